"""Pages of the documentation as text: links, code snippets, headings."""

import re
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
BUILT = ("_build", "gallery", "generated")
"""Folders of docs/ that `make docs` writes."""


@dataclass(frozen=True)
class Link:
    """One link as written: the page it stands on, and its target."""

    page: Path
    target: str

    def __str__(self) -> str:
        return f"{self.page.relative_to(ROOT)}: {self.target}"


def site_pages() -> list[Path]:
    """Every page of the site that is kept in git."""
    pages = sorted(DOCS.rglob("*.md"))
    return [page for page in pages if not set(page.relative_to(DOCS).parts) & set(BUILT)]


def all_pages() -> list[Path]:
    """Those, and the pages at the repository's root."""
    return [*site_pages(), ROOT / "README.md", ROOT / "CONTRIBUTING.md"]


def links(page: Path) -> list[Link]:
    """Links and pictures that do not leave the repository."""
    text = _without_fences(page.read_text())
    targets = re.findall(r"\]\(([^)\s]+)\)", text)
    return [Link(page, target) for target in targets if not re.match(r"[a-z]+:", target)]


def anchors(page: Path) -> set[str]:
    """Anchors of a page's headings, as GitHub and MyST make them."""
    headings = re.findall(r"^#+ +(.*)$", _without_fences(page.read_text()), flags=re.MULTILINE)
    return {_slug(heading) for heading in headings}


def snippets(page: Path) -> list[str]:
    """Lines of fenced code, and inline code."""
    text = page.read_text()
    fenced = re.findall(r"^```\w*\n(.*?)^```", text, flags=re.MULTILINE | re.DOTALL)
    inline = re.findall(r"`([^`\n]+)`", _without_fences(text))
    return [line.strip() for block in fenced for line in block.splitlines()] + inline


def _without_fences(text: str) -> str:
    return re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)


def _slug(heading: str) -> str:
    kept = re.sub(r"[^\w\- ]", "", heading.replace("`", "").lower())
    return kept.strip().replace(" ", "-")
