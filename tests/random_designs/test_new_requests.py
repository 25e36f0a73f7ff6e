"""Random requests: drawn from their seed, asked again as a refusal names it, counted."""

import json
from types import SimpleNamespace

import pytest
import trimesh

from design.errors import SpecError
from design.fabrication.finding import Finding
from tests.random_designs import new_requests
from tests.random_designs.draw import KINDS
from tests.random_designs.new_requests import asked, drawn, named
from tests.random_designs.summary import summary_of_requests

REFUSAL = (
    "a body of kind box of 20 × 30.5 × 12 mm is too small for 3 sensors and 5 magnets per face. The "
    "smallest of that shape that works is about 40 × 61 × 24 mm with sensors on faces 1, 2 alone; or with "
    "its short edges longer about 33 × 33 × 33.5 mm works; or --kind pad, a slab of that size on a rigid "
    "base, sensed from above, would fit; or 2 sensors per face would fit; or 1 magnet per face would fit"
)
OPTIONS = {"kind": "box", "size_mm": [20.0, 30.5, 12.0], "sensors": 3, "magnets": 5}


def test_a_seed_is_one_request_within_a_hand(tmp_path):
    for seed, kind in enumerate(KINDS):
        options = drawn(seed, tmp_path)
        assert options == drawn(seed, tmp_path)
        assert options["kind"] == kind
        assert 1 <= options["sensors"] <= 4
        if kind == "imported":
            surface = trimesh.load_mesh(options["file"])
            assert 30 <= max(surface.extents) * options["scale"] <= 150
        else:
            assert 9 <= min(options["size_mm"]) <= max(options["size_mm"]) <= 112.1


def test_what_a_refusal_names_is_asked_for():
    assert named(REFUSAL, OPTIONS) == [
        OPTIONS | {"size_mm": [40.0, 61.0, 24.0]},
        OPTIONS | {"size_mm": [33.0, 33.0, 33.5]},
        OPTIONS | {"kind": "pad"},
        OPTIONS | {"sensors": 2},
        OPTIONS | {"magnets": 1},
    ]
    scaled = REFUSAL.replace("24 mm with", "24 mm (scale = 2.5) with")
    assert named(scaled, OPTIONS)[0] == OPTIONS | {"scale": 2.5}


@pytest.mark.parametrize("faces", ["", ", that takes parts on 4 faces"])
def test_a_simple_body_that_a_refusal_names_is_asked_for_in_place_of_the_file(faces):
    refusal = (
        f"bent. Straighten it; or take a simple body, as --kind capsule --size 26 26.5 193{faces}"
    )
    body = {"kind": "capsule", "size_mm": [26.0, 26.5, 193.0], "sensors": 2}
    options = {"kind": "imported", "file": "scissors.stl", "scale": 1000.0, "sensors": 2}
    assert named(refusal, options) == [body]


THIN = Finding("thinnest wall", "core", 0.5, 0.8, "mm", "fail", "thicken it", (1.0, 2.0, 3.0))
GOOD = Finding("thinnest wall", "core", 0.9, 0.8, "mm", "pass", "")


@pytest.mark.parametrize(
    ("answers", "findings", "outcome"),
    [
        ([None], [GOOD], "passes"),
        ([None], [GOOD, THIN], "fails"),
        (["warned"], [THIN], "told"),
        (["seam"], [GOOD], "false alarm"),
        (["seam"], [THIN], "fails"),
        ([SpecError(REFUSAL), *[None] * 5], [GOOD], "refused"),
        ([SpecError(REFUSAL), *[None] * 5], [THIN], "false advice"),
        ([ValueError("broken")], [GOOD], "crash"),
    ],
)
def test_requests_are_judged_by_both_checks(monkeypatch, tmp_path, answers, findings, outcome):
    left = list(answers)

    def new(name, out, request):
        answer = left.pop(0)
        if isinstance(answer, Exception):
            raise answer
        if answer == "warned":
            new_requests.warnings.warn("check --fabrication fails on this body: core", stacklevel=2)

    patched = {
        "drawn": lambda seed, folder: OPTIONS,
        "new_specification": new,
        "load_spec": lambda path: path,
        "check": lambda spec: None,
        "seam_in_words": lambda spec: ["the seam"] * (answers[0] == "seam"),
        "check_fabrication": lambda spec: SimpleNamespace(findings=findings),
    }
    for name, value in patched.items():
        monkeypatch.setattr(new_requests, name, value)
    monkeypatch.setattr(new_requests.resource, "setrlimit", lambda *given: None)
    row = asked({"generator": "new", "seed": 8, "folder": str(tmp_path)})
    assert (row["kind"], row["outcome"], left) == ("box", outcome, [])
    json.dumps(row)
    text = summary_of_requests([row, row | {"outcome": "passes", "seconds": 61.0}])
    faults = outcome in ("fails", "false alarm", "false advice", "crash")
    assert f"faults: {int(faults)} of 2" in text
    assert "over 60 s: 1 of 2" in text
