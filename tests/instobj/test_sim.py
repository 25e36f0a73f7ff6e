"""Object in a simulator: what contacts, turning, relaxation and noise do to its counts."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from scipy.spatial.transform import Rotation

from design.errors import InputError
from design.layout.body import face_frame
from estimator.inversion.inversion import inversion
from estimator.inversion.storage import save_inversion
from estimator.signals.hall import full_scale_counts
from estimator.signals.presses import press_signals
from fem.presses.viscoelastic import relaxed_force_n
from instobj.sim import HallObject
from tests.support.mechanics.inverted import PULLING, inverted, presses, shear_of
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    target = tmp_path_factory.mktemp("sim") / "contacts.nc"
    save_inversion(inverted(), target)
    return target


@pytest.fixture
def cube(path):
    return HallObject(path, seed=None)


def on_face(cube, face, *places_mm):
    frame = face_frame(cube.spec, face)
    return np.stack([frame.to_object(np.array([*place, 0.0])) for place in places_mm])


def change(cube, points, force_n, **how):
    return cube.read(points, np.asarray(force_n, float), **how) - cube.rest_counts


def relative(a, b):
    return np.sqrt(np.mean((a - b) ** 2) / np.mean(b**2))


def test_one_contact_gives_the_signals_of_the_stored_presses(cube):
    model = inverted().model
    for face, place, force in ((1, (2.0, -3.0), 4.0), (3, (-8.0, 5.0), 1.5)):
        index = model.signals.faces.tolist().index(face)
        contact = np.array([[[*place, force]]])
        stored = model.singles(np.array([[index]]), contact)[0, 0, 0].reshape(-1, 3)
        assert relative(change(cube, on_face(cube, face, place), [force]), stored) < 0.01


def test_contacts_on_two_faces_add_up_and_interact_as_the_inversion_has_it(cube):
    model = inverted().model
    points = np.concatenate([on_face(cube, 1, (3.0, 3.0)), on_face(cube, 2, (-4.0, 6.0))])
    face, contact = np.array([[0, 1]]), np.array([[[3.0, 3.0, 5.0], [-4.0, 6.0, 3.0]]])
    summed = model.singles(face, contact)[0, :, 0].sum(axis=0) + model.interaction(face, contact)[0]
    assert relative(change(cube, points, [5.0, 3.0]), summed.reshape(-1, 3)) < 0.01


def test_a_contact_split_in_two_at_its_place_is_the_same_contact(cube):
    place = on_face(cube, 1, (1.0, 2.0))
    whole = change(cube, place, [6.0])
    assert relative(change(cube, np.repeat(place, 2, axis=0), [2.0, 4.0]), whole) < 1e-6
    near = on_face(cube, 1, (0.5, 2.0), (1.5, 2.0))
    assert relative(change(cube, near, [3.0, 3.0]), whole) < 0.05


@pytest.mark.parametrize("face", [1, 2, 3, 4, 5])
@pytest.mark.parametrize("sunk_mm", [0.0, 1.0])
def test_near_an_edge_the_face_is_felt_that_the_force_presses(cube, face, sunk_mm):
    """Faces share their edges, and in a simulator bodies sink in: the next face may be nearer."""
    frame = face_frame(cube.spec, face)
    half_mm = np.array(frame.half_extents_mm) - 0.3
    for share in ((1.0, 0.1), (-0.2, 1.0), (-1.0, 0.0), (0.4, -1.0), (1.0, 1.0)):
        place = np.append(half_mm * share, 0.0)
        sunk = place - [0.0, 0.0, sunk_mm]
        push = np.array([[0.0, 0.0, -4.0]]) @ frame.axes.T
        outermost = np.clip(place[:2], *cube_bounds())
        expected = change(cube, on_face(cube, face, outermost), push)
        assert abs(expected).max() > 20
        np.testing.assert_allclose(change(cube, frame.to_object(sunk[None]), push), expected)
        if not sunk_mm:
            normal = change(cube, frame.to_object(place[None]), [4.0])
            np.testing.assert_allclose(normal, expected)


def cube_bounds():
    """Smallest and largest places of the object's presses, mm."""
    return [bound[:2] for bound in inverted().model.bounds]


def test_nothing_touched_and_what_touches_an_unsensed_side_change_nothing(cube):
    assert not change(cube, np.empty((0, 3)), []).any()
    assert not change(cube, np.array([[0.0, 0.0, -21.0], [60.0, 0.0, 0.0]]), [5.0, 5.0]).any()


def test_the_ambient_field_turns_with_the_object(path):
    still = HallObject(path, ambient_ut=(0.0, 0.0, 50.0), seed=None)
    nothing = np.empty((0, 3)), np.empty(0)
    upright = still.read(*nothing) - still.rest_counts
    # turned by 180 degrees about x, the field comes from below: every channel changes its sign
    upside_down = still.read(*nothing, rotation=np.diag([1.0, -1.0, -1.0])) - still.rest_counts
    np.testing.assert_allclose(upside_down, -upright, atol=1e-9)
    strength_mt = np.linalg.norm(upright, axis=1) / still.spec.sensors.counts_per_mt
    np.testing.assert_allclose(strength_mt, 0.05, rtol=0.02)


def test_noise_is_the_chips_and_a_seed_repeats_it(path):
    nothing = np.empty((0, 3)), np.empty(0)
    one, other = HallObject(path, seed=3), HallObject(path, seed=3)
    frames = np.stack([one.read(*nothing) for _ in range(400)])
    np.testing.assert_array_equal(frames[0], other.read(*nothing))
    assert np.all(frames == np.round(frames))
    deviation = frames.std(axis=0).mean(axis=0)
    np.testing.assert_allclose(deviation, one.spec.sensors.noise_counts, rtol=0.05)


def test_readings_end_at_the_chips_range(path):
    place, force = np.array([[0.0, 0.0, 21.0]]), np.array([4.0])
    strong_ut = 1e6  # ten times what any chip reads
    most = full_scale_counts(HallObject(path).spec.sensors)
    read = HallObject(path, ambient_ut=(strong_ut, strong_ut, strong_ut)).read(place, force)
    np.testing.assert_array_equal(abs(read), most)


def test_a_held_force_on_relaxing_silicone_moves_magnets_on_as_its_prony_series_says(tmp_path):
    estimator = inverted()
    terms = ((0.2, 0.5),)
    silicone = estimator.model.spec.silicone.changed(prony=terms)
    soft = estimator.model.spec.changed(silicone=silicone)
    object.__setattr__(estimator.model, "spec", soft)
    save_inversion(estimator, tmp_path / "soft.nc")
    object.__setattr__(estimator.model, "spec", soft.changed(silicone=silicone.changed(prony=())))
    cube, elastic = HallObject(tmp_path / "soft.nc", seed=None), None
    place, step_s, time_s = on_face(cube, 1, (0.0, 0.0)), 0.01, np.arange(150) * 0.01
    travel = np.minimum(time_s / 0.2, 1.0) * 5.0
    felt = relaxed_force_n(travel, time_s, terms)
    for index, force in enumerate(felt):
        elastic = change(cube, place, [force], step_s=step_s if index else 0.0)
    fresh = HallObject(tmp_path / "soft.nc", seed=None)
    expected = change(fresh, place, [travel[-1]])
    assert felt[-1] < 0.85 * travel[-1], "the force has relaxed"
    assert relative(elastic, expected) < 0.01, "signals follow the travel"
    many = HallObject(tmp_path / "soft.nc", seed=None)
    for index, force in enumerate(felt):
        forces = np.array([[0.0], [force]])
        both = many.read(np.repeat(place[None], 2, 0), forces, step_s=step_s if index else 0.0)
    np.testing.assert_allclose(both - many.rest_counts, [0 * elastic, elastic], atol=1e-3)


def several(cube, objects=6, contacts=3, seed=0):
    """Contacts of several objects on their faces, some slots empty; forces; and how the objects lie."""
    rng = np.random.default_rng(seed)
    points = np.empty((objects, contacts, 3))
    for index in np.ndindex(objects, contacts):
        points[index] = on_face(cube, int(rng.integers(1, 6)), rng.uniform(-10, 10, 2))[0]
    force = rng.uniform(1, 6, (objects, contacts))
    force[::2, 1] = 0.0
    return points, force, Rotation.random(objects, random_state=seed).as_matrix()


def test_many_objects_at_once_read_as_one_by_one(path):
    cube = HallObject(path, ambient_ut=(10.0, -20.0, 45.0), seed=None)
    given = several(cube)
    single = np.stack([cube.read(*of_one) for of_one in zip(*given, strict=True)])
    assert abs(single - cube.rest_counts).max() > 50
    np.testing.assert_allclose(cube.read(*given), single, atol=1e-3)
    tensors = cube.read(*map(torch.as_tensor, given))
    assert isinstance(tensors, torch.Tensor)
    np.testing.assert_allclose(tensors.numpy(), single, atol=1e-3)


def test_a_thousand_objects_read_as_their_parts(cube):
    points, force, _ = several(cube, objects=1000, contacts=2, seed=1)
    last = cube.read(points[-30:], force[-30:])
    np.testing.assert_allclose(cube.read(points, force)[-30:], last, atol=1e-3)


def test_an_empty_slot_is_no_contact(cube):
    points, force, _ = several(cube)
    padded = np.concatenate([points, points[:, :1]], axis=1)
    none = np.concatenate([force, np.zeros((len(force), 1))], axis=1)
    np.testing.assert_allclose(cube.read(padded, none), cube.read(points, force), atol=1e-3)


POINT, FORCE = np.array([[1.0, 2.0, 21.0]]), np.array([4.0])


@pytest.mark.parametrize(
    ("points", "force", "how", "said"),
    [
        (POINT[0], FORCE, {}, r"shapes \(3,\) and \(1,\)"),
        (POINT, np.array([4.0, 3.0]), {}, r"shapes \(1, 3\) and \(2,\)"),
        (torch.tensor(POINT), torch.ones(1, 2), {}, r"shapes \(1, 3\) and \(1, 2\)"),
        (POINT.tolist(), FORCE.tolist(), {}, "points_mm is an array"),
        (POINT, FORCE, {"rotation": np.eye(4)}, r"got \(4, 4\)"),
        (POINT, FORCE, {"rotation": np.stack([np.eye(3)] * 2)}, r"got \(2, 3, 3\)"),
        (POINT, FORCE, {"step_s": -0.1}, "step_s .* -0.1"),
        (POINT * np.nan, FORCE, {}, "points_mm has what is no number"),
        (POINT, FORCE * np.inf, {}, "force_n has what is no number"),
    ],
)
def test_contacts_that_do_not_fit_are_one_error_and_leave_the_object_as_it_is(
    cube, points, force, how, said
):
    before = cube.read(POINT, FORCE, step_s=1.0)
    with pytest.raises(InputError, match=said):
        cube.read(points, force, **how)
    np.testing.assert_array_equal(cube.read(POINT, FORCE, step_s=1.0), before)


def test_an_ambient_field_has_three_components(path):
    with pytest.raises(InputError, match="got 2 numbers"):
        HallObject(path, ambient_ut=(10.0, 20.0))


def test_tensors_have_the_chips_noise_and_whole_counts(path):
    cube = HallObject(path, seed=3)
    points, force = torch.zeros((400, 0, 3)), torch.zeros((400, 0))
    first, second = cube.read(points, force), cube.read(points, force)
    assert torch.equal(first, first.round())
    deviation = (second - first).std(0).mean(0).numpy() / 2**0.5
    np.testing.assert_allclose(deviation, cube.spec.sensors.noise_counts, rtol=0.05)
    assert torch.equal(first, HallObject(path, seed=3).read(points, force))


def test_a_force_beyond_the_presses_is_read_as_their_largest(cube):
    largest = inverted().model.bounds[1][2]
    place = on_face(cube, 1, (1.0, 2.0))
    far, there = (change(cube, place, [force]) for force in (3 * largest, largest))
    np.testing.assert_allclose(far, there, rtol=1e-6)


def test_places_on_a_ball_are_found(tmp_path):
    ball = coarse_spec(
        name="ball",
        body={"kind": "sphere", "size_mm": (42, 42, 42), "bore_mm": 8},
        contact_grid={"count": (5, 5), "pitch_mm": 3.0},
    )
    forces, motions = synthetic_presses(ball)
    # on a ball the dimple does not reach the magnets of other faces
    motions = replace(motions, motion=np.nan_to_num(motions.motion))
    estimator = inversion(ball, forces, motions, press_signals(ball, forces, motions), 0.0, 0.0)
    save_inversion(estimator, tmp_path / "contacts.nc")
    cube, model = HallObject(tmp_path / "contacts.nc", seed=None), estimator.model
    for face, place in ((1, (4.0, -5.0)), (3, (-5.5, 2.0))):
        frame = face_frame(ball, face)
        at = frame.to_plane(np.array(place))
        for height in (0.0, -0.5):
            point = frame.to_object(np.array([[*at, height]]))
            contact = np.array([[[*place, 3.0]]])
            stored = model.singles(np.array([[face - 1]]), contact)[0, 0, 0].reshape(-1, 3)
            assert relative(change(cube, point, [3.0]), stored) < 0.02


def test_every_object_drifts_from_its_zero_until_it_is_reset(path):
    cube = HallObject(path, seed=5)
    points, force = np.zeros((300, 0, 3)), np.zeros((300, 0))

    def drift():
        frames = np.mean([cube.read(points, force) for _ in range(16)], axis=0)
        return (frames - cube.rest_counts).ravel()

    first, later = drift(), drift()
    cube.reset()
    zeroed = drift()
    drifts, noise = cube.spec.sensors.drift_counts, max(cube.spec.sensors.noise_counts)
    np.testing.assert_allclose([first.std(), zeroed.std()], drifts, rtol=0.03)
    assert (later - first).std() < noise
    assert abs(np.corrcoef(first, zeroed)[0, 1]) < 0.05


def test_warm_magnets_show_less_at_rest_and_under_a_contact(cube):
    place, share = on_face(cube, 1, (1.0, 2.0)), 1 - 0.0011 * 20
    nothing = np.empty((0, 3)), np.empty(0)
    warm_rest = cube.read(*nothing, warming_k=20.0)
    np.testing.assert_allclose(warm_rest, share * cube.rest_counts, rtol=1e-6)
    warm = cube.read(place, np.array([4.0]), warming_k=20.0) - warm_rest
    np.testing.assert_allclose(warm, share * change(cube, place, [4.0]), rtol=1e-6)
    both = cube.read(np.stack([place] * 2), np.full((2, 1), 4.0), warming_k=np.array([0.0, 20.0]))
    np.testing.assert_allclose(both[1] - warm_rest, warm, atol=1e-9)
    np.testing.assert_allclose(both[0] - cube.rest_counts, change(cube, place, [4.0]), atol=1e-9)


def test_frames_come_at_the_chips_rate_and_arrive_late(path):
    cube = HallObject(path, seed=None, delay_s=0.03)
    rate = cube.spec.sensors.frame_rate_hz
    place, step_s = on_face(cube, 1, (0.0, 0.0)), 0.001
    forces = np.linspace(0.5, 6.0, 1000)
    seen = [cube.read(place, np.array([f]), step_s=step_s)[1, 2] for f in forces]
    fresh = HallObject(path, seed=None)
    now = [fresh.read(place, np.array([f]))[1, 2] for f in forces]
    news = np.flatnonzero(np.diff(seen)) + 1
    np.testing.assert_allclose(np.diff(news) * step_s, 1 / rate, atol=1.5 * step_s)
    age = [index - now.index(seen[index]) for index in news]
    np.testing.assert_allclose(np.array(age) * step_s, 0.03, atol=1.5 * step_s)
    with pytest.raises(InputError, match="delay_s"):
        HallObject(path, delay_s=-1.0)


@pytest.fixture(scope="module")
def rubbed(tmp_path_factory):
    """The object with counts of tangential forces, and its model."""
    spec = PULLING
    estimator = inversion(spec, *presses(), model_error=0.0, force_error=0.0, shear=shear_of(spec))
    target = tmp_path_factory.mktemp("rubbed") / "contacts.nc"
    save_inversion(estimator, target)
    return HallObject(target, seed=None), estimator.model


@pytest.mark.parametrize("face", [1, 2, 3, 4, 5])
def test_friction_adds_what_tangential_forces_change(rubbed, face):
    cube, model = rubbed
    axes, place = face_frame(cube.spec, face).axes, on_face(cube, face, (2.0, -3.0))
    pressing = np.array([[0.0, 0.0, -5.0]]) @ axes.T
    rubbing = np.array([[1.5, -0.7, -5.0]]) @ axes.T
    np.testing.assert_allclose(cube.read(place, pressing), cube.read(place, np.array([5.0])))
    per_n = model.shear.values(np.array([face - 1]), np.array([[2.0, -3.0, 5.0]]))[0, 0]
    expected = np.array([1.5, -0.7]) @ per_n.reshape(2, -1)
    added = cube.read(place, rubbing) - cube.read(place, pressing)
    np.testing.assert_allclose(added.ravel(), expected, atol=1e-3)


def test_what_pulls_off_a_face_and_friction_without_its_table_change_nothing(rubbed, path):
    cube, plain = rubbed[0], HallObject(path, seed=None)
    place = on_face(cube, 1, (2.0, -3.0))
    assert cube.feels_friction
    assert not plain.feels_friction
    np.testing.assert_array_equal(cube.read(place, np.array([[2.0, 0.0, 5.0]])), cube.rest_counts)
    rubbed_too = plain.read(place, np.array([[2.0, 0.0, -5.0]]))
    np.testing.assert_allclose(rubbed_too, plain.read(place, np.array([5.0])))


def test_tensors_read_friction_and_warmth_as_arrays_do(rubbed):
    cube = rubbed[0]
    points, force, rotation = several(cube)
    vectors = np.random.default_rng(4).normal(0, 3, points.shape) * (force > 0)[..., None]
    warming = np.linspace(-5, 15, len(points))
    given = points, vectors, rotation
    arrays = cube.read(*given, warming_k=warming)
    tensors = cube.read(*map(torch.as_tensor, given), warming_k=torch.as_tensor(warming))
    assert abs(arrays - cube.rest_counts).max() > 50
    np.testing.assert_allclose(tensors.numpy(), arrays, atol=1e-3)


@pytest.mark.parametrize("kind", [np.asarray, torch.as_tensor])
def test_contacts_in_the_world_are_those_on_the_object(rubbed, kind):
    cube = rubbed[0]
    points, force, rotation = several(cube)
    vectors = np.random.default_rng(4).normal(0, 3, points.shape) * (force > 0)[..., None]
    position = np.random.default_rng(6).normal(0, 1, (len(points), 3))
    world = points * 1e-3 @ rotation.swapaxes(1, 2) + position[:, None]
    # slots without contact hold no number, as Isaac Lab has it
    world[force == 0], pushed = np.nan, vectors @ rotation.swapaxes(1, 2)
    seen = cube.read_world(*map(kind, (world, pushed, position, rotation)))
    np.testing.assert_allclose(np.asarray(seen), cube.read(points, vectors, rotation), atol=1e-3)


@pytest.mark.parametrize("cone", ["pyramidal", "elliptic"])
def test_contacts_of_mujoco_are_felt_where_they_are(path, cone):
    mujoco = pytest.importorskip("mujoco", reason="the simulator is not installed")
    cube = HallObject(path, seed=None)
    # a cube of 42 mm and 100 g hangs still under a ball that weighs 5 N
    scene = mujoco.MjModel.from_xml_string(f"""
        <mujoco><option timestep="0.002" cone="{cone}"/><worldbody>
          <body name="cube"><geom type="box" size="0.021 0.021 0.021"/></body>
          <body pos="0.004 0.002 0.0259"><joint type="slide" axis="0 0 1"/>
            <geom type="sphere" size="0.005" mass="0.5097"/></body>
        </worldbody></mujoco>""")
    data = mujoco.MjData(scene)
    for _ in range(1000):
        mujoco.mj_step(scene, data)
    seen = cube.read_mujoco(scene, data, "cube") - cube.rest_counts
    assert relative(seen, change(cube, on_face(cube, 1, (4.0, 2.0)), [5.0])) < 0.05


@pytest.mark.parametrize("cone", ["pyramidal", "elliptic"])
def test_friction_of_mujoco_is_felt(rubbed, cone):
    mujoco = pytest.importorskip("mujoco", reason="the simulator is not installed")
    cube = rubbed[0]
    # friction holds a ball that weighs 5 N against 1 N along x and -0.5 N along y
    scene = mujoco.MjModel.from_xml_string(f"""
        <mujoco><option timestep="0.001" cone="{cone}" impratio="100"/><worldbody>
          <body name="cube"><geom type="box" size="0.021 0.021 0.021" friction="0.9"/></body>
          <body pos="0.004 0.002 0.0259"><joint type="slide" axis="0 0 1"/>
            <joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/>
            <geom type="sphere" size="0.005" mass="0.5097" friction="0.9"/></body>
        </worldbody></mujoco>""")
    data = mujoco.MjData(scene)
    data.qfrc_applied[:] = [0.0, 1.0, -0.5]
    for _ in range(300):
        mujoco.mj_step(scene, data)
    seen = cube.read_mujoco(scene, data, "cube") - cube.rest_counts
    place = 1e3 * data.contact.pos[:1]
    expected = cube.read(place, np.array([[1.0, -0.5, -5.0]])) - cube.rest_counts
    frictionless = change(cube, place, [5.0])
    assert relative(frictionless, expected) > 0.1
    assert relative(seen, expected) < 0.03


@pytest.mark.parametrize("first", [True, False])
def test_a_contact_is_felt_whichever_of_its_bodies_mujoco_names_first(path, first):
    mujoco = pytest.importorskip("mujoco", reason="the simulator is not installed")
    cube = HallObject(path, seed=None)
    # MuJoCo names boxes in the order of the file; the small one weighs 5 N
    bodies = [
        '<body name="cube"><geom name="cube" type="box" size="0.021 0.021 0.021"/></body>',
        '<body pos="0.004 0.002 0.0219"><joint type="slide" axis="0 0 1"/>'
        '<geom type="box" size="0.001 0.001 0.001" mass="0.5097"/></body>',
    ]
    text = "".join(bodies if first else bodies[::-1])
    scene = mujoco.MjModel.from_xml_string(f"<mujoco><worldbody>{text}</worldbody></mujoco>")
    data = mujoco.MjData(scene)
    for _ in range(1000):
        mujoco.mj_step(scene, data)
    assert (data.contact.geom[:, 0] == scene.geom("cube").id).all() == first
    seen = cube.read_mujoco(scene, data, "cube") - cube.rest_counts
    assert relative(seen, change(cube, on_face(cube, 1, (4.0, 2.0)), [5.0])) < 0.05
