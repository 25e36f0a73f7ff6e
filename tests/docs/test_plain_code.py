"""Names and docstrings of the code are plain: no room gains a pattern that a reader stumbles over."""

import ast
import re
from collections import Counter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
PACKAGES = ("design", "fem", "estimator", "instobj")

PLACEHOLDERS = re.compile(
    "found|one|own|told|left|known|other|there|every|before|along|at|seen|asked"
)
"""Names that do not say what they hold; `left` is plain where `right` stands with it."""
PREPOSITIONS = re.compile(
    "_*(of|at|in|as|by|on|over|under|after|before|between|through|for|into|onto|per|within|beyond|beside|"
    "its|their|whose|which|what|where|when|how|it|they|those|these|this|that|both|each|every)(_.*)?"
)
"""Function names whose first word is neither verb nor noun; `to_`, `from_`, `with_` and `without_` are
Python's own idioms (`Path.with_suffix`, `dict.fromkeys`)."""
OPENINGS = re.compile(r"(What|Of|Whether|Where|How|Which|By|As)\s")
"""First words of docstrings and of notes on constants that are neither verb nor noun."""
WORDS = re.compile(
    r"\b(told|tells|beside|anew|those that|is that of|so many|by turns|worked out)\b"
)
"""Words of docstrings with a plainer one: reported, says, next to, again, computed."""

MOST = {
    "estimator/networks": (1, 0, 0, 0),  # known, the name of a stored tensor
    "instobj/cli": (1, 0, 0, 0),  # at, an option's name
    "instobj/commands": (1, 0, 0, 0),  # at, the same
}
"""Most placeholder names, function names, openings and words of a room; none where it is not listed.
Lower a number when a room gets plainer; never raise one."""


def _room_of(path: Path) -> str:
    parts = path.relative_to(ROOT).with_suffix("").parts
    return "/".join(parts[:2]) if len(parts) > 2 else parts[0]


def _bound_names(tree: ast.Module):
    """Yield every name that a module binds, with the names bound in the same function."""
    scopes = [tree, *(node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef))]
    seen = set()
    for scope in reversed(scopes):
        bound = []
        for node in ast.walk(scope):
            if isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Store):
                bound.append((node, node.id if isinstance(node, ast.Name) else node.attr))
            elif isinstance(node, ast.arg):
                bound.append((node, node.arg))
        names = {name for _, name in bound}
        for node, name in bound:
            if id(node) not in seen:
                seen.add(id(node))
                yield name, names, getattr(scope, "name", "")


def _is_placeholder(name: str, names: set[str], function: str) -> bool:
    if name == "left" and "right" in names:
        return False
    dunder = function.startswith("__")
    return bool(PLACEHOLDERS.fullmatch(name)) and not (name == "other" and dunder)


def _texts(tree: ast.Module, is_room_file: bool):
    """Yield docstrings and notes, each with whether its first word counts."""
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        for index, statement in enumerate(body if isinstance(body, list) else ()):
            value = getattr(statement, "value", None)
            if isinstance(statement, ast.Expr) and isinstance(value, ast.Constant):
                question = is_room_file and node is tree and index == 0
                yield str(value.value).strip(), not question


def patterns(source: str, is_room_file: bool = False) -> tuple[list[str], ...]:
    """Placeholder names, function names, openings and words of a module that are not plain."""
    tree = ast.parse(source)
    names = [name for name, *scope in _bound_names(tree) if _is_placeholder(name, *scope)]
    functions = [
        node.name
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef) and PREPOSITIONS.fullmatch(node.name)
    ]
    texts = list(_texts(tree, is_room_file))
    openings = [text[:40] for text, counts in texts if counts and OPENINGS.match(text)]
    words = [word for text, _ in texts for word in WORDS.findall(text)]
    return names, functions, openings, words


def _rooms() -> dict[str, list[Path]]:
    """Files of every room: what they say is read by the room's own test, as all workers collect it."""
    rooms: dict[str, list[Path]] = {}
    for package in PACKAGES:
        for path in sorted((ROOT / package).rglob("*.py")):
            rooms.setdefault(_room_of(path), []).append(path)
    return rooms


ROOMS = _rooms()


@pytest.mark.parametrize("room", sorted(ROOMS))
def test_a_room_gains_no_unplain_name_or_docstring(room):
    said = [(path, patterns(path.read_text("utf-8"), path.name == "__init__.py"))
            for path in ROOMS[room]]  # fmt: skip
    for column, limit in enumerate(MOST.get(room, (0, 0, 0, 0))):
        hits = [f"{path.relative_to(ROOT)}: {hit}" for path, lists in said for hit in lists[column]]
        assert len(hits) <= limit, f"{len(hits)} instead of {limit}:\n" + "\n".join(hits)


def test_the_table_names_rooms_that_exist():
    assert set(MOST) <= set(ROOMS)


def test_every_pattern_is_noticed():
    source = (
        '"""Where it lies."""\n\n'
        "def of_number(found):\n"
        '    """What is told beside it."""\n'
        "    left = found.own = [one for one in found]\n"
        "    return left\n\n"
        "def split(pair):\n"
        '    """Return both sides."""\n'
        "    left, right = pair\n"
        "    return left, right\n"
    )
    names, functions, openings, words = patterns(source)
    assert Counter(names) == Counter(["found", "left", "own", "one"])
    assert functions == ["of_number"]
    assert [text.split()[0] for text in openings] == ["Where", "What"]
    assert words == ["told", "beside"]
    assert patterns(source, is_room_file=True)[2] == ["What is told beside it."]
