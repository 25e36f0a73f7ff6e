"""The gap between two pockets, as tests ask for it."""

from design.layout.pockets import gaps_across_edge_mm, pocket_ends


def gap_across_edge_mm(frame, a, other, b):
    """`gaps_across_edge_mm` of one pocket each."""
    return float(gaps_across_edge_mm(pocket_ends(frame, (a,)), pocket_ends(other, (b,)))[0, 0])
