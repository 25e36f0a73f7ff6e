"""Labels, stamps and axes of chips, from names or from values alone."""

import numpy as np
import pytest

from design.errors import RecordingError
from estimator.adoption.columns import group_axes, tell_columns
from estimator.adoption.text_table import TextTable
from tests.support.recordings.foreign_logs import ForeignObject, make_log

LOG = make_log(ForeignObject(), shape=(3, 3), pitch=(13, 16), rows=5)


def table(columns, names=None):
    return TextTable(np.column_stack(columns), names, ())


def test_values_alone_tell_face_place_and_level():
    log = tell_columns(table([LOG.columns()]))
    np.testing.assert_array_equal(np.hstack([log.face, log.place, log.label]), LOG.labels)
    np.testing.assert_array_equal(log.channels, LOG.counts.reshape(len(LOG.counts), -1))


def test_labels_may_stand_behind_and_in_another_order_with_stamps_in_front():
    stamps = 1.7e9 + 0.1 * np.arange(len(LOG.labels))
    flat = LOG.counts.reshape(len(LOG.counts), -1)
    log = tell_columns(table([stamps, flat, LOG.labels[:, [2, 1, 0]]]))
    np.testing.assert_array_equal(log.time_s, stamps)
    np.testing.assert_array_equal(np.hstack([log.face, log.place, log.label]), LOG.labels)


def test_forces_of_another_grain_are_found_beside_the_chips():
    force = np.random.default_rng(0).uniform(0, 9, (len(LOG.labels), 2)).round(2)
    flat = LOG.counts.reshape(len(LOG.counts), -1)
    log = tell_columns(table([force, flat, LOG.labels[:, :2]]))
    np.testing.assert_array_equal(log.label, force)
    np.testing.assert_array_equal(log.place, LOG.labels[:, 1:2])


def test_names_order_the_axes_of_every_chip():
    names = [f"{axis}{chip}" for axis in "XYZ" for chip in range(1, 16)]
    by_axis = LOG.counts.transpose(0, 2, 1).reshape(len(LOG.counts), -1)
    log = tell_columns(table([LOG.labels, by_axis], ("Face", "Pos", "Level", *names)))
    counts, _ = group_axes(log, None)
    np.testing.assert_array_equal(counts, LOG.counts)


@pytest.mark.parametrize("by_axis", [False, True])
def test_values_tell_how_the_axes_stand(by_axis):
    flat = LOG.counts.transpose(0, 2, 1) if by_axis else LOG.counts
    log = tell_columns(table([LOG.labels, flat.reshape(len(flat), -1)]))
    counts, finding = group_axes(log, None)
    np.testing.assert_array_equal(counts, LOG.counts)
    assert finding.p is not None
    assert finding.p < 0.02


def test_stated_columns_hold_and_wrong_ones_are_refused():
    log = tell_columns(table([LOG.columns()]), "-,place,level,chips")
    assert log.face.shape[1] == 0
    with pytest.raises(RecordingError, match="cannot be placed"):
        tell_columns(table([LOG.columns()]), "face,what,level,chips")
    with pytest.raises(RecordingError, match="three columns each"):
        tell_columns(table([LOG.columns()]), "face,place,chips")


def test_columns_that_fit_two_kinds_of_log_are_asked_for():
    flat = LOG.counts.reshape(len(LOG.counts), -1)
    with pytest.raises(RecordingError, match="State the columns"):
        tell_columns(table([flat[:, :-1]]))
    with pytest.raises(RecordingError, match="State the columns"):
        tell_columns(table([LOG.labels[:, [0, 2]], flat]))


def test_stamps_in_seconds_and_nanoseconds_are_one_time_by_values_and_by_names():
    """Stamps that ROS 2 exports; 40 rows a second, so that seconds alone stand still."""
    rows = np.arange(len(LOG.labels))
    stamps = [1_718_000_000 + rows // 40, rows % 40 * 25_000_000]
    by_values = tell_columns(table([*stamps, LOG.columns()]))
    names = [f"{axis}{chip}" for chip in range(1, 16) for axis in "XYZ"]
    stamp_words = ("stamp.sec", "stamp.nanosec", "Face", "Pos", "Level", *names)
    for log in (by_values, tell_columns(table([*stamps, LOG.columns()], stamp_words))):
        assert log.time_s is not None
        np.testing.assert_allclose(log.time_s - log.time_s[0], rows / 40, atol=1e-6)
        np.testing.assert_array_equal(np.hstack([log.face, log.place, log.label]), LOG.labels)


@pytest.mark.parametrize("stands", ["first", "between"])
def test_a_column_that_is_always_zero_is_no_label(stands):
    """`data_offset` of an exported array."""
    zero, flat = np.zeros(len(LOG.labels)), LOG.counts.reshape(len(LOG.counts), -1)
    columns = [zero, LOG.labels, flat] if stands == "first" else [LOG.labels, zero, flat]
    log = tell_columns(table(columns))
    np.testing.assert_array_equal(np.hstack([log.face, log.place, log.label]), LOG.labels)
    np.testing.assert_array_equal(log.channels, flat)


@pytest.mark.parametrize("behind", [False, True])
def test_first_chips_that_never_answer_stay_chips(behind):
    counts = LOG.counts.copy()
    counts[:, :2] = 0
    flat = counts.reshape(len(counts), -1)
    log = tell_columns(table([flat, LOG.labels] if behind else [LOG.labels, flat]))
    np.testing.assert_array_equal(log.channels, flat)
    np.testing.assert_array_equal(np.hstack([log.face, log.place, log.label]), LOG.labels)
