"""In which units figures show numbers: those of reports, which libwhirl chooses and result files tell."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Shown:
    """Units of parameters, lengths and amplitudes, and how axes call them."""

    parameters: dict  #: of every parameter its unit and the size of that in SI
    length: float  #: times lengths in the scale of the case
    length_unit: str
    length_over: bool  #: lengths stand over that unit, the symbol of a length: "x / c"
    amplitude: float  #: times amplitudes from zero to peak
    amplitude_unit: str  #: "p-p", "0-p" where nobody asked

    def size(self, name):
        """What the unit of a parameter is in SI."""
        return self.parameters.get(name, ("", 1.0))[1]

    def unit(self, name):
        """The unit of a parameter, "" of plain numbers."""
        return self.parameters.get(name, ("", 1.0))[0]

    def value(self, name, value):
        """ "omega = 600 rpm" """
        return f"{name} = {value / self.size(name):.6g} {self.unit(name)}".strip()

    def lengths(self, table, scale):
        """What lengths of every point of the table are multiplied by, where ``scale`` is that of the case."""
        own = 1.0 if self.length_over else table.length_scale.ravel() / scale
        return np.broadcast_to(self.length * own, table.values.size)

    def parameter_label(self, name):
        return f"{name} ({self.unit(name)})" if self.unit(name) else name or "point"

    def counting(self, meaning="0-p amplitude"):
        """How lengths of a field of that meaning are counted, "" of places, and what they are multiplied by."""
        if "0-p amplitude" in meaning:
            return self.amplitude_unit, self.amplitude
        return ("0-p" if "0-p" in meaning else ""), 1.0

    def length_label(self, what, counted=""):
        if self.length_over:
            return f"{what} / {self.length_unit}" + (f" ({counted})" if counted else "")
        return f"{what} ({self.length_unit}{' ' if counted else ''}{counted})"
