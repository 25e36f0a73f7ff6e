"""What the pages name exists: pages, headings, commands, options, keys, files and modules."""

import inspect
import re
import sys
from pathlib import Path

import pydantic
import pytest

import instobj
from design.layout.places import fractions
from design.spec.object import ObjectSpec
from tests.support.pages import DOCS, ROOT, Link, all_pages, anchors, links, site_pages, snippets

sys.path.insert(0, str(DOCS))
from site_pages import commands, option_names

FOREIGN_OPTIONS = {"--extra-index-url", "--find-links", "--follow", "--no-deps", "--use-angle"}
"""Options of pip, git and Chromium that the pages name."""

WRITTEN_BY_MAKE_DOCS = {
    "gallery/index.rst": "examples/gallery/GALLERY_HEADER.rst",
    "reference/generated/command_line.md": "docs/site_pages.py",
}
"""Pages of the site that are not kept in git, and what they are made from."""


def _file_of(link: Link) -> Path:
    """The file that a link leads to; pages that are built stand for what they are made from."""
    path = (link.page.parent / link.target.partition("#")[0]).resolve()
    if path.is_relative_to(DOCS):
        name = str(path.relative_to(DOCS))
        if name.startswith("gallery/") and name not in WRITTEN_BY_MAKE_DOCS:
            return ROOT / "examples" / Path(name).with_suffix(".py")
        return ROOT / WRITTEN_BY_MAKE_DOCS.get(name, f"docs/{name}")
    return path


def _missing(found: list[Link]) -> list[str]:
    missing = []
    for link in found:
        anchor = link.target.partition("#")[2]
        file = link.page if link.target.startswith("#") else _file_of(link)
        if not file.exists() or (anchor and anchor not in anchors(file)):
            missing.append(str(link))
    return missing


def test_every_link_between_pages_leads_somewhere():
    assert not _missing([link for page in all_pages() for link in links(page)])


def test_a_link_to_nowhere_is_noticed():
    page = DOCS / "index.md"
    broken = [Link(page, "no_such_page.md"), Link(page, "units.md#no-such-heading")]
    assert _missing(broken) == [f"docs/index.md: {link.target}" for link in broken]


def test_pages_of_the_site_link_only_to_pages_of_the_site():
    """Sphinx knows no page outside docs/: name such a file as code, without a link."""
    outside = [
        str(link)
        for page in site_pages()
        for link in links(page)
        if link.target.startswith("../") and _file_of(link).suffix == ".md"
        if not _file_of(link).is_relative_to(DOCS)
    ]
    assert not outside


def test_every_page_stands_in_the_index():
    """A new page gets a line in one of the lists of docs/index.md."""
    index = (DOCS / "index.md").read_text()
    listed = {
        line.strip()
        for block in re.findall(r"```\{toctree\}\n(.*?)```", index, flags=re.DOTALL)
        for line in block.splitlines()
        if line.strip() and not line.startswith(":")
    }
    made = {str(Path(name).with_suffix("")) for name in WRITTEN_BY_MAKE_DOCS}
    pages = {str(page.relative_to(DOCS).with_suffix("")) for page in site_pages()} - {"index"}
    assert listed == pages | made


def _unknown_in(snippet: str) -> list[str]:
    """Commands and options of `instobj` in a snippet that do not exist."""
    known = commands()
    words = snippet.split("#")[0].replace("`", " ").split()
    if words[:3] == ["python", "-m", "studies"]:
        known = commands("studies.__main__")
        words = ["instobj", *words[3:]]
    if words and words[0] == "instobj":
        words = words[1:]
        if words[:1] == ["bench"]:
            words = [" ".join(words[:2]), *words[2:]]
        if words and re.fullmatch(r"[a-z][a-z -]*", words[0]) and words[0] not in known:
            return [words[0]]
    options = [word.split("=")[0].rstrip(",.;)") for word in words if word.startswith("--")]
    if words and words[0] in known:
        allowed = option_names(known[words[0]])
    elif words and words[0].startswith("--"):
        every = [*known.values(), *commands("studies.__main__").values()]
        allowed = set().union(FOREIGN_OPTIONS, *map(option_names, every))
    else:
        return []
    return [option for option in options if option not in allowed]


@pytest.mark.parametrize("page", all_pages(), ids=lambda page: str(page.relative_to(ROOT)))
def test_commands_and_options_that_a_page_names_exist(page):
    unknown = [(snippet, _unknown_in(snippet)) for snippet in snippets(page)]
    assert not [(snippet, words) for snippet, words in unknown if words]


def test_an_unknown_command_or_option_is_noticed():
    assert _unknown_in("instobj fly cube.toml") == ["fly"]
    assert _unknown_in("instobj score cube.toml --speed 3") == ["--speed"]
    assert _unknown_in("score --resume") == ["--resume"]
    assert _unknown_in("--no-such-option") == ["--no-such-option"]
    assert not _unknown_in("instobj score cube.toml --also shear")


def _key_exists(key: str) -> bool:
    """Whether a dotted key is one of the specification's (below a list or a table of any names)."""
    if key in {f"magnets.{fractions.KEY}", f"sensors.{fractions.KEY}"}:
        return True  # read into positions_mm
    model: object = ObjectSpec
    for part in key.split("."):
        if not (isinstance(model, type) and issubclass(model, pydantic.BaseModel)):
            return True
        names = set(model.model_fields) | {
            field.alias for field in model.model_fields.values() if field.alias
        }
        if part not in names:
            return False
        model = model.model_fields[part].annotation if part in model.model_fields else None
    return True


@pytest.mark.parametrize("page", all_pages(), ids=lambda page: str(page.relative_to(ROOT)))
def test_keys_of_the_specification_that_a_page_names_exist(page):
    tables = "|".join(
        name
        for name, field in ObjectSpec.model_fields.items()
        if isinstance(field.annotation, type) and issubclass(field.annotation, pydantic.BaseModel)
    )
    pattern = rf"(?:--set |^)((?:{tables})\.[a-z_.]+[a-z])(?=[ =,]|$)"
    named = {key for snippet in snippets(page) for key in re.findall(pattern, snippet)}
    files = {".py", ".md", ".json", ".csv", ".png", ".nc", ".html", ".toml", ".log"}
    keys = {key for key in named if Path(key).suffix not in files}
    assert not [key for key in sorted(keys) if not _key_exists(key)]


def test_an_unknown_key_is_noticed():
    assert _key_exists("shell.thickness_mm")
    assert not _key_exists("shell.colour")


def _is_defined(name: str) -> bool:
    """Whether a dotted name is a room, a module, or a name at the top of one (nothing is imported)."""
    *parts, last = name.split(".")
    folder = ROOT.joinpath(*parts)
    if (folder / last).is_dir() or (folder / f"{last}.py").exists():
        return True
    source = folder / "__init__.py" if folder.is_dir() else folder.with_suffix(".py")
    return source.exists() and bool(
        re.search(rf"^(?:def|class|    )? *[\"']?{last}\b", source.read_text(), flags=re.MULTILINE)
    )


def test_an_unknown_name_of_the_code_is_noticed():
    assert _is_defined("estimator.networks.training.face.fit_estimator")
    assert not _is_defined("estimator.training")
    assert not _is_defined("estimator.networks.training.face.no_such_function")


@pytest.mark.parametrize("page", all_pages(), ids=lambda page: str(page.relative_to(ROOT)))
def test_files_and_modules_that_a_page_names_exist(page):
    folders = "design|fem|estimator|instobj|examples|benchmarks|docs|tests"
    paths, names = set(), set()
    for snippet in snippets(page):
        paths.update(re.findall(rf"(?<![\w/])(?:{folders})/[\w/]+(?:\.\w+)?", snippet))
        if "/" not in snippet:
            dotted = re.findall(r"(?<![\w.])(?:design|fem|estimator|instobj)(?:\.\w+)+", snippet)
            names.update(dotted)
    kept = {path for path in paths if not path.startswith("docs/_build")}  # `make docs` makes it
    assert not [path for path in sorted(kept) if not (ROOT / path).exists()]
    assert not [name for name in sorted(names) if not _is_defined(name)]


def test_the_reference_holds_every_public_name():
    page = (DOCS / "reference" / "python.md").read_text()
    documented = re.findall(r"^\.\. auto\w+:: instobj\.([\w.]+)\b.*$", page, flags=re.MULTILINE)
    things = {name: getattr(instobj, name) for name in instobj.__all__}
    modules = {name: thing for name, thing in things.items() if inspect.ismodule(thing)}
    inside = {f"{name}.{own}" for name, module in modules.items() for own in module.__all__}
    handed_on = {"field.magnet_field"}  # documented under its shorter name
    assert sorted(documented) == sorted((things.keys() - modules.keys()) | inside - handed_on)


@pytest.mark.parametrize("page", all_pages(), ids=lambda page: str(page.relative_to(ROOT)))
def test_names_of_the_library_that_a_page_uses_are_public(page):
    used = set(re.findall(r"(?<![\w./-])instobj\.([A-Za-z_]\w*)", page.read_text()))
    rooms = {path.name for path in (ROOT / "instobj").iterdir()}
    assert not used - set(instobj.__all__) - rooms - {"toml"}
