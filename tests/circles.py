"""No two files of a layer need each other, directly or by way of others, and no two of its folders:

    circles.py ROOT BUILD LAYER...

Who needs whom is read from the objects: a file needs another one where it uses a symbol that the other defines. The kernels of
all instruction sets count as one file. Objects without a source, from before a file was moved, do not count.
"""
import pathlib
import re
import subprocess
import sys

# Circles that are left, by layer: each is the set of its files or folders. None may be added, and one that is gone must
# be taken out.
LEFT = {
    # A step of RK4 in lanes that meets a switch is done again on one lane, by RK4.
    "integrate": [
        {"kernels/rk4_lanes.c", "methods/rk4_one.c", "methods/rk4_redo.c", "stepper/stepper.c"},
        {".", "kernels", "methods", "stepper"},
    ],
    # Elements know their bearings' laws and assembly; these know a few elements by name.
    "rotor": [
        {"elements/films/tilting_pad_yielding.c", "pads/pads_build.c"},
        {".", "design", "elements/contacts", "elements/films", "elements/loads", "elements/shafts", "elements/supports",
         "pads", "shaft"},
    ],
    "report": [{".", "claims", "figures", "findings", "kinds", "pages", "render", "summary"}],
}


def source_of(path, build, root, layer):
    """Path of an object's source in its layer; None if there is no such file any more."""
    inside = path.relative_to(build / f"CMakeFiles/whirl_{layer}.dir")
    folder = root / "src" / layer
    if inside.parts[0] == "kernels":
        name = re.sub(r"_(scalar|128|fma|avx2|avx512)\.c\.o$", ".c", inside.name)
        found = sorted(folder.rglob(name))
        return found[0].relative_to(folder) if found else None
    source = root / inside.with_suffix("")
    return source.relative_to(folder) if source.exists() else None


def needs_of(build, root, layer):
    """Files that every file uses, {file: {file}}."""
    objects = {o: source_of(o, build, root, layer) for o in sorted((build / f"CMakeFiles/whirl_{layer}.dir").rglob("*.o"))}
    objects = {o: source for o, source in objects.items() if source}
    if not objects:
        sys.exit(f"circles: {build} has no objects of {layer}")
    defined, used = {}, {}
    for line in subprocess.check_output(["nm", "-A", *objects], text=True).splitlines():
        path, _, entry = line.partition(":")
        *_, kind, symbol = entry.split()
        name = str(objects[pathlib.Path(path)])
        if kind == "U":
            used.setdefault(name, set()).add(symbol)
        elif kind in "TDBRV":
            defined[symbol] = name
    return {name: {defined[s] for s in symbols if s in defined} - {name} for name, symbols in used.items()}


def folders_of(needs):
    """The same of folders; the layer's own is '.'."""
    folders = {}
    for name, others in needs.items():
        own = str(pathlib.Path(name).parent)
        folders.setdefault(own, set()).update({str(pathlib.Path(o).parent) for o in others} - {own})
    return folders


def circles(needs):
    """Largest sets whose members all need each other, directly or by way of others."""
    def reached(start):
        seen, stack = set(), [start]
        while stack:
            for other in needs.get(stack.pop(), ()):
                if other not in seen:
                    seen.add(other)
                    stack.append(other)
        return seen

    reach = {name: reached(name) for name in needs}
    return {frozenset(o for o in reach[n] if n in reach.get(o, ())) for n in needs if n in reach[n]}


def main(root, build, *layers):
    root, build = pathlib.Path(root).resolve(), pathlib.Path(build).resolve()
    found, left = 0, 0
    for layer in layers:
        needs = needs_of(build, root, layer)
        known = [frozenset(circle) for circle in LEFT.get(layer, [])]
        seen = circles(needs) | circles(folders_of(needs))
        for circle in sorted(seen - set(known), key=sorted):
            found += 1
            print(f"FAILED: src/{layer}: these need each other: {', '.join(sorted(circle))}")
        for circle in sorted(set(known) - seen, key=sorted):
            found += 1
            print(f"FAILED: src/{layer}: this circle is gone, take it out of this test: {', '.join(sorted(circle))}")
        left += len(known)
    if found == 0:
        print(f"{len(layers)} layers, {left} circles left")
    return found > 0


sys.exit(main(*sys.argv[1:]))
