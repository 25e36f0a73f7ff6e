"""Batches of layouts against the specification that each is: places, limits, gradients, polish."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from design.errors import InputError
from design.fabrication.layout import failures, layout_findings
from design.layout.boards import smallest_recess_wall_mm
from design.search.places import polarities
from design.search.space import params_at, search_space, with_layout
from design.search.structure import with_structure
from design.spec_io import parse_spec
from estimator.layouts.batch import layouts_of
from estimator.layouts.limits.rules import RULES, constraint_violations_mm
from estimator.layouts.polish import descend
from estimator.layouts.vectors import layout_space, layouts_at
from tests.support.objects.layout_batches import VARY, batch


def unchecked(spec, params, monkeypatch):
    """The layout as a specification, whether it fits or not."""
    monkeypatch.setattr("design.spec_io.require_fit", lambda spec, table=True: None)
    return with_layout(spec, params)


def test_tensors_are_those_of_the_specification(monkeypatch):
    spec, space, params, poles, units = batch(count=6)
    found = layouts_at(space, units, poles, 3)
    for row, one in enumerate(params):
        wanted = layouts_of(unchecked(spec, one, monkeypatch), 3, torch.float64)
        assert_allclose(found.magnet_mm[row], wanted.magnet_mm[0], rtol=0, atol=0.0051)
        assert_allclose(found.turn_rad[row], wanted.turn_rad[0], rtol=0, atol=np.deg2rad(0.051))
        assert_allclose(found.polarity[row], wanted.polarity[0], rtol=0, atol=0)
        assert_allclose(found.sensor_mm[row], wanted.sensor_mm[0], rtol=0, atol=0.0051)


def test_faces_of_each_size_have_a_layout_of_their_own(monkeypatch):
    """Of a box with unequal edges: faces 2 and 4 share one, and 3 and 5; depths are those of all."""
    body = {"body": {"size_mm": [60.0, 44.0, 40.0]}, "core": {"wall_mm": 5.0}}
    search = {"vary": {**VARY, "magnet_tilt_deg": None}}
    search["vary"] = {key: value for key, value in search["vary"].items() if value is not None}
    spec = parse_spec({"name": "box", **body, "search": search}, "made up")
    space = search_space(spec)
    units = np.random.default_rng(3).random((3, len(space.variables)))
    params = [params_at(space, unit) for unit in units]
    tensors = layout_space(space, with_structure(spec, params[0]), torch.float64)
    assert tensors.groups == ((1,), (2, 4), (3, 5))
    poles = torch.tensor([polarities(spec, one) for one in params], dtype=torch.float64)
    flags = [not v.choices for v in space.variables]
    found = layouts_at(tensors, torch.as_tensor(units[:, flags]), poles, 3)
    assert not torch.equal(found.layouts_of_face(1).magnet_mm, found.magnet_mm)
    assert torch.equal(found.layouts_of_face(5).magnet_mm, found.magnet_mm)
    for row, one in enumerate(params):
        laid = layouts_of(unchecked(spec, one, monkeypatch), 3, torch.float64)
        for face in spec.body.sensed:
            for name in ("magnet_mm", "polarity", "sensor_mm"):
                wanted, told = (getattr(each.layouts_of_face(face), name) for each in (laid, found))
                assert_allclose(told[row], wanted[0], rtol=0, atol=0.0051)
    one = found[1:2]
    assert one.face == 3
    assert torch.equal(one.layouts_of_face(2).sensor_mm[0], found.layouts_of_face(2).sensor_mm[1])
    moved = found.map_faces(lambda each, face: replace(each, magnet_mm=each.magnet_mm + face))
    assert torch.equal(moved.magnet_mm, found.magnet_mm + 3)
    assert torch.equal(moved.layouts_of_face(4).magnet_mm, found.layouts_of_face(4).magnet_mm + 4)


WORDS = {
    "pocket gap": ("touch or overlap",),
    "pockets near the edge": ("zone of the neighbouring", "outside the shell's face"),
    "seal": ("does not seal",),
    "boards near the edge": ("recess outside the core",),
}


def verdicts(seed):
    """For near misses and near hits: the rules broken, and what the specification's check says."""
    spec, space, params, poles, units = batch(seed, 12)
    variables = search_space(spec).continuous

    def broken(point):
        return constraint_violations_mm(space, layouts_at(space, point, poles, 1), 1)

    for steps in (8, 60):
        point = descend(lambda u: broken(u).sum(dim=1), units, steps)
        for row, rules in enumerate(broken(point)):
            values = zip(variables, point[row].tolist(), strict=True)
            moved = {v.name: v.low + u * (v.high - v.low) for v, u in values}
            try:
                with_layout(spec, params[row] | moved)
                said = ""
            except InputError as error:
                said = str(error)
            yield rules, said, spec, params[row] | moved


def test_limits_agree_with_the_specifications_check():
    """Kept limits fit and can be made; what does not fit breaks the limit of that name."""
    kept = refused = 0
    for rules, said, spec, params in verdicts(2):
        if float(rules.sum()) == 0:
            assert not said
            assert not failures(layout_findings(with_layout(spec, params)))
            kept += 1
        for rule, words in WORDS.items():
            if any(word in said for word in words):
                assert rules[RULES.index(rule)] > 0, (rule, said)
                refused += 1
    assert kept >= 4
    assert refused >= 4


def test_walls_between_recesses_are_those_of_the_core(monkeypatch):
    spec, space, params, poles, units = batch(5, 60, wall_mm=0.1)
    missing = constraint_violations_mm(space, layouts_at(space, units, poles, 1), 1)[
        :, RULES.index("board gap")
    ]
    walls = np.array([smallest_recess_wall_mm(unchecked(spec, one, monkeypatch)) for one in params])
    least = spec.printer.wall_mm
    clear = walls > least + 0.04
    assert clear.any()
    assert (missing.numpy()[clear] == 0).all()
    assert (missing.numpy()[walls < least] >= least - walls[walls < least] - 0.02).all()


@pytest.mark.parametrize(
    "rule", [k for k, name in enumerate(RULES) if name != "magnets in the core"]
)
def test_gradients_of_limits_are_those_of_differences(rule):
    _, space, _, poles, units = batch(7, 40)

    def broken(point):
        return constraint_violations_mm(space, layouts_at(space, point, poles, 1), 1)[:, rule]

    point = units.clone().requires_grad_()
    (slope,) = torch.autograd.grad(broken(point).sum(), point)
    way = torch.as_tensor(np.random.default_rng(1).normal(size=units.shape))
    step = 1e-6
    numeric = (broken(units + step * way) - broken(units - step * way)) / (2 * step)
    assert_allclose((slope * way).sum(dim=1), numeric, rtol=1e-3, atol=1e-4)
    assert float(broken(units).max()) > 0 or RULES[rule] == "seal"


FABRICATION = {
    "pocket gap": "pocket spacing",
    "pocket gap across an edge": "pocket spacing across an edge",
    "boards near the edge": "wall beside a side of the core",
    "board beside the wire hole": "wall beside the wire hole",
}


def test_limits_of_fabrication_have_its_figures(monkeypatch):
    """What fails breaks the limit of that name, and nothing is refused that is clear of it."""
    spec, space, params, poles, units = batch(11, 30)
    broken = constraint_violations_mm(space, layouts_at(space, units, poles, 1), 1)
    seen = dict.fromkeys((*FABRICATION, "seal"), 0)
    for row, one in enumerate(params):
        found = {f.check: f for f in layout_findings(unchecked(spec, one, monkeypatch))}
        missing = {check: f.limit - f.value for check, f in found.items()}
        silicone = max(missing["seal over the magnets"], missing["breakthrough"])
        wanted = {rule: missing[check] for rule, check in FABRICATION.items() if check in missing}
        for rule, short in (wanted | {"seal": silicone}).items():
            told = float(broken[row, RULES.index(rule)])
            if short > 0.02:  # a recess by the wire hole may also move over it
                inward = rule == "board beside the wire hole"
                assert told > (0 if inward else short - 0.02), (rule, short, told)
                seen[rule] += 1
            if short < -0.05:
                assert told == 0, (rule, short, told)
    assert min(seen.values()) > 0, seen


def test_descent_never_ends_worse_and_stays_inside():
    start = torch.as_tensor(np.random.default_rng(3).random((20, 4)))

    def loss(point):
        return ((point - 1.2) ** 2).sum(dim=1) + torch.sin(40 * point).sum(dim=1)

    end = descend(loss, start, 60)
    assert (loss(end) <= loss(start)).all()
    assert float(end.max()) <= 1
    assert float(loss(end).mean()) < float(loss(start).mean()) - 2
