"""Findings of chips, whole, from chips and an Earth's field made up by hand."""

from dataclasses import replace

import numpy as np
from numpy.testing import assert_allclose

from design.spec.object import ObjectSpec
from instobj.bench.bringup.diagnosis import chip_findings
from instobj.bench.bringup.diagnosis.earth import EarthFound
from instobj.bench.bringup.diagnosis.findings import HALF_95, ChipFound, Finding, channel_name
from instobj.bench.bringup.diagnosis.poles import MagnetFound, magnet_findings
from tests.support.new_objects import SMALL

SPEC = ObjectSpec.model_validate(
    {"name": "cube", "tolerances": {"sensor_gain_relative": 0.03, "sensor_rotation_deg": 2.0}}
)
CHIPS = 15


def about_z(degrees):
    c, s = np.cos(np.deg2rad(degrees)), np.sin(np.deg2rad(degrees))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])


def chips(**changed):
    """Fifteen sound chips with gains known to ±0.0196; `changed` by c<number>."""
    sound = ChipFound(0, np.eye(3), np.ones(3), np.full(3, 0.0196), 1.0, 0.00196)
    found = [replace(sound, site=site) for site in range(CHIPS)]
    for name, change in changed.items():
        found[int(name[1:])] = replace(found[int(name[1:])], **change)
    return found


def told(found, earth=None):
    return [
        (one.kind, one.where, one.measured)
        for one in chip_findings.chip_findings(SPEC, found, earth)
    ]


def test_sound_chips_are_not_mentioned():
    assert told(chips()) == []
    assert told(chips(c4={"turn": about_z(11.9)})) == []


def test_exchanged_turned_mirrored_and_silent_chips_are_named_with_how_they_read():
    found = chips(
        c0={"site": 1}, c1={"site": 2}, c2={"site": 0}, c4={"turn": about_z(-90)},
        c5={"turn": np.diag([1.0, 1.0, -1.0])}, c6={"dead": (True, True, True)},
        c7={"dead": (False, True, False)},
    )  # fmt: skip
    assert told(found) == [
        (
            "swapped chips",
            "F1-S1 and F1-S2 and F1-S3",
            "F1-S1 sits at F1-S2, F1-S2 sits at F1-S3, F1-S3 sits at F1-S1",
        ),
        ("turned chip", "F2-S2", "by 90° from the drawing; it reads (Y, −X, Z) for X, Y, Z"),
        ("mirrored chip", "F2-S3", "it reads (X, Y, −Z) for X, Y, Z"),
        ("silent chip", "F3-S1", "no answer of any axis to a magnet"),
        ("dead axis", "F3-Y2", "no answer to a magnet"),
    ]
    assert found[5].angle_deg == 180.0
    assert chip_findings.is_turned(SPEC, chips(c0={"turn": about_z(12.1)})[0])


def test_gains_beyond_tolerance_and_measurement_are_named_by_chip_or_axis():
    whole = 4.2 * np.hypot(0.03 / np.sqrt(3), 0.001)
    axis = 4.2 * np.hypot(0.03, 0.01)
    assert (
        told(
            chips(
                c3={"mean_gain": 1 + 0.999 * whole}, c8={"gain": np.array([1, 1 - 0.999 * axis, 1])}
            )
        )
        == []
    )
    over = chips(
        c3={"mean_gain": 1 + 1.001 * whole}, c8={"gain": np.array([1, 1 - 1.001 * axis, 1])}
    )
    assert told(over) == [
        ("gain", "F2-S1", f"{1 + 1.001 * whole:.3f} ± 0.002 of the others', all axes"),
        ("gain", "F3-Y3", f"{1 - 1.001 * axis:.3f} ± 0.020 of the others'"),
    ]


def earth(**changed):
    sound = EarthFound(
        48.0, 4.0, np.zeros((CHIPS, 3)), np.full((CHIPS, 3), 2.0),
        np.full((CHIPS, 3), 1.1), np.full((CHIPS, 3), 0.0392), 0.5,
    )  # fmt: skip
    return replace(sound, **changed)


def test_gains_of_holds_and_of_earths_field_count_by_their_precision():
    field = earth(gain=np.where(np.arange(CHIPS)[:, None] == 2, 1.32, 1.1) * np.ones((CHIPS, 3)))
    gain, sd = chip_findings.combined_gains(chips(), field)
    assert_allclose(gain[2], (1e4 * 1.0 + 0.25e4 * 1.2) / 1.25e4)
    assert_allclose(sd, 1 / np.sqrt(1.25e4))
    of_chip, chip_sd = chip_findings.findings_of_chips(chips(), field)
    mean_sd = 0.02 * np.sqrt(3) / 3
    assert_allclose(
        of_chip[2], (1.0 / 0.001**2 + 1.2 / mean_sd**2) / (1 / 0.001**2 + 1 / mean_sd**2)
    )
    assert_allclose(chip_sd, 1 / np.sqrt(1 / 0.001**2 + 1 / mean_sd**2))
    assert len(chip_findings.wide_gains(SPEC, chips(), None)) == CHIPS  # tolerance alone hides 1.1
    together = 0.1 / (4.2 + 2.0)
    widest = np.sqrt(np.maximum(together**2 - 0.03**2 / np.array([1, 2, 3]), 0))
    assert_allclose(chip_findings.widest_gain_sd(SPEC, np.array([0, 2, 3])), widest[[0, 1, 2]])
    finer = SPEC.changed(tolerances=SPEC.tolerances.changed(sensor_gain_relative=0.01))
    limit = np.sqrt(together**2 - 0.01**2 / 3) * HALF_95
    wide = chips(c1={"mean_gain_interval": 1.001 * limit}, c2={"mean_gain_interval": 0.999 * limit})
    assert chip_findings.wide_gains(finer, wide, None) == ["F1-S2"]


def test_offsets_and_a_field_that_is_not_earths_are_named():
    sensors, tolerances = SPEC.sensors, SPEC.tolerances
    allowed = np.hypot(
        sensors.counts_per_mt * 1e-3 * tolerances.sensor_offset_ut, sensors.drift_counts
    )
    offset = np.zeros((CHIPS, 3))
    offset[1, 2], offset[2, 0] = -5.001 * allowed, 4.999 * allowed
    found = list(chip_findings.earth_findings(SPEC, earth(offset=offset)))
    assert found == [Finding("offset", "F1-Z2", f"{-5.001 * allowed:+.0f} ± 2 counts")]
    for field, misfit, wrong in (
        (19.1, 0.5, False),
        (18.9, 0.5, True),
        (70.9, 3.0, False),
        (71.1, 0.5, True),
        (48.0, 3.1, True),
    ):
        told = list(chip_findings.earth_findings(SPEC, earth(field_ut=field, misfit=misfit)))
        assert bool(told) == wrong
    assert str(told[0]) == (
        "surroundings: Earth's field; 48 ± 4 µT, Earth's is 25 to 65; misfit 3.1"
    )
    assert channel_name("F3-S2", 0) == "F3-X2"


def test_magnets_are_weak_flipped_or_misplaced():
    def kinds(**found):
        sound = {"expected_pocket": 1, "pocket": 1, "strength": 1.0} | found
        return [one.kind for one in magnet_findings(SMALL, MagnetFound(**sound))]

    assert kinds() == []
    assert kinds(strength=-1.0) == ["flipped magnet"]
    assert kinds(pocket=2) == ["misplaced magnet"]
    assert (
        kinds(strength=0.19, pocket=2)
        == kinds(strength=0.59)
        == kinds(strength=1.61)
        == ["weak magnet"]
    )
    assert kinds(strength=0.61) == kinds(strength=1.59) == []
    assert kinds(strength=-0.21, pocket=2) == ["misplaced magnet", "flipped magnet"]


def test_axes_of_a_slanted_chip_are_told_by_their_largest_part():
    """Turned by 30° about Z and then by 100° about X: no entry is 1."""
    c, s = np.cos(np.radians(100)), np.sin(np.radians(100))
    slanted = np.array([[1, 0, 0], [0, c, -s], [0, s, c]]) @ about_z(30)
    found = chips(c0={"turn": slanted})[0]
    assert chip_findings.axes_text(found) == "(X, −Z, Y) for X, Y, Z"
