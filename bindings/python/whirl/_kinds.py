"""What points are told apart by in figures, regimes or attractors, and the colours of these."""

from dataclasses import dataclass

import numpy as np

from .fields import FIELD

# Of the report and the explorer: told apart by readers of any colour vision.
REGIMES = {
    "P-1": "#366EFB",
    "P-2": "#1FBADD",
    "P-4": "#1D7257",
    "other P-k": "#664406",
    "quasi-periodic": "#CC0892",
    "chaotic": "#000000",
    "undetermined": "#9A9F95",
    "diverged": "#FB8D41",
}
# Of attractors, over and over: Okabe and Ito's colours, in an order in which neighbours differ in lightness, too.
ATTRACTORS = ("#0072B2", "#E69F00", "#56B4E9", "#009E73", "#CC79A7", "#D55E00", "#F0E442", "#000000")
_NO_ATTRACTOR = "#9A9F95"
_UNDETERMINED, _PERIODIC, _QUASI_PERIODIC, _CHAOTIC, _DIVERGED = range(5)
_OPACITY = (0.4, 0.8, 1.0)  # of low, fair and high confidence


def classes(table):
    """The class of every point's verdict, as an index into :data:`REGIMES`."""
    code, period = (np.nan_to_num(table[name]).astype(int) for name in (FIELD.REGIME_CODE, FIELD.REGIME_PERIOD))
    found = np.full(code.shape, 6)
    found[code == _QUASI_PERIODIC], found[code == _CHAOTIC], found[code == _DIVERGED] = 4, 5, 7
    periodic = code == _PERIODIC
    found[periodic] = 3
    for index, k in enumerate((1, 2, 4)):
        found[periodic & (period == k)] = index
    return found


def attractor_colour(number):
    """The colour of an attractor by its number, from 1; 0 is none."""
    return ATTRACTORS[(number - 1) % len(ATTRACTORS)] if number > 0 else _NO_ATTRACTOR


def _attractor_titles(table):
    """dict of int to str: what each attractor is called in a legend, where the starts of all places are taken
    together: "1: P-5 (31 %)" of a basin, "1" where its verdict and share change from place to place."""
    numbers = table.attractors.ravel()
    first = dict(zip(*np.unique(numbers, return_index=True)))
    titles = {}
    for number, at in sorted(first.items(), key=lambda item: item[0] or np.inf):  # 0 last
        told = table.name == "basin" and FIELD.REGIME_CODE in table
        words = f": {table.verdicts.ravel()[at]} ({100.0 * table.shares.ravel()[at]:.3g} %)" if told else ""
        titles[int(number)] = f"{number}{words}" if number > 0 else "no verdict"
    return titles


@dataclass(frozen=True)
class Kinds:
    """What points are told apart by in a figure: regimes or attractors."""

    of: np.ndarray  #: [points]
    opacity: np.ndarray  #: [points]
    shown: list  #: (kind, colour, title) of those that are there, in the order of a legend
    title: str = None


def kinds_of(table, attractors=None):
    """Those of a table, attractors where it has any unless it is said; None where there are neither."""
    if table.has_attractors if attractors is None else attractors:
        numbers = table.attractors.ravel()
        shown = [(number, attractor_colour(number), title) for number, title in _attractor_titles(table).items()]
        return Kinds(numbers, np.ones(len(numbers)), shown, "attractor")
    if FIELD.REGIME_CODE not in table:
        return None
    kinds, confidence = classes(table).ravel(), np.nan_to_num(table[FIELD.REGIME_CONFIDENCE]).ravel().astype(int)
    shown = [(kind, list(REGIMES.values())[kind], list(REGIMES)[kind]) for kind in np.unique(kinds)]
    return Kinds(kinds, np.take(_OPACITY, confidence), shown)


def points_once(table):
    """Points to be drawn: all, but of several starts of a place the first that leads to each attractor."""
    if not table.has_attractors or table.name == "basin":
        return np.arange(int(np.prod(table.shape)))
    number = table.attractors
    pairs = np.column_stack([table.place, np.where(number > 0, number, -1 - np.arange(len(number)))])
    return np.sort(np.unique(pairs, axis=0, return_index=True)[1])
