"""Phases of a run on a press rig, and which may follow which."""

from __future__ import annotations

from enum import Enum


class Phase(Enum):
    """Phase of a run: it decides what the machine may do."""

    OFF = "nothing has moved"
    HOMING = "looks for its limit switches, upwards first"
    ABOVE = "moves at the safe height, nowhere lower"
    SEEKING = "goes down to find the surface"
    NEARING = "goes down to above the surface, where no chip may see a contact"
    PRESSING = "presses"
    STOPPING = "stops and lifts the tip; nothing but its own line is heard"
    LOST = "its position means nothing: no move is sent"


DOWNWARD = (Phase.SEEKING, Phase.NEARING, Phase.PRESSING)
"""Phases in which the tip may touch the object, so that both witnesses of contact are asked."""
_FOLLOWING = {
    Phase.OFF: {Phase.HOMING},
    Phase.HOMING: {Phase.ABOVE, Phase.LOST},
    Phase.ABOVE: {Phase.SEEKING, Phase.NEARING, Phase.PRESSING, Phase.STOPPING, Phase.LOST},
    Phase.SEEKING: {Phase.ABOVE, Phase.STOPPING, Phase.LOST},
    Phase.NEARING: {Phase.PRESSING, Phase.STOPPING, Phase.LOST},
    Phase.PRESSING: {Phase.ABOVE, Phase.STOPPING, Phase.LOST},
    Phase.STOPPING: {Phase.ABOVE, Phase.LOST},
    Phase.LOST: {Phase.HOMING},
}


def require_following(now: Phase, then: Phase) -> None:
    """Hold the program to the table: a press begins above the object, and after a lost position comes
    homing."""
    if then is not now and then not in _FOLLOWING[now]:
        raise AssertionError(f"{then} does not follow {now}")
