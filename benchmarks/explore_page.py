"""From the hand to the picture on the page of `instobj explore`: a magnet dragged by the mouse.

A headless Chromium with WebGL by software drags a magnet of the paper's cube over its face and back; the page
measures the time from the oldest event of the mouse that a picture answers to the picture on the screen.
Before that, from an empty store, the first map of five bodies: coarse, and by the shell's own mechanics.
"""

from __future__ import annotations

import math
import os
import re
import subprocess
import sys
import tempfile
import time
from itertools import product
from pathlib import Path

import numpy as np
from harness import Result, conclude, machine, option_parser

sys.path.insert(0, str(Path(__file__).parents[1]))
from tests.support.browser import Browser

SIZE = (1280, 800)
MAGNET, RADIUS_PX, EVERY_S = 12, 30.0, 0.02
TURNS, QUICK_TURNS = 8, 1
STEPS = 60
"""Events of the mouse in a turn."""
BODIES = {
    "cube": "examples/paper_cube.toml",
    "box": ("box", (70.0, 50.0, 35.0)),
    "cylinder": ("cylinder", (60.0, 60.0, 85.0)),
    "ball": "examples/ball.toml",
    "pear": "examples/pear.toml",
}
"""Specifications, or kinds and sizes (mm) that rules place."""


def first_map(body: str, full: bool) -> dict[str, float]:
    """Seconds of processors and of a clock to the first map of a body, in a process with an empty store."""
    with tempfile.TemporaryDirectory() as store:
        code = f"import explore_page as page; page.judge_first({body!r}, {full})"
        before, began = os.times(), time.perf_counter()
        environment = os.environ | {"INSTOBJ_STORE": store}
        here = Path(__file__).parent
        subprocess.run([sys.executable, "-c", code], check=True, cwd=here, env=environment)
        after = os.times()
    used = sum(after[2:4]) - sum(before[2:4])  # of children, user and system
    return {"processor_s": used, "clock_s": time.perf_counter() - began}


def judge_first(body: str, full: bool) -> None:
    """Open a body as the page does, and judge it once."""
    from design.placement.asked import place_parts
    from design.placement.objects import Request, spec_of
    from design.spec_io import load_spec
    from instobj.explore.engine import open_coarse_explorer, open_explorer

    given = BODIES[body]
    if isinstance(given, str):
        spec = load_spec(Path(__file__).parents[1] / given)
    else:
        spec = spec_of(place_parts(Request(*given)))
    explorer = (open_explorer if full else open_coarse_explorer)(spec)
    explorer.judge(spec, explorer.forces_n[0])


def start_page() -> tuple[subprocess.Popen[str], str]:
    """The page of the paper's cube, and its address."""
    cube = Path(__file__).parents[1] / "examples" / "paper_cube.toml"
    command = [sys.executable, "-m", "instobj", "explore", str(cube), "--page", "0"]
    process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    assert process.stderr is not None
    for line in process.stderr:
        if found := re.search(r"open (http://127\.0\.0\.1:\d+/)", line):
            return process, found[1]
    raise RuntimeError("the page did not start")


def dragged(page: Browser, turns: int) -> list[float]:
    """Ages of pictures (ms) while a magnet goes round in circles."""
    x, y = page.ask(f'instobjExplore.where("magnet", {MAGNET})')
    page.ask("instobjExplore.forget()")

    def mouse(kind: str, at: tuple[float, float]) -> None:
        held = {"button": "left", "buttons": 1, "clickCount": 1}
        page.send("Input.dispatchMouseEvent", type=kind, x=at[0], y=at[1], **held)

    mouse("mousePressed", (x, y))
    for step in range(turns * STEPS):
        angle = 2 * math.pi * step / STEPS
        mouse(
            "mouseMoved", (x + RADIUS_PX * math.sin(angle), y + RADIUS_PX * (1 - math.cos(angle)))
        )
        time.sleep(EVERY_S)
    mouse("mouseReleased", (x, y))
    page.wait("instobjExplore.idle()")
    time.sleep(0.5)
    return page.ask("instobjExplore.latencies()")


def _first_line(level: str, body: str, took: dict[str, float]) -> str:
    return f"first map of {body}, {level}: {took['processor_s']:.1f} s of a core, {took['clock_s']:.1f} s"


def report(result: Result) -> str:
    lines = [
        _first_line(level, body, took)
        for level, bodies in result["first_maps"].items()
        for body, took in bodies.items()
    ]
    return "\n".join(lines) + (
        f"\nhand to picture, ms: median {result['median_ms']:.0f}, 95 % {result['p95_ms']:.0f} "
        f"({result['pictures']} pictures, load {result['load_average']:.1f})"
    )


def main() -> None:
    """Measure once the page stands."""
    options = option_parser(__doc__ or "").parse_args()
    bodies = ["cube"] if options.quick else list(BODIES)
    levels = ("coarse",) if options.quick else ("coarse", "full")
    first: Result = {level: {} for level in levels}
    for level, body in product(levels, bodies):
        first[level][body] = first_map(body, level == "full")
        print(
            _first_line(level, body, first[level][body]), flush=True
        )  # minutes pass until the next
    process, url = start_page()
    try:
        with Browser(*SIZE) as page:
            page.send("Page.navigate", url=url)
            page.wait('document.getElementById("instobj-explore")?.dataset.ready === "yes"')
            while not page.ask("instobjExplore.exact()"):  # the shell's own mechanics
                time.sleep(1)
            dragged(page, 1)  # warm
            ages = dragged(page, QUICK_TURNS if options.quick else TURNS)
    finally:
        process.terminate()
        process.communicate()
    result = {"machine": machine(1, ()), "window": SIZE, "pictures": len(ages)}
    result |= {"first_maps": first}
    result |= {"median_ms": float(np.median(ages)), "p95_ms": float(np.percentile(ages, 95))}
    conclude("explore_page", options, result | {"load_average": os.getloadavg()[0]}, report)


if __name__ == "__main__":
    main()
