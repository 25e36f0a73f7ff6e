"""Where everything is: contact grids, magnets, sensors, pockets, boards, tips."""
