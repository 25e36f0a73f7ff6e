"""Positions of everything: contact grids, magnets, sensors, pockets, boards, tips."""
