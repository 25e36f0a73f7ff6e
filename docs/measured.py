"""Write docs/measured/*.md from results files: `python docs/measured.py`.

Each page is a file of benchmarks/results/measured: title, pages that explain it, results. A result says
what was measured, by which command (or, where no script is kept, at which commit), with which version,
when and on what; then tables. A result given as a name is a record that a script wrote into
benchmarks/results (`described` in benchmarks/harness.py).
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

RESULTS = Path(__file__).parents[1] / "benchmarks" / "results"
PAGES = Path(__file__).parent / "measured"
Result = dict[str, Any]


def read_pages() -> dict[str, Result]:
    """Return name → page, records of scripts read in."""
    pages = {path.stem: read_record(path) for path in sorted((RESULTS / "measured").glob("*.json"))}
    for page in pages.values():
        page["results"] = [
            read_record(RESULTS / r) if isinstance(r, str) else r for r in page["results"]
        ]
    return pages


def page_text(name: str, page: Result) -> str:
    """Return a page as MyST markdown."""
    explained = ", ".join(f"[{one.replace('_', ' ')}](../{one}.md)" for one in page["explained"])
    blocks = [
        f"# {page['title']}",
        f"How and why: {explained}. Written by `docs/measured.py` from "
        f"`benchmarks/results/measured/{name}.json`; do not edit.",
        *([page["what"]] if page.get("what") else []),
        *(block for result in page["results"] for block in _section(result)),
    ]
    return "\n\n".join(blocks) + "\n"


def _section(result: Result) -> Iterator[str]:
    yield f"{'#' * result.get('level', 2)} {result['title']}"
    yield "\n".join([*([result["what"]] if "what" in result else []), _origin(result)])
    for table in result.get("tables", ()):
        if caption := table.get("caption"):
            yield caption
        yield _table([table["columns"], ["---"] * len(table["columns"]), *table["rows"]])
    if report := result.get("report"):
        yield "\n".join(["```text", *report, "```"])
    yield from (f"![{caption}](../{path})" for path, caption in result.get("pictures", {}).items())
    if notes := result.get("notes"):
        yield "\n".join(f"- {note}" for note in notes)
    if missing := result.get("not_covered"):
        yield f"**Not covered**: {missing}"


def _origin(result: Result) -> str:
    """Return how, when and on what: one line in italics."""
    command, commit = result.get("command"), result.get("commit")
    source = f"`{command}`" if command else f"No script is kept; figures of commit {commit}"
    machine = result.get("machine")
    if isinstance(machine, dict):
        machine = f"{machine['processor']}, threads: {machine['threads']}"
    earlier = f"measured before {result['before']}" if "before" in result else ""
    parts = filter(None, (source, f"instobj {result['version']}", result["date"], earlier, machine))
    return f"*{'; '.join(parts)}.*"


def _table(rows: list[list[str]]) -> str:
    return "\n".join(
        "|" + "|".join(f" {cell} " if cell else " " for cell in row) + "|" for row in rows
    )


def read_record(path: Path) -> Result:
    """Return a results file."""
    return json.loads(path.read_text(encoding="utf-8"))


def main() -> None:
    """Write every page."""
    for name, page in read_pages().items():
        (PAGES / f"{name}.md").write_text(page_text(name, page), encoding="utf-8")


if __name__ == "__main__":
    main()
