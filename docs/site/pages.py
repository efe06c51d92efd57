"""Pages that are made of what is no Markdown: cases, programs and headers of C, the man page."""

import re
import shlex

import yaml

LONG_TITLE = 80


def listing(path, language, title):
    return f"# {title}\n\n[{path.name}]({path.name}) as a file.\n\n```{language}\n{path.read_text().rstrip()}\n```\n"


def case_page(path):
    """Cases have titles; claims of others have whose they are."""
    said = yaml.safe_load(path.read_text())
    return listing(path, "yaml", f"{path.stem}: {said.get('title') or said['source']}")


def first_sentence(text):
    """What a file of C says of itself first."""
    comment = re.match(r"(?://.*\n)*", text)[0]
    words = " ".join(line.lstrip("/").strip() for line in comment.splitlines())
    return re.match(r".*?(?:\.(?= |$)|$)", words)[0]


def program_page(path):
    """A long sentence names the program by what stands before its colon."""
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
    """A text of the manual page without what troff needs, as Markdown."""
    text = text.replace("\\-", "-").replace("\\&", "").replace("\\(aq", "'").replace("\\e", "\\\\")
    text = re.sub(r"([<>*_\[\]$])", r"\\\1", text)
    text = re.sub(r"\\f([BI])(.*?)\\f[RP]", lambda part: FONTS[part[1]] + part[2] + FONTS[part[1]], text)
    return re.sub(r"--", r"\--", text)


def in_fonts(macro, line):
    """The arguments of .BR and its like, whose fonts take turns; of .B and .I all of them."""
    words = shlex.split(line.replace("\\", "\\\\").replace("'", "\\'"), comments=False)
    if len(macro) == 1:
        words = [" ".join(words)]
    out = ""
    for number, word in enumerate(words):
        mark = FONTS.get(macro[number % len(macro)], "")
        bare = word.strip()
        lead, trail = word[: len(word) - len(word.lstrip())], word[len(word.rstrip()) :]
        out += lead + (mark + plain(bare) + mark if bare and mark else plain(bare)) + trail
    # Two fonts that touch need a sign between their marks that nobody sees.
    return re.sub(r"(\*+)(?=[^\s*]*\1[^\s*])", r"\1", out)


def manual_page(text):
    """The man page (docs/whirl.1) as Markdown: the macros of man(7) that it uses."""
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
