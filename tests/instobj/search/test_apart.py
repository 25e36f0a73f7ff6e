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
        found = ask([1, 2, 3, 4, 5], 60.0)
        assert [answer for _, answer in found] == [2, 4, 6, 8, 10]
        assert len({process for process, _ in found}) == 2
        assert [answer for _, answer in ask([7], 60.0)] == [14]
        with pytest.raises(GivenUp, match="died"):
            ask([1, "die"], 60.0)
        assert [answer for _, answer in ask([8, 9], 60.0)] == [16, 18], "another takes its place"


def test_while_there_is_no_answer_it_is_said_how_many_questions_wait(monkeypatch):
    monkeypatch.setattr(apart, "NEWS_EVERY_S", 0.05)
    told = []
    with side_by_side(doubles, 2, 2, told.append) as ask, pytest.raises(GivenUp, match="no result"):
        ask([1, "sleep", 3], 3.0)
    assert len(told) > 5
    assert set(told) == {3}


def test_an_interrupt_does_not_wait_for_the_answers():
    began = time.monotonic()

    def interrupt(number, frame):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)

    def asked():
        with side_by_side(doubles, 2, 2) as ask:
            ask([1, 2], 60.0)
            signal.setitimer(signal.ITIMER_REAL, 0.5)
            ask(["sleep", "sleep"], 60.0)

    try:
        with pytest.raises(KeyboardInterrupt):
            asked()
    finally:
        signal.signal(signal.SIGALRM, before)
    assert time.monotonic() - began < 40
