"""What engineers read in the figures of a lateral analysis:  lateral_figures.py"""

import json
import math


def figure(name):
    with open(name + ".json") as file:
        return json.load(file)


def panels(name):
    return {panel["name"]: panel for panel in figure(name)["panels"]}


def series(panel, shape):
    return [one for one in panel["series"] if one["shape"] == shape]


def texts(panel):
    return [text for one in series(panel, "texts") for text in one.get("texts", [])]


bode = panels("bode")
print("columns", *(bode["lag"]["box"][i] == bode["amplitude"]["box"][i] for i in (0, 1)))
print("legend", *[one["name"] for one in bode["amplitude"]["series"] if one["name"]], bode["amplitude"]["legend_inside"])
polar = bode["polar"]
print("lags", *[text for text in texts(polar) if text.endswith("\u00b0")])
print("middle", polar["x"]["low"] == -polar["x"]["high"], polar["y"]["low"] == -polar["y"]["high"])

# A mark of the first probe at a round speed stands where amplitude and lag of the other panels put it.
amplitude, lag = series(bode["amplitude"], "line")[0], series(bode["lag"], "dots")[0]
marks = series(polar, "dots")[0]
worst = 0.0
for x, y in zip(marks["x"], marks["y"]):
    places = [(a * math.cos(math.radians(d)), -a * math.sin(math.radians(d))) for a, d in zip(amplitude["y"], lag["y"])]
    worst = max(worst, min(math.hypot(x - one[0], y - one[1]) for one in places))
print("marks", len(marks["x"]) >= 4, worst < 1e-6 * max(amplitude["y"]))

chart = panels("map")["speeds"]
band = series(chart, "boxes")[0]
print("running", band["name"], round(band["y"][0]), round(band["y_to"][0]))
print("names", *texts(chart))

curve = panels("stability")["decrement"]
lines = {one["name"]: one for one in series(curve, "line")}
least, limit = lines["least of forward modes"], lines["limit"]["x"][0]
print("crossing", 0 in least["y"] and least["x"][least["y"].index(0)] == limit)
print("screening", *texts(panels("screening")["ratio"]))
