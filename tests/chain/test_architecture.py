"""The rules of the house that a test can hold."""

import ast
import json
import re
import subprocess
import sys
from pathlib import Path

import grimp
import numpy as np
import scipy.sparse
from scipy.sparse.csgraph import connected_components

ROOT = Path(__file__).parents[2]
PACKAGES = ("design", "fem", "estimator", "instobj")
HEAVY = ("torch", "cadquery", "matplotlib", "xarray", "magpylib", "skfem", "pyvista", "trimesh")


LIGHT = (
    "design.spec.object",
    "design.layout.places.positions",
    "instobj.cli.app",
    "instobj.commands.run",
    "estimator.field.models",
    "estimator.signals.presses",
    "estimator.frames.dataset",
    "estimator.deploy.runtime",
    "instobj.commands.predict",
    "estimator.recordings.boards.link",
    "instobj.bench.collect.command",
    "fem.presses.results",
)
ARRAYS = "estimator.information.scores"
"""May import xarray; comes last."""

IMPORTS = f"""
import importlib, json, sys
found, before = {{}}, set()
for module in {[*LIGHT, ARRAYS]!r}:
    importlib.import_module(module)
    now = {{name for name in {HEAVY!r} if name in sys.modules}}
    found[module], before = sorted(now - before), now
print(json.dumps(found))
"""


def test_light_modules_import_nothing_heavy():
    """One after the other in one process, so that the first that does is named."""
    done = subprocess.run(
        [sys.executable, "-c", IMPORTS], capture_output=True, text=True, check=True, cwd=ROOT
    )
    found = json.loads(done.stdout)
    assert set(found.pop(ARRAYS)) <= {"xarray"}
    assert found == {module: [] for module in LIGHT}


def test_rooms_init_files_hold_one_question_and_import_nothing():
    """`instobj` alone hands on names, each when it is first used."""
    for package in PACKAGES:
        for path in (ROOT / package).rglob("__init__.py"):
            body = ast.parse(path.read_text(encoding="utf-8")).body
            assert isinstance(body[0], ast.Expr), f"{path} says no question"
            if path != ROOT / "instobj" / "__init__.py":
                assert len(body) == 1, path


CLAUSE = (
    r"(What|Which|Where|When|Whether|How|Why|Who|Everything|Every|All)\b|"
    r"(The |An? )?[\w`]+ (is|are|has|have|shows?|tells?|walks?|finds?)\b"
)
ORDER = (
    r"(Add|Build|Check|Design|Draw|Find|Get|Look|Make|Plant|Read|Run|Write) (an?|the|after|every)\b"
)


def test_titles_of_modules_are_nouns_so_that_an_index_reads():
    """A whole sentence on the first line; only a room's own file may ask the room's question."""
    wrong = []
    for folder in (*PACKAGES, "benchmarks"):
        for path in sorted((ROOT / folder).rglob("*.py")):
            text = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or "none"
            title = text.partition("\n")[0]
            room = path.name == "__init__.py" and path.parent != ROOT / "instobj"
            sentence = re.match(f"{CLAUSE}|{ORDER}", title)
            if not title.endswith(".") or (sentence and not room):
                wrong.append(f"{path.relative_to(ROOT)}: {title}")
    assert not wrong, "\n".join(wrong)


def test_the_public_package_loads_nothing_until_it_is_asked():
    heavy = ("numpy", "pydantic", "torch")
    code = f"import sys, instobj; print([m for m in {heavy} if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_there_is_no_import_circle_anywhere():
    """Type-only imports counted, inside rooms too: strongly connected modules of the whole graph."""
    graph = grimp.build_graph("design", "fem", "estimator", "instobj")
    modules = sorted(graph.modules)
    number = {module: k for k, module in enumerate(modules)}
    arrows = [
        (number[module], number[imported])
        for module in modules
        for imported in graph.find_modules_directly_imported_by(module)
    ]
    assert _circles(len(modules), [*arrows]) == []
    back = [(b, a) for a, b in arrows[:1]]
    assert len(_circles(len(modules), arrows + back)) == 1, "a planted back-arrow is seen"


def _circles(count, arrows):
    rows, columns = zip(*arrows, strict=True)
    matrix = scipy.sparse.csr_matrix((np.ones(len(rows)), (rows, columns)), shape=(count, count))
    _, label = connected_components(matrix, connection="strong")
    found, sizes = np.unique(label, return_counts=True)
    return found[sizes > 1].tolist()
