"""Specification files that are no specification: one clear error each, in no time."""

import os
import time

import pytest

from design.errors import InputError
from design.spec_io import load_spec, with_overrides

FILES = {
    "deep": ("x = " + "[" * 500 + "]" * 500, "nests brackets or tables too deep"),
    "many keys": ("\n".join(f"a{k}.b.c = 1" for k in range(100_000)), "250000 at most"),
    "null byte": (
        'name = "x"\n[body]\nkind = "imported"\nfile = "a\\u0000b.stl"',
        "not a file name",
    ),
    "long name": (f'name = "x"\nas_built = "{"y" * 400}"', "File name too long"),
    "folder": ('name = "x"\nprinter = "."', "a folder"),
}


@pytest.mark.parametrize(("text", "said"), FILES.values(), ids=FILES)
def test_a_file_that_cannot_be_a_specification_is_one_error(text, said, tmp_path):
    path = tmp_path / "x.toml"
    path.write_text(text)
    started = time.process_time()
    with pytest.raises(InputError, match=said):
        load_spec(path)
    assert time.process_time() - started < 5, "a file of this kind took for ever"


def test_pipes_and_devices_are_not_read(tmp_path):
    os.mkfifo(tmp_path / "pipe.toml")
    for path in (tmp_path / "pipe.toml", "/dev/full", tmp_path):
        with pytest.raises(InputError, match="not a file"):
            load_spec(path)


def test_a_deeply_nested_override_is_one_error():
    with pytest.raises(InputError, match="too deep"):
        with_overrides({"name": "x"}, ["seed=" + "[" * 2000])


@pytest.mark.parametrize("ratio", [0.0, -0.1, 0.51])
def test_poissons_ratio_that_no_element_takes_is_refused(ratio, tmp_path):
    """0 passed `check` and ended `simulate` with a traceback: 1/λ is not finite there."""
    path = tmp_path / "x.toml"
    path.write_text(f'name = "x"\n[silicone]\npoisson_ratio = {ratio}')
    with pytest.raises(InputError, match=r"silicone\.poisson_ratio"):
        load_spec(path)
