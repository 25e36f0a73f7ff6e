"""A core that slips, noticed in grasps, and grasps without a slip.

    python benchmarks/slipped_core.py [--quick] [--grasps N] [--means N] [--out FOLDER]

The tests' object of analytic presses by a second forward model (`tests/support/slipped_core.py`): rest, and
grasps of one tip of 4 to 8 N, of 25 frames at 10 Hz. In a grasp the core shifts in any direction. Read as
live by an inversion that is exact and by one that believes its model wrong by 17 %. Without a slip, means of
ten frames at rest are judged too, each turned after a zero of its own. Writes `slipped_core.json`.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from harness import Result, machine, run

from estimator.deploy.live_contacts import LiveContacts
from estimator.inversion.inversion import Inversion
from estimator.inversion.slip import REST_FRAMES, slip_at_rest
from tests.support.mechanics.inverted import inverted, right
from tests.support.slipped_core import GRASP, grasps, noisy_means

_SLIPS_MM = (0.02, 0.03, 0.05, 0.1, 0.3)
_PRESSES, _SLIPPED_PRESS = 6, 2
"""Grasps of a stream, and the one within which the core slips."""


def measure(quick: bool, count: int, means: int) -> Result:
    """Rows by reader and slip; alarms without a slip."""
    exact = inverted()
    doubting = replace(exact.disturbances, model_error=np.full(exact.model.channels, 0.17))
    readers = {"exact model": exact, "17 % off": replace(exact, disturbances=doubting)}
    streams = 1 if quick else max(1, count // _PRESSES)
    rows = [
        {"reader": name, "slip_mm": slip_mm} | _row(reader, slip_mm, streams)
        for name, reader in readers.items()
        for slip_mm in (0.0, *_SLIPS_MM[2 * quick :: 1 + quick])
    ]
    rng, alarms = np.random.default_rng(1), 0
    means = 100 if quick else means
    for mean in noisy_means(rng, means):
        alarms += slip_at_rest(exact, mean, REST_FRAMES) is not None
    return {
        "machine": machine(1, ["numpy", "scipy", "magpylib"]),
        "quick": quick,
        "rows": rows,
        "means": means,
        "alarms": alarms,
    }


def _row(reader: Inversion, slip_mm: float, streams: int) -> Result:
    """Measures of streams of grasps: frames until the slip is named, its size, and the presses after it."""
    delays, sizes, good, alarms = [], [], [], 0
    slips_at = _SLIPPED_PRESS * GRASP + 4
    for seed in range(streams):
        rng = np.random.default_rng([seed, round(1e3 * slip_mm)])
        raw, face = grasps(rng, slip_mm, slips_at, _PRESSES)
        live, named = LiveContacts(reader, "rest", 8), None
        for number, counts in enumerate(raw):
            read = live.feed(counts.reshape(5, 3, 3), number / 10)
            if live.slip is not None and named is None:
                named = number
            if read is not None and number >= slips_at + GRASP - 4 and face[number].max() >= 0:
                good.append(read.explained[0] and right(read, face[number : number + 1])[0])
        if named is None or live.slip is None:
            continue
        if not slip_mm or named < slips_at:
            alarms += 1
        else:
            delays.append(named - slips_at)
            sizes.append(live.slip.size_mm - slip_mm)
    return {
        "grasps": streams * _PRESSES,
        "streams": streams,
        "named": len(delays),
        "frames_until_named": float(np.max(delays)) if delays else None,
        "size_off_mm": float(np.sqrt(np.mean(np.square(sizes)))) if sizes else None,
        "presses_right": float(np.mean(good)),
        "false_alarms": alarms,
    }


def report(result: Result) -> str:
    """One line for each reader and slip, and the bound of false alarms."""
    lines = []
    for row in result["rows"]:
        line = f"{row['reader']}, {row['slip_mm']:g} mm: "
        if row["slip_mm"]:
            line += f"named in {row['named']} of {row['streams']}"
            if row["named"]:
                line += (
                    f", {row['frames_until_named']:.0f} frames after it at the latest, size within "
                    f"{row['size_off_mm']:.3f} mm (rms)"
                )
            line += "; "
        line += f"presses right and explained {row['presses_right']:.1%} afterwards; "
        lines.append(line + f"{row['false_alarms']} false alarms in {row['grasps']} grasps")
    # 0 of n: at 95 % confidence fewer than 3 in n (rule of three)
    most = f"fewer than {3 / result['means']:.1e} a mean (95 %)" if not result["alarms"] else ""
    lines.append(
        f"{result['alarms']} of {result['means']} means at rest called a slip {most}".strip()
    )
    return "\n".join(lines)


if __name__ == "__main__":
    run(
        measure,
        report,
        grasps=(int, 300, "of each reader and slip"),
        means=(int, 300_000, "at rest without a slip"),
    )
