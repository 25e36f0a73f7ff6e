"""Files of stage results: declared in one module, and named nowhere else."""

import ast
import re
from pathlib import Path

import pytest

import instobj
from instobj.stages.table import STAGES
from instobj.store import readers
from instobj.store.readers import ResultFile, face_model_path, face_model_paths, published_files

SOURCE = Path(instobj.__file__).parent
DECLARED = [file for file in vars(readers).values() if isinstance(file, ResultFile)]
OWN = {"press", "press_mesh", "experiment_models"}
"""Stages of a command and of experiments, outside the chain."""
_BINARY = re.compile(r".*\w\.(nc|npz|npy|safetensors)$")


def literals(source):
    """Strings of a module that name a stage's file; docstrings are none."""
    tree = ast.parse(source)
    parts = [part for node in ast.walk(tree) for part in _hidden(node)]
    texts = [_text(node) for node in ast.walk(tree) if node not in parts]
    names = {Path(file.name).name for file in DECLARED} - {"*", "*.png"}
    return [text for text in texts if text in names or (text and _BINARY.fullmatch(text))]


def _hidden(node):
    """Docstrings, and the pieces of an f-string, which is read as a whole."""
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
        return [node.value]
    return node.values if isinstance(node, ast.JoinedStr) else []


def _text(node):
    if isinstance(node, ast.JoinedStr):
        return "".join(_text(part) or "x" for part in node.values)
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def test_no_other_module_names_a_file_of_a_stage():
    others = [path for path in SOURCE.rglob("*.py") if path != Path(readers.__file__)]
    found = {str(path.relative_to(SOURCE)): literals(path.read_text("utf-8")) for path in others}
    assert {path: names for path, names in found.items() if names} == {}


@pytest.mark.parametrize(
    "line",
    [
        'load(folder / "presses.nc")',
        'write(folder / "metrics.json")',
        'save(folder / f"frames_{kind}.nc")',
        'open("other.npz")',
    ],
)
def test_a_name_written_elsewhere_is_noticed(line):
    if "frames_" in line:
        assert literals(line.replace('f"frames_{kind}.nc', '"frames_paper.nc'))
    else:
        assert literals(line)
    assert not literals(f'"""Says {line[:4]}presses.nc in words."""')


def test_a_declared_file_belongs_to_a_stage_and_is_declared_once():
    assert {file.stage for file in DECLARED} <= STAGES.keys() | OWN
    published = [(file.stage, file.name) for file in DECLARED if file.published]
    assert len(published) == len(set(published))


def test_only_published_files_are_given_to_users_in_the_order_of_their_declaration(tmp_path):
    for name in ("protocol.json", "frames.nc", "other.txt"):
        (tmp_path / name).write_text("")
    assert published_files("frames", tmp_path) == [tmp_path / "frames.nc"]
    (tmp_path / "maps").mkdir()
    for name in ("maps/b.png", "maps/a.png", "scores.csv", "cross_face.json"):
        (tmp_path / name).write_text("")
    assert [path.name for path in published_files("scores", tmp_path)] == [
        "scores.csv",
        "cross_face.json",
        "a.png",
        "b.png",
    ]


def test_estimators_are_found_where_they_are_written(tmp_path):
    for face in (4, 2):
        face_model_path(tmp_path, face).write_bytes(b"")
    assert [path.name for path in face_model_paths(tmp_path)] == [
        "face_2.safetensors",
        "face_4.safetensors",
    ]
