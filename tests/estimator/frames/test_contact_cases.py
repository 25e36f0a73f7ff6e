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
        ({"kind": "grasp"}, r"grasp_faces = \[3, 5\] are not both sensed"),
        ({"dual_poses": ((0.0, 0.0, 0.0), (0.0, 20.0, 90.0))}, "dual_poses: the probe of 2 tips"),
        ({"dual_poses": ((9.0, 0.0, 0.0),)}, r"dual_poses: .* reaches beside face 1"),
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
