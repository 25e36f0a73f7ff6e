"""Geometry that follows from a specification is worked out once, and never for another one."""

import gc
import sys
from collections import Counter

import numpy as np
import pytest

from design.build.parts import parts_of
from design.layout.body import core_frames, face_frames
from design.layout.places.positions import magnet_layout
from design.layout.pockets import shell_pockets
from design.spec import cached_geometry
from design.spec.object import ObjectSpec
from tests.support.objects.body_cases import body_spec

WATCHED = {
    "face_frames", "core_frames", "shell_pockets", "core_pockets", "magnet_bodies", "sensor_places",
    "mould_frame", "parting", "locators", "core_keys", "relief_slits", "flanges", "loose_pins",
}  # fmt: skip


def derivations(spec):
    """How often each function of `WATCHED` ran on each specification while all parts were made."""
    runs, seen = Counter(), []

    def watch(frame, event, _):
        code = frame.f_code
        if event == "call" and code.co_name in WATCHED and "/design/" in code.co_filename:
            asked = frame.f_locals["spec"]
            seen.append(asked)  # kept alive, so that no other one gets its identity
            runs[code.co_name, id(asked)] += 1

    sys.setprofile(watch)
    try:
        for part in parts_of(spec):
            part.make()
    finally:
        sys.setprofile(None)
    return runs


@pytest.mark.parametrize("kind", ["two_open", "solid_dome"])
def test_each_derivation_runs_once_while_the_parts_are_made(kind):
    spec = body_spec(kind)
    fresh = ObjectSpec.model_validate(spec.model_dump())  # nothing is kept for it yet
    runs = derivations(fresh)
    assert {name for name, _ in runs} >= {"mould_frame", "face_frames", "shell_pockets"}
    assert max(runs.values()) == 1, runs


def test_a_changed_specification_has_its_own_geometry():
    spec = ObjectSpec(name="cube")
    before = face_frames(spec)[0].centre_mm[2], magnet_layout(spec).centre_mm[0, 2]
    wider = spec.changed(body=spec.body.changed(size_mm=(42.0, 42.0, 46.0)))
    copied = spec.model_copy(update={"body": wider.body})
    for other in (wider, copied):
        assert face_frames(other)[0].centre_mm[2] == before[0] + 2
        assert magnet_layout(other).centre_mm[0, 2] == before[1] + 2
    assert face_frames(spec)[0].centre_mm[2] == before[0]
    assert face_frames(spec) is face_frames(spec)


def test_what_is_shared_cannot_be_overwritten():
    spec = ObjectSpec(name="cube")
    pocket = shell_pockets(spec)[0][0]
    shared = (core_frames(spec)[1].normal, magnet_layout(spec).centre_mm, pocket.body.centre_mm)
    for array in shared:
        with pytest.raises(ValueError, match="read-only"):
            np.add(array, 1.0, out=array)


def test_nothing_is_kept_for_a_specification_that_is_gone():
    spec = ObjectSpec(name="cube")
    face_frames(spec)
    key = id(spec)
    assert key in cached_geometry.KEPT_RESULTS
    del spec
    gc.collect()
    assert key not in cached_geometry.KEPT_RESULTS
