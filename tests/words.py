#!/usr/bin/env python3
"""Documents, help and messages use plain words and short sentences:  words.py ROOT

Fails for a phrase of the list below in a document, in the help of keys (docs/reference/keys.md) or in the man page, for
a sentence of more than 40 words, and for a comment of code that begins with a relative word (What, Whether, Those, ...)
in place of its subject. It prints file, line, phrase and what to write instead. Code, formulas, links and
tables of numbers are left out. Messages in the sources may not have more such phrases than MESSAGES.
"""

import pathlib
import re
import subprocess
import sys

# Phrases that this project used and its field does not, with what to write instead.
PHRASES = {
    r"(?:is|are|be|was|were) told|\btold(?: of| by| apart| from)?": "reported, printed, given; distinguished",
    r"tells? (?:of|by|that|where|whether|how|what|which|the|whirl)": "reports, gives, lists, shows",
    r"(?:is|are) said(?: of)?": "applies to; is reported",
    r"says? of": "says about",
    r"stands? (?:there|in|for|beside|at|below|above|behind|between|apart)": "is; replaces; does not move",
    r"in the place of": "in place of",
    r"besides?": "next to, together with, compared with; also",
    r"go(?:es)? by": "uses, depends on",
    r"(?<!there )(?:is|are) none\b(?! of)(?=[,;:.)])": "say what is missing, or 0",
    r"for want of": "without",
    r"whoever": "name the person, or use the imperative",
    r"nobody": "say what happens, or leave it out",
    r"no matter of": "independent of",
    r"(?:is|are) of (?:a|one|run)\b": "belongs to, applies to",
    r"takes? (?:it|them) for": "mistakes it for",
    r"looked at (?:once more|again)": "checked again",
    r"what (?:is|was) (?:told|asked|seen|there|wrong|wanted|known)": "name the thing: requirement, reading, error",
    r"lest": "so that ... not",
    r"foretells?": "predicts",
    r"refuges?|twins?\b": "coexisting attractor; perturbed copy",
    r"where (?:it is|they are) (?:absent|not given|not said)|where absent": "absent: ...",
    r"(?:that|which) (?:is|are) there already|files? that (?:is|are) there": "existing",
}
# Phrases that are meant as they stand: file and a part of the line.
MEANT = {
    ("docs/guide/05-verdicts.md", "too few revolutions were watched to tell"),
}
# Documents with sentences of more than 40 words, and how many each may have: none today.
LONG = {}
MAX_WORDS = 40
# A comment that begins so answers a question that nobody sees.
WITHOUT_SUBJECT = re.compile(r"\s*//[/!]?\s*(?:What|Whether|Those|Who|Whose|Which|How)\b(?!.*\?$)")
# Messages with such phrases that are left; lower it when there are fewer.
MESSAGES = 2


def listed(root, *patterns):
    names = subprocess.run(["git", "ls-files", "--", *patterns], cwd=root, capture_output=True, text=True, check=True)
    return names.stdout.split()


def prose_lines(text, markdown):
    """(number, line) of the lines that are prose, without code, formulas and targets of links."""
    fenced = False
    for number, line in enumerate(text.split("\n"), 1):
        if markdown and re.match(r"\s*(```|\$\$\s*$)", line):
            fenced = not fenced
        elif not fenced:
            line = re.sub(r"`[^`]*`", "`code`", line)
            line = re.sub(r"\$[^$]+\$", "x", line)
            yield number, re.sub(r"\]\([^)]*\)", "]", line)


def sentences(text):
    """(number of the first line, words) of the sentences of paragraphs and items of Markdown."""
    text = re.sub(r"```.*?```|^\$\$$.*?^\$\$$", lambda found: "\n" * found.group(0).count("\n"), text,
                  flags=re.S | re.M)
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", lambda found: found.group(1), text)
    text = re.sub(r"`[^`]*`|\$[^$]+\$", lambda found: "x" + "\n" * found.group(0).count("\n"), text)
    paragraph, begun = [], 0
    for number, line in enumerate([*text.split("\n"), ""], 1):
        ends = not line.strip() or re.match(r"\s*([-*] |\d+\. |\||#|<)", line)
        if ends and paragraph:
            for sentence in re.split(r"(?<=[.:;!?])[)\"*]*\s+", " ".join(paragraph)):
                yield begun, sentence.split()
            paragraph = []
        if line.strip() and not re.match(r"\s*(\||#|<)", line):
            begun = begun if paragraph else number
            paragraph.append(line.strip())


def main():
    root = pathlib.Path(sys.argv[1])
    every = re.compile("|".join(rf"(?P<p{n}>\b(?:{phrase})\b)" for n, phrase in enumerate(PHRASES)), re.I)
    advice = list(PHRASES.values())
    skipped = ("docs/verification-manual.md", "tests/rotors/ross/LICENSE.md")
    documents = [name for name in listed(root, "*.md", "docs/whirl.1") if name not in skipped]
    faults = 0

    def complain(name, number, text):
        nonlocal faults
        faults += 1
        print(f"{name}:{number}: {text}")

    for name in documents:
        text = (root / name).read_text(encoding="utf-8")
        for number, line in prose_lines(text, name.endswith(".md")):
            for found in every.finditer(line):
                if not any(name == file and part in text.split("\n")[number - 1] for file, part in MEANT):
                    complain(name, number, f'"{found.group(0)}": write {advice[int(found.lastgroup[1:])]}')
        if name.endswith(".md"):
            long_ones = [(n, words) for n, words in sentences(text) if len(words) > MAX_WORDS]
            for number, words in long_ones if len(long_ones) > LONG.get(name, 0) else []:
                complain(name, number, f'"{" ".join(words[:8])} ...": {len(words)} words, write sentences of up to 25')

    for name in listed(root, "*.c", "*.h", "*.cc", "*.inc", "*.ts", "*.mjs"):
        before = ""
        for number, line in enumerate((root / name).read_text(encoding="utf-8").split("\n"), 1):
            if WITHOUT_SUBJECT.match(line) and not before.lstrip().startswith("//"):
                complain(name, number, f'"{line.strip()[:50]} ...": begin with the subject, or with a verb')
            before = line

    told = []
    for name in listed(root, "src/**/*.c", "cli/*.c", "cli/*.h", "include/**/*.h", "bindings/**/*.c"):
        for number, line in enumerate((root / name).read_text(encoding="utf-8").split("\n"), 1):
            for literal in re.findall(r'"((?:[^"\\]|\\.)* (?:[^"\\]|\\.)*)"', line):
                told += [f'{name}:{number}: "{found.group(0)}"' for found in every.finditer(literal)]
    if len(told) > MESSAGES:
        complain("messages", len(told), f"more than {MESSAGES} such phrases:\n" + "\n".join(told))
    print(f"{len(documents)} documents, {faults} faults, {len(told)} phrases in messages")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
