"""Files for simulators: the same body in MJCF, URDF and USD; MuJoCo rests, squeezes, lifts and turns it."""

import re
from xml.etree import ElementTree

import numpy as np
import pytest
import trimesh
from scipy.spatial.transform import Rotation

from design.build.masses import masses_of, total
from design.build.parts import parts_of
from design.build.simulator_body import (
    ContactSpring,
    SimulatorBody,
    collision_pieces,
    frames_of,
    visual_surfaces,
)
from design.build.simulator_files import usd_text, write_simulator_files
from design.solids.booleans import TRIANGLES, convert_to_triangles
from tests.support.objects.body_cases import body_spec

SPRING = ContactSpring(2.5, 1.0, 3.0, 0.0014, 0.6, "as made for this test")


@pytest.fixture(scope="module")
def spec():
    return body_spec("two_open")


def body_for_simulators(spec):
    made = {part.name: part for part in parts_of(spec)[:2]}
    core, shell = (
        convert_to_triangles(made[name].make(), TRIANGLES, False) for name in ("core", "shell")
    )
    return SimulatorBody(
        name="my_object_2",
        mass=total(masses_of(spec).values()),
        visual=visual_surfaces(spec, core, shell),
        collision=collision_pieces(spec, core, 0.5, 8),
        frames=frames_of(spec),
        contact=SPRING,
    )


@pytest.fixture(scope="module")
def body(spec):
    return body_for_simulators(spec)


@pytest.fixture(scope="module")
def folder(body, tmp_path_factory):
    target = tmp_path_factory.mktemp("twin")
    write_simulator_files(body, target)
    return target


def numbers(text):
    return np.array([float(word) for word in re.findall(r"-?[\d.]+(?:e-?\d+)?", text)])


def in_files(folder, prim):
    """Mass (kg), centre (m), inertia (kg m²) and one named frame as each file has them."""
    mjcf = ElementTree.parse(folder / "my_object_2.xml").getroot()
    inertial = mjcf.find("worldbody/body/inertial")
    xx, yy, zz, xy, xz, yz = numbers(inertial.get("fullinertia"))
    site = mjcf.find(f"worldbody/body/site[@name='{prim}']")
    frame = Rotation.from_quat(numbers(site.get("quat")), scalar_first=True)
    yield (
        float(inertial.get("mass")),
        numbers(inertial.get("pos")),
        np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]),
        (numbers(site.get("pos")), frame.as_matrix()),
    )
    urdf = ElementTree.parse(folder / "my_object_2.urdf").getroot()
    inertial, origin = urdf.find("link/inertial"), urdf.find(f"joint[@name='{prim}_joint']/origin")
    entry = {name: float(value) for name, value in inertial.find("inertia").items()}
    frame = Rotation.from_euler("xyz", numbers(origin.get("rpy")))
    yield (
        float(inertial.find("mass").get("value")),
        numbers(inertial.find("origin").get("xyz")),
        np.array([[entry[f"i{min(a, b)}{max(a, b)}"] for b in "xyz"] for a in "xyz"]),
        (numbers(origin.get("xyz")), frame.as_matrix()),
    )
    text = (folder / "my_object_2.usda").read_text()
    value = {
        name: numbers(re.search(rf"physics:{name} = (.*)", text)[1])
        for name in ("mass", "centerOfMass", "diagonalInertia", "principalAxes")
    }
    axes = Rotation.from_quat(value["principalAxes"], scalar_first=True).as_matrix()
    block = text[text.index(f'def Xform "{prim}"') :]
    place, turn = (
        numbers(re.search(rf"xformOp:{name} = (.*)", block)[1]) for name in ("translate", "orient")
    )
    yield (
        float(value["mass"][0]),
        value["centerOfMass"],
        axes @ np.diag(value["diagonalInertia"]) @ axes.T,
        (place, Rotation.from_quat(turn, scalar_first=True).as_matrix()),
    )


@pytest.mark.parametrize("prim", ["sensor_1", "sensor_4", "magnet_3"])
def test_the_three_files_have_the_same_mass_inertia_and_frames(body, folder, prim):
    place, axes = body.frames[prim]
    for mass, centre, inertia, frame in in_files(folder, prim):
        assert mass == pytest.approx(body.mass.mass_g / 1e3, rel=1e-8)
        np.testing.assert_allclose(1e3 * centre, body.mass.centre_mm, atol=1e-6)
        np.testing.assert_allclose(1e9 * inertia, body.mass.inertia_g_mm2, atol=0.1)
        np.testing.assert_allclose(1e3 * frame[0], place, atol=1e-6)
        np.testing.assert_allclose(frame[1], axes, atol=1e-7)


def test_frames_are_those_of_chips_and_magnets(spec):
    frames = frames_of(spec)
    assert len(frames) == len(spec.body.sensed) * (1 + spec.sensors.count_per_face)
    for _, axes in frames.values():
        np.testing.assert_allclose(axes.T @ axes, np.eye(3), atol=1e-12)
        assert np.linalg.det(axes) == pytest.approx(1.0)


def test_every_mesh_that_files_name_is_there_and_fills_its_part(body, folder):
    urdf = ElementTree.parse(folder / "my_object_2.urdf").getroot()
    named = {mesh.get("filename") for mesh in urdf.iter("mesh")}
    mjcf = ElementTree.parse(folder / "my_object_2.xml").getroot()
    assert named == {f"meshes/{mesh.get('file')}" for mesh in mjcf.iter("mesh")}
    for name in named:
        mesh = trimesh.load_mesh(folder / name)
        expected = body.meshes[name.removeprefix("meshes/").removesuffix(".stl")]
        assert mesh.volume == pytest.approx(expected.volume, rel=1e-5)


def test_the_usd_has_balanced_brackets_and_all_triangles(body):
    text = usd_text(body)
    for left, right in ("{}", "[]", "()"):
        assert text.count(left) == text.count(right)
    for surface in body.meshes.values():
        assert f"[{', '.join(['3'] * len(surface.faces))}]" in text


def test_the_usd_opens_with_its_mass_and_meshes(body, folder):
    reason = "usd-core is not installed"
    usd, geom, physics = (
        pytest.importorskip(f"pxr.{name}", reason=reason)
        for name in ("Usd", "UsdGeom", "UsdPhysics")
    )
    stage = usd.Stage.Open(str(folder / "my_object_2.usda"))
    top = stage.GetDefaultPrim()
    mass = physics.MassAPI(top)
    assert mass.GetMassAttr().Get() == pytest.approx(body.mass.mass_g / 1e3, rel=1e-6)
    meshes = [prim for prim in top.GetChildren() if prim.IsA(geom.Mesh)]
    assert {prim.GetName() for prim in meshes} == set(body.meshes)


@pytest.fixture
def mujoco():
    return pytest.importorskip("mujoco", reason="the simulator is not installed")


def scene(mujoco, folder, others, actuators=""):
    """The object among other bodies, and its first coordinate."""
    text = (folder / "my_object_2.xml").read_text()
    text = text.replace('meshdir="meshes"', f'meshdir="{folder / "meshes"}"')
    text = text.replace("<worldbody>", f"<worldbody>{others}")
    text = text.replace("</mujoco>", f"<actuator>{actuators}</actuator></mujoco>")
    model = mujoco.MjModel.from_xml_string(text)
    joint = model.body_jntadr[model.body("my_object_2").id]
    return model, mujoco.MjData(model), model.jnt_qposadr[joint]


def settle(mujoco, model, data, seconds, control=0, change=0.0):
    """Steps, while one control moves evenly by a change."""
    steps = int(seconds / model.opt.timestep)
    for _ in range(steps):
        if change:
            data.ctrl[control] += change / steps
        mujoco.mj_step(model, data)


def test_mujoco_has_the_mass_and_the_inertia(mujoco, body, folder):
    model, _, _ = scene(mujoco, folder, "")
    number = model.body("my_object_2").id
    assert model.body_mass[number] == pytest.approx(body.mass.mass_g / 1e3, rel=1e-6)
    turn = Rotation.from_quat(model.body_iquat[number], scalar_first=True).as_matrix()
    inertia = turn @ np.diag(model.body_inertia[number]) @ turn.T
    np.testing.assert_allclose(1e9 * inertia, body.mass.inertia_g_mm2, atol=0.1)


def test_mujoco_reads_the_urdf_as_it_was_meant(mujoco, body, folder, tmp_path):
    """Hung on a world by a floating joint: a first link would stand fast and lose its mass."""
    (tmp_path / "meshes").symlink_to(folder / "meshes")
    hung = """<mujoco><compiler fusestatic="false"/></mujoco><link name="world"/>
      <joint name="free" type="floating"><parent link="world"/><child link="my_object_2"/></joint>
      </robot>"""
    text = (folder / "my_object_2.urdf").read_text().replace("</robot>", hung)
    (tmp_path / "hung.urdf").write_text(text)
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "hung.urdf"))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    number = model.body("my_object_2").id
    assert model.body_mass[number] == pytest.approx(body.mass.mass_g / 1e3, rel=1e-6)
    np.testing.assert_allclose(1e3 * model.body_ipos[number], body.mass.centre_mm, atol=1e-5)
    assert model.ngeom == len(body.collision.pieces)
    for name, (place, axes) in body.frames.items():
        frame = data.body(name)
        np.testing.assert_allclose(1e3 * frame.xpos, place, atol=1e-5)
        np.testing.assert_allclose(frame.xmat.reshape(3, 3), axes, atol=1e-6)


def test_the_object_rests_on_a_table(mujoco, folder):
    model, data, start = scene(mujoco, folder, '<geom type="plane" size="1 1 .1"/>')
    data.qpos[start + 2] = 0.0235
    settle(mujoco, model, data, 2.0)
    assert abs(data.qvel).max() < 1e-3
    # it stands on its lower face, 46 mm high
    assert data.qpos[start + 2] == pytest.approx(0.023, abs=2e-4)
    assert abs(data.qpos[start + 4 : start + 7]).max() < 1e-2


@pytest.mark.parametrize("kind", ["pad", "hollow_dome", "solid_dome"])
def test_a_body_on_a_base_stands_on_it(mujoco, kind, tmp_path):
    spec = body_spec(kind)
    write_simulator_files(body_for_simulators(spec), tmp_path)
    model, data, start = scene(mujoco, tmp_path, '<geom type="plane" size="1 1 .1"/>')
    half_m = 1e-3 * spec.body.size_mm[2] / 2
    data.qpos[start + 2] = half_m + 2e-4
    settle(mujoco, model, data, 2.0)
    assert data.qpos[start + 2] == pytest.approx(half_m, abs=1e-4)
    assert abs(data.qpos[start + 4 : start + 6]).max() < 1e-2, "it leans"


def test_under_its_weight_a_ball_sinks_in_as_the_spring_says(mujoco, body, folder, tmp_path):
    guided = tmp_path / "my_object_2.xml"
    text = (folder / "my_object_2.xml").read_text()
    # what cannot turn does not roll off the ball
    slides = (f'<joint type="slide" axis="{axis}"/>' for axis in ("0 0 1", "0 1 0", "1 0 0"))
    guided.write_text(text.replace("<freejoint/>", "".join(slides)))
    (tmp_path / "meshes").symlink_to(folder / "meshes")
    model, data, start = scene(mujoco, tmp_path, '<geom type="sphere" size=".005"/>')
    data.qpos[start] = touching = 0.023 + 0.005
    settle(mujoco, model, data, 2.0)
    weight_n = body.mass.mass_g / 1e3 * 9.81
    sunk_mm = 1e3 * (touching - data.qpos[start])
    assert sunk_mm == pytest.approx(weight_n / SPRING.n_per_mm, rel=0.01)


HAND = """<geom type="plane" size="1 1 .1"/>
  <body pos="0 0 .023" gravcomp="1"><joint name="lift" type="slide" axis="0 0 1"/>
    <joint name="turn" type="hinge" axis="1 0 0"/>
    <geom type="sphere" size=".001" mass="2" contype="0" conaffinity="0"/>
    <body gravcomp="1"><joint name="left" type="slide" axis="1 0 0"/>
      <geom type="box" size=".005 .012 .012" pos="-.0275 0 0" mass="2"/></body>
    <body gravcomp="1"><joint name="right" type="slide" axis="-1 0 0"/>
      <geom type="box" size=".005 .012 .012" pos=".0275 0 0" mass="2"/></body></body>"""
MOTORS = """<position joint="lift" kp="20000" dampratio="1"/>
  <position joint="turn" kp="200" dampratio="1"/>
  <motor joint="left"/><motor joint="right"/>"""


def test_two_jaws_squeeze_lift_and_turn_the_object(mujoco, folder):
    model, data, start = scene(mujoco, folder, HAND, MOTORS)
    data.qpos[start + 2] = 0.023
    data.ctrl[2:] = 6.0
    settle(mujoco, model, data, 1.0)
    settle(mujoco, model, data, 1.0, control=0, change=0.1)
    settle(mujoco, model, data, 0.5)
    assert data.qpos[start + 2] == pytest.approx(0.123, abs=5e-4)
    settle(mujoco, model, data, 1.0, control=1, change=0.5)
    settle(mujoco, model, data, 0.5)
    turned = Rotation.from_quat(data.qpos[start + 3 : start + 7], scalar_first=True)
    np.testing.assert_allclose(turned.as_rotvec(), [0.5, 0, 0], atol=0.05)
    assert data.qpos[start + 2] == pytest.approx(0.123, abs=5e-4), "it has not slipped"


def test_jaws_that_hardly_squeeze_leave_the_object_where_it_is(mujoco, folder):
    model, data, start = scene(mujoco, folder, HAND, MOTORS)
    data.qpos[start + 2] = 0.023
    # weight 0.69 N, two jaws, friction 0.6: less than 0.57 N holds it not
    data.ctrl[2:] = 0.4
    settle(mujoco, model, data, 1.0)
    settle(mujoco, model, data, 1.0, control=0, change=0.1)
    assert data.qpos[start + 2] < 0.03
