"""Contacts of a cube of 40 mm and their grasps over time, by hand."""

from dataclasses import replace

import numpy as np

from design.body.surface_chart import flat_frame
from estimator.grasps.damage import Sphere
from estimator.grasps.measures import Conditions
from estimator.grasps.track import ContactTrack, Placed

HALF_MM = 20.0
FACES = {face: flat_frame(face, np.full(3, HALF_MM)) for face in range(1, 7)}
CONDITIONS = Conditions(FACES, Sphere(0.4, 0.49, 5.0), 5.0)


def placed(faces, xy_mm, normal_n, tangential_n=None, sigma=0.0):
    """Contacts on the cube's faces; one standard deviation (mm and N) for all."""
    count = len(faces)
    xy = np.asarray(xy_mm, float)
    force = np.full((count, 3), np.nan)
    force[:, 2] = normal_n
    if tangential_n is not None:
        force[:, :2] = tangential_n
    point = np.array(
        [FACES[face].to_object(np.append(own, 0.0)) for face, own in zip(faces, xy, strict=True)]
    )
    axes = np.array([FACES[face].axes * [1, 1, -1] for face in faces])
    covariance = np.tile(np.eye(5) * sigma**2, (count, 1, 1))
    if tangential_n is None:
        covariance[:, 2:4, 2:4] = 0.0
    return Placed(np.asarray(faces), point, axes, force, covariance)


def squeeze(
    peak_n=10.0, shares=(1.0, 1.0), frames=60, rate_hz=10.0, sigma_n=0.1, slide_mm=0.0, faces=(3, 5)
):
    """Two jaws: rest, a straight rise over 1 s, a hold, a straight fall over 1 s, rest.

    The contact of the first face slides along x from the middle of the hold on.
    """
    time_s = np.arange(frames) / rate_hz
    shape = np.clip(np.minimum((time_s - 1.0), (frames / rate_hz - 1.0) - time_s), 0.0, 1.0)
    normal = peak_n * shape[:, None] * np.asarray(shares)
    face = np.where(normal > 0, np.asarray(faces), 0)
    xy = np.where(face[..., None] > 0, 0.0, np.nan) + np.zeros((frames, 2, 2))
    xy[frames // 2 :, 0, 0] += slide_mm
    force = np.full((frames, 2, 3), np.nan)
    force[..., 2] = np.where(face > 0, normal, np.nan)
    covariance = np.zeros((frames, 2, 5, 5))
    covariance[..., 4, 4] = np.where(face > 0, sigma_n**2, 0.0)
    explained, jaws = np.ones(frames, bool), np.zeros(frames, bool)
    return ContactTrack(time_s, face, xy, force, covariance, explained, jaws)


def joined(*tracks):
    """Tracks one after the other."""
    starts = np.cumsum([0.0, *(track.time_s[-1] + 0.1 for track in tracks[:-1])])
    later = [
        replace(track, time_s=track.time_s + start)
        for track, start in zip(tracks, starts, strict=True)
    ]
    return ContactTrack.joined(later)
