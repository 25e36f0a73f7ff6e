"""Whether everything in a specification fits: the core, pockets, sensors and presses."""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING

from design.pockets import Pocket, distance_of_axes_mm, pockets

if TYPE_CHECKING:
    from design.spec import ObjectSpec
    from design.spec_hardware import MagnetSpec


def require_fit(spec: ObjectSpec) -> None:
    """Raise ValueError with what does not fit, what was given and how to mend it."""
    _check_core(spec)
    _check_wire_passages(spec)
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


def _check_wire_passages(spec: ObjectSpec) -> None:
    core, smallest = spec.core, min(spec.core_size_mm)
    if core.hub_depth_mm >= core.wall_mm:
        raise ValueError(
            f"core.hub_depth_mm must be below core.wall_mm = {core.wall_mm:g}; got "
            f"{core.hub_depth_mm:g}. Make the hub recess shallower or the wall thicker"
        )
    # The cavity is the narrowest across two walls; a side hole must also clear the top wall.
    room = smallest - 2 * core.wall_mm
    widest = max(core.wire_hole_top_diameter_mm, core.wire_hole_side_diameter_mm)
    if widest >= room:
        raise ValueError(
            f"core.wire_hole_*_diameter_mm must be below the core's cavity, {room:g} mm wide; got "
            f"{widest:g}. Use a smaller hole or thinner core walls"
        )
    if 2 * core.hub_radius_mm >= smallest:
        raise ValueError(
            f"core.hub_radius_mm must be below half the core ({smallest / 2:g} mm); "
            f"got {core.hub_radius_mm:g}. Use a smaller hub recess"
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
    for index, pocket in enumerate(pockets(shell, magnets)):
        _check_sealed(spec, index, pocket)
        half = _smallest_half_extents_mm(spec)
        if (pocket.reach_mm >= half).any():
            raise ValueError(
                f"{_where(magnets, index)} puts its pocket of radius {pocket.radius_mm:g} mm outside "
                f"the shell's face (±{half[0]:g}, ±{half[1]:g} mm). Move the magnet inwards"
            )
    _check_pockets_apart(spec)
    _check_pockets_across_edges(spec)


def _where(magnets: MagnetSpec, index: int) -> str:
    x, y = magnets.positions_mm[index]
    tilt = f" with tilt_deg {list(magnets.tilt_deg[index])}" if magnets.tilt_deg else ""
    return f"magnets.positions_mm[{index}] = ({x:g}, {y:g}){tilt}"


def _check_sealed(spec: ObjectSpec, index: int, pocket: Pocket) -> None:
    """Silicone must be left between the magnet and the face, and between the pocket and the core."""
    magnets, thickness = spec.magnets, spec.shell.thickness_mm
    sine = (1 - pocket.axis[2] ** 2) ** 0.5
    rim = sine * magnets.diameter_mm / 2 + pocket.axis[2] * magnets.height_mm / 2
    depth = -pocket.centre_mm[2]
    if depth <= rim or -pocket.lowest_mm >= thickness:
        low, high = rim, thickness + depth + pocket.lowest_mm
        raise ValueError(
            f"magnets.depth_mm[{index}] = {depth:g} does not seal the magnet within the "
            f"{thickness:g} mm of silicone: at this tilt its mid-plane must lie deeper than {low:.4g} "
            f"and its pocket's floor above the core, less deep than {high:.4g} mm. Change depth_mm or "
            "tilt_deg"
        )


def _check_pockets_apart(spec: ObjectSpec) -> None:
    every = enumerate(pockets(spec.shell, spec.magnets))
    for (i, a), (j, b) in combinations(every, 2):
        distance = distance_of_axes_mm(a, b)
        if distance <= a.radius_mm + b.radius_mm:
            raise ValueError(
                f"the pockets of magnets {i} and {j} touch or overlap: axes {distance:.3g} mm apart, "
                f"more than {a.radius_mm + b.radius_mm:g} mm needed. Move one of magnets.positions_mm"
            )


def _check_pockets_across_edges(spec: ObjectSpec) -> None:
    """The boxes round the pockets of neighbouring faces must not meet at an edge."""
    every = pockets(spec.shell, spec.magnets)
    deepest = max(-pocket.lowest_mm for pocket in every)
    half_x, half_y = (half - deepest for half in _smallest_half_extents_mm(spec))
    for index, pocket in enumerate(every):
        if (pocket.reach_mm >= (half_x, half_y)).any():
            raise ValueError(
                f"{_where(spec.magnets, index)} reaches into the {deepest:.4g} mm zone of the "
                "neighbouring face's pockets: pockets of two faces could overlap. Move the magnet "
                f"inwards: its pocket must stay within ±{half_x:.4g}, ±{half_y:.4g} mm"
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
