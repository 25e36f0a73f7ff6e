"""Condition of an object as its readings show it: fine, or what is to be done before they are believed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

CONDITIONS = ("fine", "zero again", "recalibrate", "recast")
"""From the least to the most work."""
DISTRUST_FROM = 0.2
"""Share of frames without explanation from which a warning is due."""
_MOST_SHOWN = 6
"""Names in a sentence, at most."""


@dataclass(frozen=True)
class Condition:
    """One of `CONDITIONS`, and why; `why` may be empty where all is fine."""

    name: str
    why: str = ""

    def __str__(self) -> str:
        """Return the condition and why, as sentences of reports have it."""
        return f"{self.name}: {self.why}" if self.why else self.name


FINE = Condition("fine")


def object_condition(
    unexplained: float,
    beside_magnet: float = 0.0,
    slip_mm: float = 0.0,
    chips_out: Sequence[str] = (),
    drifting: Sequence[str] = (),
) -> Condition:
    """Return the condition of a whole object, the one that asks for the most work.

    Parameters
    ----------
    unexplained : share of the last frames that nothing explains
    beside_magnet : share of them that a magnet or steel near by explains better than contacts
    slip_mm : slip of the core, 0 where none is known
    chips_out : chips whose readings are not believed
    drifting : channels whose rest has drifted since the zero beyond what the specification says
    """
    if len(chips_out) > 1:
        return Condition(
            "recast",
            f"{_names(chips_out)} give no readings to believe: take magnets away and check their wires; if "
            "that does not help, replace the chips",
        )
    if slip_mm:
        return Condition(
            "recalibrate",
            f"the core slipped by about {slip_mm:.2f} mm: calibrate again. Until then readings go on without "
            "what that adds at rest, and places are off by about as much",
        )
    if unexplained > DISTRUST_FROM:
        share = f"{100 * unexplained:.0f} % of the last frames"
        if 2 * beside_magnet > unexplained:
            return Condition(
                "zero again",
                f"{share} show a magnet or steel near by: take it away, or zero again where it stays",
            )
        return Condition(
            "recalibrate",
            f"nothing that the estimator knows explains {share}: zero again; where that does not help, "
            "calibrate on presses of this object",
        )
    if drifting:
        return Condition("zero again", f"rest has drifted in {_names(drifting)}")
    reading_on = f"read without {chips_out[0]}: check its wires" if chips_out else ""
    return Condition("fine", reading_on)


def _names(names: Sequence[str]) -> str:
    if len(names) > _MOST_SHOWN:
        return f"{', '.join(names[: _MOST_SHOWN - 1])} and {len(names) - _MOST_SHOWN + 1} more"
    return " and ".join(filter(None, (", ".join(names[:-1]), names[-1])))
