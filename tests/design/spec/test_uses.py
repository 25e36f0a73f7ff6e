"""Keys that the chosen kind does not use are refused where they are written, by one table."""

import tomllib
from pathlib import Path

import pytest

from design.errors import SpecError
from design.spec.object import ObjectSpec
from design.spec.uses import USES, require_used
from design.spec_io import load_spec

EXAMPLES = sorted((Path(__file__).parents[3] / "examples").rglob("*.toml"))


def field(key):
    """A key's default, by its dotted name."""
    table, _, name = key.partition(".")
    default = ObjectSpec.model_fields[table].default
    return getattr(default, name) if name else default


@pytest.mark.parametrize("key", list(USES))
def test_every_key_of_the_table_is_refused_for_other_kinds_alone(key):
    """Another value than the default, with kinds that use it and with those that do not."""
    deciding, values = USES[key]
    table, name = key.split(".")
    assert field(key) != "another"
    kinds = {"indenter.tip_count": [1, 2, 3], "mould.style": [None, "split", "one-piece"]}
    others = kinds.get(deciding) or [field(deciding), *values, "of no other kind"]
    assert set(values) <= set(others)
    for kind in others:
        content = {table: {name: "another"}}
        top, _, inner = deciding.partition(".")
        if kind is not None:
            content[top] = kind if not inner else content.get(top, {}) | {inner: kind}
        if kind in values:
            require_used(content)
        else:
            with pytest.raises(SpecError, match=f"{key} = 'another' has no effect with {deciding}"):
                require_used(content)


def test_defaults_that_are_written_out_pass():
    for key in USES:
        table, name = key.split(".")
        default = field(key)
        require_used({table: {name: list(default) if isinstance(default, tuple) else default}})


@pytest.mark.parametrize("path", EXAMPLES, ids=[path.stem for path in EXAMPLES])
def test_examples_write_no_key_in_vain(path):
    require_used(tomllib.loads(path.read_text(encoding="utf-8")))


def test_a_file_and_an_override_are_refused_with_what_would_use_the_key(tmp_path):
    path = tmp_path / "cube.toml"
    path.write_text('name = "cube"\n[indenter]\nfillet_mm = 1\n')
    with pytest.raises(
        SpecError, match=r"cube\.toml is not.*\n.*indenter\.kind = 'flat' or 'cuboid'"
    ):
        load_spec(path)
    path.write_text('name = "cube"\n[indenter]\nradius_mm = 4\n')
    with pytest.raises(SpecError, match=r"--set is not.*\n.*mould\.parting_azimuth_deg = 9 has no"):
        load_spec(path, ["mould.style=one-piece", "mould.parting_azimuth_deg=9"])
    box = ["indenter.kind=cuboid", "indenter.size_mm=[8,6]"]
    assert load_spec(path, box).indenter.size_mm == (8, 6), "the file's radius is of its own kind"
