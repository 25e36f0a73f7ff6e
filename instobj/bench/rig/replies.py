"""Replies of machines, whatever their dialect, and the room in which they may move."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Done:
    """`ok`: the oldest line that was not answered is."""


@dataclass(frozen=True)
class Refused:
    """The oldest line that was not answered was not carried out."""

    why: str


@dataclass(frozen=True)
class Alarm:
    """The machine stopped by itself; `keeps_position`: it still knows where it is."""

    why: str
    keeps_position: bool = False


@dataclass(frozen=True)
class Greeting:
    """Said after every reset; `restarted` where nobody can have asked for it."""

    restarted: bool = False


@dataclass(frozen=True)
class Setting:
    """One of the machine's settings."""

    name: str
    value: float


@dataclass(frozen=True)
class State:
    """State of the machine, and where its tool is in the machine's frame (mm)."""

    name: str
    detail: int | None
    position_mm: tuple[float, float, float]

    @property
    def held(self) -> bool:
        """Return whether a feed hold has come to its end."""
        return self.name == "Hold" and self.detail == 0


Reply = Done | Refused | Alarm | Greeting | Setting | State


@dataclass(frozen=True)
class Travel:
    """Ends of X, Y and Z in the machine's frame (mm, Z upwards), and its Z after homing."""

    low_mm: tuple[float, ...]
    high_mm: tuple[float, ...]
    top_mm: float
