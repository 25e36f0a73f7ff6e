"""Blocks of code in README and pages: those that can be run in seconds are, of the others every name, option
and key is one that is taken."""

import ast
import builtins
import inspect
import re
import shlex
import shutil
import sys
import tomllib
from itertools import pairwise

import pytest
import typer
from pydantic import ValidationError

from design.spec.assembly import AsBuiltSpec
from design.spec.object import ObjectSpec
from design.spec_io import with_overrides
from estimator.grasps.damage import DamageLimit
from instobj.cli.app import with_joined_sizes
from instobj.sweep.study import StudySpec
from tests.support.objects.tiny_cube import lend_mechanics
from tests.support.pages import DOCS, ROOT, all_pages

sys.path.insert(0, str(DOCS))
from site_pages import commands

SMALL = ROOT / "examples" / "gallery" / "small_cube.toml"
NOT_RUN = {"estimator", "view", "read_recording", "fit_estimator", "predict"}
"""What takes minutes, a notebook or a recording."""
NO_LINE = re.compile(r"\.\.\.|…|\||>")
"""In lines that show a form, or go to another program."""


def blocks(*languages):
    """Every block of these languages with the page that it stands on."""
    found = []
    for page in all_pages():
        text = page.read_text()
        for language, block in re.findall(r"^```(\w*)\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
            if language in languages:
                name = f"{page.relative_to(ROOT)}-{len(found)}"
                found.append(pytest.param(block, id=name))
    return found


def _names(node):
    attributes = {one.attr for one in ast.walk(node) if isinstance(one, ast.Attribute)}
    return attributes | {one.id for one in ast.walk(node) if isinstance(one, ast.Name)}


def _function(node, known):
    """What a call's name stands for, None where that is only known when it is run."""
    if isinstance(node, ast.Name):
        return known.get(node.id)
    if isinstance(node, ast.Attribute):
        holder = _function(node.value, known)
        return None if holder is None else getattr(holder, node.attr)
    return None


def _check_calls(statement, known):
    """Functions take the arguments that they are given, by number and name."""
    for call in (one for one in ast.walk(statement) if isinstance(one, ast.Call)):
        function = _function(call.func, known)
        if function is not None:
            words = {str(word.arg): None for word in call.keywords}
            inspect.signature(function).bind(*call.args, **words)


def run_block(block, known):
    """Run a block's statements; of those that take minutes or what is not here, calls are looked at."""
    wanted = set()
    for statement in ast.parse(block).body:
        code = compile(ast.Module([statement], []), "block", "exec")
        missing = _names(statement) & wanted or any(
            isinstance(one, ast.Name)
            and isinstance(one.ctx, ast.Load)
            and one.id not in known
            and not hasattr(builtins, one.id)
            for one in ast.walk(statement)
        )
        if missing or _names(statement) & NOT_RUN:
            _check_calls(statement, known)
            targets = statement.targets if isinstance(statement, ast.Assign) else []
            wanted |= {one.id for one in targets if isinstance(one, ast.Name)}
        else:
            exec(code, known)  # noqa: S102


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """With the files that blocks name, and the small cube's mechanics in its store."""
    here = tmp_path_factory.mktemp("blocks")
    lend_mechanics(here / ".instobj")
    for name in ("my_object.toml", "cube.toml"):
        shutil.copy(SMALL, here / name)
    (here / "recording.csv").write_text("time_s,F1-X1\n0,10\n0.1,12\n0.2,11\n")
    return here


def python_pages():
    """All blocks of Python of each page, one after the other as a reader pastes them."""
    for page in all_pages():
        found = re.findall(r"^```py\w*\n(.*?)^```", page.read_text(), re.MULTILINE | re.DOTALL)
        if found:
            yield pytest.param("".join(found), id=str(page.relative_to(ROOT)))


@pytest.mark.parametrize("block", list(python_pages()))
def test_the_blocks_of_python_of_a_page_run(block, folder, monkeypatch):
    monkeypatch.chdir(folder)
    monkeypatch.setenv("INSTOBJ_STORE", str(folder / ".instobj"))
    run_block(block, {})


@pytest.mark.parametrize(
    "block",
    [
        "import instobj\ninstobj.nosuch()",
        "import instobj\nx = instobj.fit_estimator('a', no_such_option=3)",
        "from fem.presses.joint import no_such_name",
        "import instobj\ninstobj.ObjectSpec(name='x').shell.no_such_key",
    ],
)
def test_a_block_that_does_not_run_is_noticed(block):
    with pytest.raises((AttributeError, ImportError, TypeError)):
        run_block(block, {})


def _parsed(content):
    if {"specification", "latin_hypercube"} & content.keys():
        return StudySpec.model_validate({"name": "x", "specification": "x.toml"} | content)
    if "limit" in content:
        return [DamageLimit(**limit) for limit in content["limit"]]
    if isinstance(content.get("magnets"), list):
        return AsBuiltSpec.model_validate(content)
    return ObjectSpec.model_validate({"name": "x"} | content)


@pytest.mark.parametrize("block", blocks("toml"))
def test_keys_and_values_of_a_block_of_toml_are_taken(block):
    _parsed(tomllib.loads(block))


def _lines(block):
    """Whole command lines of `instobj`, without comments."""
    for line in block.replace("\\\n", " ").splitlines():
        if line.strip().startswith("instobj ") and not NO_LINE.search(line.partition("#")[0]):
            yield shlex.split(line, comments=True)[1:]


def check_line(words):
    """Raise where the command does not take these words, or the specification not these changes."""
    name, *rest = with_joined_sizes(words)
    if name == "bench":
        name, *rest = f"bench {rest[0]}", *rest[1:]
    command = commands()[name]
    command.make_context(name, list(rest), resilient_parsing=False)
    changes = [after for before, after in pairwise(rest) if before == "--set"]
    try:
        ObjectSpec.model_validate(with_overrides({"name": "x"}, changes))
    except ValidationError as error:
        # what keys say of each other is a matter of the specification that a line names
        if any(one["type"] != "value_error" for one in error.errors()):
            raise


@pytest.mark.parametrize("block", blocks("sh", "bash", ""))
def test_lines_of_a_block_of_the_shell_are_taken(block):
    for words in _lines(block):
        check_line(words)


@pytest.mark.parametrize(
    "line",
    [
        "score",
        "score a.toml --speed 3",
        "score a.toml --set shell.colour=3",
        "bench live --port-number x",
    ],
)
def test_a_line_that_a_command_does_not_take_is_noticed(line):
    with pytest.raises((typer.TyperException, ValueError)):
        check_line(line.split())


def test_there_are_blocks():
    assert len(list(python_pages())) >= 3
    assert len(blocks("sh")) >= 15
