#!/usr/bin/python3
"""What Doxygen reads of a header:  header_filter.py FILE

The headers are written to be read, and some of their habits are not Doxygen's: the first comment of a file is about the
file, one that stands behind several members of a line is about all of them, and the one below it is about the next.
Names of fields say what they are themselves.
"""

import re
import sys

FIELD = re.compile(r'^(#define WHIRL_FIELD_\w+ "(\S+)")$', re.MULTILINE)
SEVERAL = re.compile(r"^(\s+)((?:const )?(?:struct )?\w+) (\**\w+(?:\[\w+\])*(?:, \**\w+(?:\[\w+\])*)+);\s*(///<.*)?$")


def comment_behind(lines, at):
    """The lines of a comment that goes on below the member it stands behind."""
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
    """A comment behind a member is not gone on with by the one before the next."""
    for line, following in zip(lines, [*lines[1:], ""]):
        yield line
        if "///<" in line and re.match(r"\s+///(?!<)", following):
            yield ""


def separate(lines):
    """One member a line, each with the comment of them all."""
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
