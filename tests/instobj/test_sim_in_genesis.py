"""Object in Genesis: contacts of several environments are felt where they are."""

import numpy as np
import pytest

from estimator.inversion.storage import save_inversion
from instobj.sim import HallObject
from tests.support.mechanics.inverted import inverted

STEP_S = 0.002


@pytest.mark.slow
def test_a_ball_on_a_turned_object_is_felt_with_its_weight_in_every_environment(tmp_path):
    genesis = pytest.importorskip("genesis", reason="Genesis is not installed")
    torch = pytest.importorskip("torch")
    save_inversion(inverted(), tmp_path / "contacts.nc")
    hall = HallObject(tmp_path / "contacts.nc", seed=None)
    genesis.init(backend=genesis.cpu, logging_level="error")
    options = genesis.options.SimOptions(dt=STEP_S)
    scene = genesis.Scene(show_viewer=False, sim_options=options)
    # turned by 90° about x, so that a side face looks up
    cube = scene.add_entity(
        genesis.morphs.Box(size=(0.042,) * 3, pos=(0.1, 0, 0.3), euler=(90, 0, 0), fixed=True)
    )
    # a ball of radius 5 mm that weighs 5 N
    heavy = genesis.materials.Rigid(rho=0.5097 / (4 / 3 * np.pi * 0.005**3))
    scene.add_entity(genesis.morphs.Sphere(radius=0.005, pos=(0.104, 0.002, 0.326)), heavy)
    scene.build(n_envs=3)
    for _ in range(60):
        scene.step()
    contacts = cube.get_contacts()
    first = (contacts["geom_a"] >= cube.geom_start) & (contacts["geom_a"] < cube.geom_end)
    force = torch.where(first[..., None], contacts["force_a"], contacts["force_b"])
    force = force * contacts["valid_mask"][..., None]
    turn = genesis.utils.geom.quat_to_R(cube.get_quat())
    seen = hall.read_world(contacts["position"], force, cube.get_pos(), turn, STEP_S).numpy()
    # (0.004, 0.002, 0.021) from the middle in the world, pushed by 5 N downwards
    rotation = turn[0].numpy()
    point_mm, push_n = np.array([[4.0, 2.0, 21.0]]) @ rotation, np.array([[0, 0, -5.0]]) @ rotation
    expected = hall.read(point_mm, push_n) - hall.rest_counts
    assert abs(expected).max() > 50
    error = np.sqrt(np.mean((seen - hall.rest_counts - expected) ** 2) / np.mean(expected**2))
    assert error < 0.01
