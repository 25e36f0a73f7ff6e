"""What all checks find, part by part; where a surface does not close, its checks are left out."""

from types import SimpleNamespace

import pytest

from design.errors import NotOneSolid
from design.fabrication import check


@pytest.fixture
def told(monkeypatch):
    """Every check tells its own name and part."""
    closed = {"core": "core's mesh", "shell": None, "jig": "jig's mesh"}

    def broken():
        raise NotOneSolid("in pieces", "pieces")

    parts = [
        SimpleNamespace(name=name, make=broken if name == "shell" else lambda name=name: name)
        for name in closed
    ]
    monkeypatch.setattr(check, "parts_of", lambda spec: parts)
    monkeypatch.setattr(
        check, "check_solid", lambda name, shape, spec: ([f"solid {shape}"], closed[name])
    )
    monkeypatch.setattr(check, "check_walls", lambda part, mesh, spec: [f"walls {mesh}"])
    monkeypatch.setattr(check, "check_edges", lambda part, mesh: [f"edges {mesh}"])
    monkeypatch.setattr(check, "check_bed", lambda part, mesh, spec: [f"bed {mesh}"])
    for name in ("features", "inhibition", "pockets"):
        monkeypatch.setattr(check, f"check_{name}", lambda spec, name=name: [name])
    monkeypatch.setattr(check, "check_electronics", lambda spec, core: [f"electronics {core}"])
    monkeypatch.setattr(check, "check_tools", lambda spec, meshes: ["tools"])
    monkeypatch.setattr(check, "check_casting", lambda spec, meshes: [f"casting {sorted(meshes)}"])
    monkeypatch.setattr(
        check, "Checked", lambda findings, meshes: SimpleNamespace(findings=findings, meshes=meshes)
    )
    return closed


OF_SPEC = ["features", "inhibition", "pockets"]


def found(name, mesh):
    return [f"walls {mesh}", f"edges {mesh}", f"bed {mesh}"] if mesh else []


def test_all_that_is_found_is_told_in_the_order_of_the_parts(told):
    said = []
    checked = check.check_fabrication.__wrapped__(None, said.append)
    assert checked.findings == [
        "solid core", *found("core", told["core"]), "solid pieces",
        "solid jig", *found("jig", told["jig"]), *OF_SPEC,
        "electronics core's mesh", "tools", "casting ['core', 'jig']",
    ]  # fmt: skip
    assert checked.meshes == {"core": told["core"], "jig": told["jig"]}
    assert said[:3] == ["checking core", "checking shell", "checking jig"]
    assert "checking boards, chips and wires" in said


def test_without_a_closed_core_its_electronics_are_left_out(told):
    told["core"] = None
    checked = check.check_fabrication.__wrapped__(None)
    assert checked.findings == [
        "solid core", "solid pieces", "solid jig", *found("jig", told["jig"]), *OF_SPEC,
        "tools", "casting ['jig']",
    ]  # fmt: skip
