"""Compares the data in an explorer's page with the result file that it was made of:  check_explorer.py RESULT.h5 PAGE"""

import base64
import json
import sys

import h5py
import numpy as np

result = h5py.File(sys.argv[1])
page = open(sys.argv[2], encoding="utf-8").read()
assert page.startswith("before ") and page.endswith(" after"), "what stands around the mark has changed"
data = page[len("before ") : -len(" after")]
for letter in "<>&":
    assert letter not in data, f"'{letter}' could be markup"
(run,) = json.loads(data)


def attribute(group, name):
    value = group.attrs[name]
    return value.decode() if isinstance(value, bytes) else value


assert run["title"] == attribute(result, "title")
assert run["case_text"] == result["case/text"].asstr("utf-8")[0]
assert [s["name"] for s in run["stations"]] == list(result["stations/name"].asstr("utf-8")[:])
assert [p["value"] for p in run["parameters"]] == list(result["parameters/value"][:])
assert {f["name"]: f["value"] for f in run["facts"]}["version"] == attribute(result["provenance"], "version")
fields = 0
for index, table in enumerate(run["tables"]):
    group = result[table["name"]]
    values = np.frombuffer(base64.b64decode(table["values"]), "<f8")
    assert np.array_equal(values, group["values"][:], equal_nan=True)
    if "verdicts" in table:
        assert [v[0] for v in table["verdicts"]] == list(group["verdict/name"].asstr("utf-8")[:])
        assert [v[1] for v in table["verdicts"]] == list(group["verdict/reason"].asstr("utf-8")[:])
    for field in table["fields"]:
        stored = group[field["name"]]
        shape = (table["count"], field["repeat"], stored.attrs["rows"], stored.attrs["columns"])
        wanted = stored[:].reshape(shape)[:, :, -field["rows"] :, : field["columns"]]
        found = np.frombuffer(base64.b64decode(field["data"]), "<f4")
        found = found.reshape(field["repeat"], field["columns"], table["count"], field["rows"])
        assert np.array_equal(found.transpose(2, 0, 3, 1), wanted.astype("<f4"), equal_nan=True), field["name"]
        fields += 1
    assert ("poincare/section" in [f["name"] for f in table["fields"]]) == (index == 0 and "poincare" in group)
assert fields > 10
print("the page holds what the result holds")
