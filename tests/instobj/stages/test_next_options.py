"""Options to try next: taken by `check` as they are pasted, and forecast to be no worse."""

import re

from design.spec.object import ObjectSpec
from design.spec_io import check, parse_spec, with_overrides
from estimator.layouts import without_mesh
from estimator.layouts.without_mesh import first_score
from instobj.stages.makers.next_options import next_options

SPEC = ObjectSpec(name="a")


def test_options_are_taken_by_check_and_forecast_no_worse():
    """A thinner shell was advised that `check` refused, or that it forecast to be three times worse."""
    options = next_options(SPEC)
    assert options == ["--set magnets.height_mm=1.5"]
    pasted = re.findall(r"--set (\S+)", " ".join(options))
    now = first_score(SPEC)
    after = first_score(check(parse_spec(with_overrides({"name": "a"}, pasted), "a")))
    assert after.median_mm < now.median_mm
    assert after.percentile_95_mm < now.percentile_95_mm
    shallow = SPEC.changed(shell={"thickness_mm": 6.0}, press={"depths_mm": [1.0, 2.0, 3.0]})
    worse = first_score(check(shallow))
    assert worse.percentile_95_mm > now.percentile_95_mm, "why a thinner shell is left out"


def test_what_cannot_be_forecast_is_not_offered():
    turns = ((0.0, 0.0, 10.0),) * 3
    assert next_options(SPEC.changed(sensors=SPEC.sensors.changed(rotations_deg=turns))) == []


def test_a_catalogued_part_stays_as_no_option_leaves_it_out():
    """The file's part and the option's height would contradict each other."""
    part = parse_spec({"name": "a", "magnets": {"part": "D6x1"}}, "a")
    assert part.magnets.height_mm == SPEC.magnets.height_mm
    assert not [option for option in next_options(part) if "magnets" in option]


def test_the_design_itself_is_forecast_once(monkeypatch):
    """It was once for every option."""
    spec = check(SPEC.changed(press={"depths_mm": [0.5, 1.0]}))
    forecast = list[ObjectSpec]()

    def counted(given):
        forecast.append(given)
        return first_score(given)

    monkeypatch.setattr(without_mesh, "first_score", counted)
    next_options(spec)
    assert len(forecast) == 3, "the design, higher magnets and a thinner shell"
    assert forecast.count(spec) == 1
