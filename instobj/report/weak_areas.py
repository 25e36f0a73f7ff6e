"""Weak areas in words and rows: what an object's weak contact locations have in common."""

from __future__ import annotations

from math import isinf, isnan
from pathlib import Path
from typing import Any

from design.layout.places.measures import LONGEST_PATH_MM
from instobj.store.content import StoredResult
from instobj.store.readers import WEAK_AREAS, WEAK_AREAS_PICTURE, WEAK_MAPS

WEAK_TITLE = (
    "weak areas: the position bound that 95 % of the locations keep, by thirds of each measure (rank: with "
    "the bound)"
)
_NAMES = {
    "border_mm": ("border, mm", "the distance to the border of their patch", "mm"),
    "magnet_mm": ("magnet, mm", "the distance to the nearest magnet", "mm"),
    "path_mm": ("path, mm", "the signal path over a magnet to a sensor", "mm"),
    "curvature_per_mm": ("curvature, 1/m", "the curvature of the surface", "1/m"),
}
"""Measure → what tables and sentences call it, and its unit there."""
_CLEAR = 0.5
"""Rank correlation from which on weak locations are said to go with a measure."""
_FARTHER = 1.1
"""Ratio of median signal paths, edges over middle, from which distance is named as the cause."""


def weak_rows(result: StoredResult) -> list[dict[str, Any]]:
    """Rows of the command line's table."""
    return _rows(WEAK_AREAS.read(result.folder))


def weak_areas_section(folder: Path) -> dict[str, Any]:
    """Sentence, table, figure and maps, as the page shows them."""
    content = WEAK_AREAS.read(folder)
    return {
        "weak_text": weak_text(content),
        "weak_areas": _rows(content),
        "weak_picture": WEAK_AREAS_PICTURE.path(folder),
        "weak_maps": sorted((folder / "maps").glob(Path(WEAK_MAPS.name).name)),
    }


_WEAK_FROM = 1.5
"""Edge ratio from which edges are called weak: half as uncertain again as the middle; ours."""


def are_weak(content: dict[str, Any]) -> bool:
    """Return whether edges are called weak."""
    ratio = content["edge_ratio"]
    # The verdict follows from the rounded figure, so that they cannot contradict each other.
    return ratio is not None and round(ratio, 1) >= _WEAK_FROM


def edge_text(content: dict[str, Any]) -> str:
    """Return whether edges are weak, by the one figure that pages and terminal give, and why."""
    ratio = content["edge_ratio"]
    if ratio is None or isnan(ratio):
        return "the same as the middle; all locations lie equally far from the border"
    times = round(ratio, 1)
    if isinf(ratio):
        text = "the middle is located, the edges are not"
    elif times > 1:
        judged = "weak" if are_weak(content) else "not weak"
        text = f"{judged}, {times:g} times as uncertain as the middle{_thirds_text(content)}"
    elif times < 1:
        text = f"less uncertain than the middle ({times:g} times)"
    else:
        return "as good as the middle"
    outer, inner = content["edge_paths_mm"]
    if are_weak(content) and outer >= _FARTHER * inner:
        text += (
            f", because magnets and sensors are farther away ({outer:.0f} mm, not {inner:.0f} mm)"
        )
    return text


def _thirds_text(content: dict[str, Any]) -> str:
    """Return the bounds of the outermost and of the innermost third."""
    bounds = [third["bound_mm"] for third in content["thirds"] if third["measure"] == "border_mm"]
    return f" ({bounds[0]:.2g} mm instead of {bounds[-1]:.2g} mm)" if bounds else ""


def weak_text(content: dict[str, Any]) -> str:
    """Return what the weak locations go with, and how much, in two sentences."""
    told_by, order = content["told_by"], content["rank_correlation"]
    if told_by is None:
        return "All contact locations lie alike: none of the measures tells them apart"
    parts = []
    if abs(order[told_by]) < _CLEAR:
        parts.append("Weak locations go with none of the measures clearly")
    else:
        side = "large" if order[told_by] > 0 else "small"
        parts.append(f"Weak locations are those where {_NAMES[told_by][1]} is {side}")
    parts[0] += f" (rank correlation with the bound {order[told_by]:+.2f})"
    thirds = [third for third in content["thirds"] if third["measure"] == told_by]
    strong, weak = sorted((thirds[0], thirds[-1]), key=lambda third: third["bound_mm"])
    parts.append(
        f"95 % of the locations keep {weak['bound_mm']:.2g} mm at {_range(weak)} and "
        f"{strong['bound_mm']:.2g} mm at {_range(strong)}"
    )
    parts.append(
        f"{100 * content['beyond_rule']:.0f} % of the locations are far from a magnet and a sensor "
        f"(signal path over {LONGEST_PATH_MM:g} mm); few such places are located within 1.5 mm at 8 N"
    )
    return "; ".join(parts)


def _rows(content: dict[str, Any]) -> list[dict[str, Any]]:
    return [
        {
            "by": _NAMES[third["measure"]][0],
            "from": _shown(third, "low"),
            "to": _shown(third, "high"),
            "places": third["places"],
            "95 % below mm": third["bound_mm"],
            "rank": content["rank_correlation"][third["measure"]],
        }
        for third in content["thirds"]
    ]


def _shown(third: dict[str, Any], end: str) -> float:
    """In the unit of the tables."""
    return third[end] * (1000 if third["measure"] == "curvature_per_mm" else 1)


def _range(third: dict[str, Any]) -> str:
    unit = _NAMES[third["measure"]][2]
    return f"{_shown(third, 'low'):.3g} to {_shown(third, 'high'):.3g} {unit}"
