"""What `instobj new` says of what comes next: memory, numbers of parts that help, time."""

import re
import tomllib
import warnings
from dataclasses import replace

import numpy as np
import pytest

from design.build.masses import mass_text
from design.placement.objects import (
    COARSE,
    SHELL_VARIANTS,
    Request,
    ShellVariant,
    first_fit,
    fitting_tables,
    spec_of,
)
from design.processes import MEMORY_SWITCH
from design.spec_io import load_spec
from estimator.layouts.without_mesh import FirstScore, first_score
from instobj.commands.first_layout import improved, parts_that_help
from instobj.commands.new import placed_text
from instobj.commands.outlook import (
    expected_text,
    memory_text,
    next_step_text,
    outlook_text,
    with_edges_that_fit,
)
from instobj.commands.run import check_specifications
from instobj.commands.specification_file import specification_text
from instobj.stages.resources import needed_gib


def placed(request):
    tables = first_fit(request, SHELL_VARIANTS, COARSE)
    assert tables is not None
    return tables


@pytest.fixture(scope="module")
def big():
    request = Request("box", (150.0, 120.0, 90.0), sensors=1, magnets=1)
    return request, placed(request)


def test_edges_of_the_mesh_follow_the_size_so_that_memory_is_enough(big):
    """Both edges alike, as little as needed; a body that fits keeps the usual ones."""
    request, tables = big
    assert needed_gib("response", spec_of(tables)) > 30
    spec = spec_of(with_edges_that_fit(request, tables))
    usual = spec_of(tables).mesh
    ratios = [spec.mesh.edge_mm / usual.edge_mm, spec.mesh.surface_edge_mm / usual.surface_edge_mm]
    np.testing.assert_allclose(ratios[0], ratios[1], rtol=5e-3)
    assert 9 < needed_gib("response", spec) <= 12
    assert "instead of 1.7 mm, so that the mechanics fit into 12 GiB" in next_step_text(spec)
    assert with_edges_that_fit(request, tables, most_gib=1e3) is tables


@pytest.mark.slow
def test_more_parts_are_named_that_bring_more_locations_within_the_limit():
    """What is named is asked for, and keeps what was said of it."""
    request = Request("pad", (60.0, 42.0, 11.0), sensors=1, magnets=2)
    spec = spec_of(placed(request))
    score = first_score(spec)
    told = parts_that_help(request, spec, score)
    assert told.startswith("NO-GO is to be expected; ")
    asked = {key: int(count) for key, count in re.findall(r"--(sensors|magnets) (\d+)", told)}
    assert asked
    more, _ = improved(placed(replace(request, **asked)), rounds=3)
    assert first_score(spec_of(more)).within > score.within + 0.05


@pytest.mark.slow
def test_parts_that_bring_the_last_locations_within_the_limit_are_named():
    """A pad with 97 % within: nothing can bring 5 % more."""
    request = Request("pad", (36.0, 36.0, 12.0), sensors=2)
    tables = placed(replace(request, magnets=9))
    told = parts_that_help(request, spec_of(tables), FirstScore(0.6, 1.4, 0.97))
    assert re.search(r"; \d more .* would bring every location within the limit", told)


@pytest.mark.slow
def test_parts_that_ask_for_another_shell_say_which():
    """Two more sensors of a box meant a shell of 5 instead of 8 mm and smaller magnets, unsaid."""
    request, shell = Request("box", (55.0, 40.0, 45.0)), ShellVariant(8.0, 6.0, 5.0, 1.0)
    tables = next(fitting_tables(replace(request, magnets=9), (shell,), COARSE))
    advice = parts_that_help(request, spec_of(tables), FirstScore(0.6, 3.5, 0.1))
    assert re.search(
        r"--sensors \d\), which is another object with a shell of [\d.]+ mm \(not 8 mm\) and magnets of",
        advice,
    )


def test_lighter_limits_are_felt_at_fewer_locations(big):
    """Signals grow with force."""
    spec = spec_of(big[1])
    felt = [
        first_score(spec.changed(limits={"detectable_force_n": force})).felt
        for force in (0.01, 1.0, 5.0, 500.0)
    ]
    assert felt == sorted(felt)
    assert felt[0] == 0
    assert felt[-1] > felt[1]
    text = expected_text(spec, FirstScore(0.5, 1.6, 0.9, 0.93))
    assert "about 93 % feel a touch of limits.detectable_force_n = 5 N" in text


def test_more_magnets_are_named_only_where_a_number_was_asked_for():
    """Without one, `new` has tried more by itself: they were no better, or cannot be made."""
    request = Request("pad", (60.0, 42.0, 11.0), sensors=1)
    spec = spec_of(placed(replace(request, magnets=2)))
    score = first_score(spec)
    assert "--magnets" in parts_that_help(replace(request, magnets=2), spec, score)
    assert "--magnets" not in parts_that_help(request, spec, score)


@pytest.mark.slow
def test_a_softer_silicone_is_advised_only_where_it_carries_the_force(big):
    """`new` advised one, and `score` a firmer one for the same object."""
    request, tables = big
    spec = spec_of(tables)
    light, heavy = (
        parts_that_help(
            request, spec.changed(score={"force_n": force_n}), FirstScore(0.9, 3.0, 0.99)
        )
        for force_n in (0.5, 50.0)
    )
    assert "a smaller body or raise limits.position_bound_mm" in heavy
    assert "little better" not in heavy
    assert re.search(r"Tried: .*[\d.]+ mm \(median\), \d+ % within", heavy)
    assert "smaller body, a softer silicone (silicone.name = 'Ecoflex 00-30') or raise" in light


@pytest.mark.slow
def test_more_sensors_under_the_same_shell_come_with_figures_and_lines_to_copy():
    """A box was said to gain little by five sensors, and `run` halved its bound with them: by rules
    they had a thinner shell and smaller magnets."""
    request = Request("box", (60.0, 45.0, 40.0))
    shell = ShellVariant(8.0, 6.0, 5.0, 1.0)
    tables, _ = improved(next(fitting_tables(replace(request, magnets=9), (shell,), COARSE)), 2)
    spec = spec_of(tables)
    score = first_score(spec)
    advice, *lines = parts_that_help(request, spec, score).splitlines()
    assert f"{score.median_mm:.2g} mm (median)" in advice
    median_mm, share = re.search(
        r"same shell: ([\d.]+) mm \(median\), (\d+) % within", advice
    ).groups()
    pasted = spec.changed(sensors=tomllib.loads("\n".join(lines))["sensors"])
    after = first_score(pasted)
    assert pasted.sensors.count_per_face == spec.sensors.count_per_face + 2
    assert pasted.shell == spec.shell
    assert float(median_mm) == pytest.approx(after.median_mm, rel=0.05)
    assert float(share) == pytest.approx(100 * after.within, abs=1)
    assert after.within > score.within


def test_no_parts_are_named_where_all_locations_are_within_the_limit(big):
    request, tables = big
    assert parts_that_help(request, spec_of(tables), FirstScore(0.1, 0.2, 1.0)) == ""


def test_bounds_to_expect_are_said_with_how_sure_they_are_and_the_share_within_the_limit(big):
    """A box was said to have "about 95 %", and the chain found 80 %."""
    score = FirstScore(0.512, 1.62, 0.9, within_range=(0.702, 0.9996))
    text = expected_text(spec_of(big[1]), score)
    for said in ("0.51 mm (median", "one in twenty above 1.6 mm", "factor of 2.5", "70 to 99 % of"):
        assert said in text
    assert "about 90" not in text
    alike = expected_text(spec_of(big[1]), replace(score, within_range=(1.0, 1.0)))
    assert "; 100 % of the contact" in alike


def test_the_range_of_the_share_is_that_of_a_factor_on_all_bounds():
    """The paper's cube at limits so many times smaller, and larger, has these shares."""
    spec = spec_of({})
    limit_mm = first_score(spec).median_mm

    def score_at(factor):
        return first_score(spec.changed(limits={"position_bound_mm": factor * limit_mm}))

    least, most = score_at(1.0).within_range
    assert (least, most) == (score_at(0.4).within, score_at(2.5).within)
    assert least < score_at(1.0).within < most


def test_contact_locations_of_a_large_body_lie_farther_apart(big):
    assert big[1]["contact_grid"]["pitch_mm"] > 3
    assert placed(Request("box", (70.0, 50.0, 35.0), 2))["contact_grid"]["pitch_mm"] == 3


def test_check_says_before_any_mesh_that_a_body_cannot_be_scored(big, tmp_path, monkeypatch):
    """With the usual edges a box of 150 mm needs 38 GiB; with those of `new` it does not."""
    request, tables = big
    monkeypatch.setenv(MEMORY_SWITCH, "15.5")
    paths = [tmp_path / "usual.toml", tmp_path / "longer.toml"]
    for path, placed in zip(paths, (tables, with_edges_that_fit(request, tables)), strict=True):
        path.write_text(specification_text(path.stem, tmp_path, placed), encoding="utf-8")
    with pytest.warns(UserWarning, match="cannot be scored here.*response.*mesh.edge_mm"):
        check_specifications(paths[:1], [])
    assert memory_text(load_spec(paths[1], [])) == ""


def test_check_warns_of_a_range_that_is_nearly_used_at_rest(tmp_path):
    """With an MLX90393 of ±4.9 mT the docs' own block was valid, and no go by its range."""
    path = tmp_path / "cube.toml"
    path.write_text('name = "cube"\n[sensors]\npart = "MLX90393"\nnoise_counts = [10, 10, 15]\n')
    with pytest.warns(
        UserWarning, match="95% of the sensors' range is used at rest.*sensors.range_mt"
    ):
        check_specifications([path], [])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_specifications([path], ["sensors.range_mt=9.8"])


def test_check_says_the_bounds_of_new_and_why_where_it_cannot(big, tmp_path):
    """Chips turned by hand are scored with a mesh alone."""
    spec = spec_of(big[1])
    path = tmp_path / "big.toml"
    path.write_text(specification_text("big", tmp_path, big[1]), encoding="utf-8")
    row = check_specifications([path], [])["specifications"][0]
    expected = expected_text(spec, first_score(spec))
    assert expected in placed_text(path)
    assert row["outlook"] == f"{expected}. Compare layouts by `instobj score`, not by this"
    assert row["mass"] == mass_text(spec)
    assert f"cover {100 * row['covered_share']:.0f} % of the sensed surface" in placed_text(path)
    turned = spec.changed(sensors=spec.sensors.changed(rotations_deg=((0.0, 0.0, 10.0),)))
    assert "sensors.rotations_deg" in outlook_text(turned)
