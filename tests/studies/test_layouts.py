"""Studies of layout: variants that fit, one through the chain on a coarse mesh, and its figure."""

import pytest

from design.errors import InputError
from design.layout.places.contact_places import grid_count
from design.spec.object import MagnetSpec, ObjectSpec
from studies import layouts
from studies.layouts import STUDIES, changed
from studies.variant_figure import draw_variants

PAPER = ObjectSpec(name="cube")
VARIANTS = (
    layouts.sensor_counts,
    layouts.magnet_counts,
    layouts.poles,
    layouts.arrangements,
    layouts.thicknesses,
    layouts.moduli,
    layouts.slits,
)


def all_of(variants, mesh):
    return {
        label: changed(PAPER, {**mesh, **changes}) for label, changes in variants(PAPER).items()
    }


def test_every_study_has_its_variants():
    assert [study.run.args[0] for study in STUDIES] == list(VARIANTS)


@pytest.mark.parametrize("mesh", [layouts.MESH, layouts.QUICK])
@pytest.mark.parametrize("variants", VARIANTS)
def test_variants_fit_and_differ(variants, mesh):
    specs = list(all_of(variants, mesh).values())
    first = specs[0]
    itself = changed(PAPER, mesh)  # comes first, in the study of moduli pressed deeper
    assert first.model_copy(update={"press": itself.press, "silicone": itself.silicone}) == itself
    assert first.silicone.youngs_modulus_mpa == itself.silicone.youngs_modulus_mpa
    assert all(spec != first for spec in specs[1:])


def test_variants_change_what_they_say():
    found = all_of(layouts.thicknesses, layouts.MESH)
    assert {spec.core_size_mm for spec in found.values()} == {(26.0, 26.0, 26.0)}
    assert found["10 mm, pockets 5 mm"].shell.pocket_depth_mm == 5
    assert [spec.sensors.count_per_face for spec in all_of(layouts.sensor_counts, {}).values()] == [
        3,
        4,
        3,
        5,
    ]
    assert [
        len(spec.magnets.positions_mm) for spec in all_of(layouts.magnet_counts, {}).values()
    ] == [
        5,
        4,
        4,
        9,
    ]
    soft = all_of(layouts.moduli, {})
    assert [float(label.split()[0]) for label in soft] == pytest.approx(
        [spec.silicone.youngs_modulus_mpa for spec in soft.values()], rel=5e-3
    )


def test_a_variant_that_does_not_fit_is_named(tmp_path):
    two = ObjectSpec(name="two", magnets=MagnetSpec(positions_mm=((0.0, 0.0), (8.0, 8.0))))
    with pytest.raises(InputError, match=r"(?s)two with centre inward.*north needs one entry"):
        layouts.compare_variants(
            lambda spec: dict(list(layouts.poles(spec).items())[1:]), two, tmp_path, True
        )


def test_variants_of_a_filled_object_are_pressed_at_its_own_locations(tmp_path, monkeypatch):
    """A body 4 mm larger would be filled with more."""
    counts = []
    monkeypatch.setattr(layouts, "chain_score", lambda spec: counts.append(grid_count(spec)))
    monkeypatch.setattr(layouts, "score_row", lambda score: {})
    monkeypatch.setattr(layouts, "draw_variants", lambda rows, force, path: None)
    layouts.compare_variants(layouts.thicknesses, PAPER, tmp_path, quick=False)
    assert counts == [grid_count(PAPER)] * 5


def test_the_figure_takes_any_rows(tmp_path):
    names = ("worst place mm", "median place mm", "worst force N", "false N")
    rows = [
        {"variant": label} | dict.fromkeys(names, 0.3 * (k + 1)) for k, label in enumerate("abc")
    ]
    draw_variants(rows, 8.0, tmp_path / "scores.png")
    assert (tmp_path / "scores.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.slow
def test_poles_are_compared_on_one_mesh(tmp_path, monkeypatch):
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    found = layouts.compare_variants(layouts.poles, PAPER, tmp_path, True)
    rows = {row["variant"]: row for row in found.rows}
    assert len(list((tmp_path / "store" / "mesh").iterdir())) == 1
    assert list(rows) == list(layouts.poles(PAPER))
    assert all(0 < row["worst place mm"] < 10 for row in rows.values())
    assert rows["centre inward"]["free range"] != rows["all outward"]["free range"]
