"""The C reference: one page a public header, its symbols in the order in which they stand there."""

import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

HERE = Path(__file__).parent
DIRECTIVES = {"function": "doxygenfunction", "typedef": "doxygentypedef", "enum": "doxygenenum",
              "define": "doxygendefine", "variable": "doxygenvariable"}


def run_doxygen(include, folder):
    """Writes folder/xml; raises an error that holds what Doxygen found undocumented."""
    folder.mkdir(parents=True, exist_ok=True)
    settings = (HERE / "Doxyfile").read_text() + (
        f'INPUT = "{include}"\nOUTPUT_DIRECTORY = "{folder}"\n'
        f'INPUT_FILTER = "{sys.executable} {HERE / "header_filter.py"}"\n')
    done = subprocess.run(["doxygen", "-"], input=settings, capture_output=True, text=True)
    if done.returncode != 0 or done.stderr:
        raise RuntimeError("the headers lack comments:\n" + done.stderr)


def code_text(element):
    """The text of a listing: its blanks are elements."""
    if element.tag == "sp":
        return " " + (element.tail or "")
    inner = (element.text or "") + "".join(code_text(child) for child in element)
    return inner + ("\n" if element.tag == "codeline" else "") + (element.tail or "").strip("\n")


def blocks_of(paragraph):
    """Words and listings of a paragraph, in their order."""
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
    """The paragraphs of a description as reStructuredText."""
    paragraphs = element.findall("para") if element is not None else []
    return "\n\n".join(block for paragraph in paragraphs for block in blocks_of(paragraph) if block)


def description(element):
    parts = [text_of(element.find(part)) for part in ("briefdescription", "detaileddescription")]
    return "\n\n".join(part for part in parts if part)


def indented(text):
    return "\n".join("   " + line if line else "" for line in text.split("\n"))


def constants(enumeration):
    """The names of an enumeration that has none itself: constants."""
    shared = description(enumeration)
    for value in enumeration.findall("enumvalue"):
        initializer = value.findtext("initializer", "").replace("=", "").strip()
        words = [f"= {initializer}" if initializer else "", description(value) or shared]
        yield f".. c:macro:: {value.findtext('name')}\n\n" + indented("\n\n".join(word for word in words if word))


def symbols(xml, header, told):
    """Line and reStructuredText of every symbol of a header that is not told of yet: `told` are names, and gets these."""
    for inner in header.findall("innerclass"):
        compound = ElementTree.parse(xml / f"{inner.get('refid')}.xml").getroot()[0]
        line = int(compound.find("location").get("line"))
        yield line, f".. doxygenstruct:: {inner.text}\n   :members:\n   :undoc-members:"
    types = {inner.text for inner in header.findall("innerclass")}
    types |= {member.findtext("name") for member in header.iter("memberdef") if member.get("kind") == "enum"}
    for member in header.iter("memberdef"):
        name, kind = member.findtext("name"), member.get("kind")
        if kind == "function" and name in told:
            continue
        told.add(name)
        line = int(member.find("location").get("line"))
        if kind == "enum" and (not name or name.startswith("@")):
            for constant in constants(member):
                yield line, constant
        elif not (kind == "typedef" and name in types) and not name.endswith("_H"):
            yield line, f".. {DIRECTIVES[kind]}:: {name}"


def write_pages(xml, folder):
    """Gives the names of the pages, without their suffix."""
    names, told = [], set()
    for path in sorted(xml.glob("*_8h.xml")):
        header = ElementTree.parse(path).getroot()[0]
        name = header.findtext("compoundname")
        title = f"whirl/{name}"
        body = [text for _, text in sorted(symbols(xml, header, told), key=lambda symbol: symbol[0])]
        page = f"{title}\n{'=' * len(title)}\n\n{description(header)}\n\n" + "\n\n".join(body) + "\n"
        names.append(name[:-2])
        (folder / f"{name[:-2]}.rst").write_text(page)
    return names
