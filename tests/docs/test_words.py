"""How-to pages are plain: short sentences, and figures that a later version could change stand elsewhere."""

import re

import pytest

from tests.support.pages import DOCS

PLAIN_PAGES = (
    "bodies.md",
    "calibrate.md",
    "estimators.md",
    "inversion.md",
    "layout_search.md",
    "live.md",
    "presses.md",
    "questions.md",
    "rig.md",
    "sweeps.md",
)
"""How-to pages whose measured figures have moved to `docs/measured`."""
MEAN_WORDS, MOST_WORDS, NUMBERS_A_SENTENCE = 17, 40, 0.4
MOST_LINES = 150


def sentences(text: str) -> list[str]:
    """Sentences of a page's paragraphs and lists, without headings, tables, code and pictures."""
    text = re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)
    lines = [re.sub(r"^(- |\d+\. )", "", line) for line in text.splitlines()]
    prose = [
        line for line in lines if line.strip() and not line.startswith(("|", "#", "!", "    "))
    ]
    parts = [part for line in prose for part in re.split(r"(?<=[.!?:])\s+(?=[A-Z*`\[])", line)]
    return [part for part in parts if len(part.split()) > 2]


def faults(text: str) -> list[str]:
    """What makes a page hard to read, in words."""
    found = sentences(text)
    words = [len(sentence.split()) for sentence in found]
    numbers = sum(len(re.findall(r"(?<![\w.])\d[\d.,]*", sentence)) for sentence in found)
    mean, share = sum(words) / len(words), numbers / len(words)
    checks = {
        f"{mean:.1f} words a sentence in the mean": mean > MEAN_WORDS,
        f"a sentence of {max(words)} words": max(words) > MOST_WORDS,
        f"{share:.2f} numbers a sentence": share > NUMBERS_A_SENTENCE,
        f"{len(text.splitlines())} lines": len(text.splitlines()) > MOST_LINES,
    }
    return [text for text, broken in checks.items() if broken]


@pytest.mark.parametrize("name", PLAIN_PAGES)
def test_a_how_to_page_is_plain(name):
    assert not faults((DOCS / name).read_text())


@pytest.mark.parametrize("name", PLAIN_PAGES)
def test_a_how_to_page_has_a_block_to_run_in_its_first_screen(name):
    first = (DOCS / name).read_text().splitlines()[:30]
    assert any(line.strip().startswith("instobj ") for line in first)


def test_a_page_that_is_not_plain_is_noticed():
    long = "One " * 41 + "word."
    assert faults(long) == ["42.0 words a sentence in the mean", "a sentence of 42 words"]
    assert faults("It took 3 to 14 minutes.") == ["2.00 numbers a sentence"]
    assert faults("It is short.\n" * 151) == ["151 lines"]
