"""Objects off the design: tolerances, virtual objects, faults seen at rest."""
