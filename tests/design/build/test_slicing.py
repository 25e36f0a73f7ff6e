"""Parts as PrusaSlicer slices them: its settings reach the layers, and no part of any example warns."""

import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
import trimesh

from design.build.export import write_part
from design.build.parts import parts_of
from design.build.print_settings import PrintSettings
from design.build.slicer_file import write_3mf
from design.build.slicing import SLICER, has_slicer, print_job
from design.spec_io import load_spec

EXAMPLES = sorted((Path(__file__).parents[3] / "examples").glob("*.toml"))
needs_slicer = pytest.mark.skipif(not has_slicer(), reason="prusa-slicer is not installed (Debian)")
pytestmark = [pytest.mark.slow, needs_slicer]
ITS_OWN = (
    "Detected missing Voronoi vertex, input polygons will be rotated back and forth.",
    "Reversing even wall line causes it to be printed CCW instead of CW!",
)
"""PrusaSlicer of the walls that it lays: where it repaired its own diagram, and where it joined a line
of a narrow wall backwards. The layers are whole, and the second comes and goes with how the part is
turned on the bed: also of an upright prism of 60 corners, edges of 0.39 mm and more, turned by 1° of
twelve angles, while the egg's core gives it at two of seven, before and after its triangles are
simplified within 0.01 mm."""
FLAT = PrintSettings(0.2, 3, 20, False, 0.0, (0.0, 0.0, -1.0))


def sliced(path):
    """What the slicer says, without its progress, and the levels (mm) of the layers."""
    code = path.with_suffix(".gcode")
    bed = ("--bed-shape", "0x0,220x0,220x220,0x220", "--first-layer-height", "0.2")
    command = [SLICER, "--export-gcode", "--loglevel", "2", *bed, "-o", str(code), str(path)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=900, check=False)
    said = [
        line
        for line in (done.stdout + done.stderr).splitlines()
        if line and not re.match(r"\d+ =>|\[.*\[trace\]|Slicing result exported", line)
        if not any(words in line for words in ITS_OWN)
    ]
    levels = re.findall(r"^;Z:([\d.]+)", code.read_text(), re.M) if code.is_file() else []
    return said if done.returncode == 0 else [*said, f"exit {done.returncode}"], levels


def warnings_of(spec, folder):
    """Every word of warning about a printed part of an object, by the part's name."""
    found = {}
    for part in parts_of(spec):
        manifest, _ = write_part(part, part.make(), folder, spec)
        if manifest.printing is not None:
            said, levels = sliced(folder / f"{part.name}.3mf")
            low, high = min(map(float, levels), default=0.0), max(map(float, levels), default=0.0)
            assert 0 < low < 1 < high, f"{part.name}: layers from {low} to {high}"
            found |= {part.name: said} if said else {}
    return found


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_every_part_of_an_example_slices_without_a_warning(path, tmp_path):
    assert warnings_of(load_spec(path), tmp_path) == {}


KEYS = ["core.keys.size_mm=[2, 2, 1.5]"]
CHOICES = {
    "handle": [
        "shell.seal_layer_mm=0.6",
        "core.keys.positions_mm=[[0, -6]]",
        "shell.slits.depth_mm=4",
        "core.wire_channel_mm=[2, 1]",
        "core.bay_mm=[10, 10, 12]",
        *KEYS,
    ],
    "egg": [
        "body.open_faces=[]",
        "shell.seal_layer_mm=0.6",
        "core.keys.positions_mm=[[9, -6]]",
        *KEYS,
    ],
    "pear": ["body.open_faces=[]", "shell.seal_layer_mm=0.5"],
    "capsule": [
        "shell.seal_layer_mm=0.5",
        "core.keys.positions_mm=[[0, -6]]",
        "core.wire_channel_mm=[2, 1]",
        *KEYS,
    ],
    "hall_skin": [
        "shell.seal_layer_mm=0.5",
        "core.bay_mm=[10, 8, 2]",
        "core.wire_channel_mm=[1, 1]",
    ],
    "hollow_dome": ["shell.seal_layer_mm=0.5"],
    "three_axis_dome": ["shell.seal_layer_mm=0.5"],
}
"""What no example asks for: layers, keys, slits, bays, channels and sockets on curved bodies and pads."""


@pytest.mark.parametrize("name", CHOICES)
def test_parts_with_layers_keys_slits_and_bays_slice_without_a_warning(name, tmp_path):
    path = next(path for path in EXAMPLES if path.stem == name)
    assert warnings_of(load_spec(path, CHOICES[name]), tmp_path) == {}


def test_a_part_that_floats_is_warned_of(tmp_path):
    lower, upper = trimesh.creation.box((10, 10, 10)), trimesh.creation.box((10, 10, 10))
    both = trimesh.util.concatenate([lower, upper.apply_translation((0, 0, 20))])
    write_3mf(both, "floating", tmp_path / "floating.3mf", FLAT, (220.0, 220.0))
    said, _ = sliced(tmp_path / "floating.3mf")
    assert any("Empty layer" in line for line in said)


def test_the_slicer_takes_layer_and_side_from_the_file(tmp_path):
    """A slab of 10 × 20 × 30 mm lies on its side of 20 × 30 mm, in layers of 0.1 mm."""
    settings = PrintSettings(0.1, 2, 0, False, 0.0, (1.0, 0.0, 0.0))
    write_3mf(
        trimesh.creation.box((10, 20, 30)), "slab", tmp_path / "slab.3mf", settings, (220.0, 220.0)
    )
    said, levels = sliced(tmp_path / "slab.3mf")
    assert said == []
    assert float(levels[-1]) == pytest.approx(10.0, abs=0.05)
    assert len(levels) == pytest.approx(99, abs=2), "0.2 mm, then 98 of 0.1 mm"


def test_a_slab_takes_the_filament_of_its_volume_and_a_large_part_is_refused(tmp_path):
    """Solid layers hold 10 × 20 × 30 mm; twice as many take nearly twice as long."""
    solid = PrintSettings(0.2, 2, 100, False, 0.0, (1.0, 0.0, 0.0))
    printer, jobs = load_spec(EXAMPLES[0]).printer, []
    for height in (10, 20, 300):
        path = tmp_path / f"{height}.3mf"
        slab = trimesh.creation.box((height, 20, 30 if height < 300 else 300))
        write_3mf(slab, "slab", path, solid, (220.0, 220.0))
        jobs.append(print_job(path, printer))
    assert jobs[0].filament_g == pytest.approx(6.0 * printer.preset.density_g_per_cm3, rel=0.05)
    assert 1.7 * jobs[0].minutes < jobs[1].minutes < 2.1 * jobs[0].minutes
    assert jobs[2] is None


def extruded(path):
    """By kind of line in the G-code: length of the moves that extrude (mm), and their places (n, 2)."""
    kind, at, found = "", np.zeros(2), {}
    for line in path.with_suffix(".gcode").read_text().splitlines():
        kind = line.removeprefix(";TYPE:") if line.startswith(";TYPE:") else kind
        move = re.match(r"G1(?=.*[XY])", line)
        if move is None:
            continue
        there = at.copy()
        for axis, value in re.findall(r"([XY])(-?[\d.]+)", line):
            there["XY".index(axis)] = float(value)
        if re.search(r"E[\d.]", line):
            length, places = found.get(kind, (0.0, []))
            found[kind] = (length + float(np.linalg.norm(there - at)), [*places, there])
        at = there
    return {kind: (length, np.array(places)) for kind, (length, places) in found.items()}


def sliced_block(folder, name, settings, mesh=None):
    mesh = trimesh.creation.box((20, 20, 12)) if mesh is None else mesh
    write_3mf(mesh, name, folder / f"{name}.3mf", settings, (220.0, 220.0))
    assert sliced(folder / f"{name}.3mf")[0] == []
    return extruded(folder / f"{name}.3mf")


def test_the_slicer_takes_walls_infill_and_brim_from_the_file(tmp_path):
    """G-code, not its header, which tells the program's defaults whatever the object says."""
    plain = sliced_block(tmp_path, "plain", PrintSettings(0.2, 2, 15, False, 0.0, (0.0, 0.0, -1.0)))
    full = sliced_block(tmp_path, "full", PrintSettings(0.2, 4, 30, False, 4.0, (0.0, 0.0, -1.0)))
    walls = [one["Perimeter"][0] / one["External perimeter"][0] for one in (plain, full)]
    assert walls == pytest.approx([1.0, 3.0], rel=0.15)
    infill = [one["Internal infill"][0] for one in (plain, full)]
    assert infill[1] / infill[0] == pytest.approx(2.0 * (16 / 18) ** 2, rel=0.15)
    reach = [np.ptp(one["Skirt/Brim"][1], axis=0).max() / 2 - 10 for one in (full,)]
    assert reach[0] >= 3.5


def test_the_slicer_takes_supports_from_the_file(tmp_path):
    post, roof = trimesh.creation.box((6, 6, 12)), trimesh.creation.box((24, 24, 3))
    table = trimesh.boolean.union([post, roof.apply_translation((0, 0, 7.5))])
    with_, without = (
        sliced_block(
            tmp_path, name, PrintSettings(0.2, 2, 15, wanted, 0.0, (0.0, 0.0, -1.0)), table
        )
        for name, wanted in (("with", True), ("without", False))
    )
    assert "Support material" in with_
    assert "Support material" not in without
