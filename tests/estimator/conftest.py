"""Networks this small gain nothing from a second thread, and lose much where cores are shared."""

import pytest
import torch

from tests.support import smaller_statistics

smaller_statistics.install()


@pytest.fixture(scope="module")
def statistics_in_full():
    """For modules that ask how good they are."""
    with smaller_statistics.in_full():
        yield


@pytest.fixture(autouse=True, scope="session")
def _one_torch_thread():
    torch.set_num_threads(1)
