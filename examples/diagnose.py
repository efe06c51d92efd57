#!/usr/bin/python3
"""Learns to tell faults of a rotor from computed records, and shows where such data mislead.

    examples/diagnose.py [FOLDER]

The records are those of cases/fault-records.yaml: eight labels, five sensors. Their features are amplitudes of orders,
forward and backward, the amplitude of whirl below the speed, and kurtosis and crest of the pedestal's vibration.
Two small classifiers of scikit-learn (Debian: python3-sklearn) learn labels from the features of some machines. They
are tested with others, in four rounds, so that every machine is tested once. The tests use:

- machines of the same kind, mild faults and severe ones;
- the second halves of the records whose first halves they were trained with: a mistake, which looks like skill;
- machines of the same kind whose sensors had no noise in training, and have noise in the test;
- machines of another kind, with a stiffer shaft and thinner oil.

The data sets are kept in FOLDER, or made in a temporary folder.
"""

import re
import sys
import tempfile
from pathlib import Path

import numpy as np

import whirl

CASE = Path(__file__).resolve().parents[1] / "cases" / "fault-records.yaml"
MACHINES = 16


def make(folder, name, machines, noise=True, **parameters):
    """Returns the data set of the case with these changes, from its file if that exists."""
    path = Path(folder) / f"{name}.h5"
    if path.exists():
        return whirl.dataset(path)
    text = CASE.read_text()
    if not noise:
        text = re.sub(r"(noise|jitter): [0-9.]+ (mV|deg)(, )?", "", text).replace(", }", "}")
    case = whirl.Case(text=text, name=CASE.name)
    case.set("dataset.machines", machines)
    for parameter, value in parameters.items():
        case.set(parameter, value)
    return whirl.dataset(case, path, progress=False)


def features(signals, per_turn):
    """Features of records [record][channel][sample]: one row each."""
    signals = signals.astype(float)
    window = np.hanning(signals.shape[2])
    centred = signals - signals.mean(2, keepdims=True)
    turns = signals.shape[2] / per_turn

    def order(spectrum, k):
        return spectrum[..., round(k * turns)]

    def below(spectrum):
        return spectrum[..., round(0.3 * turns) : round(0.6 * turns)].max(-1)

    lines = np.abs(np.fft.rfft(centred * window)) * 2 / window.sum()
    probes, pedestal = lines[:, :3], lines[:, 3]
    # The full spectrum of the left bearing's probes: positive orders turn with the shaft, negative ones against it.
    full = np.abs(np.fft.fft((centred[:, 0] + 1j * centred[:, 1]) * window)) / window.sum()
    amplitudes = [order(probes, k) for k in (1, 2, 3)] + [below(probes)]
    amplitudes += [order(full, k)[:, None] for k in (-2, -1, 1, 2)]
    amplitudes += [order(pedestal, k)[:, None] for k in range(1, 11)] + [below(pedestal)[:, None]]
    deviation = centred[:, 3].std(1)
    kurtosis = (centred[:, 3] ** 4).mean(1) / deviation**4
    crest = np.abs(centred[:, 3]).max(1) / deviation
    shape = [kurtosis[:, None], crest[:, None], signals[:, :3].mean(2)]
    return np.hstack([np.log10(np.hstack(amplitudes) + 1e-12), *shape])


def rows(data):
    return features(data.signals[:], data.samples_per_revolution)


def classifiers():
    """Two classifiers that have learnt nothing yet, by their names."""
    from sklearn.ensemble import RandomForestClassifier
    from sklearn.linear_model import LogisticRegression
    from sklearn.pipeline import make_pipeline
    from sklearn.preprocessing import StandardScaler

    return {
        "regression": make_pipeline(StandardScaler(), LogisticRegression(max_iter=5000)),
        "forest": RandomForestClassifier(n_estimators=200, random_state=1),
    }


def predicted_by_machine(name, known, tested, targets, machines):
    """Returns labels predicted for `tested` features by a classifier trained with `known` ones of other machines."""
    predicted = np.empty_like(targets)
    for part in range(4):
        test = machines % 4 == part
        predicted[test] = classifiers()[name].fit(known[~test], targets[~test]).predict(tested[test])
    return predicted


def study(folder, machines=MACHINES, others=6):
    """Returns the data set, predicted labels of its records by classifier, and accuracies by classifier and test."""
    data, quiet = make(folder, "rotor", machines), make(folder, "quiet", machines, noise=False)
    other = make(folder, "other", others, k="4.5 MN/m", oil="12 mPa s", **{"dataset.seed": 2})
    own, without_noise, of_others = rows(data), rows(quiet), rows(other)
    half = data.samples // 2
    first, second = (
        features(part, data.samples_per_revolution) for part in (data.signals[:, :, :half], data.signals[:, :, half:])
    )
    targets, machines, severity = data.targets, data.column("machine"), data.column("severity")
    taken_for, found = {}, {}
    for name, classifier in classifiers().items():
        taken_for[name] = predicted_by_machine(name, own, own, targets, machines)
        right = taken_for[name] == targets
        noisy = predicted_by_machine(name, without_noise, own, targets, machines)
        still = predicted_by_machine(name, without_noise, without_noise, targets, machines)
        found[name] = {
            "other machines of the same kind": np.mean(right),
            "  of these, severity below 0.5": np.mean(right[severity < 0.5]),
            "  of these, severity above 0.5": np.mean(right[severity > 0.5]),
            "second halves of the same records": classifier.fit(first, targets).score(second, targets),
            "trained and tested without noise": np.mean(still == targets),
            "trained without noise, tested with it": np.mean(noisy == targets),
            "machines of another kind": classifier.fit(own, targets).score(of_others, other.targets),
        }
    return data, taken_for, found


def main(folder):
    try:
        import sklearn  # noqa: F401
    except ImportError:
        sys.exit("scikit-learn is missing: 'apt install python3-sklearn' (or pip) brings it")
    data, taken_for, found = study(folder)
    print(f"{data!r}\n\nShares that are right (by chance: {1 / len(data.labels):.2f}):")
    print(f"  {'tested with':40}{''.join(f'{name:>12}' for name in found)}")
    for test in found["forest"]:
        print(f"  {test:40}{''.join(f'{own[test]:12.2f}' for own in found.values())}")
    print("\nOther machines of the same kind, by label, and what the forest takes the wrong ones for:")
    for number, label in enumerate(data.labels):
        own = taken_for["forest"][data.targets == number]
        wrong = sorted({data.labels[i] for i in own if i != number})
        print(f"  {label:12} {np.mean(own == number):.2f}  {', '.join(wrong)}")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        main(sys.argv[1])
    else:
        with tempfile.TemporaryDirectory(prefix="whirl-diagnose-") as temporary:
            main(temporary)
