"""Tangential forces in the generic recording."""

import csv
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.errors import InputError
from estimator.recordings.formats.files import read_table
from estimator.recordings.formats.netcdf import write_generic_netcdf
from estimator.recordings.reading import read_recording
from tests.support.recordings.generic_csv import SHEAR_SHARE, edited, with_shear, write_generic_csv


def test_tangential_forces_survive_both_forms(table, sheared, tmp_path):
    (tmp_path / "a.csv").write_text(sheared)
    as_csv = read_table(tmp_path / "a.csv")
    assert_allclose(as_csv.shear_n, with_shear(table).shear_n, atol=2e-6)
    write_generic_netcdf(as_csv, tmp_path / "a.nc")
    as_netcdf = read_table(tmp_path / "a.nc")
    assert_array_equal(as_netcdf.shear_n, as_csv.shear_n)
    assert as_netcdf.digest == as_csv.digest
    write_generic_csv(as_netcdf, tmp_path / "b.csv")
    assert (tmp_path / "b.csv").read_text() == sheared
    write_generic_netcdf(replace(as_csv, shear_n=-as_csv.shear_n), tmp_path / "c.nc")
    assert read_table(tmp_path / "c.nc").digest != as_csv.digest
    write_generic_netcdf(table, tmp_path / "plain.nc")
    assert read_table(tmp_path / "plain.nc").shear_n is None


@pytest.mark.parametrize("late_frames", [0, 4])
def test_tangential_labels_stand_beside_the_normal_ones(table, tmp_path, late_frames):
    """Rest level off, lag corrected; planted fault: tangential forces 4 frames later than those."""
    write_generic_netcdf(with_shear(table, late_frames), tmp_path / "a.nc")
    frames = read_recording(tmp_path / "a.nc").frames
    error_n = []
    for cell in range(2):
        force = frames.force_n[frames.valid & (frames.contact_face[:, cell] > 0), cell]
        assert force[:, 2].max() > 10
        error_n.append(np.abs(force[:, :2] - force[:, 2:] * SHEAR_SHARE[cell]).max())
    assert (max(error_n) < 0.05) == (late_frames == 0)
    assert np.isnan(frames.force_n[frames.contact_face == 0]).all()


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("cell1_shear_x_n", "cell1_shear_x_mn", "'cell1_shear_x_mn'"),
        ("cell1_shear_x_n", "cell3_shear_x_n", "'cell3_shear_x_n'"),
        ("cell2_shear_y_n", "cell2_shear_x_n", "twice"),
        (",cell2_shear_y_n", "", "lacks the columns cell2_shear_y_n"),
    ],
)
def test_headers_with_a_mistake_in_tangential_forces(tmp_path, sheared, old, new, words):
    with pytest.raises(InputError, match=words):
        read_recording(edited(tmp_path, sheared, old, new))


@pytest.mark.parametrize(
    ("value", "words"),
    [("", "cell1_shear_y_n is empty"), ("much", "not a number"), ("4e3", "shear forces")],
)
def test_impossible_tangential_forces(tmp_path, sheared, value, words):
    rows = list(csv.reader(sheared.splitlines()))
    rows[9][rows[0].index("cell1_shear_y_n")] = value
    with (tmp_path / "a.csv").open("w", newline="") as file:
        csv.writer(file).writerows(rows)
    with pytest.raises(InputError, match=words):
        read_recording(tmp_path / "a.csv")
