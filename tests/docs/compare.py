"""Checks that every shown line begins a printed line, numbers within a tolerance:  compare.py SHOWN PRINTED

Runs of blanks count as one. " ..." at the end replaces the rest of a line, and "..." any lines. Words, such as P-2, must
be the same. Numbers may differ by the effect of a processor's rounding or by a statistical error:
  41       whole numbers: by 1 (a point at the edge of a regime) or a fiftieth
  0.9167   others: by a fiftieth or two units of their last digit
  1.7e-15  below 1e-8, the level of rounding: within a factor of 1000
  v +- e   v by five of its errors as well, e within a factor of 3
JSON is compared value by value: keys that the document shows must exist, and "..." in it replaces omitted parts.
With "numbers vary" in the first line of the commands (SHOWN's third argument) only words are compared.
"""
import json
import re
import sys

NUMBER = re.compile(r"(?<![A-Za-z0-9_.-])[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![A-Za-z0-9_]*[A-Za-z_])")


def split(line):
    """Returns the words between numbers, and the numbers as written."""
    line = " ".join(line.split())
    return NUMBER.split(line), NUMBER.findall(line)


def last_digit(text):
    """Returns the size of a unit of the last written digit."""
    mantissa, _, exponent = text.partition("e")
    decimals = len(mantissa.partition(".")[2])
    return 10.0 ** (int(exponent or 0) - decimals)


def near(shown, printed, error):
    a, b = float(shown), float(printed)
    if error is not None and abs(a - b) <= 5 * error:
        return True
    if 0 < abs(a) < 1e-8 and 0 < abs(b) < 1e-8:
        return 1e-3 <= abs(a / b) <= 1e3
    least = 1 if re.fullmatch(r"[-+]?\d+", shown) else 2 * last_digit(shown)
    return abs(a - b) <= max(least, abs(a) / 50) * (1 + 1e-9)


def errors_of(words, numbers):
    """Returns for each number the standard error written after it, or None, and whether it is such an error itself."""
    behind = [None] * len(numbers)
    is_error = [False] * len(numbers)
    for i in range(len(numbers) - 1):
        if words[i + 1].strip() == "+-":
            behind[i] = float(numbers[i + 1])
            is_error[i + 1] = True
    return behind, is_error


def agree(shown, printed, compare_numbers):
    words, numbers = split(shown)
    others, found = split(printed)
    if len(found) < len(numbers) or words[:-1] != others[: len(words) - 1]:
        return False
    if not others[len(words) - 1].startswith(words[-1]):
        return False
    behind, is_error = errors_of(words, numbers)
    other_behind, _ = errors_of(others, found)
    for i, (a, b) in enumerate(zip(numbers, found)):
        if not compare_numbers:
            continue
        if is_error[i]:
            if not abs(float(a)) / 3 <= abs(float(b)) <= 3 * abs(float(a)):
                return False
            continue
        error = None if behind[i] is None else behind[i] + (other_behind[i] or 0)
        if not near(a, b, error):
            return False
    return True


class Figures(str):
    """A number of a JSON document, as written."""


def differences(shown, printed, path):
    """Returns the places where the document differs from the printed output."""
    if isinstance(shown, dict):
        if not isinstance(printed, dict):
            yield f"{path} is no object"
            return
        for key in shown:
            if key == "...":
                continue
            if key not in printed:
                yield f"{path} has no {key}"
            else:
                yield from differences(shown[key], printed[key], f"{path}.{key}")
        if "..." not in shown:
            for key in printed.keys() - shown.keys():
                yield f"{path}.{key} is printed but not shown"
    elif isinstance(shown, list):
        for i, item in enumerate(shown):
            if item == "...":
                return
            yield from differences(item, printed[i], f"{path}[{i}]") if i < len(printed) else [f"{path} is shorter"]
    elif isinstance(shown, Figures) and isinstance(printed, Figures):
        if not near(shown, printed, None):
            yield f"{path} is {printed}, not {shown}"
    elif isinstance(shown, str) and isinstance(printed, str):
        if not agree(re.sub(r" ?\.\.\.$", "", shown), printed, True):
            yield f"{path} is {printed!r}, not {shown!r}"
    elif shown != printed:
        yield f"{path} is {printed}, not {shown}"


def compare_json(shown_path, printed_path):
    documents = []
    for path in (shown_path, printed_path):
        with open(path, encoding="utf-8") as file:
            documents.append(json.load(file, parse_float=Figures, parse_int=Figures))
    found = list(differences(*documents, "document"))
    print("\n".join(found))
    return 1 if found else 0


def main(shown_path, printed_path, first_line):
    compare_numbers = "numbers vary" not in first_line
    with open(shown_path, encoding="utf-8") as file:
        shown = [line.rstrip("\n") for line in file]
    with open(printed_path, encoding="utf-8", errors="replace") as file:
        printed = file.read().split("\n")
    failures = 0 if any(line.strip() for line in shown) else 1
    if failures:
        print("the text is empty")
    for line in shown:
        if line.strip() in ("", "..."):
            continue
        text = re.sub(r" ?\.\.\.$", "", line)
        if any(agree(text, other, compare_numbers) for other in printed):
            continue
        failures += 1
        print(f"is not printed: {line}")
        for other in printed:
            if agree(text, other, False):
                print(f"      but this: {other}")
    return 1 if failures else 0


if __name__ == "__main__":
    if sys.argv[1].endswith(".json"):
        sys.exit(compare_json(sys.argv[1], sys.argv[2]))
    sys.exit(main(sys.argv[1], sys.argv[2], sys.argv[3] if len(sys.argv) > 3 else ""))
