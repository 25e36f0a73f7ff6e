"""Random objects of every kind of body, as parsed TOML; a few are no valid specification."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from hypothesis import strategies as st

KINDS = ("box", "cylinder", "capsule", "sphere", "ellipsoid", "pad", "dome", "imported")
BUMPS = 4


def between(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high, allow_nan=False).map(lambda value: round(value, 2))


@st.composite
def objects(draw, kinds: tuple[str, ...] = KINDS) -> dict[str, Any]:
    """Objects that differ in every dimension that the parts depend on."""
    kind = draw(st.sampled_from(kinds))
    thickness = draw(between(5.0, 9.0))
    body = draw(_BODIES[kind](thickness))
    narrow = _narrowest_mm(body, thickness)
    magnets, shell = draw(_magnets(kind, _narrowest_mm(body, 0.0)))
    core, sensors = draw(_electronics(kind, narrow))
    content = {
        "name": "random",
        "body": {"kind": kind, **body},
        "shell": {"thickness_mm": thickness, **shell},
        "magnets": magnets,
        "core": core,
        "sensors": sensors,
        "contact_grid": {"count": [2, 2], "pitch_mm": 2.0},
        "press": {"depths_mm": [0.5, 1.0]},
        "indenter": {"radius_mm": draw(between(2.0, 6.0))},
        "mould": draw(st.sampled_from([{}, {"style": "split"}])),
    }
    return _joined(content, draw(_box_only(thickness, narrow))) if kind == "box" else content


def _narrowest_mm(body: dict[str, Any], thickness: float) -> float:
    """Half of the narrowest extent of what is `thickness` inside the body."""
    size = body.get("size_mm") or [edge - 2.0 for edge in body["made"]["size_mm"]]
    across = size[:2] if "open_faces" not in body else size
    return min(across) / 2 - (0.0 if body.get("inside") == "silicone" else thickness)


@st.composite
def _box(draw, thickness: float) -> dict[str, Any]:
    size = [round(2 * thickness + draw(between(25.0, 34.0)), 2) for _ in range(3)]
    return {"size_mm": size, "open_faces": draw(_faces((1, 2, 3, 4, 5, 6), 4))}


@st.composite
def _cylinder(draw, thickness: float) -> dict[str, Any]:
    across, high = (round(2 * thickness + draw(between(24.0, 40.0)), 2) for _ in range(2))
    return {"size_mm": [across, across, high], "open_faces": draw(_faces((1, 6), 2))}


@st.composite
def _capsule(draw, thickness: float) -> dict[str, Any]:
    across = round(2 * thickness + draw(between(24.0, 40.0)), 2)
    return {
        "size_mm": [across, across, round(across + draw(between(2.0, 30.0)), 2)],
        **draw(_bored()),
    }


@st.composite
def _sphere(draw, thickness: float) -> dict[str, Any]:
    across = round(2 * thickness + draw(between(24.0, 40.0)), 2)
    return {"size_mm": [across] * 3, **draw(_bored())}


@st.composite
def _ellipsoid(draw, thickness: float) -> dict[str, Any]:
    size = [round(2 * thickness + draw(between(26.0, 36.0)), 2) for _ in range(3)]
    return {"size_mm": size, **draw(_bored())}


@st.composite
def _pad(draw, thickness: float) -> dict[str, Any]:
    plate = draw(between(3.6, 8.0))
    size = [draw(between(26.0, 60.0)), draw(between(26.0, 60.0)), round(thickness + plate, 2)]
    return {"size_mm": size}


@st.composite
def _dome(draw, thickness: float) -> dict[str, Any]:
    inside = draw(st.sampled_from(["core", "silicone", "air"]))
    across = round(draw(between(20.0, 40.0)) + 2 * thickness * (inside != "silicone"), 2)
    base = draw(between(3.6, 7.0))
    return {"size_mm": [across, across, round(across / 2 + base, 2)], "inside": inside}


@st.composite
def _imported(draw, thickness: float) -> dict[str, Any]:
    """A bumpy ball, drawn out along the axes; `with_file` writes it."""
    size = [round(2 * thickness + draw(between(28.0, 38.0)), 2) for _ in range(3)]
    waves = [
        {
            "along": [draw(between(-2.0, 2.0)) for _ in range(3)],
            "phase": draw(between(0.0, 6.28)),
            "height": draw(between(-0.03, 0.03)),
        }
        for _ in range(BUMPS)
    ]
    return {"made": {"size_mm": size, "waves": waves}, **draw(_bored())}


def with_file(content: dict[str, Any], folder: Path) -> dict[str, Any]:
    """The object with its made-up surface written as STL and measured, where it has one."""
    made = content["body"].get("made")
    if made is None:
        return content
    from design.body.imported import body_of_file

    path = folder / "made.stl"
    made_surface(made).export(path)
    rest = {key: value for key, value in content["body"].items() if key != "made"}
    return content | {"body": rest | body_of_file(path)}


def made_surface(made: dict[str, Any]) -> trimesh.Trimesh:
    """The bumpy ball of those waves, in a box of about that size."""
    surface = trimesh.creation.icosphere(4, 1.0)
    points = np.asarray(surface.vertices)
    radius = np.ones(len(points))
    for wave in made["waves"]:
        radius += wave["height"] * np.sin(3 * points @ np.asarray(wave["along"]) + wave["phase"])
    surface.vertices = radius[:, None] * points * np.asarray(made["size_mm"]) / 2
    return surface


@st.composite
def _bored(draw) -> dict[str, Any]:
    if not draw(st.booleans()):
        return {"open_faces": []}
    return {"open_faces": [6], "bore_mm": draw(between(5.0, 12.0))}


def _faces(choice: tuple[int, ...], most: int) -> st.SearchStrategy[list[int]]:
    return st.lists(st.sampled_from(choice), max_size=most, unique=True).map(sorted)


@st.composite
def _magnets(draw, kind: str, half: float):
    """A ring of magnets on any side of the face's centre, within what the face leaves for pockets."""
    diameter, depth = draw(between(3.0, 6.0)), draw(between(1.5, 3.5))
    room = (
        half - depth - diameter / 2 - 0.1 if kind in ("box", "pad") else 0.6 * half - diameter / 2
    )
    count = draw(st.integers(1, 4))
    apart = (diameter + 0.3) / 2 / np.sin(np.pi / count) if count > 1 else 0.0
    if apart > room:
        count, apart = 1, 0.0
    radius, turn = draw(between(apart, max(apart, room))), draw(between(0.0, 6.28))
    angles = turn + 2 * np.pi * np.arange(count) / count
    places = (radius * np.column_stack([np.cos(angles), np.sin(angles)])).round(3).tolist()
    shell = {"pocket_diameter_mm": diameter, "pocket_depth_mm": depth}
    return {"diameter_mm": diameter, "height_mm": 0.8, "positions_mm": places}, shell


@st.composite
def _electronics(draw, kind: str, narrow: float):
    """Recesses and a ring of sensors in them; walls thick enough for the recesses."""
    wall = draw(between(3.0, 5.0))
    outer = round(draw(between(0.5, 0.8)) * narrow, 2)
    inner = round(outer - draw(between(2.0, 4.0)), 2)
    core = {
        "wall_mm": wall,
        "recess_depth_mm": round(wall - 0.5, 2) if kind == "box" else draw(between(1.5, 3.0)),
        "recess_width_mm": draw(between(2.0, 5.0)),
        "recess_inner_radius_mm": max(0.5, inner),
        "recess_outer_radius_mm": max(2.5, outer),
    }
    sensors = {
        "count_per_face": draw(st.integers(1, 4)),
        "radius_mm": round(
            (core["recess_inner_radius_mm"] + core["recess_outer_radius_mm"]) / 2, 2
        ),
        "depth_below_core_face_mm": 1.0,
        **_board_of(core),
        "first_azimuth_deg": draw(st.tuples(*[between(0.0, 360.0)] * 5)),
    }
    return core, sensors


def _board_of(core: dict[str, float]) -> dict[str, list[float]]:
    """A board that fills its recess across and along, with a chip under it that does not."""
    along = round(core["recess_outer_radius_mm"] - core["recess_inner_radius_mm"], 2)
    high = round(core["recess_depth_mm"] / 2, 2) - 0.01
    board = [core["recess_width_mm"], along, high]
    return {"package_mm": board, "chip_mm": [0.5 * board[0], 0.5 * board[1], high]}


@st.composite
def _box_only(draw, thickness: float, narrow: float) -> dict[str, dict[str, Any]]:
    """Keys at a corner of the core, slits, a seal layer, channels; each half the time."""
    at = round(narrow - 1.05, 2)
    corner = st.tuples(*[st.sampled_from([-at, at])] * 2)
    chosen = {
        ("core", "keys"): {"positions_mm": [draw(corner)], "size_mm": [2, 2, 0.8]},
        ("shell", "slits"): {
            "depth_mm": draw(between(1.0, 0.9 * thickness)),
            "width_mm": draw(between(0.5, 1.5)),
        },
        ("shell", "seal_layer_mm"): draw(between(0.2, 0.6)),
        ("core", "wire_channel_mm"): [draw(between(0.8, 1.6)), 1.0],
    }
    more: dict[str, dict[str, Any]] = {"core": {}, "shell": {}}
    for (table, key), value in chosen.items():
        if draw(st.booleans()):
            more[table][key] = value
    return more


def _joined(content: dict[str, Any], more: dict[str, dict[str, Any]]) -> dict[str, Any]:
    return content | {table: content[table] | values for table, values in more.items()}


_BODIES = {
    "box": _box,
    "cylinder": _cylinder,
    "capsule": _capsule,
    "sphere": _sphere,
    "ellipsoid": _ellipsoid,
    "pad": _pad,
    "dome": _dome,
    "imported": _imported,
}
