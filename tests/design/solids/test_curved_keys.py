"""Keys on curved cores: along the surface's normal, in core, shell, mould and mesh alike."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.body.meshes import manifold_of
from design.body.triangles import block_surface
from design.errors import InputError
from design.layout.blocks import core_keys, keys_volume_mm3
from design.layout.body import body_of, core_frames
from design.layout.surface import sealed_body_surface
from design.layout.volumes import sealed_volume_mm3
from design.mould.room import core_outside
from design.solids.booleans import convert_to_triangles, volume_mm3
from design.solids.core import make_core
from design.solids.sampled import sampled_core_part, sampled_shell
from design.solids.shell import make_shell
from fem.linear.core_interface import touches_core
from tests.support.objects.body_cases import body_spec
from tests.support.objects.shell_volume import cast_cavity, shell_volume_mm3

SIZE_MM, HEIGHT_MM = (2.5, 2.0), 1.5
BORED = {"open_faces": [6], "bore_mm": 9.0}
PLACES = {
    "cylinder": (-8.0, -5.5),
    "dome_on_core": (-6.0, -6.0),
    "sphere": (-6.0, -6.0),
    "capsule": (-6.0, -6.0),
    "ellipsoid": (-6.0, -6.0),
}


def keyed(name, *more, place=None, size=SIZE_MM, height=HEIGHT_MM):
    keys = {"positions_mm": [place or PLACES[name], *more], "size_mm": [*size, height]}
    return body_spec(name, core={"keys": keys}, **({"body": BORED} if name == "ellipsoid" else {}))


@pytest.mark.parametrize("name", PLACES)
def test_keys_stand_on_the_core_and_begin_in_it(name):
    spec, plain = keyed(name), body_spec(name, **({"body": BORED} if name == "ellipsoid" else {}))
    body = body_of(spec)
    for frame, key in zip(core_frames(spec), core_keys(spec), strict=True):
        low, high = key.corners_mm[:4], key.corners_mm[4:]
        assert body.core_distance_mm(low).max() < -0.3
        foot = frame.to_object(np.array([*PLACES[name], 0.0]))
        top = key.centre_mm + key.half_mm[2] * key.axes[:, 2]
        assert_allclose(np.linalg.norm(top - foot), HEIGHT_MM, rtol=0, atol=1e-6)
        assert_allclose(body.core_distance_mm(high).min(), HEIGHT_MM, rtol=0, atol=0.1)
    standing = np.prod(SIZE_MM) * HEIGHT_MM * len(core_keys(spec))
    assert standing < keys_volume_mm3(spec) < 1.2 * standing  # the core falls away under them
    assert_allclose(
        sealed_volume_mm3(plain) - sealed_volume_mm3(spec), keys_volume_mm3(spec), rtol=1e-9
    )


@pytest.mark.parametrize("name", PLACES)
def test_the_mesh_leaves_them_out_and_the_core_holds_the_silicone_there(name):
    spec = keyed(name)
    surface = sealed_body_surface(spec)
    assert surface.is_watertight
    assert_allclose(surface.volume, sealed_volume_mm3(spec), rtol=2e-3)
    side = np.stack(
        [key.centre_mm + key.half_mm * [0, 0, 1] @ key.axes.T for key in core_keys(spec)]
    )
    assert touches_core(side, spec).all()
    assert not touches_core(side, body_spec(name)).any()


@pytest.mark.parametrize(
    "name", ["cylinder", "dome_on_core", pytest.param("ellipsoid", marks=pytest.mark.slow)]
)
def test_core_shell_and_mould_agree(name):
    spec = keyed(name)
    sampled = body_of(spec).sampled
    shell = sampled_shell(spec) if sampled else make_shell(spec)
    core = convert_to_triangles(sampled_core_part(spec) if sampled else make_core(spec))
    assert_allclose(volume_mm3(shell), shell_volume_mm3(spec), rtol=2e-3)
    assert_allclose(volume_mm3(cast_cavity(spec)), volume_mm3(shell), rtol=1e-4)
    solid = manifold_of(core)
    for key in core_keys(spec):
        whole = manifold_of(block_surface(key))
        assert (whole - solid).volume() < 0.02 * whole.volume()
        assert (
            manifold_of(convert_to_triangles(core_outside(spec))) ^ whole
        ).volume() > 0.98 * whole.volume()


@pytest.mark.parametrize(
    ("name", "given", "told"),
    [
        ("sphere", {"place": (13.5, 0.0)}, "past the core's patch"),
        ("sphere", {"place": (2.0, 1.0)}, "a sensor's recess"),
        ("cylinder", {"place": (0.0, -2.0), "size": (1.0, 1.0)}, "the wire hole"),
        ("capsule", {"place": (-6.0, -6.0), "height": 8.5}, "must be below shell.thickness_mm"),
        (
            "cylinder",
            {"place": (1.0, -7.0), "height": 6.0, "size": (2.0, 6.0)},
            "into the pocket of",
        ),
        ("pad", {"place": (-9.0, -6.0)}, "filled to the rim"),
        ("hollow_dome", {"place": (-6.0, -6.0)}, "holds air"),
    ],
)
def test_keys_that_do_not_fit_are_refused(name, given, told):
    with pytest.raises(InputError, match=told):
        keyed(name, **given)


def test_two_keys_that_meet_are_refused():
    with pytest.raises(InputError, match="key 1 of face 1 meets key 2 of face 1"):
        keyed("sphere", (-6.0, -5.0))
