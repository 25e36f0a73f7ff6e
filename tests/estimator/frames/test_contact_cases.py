"""Contact cases of simulated recordings: how many, where, and what cannot be recorded."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.distance import pdist

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.tips import tip_positions_mm
from design.spec.learning import CollectionSpec
from design.spec.object import ObjectSpec
from estimator.frames.contact_cases import (
    GRASP_POSES,
    contact_groups,
    grasp_cases,
    opposed,
    paper_cases,
    probe_tips_mm,
    random_case,
    recorded_faces,
)
from tests.support.mechanics.synthetic_presses import coarse_spec

SENSED = ObjectSpec.model_validate({"name": "a", "body": {"sensed_faces": [1, 3]}})


def test_the_paper_counts_143_cases_a_face():
    spec = coarse_spec(contact_grid={"count": (10, 10), "pitch_mm": 3.0})
    cases = paper_cases(spec, 4)
    tips = np.array([len(case.face) for case in cases])
    assert np.bincount(tips).tolist() == [0, 100, 26, 14]
    assert len(cases) + spec.collection.non_contact_cases == 143
    assert len({case.place_id for case in cases}) == 140
    reach = np.vstack([case.xy_mm for case in cases])
    assert abs(reach).max() <= 21 - spec.indenter.radius_mm


def test_grasps_at_random_poses_keep_the_probes_and_the_grid():
    spec = ObjectSpec(
        name="cube", collection=CollectionSpec(kind="grasp", grasp_faces=(3, 5), random_grasps=30)
    )
    cases, grid = grasp_cases(spec), contact_grid(spec).xy_mm
    assert [len(case.face) for case in cases] == [2] * 30 + [4] * 30 + [6] * 30
    for case in cases:
        here = case.xy_mm[case.face == 3]
        assert np.all((here >= grid.min(axis=0)) & (here <= grid.max(axis=0)))
        probe = tip_positions_mm(len(here), spec.indenter.radius_mm)
        assert_allclose(pdist(here), pdist(probe), atol=1e-9)
    turns = [np.arctan2(*np.diff(case.xy_mm[:2], axis=0)[0]) for case in cases[30:60]]
    assert np.ptp(turns) > 3
    again = grasp_cases(spec.changed(seed=spec.seed + 1))
    assert not np.allclose(again[0].xy_mm, cases[0].xy_mm)


def test_a_thumb_presses_between_two_fingers_and_a_pad_alone():
    def cases_of(*faces):
        return grasp_cases(
            ObjectSpec(name="cube", collection=CollectionSpec(kind="handling", grasp_faces=faces))
        )

    frames = {frame.number: frame for frame in face_frames(ObjectSpec(name="cube"))}
    hands, pads = cases_of(3, 5, 5), cases_of(1)
    assert len(hands) == 5
    for case in hands:
        assert (case.face.tolist(), case.cell.tolist(), case.squeezed) == (
            [3, 5, 5],
            [0, 1, 1],
            True,
        )
        points = [
            frames[face].to_object(np.append(frames[face].to_plane(xy), 0.0))
            for face, xy in zip(case.face.tolist(), case.xy_mm, strict=True)
        ]
        # fingers that press alike balance the thumb: their middle lies over it
        assert_allclose(points[0][1:], np.mean(points[1:], axis=0)[1:], atol=1e-9)
        assert np.linalg.norm(points[1] - points[2]) == pytest.approx(15.0)
    assert len({case.place_id for case in [*hands, *pads]}) == len(hands) + len(pads)
    assert all(not case.squeezed and set(case.face.tolist()) == {1} for case in pads)


def test_jaws_on_a_ball_and_on_a_handle_press_opposite_places():
    """Along the surface: 8 mm on one side lie over 8 mm on the other, mirrored in one axis."""
    for kind, size in (("sphere", [44, 44, 44]), ("cylinder", [44, 44, 60])):
        body = {"kind": kind, "size_mm": size, "sensed_faces": [3, 5]}
        spec = ObjectSpec.model_validate({"name": kind, "body": body})
        (case,) = opposed(spec, [np.array([[8.0, -5.0]])])
        touched = [
            frame.to_object(np.append(frame.to_plane(xy), 0.0))
            for frame, xy in zip(face_frames(spec), case.xy_mm, strict=True)
        ]
        assert_allclose(case.xy_mm, [[8.0, -5.0], [8.0, 5.0]], atol=1e-6)
        assert_allclose(touched[0] * [-1, 1, 1], touched[1], atol=1e-6)


def collected(**changes):
    return SENSED.changed(collection=SENSED.collection.changed(**changes))


def test_an_object_with_fewer_faces_is_recorded_on_those_it_has():
    assert [group[0].face[0] for group in contact_groups(SENSED)] == [1, 3]
    case = random_case(collected(kind="continuous"), np.random.default_rng(0), 0, 1)
    assert case.face[0] in (1, 3)
    assert recorded_faces(collected(faces=(3,))) == [3]


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"faces": (3, 5)}, r"\[3, 5\] names faces without sensors; sensed are \[1, 3\]"),
        ({"kind": "continuous", "faces": (2,)}, "names faces without sensors"),
        ({"kind": "handling", "poses": (((0.0, 0.0, 0.0),), ())}, "as many of the second"),
        ({"kind": "handling", "poses": (((0, 0, 9.0),), ((0, 0, 0.0),))}, "turned ones"),
        ({"kind": "handling", "poses": ((), ()), "grasp_faces": (1,)}, r"grasp_faces = \[1\]"),
        ({"kind": "grasp"}, r"grasp_faces = \[3, 5\] are not both sensed"),
        ({"poses": (((0.0, 0.0, 0.0), (0.0, 20.0, 90.0)), ())}, "poses: the probe of 2 tips"),
        ({"poses": (((9.0, 0.0, 0.0),), ())}, r"poses: .* reaches beside face 1"),
    ],
)
def test_what_cannot_be_recorded_is_told_before_mechanics(changes, said):
    with pytest.raises(InputError, match=said):
        contact_groups(collected(**changes))


def test_grasps_of_the_paper_lie_evenly_over_the_face():
    one, two, three = GRASP_POSES
    corners = {(x, y, 0.0) for x in (-7.5, 7.5) for y in (-7.5, 7.5)}
    assert set(one) == {(0.0, 0.0, 0.0), *corners}
    assert two == ((0.0, 0.0, 0.0), (0.0, -9.0, 0.0), (9.0, 0.0, 90.0))
    assert three == ((0.0, -3.0, 0.0), (0.0, 3.0, 180.0))


@pytest.mark.parametrize("pose", [(1.0, -2.0, 0.0), (1.0, -2.0, 90.0), (0.5, 3.0, 30.0)])
@pytest.mark.parametrize("tips", [1, 2, 3])
def test_a_probe_is_turned_from_x_to_y_about_its_middle(tips, pose):
    spec = ObjectSpec(name="cube")
    x, y, turn = pose
    probe = tip_positions_mm(tips, spec.indenter.radius_mm) @ [1, 1j]
    found = probe_tips_mm(spec, tips, pose) @ [1, 1j]
    assert_allclose(found, probe * np.exp(1j * np.radians(turn)) + complex(x, y), atol=1e-12)


def test_every_case_has_a_number_of_its_face_its_probe_and_its_place():
    spec = collected(poses=(((0.0, 0.0, 0.0), (0.0, 0.0, 90.0)), ((0.0, 0.0, 0.0),)))
    count = len(contact_grid(spec))
    for face in (1, 3):
        cases = paper_cases(spec, face)
        ids = [case.place_id - 1000 * face for case in cases]
        assert ids == [*range(count), 100_000, 100_001, 200_000]
        for case in cases:
            assert case.face.tolist() == [face] * len(case.xy_mm)
            assert not case.cell.any()
            assert set(case.share.tolist()) == {1.0}
            assert not case.squeezed
    cube = ObjectSpec(name="cube")
    grasps = opposed(cube, [np.array([[1.0, 2.0]]), np.array([[1.0, 2.0], [16.0, 2.0]])])
    assert [case.place_id for case in grasps] == [303_000, 303_001]
    assert grasps[1].cell.tolist() == [0, 0, 1, 1]
    assert grasps[1].face.tolist() == [3, 3, 5, 5]
    assert all(case.squeezed and set(case.share.tolist()) == {1.0} for case in grasps)


def test_tips_anywhere_keep_apart_and_go_from_half_as_deep_as_the_first():
    spec = ObjectSpec(name="cube", collection=CollectionSpec(kind="continuous"))
    rng, radius = np.random.default_rng(0), spec.indenter.radius_mm
    cases = [random_case(spec, rng, 7, 3) for _ in range(60)]
    shares = np.array([case.share for case in cases])
    assert set(shares[:, 0].tolist()) == {1.0}
    assert 0.5 <= shares[:, 1:].min() < 0.55
    assert 0.95 < shares[:, 1:].max() <= 1.0
    grid = contact_grid(spec).xy_mm
    for case in cases:
        assert case.cell.tolist() == [0, 1, 2]
        assert case.place_id == 7
        assert np.all((case.xy_mm >= grid.min(axis=0)) & (case.xy_mm <= grid.max(axis=0)))
        for face in set(case.face.tolist()):
            assert pdist(case.xy_mm[case.face == face]).min(initial=np.inf) >= 2 * radius - 1e-9
    assert any(len(set(case.face.tolist())) < 3 for case in cases)
    places = np.concatenate([case.xy_mm for case in cases])
    assert_allclose(places.mean(axis=0), grid.mean(axis=0), atol=3)
    assert_allclose(np.ptp(places, axis=0), np.ptp(grid, axis=0), rtol=0.1)


def test_the_default_faces_need_not_all_be_there_but_one():
    """Faces that are named must all be sensed; those of the default are recorded where they are."""
    default = CollectionSpec().faces
    assert recorded_faces(collected()) == [face for face in default if face in (1, 3)]
    top = ObjectSpec.model_validate({"name": "a", "body": {"sensed_faces": [1]}})
    assert recorded_faces(top) == [1]
    with pytest.raises(InputError, match=r"\[2\] names faces without sensors; sensed are \[1\]"):
        recorded_faces(top.changed(collection=top.collection.changed(faces=(2,))))
