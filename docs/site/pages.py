"""Pages of files that are not Markdown: cases, programs and headers of C, the man page."""

import re
import shlex

import yaml

LONG_TITLE = 80


def listing(path, language, title):
    return f"# {title}\n\n[{path.name}]({path.name}) as a file.\n\n```{language}\n{path.read_text().rstrip()}\n```\n"


def case_page(path):
    """Returns the page of a case with its title, or of a claims file with its source."""
    said = yaml.safe_load(path.read_text())
    return listing(path, "yaml", f"{path.stem}: {said.get('title') or said['source']}")


def first_sentence(text):
    """Returns the first sentence of the comment at the head of a C file."""
    comment = re.match(r"(?://.*\n)*", text)[0]
    words = " ".join(line.lstrip("/").strip() for line in comment.splitlines())
    return re.match(r".*?(?:\.(?= |$)|$)", words)[0]


def program_page(path):
    """Returns the page of a program. Of a long first sentence the part before the colon is the title."""
    subject = first_sentence(path.read_text()).rstrip(".")
    if len(subject) > LONG_TITLE:
        subject = subject.partition(":")[0]
    return listing(path, "c", f"{path.name}: {subject}" if subject else path.name)


def header_page(path):
    return listing(path, "c", f"whirl/element/{path.name}")


def contents(title, words, names):
    entries = "\n".join(names)
    return f"# {title}\n\n{words}\n\n```{{toctree}}\n:maxdepth: 1\n\n{entries}\n```\n"


FONTS = {"B": "**", "I": "*"}


def plain(text):
    """Converts a text of the manual page from troff to Markdown."""
    text = text.replace("\\-", "-").replace("\\&", "").replace("\\(aq", "'").replace("\\e", "\\\\")
    text = re.sub(r"([<>*_\[\]$])", r"\\\1", text)
    text = re.sub(r"\\f([BI])(.*?)\\f[RP]", lambda part: FONTS[part[1]] + part[2] + FONTS[part[1]], text)
    return re.sub(r"--", r"\--", text)


def in_fonts(macro, line):
    """Returns the arguments of a font macro: .BR and the like alternate two fonts, .B and .I have one."""
    words = shlex.split(line.replace("\\", "\\\\").replace("'", "\\'"), comments=False)
    if len(macro) == 1:
        words = [" ".join(words)]
    out = ""
    for number, word in enumerate(words):
        mark = FONTS.get(macro[number % len(macro)], "")
        bare = word.strip()
        lead, trail = word[: len(word) - len(word.lstrip())], word[len(word.rstrip()) :]
        out += lead + (mark + plain(bare) + mark if bare and mark else plain(bare)) + trail
    # Two adjacent fonts need an invisible sign between their marks.
    return re.sub(r"(\*+)(?=[^\s*]*\1[^\s*])", r"\1", out)


def manual_page(text):
    """Converts the man page (docs/whirl.1), with the macros of man(7) that it uses, to Markdown."""
    out, tagged = ["# whirl(1), the man page\n"], None
    for line in text.splitlines():
        macro, _, rest = line.partition(" ")
        if macro in (".TH", ""):
            continue
        if macro == ".SH":
            out.append(f"\n## {plain(rest.strip(chr(34))).capitalize()}\n")
        elif macro == ".SS":
            out.append(f"\n### {plain(rest.strip(chr(34)))}\n")
        elif macro == ".TP":
            tagged = True
        elif macro in (".PP", ".br", ".nf", ".fi"):
            out.append("" if macro != ".br" else "\\")
        else:
            words = in_fonts(macro[1:], rest) if line.startswith(".") else plain(line)
            out.append(f"\n{words}\\" if tagged else words)
            tagged = None
    return "\n".join(out) + "\n"
