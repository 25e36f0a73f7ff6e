"""Steel by images, Earth's field, stray magnets: boundary conditions, closed forms, a real plate."""

import magpylib
import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.positions import magnet_layout, sensor_layout
from design.spec.object import ObjectSpec
from design.spec_io import parse_spec
from estimator.field.environment import Plate, environment, with_images
from estimator.field.forces import mirrored
from estimator.field.models import FieldModel
from estimator.field.sources import BlockMagnet, DiskMagnet, magnet_source
from estimator.signals.field_setup import scene, sensed_field, zero_motion
from estimator.signals.presses import press_signals, rest_counts
from estimator.signals.surroundings import surroundings, with_jaw
from tests.support.mechanics.magnet_poses import total_field
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

NORMAL = np.array([0.36, -0.48, 0.8])
PLACE = np.array([1.0, -2.0, 3.0])
BLOCK = FieldModel(BlockMagnet((6.0, 3.0), 2.0, 1.2), "exact")
DISK = FieldModel(DiskMagnet(6.0, 2.0, 1.2), "exact")


def beside_steel(points, model, permeability, image=True):
    """Field at points (n, 3) of one tilted magnet 9 mm above the steel."""
    plate = Plate(PLACE, NORMAL, (permeability - 1) / (permeability + 1))
    turn = Rotation.from_rotvec([0.5, 0.2, -1.1])
    given = (turn.apply([0.0, 0.0, 1.0]), turn.apply([1.0, 0.0, 0.0]))
    centre = PLACE + 9 * NORMAL
    field = with_images(
        tuple(points.T[:, None]),
        tuple(np.asarray(centre)[:, None, None]),
        tuple(given[0][:, None, None]),
        model,
        (plate,) if image else (),
        tuple(given[1][:, None, None]),
    )
    return np.stack(field, axis=1)


def points_on_the_surface(count=80):
    rng = np.random.default_rng(1)
    across = np.cross(NORMAL, [1.0, 0.0, 0.0])
    across /= np.linalg.norm(across)
    u, v = rng.uniform(-15, 15, (2, count, 1))
    return PLACE + u * across + v * np.cross(NORMAL, across)


@pytest.mark.parametrize("model", [DISK, BLOCK], ids=["disk", "block"])
@pytest.mark.parametrize("permeability", [3.0, 1000.0, 1e12])
def test_the_steels_surface_meets_maxwells_conditions(model, permeability):
    """In the steel the field is the magnet's own times 2μ/(μ+1): B along n and H across go over."""
    points = points_on_the_surface()
    outside = beside_steel(points, model, permeability)
    alone = beside_steel(points, model, permeability, image=False)
    inside = 2 * permeability / (permeability + 1) * alone
    size = np.linalg.norm(alone, axis=1)
    along = (outside - inside) @ NORMAL
    assert_allclose(along / size, 0, atol=1e-9)
    tangential = [b - np.outer(b @ NORMAL, NORMAL) for b in (outside, inside / permeability)]
    assert_allclose((tangential[0] - tangential[1]) / size[:, None], 0, atol=1e-9)


def plate_spec(gap_mm, permeability=1e12):
    plate = {"position_mm": [0, 0, 21 + gap_mm], "normal": [0, 0, -1]}
    plate["relative_permeability"] = permeability
    return ObjectSpec.model_validate({"name": "cube", "environment": {"steel_plates": [plate]}})


def dipole_field_at_sensors(spec):
    place = scene(spec)
    return sensed_field(
        place, zero_motion(place), FieldModel(magnet_source(spec.magnets), "multipole", 1)
    )[0]


def charged_panels(gap_mm, edge_mm, count=36):
    """Charges (T mm²/4π) of the panels of a square plate of infinite permeability over face 1, their places.

    The plate is an equipotential without net charge; panels are uniformly charged squares.
    """
    spec = ObjectSpec(name="cube")
    magnets, magnet, a = magnet_layout(spec), magnet_source(spec.magnets), edge_mm / count
    x = (np.arange(count) + 0.5) * a - edge_mm / 2
    panel = np.stack([*np.meshgrid(x, x), np.full((count, count), 21.0 + gap_mm)], -1).reshape(
        -1, 3
    )
    # ∫ dA / r of a square in its own plane: u ln(v + r) + v ln(u + r) between its corners
    u, v = np.meshgrid(*[np.arange(-count, count + 1) * a + a / 2] * 2, indexing="ij")
    r = np.hypot(u, v)
    corner = u * np.log(v + r) + v * np.log(u + r)
    of_square = corner[1:, 1:] - corner[:-1, 1:] - corner[1:, :-1] + corner[:-1, :-1]
    i, j = np.divmod(np.arange(count**2), count)
    mutual = of_square[i[:, None] - i + count - 1, j[:, None] - j + count - 1]
    away = panel[:, None] - magnets.centre_mm
    moment = magnet.polarization_t * magnet.volume_mm3 * magnets.axis
    potential = np.einsum("pmk,mk->p", away / np.linalg.norm(away, axis=2)[..., None] ** 3, moment)
    n = len(panel)
    system = np.block([[mutual, -np.ones((n, 1))], [np.ones((1, n)), np.zeros((1, 1))]])
    charge = np.linalg.solve(system, np.append(-potential, 0))[:n] * a * a / (4 * np.pi)
    return charge, panel


def panels_change(gap_mm, edge_mm):
    """Change of B at the sensors by such a plate."""
    charge, panel = charged_panels(gap_mm, edge_mm)
    reach = sensor_layout(ObjectSpec(name="cube")).position_mm[:, None] - panel
    return np.einsum("p,spk->sk", charge, reach / np.linalg.norm(reach, axis=2)[..., None] ** 3)


@pytest.mark.parametrize(
    ("gap_mm", "edge_mm", "excess"), [(0.0, 42, 0.09), (5.0, 42, 0.37), (5.0, 126, 0.054)]
)
def test_a_half_space_overstates_a_real_plate_as_stated(gap_mm, edge_mm, excess):
    bare = ObjectSpec(name="cube")
    half_space = dipole_field_at_sensors(plate_spec(gap_mm)) - dipole_field_at_sensors(bare)
    real = panels_change(gap_mm, edge_mm)
    own = slice(0, 3)
    error = abs(real - half_space)[own].max() / abs(half_space)[own].max()
    assert_allclose(error, excess, atol=0.02)
    assert np.linalg.norm(real[own]) < np.linalg.norm(half_space[own])


def pulls_on_dipoles(field_at):
    """Force (N) along z on each magnet of the paper's cube as a dipole, of a field that is given."""
    spec = ObjectSpec(name="cube")
    magnets, magnet, step = magnet_layout(spec), magnet_source(spec.magnets), 1e-3
    ahead, behind = (field_at(magnets.centre_mm + s * step * magnets.axis) for s in (1, -1))
    moment = magnet.polarization_t * magnet.volume_mm3 / (4e-7 * np.pi) * 1e-6
    return moment * (ahead - behind)[:, 2] / (2 * step)  # (m·∇) B_z


@pytest.mark.parametrize(
    ("gap_mm", "edge_mm", "excess"), [(0.0, 42, 0.0), (4.0, 42, 0.023), (10.0, 42, 0.32)]
)
def test_a_half_space_overstates_the_pull_of_a_real_plate_as_stated(gap_mm, edge_mm, excess):
    charge, panel = charged_panels(gap_mm, edge_mm, count=60)
    spec = plate_spec(gap_mm)
    plate, magnets = environment(spec).plates[0], magnet_layout(spec)

    def field_of_panels(points):
        reach = points[:, None] - panel
        return np.einsum("p,mpk->mk", charge, reach / np.linalg.norm(reach, axis=2)[..., None] ** 3)

    def field_of_images(points):
        images = mirrored(magnets, plate)
        model = FieldModel(magnet_source(spec.magnets), "multipole", 1)
        return total_field(points, images.centre_mm, images.axis, model)

    real, half_space = (pulls_on_dipoles(f)[:5] for f in (field_of_panels, field_of_images))
    assert (half_space > 0).all()
    # the panels' own error is 1.2 % on the touching plate, and falls with their area
    assert_allclose(1 - real.sum() / half_space.sum(), excess, atol=0.013)


def test_second_images_between_two_jaws_are_a_twenty_fifth_of_the_change():
    """The first image of face 3's side, mirrored once more in the jaw at face 5."""
    jaws = [
        {"position_mm": [x, 0, 0], "normal": [-np.sign(x), 0, 0], "relative_permeability": 1e12}
        for x in (21.0, -21.0)
    ]
    spec = ObjectSpec.model_validate({"name": "cube", "environment": {"steel_plates": jaws}})
    model = FieldModel(magnet_source(spec.magnets), "multipole", 1)
    magnets, points = magnet_layout(spec), tuple(sensor_layout(spec).position_mm.T[:, None])
    right, left = environment(spec).plates
    centre, axis = (tuple(a.T[:, :, None]) for a in (magnets.centre_mm, magnets.axis))
    first = (right.image_of_place(centre), right.image_of_moment(axis))
    both = with_images(points, *first, model, (left,))
    once = with_images(points, *first, model, ())
    change = dipole_field_at_sensors(spec) - dipole_field_at_sensors(ObjectSpec(name="cube"))
    left_out = abs(np.array(both) - np.array(once)).max() / abs(change).max()
    assert_allclose(left_out, 0.038, atol=0.004)


def turned_counts(spec, direction):
    """Change of every resting channel when Earth's field comes to lie along `direction`."""
    x, y, z = (spec.environment.earth_size_ut * direction).tolist()
    turned = spec.environment.model_copy(update={"earth_ut": (x, y, z)})
    return rest_counts(spec.model_copy(update={"environment": turned})) - rest_counts(spec)


def test_earths_field_adds_its_components_and_turning_changes_them_by_known_counts():
    direction = np.array([0.6, 0.0, -0.8])
    spec = ObjectSpec.model_validate(
        {"name": "c", "environment": {"earth_ut": (48 * direction).tolist()}}
    )
    added = rest_counts(spec) - rest_counts(ObjectSpec(name="c"))
    expected = 820 * 0.048 * sensor_layout(spec).axes @ direction
    assert_allclose(added, expected, atol=1e-8)
    assert_allclose(turned_counts(spec, -direction), -2 * expected, atol=1e-8)
    found = surroundings(spec, (10.0,))
    assert_allclose(found.turning_largest_counts, 2 * 820 * 0.048)
    turns = Rotation.random(4000, rng=np.random.default_rng(2)).apply(direction)
    sample = 820 * 0.048 * (turns[:2000, 0] - turns[2000:, 0])
    assert_allclose(np.sqrt(np.mean(sample**2)), found.turning_rms_counts, rtol=0.05)


def test_a_random_orientation_is_that_of_the_seed():
    around = {"earth_ut": 50}
    one, other = (
        environment(ObjectSpec.model_validate({"name": "c", "seed": seed, "environment": around}))
        for seed in (1, 2)
    )
    assert_allclose(np.linalg.norm([one.uniform_t, other.uniform_t], axis=1), 50e-6, rtol=1e-12)
    assert np.linalg.norm(one.uniform_t - other.uniform_t) > 5e-6


def test_a_stray_magnet_matches_magpylib_at_every_sensor():
    stray = {"position_mm": [45, -10, 20], "size_mm": [12, 6]}
    stray["remanence_t"] = [1.3 / 3, 2.6 / 3, -2.6 / 3]
    spec = ObjectSpec.model_validate({"name": "c", "environment": {"magnets": [stray]}})
    added = rest_counts(spec) - rest_counts(ObjectSpec(name="c"))
    # the demagnetising factor of a cylinder half as high as wide: 0.47449 (Chen, Brug & Goldfarb, 1991)
    polarization_t = 1.3 / (1 + 0.47449 * 0.05)
    magnet = magpylib.magnet.Cylinder(polarization=(0, 0, polarization_t), dimension=(12e-3, 6e-3))
    magnet.rotate(Rotation.align_vectors([[1, 2, -2]], [[0, 0, 1]])[0])
    magnet.position = np.array([45, -10, 20]) / 1e3
    layout = sensor_layout(spec)
    field = magnet.getB(layout.position_mm / 1e3)
    assert_allclose(added, 820e3 * np.einsum("sac,sc->sa", layout.axes, field), atol=1e-3)


def test_the_environment_changes_baselines_but_presses_only_through_steel():
    around = {"earth_ut": [0, 0, -50], "magnets": [{"position_mm": [60, 0, 0]}]}
    bare, within = coarse_spec(), coarse_spec(environment=around)
    plated = coarse_spec(
        environment={"steel_plates": [{"position_mm": [0, 0, 26], "normal": [0, 0, -1]}]}
    )
    presses = synthetic_presses(bare)
    signals = [press_signals(spec, *presses) for spec in (bare, within, plated)]
    assert abs(signals[1].baseline_counts - signals[0].baseline_counts).max() > 30
    assert_allclose(signals[1].delta_counts, signals[0].delta_counts, atol=1e-7)
    assert abs(signals[2].delta_counts - signals[0].delta_counts)[0].max() > 20


def test_jaws_change_their_own_faces_channels_most():
    spec = ObjectSpec(name="c")
    found = surroundings(spec, (0.0, 10.0))
    assert (found.jaw_counts > 1.2 * found.jaw_elsewhere_counts).all()
    assert (found.jaw_counts[:, 0] > 3 * found.jaw_counts[:, 1]).all()
    frame = face_frames(spec)[2]
    own = sensor_layout(spec).face == frame.number
    change = rest_counts(with_jaw(spec, frame, 0.0)) - rest_counts(spec)
    assert_allclose(abs(change[own]).max(), found.jaw_counts[2, 0])


@pytest.mark.parametrize(
    ("around", "message"),
    [
        ({"magnets": [{"position_mm": [20, 0, 0]}]}, r"magnets\[0\] .* may reach into the object"),
        (
            {"steel_plates": [{"position_mm": [0, 0, 18], "normal": [0, 0, -1]}]},
            r"steel_plates\[0\]: the object reaches 3 mm into the steel",
        ),
        (
            {
                "steel_plates": [{"position_mm": [0, 0, 30], "normal": [0, 0, -2]}],
                "magnets": [{"position_mm": [0, 0, 40]}],
            },
            "a stray magnet reaches 15.59 mm into the steel",
        ),
        ({"earth_ut": 500}, "earth_ut"),
        (
            {"steel_plates": [{"position_mm": [0, 0, 30], "normal": [0, 0, 0]}]},
            "normal must not be",
        ),
    ],
)
def test_what_cannot_stand_there_is_refused(around, message):
    with pytest.raises(InputError, match=message):
        parse_spec({"name": "c", "environment": around}, "test")
