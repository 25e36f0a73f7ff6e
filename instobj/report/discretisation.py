"""What the report and the command line say of the estimated discretisation error."""

from __future__ import annotations

from typing import Any

HEADER = ["depth, mm", "force, rms", "force, largest", "motions, rms", "motions, largest"]
_FIGURES = ("force_rms", "force_worst", "motion_rms", "motion_worst")


def error_text(content: dict[str, Any]) -> str:
    """E.g. "force ±1.2 %, motions ±0.8 % at 2 mm" (root mean square), at half the deepest press."""
    steps = content["steps"]
    middle = steps[-1]["depth_mm"] / 2
    step = min(steps, key=lambda step: abs(step["depth_mm"] - middle))
    if step["force_rms"] is None:
        return f"not known at {step['depth_mm']:g} mm: a coarser mesh misses the contact"
    return (
        f"force ±{_percent(step['force_rms'])}, motions ±{_percent(step['motion_rms'])} "
        f"at {step['depth_mm']:g} mm"
    )


def error_rows(content: dict[str, Any]) -> list[list[str]]:
    """A row of `HEADER` for every depth."""
    return [
        [
            f"{step['depth_mm']:g}",
            *("–" if step[n] is None else _percent(step[n]) for n in _FIGURES),
        ]
        for step in content["steps"]
    ]


def error_note(content: dict[str, Any]) -> str:
    """How the figures were obtained."""
    return (
        f"Discretisation error, estimated from the same {content['presses']} presses on a mesh with "
        f"edges 1.5 times as long ({content['coarse_unknowns']} unknowns): "
        f"{100 * content['share_of_difference']:.0f} % of the difference, as for an error of second "
        "order. Motions are those of all magnets per newton. A patch load's compliance at a face's "
        f"centre: ±{_percent(content['patch_compliance'])} at most. A dash: the tip misses the coarser "
        "mesh's vertices."
    )


def summary_of(content: dict[str, Any]) -> dict[str, Any]:
    """What the command line prints."""
    return {
        "estimate": error_text(content),
        "patch compliance ±%": 100 * content["patch_compliance"],
        "coarse unknowns": content["coarse_unknowns"],
    }


def _percent(share: float) -> str:
    return f"{100 * share:.1f} %"
