#!/usr/bin/env python3
"""Along a parameter that is the length scale every number has the scale of its own point.

    length_scales.py WHIRL LINEAR.yaml

A disc on a linear shaft turns on a circle whose radius has a closed form in metres, whatever lengths are told in: CSV,
JSON, HDF5, the data of figures and the tables of the report are compared with it.
"""
import csv
import json
import math
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py

ECCENTRICITY, SPEED, DAMPING = 0.05e-3, 0.8, 0.1  # m; over the natural frequency; ratio
RADIUS = ECCENTRICITY * SPEED**2 / math.hypot(1 - SPEED**2, 2 * DAMPING * SPEED)
# The method errs by less: 512 steps of order 4 a revolution. Data of figures have 7 digits, tables 4.
EXACT, DATA, TABLE = 1e-8, 1e-6, 1e-3


def expect(what, found, expected, tolerance):
    if not abs(found - expected) <= tolerance * expected:
        sys.exit(f"{what}: {found:.10g}, expected {expected:.10g}")


def check_csv(folder):
    with open(folder / "sweep.csv", newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert len(rows) == 4
    for row in rows:
        expect(f"CSV at c = {row['c [mm]']} mm", float(row["orbit/max_radius disc [mm 0-p]"]), RADIUS / 1e-3, EXACT)
    with open(folder / "detail-spectrum-lines.csv", newline="", encoding="utf-8") as stream:
        lines = list(csv.DictReader(stream))
    for line in lines:
        expect("order in CSV", float(line["order [1]"]), 1.0, EXACT)
        expect("line in CSV", float(line["x [mm 0-p]"]), RADIUS / 1e-3, EXACT)


def check_json(text):
    document = json.loads(text)
    for point in document["points"] + document["detail"]:
        assert point["length_scale"] == point["parameters"]["c"]
        expect("JSON", point["stations"]["disc"]["max_radius"] * point["length_scale"], RADIUS, EXACT)


def check_file(path):
    with h5py.File(path) as result:
        for name in ("sweep", "detail"):
            table = result[name]
            radius = table["orbit/max_radius"]
            scale = table["length_scale"][:]
            assert (scale == table["values"][:]).all()
            assert math.isnan(radius.attrs["SI_factor"])
            for metres in radius[:, 0] * scale:
                expect("HDF5", metres, RADIUS, EXACT)


def series(figure, panel, shape, least=1):
    """The points of all series of a shape in a panel that have so many at least: arrows have three."""
    own = next(one for one in figure["panels"] if one["name"] == panel)
    chosen = [one for one in own["series"] if one["shape"] == shape and len(one.get("x", [])) >= least]
    return [(x, y) for one in chosen for x, y in zip(one["x"], one["y"]) if x is not None]


def check_figures(figure_of):
    diagram = figure_of("bifurcation-disc")
    x, y = series(diagram, "x", "dots"), series(diagram, "y", "dots")
    assert len({place for place, _ in x}) == 4
    for (_, across), (_, up) in zip(x, y):
        expect("bifurcation diagram", math.hypot(across, up), RADIUS / 1e-3, DATA)
    for _, radius in series(diagram, "radius", "line"):
        expect("largest radius", radius, RADIUS / 1e-3, DATA)
    for c in ("0.1mm", "0.4mm"):
        for across, up in series(figure_of(f"c-{c}-disc"), "orbit", "line", 4):
            expect(f"orbit at c = {c}", math.hypot(across, up), RADIUS / 1e-3, DATA)


def check_page(text):
    table = re.search(r"Size and sense.*?</table>", text, re.S)[0]
    radii = re.findall(r"<td>disc</td><td class=\"number\">([\d.]+)</td>", table)
    lines = re.findall(r"<td>1(?:, [\d., ]+)?</td><td[^>]*>([\d.]+)", table)
    assert len(radii) == len(lines) == 4, table
    for radius in radii:
        expect("table of the report", float(radius), RADIUS / 1e-3, TABLE)
    for line in lines:
        expect("lines of the report", float(line), RADIUS / 1e-3, 10 * TABLE)


def main():
    whirl, case = str(Path(shutil.which(sys.argv[1])).resolve()), Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)

        def run(*words):
            return subprocess.run([whirl, *words], cwd=folder, check=True, capture_output=True, text=True).stdout

        run("run", str(case), "-q", "-o", "linear.h5")
        check_json(run("run", str(case), "-q", "--json"))
        run("export", "linear.h5", "--csv", "csv")
        run("report", "linear.h5", "-q", "-o", "report", "--units", "mm")
        check_csv(folder / "csv")
        check_file(folder / "linear.h5")
        check_figures(lambda name: json.loads(run("figure", "linear.h5", name, "--units", "mm", "-o", "-")))
        check_page((folder / "report" / "report.html").read_text(encoding="utf-8"))


main()
