"""Whether everything in a specification fits: the core, pockets, sensors and presses."""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from design.spec import ObjectSpec


def require_fit(spec: ObjectSpec) -> None:
    """Raise ValueError with what does not fit, what was given and how to mend it."""
    _check_core(spec)
    _check_pockets(spec)
    _check_sensors(spec)
    _check_presses(spec)


def _smallest_half_extents_mm(spec: ObjectSpec) -> tuple[float, float]:
    """Half extents (x, y) that every sensed face of the body offers, in the face's own axes."""
    sx, sy, sz = (edge / 2 for edge in spec.body.size_mm)
    return min(sx, sz), min(sx, sy)


def _check_core(spec: ObjectSpec) -> None:
    smallest = min(spec.core_size_mm)
    if smallest <= 2 * spec.core.wall_mm:
        raise ValueError(
            f"the core must be larger than two core walls ({2 * spec.core.wall_mm:g} mm); got a core "
            f"of {smallest:g} mm. Make the body larger, or shell.thickness_mm or core.wall_mm smaller"
        )
    if spec.core.recess_depth_mm >= spec.core.wall_mm:
        raise ValueError(
            f"core.recess_depth_mm must be below core.wall_mm = {spec.core.wall_mm:g}; got "
            f"{spec.core.recess_depth_mm:g}. Make the recess shallower or the wall thicker"
        )
    if not spec.core.recess_inner_radius_mm < spec.core.recess_outer_radius_mm < smallest / 2:
        raise ValueError(
            "core recesses must satisfy recess_inner_radius_mm < recess_outer_radius_mm < half the "
            f"core ({smallest / 2:g} mm); got {spec.core.recess_inner_radius_mm:g} and "
            f"{spec.core.recess_outer_radius_mm:g}. Move the recess inwards"
        )


def _check_pockets(spec: ObjectSpec) -> None:
    shell, magnets = spec.shell, spec.magnets
    if shell.pocket_depth_mm >= shell.thickness_mm:
        raise ValueError(
            f"shell.pocket_depth_mm must be below shell.thickness_mm = {shell.thickness_mm:g}; got "
            f"{shell.pocket_depth_mm:g}. Make the pocket shallower or the shell thicker"
        )
    if magnets.height_mm >= shell.pocket_depth_mm or magnets.diameter_mm > shell.pocket_diameter_mm:
        raise ValueError(
            f"a magnet of {magnets.diameter_mm:g} × {magnets.height_mm:g} mm must fit below the seal in "
            f"a pocket of {shell.pocket_diameter_mm:g} × {shell.pocket_depth_mm:g} mm; it does not. "
            "Choose a smaller magnet or a larger pocket"
        )
    radius = shell.pocket_diameter_mm / 2
    half_x, half_y = _smallest_half_extents_mm(spec)
    for index, (x, y) in enumerate(magnets.positions_mm):
        if abs(x) + radius >= half_x or abs(y) + radius >= half_y:
            raise ValueError(
                f"magnets.positions_mm[{index}] = ({x:g}, {y:g}) puts a pocket of radius {radius:g} mm "
                f"outside the shell's face (±{half_x:g}, ±{half_y:g} mm). Move the magnet inwards"
            )
    for (i, a), (j, b) in combinations(enumerate(magnets.positions_mm), 2):
        distance = ((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2) ** 0.5
        if distance < 2 * radius:
            raise ValueError(
                f"the pockets of magnets {i} and {j} overlap: centres {distance:.3g} mm apart, at "
                f"least {2 * radius:g} mm needed. Move one of magnets.positions_mm"
            )
    _check_pockets_across_edges(spec)


def _check_pockets_across_edges(spec: ObjectSpec) -> None:
    """Pockets of neighbouring faces are Ø×depth cylinders whose boxes must not meet at an edge."""
    radius, depth = spec.shell.pocket_diameter_mm / 2, spec.shell.pocket_depth_mm
    half_x, half_y = _smallest_half_extents_mm(spec)
    for index, (x, y) in enumerate(spec.magnets.positions_mm):
        if abs(x) + radius > half_x - depth or abs(y) + radius > half_y - depth:
            raise ValueError(
                f"magnets.positions_mm[{index}] = ({x:g}, {y:g}) reaches into the {depth:g} mm zone of "
                "the neighbouring face's pockets: pockets of two faces could overlap. Move the magnet "
                f"to within ±{half_x - depth - radius:g}, ±{half_y - depth - radius:g} mm"
            )


def _check_sensors(spec: ObjectSpec) -> None:
    sensors, core = spec.sensors, spec.core
    half = min(spec.core_size_mm) / 2
    if sensors.radius_mm >= half:
        raise ValueError(
            f"sensors.radius_mm puts the sensors outside the core: it must be below {half:g} (half "
            f"the core's edge); got {sensors.radius_mm:g}. Choose a smaller radius"
        )
    if sensors.depth_below_core_face_mm > core.recess_depth_mm:
        raise ValueError(
            f"sensors.depth_below_core_face_mm must not exceed core.recess_depth_mm = "
            f"{core.recess_depth_mm:g}; got {sensors.depth_below_core_face_mm:g}. Deepen the recess"
        )
    if not core.recess_inner_radius_mm <= sensors.radius_mm <= core.recess_outer_radius_mm:
        raise ValueError(
            f"sensors.radius_mm must lie in the core's recess ({core.recess_inner_radius_mm:g} to "
            f"{core.recess_outer_radius_mm:g} mm); got {sensors.radius_mm:g}. Move the sensor or the recess"
        )


def _check_presses(spec: ObjectSpec) -> None:
    grid = spec.contact_grid
    half = _smallest_half_extents_mm(spec)
    for axis, (count, limit) in enumerate(zip(grid.count, half, strict=True)):
        reach = count * grid.pitch_mm / 2 + spec.indenter.radius_mm
        if reach > limit:
            raise ValueError(
                f"contact_grid.count[{axis}] × pitch_mm, half a pitch of margin and the indenter need "
                f"{2 * reach:g} mm on a face of {2 * limit:g} mm. Use fewer places, a smaller pitch or "
                "a smaller indenter.radius_mm"
            )
    deepest = spec.press.depths_mm[-1]
    if deepest > 0.6 * spec.shell.thickness_mm:
        raise ValueError(
            f"press.depths_mm must stay below 60 % of shell.thickness_mm (linear mechanics); got "
            f"{deepest:g} of {spec.shell.thickness_mm:g} mm. Press less deep or thicken the shell"
        )
    if deepest >= spec.indenter.radius_mm:
        raise ValueError(
            f"press.depths_mm must stay below indenter.radius_mm = {spec.indenter.radius_mm:g}; got "
            f"{deepest:g}. Press less deep or use a larger hemisphere"
        )
