"""Tests that all renderers give the same statements and sheets for every shipped case, number by number.

Renderers: Python, notebooks, JSON, CSV, LaTeX, Markdown, text, the summary and HTML of the command, and Octave.
"""

import csv
import io
import json
import os
import re
import shutil
import subprocess
import textwrap
from html.parser import HTMLParser

import numpy as np
import pytest
from conftest import COMMAND, ROOT, command

import whirl

RPM = 2 * np.pi / 60


def at_rest(name):
    """Makes a shipped case without its motions, at few points."""
    text = (ROOT / f"cases/{name}.yaml").read_text()
    head, study = re.split(r"(?m)^study:\n", text)
    motions = "sweep|motions|starts|initial|integrate|keep|analyze|detail"
    study = re.sub(rf"(?m)^  ({motions}):.*\n(    .*\n)*", "", study)
    return f"{head}study:\n{re.sub('points: [0-9]+', 'points: 4', study)}"


def shortened(name):
    """Makes a shipped case at few points, with short motions, without studies of many starts."""
    head, study = re.split(r"(?m)^study:\n", (ROOT / f"cases/{name}.yaml").read_text())
    study = re.sub(r"(?m)^  (detail|confirm|starts|curves):.*\n(    .*\n)*", "", study)
    study = re.sub(r"points: [0-9]+", "points: 3", study)
    study = re.sub(r"(?m)^(  branch: +\{.*?)(, points: 3)?(, .*)?\}", r"\1\3, points: 20, torus_points: 4}", study)
    short = {"transient": 20, "record": 16, "watch": 30, "rows": 20, "machines": 4, "duration": "0.5 s", "waveform": 2}
    for key, value in short.items():
        study = re.sub(rf"\b{key}: +[0-9.]+( s)?", f"{key}: {value}", study)
    return f"{head}study:\n{study}"


AT_REST = ("floating-ring", "magnetic-drop", "misalignment", "pump", "ross-example", "tilting-pad-table")
OWN = ("modes", "branch", "tori")
NONE = ("reference",)  # a list of all keys, no machine
MOVING = tuple(
    path.stem
    for path in sorted((ROOT / "cases").glob("*.yaml"))
    if path.stem not in AT_REST + NONE and "claims" not in path.stem
)


@pytest.fixture(scope="module", params=AT_REST + MOVING + OWN)
def file(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp(request.param)
    if request.param in OWN:
        text = (ROOT / f"tests/cli/{request.param}.yaml").read_text()
    else:
        text = at_rest(request.param) if request.param in AT_REST else shortened(request.param)
    (folder / "case.yaml").write_text(text)
    command("run", folder / "case.yaml", "-q", "-o", folder / "r.h5")
    return folder / "r.h5"


@pytest.fixture(scope="module")
def modes():
    return whirl.run(whirl.Case(ROOT / "tests/cli/modes.yaml"), progress=False)


def phrase(of):
    return of["text"], tuple(np.nan if number is None else number for number in of["values"])


def test_statements_and_sheets_are_those_of_the_command(file):
    document = json.loads(command("show", file, "--json").stdout)
    result = whirl.open(file)
    statements = result.statements()
    assert len(statements) == len(document.get("statements", []))
    for own, reported in zip(statements, document.get("statements", [])):
        for name in ("table", "what", "verdict", "text"):
            assert getattr(own, name) == reported[name]
        assert (own.station, own.clause) == (reported.get("station", ""), reported.get("clause", ""))
        for name in ("at", "asked", "found", "judged"):
            if name in reported:
                np.testing.assert_equal((getattr(own, name), own.values[name]), phrase(reported[name]))
        assert own.found in str(own) and own.judged in str(own)
    sheets = result.sheets()
    assert len(sheets) == len(document.get("sheets", [])) and statements + list(sheets)
    for (key, own), reported in zip(sheets.items(), document.get("sheets", [])):
        assert (own.table, own.name, own.title) == (reported["table"], reported["name"], reported["title"])
        assert own.si == result.sheet(f"{own.table}/{own.name}").si == result.sheet(key).si
        assert len(own) == len(reported["rows"]) and all(len(row) == len(own.columns) for row in reported["rows"])
        for row, shown, cells in zip(own.si, own.rows, reported["rows"]):
            for column, number, in_unit, cell in zip(own.columns, row, shown, cells):
                assert number == (tuple(cell) if isinstance(cell, list) else cell)
                if isinstance(cell, float):
                    assert in_unit * column.size == pytest.approx(cell, rel=1e-15)


def latex_of(text):
    escaped = re.sub(r"([%&_#$])", r"\\\1", text)
    return escaped.replace("µ", "$\\mu$").replace("+-", "$\\pm$")


def test_texts_are_the_numbers(file):
    """Tests that CSV has every number of `rows`, and that text, LaTeX and Markdown have the rounded numbers of
    `texts`."""
    result = whirl.open(file)
    # One sheet of each name: the tables of one study at several `conditions` have the same sheets.
    once = {sheet.name: (key, sheet) for key, sheet in result.sheets().items()}
    printed, shown_alone = command("table", file).stdout, list(once.values())[-1][0] if once else None
    for key, sheet in once.values():
        heading, *rows = csv.reader(io.StringIO(result.sheet_text(key, "csv"), newline=""))
        assert heading == [column.title for column in sheet.columns] and len(rows) == len(sheet)
        for row, texts in zip(sheet.rows, rows):
            for cell, text in zip(row, texts):
                assert (
                    text == (cell or "")
                    if isinstance(cell, (str, type(None)))
                    else isinstance(cell, tuple) or float(text) == cell
                )
        text, latex = result.sheet_text(key), result.sheet_text(key, "latex")
        for row, texts in zip(sheet.rows, sheet.texts):
            for column, cell, shown in zip(sheet.columns, row, texts):
                numbers = cell if isinstance(cell, tuple) else [] if isinstance(cell, (str, type(None))) else [cell]
                for number, one in zip(numbers, shown.split(column.between) if column.between else [shown]):
                    assert float(one) == pytest.approx(number, rel=0.51 * 10 ** (1 - column.digits))
        assert latex.count("\\\\\n") == len(sheet) + 1
        _, _, *lines = result.sheet_text(key, "markdown").splitlines()
        filled = [texts for texts in zip(*sheet.texts) if any(texts)]
        assert lines == [f"| {' | '.join(text.replace('|', chr(92) + '|') for text in row)} |" for row in zip(*filled)]
        for cell in (cell for row in sheet.texts for cell in row):
            assert cell in text and latex_of(cell) in latex
        assert text in printed and (key != shown_alone or text == command("table", file, key).stdout)


def test_closed_form(modes):
    """Tests a disc of 2 kg on springs of 80 and 200 kN/m."""
    speeds = [np.sqrt(80e3 / 2), np.sqrt(200e3 / 2)]
    sheet = modes.sheet("critical")
    keys = [column.key for column in sheet.columns]
    assert [row[keys.index("omega")] for row in sheet.si] == pytest.approx(speeds, rel=1e-9)
    assert sheet["omega"] == pytest.approx(np.array(speeds) / RPM, rel=1e-9)
    assert sheet.columns[keys.index("omega")].title == "omega (rpm)"
    assert [record["what"] for record in sheet.records()] == ["critical speed"] * 2
    (reported,) = [own for own in modes.statements() if own.what.startswith("critical speeds")]
    assert reported.values["found"] == pytest.approx(speeds, rel=1e-9) and reported.found == "1909.9 rpm, 3019.8 rpm"
    assert reported.table == "modes" and reported.verdict == "none asked for" and not reported.clause


def without_limits(rows):
    """Returns rows with the limits removed from their texts, since limits are written in the shown units."""
    limit = re.compile(r" (or )?not (above|below) \S+( \S+)?( 0-p| p-p)?")
    return [[limit.sub("", cell) if isinstance(cell, str) else cell for cell in row] for row in rows]


def test_units_are_those_of_figures(file):
    """Tests that numbers in SI do not depend on the shown units, and that columns other than parameters have US
    units."""
    result = whirl.open(file)
    metric, customary = result.sheets("SI, Hz"), result.sheets("US")
    assert result.show_in("US").sheets() == customary
    for key, sheet in customary.items():
        assert without_limits(sheet.si) == without_limits(metric[key].si) and sheet.keys == metric[key].keys
        units = {column.unit for column in sheet.columns if column.key not in result.parameters}
        assert not units & {"m", "mm", "µm p-p", "N", "kg mm", "MN/m", "kN s/m", "Hz"}


def test_frames(modes):
    pytest.importorskip("pandas")
    sheet = modes.sheet("lowest")
    frame = sheet.to_pandas()
    assert list(frame.columns) == [column.title for column in sheet.columns] and len(frame) == len(sheet)
    for at, key in enumerate(frame.attrs["keys"]):
        if frame.iloc[:, at].dtype.kind == "f":
            np.testing.assert_array_equal(frame.iloc[:, at], sheet[key])
    statements = modes.statements()
    assert list(statements.to_pandas()["found"]) == [own.found for own in statements]


def test_frames_without_pandas(modes, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "pandas", None)
    with pytest.raises(ImportError, match="pip install pandas"):
        modes.sheet("critical").to_pandas()


class Cells(HTMLParser):
    """The texts of the cells of a table."""

    def __init__(self, page):
        super().__init__()
        self.found, self.inside = [], False
        self.feed(page)

    def handle_starttag(self, tag, _attributes):
        self.inside = tag == "td"
        self.found += [""] if self.inside else []

    def handle_endtag(self, _tag):
        self.inside = False

    def handle_data(self, data):
        if self.inside:
            self.found[-1] += data


def test_notebooks_show_what_texts_do(file):
    result = whirl.open(file)
    for sheet in result.sheets().values():
        shown = [column for column in zip(*sheet.texts) if any(column)]
        assert Cells(sheet._repr_html_()).found == [text for row in zip(*shown) for text in row]
    cells = Cells(result.statements()._repr_html_()).found
    assert all(own.found in cells and own.judged in cells for own in result.statements())


def bare(text):
    return re.sub(r"\s+", " ", text).strip()


class Tables(HTMLParser):
    """The tables of a page as rows of texts, and the text of the page."""

    def __init__(self, page):
        super().__init__()
        self.tables, self.text, self.inside = [], "", False
        self.feed(re.sub(r"<(style|script|svg).*?</\1>", "", page, flags=re.S))

    def handle_starttag(self, tag, _attributes):
        if tag == "table":
            self.tables.append([])
        elif tag == "tr":
            self.tables[-1].append([])
        elif tag in ("td", "th"):
            self.tables[-1][-1].append("")
            self.inside = True

    def handle_endtag(self, tag):
        self.inside = self.inside and tag not in ("td", "th")

    def handle_data(self, data):
        data = data.replace("\u00b1", "+-")
        self.text += data
        if self.inside:
            self.tables[-1][-1][-1] += data


def test_pages_have_all_of_it(file, tmp_path):
    """Tests that the page has every statement with its verdict, and every sheet with all headings and cells."""
    result = whirl.open(file)
    command("report", file, "-o", tmp_path, "-q", "--gnuplot=/bin/true")
    page = Tables((tmp_path / "report.html").read_text(encoding="utf-8"))
    text = bare(page.text)
    for own in result.statements():
        assert bare(own.text) in text and own.asked in text and own.found in text
    tables = [[[bare(cell) for cell in row] for row in table] for table in page.tables]
    for key, sheet in result.sheets().items():
        columns = [
            (column.title, *texts) for column, texts in zip(sheet.columns, zip(*sheet.texts), strict=True) if any(texts)
        ]
        rows = [[bare(cell) for cell in row] for row in zip(*columns, strict=True)]
        step = 1 + (len(sheet) - 1) // 80  # a page has up to 80 points
        shown = rows[:1] + (rows[1::step] if [rows[0], *rows[1::step]] in tables else rows[1:])
        assert shown in tables, key


# Sheets that summaries leave out, because statements say the same or users only look numbers up in them.
LEFT_OUT = "regimes windows jumps attractors verdicts reasons sizes named-lines synchronous".split()
LEFT_OUT += ["watched-stations", "watched-contacts"]


def test_the_summary_has_all_of_it(file):
    """Tests that the summary has every statement, and the headings, the first and the last row of every sheet. `whirl
    table` has the sheets that a summary may leave out."""
    result = whirl.open(file)
    shown = bare(command("show", file).stdout)
    tables = bare(command("table", file).stdout)
    for own in result.statements():
        assert bare(own.text) in shown
    for key, sheet in result.sheets().items():
        reported = tables if sheet.name in LEFT_OUT else shown
        assert sheet.title in reported, key
        for column, texts in zip(sheet.columns, zip(*sheet.texts)):
            # The first row is shown; of sheets with at most 24 rows also the last one.
            for text in (texts[0], texts[min(len(texts), 24) - 1] if len(texts) <= 24 else texts[0]):
                assert bare(text) in reported and (not any(texts) or bare(column.title) in reported), (
                    key,
                    column.title,
                )


OF_ALL = """
statements = whirl_statements(file);
for i = 1:numel(statements)
  printf("statement\\037%s\\037%s\\037%s\\n", statements(i).table, statements(i).verdict, statements(i).text);
end
names = whirl_table(file, "list");
for i = 1:numel(names)
  sheet = whirl_table(file, names{i});
  printf("sheet\\037%s\\n", names{i});
  for row = 1:size(sheet.texts, 1)
    printf("row\\037%s\\n", strjoin(sheet.texts(row, :), "\\037"));
  end
end
"""


@pytest.mark.skipif(not shutil.which("octave-cli"), reason="there is no Octave")
def test_octave_has_all_of_it(file):
    """Tests that Octave has every statement with its verdict, and every cell of every sheet."""
    result = whirl.open(file)
    expected = [("statement", own.table, own.verdict, own.text) for own in result.statements()]
    for key, sheet in result.sheets().items():
        expected += [("sheet", key), *(("row", *texts) for texts in sheet.texts)]
    script = f"file = '{file}'; {OF_ALL}"
    done = subprocess.run(
        [
            "octave-cli",
            "--no-init-file",
            "--no-history",
            "--quiet",
            "--path",
            str(ROOT / "bindings/octave"),
            "--eval",
            script,
        ],
        check=True,
        capture_output=True,
        text=True,
        env={**os.environ, "WHIRL": str(COMMAND)},
    )
    assert [tuple(line.split("\x1f")) for line in done.stdout.splitlines()] == expected


def test_no_number_is_rounding_noise():
    """Tests that numbers that are 0 by symmetry (the slope in the middle of a shaft, the cross coupling of its magnets)
    are shown as 0, not as rounding errors."""
    magnet = (
        "{at: %s, gap: 0.5 mm, bias: 4 A, turns: 200, area: 8 cm2, max_current: 9 A, proportional: 1.8e4 A/m, "
        "integral: 8e4 A/m/s, derivative: 28 A.s/m, derivative_filter: 0.1 ms, sensor_bandwidth: 10 kHz, "
        "amplifier_bandwidth: 2.5 kHz}"
    )
    text = f"""
        whirl: 1
        rotor:
          speed: 10000 rpm
          length_scale: 0.25 mm
          shafts: {{main: {{mesh_to: 2 kHz, modes: 6}}}}
          stations:
            de: {{position: 120 mm, mass: 3 kg}}
            core: {{position: 500 mm, mass: 55 kg, diametral: 1.9 kg.m2, polar: 0.32 kg.m2}}
            nde: {{position: 880 mm, mass: 3 kg}}
          elements:
            - gravity: {{}}
            - segment: {{length: 200 mm, outer: 80 mm}}
            - segment: {{length: 600 mm, outer: 110 mm}}
            - segment: {{length: 200 mm, outer: 80 mm}}
            - magnetic: {magnet % "de"}
            - magnetic: {magnet % "nde"}
        study: {{statics: {{}}}}
        """
    result = whirl.run(whirl.Case(text=textwrap.dedent(text)), progress=False)
    weight, bearings = result.sheet("statics/weight"), result.sheet("statics/coefficients")
    slopes = weight["slope"]
    assert slopes[1] == 0.0 and slopes[0] == pytest.approx(-slopes[2], rel=1e-9) and slopes[0] != 0.0
    assert np.all(bearings["kxy"] == 0.0) and np.all(bearings["kxx"] > 0.0)


def test_motions_without_spectra_have_those_of_the_machine():
    text = re.sub("analyze: .*", "analyze: [orbit]", (ROOT / "tests/cli/good.yaml").read_text())
    result = whirl.run(whirl.Case(text=text), progress=False)
    reported = [own.what for own in result.statements()]
    assert reported == ["weight", "motions", "nearest to a wall"]
    assert list(result.sheets()) == ["stations", "sizes", "watched-stations"]
    with pytest.raises(whirl.BadInput, match="there is no sheet 'peaks'"):
        result.sheet("peaks")


def test_wrong_arguments_are_refused(modes):
    with pytest.raises(whirl.BadInput, match="there is no sheet 'lowst', did you mean lowest"):
        modes.sheet("lowst")
    with pytest.raises(whirl.BadInput, match="expected text, csv, latex, markdown or json"):
        modes.sheet_text("lowest", "xlsx")
    with pytest.raises(whirl.BadInput, match="holds one sheet, expected the name of one"):
        modes.sheet_text(format="csv")
    with pytest.raises(whirl.BadInput, match="did you mean rpm"):
        modes.statements("rpn")
    with pytest.raises(KeyError, match="no column 'speeds', expected one of: "):
        modes.sheet("lowest")["speeds"]
    with pytest.raises(KeyError, match="did you mean 'lowest'"):
        modes.sheets()["lowes"]
