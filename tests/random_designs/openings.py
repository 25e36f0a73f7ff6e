"""Ways that must be open, silicone that must be there, and a mould that leaves nothing over.

Bodies are made of the specification's numbers, as in the judge; parts are those of the build.
"""

from __future__ import annotations

from itertools import combinations

import manifold3d
import numpy as np
import trimesh
from jaxtyping import Float
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from design.body.meshes import manifold_of
from design.body.surface_chart import FACE_AXES
from design.layout.blocks import relief_slits
from design.layout.boards import wire_channels, wire_hole_diameter_mm
from design.layout.body import body_of, face_frames
from design.layout.core_hold import FLAT_SHARE, core_outlet
from design.layout.mould.frame import mould_frame, mould_style
from design.layout.mould.pins import Pin, loose_pins, pins_of_kinds
from design.layout.mould.pouring import Hole
from design.layout.places.positions import board_places, cover_mm
from design.layout.pockets import shell_pockets
from design.mould.openings import mould_holes, seal_holes
from design.mould.room import core_outside
from design.solids.booleans import convert_to_triangles
from design.spec.object import ObjectSpec

Solids = dict[str, manifold3d.Manifold]
_SKIN_MM = 0.05
"""By which ways are drawn in, and a film of silicone where there should be none may be thick."""
_FACET_MM = 0.1
"""By which triangles of narrow holes lie within them."""
_TOLD_MM = 0.05
"""By which the silicone over a magnet may be thinner than checks tell."""
_FACE_COSINE = 0.5
"""Patches end where the surface is 60° steep."""
_POUR_MM = 2.8
_STRAY_MM3 = 0.5
_FIRST = ("mould_box", "mould_half_a", "mould_half_b", "mould_plug", "mould_holder")
_SEAL = ("mould_seal_half_a", "mould_seal_half_b", "mould_holder")


def placed_pins(spec: ObjectSpec, parts: dict[str, trimesh.Trimesh]) -> Solids:
    """Every loose pin where it stands; parts hold the first of each kind."""
    if mould_style(spec) != "split" or "mould_half_a" not in parts:
        return {}
    pins, found = loose_pins(spec), Solids()
    for name, members in pins_of_kinds(pins):
        home = np.linalg.inv(_pose(pins[members[0]]))
        for index in members:
            moved = parts[name].copy().apply_transform(_pose(pins[index]) @ home)
            found[f"pin {index + 1}"] = manifold_of(moved)
    return found


def _pose(pin: Pin) -> Float[np.ndarray, "4 4"]:
    """Of a pin's pocket in the object's frame."""
    body, pose = pin.pocket.body, np.eye(4)
    pose[:3, :3] = pin.frame.axes @ body.frame
    pose[:3, 3] = pin.frame.to_object(np.append(body.centre_mm[:2], 0.0))
    return pose


def thin_covers(spec: ObjectSpec, outer: trimesh.Trimesh) -> list[str]:
    """Magnets and boards in the silicone with less of it over them, anywhere, than checks tell, or
    beside them, towards another side of the body, than `silicone.thinnest_wall_mm`."""
    wrong, surface = [], manifold_of(outer)
    reach = 2 * max(spec.body.size_mm)
    for frame, pockets in zip(face_frames(spec), shell_pockets(spec), strict=True):
        for pocket in pockets:
            body = pocket.body
            normal = frame.axes_at(body.centre_mm[:2])[:, 2]
            axes = frame.axes_at(body.centre_mm[:2]) @ body.frame
            top = frame.to_object(body.centre_mm) + axes[:, 2] * body.height_mm / 2
            flat = body.outline.corners_mm(24) if body.outline.round else body.outline.corners_mm(4)
            disk = np.concatenate([share * flat for share in (0.0, 0.5, 1.0)])
            points = top + disk @ axes[:, :2].T
            found = [_least_mm(surface, point, axes, normal, reach) for point in points]
            over, beside = np.min(found, axis=0)
            told, what = cover_mm(frame, body), f"{body.label} of face {frame.number}"
            if not over > told - _TOLD_MM:
                wrong.append(f"{over:.2f} mm of silicone over {what}, {told:.2f} mm told")
            if not beside > spec.silicone.thinnest_wall_mm - _TOLD_MM:
                wrong.append(f"{beside:.2f} mm of silicone beside {what}")
    return wrong


def _least_mm(
    surface: manifold3d.Manifold,
    point: Float[np.ndarray, "3"],
    axes: Float[np.ndarray, "3 3"],
    normal: Float[np.ndarray, "3"],
    reach: float,
) -> tuple[float, float]:
    """Of rays out of a point, along the body's axis and up to 40° beside it: over the body, and to
    where the surface turns more than 60° from its normal over the body, the pad's side of a deep magnet.
    """
    slants = [(0.0, 0.0), *((np.sin(t), np.cos(t)) for t in np.linspace(0, 2 * np.pi, 7)[:-1])]
    over = beside = np.inf
    for slant in (0.35, 0.84):
        for x, y in slants:
            way = axes @ np.array([slant * x, slant * y, 1.0])
            hits = surface.ray_cast(tuple(point), tuple(point + reach * way / np.linalg.norm(way)))
            if not hits:
                return -np.inf, beside
            length = float(np.linalg.norm(np.asarray(hits[0].position) - point))
            if np.dot(hits[0].normal, normal) > _FACE_COSINE:
                over = min(over, length)
            else:
                beside = min(beside, length)
    return over, beside


def blocked_ways(spec: ObjectSpec, solids: Solids, pins: Solids) -> list[str]:
    """Pouring holes, vents, slots, wire holes, channels and slits that something is in."""
    wrong = _blocked_wires(spec, solids["core"]) if "core" in solids else []
    if "shell" in solids:
        for k, slit in enumerate(relief_slits(spec), start=1):
            cube = manifold3d.Manifold.cube(tuple(2 * (slit.half_mm - _SKIN_MM)), True)
            wrong += _in_the_way(
                f"slit {k}", _posed(cube, slit.axes, slit.centre_mm), solids, "shell"
            )
    wrong += _blocked_sides(spec, solids)
    if any(name in solids for name in _FIRST):
        first = {name: solids[name] for name in _FIRST if name in solids} | pins
        wrong += _blocked_holes(mould_holes(spec), first, solids.get("shell"))
        wrong += _no_slot(spec, solids)
    if "mould_seal_half_a" in solids:
        held = {
            f"pin {k}": pins[f"pin {k}"]
            for k, pin in enumerate(loose_pins(spec), start=1)
            if pin.locator is not None
        }
        second = {name: solids[name] for name in _SEAL if name in solids} | held
        wrong += _blocked_holes(seal_holes(spec), second, None)
    return wrong


def _blocked_holes(
    holes: tuple[Hole, ...], mould: Solids, shell: manifold3d.Manifold | None
) -> list[str]:
    wrong = []
    low, high = (
        np.min([np.reshape(s.bounding_box(), (2, 3)) for s in mould.values()], axis=0)[0],
        (np.max([np.reshape(s.bounding_box(), (2, 3)) for s in mould.values()], axis=0)[1]),
    )
    for k, hole in enumerate(holes, start=1):
        name = f"{hole.use} hole {k}"
        way = _rod(hole.top_mm, hole.end_mm, hole.diameter_mm / 2 - _SKIN_MM)
        for part in mould:
            wrong += _in_the_way(name, way, mould, part)
        if ((hole.end_mm > low) & (hole.end_mm < high)).all():
            wrong.append(f"{name} ends in the mould")
        if shell is not None:
            start = _rod(hole.start_mm, hole.top_mm, hole.diameter_mm / 2)
            if (start ^ shell).volume() < 0.1 * start.volume():
                wrong.append(f"{name} does not reach the silicone")
    return wrong


def _no_slot(spec: ObjectSpec, solids: Solids) -> list[str]:
    """Where a plug hangs in an open mould: silicone must be poured beside it."""
    frame = mould_frame(spec)
    if frame.opening != "open" or "shell" not in solids:
        return []
    turned = np.column_stack([frame.axes.T, np.zeros(3)])
    stood = {name: solid.transform(turned) for name, solid in solids.items()}
    level = stood["shell"].bounding_box()[5] - 0.2
    way = stood["shell"].slice(level)
    for name in _FIRST:
        if name in stood:
            above = stood[name].trim_by_plane((0.0, 0.0, 1.0), level + 0.1)
            way = way - above.project()
    return [] if way.offset(-_POUR_MM / 2).area() > 0 else ["no slot to pour into is left"]


def _blocked_wires(spec: ObjectSpec, core: manifold3d.Manifold) -> list[str]:
    """Wire holes from the core's faces to where wires leave, and channels from recesses to them."""
    wrong, body = [], body_of(spec)
    for frame, places in board_places(spec):
        radius = wire_hole_diameter_mm(spec, frame.number) / 2 - _FACET_MM
        out = frame.centre_mm + frame.normal
        if body.on_base or body.name == "pad":
            inside = frame.centre_mm * [1, 1, 0] - [0, 0, body.half_mm[2]]
        elif body.opening == "open":
            depth = min(spec.core.wall_mm + 0.5, float(frame.centre_mm @ frame.normal))
            inside = frame.centre_mm - depth * frame.normal  # a core without cavity: to its axis
        else:
            inside = np.zeros(3)
        name = f"wire hole of face {frame.number}"
        wrong += _in_the_way(name, _rod(out, inside, radius), {"core": core}, "core")
        if spec.arrangement == "sensors-in-core":
            for k, channel in enumerate(wire_channels(spec, frame, [p for p, _ in places], 0.0)):
                cube = manifold3d.Manifold.cube(tuple(2 * (channel.half_mm - _SKIN_MM)), True)
                posed = _posed(cube, channel.axes, channel.centre_mm)
                name = f"channel {k + 1} of face {frame.number}"
                wrong += _in_the_way(name, posed, {"core": core}, "core")
    if body.opening == "bore":
        widest = FLAT_SHARE * core_outlet(spec).radius_mm  # beside the flat that the rod's meets
        radius = min(spec.core.wire_hole_side_diameter_mm / 2, widest) - _FACET_MM
        down = np.array([0.0, 0.0, -body.half_mm[2]])
        wrong += _in_the_way(
            "the outlet of the wires", _rod(np.zeros(3), down, radius), {"core": core}, "core"
        )
    return wrong


def _blocked_sides(spec: ObjectSpec, solids: Solids) -> list[str]:
    """Where the core's room runs out through whole sides: wires must leave it through one of them."""
    inner = {name: solids[name] for name in ("core", "shell") if name in solids}
    if body_of(spec).opening != "open" or "core" not in inner:
        return []
    radius, found = spec.core.wire_hole_side_diameter_mm / 2 - _FACET_MM, []
    for face in spec.body.opened:
        out = (1.0 + body_of(spec).half_mm) * FACE_AXES[face][0]
        name, way = f"the way out of side {face}", _rod(np.zeros(3), out, radius)
        found.append([told for part in inner for told in _in_the_way(name, way, inner, part)])
    return [] if [] in found else [told for texts in found for told in texts]


def meeting_pins(solids: Solids, pins: Solids) -> list[str]:
    """Pins that meet each other, or another part of the closed mould, or what they stand round."""
    wrong = []
    for a, b in combinations(pins, 2):
        wrong += _in_the_way(a, pins[a], pins, b)
    for name in ("core", "shell", *_FIRST):
        if name in solids:
            for pin, solid in pins.items():
                wrong += _in_the_way(pin, solid, solids, name)
    return wrong


def left_over(spec: ObjectSpec, solids: Solids, pins: Solids) -> list[str]:
    """Room in the closed mould that no part of the object takes: silicone would fill it."""
    mould = [solids[name] for name in _FIRST if name in solids]
    if not mould or "shell" not in solids or spec.shell.seal_layer_mm:
        return []
    taken = [
        solids["shell"],
        *mould,
        *pins.values(),
        manifold_of(convert_to_triangles(core_outside(spec))),
    ]
    outer = manifold_of(body_of(spec).outer_surface())
    free = outer - manifold3d.Manifold.batch_boolean(taken, manifold3d.OpType.Add)
    return [
        f"the mould leaves {volume:.3g} mm³ free at {place.round(1).tolist()}"
        for volume, place in stray_pieces(free, taken)
    ]


def stray_pieces(
    free: manifold3d.Manifold, taken: list[manifold3d.Manifold]
) -> list[tuple[float, Float[np.ndarray, "3"]]]:
    """Volume and middle of what is thicker than a skin; `free` is what a boolean left beside `taken`.

    Each piece is cut by all that is taken once more, one by one: where pins fill their pockets, walls
    upon walls, a boolean of many can leave a piece that lies in the shell (13.6 mm³ of random design
    602). Volumes are asked for at every step, as Manifold gathers what it is not asked for.
    """
    found = []
    for piece, place in _pieces(free):
        volume = piece.volume()
        for part in taken:
            piece = piece - part
            volume = piece.volume()
        if volume > _STRAY_MM3 and 2 * volume / piece.surface_area() > _SKIN_MM:
            found.append((volume, place))
    return found


def _pieces(
    solid: manifold3d.Manifold,
) -> list[tuple[manifold3d.Manifold, Float[np.ndarray, "3"]]]:
    """Each surface round a volume, and its middle; `decompose` takes 12 s for 1 900 slivers."""
    mesh = solid.to_mesh64()
    corners, faces = np.array(mesh.vert_properties)[:, :3], np.asarray(mesh.tri_verts, int)
    count = len(corners)
    edges = coo_matrix(
        (np.ones(2 * len(faces)), (np.tile(faces[:, 0], 2), faces[:, 1:].T.ravel())), (count, count)
    )
    pieces, of_corner = connected_components(edges, directed=False)
    one, two, three = np.moveaxis(corners[faces], 1, 0)
    across, label = np.cross(two - one, three - one), of_corner[faces[:, 0]]
    volume = np.bincount(label, np.einsum("ij,ij->i", across, one) / 6, pieces)
    found = []
    for k in np.flatnonzero(volume > _STRAY_MM3):
        piece = trimesh.Trimesh(corners, faces[label == k], process=False)
        piece.remove_unreferenced_vertices()
        found.append((manifold_of(piece), corners[of_corner == k].mean(axis=0)))
    return found


def _rod(start: np.ndarray, end: np.ndarray, radius: float) -> manifold3d.Manifold:
    return manifold_of(trimesh.creation.cylinder(radius, segment=[start, end], sections=48))


def _posed(solid: manifold3d.Manifold, axes: np.ndarray, centre: np.ndarray) -> manifold3d.Manifold:
    pose = np.column_stack([axes, centre])
    if np.linalg.det(axes) < 0:
        pose[:, 2] *= -1
    return solid.transform(pose)


def _in_the_way(name: str, way: manifold3d.Manifold, solids: Solids, part: str) -> list[str]:
    """Common volume thicker than the skin by which triangles leave surfaces."""
    boxes = [np.reshape(solid.bounding_box(), (2, 3)) for solid in (way, solids[part])]
    if (boxes[0][0] > boxes[1][1]).any() or (boxes[1][0] > boxes[0][1]).any():
        return []
    common = way ^ solids[part]
    volume = common.volume()
    if volume <= 0.02 or 2 * volume <= _SKIN_MM * common.surface_area():
        return []
    place = np.reshape(common.bounding_box(), (2, 3)).mean(axis=0).round(1).tolist()
    return [f"{part} is in the way of {name}: {volume:.3g} mm³ at {place}"]
