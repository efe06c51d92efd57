#!/usr/bin/env python3
"""Compares what a lateral document says with its own tables, with JSON and with the summary:

    lateral_agrees.py RESULT.h5 lateral.html

- What is asked for: every statement of JSON that has a clause stands in the table of the document, word for word, and
  its verdict in the summary.
- "What was found" names those that fail or are not known, and counts those that hold.
- Every other statement of a whole table stands in "What was found" and in the summary, word for word; those of the
  machine as a whole in a chapter.
- Every number in "What was found" stands in a table or a sentence of a later chapter, to the digits that it has.
"""
import html
import json
import math
import re
import subprocess
import sys


def plain(markup):
    return re.sub(r"\s+", " ", html.unescape(re.sub(r"<[^>]+>", " ", markup))).strip().replace("\u00b1", "+-")


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
    faults, satisfied, judged = [], 0, 0
    whole = sentences.get("What is asked for", "")
    for row in document.get("statements", []):
        texts = [row[key]["text"] for key in ("asked", "found", "judged") if row[key]["text"]]
        for text in texts:
            if text not in summary:
                faults.append(f"the summary lacks {text!r} of JSON")
            if "clause" in row and text not in table:
                faults.append(f"the table of what is asked for lacks {text!r} of JSON")
            if not row["table"] and text not in rest:
                faults.append(f"the chapters lack {text!r} of JSON")
            if row["table"] and "clause" not in row and "at" not in row and text not in plain(first):
                faults.append(f"what was found lacks {text!r} of JSON")
        if "clause" not in row:
            continue
        judged += row["verdict"] != "none asked for"
        satisfied += row["verdict"] == "holds"
        named = re.search(rf"{row['verdict']}: [^;]*{re.escape(row['what'])} \({re.escape(row['table'])}\)", whole)
        if bool(named) != (row["verdict"] in ("fails", "not known")):
            faults.append(f"{row['what']} of {row['table']} {row['verdict']}, beside {whole!r}")
    if judged and f"{satisfied} of {judged} hold" not in whole:
        faults.append(f"{satisfied} of {judged} hold, beside {whole!r}")
    known = [value for value, _ in numbers(rest)]
    checked = 0
    for name, sentence in sentences.items():
        for shown, digits in numbers(sentence):
            if digits < 3 or shown == 2005:  # the year of a standard
                continue
            checked += 1
            if not any(rounds_to(value, shown, digits) or rounds_to(abs(value), abs(shown), digits) for value in known):
                faults.append(f"{name}: {shown} stands in no table: {sentence!r}")
    print(f"{judged} rows, {checked} numbers")
    for fault in faults:
        print("lateral_agrees: FAILED:", fault)
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
