"""Measures of a grasp by name with unit, definition and source, and the protocols that use them."""

from __future__ import annotations

from dataclasses import dataclass

OWN = "instobj"
_RAM = "Falco et al., Grasping the performance, IEEE Robotics & Automation Magazine 22(4), 2015"
_SP1227 = "NIST SP 1227 (draft, 2018) names it; its clause could not be read"
_LESS, _MORE = "lower", "higher"
_CANNY = "Ferrari & Canny, ICRA 1992"
_ASTM = "ASTM WK83863, scope (the draft's clauses could not be read)"


@dataclass(frozen=True)
class Measure:
    """One figure of a grasp.

    `better` says which way is better when grippers are ranked; "lower", "higher", or empty.
    """

    title: str
    unit: str
    definition: str
    source: str = OWN
    better: str = ""


_ROWS: tuple[tuple[str, ...], ...] = (
    ("peak_n", "peak force", "N", "largest sum of all normal forces, averaged where steady", OWN, _LESS),
    ("mean_n", "mean force held", "N", "mean sum of the normal forces in the hold", OWN, _LESS),
    ("finger_n", "finger strength", "N", "largest force on one face", f"{_SP1227}; {_RAM}", _MORE),
    ("grasp_n", "grasp strength", "N", "largest force through the object: mean of both sides' forces along "
     "the grasp's axis at the peak", f"maximum force imposed on an object: {_ASTM}; {_SP1227}", _MORE),
    ("loading_n_per_s", "loading rate", "N/s", "steepest rise of the total force in closing", OWN, _LESS),
    ("asymmetry", "asymmetry of the jaws", "1", "(F₊ − F₋)/(F₊ + F₋) of both sides in the hold"),
    ("net_force_n", "net force", "N", "size of the sum of all contact forces in the hold"),
    ("net_moment_nmm", "net moment", "N mm", "size of their moment about the object's centre"),
    ("equilibrium_p", "equilibrium", "1", "chance of a net force as large if contacts and weight balanced "
     "(χ²); the weight's direction and what acceleration adds by the IMU, or the best direction"),
    ("friction_used", "friction used", "1", "largest tangential over normal force in the hold", OWN, _LESS),
    ("friction_needed", "friction needed", "1", "least friction with which the contacts close the grasp",
     "Nguyen, IJRR 7(3), 1988", _LESS),
    ("closed", "force closure", "1", "1 where the grasp is closed at the friction assumed", _CANNY, _MORE),
    ("epsilon", "ε", "1", "largest wrench resisted in every direction, unit contact forces", _CANNY, _MORE),
    ("volume", "volume of the wrench space", "1", "of the hull of contact wrenches, unit contact forces",
     "Li & Sastry, IEEE J. Robotics Automation 4, 1988", _MORE),
    ("hold_s", "hold", "s", "time from the first to the last frame above 90 % of the level"),
    ("creep", "creep of the force", "1/decade", "change of the held force per tenfold time, over its mean"),
    ("unsteadiness", "unsteadiness", "1", "rms deviation of the held force from its mean, over the mean",
     f"{OWN}; the performance of fingertip force tracking: {_RAM}", _LESS),
    ("slip_mm", "contact slip", "mm", "largest way of a face's centre of force in the hold", OWN, _LESS),
    ("slip_onset_s", "onset of slip", "s", "time from the start of the hold until a contact slips"),
    ("slip_n", "force held before slip", "N", "mean total force of the hold up to the onset of slip",
     f"slip resistance: {_SP1227}; definition: {OWN}"),
    ("regrasps", "regrasps", "1", "times that the force fell below half its level and came back", OWN, _LESS),
    ("jolt_m_s2", "hardest jolt", "m/s²", "largest specific force beyond gravity in the grasp, by the "
     "object's IMU", OWN, _LESS),
    ("pressure_mpa", "pressure on the skin", "MPa", "largest mean pressure of a contact on the silicone at "
     "the peak, by the presses that the estimator's file holds, else by Hertz", OWN, _LESS),
    ("depth_mm", "indentation", "mm", "depth of the deepest contact at the peak, likewise", OWN, _LESS),
    ("energy_mj", "energy put in", "mJ", "work on the silicone up to the peak, likewise", OWN, _LESS),
    ("unexplained", "frames not trusted", "1", "share of frames that the estimator cannot explain"),
)  # fmt: skip
"""Name, title, unit, definition, source and better way of every measure."""
MEASURES = {name: Measure(*row) for name, *row in _ROWS}
"""Measures by name, as in grasps.csv."""


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
