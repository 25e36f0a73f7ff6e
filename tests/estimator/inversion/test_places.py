"""Contact points of a simulator on the faces of a body: found on the face that holds them, and where."""

import numpy as np
import pytest

from design.layout.body import face_frames
from estimator.inversion.model.places import surface_places
from tests.support.objects.body_cases import body_spec


@pytest.mark.parametrize(
    ("kind", "farthest_mm"),
    [("closed_box", 0.15), ("capsule", 0.3), ("sphere", 0.3), ("ellipsoid", 0.4), ("dome_on_core", 0.15)],
)  # fmt: skip
def test_every_point_of_a_face_is_found_where_it_lies(kind, farthest_mm):
    spec, rng = body_spec(kind), np.random.default_rng(0)
    frames = [frame for frame in face_frames(spec) if frame.number in spec.body.sensed]
    places = surface_places(frames)
    for frame in frames:
        # out to 99 % of a patch's border; patches of the capsule and the ellipsoid overlap there
        xy = rng.uniform(-0.99, 0.99, (2000, 2)) * frame.half_extents_mm
        xy = xy[frame.covers(xy / 0.99)]
        points, inwards = frame.to_object(np.pad(xy, ((0, 0), (0, 1)))), -frame.axes_at(xy)[..., 2]
        for push in (inwards, 0 * inwards):
            face, place_mm, _ = places.nearest(points, push)
            assert (face >= 0).all()
            for index, other in enumerate(frames):
                on_it = face == index
                again = np.pad(other.to_plane(place_mm[on_it]), ((0, 0), (0, 1)))
                away_mm = np.linalg.norm(other.to_object(again) - points[on_it], axis=1)
                assert away_mm.max(initial=0.0) < farthest_mm
