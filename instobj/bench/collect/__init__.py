"""Commands that meet boards and built objects: collect, predict, live, firmware, rig."""
