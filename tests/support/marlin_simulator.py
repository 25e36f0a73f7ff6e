"""A machine with Marlin 2 after its published G-codes and sources, in the room of the Grbl one.

It answers `ok` once a move is planned, reports `M114` at once, carries out a line whole or refuses it by
its number and check sum, and stops at once on `M410` as the characters come in, where it was built so. What
waits behind that stop is carried out afterwards.
"""

import re
from functools import reduce
from operator import xor

import numpy as np

from tests.support.grbl_simulator import HOLD_S, PLANNED, GrblSimulator

STEPS = np.array([80.0, 80.0, 400.0])
LOW_MM = np.array([-300.0, -200.0, -80.0])
WORD = re.compile(r"([GXYZF])(-?\d*\.?\d+)")


class MarlinSimulator(GrblSimulator):
    def __init__(self, emergency_parser=True, soft="ON", switches=("x_max", "y_max", "z_max")):
        self.emergency_parser, self.soft, self.switches = emergency_parser, soft, switches
        super().__init__()

    def power_on(self):
        """As after plugging in: position unknown, and called zero."""
        self.position, self.state, self.number = np.zeros(3), "Idle", 0
        self.off_after_s = 120  # motors without a move
        self._clear()
        self.say("start\necho:Marlin 2.1.2\n")

    def take(self, data):
        for byte in data:
            self.bytes_in += 1
            if self.bytes_in in self.drop_in or self.state == "Alarm":
                continue
            if len(self.rx) >= 128:
                self.overflowed = True
                continue
            self.rx.append(byte)
            if self.emergency_parser and self.rx.split(b"\n")[-2:] == [b"M410", b""]:
                self._stop()

    def _stop(self):
        self.holds.append(self.now)
        if self.state == "Run":
            self.state, self.hold_left = "Hold", HOLD_S

    def report(self):
        sent = self.plan[-1][0] if self.plan else self.position
        counts = np.round(self.position * STEPS)
        sent_text, count_text = (
            " ".join(
                f"{axis}:{value:.{digits}f}" for axis, value in zip("XYZ", values, strict=True)
            )
            for values, digits in ((sent, 2), (counts, 0))
        )
        return f"{sent_text} E:0.00 Count {count_text}\n"

    def _carry_out(self, line):
        if self.state == "Hold":
            return False
        if line.startswith("N"):
            text, _, check = line.rpartition("*")
            head, _, line = text.partition(" ")
            if check != str(reduce(xor, text.encode(), 0)):
                return self._refuse("checksum mismatch")
            if line.startswith("G") and self.refuse:
                self.refuse.popleft()
                return self._refuse("checksum mismatch")
            if line.startswith("M110"):
                self.number = int(line.partition("N")[2])
            elif int(head[1:]) != self.number + 1:
                return self._refuse("Line Number is not Last Line Number+1")
            else:
                self.number += 1
            self.waiting = line
        if line.startswith("G28"):
            return self._home(line)
        if line.startswith(("G0", "G1")):
            return self._move_to(line)
        if line == "M410" and not self.emergency_parser:
            self._stop()
        self._tell(line)
        self.say("ok\n")
        return True

    def _refuse(self, why):
        self.say(f"Error:{why}, Last Line: {self.number}\nResend: {self.number + 1}\nok\n")
        self.rx.clear()
        return True

    def _tell(self, line):
        ends = [
            " ".join(f"{axis}{value:.2f}" for axis, value in zip("XYZ", end, strict=True))
            for end in (LOW_MM, np.zeros(3))
        ]
        texts = {
            "M92": "echo:  M92 X80.00 Y80.00 Z400.00 E93.00\n",
            "M114": self.report(),
            "M115": f"FIRMWARE_NAME:Marlin 2.1.2\nCap:EMERGENCY_PARSER:{int(self.emergency_parser)}\n",
            "M211": f"echo:Soft endstops: {self.soft}  Min: {ends[0]}   Max: {ends[1]}\n",
            "M119": "Reporting endstop status\n" + "".join(f"{k}: open\n" for k in self.switches),
        }
        if line.startswith("M118 E1 "):
            self.say(f"echo:{line[8:]}\n")
        elif line in texts:
            self.say(texts[line])
        elif line == "M84S0":
            self.off_after_s = 0
        elif not line.startswith("M110") and line not in ("G21", "G90", "M410", ""):
            self.say(f'echo:Unknown command: "{line}"\n')

    def _home(self, line="G28"):
        if self.state != "Home":
            self.state, self.busy_until = "Home", self.now + 2.0
        if self.now < self.busy_until:
            return False
        self.position[["XYZ".index(axis) for axis in line[3:]]] = 0.0
        self.state = "Idle"
        self._answer("ok")
        return True

    def _move_to(self, line):
        if len(self.plan) >= PLANNED:
            return False
        target = self.plan[-1][0].copy() if self.plan else self.position.copy()
        for letter, value in WORD.findall(line):
            if letter in "XYZ":
                target["XYZ".index(letter)] = float(value)
            elif letter == "F":
                self.feed = float(value)
        self.plan.append((np.clip(target, LOW_MM, 0.0), self.feed / 60))
        self.lines.append(line)
        self.state = "Run"
        self._answer("ok")
        return True

    def alarm(self, number):
        self.state = "Alarm"
        self._clear()
        self.say("Error:Printer halted. kill() called!\n")

    def _move(self, seconds):
        super()._move(seconds)
        if self.state == "Hold" and self.hold_left is None:
            self.plan.clear()
            self.state = "Idle"
