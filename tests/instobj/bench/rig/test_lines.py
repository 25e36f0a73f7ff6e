"""Replies of Grbl as its interface document prints them, numbers of load cells, and the send buffer."""

import pytest

from instobj.bench.rig.grbl_lines import GrblSpeech
from instobj.bench.rig.load_lines import NumberLines
from instobj.bench.rig.machine import MachineFault, MachineLink
from instobj.bench.rig.marlin_lines import MarlinSpeech
from instobj.bench.rig.replies import Alarm, Done, Greeting, Refused, Setting, State


class FakeLine:
    def __init__(self):
        self.said, self.got = b"", b""

    def read(self, size):
        said, self.said = self.said, b""
        return said

    def write(self, data):
        self.got += data
        return len(data)


def test_every_kind_of_reply_is_read_over_any_cut_of_the_bytes():
    text = (
        b"\r\nGrbl 1.1h ['$' for help]\r\n[MSG:'$H'|'$X' to unlock]\r\n$130=200.000\r\nok\r\n"
        b"error:20\r\nALARM:1\r\n<Hold:0|MPos:-1.000,2.500,-3.125|FS:0,0|Ov:100,100,100>\r\n"
    )
    wanted = [
        Greeting(),
        Setting("$130", 200.0),
        Done(),
        Refused("error:20 (unknown G-code)"),
        Alarm("ALARM:1 (a limit switch was hit; the position is lost)"),
        State("Hold", 0, (-1.0, 2.5, -3.125)),
    ]
    for size in (1, 7, 1000):
        reader = GrblSpeech()
        pieces = [text[k : k + size] for k in range(0, len(text), size)]
        assert [one for piece in pieces for one in reader.feed(piece)] == wanted
        assert reader.damaged == 0


def test_work_positions_need_their_offset_and_damaged_lines_are_counted():
    reader = GrblSpeech()
    assert reader.feed(b"<Idle|WPos:1.000,2.000,3.000|FS:0,0>\n") == []
    (found,) = reader.feed(b"<Idle|WPos:1.000,2.000,3.000|FS:0,0|WCO:-10.000,0.000,-5.000>\n")
    assert found.position_mm == (-9.0, 2.0, -2.0)
    (found,) = reader.feed(b"<Run|WPos:2.000,2.000,3.000|FS:0,0>\n")
    assert found.position_mm == (-8.0, 2.0, -2.0)
    assert reader.feed(b"k\n<Idle|MPos:1.0,2.0>\n<Idle|MPos:1.0,2.0,x>\nerro:2\n") == []
    assert reader.damaged == 5


def test_lines_wait_until_the_machine_has_room_for_them():
    line = FakeLine()
    link = MachineLink(line, "machine", trusted=True, floor_mm=-200.0)
    sent = [f"G53G0X-{100 + k}.125" for k in range(20)]
    link.send(*sent)
    answered = 0
    while link.unanswered:
        assert len(line.got) - sum(len(one) + 1 for one in sent[:answered]) <= 127
        line.said = b"ok\r\n"
        link.poll()
        answered += 1
    assert line.got.decode().split() == sent


def test_lines_that_belong_together_are_sent_at_once_or_not_yet():
    line = FakeLine()
    link = MachineLink(line, "machine", trusted=True, floor_mm=-200.0)
    for _ in range(3):
        link.send_whole(["G53G1Z-112.35F120", "G4P0.3", "G53G0Z-109", "G4P0.9"])
    part = b"G53G1Z-112.35F120\nG4P0.3\nG53G0Z-109\nG4P0.9\n"
    assert line.got == 2 * part  # 43 of 127 characters each
    assert link.unanswered == 12
    line.said = b"ok\r\n"
    link.poll()
    assert line.got == 3 * part


def test_faults_are_told_with_the_line_that_was_refused():
    line = FakeLine()
    link = MachineLink(line, "machine", trusted=True, floor_mm=-200.0)
    link.send("G4P1", "G53G0Z-1")
    line.said = b"ok\r\nerror:33\r\n"
    with pytest.raises(MachineFault, match=r"error:33 \(the target is no place\) to 'G53G0Z-1'"):
        link.poll()
    line.said = b"Grbl 1.1h ['$' for help]\r\n"
    with pytest.raises(MachineFault, match="was reset"):
        link.poll()
    assert link.unanswered == 0


def test_numbers_become_newtons_by_their_unit_or_the_scale():
    lines = NumberLines(scale=-0.5)
    assert lines.feed(b"34\n2\n-4.5\r\n1 N\n10") == [-1.0, 2.25, 1.0]
    assert lines.feed(b"0 g\n2e3mN\nload: 3\n\n") == pytest.approx([0.980665, 2.0])
    assert lines.damaged == 1


def test_marlin_is_sent_numbered_lines_with_the_check_sum_of_its_documents():
    """The RepRap documents print `N5 G28*22`; moves name their own speed, which Marlin keeps for all."""
    speech = MarlinSpeech()
    sent = [
        speech.encode(line).decode() for line in ("G90", "G53G0X-1Y-2", "G53G1Z-5F60", "G53Z-6")
    ]
    assert [line.partition("*")[0] for line in sent] == [
        "N1 G90",
        "N2 G0X-1Y-2F600",
        "N3 G1Z-5F60",
        "N4 G1Z-6F60",
    ]
    assert speech.encode("G28") == b"N5 G28*22\n"
    speech.restart()
    assert speech.encode("G90") == b"N1 G90*17\n"


def test_marlin_stands_still_where_its_motors_are_where_they_were_sent():
    """`ok` behind a report belongs to it; one of a line is handed on."""
    speech = MarlinSpeech()
    assert speech.feed(b"echo:  M92 X80.00 Y80.00 Z400.00 E93.00\nok\n") == []
    moving = b"X:10.00 Y:0.00 Z:-5.00 E:0.00 Count X:400 Y:0 Z:-2000\nok P15 B3\n"
    assert speech.feed(moving + b"ok\n") == [State("Run", None, (5.0, 0.0, -5.0)), Done()]
    still = b"X:10.00 Y:0.01 Z:-5.00 E:0.00 Count X: 800 Y:1 Z:-2000\nok\n"
    assert speech.feed(still) == [State("Idle", None, (10.0, 0.0125, -5.0))]
    core_xy = b"X:10.00 Y:0.00 Z:-5.00 E:0.00 Count A:800 B:0 Z:-2000\n"
    assert speech.feed(core_xy) == []  # its motors are no axes
    text = (
        b"start\nbusy: processing\nError:Printer halted. kill() called!\nCap:EMERGENCY_PARSER:1\n"
    )
    assert speech.feed(text) == [
        Greeting(restarted=True),
        Alarm("Error:Printer halted. kill() called!"),
        Setting("EMERGENCY_PARSER", 1.0),
    ]
