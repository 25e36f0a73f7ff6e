"""The contract of a kind of body: one class, one registry, and nobody else asks for its name."""

import ast
import re
from pathlib import Path

import pytest
from pydantic import ValidationError

from design.body.kinds.registry import KINDS
from design.layout.body import body_of
from design.solids.body import SOLIDS
from design.spec.object import ObjectSpec
from tests.support.objects.body_cases import body_spec

ROOT = Path(__file__).parents[3]
ASKED = re.compile(r"body\.kind (==|!=|in |not in )|\[(spec\.)?body\.kind\]")
KNOWN_BY_NAME = {"design/layout/body.py", "design/solids/body.py", "design/spec/body.py"}


def test_a_kind_s_name_is_looked_up_in_three_files_and_asked_for_nowhere_else():
    asked = {
        path.relative_to(ROOT).as_posix()
        for package in ("design", "fem", "estimator", "instobj")
        for path in (ROOT / package).rglob("*.py")
        if ASKED.search(path.read_text(encoding="utf-8"))
    }
    assert asked == KNOWN_BY_NAME


NAMED = {
    "design/solids/body.py": "exact solids, one entry per kind",
    "design/spec/body.py": "the default kind",
    "design/spec/mechanics.py": "the indenter's shape",
    "design/spec/uses.py": "the indenter's shape",
    "design/layout/tips.py": "the indenter's shape",
    "design/solids/probes.py": "the indenter's shape",
    "instobj/figures/style.py": "matplotlib's padding",
    "instobj/commands/new.py": "everyday words for shapes, and kinds of one length",
    "design/spec_io.py": "the kind that a file's keys stand for",
}
"""Files outside the kinds that hold a word which is a kind's name, and what it says there."""


def test_nothing_else_lists_kinds():
    """What is asked of a kind stands in its class."""
    named = set()
    for package in ("design", "fem", "estimator", "instobj"):
        for path in (ROOT / package).rglob("*.py"):
            place = path.relative_to(ROOT).as_posix()
            tree = ast.walk(ast.parse(path.read_text(encoding="utf-8")))
            if any(_kind_named_by(node) for node in tree):
                named.add(place)
    assert {place for place in named if not place.startswith("design/body/kinds/")} == {*NAMED}
    template = (ROOT / "instobj" / "templates" / "cube.toml").read_text(encoding="utf-8")
    # the table of the indenter has kinds and a pad of its own, whose names are those of bodies
    template = re.sub(r"^\[indenter\].*?(?=^\[)", "", template, flags=re.MULTILINE | re.DOTALL)
    assert not re.search(rf"\b({'|'.join({*KINDS} - {'box', 'cylinder', 'imported'})})\b", template)


def _kind_named_by(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, str) and node.value in KINDS


def test_every_kind_has_exact_solids_or_is_known_by_its_triangles():
    assert set(SOLIDS) == {name for name, kind in KINDS.items() if not kind.sampled}


@pytest.mark.parametrize("name", KINDS)
def test_every_kind_goes_by_its_own_name_and_opens_faces_that_it_has(name):
    kind = KINDS[name]
    assert kind.name == name
    assert set(kind.openable) <= set(kind.faces)
    assert not kind.__abstractmethods__


def test_an_unknown_kind_is_refused_with_the_names_of_all():
    with pytest.raises(ValidationError) as refused:
        ObjectSpec.model_validate({"name": "a", "body": {"kind": "cone"}})
    for name in KINDS:
        assert f"'{name}'" in str(refused.value)


def test_bodies_that_differ_inside_alone_have_one_outside():
    thin, thick = (body_of(body_spec("ellipsoid", shell={"thickness_mm": t})) for t in (7.0, 8.0))
    assert thin != thick
    assert thin.outside == thick.outside
    assert thin.outside != body_of(body_spec("sphere")).outside
