"""Deformation in the report: compliance, a section, and how far small strain can be trusted."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from design.spec.object import ObjectSpec
from instobj.report.pages import render
from instobj.store import readers


def deformation_section(spec: ObjectSpec, inputs: dict[str, Path], protocol: dict[str, Any]) -> str:
    """HTML: section through the deformed shell, error of small strain, its correction."""
    content = readers.LARGE_STRAIN.read(inputs["large_strain"])
    corrected = content["correction"] is not None
    section = readers.SECTION.path(inputs["shapes"])
    return render(
        "deformation.html.j2",
        section=section if section.is_file() else None,
        presses=_presses(content) if corrected else [],
        text=correction_text(content) if corrected else envelope_text(spec, protocol),
    )


def envelope_text(spec: ObjectSpec, protocol: dict[str, Any]) -> str:
    """Orientation from presses of another object: error at the protocol's peaks, 5 and 20 % depths."""
    from fem.large_strain.linearity import depth_of_force_error_mm, linear_error

    thickness = spec.shell.thickness_mm
    parts = []
    for name in ("shallowest_peak_mm", "deepest_peak_mm"):
        depth = protocol[name]
        error = linear_error(depth, thickness)
        if error is None:
            parts.append(f"beyond what was measured at {depth:.2f} mm")
        else:
            size = f"force by up to {100 * error.force:.0f} %, magnet motions by {100 * error.motion:.0f} %"
            parts.append(f"{size} at {depth:.2f} mm")
    five = depth_of_force_error_mm(0.05, thickness)
    return (
        "Small-strain mechanics is off at the protocol's peaks: "
        + "; ".join(dict.fromkeys(parts))
        + f". Its force is 5 % off at {five:.1f} mm at the worst location, and less than 20 % off down to "
        f"{thickness / 2:g} mm. This is orientation: the largest of six neo-Hookean presses of the R5 "
        "hemisphere on a cube of 42 mm with a shell of 8 mm, scaled by depth over thickness. "
        'mechanics.correction = "large-strain" presses this object instead and corrects the table; '
        "instobj press shows both models for one press."
    )


def correction_text(content: dict[str, Any]) -> str:
    """Gain of the correction, every location predicted from the others."""
    gains = []
    for name, title in (("force", "force"), ("shift", "shifts"), ("rotation", "rotations")):
        error = content["error"][name]
        applied = any(content["correction"][name])
        gains.append(
            f"{title} {100 * error['uncorrected_rms']:.1f} % → {100 * error['corrected_rms']:.1f} % "
            f"(largest {100 * error['uncorrected_largest']:.0f} → {100 * error['corrected_largest']:.0f} %)"
            + ("" if applied else ", so left uncorrected")
        )
    return (
        "All presses are corrected for large deformation by a fit to these (neo-Hookean, first face, "
        "taken to hold on all). Error without and with the correction, each location predicted from the "
        "others, root mean square over depths: "
        + "; ".join(gains)
        + ". Force as a share of itself; motions of the worst magnet as a share of the press's largest."
    )


def _presses(content: dict[str, Any]) -> list[list[str]]:
    rows = []
    for row in content["presses"]:
        reached = row["status"] == "converged"
        deepest = f"{row['converged_depth_mm']:.2f} mm" + ("" if reached else ", then diverged")
        ratio = row["linear_force_n"][-1] / row["force_n"][-1]
        rows.append(
            [
                f"({row['x_mm']:g}, {row['y_mm']:g})",
                _depth(row["five_percent_mm"]),
                _depth(row["twenty_percent_mm"]),
                deepest,
                f"{ratio:.2f}",
            ]
        )
    return rows


def _depth(value_mm: float | None) -> str:
    return "not reached" if value_mm is None else f"{value_mm:.2f} mm"
