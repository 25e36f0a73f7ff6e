"""Questions answered by a separate process, or by several: in order, whatever becomes of one of them."""

import os
import signal
import time

import pytest

from design.errors import InputError
from instobj.search import apart
from instobj.search.apart import WorkerTimeout, answers
from instobj.stages.workers import Here, open_workers


def _sleepy(argument):
    """What a question of one part asks for: a death, an error, or a nap of so many seconds."""

    def answer(question):
        (part,) = question
        if part == "die":
            os.kill(os.getpid(), signal.SIGKILL)
        if part == "fail":
            raise ZeroDivisionError("by nothing")
        if part == "refuse":
            raise InputError("not that")
        time.sleep(part)
        return [argument]

    return answer


def _given_up_and_asked_again(ask):
    assert ask([[0]], 60.0) == [["done"]]
    (slow,) = ask([[60]], 0.5)
    dead, failed, refused, done = ask([["die"], ["fail"], ["refuse"], [0]], 60.0)
    assert isinstance(slow, WorkerTimeout)
    assert "no result after 0.5 s" in str(slow)
    assert isinstance(dead, WorkerTimeout)
    assert isinstance(failed, WorkerTimeout)
    assert "ZeroDivisionError" in str(failed)
    assert isinstance(refused, InputError)
    assert "not that" in str(refused)
    assert done == ["done"]


def test_work_apart_is_given_up_and_starts_again():
    with answers(_sleepy, "done", Here()) as ask:
        _given_up_and_asked_again(ask)


def test_work_of_several_processes_is_given_up_and_starts_again():
    """A question whose worker dies each time is asked of others, then given up."""
    with open_workers(2) as workers, answers(_sleepy, "done", workers) as ask:
        _given_up_and_asked_again(ask)


def _doubles(argument):
    def answer(question):
        time.sleep(0.5 * ("sleep" in question))
        return [(os.getpid(), argument * part) for part in question if part != "sleep"]

    return answer


def test_answers_come_in_the_order_of_the_questions_from_all_processes():
    with open_workers(2) as workers, answers(_doubles, 2, workers) as ask:
        found = ask([[1, 2, "sleep"], [3, "sleep"], [4, 5]], 60.0)
    assert [[value for _, value in answer] for answer in found] == [[2, 4], [6], [8, 10]]
    assert len({process for answer in found for process, _ in answer}) == 2
    assert os.getpid() not in {process for answer in found for process, _ in answer}


def test_while_there_is_no_answer_it_is_said_how_many_parts_wait(monkeypatch):
    monkeypatch.setattr(apart, "NEWS_EVERY_S", 0.05)
    told = []
    with answers(_sleepy, "done", Here(), told.append) as ask:
        _, late = ask([[0], [60]], 3.0)
    assert "no result" in str(late)
    assert len(told) > 5
    assert set(told) == {2}


def test_an_interrupt_does_not_wait_for_the_answers():
    began = time.monotonic()

    def interrupt(number, frame):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)

    def asked():
        with answers(_sleepy, "done", Here()) as ask:
            ask([[0]], 60.0)
            signal.setitimer(signal.ITIMER_REAL, 0.5)
            ask([[60], [60]], 60.0)

    try:
        with pytest.raises(KeyboardInterrupt):
            asked()
    finally:
        signal.signal(signal.SIGALRM, before)
    assert time.monotonic() - began < 40
