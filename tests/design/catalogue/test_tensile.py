"""Tensile tests: solids found again from their own curves, and data that are refused."""

from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.catalogue.tensile import fit_tensile, fits_by_range, nominal_stress_mpa
from design.catalogue.tensile_files import TensileTest, read_tensile_test
from design.errors import InputError
from design.spec_io import load_spec
from fem.large_strain.hyperelastic import first_piola_stress, ogden, yeoh
from tests.support.physics_pages import assert_page

RNG = np.random.default_rng
STRETCH = np.linspace(1.05, 1.9, 18)
SOLIDS = {
    "neo-hookean": (0.045,),
    "yeoh": (0.05, 0.008, -0.0004),
    "ogden": (0.061, 2.7),
}


def curve(solid, scale=1.0):
    return TensileTest(STRETCH, scale * nominal_stress_mpa(solid, SOLIDS[solid], STRETCH))


def fitted(test, solid):
    return next(fit for fit in fit_tensile(test, "test").solids if fit.solid == solid)


@pytest.mark.parametrize("solid", SOLIDS)
def test_a_solid_is_found_again_from_its_own_curve(solid):
    fit = fitted(curve(solid), solid)
    assert_allclose(fit.constants, SOLIDS[solid], rtol=1e-5)
    assert fit.stable
    assert fit.residual_mpa < 1e-8
    doubled = fitted(curve(solid, 2.0), solid)
    assert_allclose(doubled.youngs_modulus_mpa, 2 * fit.youngs_modulus_mpa, rtol=1e-5)


@pytest.mark.parametrize("solid", SOLIDS)
def test_the_curve_is_that_of_the_finite_elements_material(solid):
    """Uniaxial tension of `fem.large_strain.hyperelastic` with the pressure that frees the sides."""
    constants = SOLIDS[solid]
    material = ogden(constants[:1], constants[1:]) if solid == "ogden" else yeoh(*constants)
    for stretch in (1.1, 1.7):
        gradient = np.diag([stretch, stretch**-0.5, stretch**-0.5])
        stress = np.diag(first_piola_stress(material, gradient[None])[0])
        free = stress[0] - stress[1] * stretch**-1.5
        expected = nominal_stress_mpa(solid, constants, np.array([stretch]))[0]
        assert_allclose(free, expected, rtol=1e-12)


@pytest.mark.parametrize("solid", SOLIDS)
def test_the_modulus_is_the_slope_at_rest(solid):
    step = 1e-6
    slope = nominal_stress_mpa(solid, SOLIDS[solid], np.array([1 + step]))[0] / step
    assert_allclose(fitted(curve(solid), solid).youngs_modulus_mpa, slope, rtol=1e-4)


def test_the_interval_spans_the_solids_that_fit():
    stress = nominal_stress_mpa("yeoh", SOLIDS["yeoh"], STRETCH)
    noise = 0.002 * np.random.default_rng(4).standard_normal(len(STRETCH))
    fit = fit_tensile(TensileTest(STRETCH, stress + noise), "pull.csv")
    moduli = [s.youngs_modulus_mpa for s in fit.solids if s.stable and s.residual_percent < 10]
    assert fit.modulus.range_mpa == (min(moduli), max(moduli))
    assert fit.modulus.low_mpa < 0.3 < fit.modulus.high_mpa
    assert "fitted to pull.csv" in fit.modulus.source


def test_points_far_beyond_a_press_are_left_out():
    near = curve("ogden")
    far = np.linspace(2.1, 6, 20)
    test = TensileTest(np.append(STRETCH, far), np.append(near.nominal_stress_mpa, far**4))
    assert fitted(test, "ogden").constants == fitted(near, "ogden").constants


def written(folder, header, rows):
    path = folder / "pull.csv"
    path.write_text("\n".join([header, *(",".join(map(str, row)) for row in rows)]))
    return path


def test_strain_percent_and_kilopascals(tmp_path):
    test = curve("neo-hookean")
    rows = zip(100 * (STRETCH - 1), 1e3 * test.nominal_stress_mpa, strict=True)
    read = read_tensile_test(written(tmp_path, "strain_percent,nominal_stress_kpa", rows))
    assert_allclose(read.stretch, STRETCH, rtol=1e-12)
    assert_allclose(read.nominal_stress_mpa, test.nominal_stress_mpa, rtol=1e-12)


GOOD = [(1 + 0.1 * i, 0.02 * i) for i in range(1, 9)]


@pytest.mark.parametrize(
    ("header", "rows", "words"),
    [
        ("stretch,force", GOOD, "columns .*force.*tensile data need one of"),
        ("time,nominal_stress_mpa", GOOD, "columns .*time.*tensile data need one of"),
        ("time,force", GOOD, "columns .'time', 'force'.; tensile data need one of"),
        ("stretch,nominal_stress_mpa", [], "tensile data need"),
        ("stretch,nominal_stress_mpa", GOOD[:4], "4 points .* of 1.4; at least 6"),
        ("stretch,nominal_stress_mpa", [*GOOD[:5], (2.1, 0.3)], "5 points .* of 2; at least 6"),
        (
            "strain,nominal_stress_mpa",
            [(0.01 * i, 0.1 * i) for i in range(8)],
            "8 points .* of 1.07; .*reach 1.1",
        ),
        ("stretch,nominal_stress_mpa", [*GOOD[:5], (1.2, 0.1), *GOOD[5:]], "line 7: .*sorted"),
        ("stretch,nominal_stress_mpa", [*GOOD, (1.95, -0.1)], "line 10: .*stress ≥ 0"),
        ("stretch,nominal_stress_mpa", [(0.9, 0.1), *GOOD], "line 2: .*stretch ≥ 1"),
        ("stretch,nominal_stress_mpa", [*GOOD, (1.95, "nan")], "not finite"),
        ("stretch,nominal_stress_mpa", [*GOOD, (1.95, "1;2")], "needs a number"),
        ("stretch,nominal_stress_mpa", [*GOOD, (1.95,)], "needs a number"),
    ],
)
def test_data_that_make_no_sense_are_refused(header, rows, words, tmp_path):
    with pytest.raises(InputError, match=words):
        read_tensile_test(written(tmp_path, header, rows))


@pytest.mark.parametrize(
    ("rows", "line"),
    [
        ([(1.0, 0.0), (1.1, 0.0), (1.2, -0.01), (1.3, 0.2)], 4),
        ([(1.0, 0.0), (1.0, 0.1), (0.9, 0.2), (1.3, 0.3)], 4),
        ([(1.0, 0.0), (1.1, 0.1), (1.1, 0.2), (1.3, 0.3)], 4),
        ([(1.0, 0.0), (1.2, 0.1), (1.3, 0.2), (1.25, 0.3)], 5),
    ],
)
def test_the_line_that_is_wrong_is_named_and_not_one_that_begins_at_rest(rows, line, tmp_path):
    path = written(tmp_path, "stretch,nominal_stress_mpa", rows)
    with pytest.raises(InputError, match=f"line {line}: "):
        read_tensile_test(path)


def test_six_points_are_enough_and_five_are_not(tmp_path):
    header = "stretch,nominal_stress_mpa"
    assert len(read_tensile_test(written(tmp_path, header, GOOD[:6])).stretch) == 6
    with pytest.raises(InputError, match="5 points"):
        read_tensile_test(written(tmp_path, header, GOOD[:5]))
    assert len(read_tensile_test(written(tmp_path, header, [*GOOD[:5], (2.0, 0.3)])).stretch) == 6
    barely = [(1.05 + 0.01 * k, 0.1) for k in range(5)]
    assert len(read_tensile_test(written(tmp_path, header, [*barely, (1.1, 0.3)])).stretch) == 6


def test_a_table_begins_within_a_hundred_lines(tmp_path):
    path = written(tmp_path, "stretch,nominal_stress_mpa", GOOD)
    table = path.read_text()
    path.write_text("pulled in May\n" * 99 + table)
    assert len(read_tensile_test(path).stretch) == len(GOOD)
    path.write_text("pulled in May\n" * 100 + table)
    with pytest.raises(InputError, match="tensile data need one of"):
        read_tensile_test(path)


def test_a_falling_curve_fits_no_solid():
    falling = TensileTest(STRETCH, 0.1 / STRETCH**4)
    with pytest.raises(InputError, match=r"no solid fits pull\.csv to 10 %"):
        fit_tensile(falling, "pull.csv")


def test_a_specification_takes_its_modulus_from_a_file_beside_it(tmp_path):
    test = curve("ogden")
    rows = zip(STRETCH, test.nominal_stress_mpa, strict=True)
    written(tmp_path, "stretch,nominal_stress_mpa", rows)
    spec = tmp_path / "cube.toml"
    spec.write_text('name = "cube"\n[silicone]\nmodulus_from = "pull.csv"\n')
    silicone = load_spec(spec).silicone
    assert_allclose(silicone.youngs_modulus_mpa, 1.5 * 0.061 * 2.7, rtol=1e-5)
    assert silicone.relative_spread is not None
    assert silicone.modulus_source == "fitted to pull.csv"
    given = load_spec(spec, ["silicone.youngs_modulus_mpa=0.3"]).silicone
    assert (given.youngs_modulus_mpa, given.modulus_source) == (0.3, "given")
    with pytest.raises(InputError, match="cannot read tensile data"):
        load_spec(spec, ["silicone.modulus_from=none.csv"])


def intervals_hold(noise_of):
    """Share of 90 % intervals that hold the modulus, for a Yeoh curve with many draws of noise."""
    stretch = np.linspace(1.02, 2.0, 60)
    clean, rng, held = nominal_stress_mpa("yeoh", SOLIDS["yeoh"], stretch), RNG(5), []
    for _ in range(60):
        test = TensileTest(stretch, clean + 0.002 * noise_of(rng, len(stretch)))
        fit = next(
            one for one in fits_by_range(test) if (one.to_stretch, one.fit.solid) == (2.0, "yeoh")
        )
        held.append(fit.low_mpa < 6 * SOLIDS["yeoh"][0] < fit.high_mpa)
    return float(np.mean(held))


def drifting(rng, count):
    """Noise whose neighbours are alike (correlation 0.8), of variance 1."""
    noise = np.zeros(count)
    noise[0] = rng.standard_normal()
    for k in range(1, count):
        noise[k] = 0.8 * noise[k - 1] + 0.6 * rng.standard_normal()
    return noise


def test_nine_of_ten_intervals_hold_the_modulus_with_independent_noise():
    assert 0.8 <= intervals_hold(lambda rng, count: rng.standard_normal(count)) <= 0.98


def test_intervals_grow_where_neighbouring_residuals_are_alike():
    """A fit takes up some of a drift: 75 % hold the modulus, and 30 % if residuals counted as independent."""
    assert 0.6 <= intervals_hold(drifting) <= 0.98


def test_ranges_that_the_test_does_not_reach_are_left_out():
    found = fits_by_range(curve("ogden"))
    assert [one.to_stretch for one in found] == [1.5] * 3
    assert [one.points for one in found] == [10] * 3


PUBLISHED = """PARAMETER;INFO;URL;;
Strain Measurement;Global;;;
Strain calculation;Derived from the machine crosshead displacement readings;;;
Material;EcoFlex30;;;
;;;;
Time (s);True Strain;True Stress (MPa);Engineering Strain;Engineering Stress (MPa)
"""


def test_published_files_are_read_as_they_are(tmp_path):
    """Semicolons, details above, true values beside, one more column, blank lines."""
    test = curve("yeoh")
    rows = [
        f"{0.1 * k};{np.log(a)};{a * p};{a - 1};{p};;"
        for k, (a, p) in enumerate(zip(STRETCH, test.nominal_stress_mpa, strict=True))
    ]
    path = tmp_path / "published.csv"
    path.write_text(PUBLISHED + "\n".join([*rows[:4], ";;;;", *rows[4:], "", ";;;;"]))
    read = read_tensile_test(path)
    assert_allclose(read.stretch, STRETCH, rtol=1e-12)
    assert_allclose(read.nominal_stress_mpa, test.nominal_stress_mpa, rtol=1e-12)
    assert read.details["Material"] == "EcoFlex30"
    path.write_text(PUBLISHED + "\n".join([*rows[:8], rows[7], *rows[8:]]))
    with pytest.raises(InputError, match=r"line 15: .*does not exceed"):
        read_tensile_test(path)


INITIAL_MODULI_MPA = {
    "PlatSil_Gel_10": (0.14, 0.16),
    "Ecoflex_00-30": (0.040, 0.045),
    "Dragon_Skin_10_MEDIUM": (0.11, 0.13),
    "Dragon_Skin_30": (0.49, 0.53),
    "Mold_Star_16_FAST": (0.23, 0.25),
}
"""Yeoh and Ogden, stretches up to 1.5 and 2: docs/measured/validation.md."""


@pytest.mark.parametrize("name", INITIAL_MODULI_MPA)
def test_every_public_tensile_test_is_read_and_fitted(name):
    path = Path(__file__).parents[3].parent / f"shared/data/silicone-tensile/{name}.csv"
    if not path.exists():
        pytest.skip(f"{path} is not here")
    test = read_tensile_test(path)
    assert test.stretch[-1] > 8
    low, high = INITIAL_MODULI_MPA[name]
    moduli = [
        one.fit.youngs_modulus_mpa
        for one in fits_by_range(test)
        if one.to_stretch in (1.5, 2.0) and one.fit.solid != "neo-hookean"
    ]
    assert len(moduli) == 4
    assert low < min(moduli) < max(moduli) < high


def test_fits_of_a_made_up_pull_are_as_on_the_page():
    """Yeoh's solid of 0.05, −0.004 and 0.0009 MPa with a wave of 1 %, to a stretch of 2.6."""
    stretch = np.linspace(1.04, 2.6, 40)
    pull = nominal_stress_mpa("yeoh", (0.05, -0.004, 0.0009), stretch)
    test = TensileTest(stretch, pull * (1 + 0.01 * np.sin(9 * stretch)))
    fit = fit_tensile(test, "made up")
    modulus = fit.modulus
    lines = [("modulus (MPa)", [modulus.youngs_modulus_mpa, modulus.low_mpa, modulus.high_mpa])]
    for solid in fit.solids:
        sizes = [*solid.constants, solid.youngs_modulus_mpa, solid.residual_percent, solid.stable]
        lines.append((solid.solid, [*sizes, 1e3 * solid.residual_mpa]))
    for one in fits_by_range(test):
        sizes = [one.to_stretch, one.points, one.fit.youngs_modulus_mpa, one.low_mpa, one.high_mpa]
        lines.append((f"range of {one.fit.solid}", sizes))
    assert_page("design/catalogue", lines)
