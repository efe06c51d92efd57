#!/usr/bin/python3
"""Filters a header for Doxygen:  header_filter.py FILE

Some comments of the headers follow other rules than Doxygen's. The first comment of a file is about the file. A comment
behind several members of one line is about all of them, and the comment below it is about the next member. Constants of
field names have no comment: the name itself becomes their text.
"""

import re
import sys

FIELD = re.compile(r'^(#define WHIRL_FIELD_\w+ "(\S+)")$', re.MULTILINE)
SEVERAL = re.compile(r"^(\s+)((?:const )?(?:struct )?\w+) (\**\w+(?:\[\w+\])*(?:, \**\w+(?:\[\w+\])*)+);\s*(///<.*)?$")


def comment_behind(lines, at):
    """Returns the lines of a comment that begins behind a member and continues below it."""
    end = at + 1
    while end < len(lines) and re.match(r"\s+///<", lines[end]):
        end += 1
    return [line.strip() for line in lines[at + 1 : end]]


def comment_before(lines):
    start = len(lines)
    while start and re.match(r"\s+///(?!<)", lines[start - 1]):
        start -= 1
    return lines[start:]


def apart(lines):
    """Separates the comment behind a member from the comment before the next member."""
    for line, following in zip(lines, [*lines[1:], ""]):
        yield line
        if "///<" in line and re.match(r"\s+///(?!<)", following):
            yield ""


def separate(lines):
    """Puts each of several members on its own line, with their common comment."""
    out = []
    at = 0
    while at < len(lines):
        several = SEVERAL.match(lines[at])
        if not several:
            out.append(lines[at])
            at += 1
            continue
        indent, kind, names, behind = several.groups()
        below = comment_behind(lines, at) if behind else []
        before = [] if behind else comment_before(out)
        for number, name in enumerate(names.split(", ")):
            out += before if number else []
            out.append(f"{indent}{kind} {name};")
            out += [indent + line for line in ([behind] if behind else []) + below]
        at += 1 + len(below)
    return out


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as header:
        text = re.sub(r"\A///", "/// \\\\file\n///", header.read())
    text = FIELD.sub(r"\1 ///< The field `\2`.", text)
    print("\n".join(apart(separate(text.split("\n")))))
