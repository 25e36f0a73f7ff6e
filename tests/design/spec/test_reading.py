"""Specification files that are no specification: one clear error each, in no time."""

import os
import time

import numpy as np
import pytest
import torch
import trimesh
from numpy.testing import assert_allclose
from pydantic import ValidationError

from design.errors import InputError, SpecError
from design.spec.object import LARGEST_SEED, ObjectSpec
from design.spec.removed import REMOVED
from design.spec_io import load_spec, parse_spec, with_overrides

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
    for path in (tmp_path / "pipe.toml", "/dev/full", tmp_path, "."):
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


def test_a_key_of_a_hundred_thousand_tables_is_one_error(tmp_path):
    """tomllib alone works on it for minutes."""
    path = tmp_path / "x.toml"
    path.write_text('name = "x"\n' + ".".join(["a"] * 100_000) + " = 1")
    with pytest.raises(InputError, match="too deep"):
        load_spec(path)


@pytest.mark.parametrize(
    ("element", "ratio", "other"),
    [("taylor-hood", 0.0, "p2"), ("taylor-hood", -0.2, "p2"), ("p2", 0.46, "taylor-hood")],
)
def test_an_element_that_cannot_take_the_ratio_names_the_one_that_does(element, ratio, other):
    content = {"silicone": {"poisson_ratio": ratio}, "name": "x"}
    with pytest.raises(InputError, match=rf'got {ratio:g}\. Use mechanics\.element = "{other}"'):
        parse_spec(content | {"mechanics": {"element": element}}, "x")
    parse_spec(content | {"mechanics": {"element": other}}, "x")


def test_a_list_with_a_wrong_entry_is_told_once():
    content = {"name": "cube", "search": {"objectives": ["nope"]}}
    with pytest.raises(SpecError) as told:
        parse_spec(content, "made up")
    assert str(told.value).count("nope") == 1
    assert "at least 1 item" not in str(told.value)


@pytest.mark.parametrize("table", sorted(set(ObjectSpec.model_fields) - {"name", "seed"}))
def test_tables_of_another_type_and_names_that_are_no_text_are_told(table):
    """Parts, grades and presets fill in what is left out before the table's keys are read."""
    names = [{key: 5} for key in ("name", "part", "grade", "material", "use")]
    for given in ("text", 5, ["x"], None, *names):
        with pytest.raises(ValidationError):
            ObjectSpec.model_validate({"name": "t", table: given})


def test_an_indenter_s_file_is_read_beside_the_specification(tmp_path):
    corners = np.array([[0.0, 0, 0], [6, 0, 8], [-6, 5, 8], [-6, -5, 8]])
    folder = tmp_path / "tips"
    folder.mkdir()
    trimesh.convex.convex_hull(corners).export(folder / "tip.stl")
    path = tmp_path / "x.toml"
    path.write_text('name = "x"\n[indenter]\nkind = "stl"\nvertices_mm = "tips/tip.stl"\n')
    found = np.array(load_spec(path).indenter.vertices_mm)
    assert_allclose(found[np.lexsort(found.T)], corners[np.lexsort(corners.T)], atol=1e-5)


@pytest.mark.parametrize(
    "number", ["9" * 5000, "9" * 4000, "0x" + "f" * 5000, str(10**31)], ids=len
)
def test_a_number_of_many_digits_is_one_error(number, tmp_path):
    """Python reads no integer of more than 4300 digits, and makes none of 309 a float."""
    path = tmp_path / "x.toml"
    path.write_text(f'name = "x"\n[shell]\nthickness_mm = {number}')
    with pytest.raises(SpecError, match=r"10\^30"):
        load_spec(path)
    path.write_text('name = "x"')
    with pytest.raises(SpecError, match=r"10\^30"):
        load_spec(path, [f"seed={number}"])


def test_a_seed_is_one_that_numpy_and_torch_take(tmp_path):
    path = tmp_path / "x.toml"
    path.write_text(f'name = "x"\nseed = {LARGEST_SEED}')
    seed = load_spec(path).seed
    np.random.RandomState(seed + 10**6)
    torch.manual_seed(seed)
    with pytest.raises(SpecError, match=r"seed: .*less than or equal"):
        load_spec(path, [f"seed={LARGEST_SEED + 1}"])


def test_a_file_that_windows_marks_as_utf_8_is_read(tmp_path):
    path = tmp_path / "x.toml"
    path.write_bytes(b'\xef\xbb\xbf# a comment\nname = "x"')
    assert load_spec(path).name == "x"


def test_a_file_in_latin_1_is_told_to_be_saved_as_utf_8(tmp_path):
    path = tmp_path / "x.toml"
    path.write_bytes('# Würfel\nname = "x"'.encode("latin-1"))
    with pytest.raises(SpecError, match=r"not text in UTF-8\. Save it"):
        load_spec(path)


@pytest.mark.parametrize("content", [b"time_s,F1-X1\n0.0,1002\n", b"\x89HDF\r\n\xff"])
def test_another_file_is_no_specification_rather_than_one_to_mend(tmp_path, content):
    """A recording was called TOML with a bad line, a data set a text to save as UTF-8."""
    path = tmp_path / "frames.csv"
    path.write_bytes(content)
    with pytest.raises(SpecError, match=r"frames\.csv is no specification\. Give the TOML file"):
        load_spec(path)


def test_a_name_without_its_ending_is_proposed_with_it(tmp_path):
    (tmp_path / "mybox.toml").write_text('name = "mybox"')
    with pytest.raises(InputError, match=r"Did you mean .*mybox\.toml\?$"):
        load_spec(tmp_path / "mybox")
    with pytest.raises(InputError, match="instobj new"):
        load_spec(tmp_path / "another")


def test_a_key_without_its_table_is_proposed_with_it(tmp_path):
    path = tmp_path / "x.toml"
    path.write_text('name = "x"\nthickness_mm = 9')
    with pytest.raises(SpecError, match=r"Did you mean 'shell\.thickness_mm'\?"):
        load_spec(path)


OF_A_FILE = """
name = "x"
[magnets]
shape = "disk"
diameter_mm = 6.0
inner_diameter_mm = 0.0
height_mm = 1.0
grade = "N50"
[shell]
pocket_diameter_mm = 6.2
pocket_depth_mm = 3.0
"""


def test_a_part_that_is_asked_for_goes_before_the_lines_of_a_file(tmp_path):
    path = tmp_path / "x.toml"
    path.write_text(OF_A_FILE)
    spec = load_spec(path, ["magnets.part=D8x2"])
    assert (spec.magnets.diameter_mm, spec.magnets.height_mm) == (8, 2)
    assert (spec.shell.pocket_diameter_mm, spec.shell.pocket_depth_mm) == (8.2, 4)
    assert spec.magnets.grade == "N50", "which this part leaves open"
    ring = load_spec(path, ["magnets.part=R6x2x2"])
    assert (ring.magnets.shape, ring.magnets.inner_diameter_mm) == ("ring", 2)
    with pytest.raises(SpecError, match=r"contradicts magnets\.part"):
        load_spec(path, ["magnets.part=D8x2", "magnets.height_mm=1"])
    wider = load_spec(path, ["magnets.part=D8x2", "shell.pocket_diameter_mm=9"])
    assert wider.shell.pocket_diameter_mm == 9


def test_a_sensor_without_figures_is_told_in_which_form_they_are_given(tmp_path):
    path = tmp_path / "x.toml"
    path.write_text('name = "x"\n[sensors]\npart = "MLX90393"')
    with pytest.raises(SpecError, match=r"sensors\.noise_counts = \[10, 10, 15\]"):
        load_spec(path)
    assert load_spec(path, ["sensors.noise_counts=[10, 10, 15]"]).sensors.part == "MLX90393"


def test_changes_from_python_are_told_without_options_of_the_command_line(tmp_path):
    path = tmp_path / "x.toml"
    path.write_text('name = "x"')
    for change in ("thickness", "name.x=1", "shell.thicknes_mm=1", "seed=" + "[" * 2000):
        with pytest.raises(SpecError) as error:
            load_spec(path, [change])
        assert "--set" not in str(error.value)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ("mesh.edge_mm=1000", "mesh.edge_mm: .*less than or equal to 100"),
        ("mesh.envelope_mm=1000", "mesh.envelope_mm: .*less than or equal to 5"),
        (
            "mesh.edge_mm=43",
            r"mesh\.edge_mm = 43 is more than the shortest edge of the body, 42 mm",
        ),
        ("mesh.surface_edge_mm=22", r"mesh\.surface_edge_mm = 22 is more than half"),
        ("mesh.envelope_mm=1.1", r"mesh\.envelope_mm = 1\.1 is more than an eighth"),
    ],
)
def test_a_mesh_that_the_body_has_no_room_for_is_refused(change, words):
    """The mesher worked on it without end, or until the memory was full."""
    key = change.partition("=")[0]
    with pytest.raises(SpecError, match=words):
        parse_spec(with_overrides({"name": "x"}, [change]), "x")
    fits = {"mesh.edge_mm": 42, "mesh.surface_edge_mm": 21, "mesh.envelope_mm": 1}[key]
    parse_spec(with_overrides({"name": "x"}, [f"{key}={fits}"]), "x")


@pytest.mark.parametrize("removed", sorted(REMOVED))
def test_what_was_removed_says_what_holds_in_its_place(removed, tmp_path):
    path, (key, _, value) = tmp_path / "x.toml", removed.partition(" = ")
    path.write_text('name = "x"')
    table, _, name = key.rpartition(".")
    of_entries = table == "environment.magnets"  # a list of tables
    change = (
        f"{table}=[{{{name}=1, position_mm=[99, 0, 0]}}]" if of_entries else f"{key}={value or 1}"
    )
    with pytest.raises(InputError) as told:
        load_spec(path, [change])
    assert f"was removed: {REMOVED[removed]}" in str(told.value)
    assert key in str(told.value)
