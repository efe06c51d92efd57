#!/usr/bin/env python3
"""Compares what a lateral document says with its own tables, with JSON and with the summary:

    lateral_agrees.py RESULT.h5 lateral.html

- What is asked for: every row of JSON's "asked" stands in the table of the document, word for word, and its verdict in
  the summary.
- Separation margins and stability in "What was found" have the verdict of these rows.
- Every number in "What was found" stands in a table or a sentence of a later chapter, to the digits that it has.
"""
import html
import json
import math
import re
import subprocess
import sys


def plain(markup):
    return re.sub(r"\s+", " ", html.unescape(re.sub(r"<[^>]+>", " ", markup))).strip()


def numbers(text):
    """Numbers of a text with their significant digits."""
    found = []
    for sign, token in re.findall(r"(?<![\w.])(-?)(\d+(?:\.\d+)?(?:[eE][-+]?\d+)?)(?![\w]*\.[a-z])", text):
        digits = len(re.sub(r"[eE].*", "", token).replace(".", "").lstrip("0")) or 1
        found.append((float(sign + token), digits))
    return found


def rounds_to(value, shown, digits):
    if value == shown:
        return True
    if shown == 0.0 or not math.isfinite(value):
        return False
    return abs(value - shown) <= 0.5001 * 10.0 ** (math.floor(math.log10(abs(shown))) - digits + 1)


def main(result, page):
    markup = re.sub(r"<style.*?</style>", "", open(page, encoding="utf-8").read(), flags=re.S)
    first = re.search(r'<section id="found">(.*?)</section>', markup, re.S).group(1)
    rest = plain(markup[markup.index("</section>") :])
    summary = subprocess.run(["whirl", "show", result], check=True, capture_output=True, text=True).stdout
    document = json.loads(subprocess.run(["whirl", "show", result, "--json"], check=True, capture_output=True, text=True).stdout)
    sentences = {}
    for item in re.findall(r"<li>(.*?)</li>", first.split("</ol>")[0], re.S):
        name = plain(re.search(r"<strong>(.*?)</strong>", item, re.S).group(1)).rstrip(".")
        sentences[name] = plain(item)
    table = plain(first.split("</ol>")[1])
    faults, verdicts = [], {}
    for row in document.get("asked", []):
        for key in ("what", "asked", "found", "told"):
            if row[key] not in table:
                faults.append(f"the table of what is asked for lacks {key} {row[key]!r} of JSON")
        verdicts.setdefault(row["what"], []).append(row["verdict"])
        if row["what"] == "separation margin" and row["told"] not in summary:
            faults.append(f"the summary lacks {row['told']!r}")
    order = ["none asked for", "holds", "not known", "fails"]
    worst = {what: max(all_of, key=order.index) for what, all_of in verdicts.items()}

    def expect(what, name, words):
        if what in worst and not re.search(words[worst[what]], sentences[name]):
            faults.append(f"{name}: {sentences[name]!r} beside the verdict {worst[what]!r}")

    expect("separation margin", "Separation margins",
           {"none asked for": "no margin is asked for", "holds": "All [0-9]+ peaks .* have it", "not known": "Not known",
            "fails": "[0-9]+ of [0-9]+ peaks lack"})
    expect("stability, Level II", "Stability", {"holds": ": holds", "not known": "[Nn]ot known", "fails": ": fails"})
    known = [value for value, _ in numbers(rest)]
    checked = 0
    for name, sentence in sentences.items():
        for shown, digits in numbers(sentence):
            if digits < 3 or shown == 2005:  # the year of a standard
                continue
            checked += 1
            if not any(rounds_to(value, shown, digits) or rounds_to(abs(value), abs(shown), digits) for value in known):
                faults.append(f"{name}: {shown} stands in no table: {sentence!r}")
    print(f"{len(document.get('asked', []))} rows, {checked} numbers")
    for fault in faults:
        print("lateral_agrees: FAILED:", fault)
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
