"""Studies of tolerances: effects of the deviations that a drawing allows."""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterable, Mapping
from typing import Any

from .case import Case
from .errors import BadInput
from .result import Result
from .running import run

__all__ = ["tolerances"]


def tolerances(
    case: Case | str | os.PathLike,
    parameters: Mapping[str, Any],
    of: Iterable[Mapping[str, Any]] | None = None,
    *,
    samples: int = 1024,
    seed: int = 1,
    indices: bool = False,
    **options: Any,
) -> Result:
    """Runs a case with tolerances: every point of its study, and each of them at samples of the parameters.

    Parameters
    ----------
    case : Case, str or path
        A case that has no tolerances yet.
    parameters : dict
        Names of parameters with their tolerances as a case has them: ``{"c": "0.2 mm +- 5 %", "d": "40 mm H7"}``, or
        the keys of a distribution, ``{"k": {"distribution": "normal", "deviation": "0.05 MN/m"}}``.
    of : list of dict, optional
        Numbers of every point with their limits: ``[{"field": "orbit/max_radius", "at": "disc", "below": "0.15 mm"}]``.
    samples, seed, indices
        As the keys of ``tolerances`` in a case.
    **options
        Options of :func:`whirl.run`.

    Returns
    -------
    Result
        Its table "tolerances" has the samples; its sheets "probabilities", "spread-1", "indices" and "convergence" have
        the findings (``result.sheet("indices").to_pandas()``); :meth:`Result.spread` computes statistics of any other
        number.
    """
    own = case if isinstance(case, Case) else Case(case)
    keys: dict[str, Any] = {"parameters": dict(parameters), "samples": int(samples), "seed": int(seed)}
    if indices:
        keys["indices"] = "yes"
    if of is not None:
        keys["of"] = [dict(one) for one in of]
    return run(Case(text=_with_tolerances(own.text, keys), name=own.name), **options)


def _with_tolerances(text: str, keys: Mapping[str, Any]) -> str:
    """Returns the text of a case with tolerances below `study:`."""
    lines = text.splitlines()
    starts = [i for i, line in enumerate(lines) if re.match(r"study\s*:\s*(#.*)?$", line)]
    inside = lines[starts[0] + 1 :] if starts else []
    first = next((line for line in inside if line.strip() and not line.lstrip().startswith("#")), "")
    indent = first[: len(first) - len(first.lstrip())]
    if not indent:
        raise BadInput("the case has no study on lines of its own below 'study:', to which tolerances could be added")
    if any(re.match(re.escape(indent) + r"tolerances\s*:", line) for line in inside):
        raise BadInput("the case has tolerances of its own: run it as it is, by whirl.run")
    lines.insert(starts[0] + 1, f"{indent}tolerances: {json.dumps(keys, ensure_ascii=False)}")
    return "\n".join(lines) + "\n"
