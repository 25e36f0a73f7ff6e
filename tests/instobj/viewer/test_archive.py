"""The page's archive holds what it was given, to its steps."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from instobj.viewer.archive import pack, stepped
from tests.support.archives import unpack


@pytest.mark.parametrize(("kind", "most"), [("i1", 126), ("i2", 32766)])
def test_numbers_come_back_to_half_a_step_and_gaps_as_gaps(kind, most):
    values = np.random.default_rng(1).normal(0, 7.0, (3, 5, 2))
    values[1, 2, 0] = np.nan
    content, arrays = unpack(pack({"name": "cube"}, {"a": stepped(values, kind)}))
    assert content == {"name": "cube"}
    assert arrays["a"].shape == values.shape
    assert_allclose(arrays["a"], values, atol=0.501 * np.nanmax(abs(values)) / most)


def test_arrays_of_odd_lengths_do_not_run_into_each_other():
    given = {
        "a": np.arange(5, dtype="<u1"),
        "b": np.arange(3, dtype="<f4") / 3,
        "c": np.array([7], "<u2"),
    }
    _, arrays = unpack(pack({}, given))
    for name, array in given.items():
        assert_array_equal(arrays[name], array)


def test_equal_scenes_give_equal_files():
    arrays = {"a": stepped(np.linspace(-1, 1, 9), "i2", 0.005)}
    assert pack({"x": 1}, arrays) == pack({"x": 1}, arrays)


def test_a_number_that_the_page_cannot_read_is_refused():
    with pytest.raises(ValueError, match="JSON"):
        pack({"x": float("nan")}, {})
