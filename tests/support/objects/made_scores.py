"""Scores of an object that are made up but for the position bounds."""

from dataclasses import fields

import numpy as np

from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from estimator.information.scores import PlaceScores


def scores_of(spec, bound_mm):
    """Scores with these position bounds, all others 1."""
    there = contact_places(spec)
    ones = np.where(there, 1.0, np.nan)
    values = {field.name: ones for field in fields(PlaceScores)[2:]}
    values |= {"reaches_score_force": there}
    bound = np.where(there, bound_mm, np.nan)
    values |= {"position_bound_mm": bound, "position_error_mm": bound}
    return PlaceScores(np.array(spec.body.sensed), contact_grid(spec), **values)
