"""The second draw: seeds are specifications, kinds and halves take turns, edits are known keys."""

import json
import tomllib
from collections import Counter

import numpy as np
import pytest
import trimesh

from design.layout.places.fractions import with_places_in_mm
from design.spec.object import ObjectSpec
from tests.random_designs import __main__ as command
from tests.random_designs.draw import KINDS, kind_of
from tests.random_designs.draw_edits import EXAMPLES, drawn, of_example
from tests.random_designs.edits import EDITS, KEYS, value_of
from tests.random_designs.foreign_shapes import SHAPES, foreign_shape
from tests.support.pages import ROOT

A_PLACED_PAD = 9
A_PEAR = 7


@pytest.mark.parametrize("seed", [*range(A_PEAR), A_PLACED_PAD])
def test_a_seed_is_one_specification_of_its_kind(tmp_path, seed):
    tables = drawn(seed, tmp_path)
    assert tables == drawn(seed, tmp_path)
    assert tables.get("body", {}).get("kind", "box") == kind_of(seed)
    assert tables["name"] == f"edits_{seed}"


def test_kinds_turn_up_evenly_in_both_halves():
    halves = Counter((kind_of(seed), of_example(seed)) for seed in range(160))
    assert halves == {(kind, half): 10 for kind in KINDS for half in (True, False)}


def test_other_seeds_are_other_specifications(tmp_path):
    seeds = range(0, 16 * 8, 16)
    assert len({json.dumps(drawn(seed, tmp_path) | {"name": ""}) for seed in seeds}) == len(seeds)


def test_edited_keys_are_keys_of_the_specification():
    for where, _, _ in KEYS:
        fields = ObjectSpec.model_fields
        for name in where.split(".")[:-1]:
            fields = fields[name].annotation.model_fields
        assert where.split(".")[-1] in fields, where
    assert len({where for where, _, _ in KEYS}) > 40
    assert all(sum(kind in kinds for _, kinds in EDITS) > 40 for kind in KINDS)


@pytest.mark.parametrize("kind", ["box", "pad", "capsule", "dome"])
def test_one_edit_leaves_what_the_schema_takes(kind):
    """Keys that belong together change together: a magnet's part and sizes, lists and their lengths."""
    text = (ROOT / "examples" / f"{EXAMPLES[kind][0]}.toml").read_text()
    for number, (edit, kinds) in enumerate(EDITS):
        if kind in kinds:
            tables = tomllib.loads(text)
            edit(np.random.default_rng(number), tables)
            spec = ObjectSpec.model_validate(with_places_in_mm(tables))
            assert spec.body.kind == kind, "an edit keeps the kind of body"


def test_values_are_those_given_or_the_defaults():
    tables = {"shell": {"thickness_mm": 5.0}}
    assert value_of(tables, "shell.thickness_mm") == 5.0
    assert value_of(tables, "shell.slits.width_mm") == ObjectSpec(name="x").shell.slits.width_mm
    assert value_of(tables, "magnets.depth_mm") is None


@pytest.mark.parametrize("shape", SHAPES)
def test_foreign_shapes_are_closed_solids(shape):
    surface = shape(np.random.default_rng(0))
    assert surface.is_watertight
    assert surface.volume > 0.05 * np.prod(surface.extents)


def test_foreign_shapes_are_as_long_as_asked():
    for seed in range(4):
        surface = foreign_shape(np.random.default_rng(seed), 70.0)
        assert max(surface.extents) == pytest.approx(70.0)


def test_a_file_in_another_unit_is_read_as_large_as_it_was(tmp_path):
    body = drawn(A_PEAR, tmp_path)["body"]
    assert body["kind"] == kind_of(A_PEAR)
    assert body["scale"] > 2.0
    written = trimesh.load_mesh(body["file"]).extents * body["scale"]
    assert body["size_mm"] == pytest.approx(written.tolist(), rel=1e-5)
    assert max(body["size_mm"]) > 50


def test_a_table_holds_seeds_of_one_generator(tmp_path, monkeypatch, capsys):
    table = tmp_path / "rows.jsonl"
    table.write_text(json.dumps({"seed": 0, "kind": "box", "outcome": "sound", "seconds": 1.0}))
    monkeypatch.setattr("sys.argv", ["x", "--generator", "edits", "--table", str(table)])
    with pytest.raises(SystemExit):
        command.main()
    assert "holds seeds of the generator placed" in capsys.readouterr().err
