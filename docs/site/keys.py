"""The reference of elements and keys (docs/reference/keys.md), with the output of `whirl describe NAME` as tables."""

import re

BLOCK = re.compile(r"^## (\S+)\n\n```\n(.*?)^```\n", re.MULTILINE | re.DOTALL)
COLUMNS = ["name", "symbol", "unit", "default", "range"]


def escaped(text):
    """Escapes the signs of Markdown, except backticks around names."""
    parts = text.split("`")
    parts[::2] = [re.sub(r"([*_$<\[\]\\|])", r"\\\1", part) for part in parts[::2]]
    return "`".join(parts)


def cells(line, starts):
    """Returns the cells of a row, which begin in the columns of the heading."""
    ends = [*starts[1:], None]
    return [line[start:end].strip() for start, end in zip(starts, ends)]


def row(values, meaning):
    name, symbol, unit, default, bounds = values
    # With no-break spaces, so that "N s/m" stays on one line.
    unbroken = [escaped(word).replace(" ", "\u00a0") for word in (symbol, unit, default, bounds)]
    if "|" in bounds:
        unbroken[-1] = ", ".join(f"`{word}`" for word in bounds.split("|"))
    words = [f"`{name}`", *unbroken]
    return "| " + " | ".join([*words, escaped(meaning)]) + " |"


def table(lines):
    """Returns a table of keys. Each row has two or more lines: the columns, then the meaning of the key."""
    starts = [lines[0].index(title) for title in COLUMNS]
    keys = []
    for line in lines[1:]:
        if line.startswith("      "):
            keys[-1][1].append(line.strip())
        else:
            keys.append((cells(line, starts), []))
    heading = "| key | symbol | unit | default | range | meaning |\n|---|---|---|---|---|---|\n"
    return heading + "\n".join(row(values, " ".join(meaning)) for values, meaning in keys)


def paragraphs(lines, name):
    """Returns the lines before the keys; a line that begins with two blanks continues the one before."""
    joined = []
    for line in lines:
        if line.startswith("  "):
            joined[-1] += " " + line.strip()
        else:
            joined.append(line)
    words = [line.removeprefix(f"{name}: ") for line in joined]
    return "\n\n".join(escaped(line[:1].upper() + line[1:]) for line in words)


def described(block):
    """Returns the section of a name with its keys. A name with two meanings (an element and an analysis) has both."""
    out, name = [f"## {block[1]}"], block[1]
    for part in block[2].strip("\n").split("\n\n"):
        lines = part.split("\n")
        out.append(table(lines) if lines[0].split() == COLUMNS else paragraphs(lines, name))
    return "\n\n".join(out) + "\n"


def page(text):
    """Returns docs/reference/keys.md in the form of the site."""
    made, count = BLOCK.subn(described, text)
    if count == 0 or "```" in made:
        raise RuntimeError("docs/reference/keys.md is not as docs/site/keys.py expects it")
    return made
