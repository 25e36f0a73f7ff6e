"""Moulds of every kind of body: they cast the shell, hold the core, come apart and let the air out."""

from pathlib import Path

import cadquery as cq
import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

from design.body.imported import body_of_file
from design.body.meshes import high_points
from design.build.parts import parts_of
from design.errors import InputError
from design.fabrication.casting import OPEN_MM3, check_casting
from design.layout.body import body_of
from design.layout.core_hold import core_outlet, locators, why_no_mould
from design.layout.mould.frame import least_undercut, mould_frame, mould_style, parting, up
from design.layout.mould.pins import loose_pins, pins_of_kinds
from design.layout.mould.pouring import pour_holes
from design.mould import plug
from design.mould.halves import make_mould_half
from design.mould.openings import air_traps, mould_holes
from design.mould.pins import make_pin
from design.mould.plug import make_mould_holder
from design.mould.room import cast_room
from design.solids.booleans import common, convert_to_triangles, cut, volume_mm3
from design.solids.core import make_core
from design.solids.sampled import sampled_shell
from design.solids.shell import make_shell
from design.spec_io import parse_spec
from tests.support.objects.body_cases import body_spec
from tests.support.objects.random_objects import made_surface
from tests.support.objects.shell_volume import shell_volume_mm3
from tests.support.objects.whole_mould import inside_of_mould, mould_around

BESIDE = {"positions_mm": [[7.0, -1.0]]}
"""Clear of the wire holes in the middles of the faces, of which some are along a pull."""

CASES = {
    "pad": {},
    "cylinder": {},
    "sleeve": {},
    "solid_dome": {},
    "hollow_dome": {},
    "dome_on_core": {},
    "two_open": {},
    "closed_box": {},
    "sphere": {},
    "capsule": {},
    "closed capsule": {"body": {"open_faces": []}, "magnets": BESIDE},
    "ellipsoid": {"magnets": BESIDE},
    "ellipsoid on sockets": {},
    "closed sphere": {"body": {"open_faces": []}},
    "bored ellipsoid": {"body": {"open_faces": [6], "bore_mm": 9.0}},
    "split pad": {"mould": {"style": "split"}},
    "split cylinder": {"mould": {"style": "split"}},
    "split dome": {"mould": {"style": "split"}},
    "open at the side": {"body": {"open_faces": [3]}},
    "closed cylinder": {"body": {"open_faces": []}, "magnets": BESIDE},
    "slits that meet the pouring hole": {"shell": {"slits": {"depth_mm": 1.2, "width_mm": 0.5}}},
}
KINDS = {
    "bored ellipsoid": "ellipsoid",
    "split pad": "pad",
    "split cylinder": "cylinder",
    "split dome": "dome_on_core",
    "open at the side": "closed_box",
    "slits that meet the pouring hole": "closed_box",
    "closed cylinder": "cylinder",
    "closed capsule": "capsule",
    "ellipsoid on sockets": "ellipsoid",
    "closed sphere": "sphere",
}
LONG = (
    "slits that meet the pouring hole",
    "ellipsoid",
    "ellipsoid on sockets",
    "closed sphere",
    "sphere",
    "capsule",
    "closed capsule",
    "bored ellipsoid",
    "split dome",
    "split cylinder",
    "closed cylinder",
)
"""Booleans of many pins with curved faces take the kernel 5 to 15 s."""
SAMPLING = 2e-4
"""Of the shell's volume: round pockets are cut with 64 sides there, and pins are finer."""


def case(name, **changes):
    return body_spec(KINDS.get(name, name), **(CASES[name] | changes))


def shell_of(spec):
    return sampled_shell(spec) if body_of(spec).sampled else make_shell(spec)


def missed_share(spec, parts):
    """Volume in which the room that parts leave differs from the shell, as a share of the shell.

    The kernel sees no difference of solids that share curved faces, so that volumes are compared
    too; integrated to 1e-6, or they are off by as much themselves.
    """
    shell, cavity = shell_of(spec), cut(cast_room(spec), *parts)
    beyond = volume_mm3(cut(cavity, shell)) + volume_mm3(cut(shell, cavity))
    fine = [s.Volume(1e-6) if isinstance(s, cq.Shape) else float(s.volume) for s in (shell, cavity)]
    return (beyond + abs(fine[0] - fine[1])) / fine[0]


def translated(part, by_mm):
    if isinstance(part, cq.Shape):
        return part.translate(cq.Vector(*by_mm))
    return part.copy().apply_translation(by_mm)


def marked(*names):
    """Parameters, the long ones slow."""
    return [pytest.param(n, marks=pytest.mark.slow if n in LONG else []) for n in names]


@pytest.mark.parametrize("name", marked(*CASES))
def test_envelope_less_mould_less_what_is_inside_is_the_shell(name):
    spec = case(name)
    assert missed_share(spec, [*mould_around(spec), *inside_of_mould(spec)]) < (
        SAMPLING if body_of(spec).sampled else 1e-6
    )


@pytest.mark.parametrize("name", marked("sphere", "bored ellipsoid", "closed_box"))
def test_a_pin_forgotten_or_shifted_does_not_cast_the_shell(name):
    spec = case(name)
    half_a, half_b, pin, *others = [*mould_around(spec), *inside_of_mould(spec)]
    assert missed_share(spec, [half_a, half_b, *others]) > 1e-3
    way = 0.6 * loose_pins(spec)[0].way
    shifted = translated(pin, way)
    assert missed_share(spec, [half_a, half_b, shifted, *others]) > SAMPLING


def test_the_closed_box_is_the_formula_s_shell():
    spec = case("closed_box")
    assert_allclose(make_shell(spec).Volume(), shell_volume_mm3(spec), rtol=1e-9)
    (one, other) = locators(spec)
    assert abs(one.frame.normal @ other.frame.normal) < 1e-12


def test_locating_pins_are_parts_of_their_own_even_where_alike():
    pins = loose_pins(case("closed_box"))
    held = next(pin for pin in pins if pin.locator is not None)
    before, after = (pins_of_kinds(some) for some in (pins, (*pins, held, held)))
    assert [name for name, _ in after[len(before) :]] == ["mould_locator_3", "mould_locator_4"]
    plain = [members for name, members in after if not name.startswith("mould_locator")]
    assert sum(map(len, plain)) == sum(pin.locator is None for pin in pins)


@pytest.mark.parametrize("name", marked("sphere", "closed_box"))
def test_parts_go_together_and_none_is_inside_another(name):
    spec = case(name)
    halves = [make_mould_half(spec, side) for side in (1, -1)]
    pins = [make_pin(spec, pin) for pin in loose_pins(spec)]
    rods = [make_mould_holder(spec)] if mould_frame(spec).opening == "bore" else []
    core, named = make_core(spec), [*halves, *rods, *pins]
    for index, part in enumerate(named):
        assert volume_mm3(common(part, core)) < 1e-6
        for other in named[index + 1 :]:
            assert volume_mm3(common(part, other)) < 1e-6


@pytest.mark.parametrize("name", marked("sphere", "capsule", "split cylinder"))
def test_halves_and_the_rod_draw_out_without_tearing_the_silicone(name):
    spec = case(name)
    shell, normal = make_shell(spec), parting(spec).normal
    drawn = [(make_mould_half(spec, side), side * normal) for side in (1, -1)]
    if mould_frame(spec).opening == "bore":
        drawn.append((make_mould_holder(spec), mould_frame(spec).out))
    for part, way in drawn:
        for step in (0.5, 4.0, 15.0):
            moved = part.translate(cq.Vector(*(step * way)))
            assert volume_mm3(common(moved, shell)) < 1e-6
    wrong = drawn[0][0].translate(cq.Vector(*(-4.0 * normal)))
    assert volume_mm3(common(wrong, shell)) > 100


def test_the_rod_keeps_the_core_from_turning_and_from_rising():
    spec = case("sphere")
    holder, core = make_mould_holder(spec), make_core(spec)
    assert volume_mm3(common(holder, core)) < 1e-6
    for turn in (-20.0, 20.0):
        turned = holder.rotate(cq.Vector(0, 0, 0), cq.Vector(0, 0, 1), turn)
        assert volume_mm3(common(turned, core)) > 0.1
    assert volume_mm3(common(holder.translate(cq.Vector(0, 0, 0.3)), core)) > 1
    assert core_outlet(spec).nose_mm > core_outlet(spec).floor_mm + spec.core.wall_mm


def test_bosses_along_the_pull_stay_on_their_half():
    turned = case("sphere", mould={"parting_azimuth_deg": 0.0}, magnets={"positions_mm": [[0, 0]]})
    assert len(loose_pins(turned)) == 3, "faces 3 and 5 point along x"
    assert missed_share(turned, [*mould_around(turned), *inside_of_mould(turned)]) < 1e-6
    half, shell = make_mould_half(turned, 1), make_shell(turned)
    moved = half.translate(cq.Vector(5, 0, 0))
    assert volume_mm3(common(moved, shell)) < 1e-6


def test_a_style_that_cannot_be_drawn_is_refused_and_the_other_is_chosen():
    assert mould_style(case("sphere")) == "split"
    assert mould_style(case("pad")) == "one-piece"
    with pytest.raises(InputError, match="needs a whole side of the body open"):
        case("sphere", mould={"style": "one-piece"})


def test_a_core_that_nothing_can_hold_is_told():
    spec = body_spec("ellipsoid", core={"wire_hole_side_diameter_mm": 20.0})
    assert not [part for part in parts_of(spec) if part.name.startswith("mould")]
    (told,) = check_casting(spec, {})
    assert (told.check, told.status) == ("mould", "fail")
    assert "Move a face's pockets" in told.what
    assert why_no_mould(case("ellipsoid")) is None


def meshes_of(spec):
    return {part.name: convert_to_triangles(part.make()) for part in parts_of(spec)}


def found(findings, check, part=None):
    (finding,) = [f for f in findings if f.check == check and part in (None, f.part)]
    return finding


@pytest.mark.slow
def test_the_seam_of_an_ellipsoid_runs_at_its_silhouette():
    spec = case("bored ellipsoid")  # 60 × 50 × 44 mm
    assert_allclose(parting(spec).normal, [0, 1, 0], rtol=0, atol=1e-12)
    findings = check_casting(spec, meshes_of(spec))
    assert not [f for f in findings if f.status == "fail"]
    skew = case("bored ellipsoid", mould={"parting_azimuth_deg": 40.0})
    hook = found(check_casting(skew, meshes_of(skew)), "undercut", "mould_half_a")
    assert hook.status == "fail"
    assert hook.value > 0.3


def test_the_parting_plane_is_found_where_least_hooks():
    """An egg that is blunt at one end: its largest section lies off the middle of its box."""
    cone = trimesh.creation.icosphere(4, 10.0)
    points = np.asarray(cone.vertices)
    points[points[:, 0] > 0, 0] *= 2.5
    points[:, 0] -= 7.5
    normal = np.array([1.0, 0, 0])
    cone.vertices = points
    area, offset = least_undercut(cone, normal)
    assert area < 0.5
    assert_allclose(offset, -7.5, rtol=0, atol=1.0)
    hooked, middle = least_undercut(cone, np.array([0, 1.0, 0]))
    assert (round(hooked, 6), middle) == (0.0, 0.0)


@pytest.fixture(scope="module")
def peanut(tmp_path_factory):
    """Two balls in one: poured with the bore between them, each has a high point of its own."""
    balls = [trimesh.creation.icosphere(3, 22) for _ in range(2)]
    for ball, x in zip(balls, (-13, 13), strict=True):
        ball.apply_translation((x, 0, 0))
    path = Path(tmp_path_factory.mktemp("body")) / "peanut.stl"
    trimesh.boolean.union(balls, engine="manifold").export(path)
    body = {
        "kind": "imported",
        "bore_mm": 6.0,
        "sensed_faces": [1, 3],
        "open_faces": [6],
        **body_of_file(path),
    }
    return body_spec("ellipsoid", body=body, mesh={"envelope_mm": 0.2}, printer={"hole_mm": 1.5})


@pytest.mark.slow
def test_vents_stand_on_high_points_and_are_open(peanut):
    shell = sampled_shell(peanut)
    traps = air_traps(peanut, shell, pour_holes(peanut))
    assert sorted(round(float(trap.place_mm[0])) for trap in traps) == [-13, 13]
    vents = [hole for hole in mould_holes(peanut) if hole.use == "vent"]
    assert [vent.diameter_mm for vent in vents] == [1.5, 1.5]
    meshes = meshes_of(peanut)
    findings = check_casting(peanut, meshes)
    assert found(findings, "air traps").status == "pass"
    assert found(findings, "holes are open").status == "pass"
    plugged = trimesh.creation.cylinder(0.5, segment=[vents[0].start_mm, vents[0].end_mm])
    meshes["mould_half_a"] = meshes["mould_half_a"].union(plugged)
    blocked = found(check_casting(peanut, meshes), "holes are open")
    assert blocked.status == "fail"
    assert_allclose(blocked.limit, OPEN_MM3 + 0.01 * np.pi * 1.5**2 / 4)


BUMPY = {
    "size_mm": [44.0, 44.0, 44.0],
    "waves": [{"along": [0.7, -1.2, -0.3], "phase": 3.2, "height": 0.03}],
}
"""A ball whose bore's rim is highest beside the rod, between the pouring holes."""


def bumpy(tmp_path, made=BUMPY):
    path = tmp_path / "bumpy.stl"
    made_surface(made).export(path)
    body = {"kind": "imported", "bore_mm": 8.0, "sensed_faces": [1], **body_of_file(path)}
    return body_spec("sphere", body=body | {"open_faces": [6]})


def test_vents_under_the_holder_lead_through_it(tmp_path):
    """Air at the rim of a bore rises along the rod and through the flange."""
    spec = bumpy(tmp_path)
    vents = [hole for hole in mould_holes(spec) if hole.use == "vent"]
    aside = [np.hypot(*vent.top_mm[:2]) - spec.body.bore_mm / 2 for vent in vents]
    assert min(abs(away) for away in aside) < vents[0].diameter_mm / 2, "one stands half in the rod"
    inside = {part.name: part for part in parts_of(spec)}
    meshes = {
        name: convert_to_triangles(inside[name].make())
        for name in ("shell", "core", "mould_holder")
    }
    findings = check_casting(spec, meshes)
    assert found(findings, "holes are open").status == "pass"
    assert found(findings, "mould closes").status == "pass"
    whole = convert_to_triangles(holder_without_vents(spec))
    removed = cut(whole, meshes["mould_holder"])
    assert volume_mm3(removed) > 3.5
    assert volume_mm3(common(removed, cast_room(spec))) < 0.01, "silicone sees the same rod"
    blocked = found(check_casting(spec, meshes | {"mould_holder": whole}), "holes are open")
    assert (blocked.status, blocked.part) == ("fail", "mould_holder")


def holder_without_vents(spec):
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(plug, "mould_holes", lambda _: ())
        return make_mould_holder(spec)


def test_a_closed_mould_is_poured_at_its_upper_corner():
    spec = case("closed_box")
    (pour,) = mould_holes(spec)
    corner = np.array([1.0, -1.0, -1.0]) * np.asarray(spec.body.size_mm) / 2
    assert_allclose(up(spec), corner / np.linalg.norm(corner), rtol=0, atol=1e-12)
    away = np.cross(pour.start_mm - corner, up(spec))
    assert_allclose(np.linalg.norm(away), 0, rtol=0, atol=1e-9)
    assert air_traps(spec, sampled_shell(spec), (pour,)) == []
    assert len(air_traps(spec, sampled_shell(spec), ())) == 1


def test_high_points_by_hand():
    """A plate with bumps of 3, 2 and 0.05 mm: air stays under those that the rim does not drain."""
    x, y = np.meshgrid(np.linspace(-15, 15, 61), np.linspace(-10, 10, 41), indexing="ij")
    height = sum(
        tall * np.exp(-((x - at) ** 2 + y**2) / 4) for tall, at in ((3, -8), (2, 1), (0.05, 9))
    )
    nodes = np.arange(x.size).reshape(x.shape)
    a, b, c, d = (nodes[i, j].ravel() for i, j in _CORNERS)
    mesh = trimesh.Trimesh(
        np.column_stack([x.ravel(), y.ravel(), height.ravel()]),
        np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])]),
    )
    places = high_points(mesh, np.array([0, 0, 1.0]), 99.0, 0.1)
    assert_allclose([trap.place_mm[0] for trap in places], [-8, 1], rtol=0, atol=0.51)
    assert_allclose(places[1].depth_mm, 1.97, rtol=0, atol=0.02)  # over the saddle to the first
    (left,) = high_points(mesh, np.array([0, 0, 1.0]), 2.5, 0.1)
    assert_allclose(left.place_mm[0], 1, rtol=0, atol=0.51)
    assert len(high_points(mesh, np.array([0, 0, 1.0]), 99.0, 0.01)) == 3
    assert not high_points(mesh, np.array([0, 0, -1.0]), 99.0, 0.1)


_CORNERS = (
    (slice(0, -1), slice(0, -1)),
    (slice(1, None), slice(0, -1)),
    (slice(1, None), slice(1, None)),
    (slice(0, -1), slice(1, None)),
)


def test_a_locating_pin_leaves_the_magnet_a_floor():
    """A hole of Ø4 through a pocket of Ø3 left nothing for the magnet to rest on."""
    narrow = {"magnets": {"diameter_mm": 3.0}, "shell": {"pocket_diameter_mm": 3.0}}
    box = {"body": {"open_faces": []}}
    middles = {"positions_mm": [[0.0, 0.0], [9.0, 0.0]]}
    wide = parse_spec({"name": "wide", "magnets": middles, **box}, "test")
    assert [len(locator.pockets) for locator in locators(wide)] == [1, 1]
    swallowed = parse_spec(
        {"name": "narrow", **box, **narrow, "magnets": narrow["magnets"] | middles}, "test"
    )
    assert [locator.radius_mm for locator in locators(swallowed)] == [1.0], "the top's hole alone"
