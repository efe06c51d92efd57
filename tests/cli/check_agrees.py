"""check_agrees.py WHIRL: every case that `whirl run` refuses is refused by `whirl check`, with the same sentence.

Every option of every study is set to values that no study can take, that some cannot, and that all can. `check` and
`run` must agree on each case, and a case that is called good is never refused.
"""

import os
import subprocess
import sys
import tempfile

WHIRL = os.path.abspath(sys.argv[1])
MACHINE = """whirl: 1
parameters: {omega: 3000 rpm, k: 10 MN/m, z: 0}
rotor:
  speed: = omega
  length_scale: 100 um
  materials: {steel: {modulus: 210 GPa, poisson: 0.3, density: 7850 kg/m3}}
  shafts: {main: {material: steel, modes: 2}}
  stations:
    left: {position: 0.1 m}
    disc: {position: 0.5 m, mass: 30 kg, diametral: 0.3 kg.m2, polar: 0.5 kg.m2}
    right: {position: 0.9 m}
  elements:
    - segment: {length: 1 m, outer: 60 mm, elements: 10}
    - bearing: {at: left, kxx: KXX, kyy: = k, cxx: 1 kN.s/m, cyy: 1 kN.s/m}
    - bearing: {at: right, kxx: = k, kyy: = k, cxx: 1 kN.s/m, cyy: 1 kN.s/m}
    - unbalance: {at: disc, moment: 1e-4 kg.m}
    - gravity: {}
"""
STAGE = "    - stage: {at: disc, power: 200 kW, diameter: 0.4 m, width: 20 mm, density_ratio: 1.2}\n"
OVER = "parameter: k, from: 1e6, to: 1e8, points: 3"
RUN = "speed_from: 10 rad/s, speed_to: 20 rad/s, rate: 50 rad/s2, rows: 4, stationary: 0"
BRANCH = "parameter: omega, from: 100, to: 120, points: 20, rtol: 1e-9"
NUMBERS = ["0", "-1", "2.5", "1e30"]
STATIONS = ["nowhere", "disc", "right", "[disc, left]", "[]"]
RULE = "running_to: 3000 rpm, weight: 12 kg"
# Study: its fixed keys, then keys with their values.
STUDIES = {
    "modes": (OVER, {"count": NUMBERS, "orders": NUMBERS, "line_frequency": NUMBERS, "running_to": NUMBERS}),
    "unbalance": (
        RULE,
        {"antinodes_of": ["1", "2", "7", "100", *NUMBERS], "at": STATIONS, "probes_at": STATIONS, "trip": NUMBERS},
    ),
    "critical_speeds": (OVER, {"count": NUMBERS, "bearings": ["yes", "2"]}),
    "stability": (OVER, {"density": NUMBERS}),
    "statics": (OVER, {"coupling": ["[disc, disc]", "[left, right]", *STATIONS]}),
    "runup": (
        RUN,
        {
            **dict.fromkeys("speed_from speed_to rate duration settle trip_time trip_speed".split(), NUMBERS),
            **dict.fromkeys("loss_moment loss_time loss_speed stationary change_time change_speed".split(), NUMBERS),
            **dict.fromkeys("spectra spectrum_turns highest_order slow_roll orbits waveform rtol".split(), NUMBERS),
            "loss_at": STATIONS,
            "change": ["{k: 2 MN/m}", "{q: 1}"],
            "method": ["rodas5p", "rk4"],
        },
    ),
    "response": ("", {}),
    "branch": (
        BRANCH,
        {
            **dict.fromkeys("longest switches segments points step rtol torus_nodes torus_points".split(), NUMBERS),
            "revolutions": ["2", "3", *NUMBERS],
            "at": ["[110]", "[110, 115]", "[200]", "[]"],
            "begin": ["start", "linear", "nowhere"],
            "rest": ["yes", "no"],
            "tori": ["yes"],
        },
    ),
}
# Machines whose motions diverge: at once, or after some revolutions.
FLEEING = MACHINE.replace("KXX", "-1e9")
GROWING = MACHINE.replace("KXX", "= k, kxy: 2e7, kyx: -2e7")
STOPPED = 3  # exit status of a run that --max-time ended
BESIDE = {
    "integrate": dict.fromkeys("steps_per_revolution rtol limit transient record watch".split(), NUMBERS),
    "keep": dict.fromkeys("waveform samples highest_order".split(), NUMBERS),
    "analyze": {None: ["[waveform]", "[exponents]", "[floquet]", "[]"]},
    "starts": {"count": NUMBERS},
}


def cases():
    """Yields (name, text) of all cases."""
    for study, (always, keys) in STUDIES.items():
        for key, values in [("", [""]), *keys.items()]:
            for value in values:
                kept = [part for part in always.split(", ") if part and part.split(":")[0] != key]
                options = ", ".join(kept + ([f"{key}: {value}"] if key else []))
                machine = MACHINE.replace("KXX", "= k") + (STAGE if study == "stability" else "")
                yield f"{study}: {{{options}}}", f"{machine}study:\n  {study}: {{{options}}}\n"
    for part, keys in BESIDE.items():
        for key, values in keys.items():
            for value in values:
                given = f"{part}: {{{key}: {value}}}" if key else f"{part}: {value}"
                yield given, MACHINE.replace("KXX", "= k") + f"study:\n  response: {{}}\n  {given}\n"
    for name, machine in (("flees", FLEEING), ("grows", GROWING)):
        for begin in ("settled", "start", "linear"):
            for rest in ("no", "yes"):
                given = f"branch: {{{BRANCH}, begin: {begin}, rest: {rest}}}"
                yield f"{given} of a machine that {name}", machine + f"study:\n  {given}\n"
    # Stiffness over the speed: no critical speeds all at once.
    for study in ("critical_speeds", "modes", "statics"):
        text = MACHINE.replace("KXX", "= 1e4*omega") + f"study:\n  {study}: {{}}\n"
        yield f"{study} of bearings over the speed", text


def whirl(*arguments):
    """The exit status, the output, and the last sentence of complaint without the name of the case."""
    done = subprocess.run([WHIRL, *arguments], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr.replace("whirl: case.yaml: ", "whirl: ")


def main():
    refused = good = 0
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for name, text in cases():
            with open("case.yaml", "w", encoding="utf-8") as file:
                file.write(text)
            checked, said, why = whirl("check", "case.yaml")
            # What a motion shows of a machine that diverges is refused after seconds, all else before the first motion.
            time = "9 s" if " of a machine that " in name else "1 s" if name.startswith("branch") else "0.2 s"
            for most in (time, "90 s"):
                ran, _, complaint = whirl("run", "case.yaml", "-q", "-o", "r.h5", "--threads", "1", "--max-time", most)
                for left in set(os.listdir(".")) - {"case.yaml"}:
                    os.remove(left)
                if checked != 2 or ran != STOPPED:  # otherwise a busy computer was too slow
                    break
            good += checked == 0
            refused += checked == 2
            if checked not in (0, 2) or (checked == 2) != (ran == 2):
                wrong.append(f"{name}: check ends with {checked}, run with {ran}: {why}{complaint}")
            elif checked == 2 and ": good" in said:
                wrong.append(f"{name}: is called good, and refused: {why}")
            elif checked == 2 and why.split("\n")[0] not in complaint:
                wrong.append(f"{name}: check says {why}, run {complaint}")
    assert good > 20 and refused > 20, (good, refused)
    assert not wrong, "\n".join(wrong)
    print(f"{good} cases are good and {refused} refused, by check and run alike")


main()
