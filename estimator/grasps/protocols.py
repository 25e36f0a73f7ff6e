"""Measures of a grasp by name with unit, definition and source, and the protocols that use them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

OWN = "instobj"
_RAM = "Falco et al., Grasping the performance, IEEE Robotics & Automation Magazine 22(4), 2015"
_SP1227 = "NIST SP 1227 (draft, 2018) names it; its clause could not be read"
_ASTM = "ASTM WK83863, scope (the draft's clauses could not be read)"


@dataclass(frozen=True)
class Measure:
    """One figure of a grasp.

    `better` says which way is better when grippers are ranked; None where neither is.
    """

    title: str
    unit: str
    definition: str
    source: str = OWN
    better: Literal["lower", "higher"] | None = None


MEASURES: dict[str, Measure] = {
    "peak_n": Measure(
        "peak force", "N", "largest sum of all normal forces in the grasp; noise raises it", OWN, "lower"
    ),
    "mean_n": Measure("mean force held", "N", "mean sum of the normal forces in the hold", OWN, "lower"),
    "finger_n": Measure(
        "finger strength", "N", "largest force on one face in the grasp", f"{_SP1227}; {_RAM}", "higher"
    ),
    "grasp_n": Measure(
        "grasp strength", "N",
        "largest force transmitted through the object: the mean of both sides' forces along the "
        "grasp's axis", f"maximum force imposed on an object: {_ASTM}; {_SP1227}", "higher",
    ),
    "loading_n_per_s": Measure(
        "loading rate", "N/s", "steepest rise of the total force while closing", OWN, "lower"
    ),
    "asymmetry": Measure(
        "asymmetry of the jaws", "1", "(F₊ − F₋)/(F₊ + F₋) of both sides' forces in the hold", OWN
    ),
    "net_force_n": Measure("net force", "N", "size of the sum of all contact forces in the hold", OWN),
    "net_moment_nmm": Measure(
        "net moment", "N mm", "size of the sum of moments about the object's centre in the hold", OWN
    ),
    "equilibrium_p": Measure(
        "equilibrium", "1",
        "chance of a net force as large if the contacts and the weight balanced (χ²)", OWN,
    ),
    "friction_used": Measure(
        "friction used", "1", "largest ratio of tangential to normal force in the hold", OWN, "lower"
    ),
    "friction_needed": Measure(
        "friction needed", "1", "least friction with which the contacts close the grasp",
        "Nguyen, IJRR 7(3), 1988", "lower",
    ),
    "closed": Measure(
        "force closure", "1", "chance that the grasp is closed at the friction assumed",
        "Ferrari & Canny, ICRA 1992", "higher",
    ),
    "epsilon": Measure(
        "ε", "1", "largest wrench resisted in every direction, unit contact forces",
        "Ferrari & Canny, ICRA 1992", "higher",
    ),
    "volume": Measure(
        "volume of the wrench space", "1", "volume of the hull of contact wrenches, unit contact forces",
        "Li & Sastry, IEEE J. Robotics Automation 4, 1988", "higher",
    ),
    "hold_s": Measure("hold", "s", "time from the first to the last frame above 90 % of the level", OWN),
    "creep": Measure(
        "creep of the force", "1/decade", "change of the held force per tenfold time, over its mean", OWN
    ),
    "unsteadiness": Measure(
        "unsteadiness", "1", "rms deviation of the held force from its mean, over the mean",
        "instobj; the performance of fingertip force tracking: " + _RAM, "lower",
    ),
    "slip_mm": Measure(
        "contact slip", "mm", "largest way of a face's centre of force during the hold", OWN, "lower"
    ),
    "slip_onset_s": Measure(
        "onset of slip", "s", "time from the start of the hold until a contact has slipped", OWN
    ),
    "slip_n": Measure(
        "force held before slip", "N", "mean total force in the hold up to the onset of slip",
        f"slip resistance: {_SP1227}; definition: {OWN}", "lower",
    ),
    "regrasps": Measure(
        "regrasps", "1", "times that the force fell below half of its level and came back", OWN, "lower"
    ),
    "energy_mj": Measure(
        "energy put in", "mJ", "work on the silicone up to the peak by Hertz: an upper bound", OWN, "lower"
    ),
    "unexplained": Measure(
        "frames not trusted", "1", "share of frames that the estimator cannot explain", OWN
    ),
}  # fmt: skip


@dataclass(frozen=True)
class Protocol:
    """Measures that a protocol ranks by and shows.

    Attributes
    ----------
    headline : measure that grippers are ranked by
    measures : shown in the grasps' table
    definition : what is done and computed
    pinch : only grasps between two opposite sides count
    """

    headline: str
    measures: tuple[str, ...]
    definition: str
    pinch: bool = False


PROTOCOLS: dict[str, Protocol] = {
    "handling": Protocol(
        "peak_n",
        ("peak_n", "mean_n", "loading_n_per_s", "asymmetry", "friction_needed", "epsilon", "slip_mm",
         "regrasps"),
        "take, hold and release the object; the gentler gripper has the lower peak force",
    ),
    "grasp-strength": Protocol(
        "grasp_n", ("grasp_n", "finger_n", "peak_n", "asymmetry", "hold_s"),
        "close with full effort; the object takes the place of the split cylinder, softer and of its "
        "own shape, so that figures compare grippers on it, not with the standard's",
    ),
    "pinch": Protocol(
        "grasp_n", ("grasp_n", "finger_n", "asymmetry", "friction_needed", "epsilon", "hold_s"),
        "as grasp-strength, of grasps between two opposite sides alone (ASTM names pinch and wrap)",
        pinch=True,
    ),
    "slip": Protocol(
        "slip_mm", ("slip_mm", "slip_onset_s", "slip_n", "friction_used", "friction_needed", "mean_n"),
        "pull at the held object; contacts that move on its surface slip",
    ),
    "force-tracking": Protocol(
        "unsteadiness", ("unsteadiness", "creep", "mean_n", "loading_n_per_s", "hold_s"),
        "hold a constant force; the commanded force is not in a recording, so that the deviation is from "
        "the grasp's own mean, not from the command",
    ),
}  # fmt: skip
"""Protocols by name. Touch sensitivity, force calibration, grasp efficiency and hand stiffness of NIST SP
1227 need the hand's own signals, and are not computed."""
