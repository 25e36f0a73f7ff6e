"""Questions answered by several processes: in order, whatever becomes of one of them."""

import os
import signal
import time

import pytest

from instobj.search import apart
from instobj.search.apart import GivenUp, side_by_side


def doubles(argument):
    def answer(questions):
        if "die" in questions:
            os.kill(os.getpid(), signal.SIGKILL)
        if "sleep" in questions:
            time.sleep(60)
        return [(os.getpid(), argument * question) for question in questions]

    return answer


def test_answers_come_in_the_order_of_the_questions_from_all_processes():
    with side_by_side(doubles, 2, 2) as ask:
        found = ask([[1, 2], [3], [4, 5]], 60.0)
        assert [[value for _, value in answer] for answer in found] == [[2, 4], [6], [8, 10]]
        assert len({process for answer in found for process, _ in answer}) == 2
        well, died = ask([[7], ["die"]], 60.0)
        assert [value for _, value in well] == [14]
        assert isinstance(died, GivenUp)
        assert "died" in str(died)
        another = ask([[8], [9]], 60.0)
        assert [value for ((_, value),) in another] == [16, 18], "another takes its place"


def test_questions_wait_for_a_process_that_is_free():
    """Of four, three go to the process that is not asleep."""
    with side_by_side(doubles, 2, 2) as ask:
        asleep, *others = ask([["sleep"], [1], [2], [3]], 5.0)
    assert isinstance(asleep, GivenUp)
    assert len({process for ((process, _),) in others}) == 1


def test_while_there_is_no_answer_it_is_said_how_many_parts_wait(monkeypatch):
    monkeypatch.setattr(apart, "NEWS_EVERY_S", 0.05)
    told = []
    with side_by_side(doubles, 2, 2, told.append) as ask:
        _, late = ask([[1, 3], ["sleep"]], 3.0)
    assert "no result" in str(late)
    assert len(told) > 5
    assert set(told) == {3}


def test_an_interrupt_does_not_wait_for_the_answers():
    began = time.monotonic()

    def interrupt(number, frame):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)

    def asked():
        with side_by_side(doubles, 2, 2) as ask:
            ask([[1], [2]], 60.0)
            signal.setitimer(signal.ITIMER_REAL, 0.5)
            ask([["sleep"], ["sleep"]], 60.0)

    try:
        with pytest.raises(KeyboardInterrupt):
            asked()
    finally:
        signal.signal(signal.SIGALRM, before)
    assert time.monotonic() - began < 40
