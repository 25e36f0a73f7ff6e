"""Surroundings in words: what the terminal says before mechanics, and what the report knows beyond."""

from instobj.report.surroundings import grasp_rows, surroundings_lines, surroundings_section
from instobj.stages.makers.surroundings import surroundings_row
from tests.support.markup import read
from tests.support.mechanics.odd_presses import SPEC

JAWS = [
    {"material": "steel", "gap_mm": 0.0, "counts": 926.4, "pull_n": 0.2855, "false_force_n": 5.35},
    {"material": "steel", "gap_mm": 10.0, "counts": 144.4, "pull_n": 1.2e-3, "false_force_n": 3.38},
    {"material": "plastic", "gap_mm": 0.0, "counts": 0.2, "pull_n": 3e-6, "false_force_n": 3e-4},
]
RESTING = {"force_n": 0.0314, "moved_mm": 0.00377, "counts": 4.59}


def test_before_mechanics_steel_is_told_in_counts_and_its_pull_in_newtons():
    row = surroundings_row(SPEC)
    (line,) = (line for line in surroundings_lines(row) if "steel" in line)
    assert f"pulls a magnet with up to {row['jaw_pull_n'][0]:.3g} N" in line
    assert 0.3 < row["jaw_pull_n"][0] < 0.4
    assert not any("push" in line for line in surroundings_lines(row))


def test_the_report_has_counts_and_newtons_of_every_jaw():
    row = surroundings_row(SPEC) | {"jaws": JAWS, "resting": RESTING}
    told = read(surroundings_section(row))
    assert "steel, touching 926 5.35 0.285" in told
    assert "steel, 10 mm away 144 3.38 0.0012" in told
    assert "plastic, touching 0 0 0" in told
    assert "with up to 0.0314 N" in told
    assert "up to 3.77 µm and the zero by up to 4.59 counts" in told
    without = read(surroundings_section(row | {"resting": None}))
    assert "each other" not in without


def test_a_flat_jaw_has_its_bounds_alone_and_against_another():
    bounds = {"force_bound": "n", "centre_bound": "mm", "tilt_bound": "deg", "size_bound": "mm"}
    figures = (1.2345, 3.4, 0.104, 7.4, 4.2, 11.6, 0.43, 12.5)
    names = [f"{name}{state}_{unit}" for state in ("", "_drifted") for name, unit in bounds.items()]
    alone = {"face": 3, "against": None, "covered": 1.0} | dict(zip(names, figures, strict=True))
    part = alone | {"covered": 0.5}
    alone |= {"size_bound_mm": float("nan"), "size_bound_drifted_mm": float("nan")}
    blind = alone | {"against": 5, "force_bound_n": float("inf")}
    rows = grasp_rows({"jaw_bounds": [alone, part, blind]})
    assert rows[0] == ("face 3", "1.23", "3.4", "0.104", "–", "4.2", "11.6", "0.43", "–")
    middle = "middle of face 3, half as long and wide"
    assert rows[1] == (middle, "1.23", "3.4", "0.104", "7.4", "4.2", "11.6", "0.43", "12.5")
    assert rows[2][:2] == ("face 3, another over 5", "∞")
    assert grasp_rows({"jaw_bounds": []}) == []
