#!/usr/bin/python3
"""The stable interface of libwhirl is that of the baseline.

    stable.py ROOT BUILD            the test
    stable.py ROOT BUILD --write    writes the baseline anew (docs/abi.md says when that may be), and what was added also
                                    into debian/libwhirl1.symbols

The sources that define functions of the stable headers are compiled once more, with debug information, into a library
of their own; abidw (abigail-tools) writes down its functions and the types that public headers show of them, and abidiff
sets these beside tests/abi/libwhirl-<ABI>.abi. Changes on purpose must be found, and an addition must pass.
"""

import json
import os
import pathlib
import platform
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

ROOT, BUILD = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
SKIPPED = 77


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{shlex.join(str(word) for word in command)}\n{done.stdout}{done.stderr}")
    return done.stdout


def abi_number():
    return re.search(r"^set\(WHIRL_ABI (\d+)\)", (ROOT / "CMakeLists.txt").read_text(), re.M)[1]


def stable_headers():
    return [*(ROOT / "include/whirl").glob("*.h"), BUILD / "include/whirl/version.h"]


def stable_functions():
    """The functions that stable headers declare, told apart from comments and types by the shape of a declaration."""
    code = "".join(re.sub(r"//.*", "", header.read_text()) for header in stable_headers())
    return set(re.findall(r"^\w[\w *]*\b(whirl_\w+)\(", code, re.M))


def exported_versions():
    lines = run("nm", "-D", "--defined-only", "--with-symbol-versions", BUILD / "libwhirl.so").splitlines()
    symbols = (line.split()[-1] for line in lines)
    return dict(re.split("@@?", symbol) for symbol in symbols if "@" in symbol)


def check_versions(functions):
    """Stable functions, and no others, have the version of the stable interface."""
    node, versions = "WHIRL_" + abi_number(), exported_versions()
    marked = {name for name, version in versions.items() if version == node}
    if marked != functions:
        sys.exit(f"of version {node} and not declared in stable headers, or the other way round: {marked ^ functions}")


def compile_commands(functions):
    """How the sources that define these functions are compiled: [(source, command)]."""
    commands = []
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        source = pathlib.Path(entry["file"])
        if not re.match(str(ROOT) + r"/src/(\w+/)+\w+\.c$", str(source)):
            continue
        text = source.read_text()
        if any(re.search(rf"^\w[\w *]*\b{name}\(", text, re.M) for name in functions):
            words = shlex.split(entry["command"])
            words = [word for word in words[: words.index("-o")] if not word.startswith(("-O", "-D_FORTIFY"))]
            commands.append((source, words))
    return commands


def describe(commands, folder, changes=()):
    """The interface as abidw writes it, of sources and headers in which (file, old, new) are replaced."""
    tree = folder / "tree"
    shutil.rmtree(tree, ignore_errors=True)
    shutil.copytree(ROOT / "include", tree / "include")
    shutil.copytree(BUILD / "include/whirl", tree / "include/whirl", dirs_exist_ok=True)
    for file, old, new in changes:
        path = tree / file
        if not path.exists():
            shutil.copy(ROOT / file, path.parent.mkdir(parents=True, exist_ok=True) or path)
        text = path.read_text()
        if old not in text:
            sys.exit(f"{file} has no '{old}': mend this test")
        path.write_text(text.replace(old, new))
    objects = []
    for source, command in commands:
        changed = tree / source.relative_to(ROOT)
        objects.append(tree / f"{len(objects)}.o")
        words = [str(tree / "include") if w == str(ROOT / "include") else w for w in command]
        words = [w if not w.startswith("-I") else w.replace(str(ROOT / "include"), str(tree / "include")) for w in words]
        words = [w for w in words if w != "-I" + str(BUILD / "include")]
        run(*words, "-g", "-O0", f"-ffile-prefix-map={tree}/=", f"-ffile-prefix-map={ROOT}/=", "-I", source.parent, "-c", changed if changed.exists() else source, "-o", objects[-1])
    library, description = tree / "libwhirl.so", folder / "described.abi"
    # What other headers show of a type is no part of the interface, and functions that they declare are not either.
    public, script = tree / "stable", tree / "stable.map"
    public.mkdir()
    for header in stable_headers():
        shutil.copy(tree / "include/whirl" / header.name, public)
    names = "; ".join(sorted(stable_functions()))
    script.write_text(f"WHIRL_{abi_number()} {{ global: {names}; local: *; }};\n")
    run("cc", "-shared", *objects, "-o", library, f"-Wl,-soname,libwhirl.so.{abi_number()}",
        f"-Wl,--version-script={script}")  # fmt: skip
    run("abidw", "--headers-dir", public, "--drop-private-types", "--no-corpus-path",
        "--no-comp-dir-path", "--no-show-locs", "--no-elf-needed", "--exported-interfaces-only", "--drop-undefined-syms",
        "--type-id-style", "hash", "--out-file", description, library)  # fmt: skip
    return description


def difference(baseline, description):
    """What is no longer as it was; "" where the new one serves all programs of the old one."""
    done = subprocess.run(
        ["abidiff", "--no-added-syms", str(baseline), str(description)], capture_output=True, text=True
    )
    return done.stdout if done.returncode else ""


def described_functions(description):
    return set(re.findall(r"<elf-symbol name='(whirl_\w+)'", description.read_text()))


INCOMPATIBLE = {
    "a struct that is passed by value grows": [
        ("include/whirl/status.h", "const char *message;", "int line;\n    const char *message;")
    ],
    "a member of a struct has another type": [
        ("include/whirl/status.h", "whirl_code code;", "long code;")
    ],
    "an argument has another type": [
        ("include/whirl/version.h", "int major, int minor, int patch);", "int major, int minor, long patch);"),
        ("src/base/version.c", "int major, int minor, int patch) {", "int major, int minor, long patch) {"),
        ("src/base/version.c", "int least[] = {major, minor, patch}", "int least[] = {major, minor, (int)patch}"),
        ("src/base/version.c", "%d.%d.%d", "%d.%d.%ld"),
    ],
    "words of an enumeration have other values": [
        ("include/whirl/status.h", "WHIRL_NO_MEMORY, ", "WHIRL_NO_MEMORY = 20, ")
    ],
    "a function is gone": [
        ("include/whirl/version.h", "const char *whirl_version(void)", "const char *whirl_other(void)"),
        ("src/base/version.c", "const char *whirl_version(void)", "const char *whirl_other(void)"),
    ],
}
COMPATIBLE = {
    "a struct behind a handle grows": [
        ("include/whirl/engine/result.h", "char title[256];", "int more;\n    char title[256];")
    ],
    "an enumeration has one more word at its end": [
        ("include/whirl/status.h", "WHIRL_MISSING_PROGRAM ", "WHIRL_MISSING_PROGRAM, WHIRL_ANOTHER ")
    ],
}


def packaged_functions():
    """The functions that Debian's list names, with the version that brought them."""
    text = (ROOT / "debian/libwhirl1.symbols").read_text()
    return set(re.findall(rf"^ (whirl_\w+)@WHIRL_{abi_number()} [0-9.]+$", text, re.M))


def list_for_packages(functions):
    """Adds functions to Debian's list, as of the present version."""
    version = re.search(r"^project\(whirl VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(), re.M)[1]
    with (ROOT / "debian/libwhirl1.symbols").open("a") as symbols:
        symbols.writelines(f" {name}@WHIRL_{abi_number()} {version}\n" for name in sorted(functions))


def main():
    if platform.machine() != "x86_64":
        print("the baseline is of x86_64: skipped")
        sys.exit(SKIPPED)
    if not shutil.which("abidiff"):
        print("abidiff is missing (package abigail-tools)" + ("" if os.environ.get("CI") else ": skipped"))
        sys.exit(1 if os.environ.get("CI") else SKIPPED)
    functions = stable_functions()
    check_versions(functions)
    baseline = ROOT / f"tests/abi/libwhirl-{abi_number()}.abi"
    commands = compile_commands(functions)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        description = describe(commands, folder)
        if "--write" in sys.argv:
            shutil.copy(description, baseline)
            list_for_packages(functions - packaged_functions())
            return
        report = difference(baseline, description)
        if report:
            sys.exit(f"{report}\nThe stable interface has changed: docs/abi.md says what may be done.")
        missing = functions - (described_functions(baseline) & packaged_functions())
        if missing:
            sys.exit(f"not in {baseline.name} and debian/libwhirl1.symbols: {', '.join(sorted(missing))};"
                     " 'tests/abi/stable.py . build --write' adds them")  # fmt: skip
        for change, edits in INCOMPATIBLE.items():
            if not difference(baseline, describe(commands, folder, edits)):
                sys.exit(f"abidiff takes no notice where {change}")
        for change, edits in COMPATIBLE.items():
            report = difference(baseline, describe(commands, folder, edits))
            if report:
                sys.exit(f"{report}\nabidiff forbids that {change}")
    print(f"{len(functions)} stable functions are those of {baseline.name}; {len(INCOMPATIBLE)} changes were found")


main()
