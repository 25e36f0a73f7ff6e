"""Parts of a placement by hand, and what is proposed where a body is too small, by made-up rules."""

from dataclasses import replace

import numpy as np
import pytest

from design.layout.body import face_frames
from design.layout.places.positions import sensor_layout
from design.layout.pockets import shell_pockets
from design.placement import asked
from design.placement.asked import (
    _fewer,
    _grown,
    _larger,
    _smallest,
    _thickened,
    _told,
    _too_small,
)
from design.placement.objects import Request, Trim, _pitches_mm, _rounded, bare_tables
from design.placement.paths import long_path_mm
from design.placement.room import (
    _beside_mm,
    low_rim,
    outlet_room_mm,
    tight_core,
    tight_middle,
    tight_rim,
    tight_shell,
)
from tests.support.objects.worked_objects import OBJECTS, worked
from tests.support.recorded_facts import assert_on_record, told

TRIM = Trim(7.0, 5.0, 3.0)
IN_CORE = [name for name in OBJECTS if name not in ("reverse box", "ellipsoid")]


@pytest.mark.parametrize(
    ("kind", "size", "bore"),
    [("sphere", 50, 10.0), ("sphere", 27, 6.0), ("sphere", 20, 4.0), ("box", 42, None)],
)
def test_a_bore_is_half_of_the_room_from_4_to_10_mm(kind, size, bore):
    tables = bare_tables(Request(kind, (float(size),) * 3, faces=(1, 2)), TRIM)
    assert tables["body"].get("bore_mm") == bore
    assert tables["body"]["sensed_faces"] == [1, 2]
    assert tables["shell"] == {
        "thickness_mm": 7.0,
        "pocket_diameter_mm": 5.0,
        "pocket_depth_mm": 3.0,
    }
    assert "sensed_faces" not in bare_tables(Request(kind, (float(size),) * 3), TRIM)["body"]


def test_pitches_are_coarser_on_faces_that_would_take_more_than_100_locations():
    assert _pitches_mm(worked("box")) == (3.0, 2.5, 2.0, 1.5, 1.0)
    for long, pitches in ((350.0, (4.0,)), (301.0, (4.0,)), (290.0, (3.0, 2.5, 2.0, 1.5, 1.0))):
        body = worked("box").body.changed(size_mm=(46.0, 50.0, long))
        assert _pitches_mm(worked("box").changed(body=body)) == pitches


def test_sizes_grow_in_half_millimetres_and_files_as_their_scale():
    request = Request("imported", (20.0, 30.1, 40.0), file=(("file", "a.stl"), ("scale", 2.0)))
    grown = _grown(request, 1.25)
    assert grown.size_mm == pytest.approx((25.0, 30.1 * 1.25, 50.0))
    assert dict(grown.file) == {"file": "a.stl", "scale": 2.5}
    assert dict(_grown(replace(request, file=(("file", "a.stl"),)), 1.25).file)["scale"] == 1.25
    plain = _grown(Request("box", (20.0, 30.1, 40.0)), 1.25)
    assert (plain.size_mm, plain.file) == ((25.0, 38.0, 50.0), ())
    assert _thickened(request, 1.3).size_mm == (26.0, 30.1, 40.0)
    assert _rounded(np.array([[1.234, -0.001]])) == [[1.23, 0.0]]


def ruled(monkeypatch, rule):
    monkeypatch.setattr(asked, "fits_roughly", rule)
    monkeypatch.setattr(asked, "roomy_faces", lambda request: ())


@pytest.mark.parametrize(
    ("least", "found"), [(21.0, 21.0), (25.0, 25.0), (31.0, 31.5), (140.0, 141.0), (170.0, None)]
)
def test_the_smallest_size_that_works_is_found_to_a_few_percent(monkeypatch, least, found):
    """Steps of 1.25, the last halved thrice, up to eight times the size."""
    ruled(monkeypatch, lambda request: request.size_mm[0] >= least)
    smallest = _smallest(Request("box", (20.0, 20.0, 20.0)), 20.0, _grown)
    if found is None:
        assert smallest is None
    else:
        assert least <= smallest.size_mm[0] <= 1.035 * least + 0.5


def test_nothing_grows_beyond_a_metre(monkeypatch):
    ruled(monkeypatch, lambda request: request.size_mm[0] >= 1100.0)
    assert _smallest(Request("box", (700.0, 700.0, 700.0)), 700.0, _grown) is None


def test_larger_sizes_are_told_of_the_shape_and_with_short_edges_alone(monkeypatch):
    ruled(monkeypatch, lambda request: min(request.size_mm) >= 30.0)
    whole, short = _larger(Request("box", (24.0, 60.0, 60.0)))
    assert whole == "The smallest of that shape that works is about 30 × 75 × 75 mm"
    assert short == "with its short edges longer about 30 × 60 × 60 mm works"
    (alone,) = _larger(Request("box", (24.0, 24.0, 24.0)))
    assert alone.endswith("about 30 × 30 × 30 mm")
    (short,) = _larger(Request("box", (24.0, 160.0, 160.0)))  # the whole: beyond the printer's bed
    assert short == "With its short edges longer about 30 × 160 × 160 mm works"
    (whole,) = _larger(Request("box", (24.0, 160.0, 160.0), file=(("scale", 1.0),)))
    assert whole.endswith("30 × 200 × 200 mm (scale = 1.25)"), "nothing else helps"
    monkeypatch.setattr(asked, "with_thinnest", lambda request: request)
    (scaled,) = _larger(Request("imported", (24.0, 60.0, 60.0), file=(("scale", 2.0),)))
    assert scaled.endswith("30 × 75 × 75 mm (scale = 2.5)")


@pytest.mark.parametrize(
    ("sensors", "most", "said"),
    [
        (4, 3, "3 sensors"),
        (5, 2, "2 sensors"),
        (4, 1, "1 sensor"),
        (2, 1, "1 sensor"),
        (1, 1, None),
    ],
)
def test_fewer_sensors_are_told_that_would_fit(monkeypatch, sensors, most, said):
    ruled(monkeypatch, lambda request: request.sensors <= most)
    assert list(_fewer(Request("box", (30.0, 30.0, 30.0), sensors))) == (
        [f"{said} per face would fit"] if said else []
    )


@pytest.mark.parametrize(
    ("wanted", "fit", "said"),
    [(5, 2, "2 magnets"), (3, 1, "1 magnet"), (1, 1, None), (None, 2, None), (4, 0, None)],
)
def test_fewer_magnets_are_told_that_would_fit(monkeypatch, wanted, fit, said):
    found = {"magnets": {"positions_mm": [[0.0, 0.0]] * fit}} if fit else None
    monkeypatch.setattr(asked, "every_fit", lambda *given: iter([found] if found else []))
    monkeypatch.setattr(asked, "fits_roughly", lambda request: False)
    told_ = list(_fewer(Request("box", (30.0, 30.0, 30.0), 3, wanted)))
    assert told_ == ([f"{said} per face would fit"] if said else [])


def test_what_is_too_small_is_told_with_all_that_helps(monkeypatch):
    ruled(monkeypatch, lambda request: min(request.size_mm) >= 30 or request.sensors == 1)
    said = _too_small(Request("box", (24.0, 24.0, 24.0), 2))
    assert said == (
        "a body of kind box of 24 × 24 × 24 mm is too small for 2 sensors and a magnet per face. The "
        "smallest of that shape that works is about 30 × 30 × 30 mm; or 1 sensor per face would fit"
    )
    monkeypatch.setattr(asked, "with_thinnest", lambda request: request)
    monkeypatch.setattr(asked, "fits_roughly", lambda request: False)
    monkeypatch.setattr(asked, "every_fit", lambda *given: iter([]))
    said = _too_small(Request("imported", (24.0, 24.0, 24.0), 1, 3, (("file", "x"),)))
    assert said == (
        "an imported body of 24 × 24 × 24 mm is too small for 1 sensor and 3 magnets per face, and no "
        "size up to 8 times was found that works. Choose another shape"
    )
    assert (
        _told(Request("box", (1.0, 2.0, 3.0), faces=(2, 4)))
        == "1 × 2 × 3 mm with sensors on faces 2, 4 alone"
    )
    assert _told(Request("box", (1.0, 2.0, 3.0), faces=(2,))).endswith("on face 2 alone")


@pytest.mark.parametrize("name", IN_CORE)
def test_gaps_of_an_object_are_as_on_record(name):
    spec = worked(name)
    pockets = zip(face_frames(spec), shell_pockets(spec), strict=True)
    beside = [min(_beside_mm(frame, p), 1e6) for frame, face in pockets for p in face[:2]]
    tight = [tight_core(spec), tight_core(spec, sunk=False), tight_middle(spec), tight_rim(spec)]
    lines = [
        told(
            "tight core, flat, middle, rim; low rim; tight shell",
            [*tight, low_rim(spec), tight_shell(spec)],
        ),
        told("beside pockets", beside),
        told("outlet's room", min(outlet_room_mm(spec), 1e6)),
        told("long path", long_path_mm(spec, sensor_layout(spec))),
    ]
    assert_on_record("gaps", name, lines)


def moved(name, **tables):
    content = {
        table: getattr(worked(name), table).changed(**values) for table, values in tables.items()
    }
    return worked(name).changed(**content)


def test_gaps_are_tight_up_to_their_border():
    """Walls of 0.8 mm are printed, silicone of 1.25 mm is roomy; hole of Ø3, recesses from 2.3 mm inwards."""
    spread = {"positions_mm": ((9.0, 0.0), (-9.0, 0.0)), "north": ()}
    for y, tight in ((4.59, True), (4.61, False)):
        assert (
            tight_middle(moved("closed box", sensors={"positions_mm": [[0.0, y], [9.0, 0.0]]}))
            == tight
        )
    for depth, tight in ((1.84, True), (1.86, False), (6.14, False), (6.16, True)):
        assert tight_shell(moved("closed box", magnets={**spread, "depth_mm": depth})) == tight, (
            depth
        )
    for apart, tight in ((5.44, True), (5.46, False)):
        row = {"positions_mm": ((0.0, 0.0), (apart, 0.0)), "north": ()}
        assert tight_shell(moved("closed box", magnets=row)) == tight
    for x, tight in ((16.66, True), (16.64, False)):
        row = {"positions_mm": ((x, 0.0), (-x, 0.0)), "north": ()}
        assert tight_shell(moved("pad", magnets=row)) == tight
