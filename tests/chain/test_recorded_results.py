"""A function that returns something else than what is on record is noticed, and nothing else is."""

from copy import deepcopy
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
import scipy.sparse as sp
import torch

from tests.support.recorded_results.__main__ import agreed, chosen, updated
from tests.support.recorded_results.digests import Opaque, of_arguments, of_result
from tests.support.recorded_results.witness import SHARE, Witness

FILE, NAME = "tests/design/test_a.py", "design.a.function"


@dataclass
class Told:
    name: str
    value: np.ndarray
    count: int = 2


def recorded(function, *calls):
    """What two runs of a test file see, as it goes on record."""
    runs = []
    for _ in range(2):
        witness = Witness({}, recording=True)
        witness.begins(FILE)
        for args in calls:
            witness.call(NAME, function, deepcopy(args), {})
        runs.append(witness.records)
    return chosen(agreed(*runs))


def compared(records, function, *calls):
    witness = Witness(records)
    assert witness.begins(FILE)
    found = [witness.call(NAME, function, args, {}) for args in calls]
    witness.complain()
    return found


def told(values):
    return Told("a", values.cumsum() + 1)


def test_the_same_passes_and_another_result_for_the_same_arguments_does_not():
    one, other = np.arange(4.0), np.ones(3)
    assert len(compared(recorded(told, (one,)), told, (one,), (other,))) == 2
    for wrong in (
        lambda values: Told("b", values.cumsum() + 1),
        lambda values: Told("a", values.cumsum() + 1, 3),
        lambda values: Told("a", values.cumsum()[::-1] + 1),
        lambda values: Told("a", values.cumsum() + 1 + 1e-5),
        lambda values: Told("a", (values.cumsum() + 1)[:3]),
    ):
        with pytest.raises(AssertionError, match=r"design\.a\.function: .* on record, .* now"):
            compared(recorded(told, (one,)), wrong, (one,))
        compared(recorded(told, (one,)), wrong, (other,))
    compared(
        recorded(told, (one,)), lambda values: Told("a", values.cumsum() + 1 + SHARE / 5), (one,)
    )


def test_a_change_that_was_meant_takes_the_old_results_place():
    one = np.arange(4.0)
    records = recorded(told, (one,))
    witness = Witness(deepcopy(records))
    witness.begins(FILE)
    witness.call(NAME, lambda values: values * 7, (one,), {})
    updated(records, witness.changed)
    compared(records, lambda values: values * 7, (one,))


def test_what_a_function_does_to_its_arguments_counts_where_it_returns_nothing():
    def doubles(values):
        values *= 2

    def trebles(values):
        values *= 3

    records = recorded(doubles, (np.ones(2),))
    compared(records, doubles, (np.ones(2),))
    with pytest.raises(AssertionError):
        compared(recorded(doubles, (np.ones(2),)), trebles, (np.ones(2),))


def test_results_that_differ_from_run_to_run_do_not_go_on_record():
    draw = np.random.default_rng()
    assert recorded(lambda n: draw.random(n), (3,)) == {}
    assert recorded(lambda path: 1.0, (Path("tests"),)) == {}  # a folder's content is not looked at


def test_every_content_of_arguments_counts(tmp_path):
    file = tmp_path / "a.csv"
    file.write_text("1")
    values = [
        1, 2.5, "a", None, True, (1, 2), [1, 3], {"a": 1}, {"a": 2}, np.arange(3), np.arange(3.0),
        np.arange(6.0).reshape(2, 3), np.array(["a"]), sp.eye(3, format="csr"), torch.ones(2),
        np.random.default_rng(1), np.random.default_rng(2), file, Told("a", np.ones(1)), np.array([np.nan]),
    ]  # fmt: skip
    keys = [of_arguments(value) for value in values]
    assert len(set(keys)) == len(keys)
    file.write_text("2")
    assert of_arguments(file) not in keys
    assert keys == [of_arguments(value) if value is not file else keys[17] for value in values]
    with pytest.raises(Opaque):
        of_arguments(lambda: 1)
    assert of_result((lambda: 1, 2.0))[1] == [(1, 2.0, pytest.approx(2 * np.cos(0.7)))]
