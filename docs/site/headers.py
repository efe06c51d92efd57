"""The C reference: one page for each public header, with its symbols in the order of the header."""

import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HERE = Path(__file__).parent
DIRECTIVES = {"function": "doxygenfunction", "typedef": "doxygentypedef", "enum": "doxygenenum",
              "define": "doxygendefine", "variable": "doxygenvariable"}


def run_doxygen(folders, folder):
    """Writes folder/xml for the headers in whirl/ of `folders`; raises an error that lists undocumented symbols."""
    folder.mkdir(parents=True, exist_ok=True)
    inputs = " ".join(f'"{include}/whirl"' for include in folders)
    settings = (HERE / "Doxyfile").read_text() + (
        f'INPUT = {inputs}\nOUTPUT_DIRECTORY = "{folder}"\n'
        f'INPUT_FILTER = "{sys.executable} {HERE / "header_filter.py"}"\n')
    done = subprocess.run(["doxygen", "-"], input=settings, capture_output=True, text=True)
    if done.returncode != 0 or done.stderr:
        raise RuntimeError("the headers lack comments:\n" + done.stderr)


def code_text(element):
    """Returns the text of a listing, whose blanks are elements of the XML."""
    if element.tag == "sp":
        return " " + (element.tail or "")
    inner = (element.text or "") + "".join(code_text(child) for child in element)
    return inner + ("\n" if element.tag == "codeline" else "") + (element.tail or "").strip("\n")


def blocks_of(paragraph):
    """Returns words and listings of a paragraph, in their order."""
    words = paragraph.text or ""
    for child in paragraph:
        inner = "".join(child.itertext())
        if child.tag in ("programlisting", "verbatim"):
            code = child.text if child.tag == "verbatim" else "".join(map(code_text, child))
            yield from (" ".join(words.split()), "::\n\n" + indented(code.rstrip()))
            words = ""
        else:
            words += f"``{inner}``" if child.tag == "computeroutput" else inner
        words += child.tail or ""
    yield " ".join(words.split())


def text_of(element):
    """Returns the paragraphs of a description as reStructuredText."""
    paragraphs = element.findall("para") if element is not None else []
    return "\n\n".join(block for paragraph in paragraphs for block in blocks_of(paragraph) if block)


def description(element):
    parts = [text_of(element.find(part)) for part in ("briefdescription", "detaileddescription")]
    return "\n\n".join(part for part in parts if part)


def indented(text):
    return "\n".join("   " + line if line else "" for line in text.split("\n"))


def constants(enumeration):
    """Yields the constants of an enumeration without a name."""
    shared = description(enumeration)
    for value in enumeration.findall("enumvalue"):
        initializer = value.findtext("initializer", "").replace("=", "").strip()
        words = [f"= {initializer}" if initializer else "", description(value) or shared]
        yield f".. c:macro:: {value.findtext('name')}\n\n" + indented("\n\n".join(word for word in words if word))


def project_of(xml, header, folder):
    """Writes an index of one header to a new folder: Breathe searches its whole index for each symbol."""
    folder.mkdir(parents=True)
    compounds = {header.get("id")} | {inner.get("refid") for inner in header.findall("innerclass")}
    index = ElementTree.parse(xml / "index.xml")
    for compound in index.getroot().findall("compound"):
        if compound.get("refid") not in compounds:
            index.getroot().remove(compound)
    index.write(folder / "index.xml")
    for compound in compounds:
        (folder / f"{compound}.xml").symlink_to(xml / f"{compound}.xml")


def symbols(xml, header, listed):
    """Yields line and reStructuredText of every symbol of a header that is not in `listed`, and adds it to that set."""
    project = header.findtext("compoundname")
    for inner in header.findall("innerclass"):
        compound = ElementTree.parse(xml / f"{inner.get('refid')}.xml").getroot()[0]
        line = int(compound.find("location").get("line"))
        yield line, f".. doxygenstruct:: {inner.text}\n   :project: {project}\n   :members:\n   :undoc-members:"
    types = {inner.text for inner in header.findall("innerclass")}
    types |= {member.findtext("name") for member in header.iter("memberdef") if member.get("kind") == "enum"}
    for member in header.iter("memberdef"):
        name, kind = member.findtext("name"), member.get("kind")
        if kind == "function" and name in listed:
            continue
        listed.add(name)
        line = int(member.find("location").get("line"))
        if kind == "enum" and (not name or name.startswith("@")):
            for constant in constants(member):
                yield line, constant
        elif not (kind == "typedef" and name in types) and not name.endswith("_H"):
            yield line, f".. {DIRECTIVES[kind]}:: {name}\n   :project: {project}"


INDEX = """# C API

Each public header has a page. `#include <whirl/whirl.h>` includes the *stable* headers: programs that were compiled
with them run with later versions of the library. `#include <whirl/engine.h>` includes the headers of the engine, too,
whose structs grow: a program that uses them runs with libraries of the same minor version ([the ABI](../docs/abi.md)).
Every function that can fail returns a `whirl_status` with a sentence.

The headers for elements of your own have [other pages](element/index.md).
"""
ELEMENTS = """# Headers for elements

An installation has these headers in `whirl/element`, to compile [elements of your own](../../docs/elements.md). They
are internal headers of the library: compile an element again for every version.
"""


def index_page(words, titles, entries):
    """Returns the text with a table of headers: the page, then the other columns."""
    heading = f"| {' | '.join(['header', *titles])} |\n|{'---|' * (len(titles) + 1)}\n"
    rows = "".join(f"| {{doc}}`whirl/{page}.h </api/{page}>` | {' | '.join(columns)} |\n" for page, *columns in entries)
    names = "\n".join(f"/api/{page}" for page, *_ in entries)
    return f"{words}\n{heading}{rows}\n```{{toctree}}\n:hidden:\n:maxdepth: 1\n\n{names}\n```\n"


def write_pages(xml, folder, projects):
    """Writes a page for each header. Returns the pages without their suffix, each with its first sentence and "stable"
    if its interface is stable. `projects` gets one folder for each header, which Breathe reads."""
    pages, listed = [], set()
    shutil.rmtree(projects, ignore_errors=True)
    for path in sorted(xml.glob("*_8h.xml"), key=lambda path: (path.name.startswith("engine_2"), path.name)):
        header = ElementTree.parse(path).getroot()[0]
        project = header.findtext("compoundname")
        name = header.find("location").get("file").rpartition("include/whirl/")[2]
        project_of(xml, header, projects / project)
        title = f"whirl/{name}"
        body = [text for _, text in sorted(symbols(xml, header, listed), key=lambda symbol: symbol[0])]
        words = description(header)
        page = f"{title}\n{'=' * len(title)}\n\n{words}\n\n" + "\n\n".join(body) + "\n"
        first = re.match(r".*?\.(?=\s|$)|.*", words, re.DOTALL)[0]
        pages.append((name[:-2], " ".join(first.split()), "" if name.startswith("engine") else "stable"))
        written = folder / f"{name[:-2]}.rst"
        written.parent.mkdir(parents=True, exist_ok=True)
        written.write_text(page)
    return pages
