"""Every page is of one kind and plain: short sentences; figures that later versions change stand apart."""

import re

import pytest

from tests.support.pages import DOCS, ROOT, site_pages

KIND_OF = {
    "index": "how-to",
    **dict.fromkeys(
        (
            *("adopt", "assess", "bodies", "bringup", "calibrate", "estimators"),
            *("experiments", "explore", "fabrication"),
            *("firmware", "install", "inversion", "layout_search", "library", "live"),
            *("look_inside", "presses", "questions", "reliability", "rig", "robustness"),
            *("simulate", "start", "sweeps", "validation"),
        ),
        "how-to",
    ),
    **dict.fromkeys(
        ("architecture", "core", "faces", "field", "information", "moulds", "security"),
        "explanation",
    ),
    **dict.fromkeys(("glossary", "recordings", "units"), "reference"),
    "how_true": "measured",
}
"""Pages at the top of docs/; of those in folders the folder says it."""
KIND_OF_FOLDER = {"reference": "reference", "measured": "measured", "verification": "measured"}
MEAN_WORDS, MOST_WORDS = 17, 40
MOST_NUMBERS = {"how-to": 0.4, "explanation": 0.4}
"""Numbers a sentence; figures that a later version can change stand on measured pages."""
MOST_WORDS_OF_A_PAGE = {"how-to": 800, "explanation": 1500}
PAGES = site_pages()


def name_of(page) -> str:
    return str(page.relative_to(DOCS).with_suffix(""))


def kind_of(name: str) -> str:
    """Return the kind of a page by its name below docs/, "" where nothing says it."""
    folder, _, _ = name.rpartition("/")
    return KIND_OF_FOLDER.get(folder, "") if folder else KIND_OF.get(name, "")


def without_code(text: str) -> str:
    """Return a page without fenced code and without tables that the code writes."""
    text = re.sub(r"^<!-- (\w+): written .*?<!-- end of \1 -->$", "", text, flags=re.M | re.S)
    return re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)


def sentences(text: str) -> list[str]:
    """Sentences of a page's paragraphs and lists, without headings, tables, code and pictures."""
    lines = [re.sub(r"^\s*(- |\d+\. )", "", line) for line in without_code(text).splitlines()]
    prose = [
        line for line in lines if line.strip() and not line.startswith(("|", "#", "!", "    "))
    ]
    parts = [part for line in prose for part in re.split(r"(?<=[.!?:])\s+(?=[A-Z*`\[])", line)]
    return [part for part in parts if len(part.split()) > 2]


def faults(text: str, kind: str = "how-to") -> list[str]:
    """Return what makes a page of a kind hard to read, in words."""
    found = sentences(text)
    words = [len(sentence.split()) for sentence in found] or [0]
    numbers = sum(len(re.findall(r"(?<![\w.])\d[\d.,]*", sentence)) for sentence in found)
    mean, share = sum(words) / len(words), numbers / len(words)
    size = len([word for word in without_code(text).split() if word.strip("|-:")])
    checks = {
        f"{mean:.1f} words a sentence in the mean": mean > MEAN_WORDS,
        f"a sentence of {max(words)} words": max(words) > MOST_WORDS,
        f"{share:.2f} numbers a sentence": share > MOST_NUMBERS.get(kind, share),
        f"{size} words": size > MOST_WORDS_OF_A_PAGE.get(kind, size),
    }
    return [text for text, broken in checks.items() if broken]


def test_every_page_is_of_a_kind():
    names = {name_of(page) for page in PAGES}
    assert not [name for name in names if not kind_of(name)]
    assert set(KIND_OF) <= names


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_a_page_is_plain(page):
    assert not faults(page.read_text(), kind_of(name_of(page)))


def test_the_readme_is_plain():
    assert not faults((ROOT / "README.md").read_text(), "how-to")


HOW_TO = sorted(name for name, kind in KIND_OF.items() if kind == "how-to" and name != "index")


@pytest.mark.parametrize("name", HOW_TO)
def test_a_how_to_page_has_a_block_to_run_in_its_first_screen(name):
    first = (DOCS / f"{name}.md").read_text().splitlines()[:30]
    assert any(line.startswith(("```sh", "```py")) for line in first)


def pictures(page) -> list:
    """Return the files of the pictures that a page shows."""
    shown = re.findall(r"!\[[^\]]+\]\((\S+)\)", page.read_text())
    return [page.parent / path for path in shown]


@pytest.mark.parametrize("page", [*(DOCS / f"{name}.md" for name in HOW_TO), ROOT / "README.md"])
def test_a_how_to_page_and_the_readme_show_what_is_seen(page):
    assert any(path.is_file() for path in pictures(page))


@pytest.mark.parametrize(
    "path", sorted((DOCS / "pictures").glob("*.png")), ids=lambda path: path.stem
)
def test_a_picture_of_what_is_seen_is_small_and_shown(path):
    assert path.stat().st_size <= 150_000
    pages = [*PAGES, ROOT / "README.md"]
    assert any(path == shown.resolve() for page in pages for shown in pictures(page))


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_a_page_of_figures_or_keys_names_the_page_that_explains_them(page):
    name = name_of(page)
    folder, _, own = name.rpartition("/")
    if folder in ("measured", "reference") and own not in ("python", "specification"):
        assert re.search(r"\]\(\.\./\w+\.md", "\n".join(page.read_text().splitlines()[:8]))


def test_a_page_that_is_not_plain_is_noticed():
    long = "One " * 41 + "word."
    assert faults(long) == ["42.0 words a sentence in the mean", "a sentence of 42 words"]
    assert faults("It took 3 to 14 minutes.") == ["2.00 numbers a sentence"]
    assert faults("It took 3 to 14 minutes.", "measured") == []
    assert faults("It is short.\n" * 267) == ["801 words"]
