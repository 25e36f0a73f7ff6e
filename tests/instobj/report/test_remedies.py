"""What turns a no-go into a go: the cheapest change that is enough, by hand from small tables."""

import numpy as np
import pytest

from design.layout.places.contact_grid import contact_grid
from design.spec_io import parse_spec
from instobj.report.remedies import (
    decision,
    edges_text,
    further_text,
    remedies,
    remedies_section,
    softer_label,
    worst_edge_text,
)
from tests.support.objects.made_scores import scores_of

SPEC = parse_spec(
    {
        "name": "a",
        "limits": {"position_bound_mm": 2.0, "detectable_force_n": 4.0},
    },
    "a",
)


def row(
    changes,
    bound_mm=1.0,
    force_n=1.0,
    margin=0.5,
    of_objects=0.5,
    magnets=10,
    sensors=10,
    unreached=0.0,
    settings=(),
    edge_bound_mm=None,
):
    return {
        "changes": list(changes),
        "weakest_bound_mm": bound_mm,
        "median_bound_mm": bound_mm / 2,
        "worst_detectable_n": force_n,
        "saturation_margin": margin,
        "objects_margin": of_objects,
        "magnets": magnets,
        "sensors": sensors,
        "unreached": unreached,
        "settings": list(settings),
        "edge_bound_mm": edge_bound_mm,
    }


START = row((), bound_mm=5.0)


def test_the_cheapest_change_that_is_enough_comes_first_with_its_price_and_time():
    rows = [
        START,
        row(("sensors",), sensors=15),
        row(("magnets",), magnets=20),
        row(("free",), bound_mm=2.1),
        row(("free", "soft"), bound_mm=2.0, force_n=4.0),
    ]
    found = remedies(SPEC, rows)
    assert [one.changes for one in found if one.turns] == [
        ("free", "soft"),
        ("magnets",),
        ("sensors",),
    ]
    assert [(one.price, one.minutes) for one in found[:3]] == [(0, 0), (2, 20), (15, 75)]
    told = decision(found, go=False)
    assert told == "Turns it into a go: free and soft (no more magnets or sensors)"
    assert found[1].text == "magnets (+2 € for magnets and sensors, +20 min by hand)"


def test_a_pair_says_nothing_new_where_half_of_it_is_enough():
    rows = [START, row(("a",)), row(("b",), bound_mm=3.0), row(("a", "b"))]
    assert [one.changes for one in remedies(SPEC, rows)] == [("a",), ("b",)]


@pytest.mark.parametrize(
    ("figures", "ratio"),
    [
        ({"bound_mm": 6.0}, 3.0),
        ({"force_n": 6.0}, 1.5),
        ({"margin": 0.0}, 1 / 0.9),
        ({"margin": -0.8}, 2.0),
    ],
)
def test_every_limit_counts(figures, ratio):
    start = row((), bound_mm=9.0, force_n=99.0, margin=-9.0)
    ranked = remedies(SPEC, [start, row(("a",), **figures)])
    assert not ranked[0].turns
    assert ranked[0].ratio == pytest.approx(ratio)


def test_where_nothing_is_enough_the_nearest_is_told_with_what_is_left():
    rows = [START, row(("a",), bound_mm=4.0), row(("b",), bound_mm=3.0, sensors=11)]
    told = decision(remedies(SPEC, rows), go=False)
    assert told.startswith(
        "None of the changes tried is enough, alone or with others. Helps most alone: b (+3 €"
    )
    assert "1.5 times its limit" in told
    blind = [row(changes, bound_mm=float("inf")) for changes in ((), ("a",))]
    assert decision(remedies(SPEC, blind), go=False).endswith("fits and makes it better")
    deaf = [
        row((), bound_mm=9.0, force_n=float("inf")),
        row(("cheap",), bound_mm=8.0, force_n=float("inf")),
        row(("sensors",), bound_mm=3.0, force_n=float("inf"), sensors=15),
    ]
    found = remedies(SPEC, deaf)
    assert [one.changes[0] for one in found] == ["sensors", "cheap"]
    told = decision(found, go=False)
    helps = "alone: sensors (+15 € for magnets and sensors, +75 min by hand); the weakest position bound is"
    assert f"{helps} then 3 mm, and some locations feel nothing" in told
    assert decision(remedies(SPEC, rows), go=True) == "Every limit is kept; nothing has to change"
    assert decision(remedies(SPEC, [START]), go=False).startswith("None of the changes")


def test_options_to_try_next_come_after_other_places():
    tried = further_text(SPEC, [START], ["--set magnets.height_mm=1.5"])
    assert "Next to try: other places (instobj optimize), then --set magnets.height_mm=1.5" in tried
    assert further_text(SPEC, [START]).endswith("Next to try: other places (instobj optimize)")


def test_why_a_softer_silicone_is_left_out_is_said():
    """Dragon Skin 10 would have helped, and was left out without a word."""
    label = softer_label("Ecoflex 00-30")
    few = further_text(SPEC, [START, row((label,), unreached=0.9)])
    assert "with Ecoflex 00-30 presses reach 5 N at only 10 % of the locations" in few
    assert "Dragon Skin 10 (0.12 to 0.42 MPa) is not surely softer" in few
    assert "(0.15 to 0.54 MPa)" in few
    assert "left out" not in further_text(SPEC, [START, row((label,), unreached=0.1)])
    softest = SPEC.changed(silicone={"name": "Ecoflex 00-30"})
    assert "Softer silicone is left out: the catalogue has none" in further_text(softest, [START])
    found = remedies(SPEC, [START, row(("b",), bound_mm=3.0)])
    assert decision(found, go=False, further=few).endswith(few)
    assert few not in decision(found, go=True, further=few)


def test_the_page_names_what_to_try_next_only_where_no_change_is_enough():
    better, enough = (
        remedies_section(SPEC, {"alternatives": [START, row(("b",), bound_mm=bound)]}, go=False)
        for bound in (3.0, 1.0)
    )
    assert any("Next to try" in sentence for sentence in better["decision"])
    assert enough["decision"] == ("Turns it into a go: b (no more magnets or sensors)",)


def test_a_set_that_comes_nearer_is_named_beside_the_change_that_helps_most():
    """Two more sensors left a cylinder at 2.58 times the limit; with four frames each it was 1.78."""
    rows = [START, row(("a",), bound_mm=4.0), row(("b",), bound_mm=3.0), row(("a", "b"), 2.5)]
    text = decision(remedies(SPEC, rows), go=False)
    assert (
        "alone: b (no more magnets or sensors); the worst figure is then still 1.5 times its limit"
        in text
    )
    assert "(1.25 times with a and b)" in text


def test_a_figure_just_above_its_limit_is_told_as_above_it():
    told = decision(remedies(SPEC, [START, row(("a",), bound_mm=2.004)]), go=False)
    assert "0.2 % above its limit" in told


def test_the_page_shows_what_the_object_itself_costs():
    section = remedies_section(SPEC, {"alternatives": [START, row(("a",), sensors=11)]}, go=False)
    specified, changed = section["alternatives"]
    assert specified == ["as specified", "5.00", "2.50", "1.00", "50 %", "32", "170", ""]
    assert changed == ["a", "1.00", "0.50", "1.00", "50 %", "+3", "+15", "pass"]


def test_what_is_not_detected_at_all_is_no_number():
    blind = row((), bound_mm=float("inf"), force_n=float("inf"))
    section = remedies_section(SPEC, {"alternatives": [blind, row(("a",))]}, go=False)
    assert section["alternatives"][0][1:4] == ["∞", "∞", "∞"]
    assert "inf" not in str(section)


def test_what_makes_it_no_better_is_no_remedy_and_of_equals_the_cheapest_comes_first():
    """One more sensor made a box worse, and a dear change stood above a free one that was as good."""
    rows = [
        START,
        row(("worse",), bound_mm=5.7, sensors=15),
        row(("dear",), bound_mm=3.0, sensors=15),
        row(("free",), bound_mm=3.01),
    ]
    assert [one.changes for one in remedies(SPEC, rows)] == [("free",), ("dear",)]


def test_a_remedy_says_where_the_force_is_no_longer_reached():
    rows = [START, row(("soft",), unreached=0.42), row(("too soft",), unreached=0.62)]
    (soft,) = remedies(SPEC, rows)
    assert "at 42 % of the locations the deepest press is then below 5 N" in soft.text


def test_price_and_minutes_are_of_what_is_added():
    (found,) = remedies(SPEC, [START, row(("both",), magnets=12, sensors=11)])
    assert (found.price, found.minutes) == pytest.approx((3.4, 19))


def test_a_change_is_not_enough_where_chips_of_virtual_objects_leave_their_range():
    (found,) = remedies(SPEC, [START, row(("strong",), of_objects=-0.2)])
    assert found.ratio == pytest.approx(1.2)
    assert not found.turns


def test_the_change_that_helps_most_comes_with_its_lines_to_copy():
    """The cheapest set that is enough, else the best single change; none where nothing has to change."""
    lines = ("sensors.count_per_face = 4",)
    enough = [START, row(("a",), bound_mm=3.0), row(("b",), sensors=15, settings=lines)]
    best = [START, row(("a",), 4.0), row(("b",), 3.0, settings=lines), row(("a", "b"), 2.5)]
    for rows in (enough, best):
        assert remedies_section(SPEC, {"alternatives": rows}, go=False)["settings"] == lines
    assert remedies_section(SPEC, {"alternatives": enough}, go=True)["settings"] == ()


@pytest.mark.parametrize(
    ("after_mm", "sentence"),
    [
        ((1.9, 0.9, 0.8), ". This halves it: sensors (edges then 0.9 mm)"),
        ((1.9, 1.5, 1.2), ". No change tried halves it; the best: magnets (edges then 1.2 mm)"),
        ((2.0, 2.5, 3.0), "; none of the changes tried makes them better"),
    ],
)
def test_weak_edges_come_with_the_cheapest_change_that_halves_their_bound(after_mm, sentence):
    changes = (("free", {}), ("sensors", {"sensors": 11}), ("magnets", {"magnets": 20}))
    rows = [row((), edge_bound_mm=2.0)] + [
        row((name,), edge_bound_mm=bound, **parts)
        for (name, parts), bound in zip(changes, after_mm, strict=True)
    ]
    if sentence.startswith(". This halves"):  # 3 € for a sensor, 2 € for ten magnets
        rows[3]["magnets"] = 30
    weak = {"edge_ratio": 1.8, "edge_paths_mm": [9.0, 9.0], "thirds": []}
    text = edges_text(SPEC, weak, rows)
    assert text == f"weak, 1.8 times as uncertain as the middle{sentence}"
    strong = weak | {"edge_ratio": 1.2}
    assert edges_text(SPEC, strong, rows) == "not weak, 1.2 times as uncertain as the middle"


@pytest.mark.parametrize(
    ("face", "direction", "said"),
    [
        (2, (1, 0), "; but the worst location lies near the middle of the edge +x of face 2, at"),
        (1, (1, 0), "; but the worst location lies near the middle of the edge +x of face 1, at"),
        (1, (0, 0), ""),
    ],
)
def test_edges_that_are_not_weak_do_not_hide_that_the_worst_location_is_at_one(
    face, direction, said
):
    """A box's "as good as the middle" stood above a worst location next to its open side."""
    xy_mm = contact_grid(SPEC).xy_mm
    bounds = np.ones((5, len(xy_mm)))
    # outermost in that direction, in the middle of the other; the middle for none
    worst = np.argmax(xy_mm @ direction - 0.1 * np.abs(xy_mm).sum(axis=1))
    bounds[face - 1, worst] = 4.0
    text = worst_edge_text(SPEC, scores_of(SPEC, bounds), {"edge_ratio": 1.0})
    assert text.startswith(said)
    assert bool(text) == bool(said)
    # face 2 runs along −z in x, and the open side is 6, −z
    assert text.endswith(", next to the open side 6") == (face == 2)
    assert worst_edge_text(SPEC, scores_of(SPEC, bounds), {"edge_ratio": 2.0}) == ""
