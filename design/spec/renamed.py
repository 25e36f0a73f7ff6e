"""Keys that a specification once had: renamed ones still read, with a warning; removed ones are errors."""

from __future__ import annotations

import warnings
from typing import Any

from design.errors import SpecError

_OBJECTIVES = {"cross_face_sigma": "median_false_force_n"}
RENAMED = {
    "training": {"members": "ensemble", "interval_cover": "coverage"},
    "search.objectives": _OBJECTIVES,
    "search.limits.times_start": _OBJECTIVES,
}
"""Table (or list) → older key → its name now; tables after the tables that hold them."""
_OBJECTIVES_GONE = {
    "build_minutes": "search.vary counts the parts",
    "compliance_deviation": "layouts are not judged by softness",
    "cost": "search.vary counts the parts",
    "edge_position_bound_mm": "take percentile_99_position_bound_mm",
    "grasp_position_bound_mm": "take worst_position_bound_mm",
    "pair_all_position_bound_mm": "take worst_position_bound_mm",
    "pair_own_position_bound_mm": "take worst_position_bound_mm",
    "percentile_95_position_bound_mm": "take percentile_99_position_bound_mm",
    "position_bound_over_start": "take position_over_limit",
    "slip_place_mm": "`instobj run --to robustness` tells what slip costs",
    "task_loss": "take worst_position_bound_mm and worst_force_bound_n",
    "tolerance_place_mm": "`instobj run --to robustness` tells what tolerances cost",
}
REMOVED = {
    "collection.hysteresis": "silicone.prony makes the felt force lag",
    "core.hub_depth_mm": "the hub's recess is 0.5 mm deep",
    "core.wire_diameter_mm": "wires measure 0.4 mm with their insulation",
    "export": "triangles leave the solids by 0.05 mm at most and turn by 0.2 rad",
    "inversion.least_force_n": "contacts of 0.2 N and more are read",
    "magnets.current_a": "an electromagnet is a magnet of μ0 N I / L: study `electromagnets`",
    "magnets.kind": "an electromagnet is a magnet of μ0 N I / L: study `electromagnets`",
    "magnets.switching": "an electromagnet is a magnet of μ0 N I / L: study `electromagnets`",
    "magnets.turns": "an electromagnet is a magnet of μ0 N I / L: study `electromagnets`",
    "mechanics.element = p1": "linear tetrahedra lock. Take taylor-hood",
    "mechanics.slip.model": "the shell follows its slipped core by finite elements",
    "mould.dowel_draft_deg": "dowels have a draft of 10°",
    "mould.play_mm": "sliding parts have printer.clearance_mm between them",
    "mould.silicone_waste": "15 % more silicone is mixed than the parts hold",
    "mould.vent_mm": "vents are as wide as printer.hole_mm",
    "printer.aspect": "it is that of printer.process",
    "printer.density_g_per_cm3": "it is that of printer.process",
    "printer.draft_deg": "it is that of printer.process",
    "protocol.peak_force_spread": "peaks vary by 10 % from press to press",
    "score.hull": "δ is taken from the covariance of the signals",
    "score.hull_frames": "δ is that of 1000 frames",
    "search.batch": "a batch has a layout for each process, 64 on a card, 16 without polish_steps",
    "search.compliance_mm_per_n": "layouts are not judged by softness",
    "search.engine": "layouts begin at random, choices by turns, and are improved by CMA-ES",
    "search.limits.board_gap_mm": "printer.wall_mm stays between two recesses",
    "search.limits.build_minutes": "parts are counted by search.vary.magnet_count and sensor_count",
    "search.limits.cost": "parts are counted by search.vary.magnet_count and sensor_count",
    "search.limits.parts_per_face": "parts are counted by search.vary.magnet_count and sensor_count",
    "search.limits.places_worse": "a location may get worse within limits.position_bound_mm, and beyond it "
    "where others gain as much",
    "search.limits.pocket_gap_mm": "silicone.thinnest_wall_mm stays between two pockets",
    "search.limits.wiring_mm": "boards lie within search.vary.sensor_reach_mm",
    "search.magnet_symmetry": "every magnet has its own place",
    "search.prices": "what is tried next is priced at 0.2 EUR a magnet and 3 EUR a sensor",
    "search.sensor_symmetry": "every sensor has its own place",
    "search.task": "layouts are judged by bounds of position and force",
    "search.trial_seconds": "a trial may take 3 s for each generation, 900 s at least",
    "search.vary.core_size_mm": "search once for each size of the core",
    "search.vary.sensor_range_mt": "search once for each sensors.range_mt",
    "search.vary.sensor_turn_deg": "a chip turned about its Z measures as well",
    "sensors.i2c_khz": "the bus runs at 400 kHz",
    "sensors.offset_tolerance_mt": "offsets are drawn within tolerances.sensor_offset_ut",
    "silicone.cure_h": "the time to demould is that of the preset silicone.name",
    "silicone.mix_ratio": "the mixing ratio is that of the preset silicone.name",
    "silicone.peel_share": "peeling may take a third of silicone.elongation_percent",
    "silicone.pot_life_min": "the pot life is that of the preset silicone.name",
    "training.batch_size": "512 frames a batch, fewer of small data sets",
    "training.heatmap_axes": "estimators read the normal force (studies: FitSettings.axes)",
    "training.learning_rate": "it begins at 0.003",
    "training.model = linear": "ridge regression is a baseline of `instobj train`",
    "training.model = paper": "the paper's network is studies/paper/network.py",
    "training.output": "estimators draw heatmaps (studies: FitSettings.continuous)",
    "training.patience_epochs": "training stops 15 epochs after its best",
} | {
    f"{key} = {name}": why
    for name, why in _OBJECTIVES_GONE.items()
    for key in ("search.objectives", f"search.limits.times_start.{name}.[key]")
}
"""Key, table or `key = value` that there is no more → what holds in its place."""


def name_now(table: str, key: str) -> str:
    """The key's name now; warns where `key` is an older one."""
    now = RENAMED.get(table, {}).get(key)
    if now is None:
        return key
    warnings.warn(
        f"{table}.{key} is now called {table}.{now}. Rename it",
        FutureWarning,
        stacklevel=2,
    )
    return now


def rename_older_keys(table: str, given: Any) -> Any:
    """The table (or list) `given` with every key under its name now; anything else comes back as it is.

    Raises
    ------
    SpecError
        A key is given under both names.
    """
    if isinstance(given, list | tuple):
        return [
            name_now(table, key_name) if isinstance(key_name, str) else key_name
            for key_name in given
        ]
    if not isinstance(given, dict):
        return given
    for older, now in RENAMED[table].items():
        if older in given and now in given:
            raise SpecError(
                f"{table}.{older} is the older name of {table}.{now}; got both, "
                f"{given[older]!r} and {given[now]!r}. Keep {table}.{now}"
            )
    return {name_now(table, key): value for key, value in given.items()}
