"""Stamps and counts alone: of CSV without columns of load cells, and of whole recordings."""

import gzip

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import RecordingError
from estimator.recordings.formats.files import read_signals

HEADER = "time_s, F3-Y2,F1-X1"
ROWS = ["0.0,11,-4", "0.1,12,-5", "0.2,-1,-6"]


def written(folder, *lines):
    path = folder / "a.csv"
    path.write_text("\n".join(lines) + "\n")
    return path


@pytest.mark.parametrize("missing", [None, -1])
def test_signals_without_load_cells_are_read_by_their_names(tmp_path, missing):
    remark = [] if missing is None else [f"# missing = {missing}"]
    time_s, counts = read_signals(written(tmp_path, *remark, HEADER, *ROWS))
    assert_allclose(time_s, [0.0, 0.1, 0.2])
    assert counts.shape == (3, 5, 2, 3)
    assert_allclose(counts[:, 2, 1, 1], [11, 12, -1 if missing is None else np.nan])
    assert_allclose(counts[:, 0, 0, 0], [-4, -5, -6])
    assert np.isfinite(counts).sum() == (6 if missing is None else 5)


def test_signals_of_a_whole_recording_are_those_beside_its_labels(tmp_path):
    header = (
        "time_s,session,rest,F1-X1,F1-Y1,F1-Z1,cell1_force_n,cell1_face,cell1_x1_mm,cell1_y1_mm"
    )
    rows = [f"{0.1 * k:g},0,{int(k < 3)},{k},{2 * k},{3 * k},{k},1,0,0" for k in range(6)]
    time_s, counts = read_signals(written(tmp_path, header, *rows))
    assert_allclose(time_s, 0.1 * np.arange(6))
    assert_allclose(counts[:, 0, 0], np.outer(np.arange(6), [1, 2, 3]))
    assert np.isnan(counts[:, 1:]).all()


@pytest.mark.parametrize(
    ("header", "rows", "what"),
    [
        ("F1-X1,F3-Y2", ["1,2", "3,4"], "time_s"),
        ("time_s,F1-X1,cell1_face", ["0,1,1", "1,2,1"], "cell1"),
        ("time_s,F1-X1", ["0,1", "10,2", "20,3"], "10 s apart"),
        ("time_s,F1-X1", ["0,1", "0.1,2e8"], "raw counts of the sensors"),
    ],
)
def test_signals_that_cannot_be_are_refused(tmp_path, header, rows, what):
    with pytest.raises(RecordingError, match=what):
        read_signals(written(tmp_path, header, *rows))


def test_a_gzip_file_is_read_like_what_it_holds_and_a_cut_one_is_refused(tmp_path):
    plain = written(tmp_path, HEADER, *ROWS)
    packed = tmp_path / "a.csv.gz"
    packed.write_bytes(gzip.compress(plain.read_bytes()))
    for own, other in zip(read_signals(packed), read_signals(plain), strict=True):
        assert_allclose(own, other)
    packed.write_bytes(packed.read_bytes()[:-9])
    with pytest.raises(RecordingError, match="gzip file that is cut off"):
        read_signals(packed)
