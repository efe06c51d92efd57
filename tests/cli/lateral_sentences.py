#!/usr/bin/env python3
"""Checks every sentence of a lateral document against the numbers of its result:

    lateral_sentences.py RESULT.h5 lateral.html

A sentence is whatever stands outside of tables, figures and the case. Those with a number or a verdict must be of a
kind that is known here, and are derived once more from the fields of the result, by rules of this file's own: what is stable
by growth, where modes cross the speed, margins by API 617's formula, shares of clearances, decrements, motions. What is
no finding stands in FIXED, each with its reason. A sentence of another kind is a failure: tell here how it is checked.
"""
import html
import json
import math
import re
import subprocess
import sys

import h5py
import numpy as np

RPM = math.pi / 30.0
MIL = 25.4e-6
UNITS = {"mil p-p": MIL, "mil": MIL, "s": 1.0, "N": 1.0, "MN/m": 1e6, "mm 0-p": 1e-3, "rpm": RPM, "Hz": 2.0 * math.pi, "rad/s": 1.0, "1/s": 1.0, "%": 1.0, "N/m": 1.0, "µm p-p": 1e-6, "µm": 1e-6,
         "mm": 1e-3, "": 1.0}

# Sentences with numbers that are no findings.
FIXED = {
    r"\d+\. [A-Z][a-z, -]+|Contacts of a run": "a title",
    r"Values before and after a jump, on the way up .*": "what a jump is",
    r"Clauses are those of API RP 684, .*": "editions of standards",
    r"Of the machine without damping, the lowest 6 of each direction\.": "how many are listed",
    r"Natural frequencies over the speed \(Campbell diagram\), .*": "what the chapter has",
    r"Critical speeds as peaks of all stations, .*": "the method",
    r"The (least|smallest) logarithmic decrement of (the )?forward modes .*": "the method",
    r"Logarithmic decrements with bearings, .*": "what the chapter has",
    r"Critical speeds and thresholds of stability": "a title",
    r"Amplitudes say whether they are zero to peak \(0-p\) or peak to peak \(p-p\)\.": "the convention",
    r"Time against the rotation: .*": "a definition",
    r"Amplitudes and phase lags of x, of y, and of the circular motions .*": "a definition",
    r"The exponent is the mean over all watched revolutions, .*": "a definition",
    r"Every point was started from .*": "the method",
    r"At the (running speed|frequency of the \w+) \(1X\)": "a title",
}


def plain(markup):
    return re.sub(r"\s+", " ", html.unescape(re.sub(r"<[^>]+>", " ", markup))).strip().replace(" .", ".").replace("\u00b1", "+-")


def sentences(markup):
    """Titles of third order and texts below them: of paragraphs, items and titles, without tables, lists of facts,
    figures and the case."""
    markup = re.sub(r"<(style|script|svg|pre|table|figure|dl)\b.*?</\1>", "</p>", markup, flags=re.S)
    markup = markup[markup.index("<main>") :]
    title = ""
    tags = r"/?(?:p|li|ul|ol|h[1-6]|section|div|summary|details)\b"
    for tag, text in re.findall(rf"<({tags})[^>]*>((?:[^<]|<(?!{tags}))*)", markup):
        text = plain(text)
        title = text if tag == "h3" else title
        if re.search(r"\d|stable|holds|fails|not known|never", text):
            yield title, text


def rounds_to(value, shown):
    """Whether a number is shown to the digits that it has."""
    written = re.sub(r"[eE].*|-", "", shown)
    # Zeros at the end of a whole number may stand for digits that are not shown.
    digits = len((written.replace(".", "") if "." in written else written.rstrip("0")).lstrip("0")) or 1
    number = float(shown)
    if value == number:
        return True
    if number == 0.0 or not math.isfinite(value):
        return False
    return abs(value - number) <= 0.5001 * 10.0 ** (math.floor(math.log10(abs(number))) - digits + 1)


class Result:
    """A result, and what JSON says of it."""

    def __init__(self, path):
        self.file = h5py.File(path)
        text = subprocess.run(["whirl", "show", path, "--json"], check=True, capture_output=True, text=True).stdout
        self.json = json.loads(text)
        self.stations = [name.decode() for name in self.file["stations/name"][:]]
        self.contacts = [name.decode() for name in self.file["contacts/name"][:]] if "contacts" in self.file else []

    def field(self, table, name):
        return self.file[table][name][:] if name in self.file[table] else None

    def values(self, table):
        return self.file[table]["values"][:]

    def lengths(self, table):
        return self.file[table]["length_scale"][:]

    def option(self, table, name):
        return self.file[table].attrs[name]

    def tables(self):
        return [name for name in self.file if isinstance(self.file[name], h5py.Group) and "analyses" in self.file[name].attrs]

    def sheet(self, table, name):
        for sheet in self.json.get("sheets", []):
            if sheet["table"] == table and sheet["name"] == name:
                keys = [column["key"] for column in sheet["columns"]]
                return [dict(zip(keys, row)) for row in sheet["rows"]]
        return []


# ---------------------------------------------------------------- statements


def stability_of_modes(result, own):
    table = own["table"]
    at = np.argmin(abs(result.values(table) - own["at"]["values"][0])) if "at" in own else 0
    largest = result.field(table, "modes/stability")[at]
    seen = [result.field(table, name)[at] for name in ("modes/growth", "modes/overdamped")]
    seen = max([np.nanmax(numbers) for numbers in seen if np.isfinite(numbers).any()])
    word = "stable" if largest < 0 else "unstable" if largest > 0 else "undamped"
    assert seen <= largest + 1e-9 * abs(seen), f"a mode grows with {seen}"
    match = re.fullmatch(r"(\w+): the largest real part of all eigenvalues(?: but .*)? is (\S+) 1/s", own["found"]["text"])
    assert match and match[1] == word and rounds_to(largest, match[2]), f"{largest} 1/s"


def critical(result, own):
    """Modes cross the speed, or the growth its zero, between the points on both sides of what is reported."""
    table, text = own["table"], own["found"]["text"]
    values, speed = result.values(table), result.field(table, "modes/speed")
    frequency, growth = result.field(table, "modes/frequency"), result.field(table, "modes/stability")
    thresholds = re.findall(r"(unstable|stable) from (?:\w+ = )?(\S+)(?: (rpm|MN/m|N/m))?", text)
    for word, shown, unit in thresholds:
        value = float(shown) * UNITS[unit]
        after = np.searchsorted(values, value)
        assert 0 < after < len(values), f"{value} is at no point"
        signs = (growth[after - 1] > 0, growth[after] > 0)
        assert signs == ((False, True) if word == "unstable" else (True, False)), f"growth {growth[after - 1 : after + 1]}"
    rest = re.sub(r"(unstable|stable) from (?:\w+ = )?(\S+)(?: (rpm|MN/m|N/m))?", "", text)
    for shown, at, unit in re.findall(r"([\d.]+(?:e[+-]\d+)?) rpm(?: at \w+ = (\S+) ([^\s,]+))?", rest):
        after = np.searchsorted(values, float(at) * UNITS[unit]) if at else np.searchsorted(speed, float(shown) * RPM)
        assert 0 < after < len(speed), f"{shown} rpm is at no point"
        below = [np.sum(frequency[i] < speed[i]) for i in (after - 1, after)]
        assert below[0] != below[1], f"no frequency crosses the speed near {shown} rpm"
    everywhere = re.search(r"unstable at all (\d+) values|unstable at (\d+) of (\d+) values", rest)
    if everywhere:
        reported = int(everywhere[1] or everywhere[2])
        assert reported == np.sum(growth > 0), f"{np.sum(growth > 0)} are"
    more = re.search(r"and (\d+) more", rest)
    rows = np.isfinite(result.field(table, "modes/critical")[..., 0]).sum()
    reported = len(thresholds) + len(re.findall(r"[\d.]+ rpm", rest)) + (int(more[1]) if more else 0)
    assert not rows or everywhere or reported == rows, f"{rows} are located"


def frequencies(result, own):
    known = result.field(own["table"], "modes/known")
    shown = re.findall(r"([\d.e+]+) rad/s", own["found"]["text"])
    if "known but for multiples" in own["found"]["text"]:
        known = result.field(own["table"], "modes/modulo").reshape(-1, 1)
    assert shown and all(rounds_to(known[0][i], text) for i, text in enumerate(shown)), f"{known[0]}"


def sensitivity(result, own):
    table, text = own["table"], own["found"]["text"]
    at = np.argmin(abs(result.values(table) - own["at"]["values"][0])) if "at" in own else 0
    peak, frequency = (result.field(table, f"modes/{name}")[at] for name in ("sensitivity", "sensitivity_frequency"))
    match = re.match(r"([\d.]+) at ([\d.]+) Hz: (?:zone ([A-D])|no zone)", text)
    zone = "A" if peak < 3 else "B" if peak < 4 else "C" if peak < 5 else "D"
    assert match and rounds_to(peak, match[1]) and rounds_to(frequency / (2 * math.pi), match[2]), f"{peak} at {frequency}"
    assert match[3] == (None if result.field(table, "modes/stability")[at] > 0 else zone), zone


def rigid(result, own):
    at = np.argmin(abs(result.values(own["table"]) - own["at"]["values"][0])) if "at" in own else 0
    assert own["found"]["text"].startswith(f"{result.field(own['table'], 'modes/rigid_body')[at]:g},")


def running(result, table):
    low, high = result.option(table, "running_low"), result.option(table, "running_high")
    return (low or high), (high or low)


def probed(result, table):
    """Stations with a probe."""
    names = result.option(table, "probes_at")
    names = [name for name in re.split(r"[,\s]+", names.decode() if isinstance(names, bytes) else names) if name]
    return names or result.stations


def margin(result, own):
    """The reported peak is one of the response there; the required margin follows from its amplification by API 617."""
    table, (low, high) = own["table"], running(result, own["table"])
    speed, probe = result.field(table, "unbalance/speed"), result.field(table, "unbalance/probe")
    peaks = [peak for peak in result.sheet(table, "peaks") if peak["asked"] and peak["asked"] > 0]
    satisfied = [peak for peak in peaks if peak["margin"] is not None and peak["margin"] >= peak["asked"]]
    for peak in peaks:
        factor, side = peak["amplification"], peak["side"]
        asked = 17 * (1 - 1 / (factor - 1.5)) + (10 if side == "above" else 0)
        had = (peak["speed"] / high - 1 if side == "above" else 1 - peak["speed"] / low) * 100
        near = np.argmin(abs(speed - peak["speed"]))
        curve = probe[:, result.stations.index(peak["station"]), :].max(axis=1)
        window = curve[max(near - 1, 0) : near + 2]
        if side != "within":
            assert abs(asked - peak["asked"]) < 0.02 and abs(had - peak["margin"]) < 1e-6, f"{peak}: {asked}, {had}"
        assert peak["station"] in probed(result, table) and len(window) and peak["amplitude"] > 0, f"{peak}"
    assert all(peak["verdict"].startswith("holds") == (peak in satisfied) for peak in peaks), "verdicts of peaks"
    reaches = (np.diff(speed) > 0).all() and speed[0] <= low * (1 + 1e-9) and speed[-1] >= high * (1 - 1e-9)
    verdict = "fails" if len(satisfied) < len(peaks) else "not known" if not reaches else "holds" if peaks else "none asked for"
    assert own["verdict"] == verdict, f"{len(satisfied)} of {len(peaks)} peaks"
    match = re.match(r"holds: (\d+) of (\d+) peaks|fails: (\d+) of (\d+) peaks", own["judged"]["text"])
    if match:
        reported = (int(match[1]), int(match[2])) if match[1] else (int(match[4]) - int(match[3]), int(match[4]))
        assert reported == (len(satisfied), len(peaks)), f"{len(satisfied)} of {len(peaks)} hold"
    if peaks:
        worst = min(peaks, key=lambda peak: -math.inf if peak["margin"] is None else peak["margin"] - peak["asked"])
        shown = [worst["asked"]] + ([] if worst["margin"] is None else [worst["margin"]]) + [worst["speed"]]
        assert np.allclose(own["asked"]["values"] + own["found"]["values"], shown), f"the worst is {worst}"
        assert worst["station"] in own["found"]["text"]


def scaling(result, table):
    """Vibration limit of API 617, m p-p, the largest where the machine runs at points, and the factor."""
    low, high = running(result, table)
    speed = result.field(table, "unbalance/speed")
    limit = 25.4e-6 * min(1.0, math.sqrt(12000 * RPM / high))
    inside = (speed >= low * (1 - 1e-9)) & (speed <= high * (1 + 1e-9))
    seen = 2 * result.field(table, "unbalance/probe") * result.lengths(table)[:, None, None]
    columns = [result.stations.index(name) for name in probed(result, table)]
    return limit, seen[inside][:, columns].max() if inside.any() else 0.0


def vibration(result, own):
    limit, largest = scaling(result, own["table"])
    reported = own["found"]["values"][0]
    # Between points it may be larger, by a curve through them.
    assert np.isclose(own["asked"]["values"][0], limit) and largest <= reported * (1 + 1e-9) and reported < 1.2 * largest + 1e-12, largest
    assert own["verdict"] == ("fails" if reported > limit else "holds")


def scaled(result, own):
    if own["found"]["text"].startswith("none: "):
        return
    limit, largest = scaling(result, own["table"])
    reported = own["found"]["values"]
    match = re.search(r"responses are scaled by ([\d.]+) \(6 at most\)", own["found"]["text"])
    assert np.isclose(reported[0], limit) and largest <= reported[1] * (1 + 1e-9) and reported[1] < 1.2 * largest + 1e-12, largest
    assert match and rounds_to(min(6.0, limit / reported[1]), match[1])


def clearances(result, own):
    table, match = own["table"], re.match(r"(\S+) % at (\S+), (\S+) rpm, scaled by (\S+)", own["found"]["text"])
    factor = float(match[4])
    speed, trip = result.field(table, "unbalance/speed"), result.option(table, "trip")
    last = np.searchsorted(speed, trip * (1 - 1e-9)) if trip > 0 else len(speed) - 1
    share = 100 * factor * result.field(table, "unbalance/axes")[..., 0] / result.field(table, "unbalance/clearance")
    share = np.nan_to_num(share[: last + 1], posinf=0)
    point, station = np.unravel_index(share.argmax(), share.shape)
    reported = own["found"]["values"]
    assert abs(reported[0] / share.max() - 1) < 1e-3 and match[2] == result.stations[station], f"{share.max()} %"
    assert np.isclose(reported[1], speed[point]), f"{speed[point]} rad/s"
    assert own["verdict"] == ("holds" if share.max() <= 75 else "fails")


def levels(result, table):
    names = ("anticipated", "limit", "decrement", "complete", "region")
    numbers = {name: result.field(table, f"stability/{name}") for name in names}
    staged = np.nan_to_num(numbers["anticipated"]) > 0
    asked = np.where(np.nan_to_num(numbers["region"]) > 0.5, 10.0, 2.0)
    ratio = np.where(staged, numbers["limit"] / np.where(staged, numbers["anticipated"], 1), np.nan)
    one = np.where(~staged, "none", np.where(np.isnan(numbers["decrement"]), "not known",
                   np.where((numbers["decrement"] >= 0.1) & ~(ratio < asked), "holds", "fails")))
    two = np.where(np.isnan(numbers["complete"]), "not known", np.where(numbers["complete"] > 0.1, "holds", "fails"))
    return numbers, staged, ratio, one, two


def worst_of(verdicts):
    return next(word for word in ("fails", "not known", "holds", "none") if word in verdicts)


def level_one(result, own):
    numbers, staged, ratio, one, _ = levels(result, own["table"])
    assert own["verdict"] == worst_of(one), f"{one}"
    match = re.search(r"decrement (\S+), (?:limit (\S+) times|no limit below 1000 times)", own["found"]["text"])
    assert match and rounds_to(np.nanmin(numbers["decrement"][staged]), match[1]), f"{numbers['decrement']}"
    assert not match[2] or any(rounds_to(number, match[2]) for number in ratio), f"{ratio}"
    region = re.search(r"(\d+) of (\d+) points in region B", own["found"]["text"])
    assert not region or int(region[1]) == np.sum(numbers["region"] > 0.5)


def level_two(result, own):
    numbers, _, _, _, two = levels(result, own["table"])
    assert own["verdict"] == worst_of(two), f"{two}"
    match = re.search(r"decrement (\S+)", own["found"]["text"])
    assert not match or rounds_to(np.nanmin(numbers["complete"]), match[1]), f"{numbers['complete']}"


def lines_beside(result, own):
    """The line reported is one of its station's at that value, and none there is larger on this side of the synchronous one;
    where none is reported, no point of a few has one."""
    table, below = own["table"], own["what"].startswith("sub")
    lines = result.field(table, "spectrum/lines")
    order, size = lines[..., 0], np.fmax(lines[..., 1], lines[..., 2])
    side = (order > 0.02) & (order < 0.98) if below else (order > 1.02) & (abs(order - np.round(order)) > 0.02)
    side &= size >= 0.05 * size[..., :1]
    seen = np.where(side, size, 0.0) * result.lengths(table)[:, None, None]
    if own["found"]["text"].startswith("none of 5 % or more of the largest line"):
        assert len(seen) > 8 or not seen.any(), f"order {order[seen == seen.max()]}, {seen.max()} m"
        return
    match = re.match(r"largest .* at order (\S+) of (\w+), \w+ = ", own["found"]["text"])
    point, station, row = np.unravel_index(seen.argmax(), seen.shape)
    reported = own["found"]["values"]
    assert match and seen[point, station, row] >= reported[0] * (1 - 1e-9), f"{seen.max()} m"
    if len(seen) <= 8:
        assert np.isclose(reported[0], seen.max()) and np.isclose(reported[1], result.values(table)[point]), f"{seen.max()} m"
        assert rounds_to(order[point, station, row], match[1]) and match[2] == result.stations[station], f"order {order[point, station, row]}"


def unknown_bearings(result, own):
    """Their stations have a bearing of coefficients, or a film of a force scale, in the case."""
    case = result.file["case/text"].asstr("utf-8")[0]
    stations, _, what = own["found"]["text"].partition(": the case gives ")
    kind = "film" if what.startswith("the force scale") else "bearing"
    assert stations and what.endswith(" are not known")
    for station in stations.split(", "):
        assert re.search(rf"- {kind}:\s*(\{{\s*)?at: {station}\b", case), f"{station} has no such {kind}"


def weight(result, own):
    """The components along the shafts and across add up to the gravity of the case."""
    text = own["found"]["text"]
    case = result.file["case/text"].asstr("utf-8")[0]
    asked = re.search(r"^\s*- gravity(?:: *(?:(\S+) m/s2|\{.*?acceleration: (\S+) m/s2.*?\}|.*))?", case, re.M)
    parts = [float(number) for number in re.findall(r"(\S+) m/s2", text)]
    gravity = float(asked[1] or asked[2] or 9.80665) if asked else 0.0
    assert abs(math.hypot(0.0, *parts) - gravity) < 1e-5 * gravity + 1e-12, f"{gravity} m/s2"
    assert text.startswith("none: ") == (gravity == 0.0)


def missing(result, table):
    """The points without any number of the analyses of motions."""
    numbers = []
    for analysis in ("poincare", "orbit", "rub", "spectrum", "lyapunov", "exponents"):
        for name in result.file[table].get(analysis, {}):
            numbers.append(np.isfinite(result.field(table, f"{analysis}/{name}")).reshape(len(result.values(table)), -1).any(axis=1))
    return ~np.any(numbers, axis=0)


def ended_early(result, own):
    lost = missing(result, own["table"])
    match = re.match(r"(\d+) of (\d+) motions(?:, first at (\S+))?", own["found"]["text"])
    assert match and (int(match[1]), int(match[2])) == (lost.sum(), len(lost)), f"{lost.sum()} of {len(lost)}"
    assert not match[3] or np.isclose(own["found"]["values"][0], result.values(own["table"])[lost.argmax()])


def largest_motion(result, own):
    """The station that goes farthest from the centre during any run, when and at which speed."""
    table = own["table"]
    peak = result.field(table, "runup/peak") * result.lengths(table)[:, None]
    run, station = np.unravel_index(np.nanargmax(peak), peak.shape)
    seen = [peak[run, station]] + [result.field(table, f"runup/peak_{name}")[run, station] for name in ("time", "speed")]
    assert np.allclose(own["found"]["values"], seen, rtol=1e-12) and f"at {result.stations[station]}," in own["found"]["text"], seen


def touches(result, own):
    """How often a contact closes in the run in which it is pressed most, and the largest force at the instants of the run."""
    table, contact = own["table"], result.contacts.index(own["what"])
    force = result.field(table, "runup/force")[:, contact] * result.file["case"].attrs["force_scale"]
    run = np.unravel_index(np.nanargmax(force), force.shape)[0]
    match = re.match(r"closes (\d+) times?, first at ([\d.e+]+) s, with up to (\S+) N", own["found"]["text"])
    assert match and int(match[1]) == result.field(table, "runup/contact_number")[run, contact], "number"
    assert rounds_to(result.field(table, "runup/contact")[run, contact, 0], match[2]), result.field(table, "runup/contact")
    assert rounds_to(np.nanmax(force), match[3]), f"{np.nanmax(force)} N"


def line_jump(result, own):
    """Between neighbouring points; the line is the strongest of its station on its side at both."""
    table, values = own["table"], result.values(own["table"])
    match = re.match(r"jumps from (\S+) .* to (\S+) .* after (\S+)", own["found"]["text"])
    lines = result.field(table, "spectrum/lines")
    order, size = lines[..., 0], np.fmax(lines[..., 1], lines[..., 2]) * result.lengths(table)[:, None, None]
    at = np.argmin(abs(values - own["found"]["values"][-1]))
    assert match and at + 1 < len(values), f"{own['found']}"
    reported = float(own["what"].split()[-1])
    assert any(rounds_to(one, own["what"].split()[-1]) for one in order[at].ravel()), f"no line of order {reported}"
    assert np.isclose(size[at], own["found"]["values"][0]).any() and np.isclose(size[at + 1], own["found"]["values"][1]).any()


def runout(result, own):
    assert result.field(own["table"], "unbalance/seen") is not None


def clearances_unknown(result, own):
    assert own["verdict"] == "not known" and not own["found"]["text"]


def of_several_starts(result, table):
    return result.file[table].attrs.get("starts", 1) > 1


def motions(result, own):
    """How many come back, diverge, are in doubt, have no verdict or end early."""
    table, text = own["table"], own["found"]["text"]
    match = re.fullmatch(r"(\d+), not judged \(analyze: regime\): (\d+) revolutions[^;]*(?:; (\d+) of them ended early.*)?", text)
    if match:
        assert int(match[1]) == len(result.values(table)) and int(match[2]) == result.option(table, "record")
        assert int(match[3] or 0) == missing(result, table).sum(), f"{missing(result, table).sum()} have no numbers"
        return
    codes, periods = result.field(table, "regime/code"), result.field(table, "regime/period")
    match = re.fullmatch(r"(?P<one>\d+) of (?P<all>\d+) come back every revolution(?:, \d+ diverge \(.*?\))?"
                         r"(?:, (?P<doubt>\d+) are in doubt)?(?P<rest>.*)", text)
    assert match, text
    if of_several_starts(result, table):
        of_starts(result, table, match)
        return
    assert int(match["all"]) == len(codes) and int(match["one"]) == np.sum((codes == 1) & (periods == 1)), f"{codes}, {periods}"
    doubt = np.sum(result.field(table, "regime/confidence") == 0)
    assert int(match["doubt"] or 0) == doubt, f"{doubt} in doubt"


def of_starts(result, table, match):
    """Motions from several starts a point: how many starts have no verdict, at how many points none has one, and that the
    others are reported."""
    codes, values = result.field(table, "regime/code"), result.values(table)
    reported = {value: np.any(codes[values == value] > 0) for value in set(values)}
    starts = re.search(r"(\d+) of (\d+) starts have no verdict(?: \(at (\d+) of (\d+) points none of them has one\))?", match["rest"])
    without, empty = np.sum(codes == 0), sum(not one for one in reported.values())
    assert (int(starts[1]) if starts else 0) == without, f"{without} of {len(codes)} starts"
    assert not starts or int(starts[3] or 0) == empty, f"{empty} of {len(reported)} points"
    assert int(match["one"]) <= int(match["all"]) >= len(reported) - empty, f"{len(reported)} points"


def touches_motions(result, own):
    """Where motions touch, how long and how hard."""
    table, name, text = own["table"], own["what"], own["found"]["text"]
    if of_several_starts(result, table):
        return
    share = result.field(table, "rub/share")[:, result.contacts.index(name)]
    force = result.field(table, "rub/max_force")[:, result.contacts.index(name)] * result.file["case"].attrs["force_scale"]
    match = re.match(r"touches in (\d+) of (\d+) motions.*?at most (\S+) % of the time and with (\S+) N", text)
    assert (text == "never touches") == (np.nanmax(share) == 0) and (match or text == "never touches"), f"{name}: {share}"
    if match:
        assert int(match[1]) == np.sum(share > 0) and rounds_to(100 * np.nanmax(share), match[3]) and rounds_to(np.nanmax(force), match[4])


def nearest(result, own):
    table, wall = own["table"], re.match(r"(\S+) % of its radial (clearance|gap)", own["found"]["text"])
    if of_several_starts(result, table):
        return
    at = result.stations.index(own["station"])
    reach = result.file["stations"]["gap" if wall[2] == "gap" else "clearance"][at]
    parameter = result.option(table, "parameter")
    parameter = parameter.decode() if isinstance(parameter, bytes) else parameter
    if wall[2] == "gap" and re.search(rf"gap: = {parameter}\b", result.file["case/text"].asstr("utf-8")[0]):
        reach = result.values(table) / result.lengths(table)
    seen = 100 * np.nanmax(result.field(table, "orbit/max_radius")[:, at] / reach)
    assert rounds_to(seen, wall[1]), f"{seen} %"


def no_other_motions(result, own):
    assert not of_several_starts(result, own["table"]) and own["found"]["text"] == "not searched for (starts)"


CODES = {"P": 1, "quasi-periodic": 2, "chaotic": 3, "undetermined": 0, "diverged": 4}


def regimes(result, own):
    """Ends of ranges are points with the regime reported; ranges that change have several."""
    table = own["table"]
    values, codes, periods = result.values(table), result.field(table, "regime/code"), result.field(table, "regime/period")
    reported = iter(own["found"]["values"])
    for part in own["found"]["text"].split("; "):
        match = re.match(r"(changing: )?(.*?) (from|at) ", part)
        ends = [next(reported) for _ in range(2 if match[3] == "from" else 1)]
        for value in ends:
            here = np.isclose(values, value, rtol=1e-12)
            assert here.any(), f"no point at {value}"
            names = {f"P-{int(periods[i])}" if codes[i] == 1 else next(name for name, code in CODES.items() if code == codes[i])
                     for i in np.flatnonzero(here)}
            assert names & set(match[2].split(", ")) or "rests" in match[2], f"{names} at {value}"


def confidence(result, own):
    table, text = own["table"], own["found"]["text"]
    grades = result.field(table, "regime/confidence")
    single = re.match(r"(high|fair|low) \(", text)
    if single:
        assert ["low", "fair", "high"][int(grades[0])] == single[1], f"{grades}"
        return
    match = re.fullmatch(r"(\d+) high, (\d+) fair, (\d+) low", text)
    reported = [int(match[i]) for i in (3, 2, 1)]
    counts = [int(np.sum(grades == i)) for i in range(3)]
    if of_several_starts(result, table):
        assert sum(reported) == len([one for one in result.json["attractors"] if one["table"] == table])
    else:
        assert reported == counts, f"{counts}"


def rubbing(result, own):
    table = own["table"]
    share = np.nanmax(result.field(table, "rub/share"), axis=1)
    match = re.fullmatch(r"at (\d+) of (\d+) points", own["found"]["text"])
    assert match and (of_several_starts(result, table) or (int(match[1]), int(match[2])) == (np.sum(share > 0), len(share))), f"{share}"


def undetermined(result, own):
    """No more points than have no verdict; the first is one of them."""
    table = own["table"]
    codes, values = result.field(table, "regime/code"), result.values(table)
    match = re.match(r"at (\d+) points?", own["found"]["text"])
    assert match and 0 < int(match[1]) <= np.sum(codes == 0), f"{np.sum(codes == 0)}"
    first = [value for value in own["found"]["values"][:1] if "first at" in own["found"]["text"]]
    assert all(np.isclose(values[codes == 0], value, rtol=1e-12).any() for value in first), f"{first}"


def to_settle(result, own):
    assert (result.field(own["table"], "regime/code") == 0).any()


def without_verdict(result, own):
    codes = result.field(own["table"], "regime/code")
    match = re.match(r"(\d+) of (\d+) starts", own["found"]["text"])
    assert match and (int(match[1]), int(match[2])) == (np.sum(codes == 0), len(codes)), f"{codes}"


def several(result, own):
    places = {}
    for one in result.json["attractors"]:
        if one["table"] == own["table"]:
            places.setdefault(str(one["parameters"]), set()).add(one["attractor"])
    count = sum(len(numbers) > 1 for numbers in places.values())
    match = re.match(r"coexist at (\d+) of (\d+) point|found at no point", own["found"]["text"])
    assert match and int(match[1] or 0) == count, f"{count}"


def missed(result, own):
    match = re.match(r"(\d+) for each point: with a chance of 5 % they all miss an attractor to which (\S+) % of starts", own["found"]["text"])
    count = int(result.file[own["table"]].attrs["starts"])
    assert match and int(match[1]) == count and rounds_to(100 * (1 - 0.05 ** (1 / count)), match[2])


def motion(result, own):
    table, text = own["table"], own["found"]["text"]
    if text.startswith("no verdict"):
        assert result.field(table, "regime/code") is None
        return
    name = re.match(r"P|rests|[\w-]+", text)[0]
    assert CODES.get(name, 1) == result.field(table, "regime/code")[0], text


def reason(result, own):
    exponent = result.field(own["table"], "regime/exponent")
    match = re.search(r"largest exponent (\S+) \+- ", own["found"]["text"])
    assert not match or np.isclose(exponent.ravel()[0], float(match[1]), atol=2e-1), f"{exponent}"


def beyond(result, own):
    """Range of a law that is exceeded: the limit, the largest value, at how many points and where first."""
    table = own["table"]
    match = re.fullmatch(r".* up to (?P<most>\S+?)(?: [^\s,]+)?, .*; reached (?P<reached>\S+?)"
                         r"(?: [^\s(]+)?(?: \((?P<points>\d+) of \d+ points, first at .*\))?", own["found"]["text"])
    reached, most = np.moveaxis(result.field(table, "ranges/reached"), -1, 0).reshape(2, len(result.values(table)), -1)
    found = [row for row in range(reached.shape[1]) if rounds_to(np.nanmax(reached[:, row]), match["reached"])
             and rounds_to(most[0, row], match["most"])]
    assert found, f"{np.nanmax(reached, axis=0)}"
    left = reached[:, found[0]] > most[:, found[0]]
    assert not match["points"] or int(match["points"]) == left.sum(), f"{left.sum()} points"
    assert not own["found"]["values"] or np.isclose(own["found"]["values"][0], result.values(table)[left.argmax()])


STATEMENTS = {
    "critical speeds with damping, and thresholds of stability": critical,
    "stability": stability_of_modes,
    "frequencies": frequencies,
    "rigid-body modes": rigid,
    "peak sensitivity of the loops of control": sensitivity,
    "separation margin": margin,
    "vibration at probes where it runs": vibration,
    "vibration at probes, clearances": clearances_unknown,
    "close clearances": clearances,
    "scaled responses": scaled,
    "runout": runout,
    "weight": weight,
    "bearings": unknown_bearings,
    "sub-synchronous lines": lines_beside,
    "super-synchronous lines": lines_beside,
    "ended early": ended_early,
    "largest motion": largest_motion,
    "stability, Level I": level_one,
    "stability, Level II": level_two,
    "motions": motions,
    "nearest to a wall": nearest,
    "other motions": no_other_motions,
    "regimes": regimes,
    "confidence": confidence,
    "rub": rubbing,
    "undetermined": undetermined,
    "undetermined points": to_settle,
    "without a verdict": without_verdict,
    "several attractors": several,
    "starts": missed,
    "motion": motion,
    "reason": reason,
    "beyond its law": beyond,
}


def shown_agrees(own):
    """Numbers of a statement's texts are its numbers in the units that stand behind them."""
    for part in ("asked", "found", "judged"):
        values = list(own[part]["values"])
        for shown, unit in re.findall(r"(?<![\w.])(-?\d[\d.]*(?:e[+-]?\d+)?)(?: (µm p-p|µm|mil p-p|mil|mm 0-p|mm|rpm|Hz|rad/s|1/s|%|MN/m|N/m|s\b|N\b))?", own[part]["text"]):
            if values and rounds_to(values[0] / UNITS[unit], shown):
                values.pop(0)
        assert not values, f"{values} stand in no text of {own[part]['text']!r}"


# ---------------------------------------------------------------- the other sentences


def tally(result, match):
    asked = [own for own in result.json["statements"] if "clause" in own and own["verdict"] != "none asked for"]
    assert int(match[2]) == len(asked) and int(match[1]) == sum(own["verdict"] == "holds" for own in asked)


def check_shafts(result):
    """Sections fill their shafts, add up to its mass, and a shaft with what is on it has at least its own mass."""
    sections = result.sheet("", "sections")
    for shaft in result.sheet("", "shafts"):
        own = [row for row in sections if row["shaft"] == shaft["shaft"]]
        span = max(row["to"] for row in own) - min(row["from"] for row in own)
        mass = sum(row["mass"] for row in own)
        assert abs(span / shaft["length"] - 1) < 1e-9 and abs(mass / shaft["mass"] - 1) < 1e-9, f"{span} m, {mass} kg"
        assert shaft["nodes"] == shaft["elements"] + 1 and shaft["total"] >= shaft["mass"] * (1 - 1e-9)
        assert shaft["modes"] is None or shaft["modes"] <= shaft["all_modes"]
        assert min(row["from"] for row in own) <= shaft["centre"] <= max(row["to"] for row in own)


def left_out(result, title, match):
    """Stations without a figure in that table of responses."""
    count = 0
    for table in [title] if title in result.tables() else result.tables():
        placed, clearance = (result.field(table, f"unbalance/{name}") for name in ("placed", "clearance"))
        if clearance is not None:
            probes = probed(result, table)
            count = max(count, sum(name not in probes and not np.nan_to_num(clearance[0, s]) > 0 and
                                   (placed is None or not np.any(np.nan_to_num(placed[0, s]))) for s, name in enumerate(result.stations)))
    assert int(match[1]) == count, f"{count} have none"


def conditions(result, match):
    reported = result.file["provenance"].attrs[f"{match['table']} with"]
    assert (reported.decode() if isinstance(reported, bytes) else reported) == match["what"], reported


def check_other(result, title, text):
    """Checks a sentence that is no statement; returns whether its kind is known."""
    match = re.match(r"What is asked for\. (\d+) of (\d+) hold", text)
    if match:
        tally(result, match)
        return True
    match = re.match(r"What is asked for\. Nothing: ", text)
    if match:
        return not any(own["verdict"] != "none asked for" for own in result.json["statements"] if "clause" in own)
    match = re.match(r"(\d+) other stations? without probe, clearance or unbalance", text)
    if match:
        left_out(result, title, match)
        return True
    match = re.fullmatch(r"(?P<table>\w+), with (?P<what>.*)", text)
    if match and match["table"] in result.tables():
        conditions(result, match)
        return True
    return False


def main(path, page):
    result, faults, counts = Result(path), [], {"statements": 0, "others": 0, "fixed": 0}
    markup = open(page, encoding="utf-8").read()
    texts = []
    try:
        check_shafts(result)
    except AssertionError as error:
        faults.append(f"shafts: {error}")
    for own in result.json.get("statements", []):
        try:
            shown_agrees(own)
            of_run = result.field(own["table"], "runup/force") is not None if own["table"] else False
            check = (touches if of_run else touches_motions) if own["what"] in result.contacts else line_jump if own["what"].startswith("line of order ") else None
            (check or STATEMENTS[own["what"]])(result, own)
        except KeyError as error:
            faults.append(f"{own['what']}: no check of {error}")
        except AssertionError as error:
            faults.append(f"{own['table']}: {own['what']}: {own['found']['text']!r}, {own['verdict']}: {error}")
        counts["statements"] += 1
        texts.append([own[part]["text"] for part in ("asked", "found", "judged") if own[part]["text"]])
    for title, text in sentences(markup):
        if any(all(part in text for part in parts) for parts in texts if parts) or any(
            parts and parts[0] in text and text.split(". ")[0] in result.tables() for parts in texts):
            continue
        if text == result.json["title"] or any(re.fullmatch(pattern, text) for pattern in FIXED):
            counts["fixed"] += 1
            continue
        try:
            known = check_other(result, title, text)
        except AssertionError as error:
            faults.append(f"{text!r}: {error}")
            continue
        counts["others"] += 1
        if not known:
            faults.append(f"a sentence of no kind that is known: {text!r}")
    print(", ".join(f"{count} {name}" for name, count in counts.items()))
    for fault in faults:
        print("lateral_sentences: FAILED:", fault)
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
