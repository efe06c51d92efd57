#!/usr/bin/python3
"""JSON documents are valid by docs/reference/result.schema.json:  check_schema.py SCHEMA DOCUMENT...

Sheets have a cell for every column besides, which a schema cannot say. A document in which a part is missing, or of
another kind, must be refused.
"""

import copy
import json
import sys

from jsonschema import Draft202012Validator

schema = json.load(open(sys.argv[1], encoding="utf-8"))
Draft202012Validator.check_schema(schema)
validator = Draft202012Validator(schema)


def without(document, *way):
    changed = copy.deepcopy(document)
    inner = changed
    for step in way[:-1]:
        inner = inner[step]
    del inner[way[-1]]
    return changed


def refused(whole):
    """Copies with a fault each, of few points."""
    keys = schema["properties"]
    document = {key: value for key, value in whole.items() if key in keys} | {"points": whole["points"][:1]}
    assert validator.is_valid(document)
    yield without(document, "format")
    yield document | {"format": 2}
    yield document | {"sweep": 3}
    yield document | {"length_scale": "1 mm"}
    if document["points"]:
        yield without(document, "points", 0, "parameters")
    if "statements" in document:
        yield without(document, "statements", 0, "verdict")
        yield document | {"statements": [document["statements"][0] | {"verdict": "perhaps"}]}
    if "sheets" in document:
        yield without(document, "sheets", 0, "columns", 0, "unit")
        yield document | {"sheets": [document["sheets"][0] | {"rows": [[{}]]}]}


failures = 0
for name in sys.argv[2:]:
    document = json.load(open(name, encoding="utf-8"))
    faults = [
        f"{'/'.join(map(str, fault.absolute_path))}: {fault.message[:200]}" for fault in validator.iter_errors(document)
    ]
    for sheet in document.get("sheets", []):
        if any(len(row) != len(sheet["columns"]) for row in sheet["rows"] + sheet["shown"]):
            faults.append(f"sheet {sheet['name']}: rows are not as long as there are columns")
    faults += [
        f"copy {i} with a fault is let pass" for i, bad in enumerate(refused(document)) if validator.is_valid(bad)
    ]
    print(f"{name}: " + ("; ".join(faults[:5]) or "as the schema says"))
    failures += len(faults) > 0
sys.exit(failures > 0)
