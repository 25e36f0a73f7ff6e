"""Figures that Knopke et al. (RA-L 2024) published, to stand beside ours."""

from __future__ import annotations

TABLE_I: dict[int, dict[str, float]] = {
    face: {
        "A_sim": similarity,
        "E_loc px": 1e-4 * location,
        "E_f %": percent,
        "E_f N": newton,
        "A_non": 1.0,
    }
    for face, similarity, location, percent, newton in (
        (1, 0.999, 15.3, 1.82, 0.278),
        (2, 0.999, 67.8, 2.09, 0.380),
        (3, 0.997, 127.0, 3.23, 0.479),
        (4, 0.999, 60.4, 1.99, 0.370),
        (5, 0.999, 25.5, 2.09, 0.410),
    )
}
"""General performance, random split of frames."""
TABLE_II = {
    "seen": {"A_sim": 1.0, "E_loc px": 0.0, "E_f %": 3.06, "E_f N": 0.372},
    "unseen": {"A_sim": 0.896, "E_loc px": 1.32, "E_f %": 32.6, "E_f N": 4.18},
}
TABLE_III = {
    3: {"A_sim": 0.631, "E_loc px": 1.91, "E_f %": 38.7, "E_f N": 5.76, "A_non": 0.933},
    5: {"A_sim": 0.678, "E_loc px": 2.96, "E_f %": 23.8, "E_f N": 4.61, "A_non": 0.984},
}
"""Grasps by a gripper that presses faces 3 and 5 at once."""
LINEAR = {"A_sim": 0.318, "E_loc px": 1.36, "E_f %": 43.5, "E_f N": 6.56, "A_non": 0.625}
"""Linear regression on face 1, from the authors' repository page."""
LEAST_TRAINING_FRAMES = 2683
"""Down to this many training frames, 1/32 of all, the paper's performance held."""


def beside(ours: dict[str, float | None], published: dict[str, float]) -> dict[str, float | None]:
    """Our columns, each followed by the published one where there is one."""
    row: dict[str, float | None] = {}
    for name, value in ours.items():
        row[name] = value
        if name in TABLE_I[1]:
            row[f"paper {name}"] = published.get(name)
    return row
