#!/usr/bin/python3
"""The documentation site:  build.py BUILD [--without-runs]

Copies the Markdown of the repository to BUILD/docs-work/source with the same folders, adds pages that are made of
headers, cases, programs and the man page, runs the tutorials, and builds BUILD/docs with Sphinx. Needs no network.
--without-runs shows the tutorials without the output of their cells, which is quick.
"""

import importlib
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import headers
import keys
import pages
import theme
import tutorials

ROOT = Path(__file__).resolve().parents[2]
MATHJAX = Path("/usr/share/javascript/mathjax")
MATHJAX_PARTS = ["MathJax.js", "config/TeX-AMS_CHTML.js", "extensions", "jax/element", "jax/input/TeX",
                 "jax/output/CommonHTML", "fonts/HTML-CSS/TeX/woff"]
# Sphinx makes millions of nodes. With the usual thresholds Python's garbage collector takes a quarter of the time.
SPHINX = "import gc, sphinx.cmd.build as s; gc.set_threshold(200000, 50, 50); raise SystemExit(s.main())"
# The mark in the first line of a block that tells tests/docs/examples.sh how to test it.
TESTED = re.compile(r"^(```\w+\n)(?:#|//|%) tested\b.*\n", re.MULTILINE)
# Pages of the navigation; some have a distinguishing name in place of their title.
PARTS = {
    "Using whirl": ["docs/guide/README", "docs/tutorials/README", "docs/gallery", "Python guide <docs/python>",
                    "docs/octave", "docs/figures", "Studies on a cluster <docs/cluster>", "Elements of your own <docs/elements>"],
    "Reference": ["docs/reference/keys", "whirl(1) <docs/whirl>", "C API <api/index>", "Python API <api/python>",
                  "docs/glossary", "docs/result-file", "docs/journal", "cases/index", "examples/index",
                  "ABI of libwhirl <docs/abi>"],
    "What it rests on": ["docs/theory", "docs/verification-manual", "docs/benchmarks"],
    "The project": ["ARCHITECTURE", "CONTRIBUTING", "Portability <docs/portability>", "CHANGELOG"],
}
# The first lesson; the others follow in the order of their list.
FIRST_LESSON = "first-rotor"


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text)


def adapted(text):
    """Converts Markdown of a forge to that of the site: formulas, links to pages of the site, no marks for tests."""
    text = TESTED.sub(r"\1", text)
    text = text.replace("```math\n", "```{math}\n")
    text = re.sub(r"\]\(((?:\.\./)*cases/[\w-]+)\.yaml\)", r"](\1.md)", text)
    text = re.sub(r"\]\(((?:\.\./)*(?:examples|cases))/?\)", r"](\1/index.md)", text)
    return re.sub(r"\]\(((?:\.\./)*examples/[\w-]+)\.c\)", r"](\1.md)", text)


def lay_out_markdown(source):
    for path in [*ROOT.glob("*.md"), *ROOT.glob("docs/*.md"), *ROOT.glob("docs/reference/*.md")]:
        name = path.relative_to(ROOT)
        if str(name) != "README.md":
            write(source / name, adapted(path.read_text()))
    lay_out_guide(source)
    write(source / "docs/reference/keys.md", keys.page(adapted((ROOT / "docs/reference/keys.md").read_text())))
    shutil.copy(ROOT / "docs/reference/result.schema.json", source / "docs/reference")
    for name in ("docs/images", "examples/slurm"):
        shutil.copytree(ROOT / name, source / name, dirs_exist_ok=True)
    for name in ("LICENSE", "CITATION.cff"):
        shutil.copy(ROOT / name, source)
    write(source / "docs/whirl.md", pages.manual_page((ROOT / "docs/whirl.1").read_text()))


def lay_out_guide(source):
    """Writes the chapters of the user guide, below their list."""
    chapters = sorted(ROOT.glob("docs/guide/[0-9]*.md"))
    for path in chapters:
        write(source / "docs/guide" / path.name, adapted(path.read_text()))
    entries = "\n".join(path.stem for path in chapters)
    text = adapted((ROOT / "docs/guide/README.md").read_text())
    write(source / "docs/guide/README.md", f"{text}\n```{{toctree}}\n:hidden:\n\n{entries}\n```\n")


def lay_out_listings(source):
    for folder, suffix, page, title, words in (
            ("cases", "yaml", pages.case_page, "Example cases", "Every case that comes with whirl."),
            ("examples", "c", pages.program_page, "Example programs", "Complete programs against the library.")):
        names = []
        for path in sorted(ROOT.glob(f"{folder}/*.{suffix}")):
            write(source / folder / f"{path.stem}.md", page(path))
            shutil.copy(path, source / folder)
            names.append(path.stem)
        write(source / folder / "index.md", pages.contents(title, words, names))


def lay_out_gallery(build, source):
    """Adds the explorers that `make gallery` has built, next to their cases."""
    explorers = {path.stem: path for path in (build / "gallery").glob("*.html")}

    def links(case):
        names = [name for name in (case[1], f"{case[1]}-linear") if name in explorers]
        words = [f"[{word}](gallery/{name}.html)" for word, name in zip(("explorer", "modes and response"), names)]
        return f"{case[0]} ({', '.join(words)})" if words else case[0]

    (source / "docs/gallery").mkdir(exist_ok=True)
    for path in explorers.values():
        shutil.copy(path, source / "docs/gallery")
    text = re.sub(r"\[cases/([\w-]+)\.yaml\]\([^)]*\)", links, (ROOT / "docs/gallery.md").read_text())
    write(source / "docs/gallery.md", adapted(text))


def lay_out_reference(build, work, source):
    """Writes the C reference, with the header that CMake makes, and the Python reference."""
    headers.run_doxygen([ROOT / "include", build / "include"], work / "doxygen")
    (source / "api").mkdir(exist_ok=True)
    listed = headers.write_pages(work / "doxygen/xml", source / "api", work / "doxygen/headers")
    page = headers.index_page(headers.INDEX, ["what it has", "interface"], listed)
    write(source / "api/index.md", page + "\n```{toctree}\n:hidden:\n\nelement/index\n```\n")
    lay_out_element_headers(source / "api/element")
    lay_out_python(source)


def lay_out_element_headers(folder):
    """Shows the headers installed for custom elements unchanged: Doxygen cannot read their macros."""
    installed = re.search(r"install\(FILES ([^)]*)\n\s*DESTINATION \S*/whirl/element\)",
                          (ROOT / "cmake/install.cmake").read_text())[1].split()
    listed = []
    for path in sorted((ROOT / name for name in installed), key=lambda path: path.name):
        write(folder / f"{path.stem}.md", pages.header_page(path))
        shutil.copy(path, folder)
        listed.append((f"element/{path.stem}", pages.first_sentence(path.read_text())))
    write(folder / "index.md", headers.index_page(headers.ELEMENTS, ["what it has"], listed))


def lay_out_python(source):
    """Writes the Python reference, if the package exists: the names of `whirl` itself, then its modules."""
    package = ROOT / "bindings/python/whirl"
    if not package.is_dir():
        return
    sys.path.insert(0, str(package.parent))
    modules = ["whirl", *(f"whirl.{name}" for name in importlib.import_module("whirl").__all__
                          if (package / f"{name}.py").exists() or (package / name).is_dir())]
    text = "Python API\n==========\n\n"
    for module in modules:
        text += f"{module}\n{'-' * len(module)}\n\n.. automodule:: {module}\n   :members:\n   :undoc-members:\n\n"
    write(source / "api/python.rst", text)


def lay_out_tutorials(source, runs):
    """Writes the tutorials in the order of their list, after the first lesson."""
    text = (ROOT / "docs/tutorials/README.md").read_text()
    names = re.findall(r"\]\(([\w-]+)\.md\)", text)
    folder = source / "docs/tutorials"
    folder.mkdir(parents=True, exist_ok=True)
    for name in names:
        notebook = tutorials.read_notebook(adapted((ROOT / f"docs/tutorials/{name}.md").read_text()))
        if runs:
            print(f"running {name}", flush=True)
            tutorials.execute(notebook)
        write(folder / f"{name}.md", tutorials.page(notebook, folder, name))
    entries = "\n".join(sorted(names, key=lambda name: name != FIRST_LESSON))
    write(folder / "README.md", f"{adapted(text)}\n```{{toctree}}\n:hidden:\n\n{entries}\n```\n")


def page_of(entry):
    """Returns the page of an entry of PARTS."""
    return re.sub(r".*<(.*)>$", r"\1", entry)


def lay_out_front(source):
    """Writes the front page, which is README with the navigation of all parts."""
    text = adapted((ROOT / "README.md").read_text())
    listed = {page_of(entry) for entries in PARTS.values() for entry in entries}
    others = [f"docs/{path.stem}" for path in sorted(source.glob("docs/*.md")) if f"docs/{path.stem}" not in listed]
    for title, entries in PARTS.items():
        there = [entry for entry in entries if list(source.glob(f"{page_of(entry)}.*"))]
        entries = "\n".join(there + (others if title == "Reference" else []))
        text += f"\n```{{toctree}}\n:hidden:\n:caption: {title}\n\n{entries}\n```\n"
    write(source / "index.md", text)


def lay_out_static(source):
    for part in MATHJAX_PARTS:
        target = source / "static/mathjax" / part
        target.parent.mkdir(parents=True, exist_ok=True)
        if (MATHJAX / part).is_dir():
            shutil.copytree(MATHJAX / part, target, dirs_exist_ok=True)
        else:
            shutil.copy(MATHJAX / part, target)
    theme.lay_out(source / "static")
    shutil.copy(ROOT / "docs/site/site.css", source / "static")
    shutil.copy(ROOT / "docs/site/conf.py", source)


def version():
    found = re.search(r"project\(whirl\s+VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())
    return found[1] if found else ""


def main():
    build = Path(sys.argv[1]).resolve()
    runs = "--without-runs" not in sys.argv
    work = build / ("docs-work" if runs else "docs-quick")
    source = work / "source"
    # Remains of an earlier build of a page may conflict with the present one.
    for earlier in (source, work / "doctrees"):
        shutil.rmtree(earlier, ignore_errors=True)
    tutorials.environment(build)
    lay_out_markdown(source)
    lay_out_listings(source)
    lay_out_gallery(build, source)
    lay_out_reference(build, work, source)
    lay_out_tutorials(source, runs)
    lay_out_front(source)
    lay_out_static(source)
    os.environ.update(WHIRL_VERSION=version(), WHIRL_DOXYGEN=str(work / "doxygen/headers"))
    site = build / "docs" if runs else work / "site"
    shutil.rmtree(site, ignore_errors=True)
    options = ["-W", "--keep-going", "-q", "-d", str(work / "doctrees")]
    return subprocess.run([sys.executable, "-c", SPHINX, *options, str(source), str(site)]).returncode


if __name__ == "__main__":
    sys.exit(main())
