"""First designs of `instobj new` beside those that a longer search finds with the same parts.

    python benchmarks/first_designs.py [--quick] [--requests N] [--seconds S] [--out FOLDER]

Random requests: kinds without a file, edges of 30 to 120 mm, 1 to 4 sensors and 1 to 9 magnets on each face.
Each is placed as `instobj new` places it; then walks from ever new seeds go on from the best so far, with the
same shell, magnets, range and numbers. Both are judged by the presses of a layer, without a mesh. Writes
`first_designs.json`: median and 95th percentile of the position bound, and ratios. The chain is not run.
A call that was cut short goes on at the request where it stopped.
"""

from __future__ import annotations

import argparse
import time
from functools import partial
from pathlib import Path

import numpy as np
from harness import Result, conclude, kept, machine, option_parser, parts_folder

from design.errors import InputError
from design.placement.objects import Request, spec_of
from estimator.layouts.without_mesh import first_score
from instobj.commands.first_layout import improved
from instobj.commands.new import designed

KINDS = ("box", "cylinder", "capsule", "sphere", "ellipsoid", "dome", "pad")
_EDGES_MM, _ROUND_KINDS = (30.0, 120.0), ("cylinder", "capsule", "dome")


def measure(requests: int, seconds: float, parts: Path) -> Result:
    """A row for each request that finds room, and how many did not; rows in `parts` are kept."""
    rows, refused = list[Result](), 0
    while len(rows) < requests:
        number = len(rows) + refused
        row = kept(parts, str(number), partial(_row, random_request(number), seconds))
        if row is None:
            refused += 1
        else:
            rows.append(row)
            print(number, row, flush=True)
    about = {"machine": machine(1, ["numpy", "torch"]), "seconds": seconds, "refused": refused}
    ratios = {
        f"{of} over longer search": {
            str(q): float(np.quantile([row[of][0] / row[of][1] for row in rows], q))
            for q in (0.5, 0.9, 1.0)
        }
        for of in ("median_mm", "percentile_95_mm")
    }
    return {**about, **ratios, "rows": rows}


def random_request(number: int) -> Request:
    """Request `number` of an endless list."""
    rng = np.random.default_rng([2026, number])
    kind = str(rng.choice(KINDS))
    x, y, z = np.round(rng.uniform(*_EDGES_MM, 3))
    if kind == "sphere":
        x = y = z
    elif kind in _ROUND_KINDS:
        y = x
    size = tuple(float(edge) for edge in (x, y, z))
    return Request(kind, size, int(rng.integers(1, 5)), int(rng.integers(1, 10)))


def _row(request: Request, seconds: float) -> Result | None:
    try:
        tables, failed = designed(request)
    except InputError:
        return None
    first = first_score(spec_of(tables))
    began, seed = time.process_time(), 0
    best, least = improved(tables, 0)
    while time.process_time() - began < seconds:
        seed += 1
        moved, loss = improved(best, seed=seed)
        best, least = (moved, loss) if loss < least else (best, least)
    longer = first_score(spec_of(best))
    return {
        "request": [request.kind, request.size_mm, request.sensors, request.magnets],
        "searches": seed,
        "fails fabrication": bool(failed),
        "within limit": [first.within, longer.within],
        "median_mm": [first.median_mm, longer.median_mm],
        "percentile_95_mm": [first.percentile_95_mm, longer.percentile_95_mm],
    }


def report(result: Result) -> str:
    """Ratios in words."""
    lines = [
        f"{name}: {', '.join(f'quantile {q} {ratio:.2f}' for q, ratio in ratios.items())}"
        for name, ratios in result.items()
        if name.endswith("longer search")
    ]
    return "\n".join([*lines, f"{len(result['rows'])} requests, {result['refused']} found no room"])


def main() -> None:
    """Measure, write, print."""
    parser: argparse.ArgumentParser = option_parser(__doc__ or "")
    parser.add_argument("--requests", type=int, default=20, help="requests that find room")
    parser.add_argument("--seconds", type=float, default=300.0, help="of one core, a request")
    options = parser.parse_args()
    requests, seconds = (2, 5.0) if options.quick else (options.requests, options.seconds)
    parts = parts_folder("first_designs", f"{seconds:g}s", options, {"machine": machine(1, ())})
    conclude("first_designs", options, measure(requests, seconds, parts), report)


if __name__ == "__main__":
    main()
