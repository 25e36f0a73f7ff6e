"""Jaws read from frames: force, centre of pressure and tilt of both, and which kind of contact it was.

Frames come from presses of tilted indenters, solved jointly: no table, pattern or sum of motions is in them.
"""

from dataclasses import replace

import numpy as np
import pytest

from design.spec.object import ContactGridSpec, IndenterSpec, MeshSpec
from estimator.grasps.track import track_of_sets
from estimator.information.jaws import signals_of_motions
from estimator.inversion.inversion import inversion
from estimator.inversion.storage import load_inversion, save_inversion
from estimator.inversion.tracking import Tracker
from estimator.signals.presses import press_signals
from fem.linear.response import build_response
from fem.mesh.tetrahedra import tetrahedralize
from fem.presses.jaws import jaw_faces
from fem.presses.joint import Tip, press_tips
from fem.presses.table import simulate_lattice

POSES = (((0.0, 0.0), 0.8), ((0.5, 0.0), 1.1), ((0.0, -1.0), 1.3), ((0.7, 0.7), 1.5))
"""Tilts (degrees) and depth (mm) of what touches first: 50 N and more, of which noise hides 2 %."""


@pytest.fixture(scope="module")
def spec(rigid_spec):
    return rigid_spec.changed(contact_grid=ContactGridSpec(count=(3, 3), pitch_mm=10.0))


@pytest.fixture(scope="module")
def reader(spec, rigid_response, tmp_path_factory):
    """The estimator as `predict` reads it from its file."""
    forces, motions = simulate_lattice(spec, rigid_response)
    tips = inversion(spec, forces, motions, press_signals(spec, forces, motions), 0.03, 0.0)
    path = tmp_path_factory.mktemp("jaws") / "contacts.nc"
    save_inversion(replace(tips, jaw_tables=jaw_faces(spec, rigid_response)), path)
    return load_inversion(path)


def frame_of(spec, response, tips, depth_mm, seed=3, **indenter):
    """Noisy counts, and the press."""
    press = press_tips(
        spec.changed(indenter=IndenterSpec(**indenter)),
        response,
        tips,
        np.full(len(tips), depth_mm),
    )
    counts = signals_of_motions(spec, press.motion[None]).delta_counts[0, 0].ravel()
    noise = np.tile(np.asarray(spec.sensors.noise_counts), len(counts) // 3)
    return counts + noise * np.random.default_rng(seed).normal(size=len(counts)), press


def grasp(spec, response, tilt, depth):
    """Counts of two jaws on opposite faces, and the press."""
    tips = [Tip(3, 0.0, 0.0), Tip(5, 0.0, 0.0)]
    jaw = {"kind": "cuboid", "size_mm": (63.0, 63.0), "turn_deg": (0.0, *tilt)}
    return frame_of(spec, response, tips, depth, **jaw)


def errors(read, press, tilt):
    """Largest error of two jaws: force (relative), centre (mm), tilt (degrees)."""
    assert read.jaws.all()
    assert read.explained.all()
    assert read.face[0, :2].tolist() == [3, 5]
    assert read.number.tolist() == [2]
    off = (
        abs(read.force_n[0, :2] / press.force_n - 1).max(),
        np.linalg.norm(read.xy_mm[0, :2] - press.centre_mm, axis=1).max(),
        abs(read.tilt_deg[0, :2] - tilt).max(),
    )
    return np.array(off)


def worst_of_poses(spec, reader, response, poses=POSES):
    """The largest errors over poses, each read by itself."""
    worst = np.zeros(3)
    for tilt, depth in poses:
        counts, press = grasp(spec, response, tilt, depth)
        worst = np.maximum(worst, errors(reader.read(counts[None])[0], press, tilt))
    return worst


def test_two_jaws_are_read_and_are_no_tips(spec, reader, rigid_response):
    """Tilts about one axis are read below, where a grasp turns. Less than half of a tilt is lost."""
    assert (worst_of_poses(spec, reader, rigid_response, POSES[2:]) < [0.05, 1.0, 0.3]).all()


PARTS = (((42.0, 42.0), (21.0, 0.0)), ((60.0, 20.0), (0.0, 0.0)), ((30.0, 30.0), (12.0, 12.0)))
"""Edges of jaws (mm) and where their middles lie: half over the border, a bar, over a corner."""


@pytest.mark.parametrize(("size", "place"), PARTS)
def test_jaws_over_parts_of_faces_are_no_tips(spec, reader, rigid_response, size, place):
    """Force within 10 %, and within its interval; centre of pressure within 1 mm; size within 5 mm or what
    is said of it."""
    tips = [Tip(face, *place) for face in (3, 5)]
    jaw = {"kind": "cuboid", "size_mm": size, "turn_deg": (0.0, 0.3, 0.2)}
    counts, press = frame_of(spec, rigid_response, tips, 0.9, **jaw)
    read, _ = reader.read(counts[None])
    assert read.jaws.all()
    assert read.explained.all()
    assert read.face[0, :2].tolist() == [3, 5]
    away = abs(read.force_n[0, :2] - press.force_n)
    assert (away < 0.1 * press.force_n).all()
    assert (away < 2 * read.force_halfwidth_n[0, :2]).all()
    away = read.xy_mm[0, :2] - press.centre_mm - place
    assert (np.linalg.norm(away, axis=1) < 1.0).all()
    half, middle = np.array(size) / 2, np.array(place)
    covered = np.minimum(middle + half, 21.0) - np.maximum(middle - half, -21.0)
    away = abs(read.size_mm[0, :2, :, 0] - covered)
    assert (away < 5.0 + 2 * read.size_halfwidth_mm[0, :2, None]).all()


def test_tips_are_no_jaws(spec, reader, rigid_response):
    for tips in ([Tip(3, 5.0, -4.0)], [Tip(3, 5.0, -4.0), Tip(5, -6.0, 3.0)]):
        counts, _ = frame_of(spec, rigid_response, tips, 1.0)
        read, _ = reader.read(counts[None])
        assert not read.jaws.any()
        assert read.number.tolist() == [len(tips)]


def test_a_grasp_by_jaws_is_followed_as_jaws_until_it_lets_go(spec, reader, rigid_response):
    """Rest, a grasp that turns about the faces' x, rest, then a tip: no jaw splits into tips."""
    tracker, rest = Tracker(reader), np.zeros(reader.model.channels)
    assert tracker.feed(rest).number.tolist() == [0]
    for tilt in (0.0, 0.2, 0.4, 0.6):
        counts, press = grasp(spec, rigid_response, (tilt, 0.0), 1.0)
        read = tracker.feed(counts)
        assert (errors(read, press, (tilt, 0.0)) < [0.05, 1.0, 2.0]).all()
        assert track_of_sets(np.zeros(1), read, 0.0).jaws.all()
    assert tracker.seen_anew <= 2  # jaws go on from the frame before
    assert tracker.feed(rest).number.tolist() == [0]
    counts, _ = frame_of(spec, rigid_response, [Tip(3, 5.0, -4.0)], 1.0)
    read = tracker.feed(counts)
    assert not read.jaws.any()
    assert not track_of_sets(np.zeros(1), read, 0.0).jaws.any()
    assert read.number.tolist() == [1]


def fingers(spec, response, place, depth_mm, seed=3):
    """Counts of two flat fingers of 14 mm on opposite faces, and the press."""
    tips = [Tip(face, *place) for face in (3, 5)]
    return frame_of(spec, response, tips, depth_mm, seed, kind="cuboid", size_mm=(14.0, 14.0))


def test_fingers_that_passed_for_a_magnet_are_jaws_once_it_is_gone(spec, reader, rigid_response):
    """So light, a magnet near by explains them; contacts looked for from scratch end it, and are weighed."""
    tracker, sets = Tracker(reader), []
    tracker.feed(np.zeros(reader.model.channels))
    for number, depth in enumerate((0.08, 0.16, 0.32, 0.32)):
        counts, press = fingers(spec, rigid_response, (0.0, 0.0), depth, 29 + number)
        sets.append((tracker.feed(counts), tracker.beside_magnet))
    assert sets[1][1]
    for read, beside_magnet in sets[2:]:
        assert not beside_magnet
        assert read.jaws.all()
        assert read.number.tolist() == [2]
        assert (abs(read.force_n[0, :2] - press.force_n) < 2 * read.force_halfwidth_n[0, :2]).all()


def test_tips_that_jaws_gave_way_to_stay_as_uncertain(spec, reader, rigid_response):
    """Tips of a finger that presses on may still be jaws in the next frame."""
    tracker, sets = Tracker(reader), []
    tracker.feed(np.zeros(reader.model.channels))
    for depth in (0.1, 0.212, 0.324, 0.436, 0.436, 0.436):
        counts, _ = fingers(spec, rigid_response, (-6.0, 4.0), depth)
        sets.append(tracker.feed(counts))
    assert [bool(read.jaws[0]) for read in sets] == [False, True, True, False, False, False]
    first, *later = (np.nansum(read.force_halfwidth_n[0]) for read in sets[3:])
    assert (np.array(later) > 0.9 * first).all()


LIGHT_N = 3.0


@pytest.fixture(scope="module")
def light_fingers(spec, rigid_response):
    """Frames of a flat finger of 16 mm pressed lightly at six places of face 3, and its forces (N)."""
    finger = {"kind": "cuboid", "size_mm": (16.0, 16.0), "turn_deg": (0.0, 0.3, 0.2)}
    frames = []
    for place in ((-12.0, -12.0), (0.0, -8.0), (10.0, -4.0), (-6.0, 2.0), (4.0, 6.0), (12.0, 12.0)):
        depth = 0.3
        for _ in range(4):
            counts, press = frame_of(spec, rigid_response, [Tip(3, *place)], depth, **finger)
            depth *= (LIGHT_N / press.force_n[0]) ** 0.7
        frames.append((counts, press.force_n[0]))
    return frames


def test_tips_that_may_be_a_light_finger_are_less_certain(reader, light_fingers):
    """The whole force is less certain than to a reader that knows no jaws, or hardly more."""
    sigmas = []
    for counts, _ in light_fingers:
        kinds = [each.read(counts[None])[0] for each in (reader, replace(reader, jaw_tables=()))]
        if not kinds[0].jaws[0]:
            sigmas.append([np.sqrt(np.nansum(read.covariance[0, :, 2, 2])) for read in kinds])
    either, tips = np.transpose(sigmas)
    assert (either > 0.8 * tips).all()
    assert np.sum(either > 1.2 * tips) >= 2


@pytest.fixture(scope="module")
def flat(spec, reader):
    """The reader of contacts that are known to be flat."""
    known = spec.changed(inversion=spec.inversion.model_copy(update={"probes": "flat"}))
    return replace(reader, model=replace(reader.model, spec=known))


def test_fingers_known_to_be_flat_are_never_sought_as_tips_again(spec, flat, rigid_response):
    tracker, sought = Tracker(flat), []
    tracker.feed(np.zeros(flat.model.channels))
    for depth in (0.2, 0.3, 0.45):  # to more than twice the force
        assert tracker.feed(fingers(spec, rigid_response, (0.0, 0.0), depth)[0]).jaws.all()
        sought.append(tracker.seen_anew)
    assert len(set(sought)) == 1


def test_fingers_known_to_be_flat_are_read_as_jaws(flat, light_fingers):
    for counts, force_n in light_fingers:
        read, _ = flat.read(counts[None])
        assert read.jaws.all()
        assert read.explained.all()
        assert abs(read.force_n[0, 0] - force_n) < 2 * np.sqrt(read.covariance[0, 0, 2, 2])


@pytest.mark.slow
def test_jaws_on_another_mesh_are_read(spec, reader):
    """Force within 5 %, centre of pressure within 1 mm, tilt within 2°."""
    other = spec.changed(mesh=MeshSpec(surface_edge_mm=1.8, edge_mm=4.4))
    response = build_response(tetrahedralize(other), other)
    assert (worst_of_poses(spec, reader, response) < [0.05, 1.0, 2.0]).all()
