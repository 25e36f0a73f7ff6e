"""A machine with Grbl 1.1 after its published protocol (gnea/grbl, doc/markdown), in simulated time.

Moves have a constant speed; a feed hold stops after 20 ms. `take` gets bytes, `give` returns those that
the machine sends; `advance` lets time pass. Faults are planted by attributes.
"""

import math
import re
from collections import deque

import numpy as np

SETTINGS = {1: 255, 10: 1, 13: 0, 20: 1, 21: 1, 22: 1, 23: 0, 25: 500, 27: 1}
SETTINGS |= {110: 6000, 111: 6000, 112: 3000, 130: 300, 131: 200, 132: 80}
GREETING = "\r\nGrbl 1.1h ['$' for help]\r\n"
WORD = re.compile(r"([A-Z])(-?\d*\.?\d+)")
HOLD_S = 0.02
PLANNED = 15


class GrblSimulator:
    def __init__(self, **settings):
        self.settings = SETTINGS | {int(name[1:]): value for name, value in settings.items()}
        self.out, self.rx, self.now = bytearray(), bytearray(), 0.0
        self.overflowed = False
        self.late_ok_s = 0.0
        self.alarm_at_mm = None  # ALARM:1 once a move passes this Z, or error by `refuse`
        self.refuse = deque()  # numbers of errors for the next lines that begin with G
        self.drop_out, self.drop_in = set(), set()  # numbers of bytes that get lost
        self.bytes_out = self.bytes_in = 0
        self.lines, self.holds = [], []
        self.power_on()

    def power_on(self):
        """As after plugging in: position unknown, locked."""
        self.position = np.zeros(3)
        self.state = "Alarm" if self.settings[22] else "Idle"
        self.mode, self.feed = "G0", 0.0
        self._clear()
        self.say(GREETING)

    def _clear(self):
        self.rx.clear()
        self.plan, self.oks = deque(), deque()
        self.waiting = None
        self.hold_left = None
        self.busy_until = 0.0

    def say(self, text):
        for byte in text.encode():
            self.bytes_out += 1
            if self.bytes_out not in self.drop_out:
                self.out.append(byte)

    def give(self):
        data, self.out = bytes(self.out), bytearray()
        return data

    def take(self, data):
        for byte in data:
            self.bytes_in += 1
            if self.bytes_in in self.drop_in:
                continue
            if byte == ord("?"):
                if self.state != "Home":
                    self.say(self.report())
            elif byte == ord("!"):
                self._hold()
            elif byte == ord("~"):
                self._resume()
            elif byte == 0x18:
                self._reset()
            elif len(self.rx) >= 128:
                self.overflowed = True
            else:
                self.rx.append(byte)

    def report(self):
        name = f"Hold:{int(self.hold_left is not None)}" if self.state == "Hold" else self.state
        place = ",".join(f"{value:.3f}" for value in self.position)
        free = f"Bf:{PLANNED - len(self.plan)},{128 - len(self.rx)}"
        return f"<{name}|MPos:{place}|FS:{self.feed:.0f},0|{free}>\r\n"

    def _hold(self):
        self.holds.append(self.now)
        if self.state == "Run":
            self.state, self.hold_left = "Hold", HOLD_S
        elif self.state == "Idle":
            self.state, self.hold_left = "Hold", None

    def _resume(self):
        if self.state == "Hold":
            self.state, self.hold_left = "Run" if self.plan else "Idle", None

    def _reset(self):
        moving = self.state in ("Run", "Home") or (
            self.state == "Hold" and self.hold_left is not None
        )
        if moving:
            self.say(f"ALARM:{6 if self.state == 'Home' else 3}\r\n")
            self.state = "Alarm"
        elif self.state != "Alarm":
            self.state = "Idle"
        self._clear()
        self.mode = "G0"
        self.say(GREETING)
        if self.state == "Alarm":
            self.say("[MSG:'$H'|'$X' to unlock]\r\n")

    def advance(self, seconds):
        """Let time pass: lines are read, moves are done."""
        self.now += seconds
        while self.oks and self.oks[0][0] <= self.now:
            self.say(self.oks.popleft()[1])
        self._read_lines()
        self._move(seconds)
        self._read_lines()

    def _read_lines(self):
        while self.waiting or b"\n" in self.rx:
            if self.waiting is None:
                line, _, rest = bytes(self.rx).partition(b"\n")
                self.rx = bytearray(rest)
                self.waiting = line.decode("ascii", "replace").strip()
            if not self._carry_out(self.waiting):
                return
            self.waiting = None

    def _answer(self, text):
        self.oks.append((self.now + self.late_ok_s, f"{text}\r\n"))
        if not self.late_ok_s:
            self.say(self.oks.pop()[1])

    def _carry_out(self, line):
        """Whether the line is done with; False where it waits."""
        if line.startswith("$"):
            return self._system(line)
        if self.state == "Alarm":
            self._answer("error:9")
        elif line and self.refuse:
            self._answer(f"error:{self.refuse.popleft()}")
        elif "".join(a + b for a, b in WORD.findall(line)) != line:
            self._answer("error:1")
        else:
            return self._words(line, WORD.findall(line))
        return True

    def _system(self, line):
        if line == "$$":
            for number, value in self.settings.items():
                self.say(f"${number}={value:.3f}\r\n" if number > 99 else f"${number}={value}\r\n")
        elif line == "$H":
            return self._home()
        elif line == "$X":
            self.state = "Idle" if self.state == "Alarm" else self.state
        else:
            self._answer("error:3")
            return True
        self._answer("ok")
        return True

    def _home(self):
        if not self.settings[22]:
            self._answer("error:5")
            return True
        if self.state != "Home":
            self.state, self.busy_until = "Home", self.now + 2.0
            self.position[2] = -self.settings[27]
        if self.now < self.busy_until:
            return False
        self.position = -self.settings[27] * np.ones(3)
        self.state = "Idle"
        self._answer("ok")
        return True

    def _words(self, line, words):
        codes = [f"G{float(value):g}" for letter, value in words if letter == "G"]
        if "G4" in codes:
            return self._dwell(float(dict(words)["P"]))
        if len(self.plan) >= PLANNED:
            return False
        target = self.plan[-1][0].copy() if self.plan else self.position.copy()
        for letter, value in words:
            if letter in "XYZ":
                target["XYZ".index(letter)] = float(value)
            elif letter == "F":
                self.feed = float(value)
        self.mode = next((code for code in codes if code in ("G0", "G1")), self.mode)
        if "G53" not in codes or (self.mode == "G1" and not self.feed):
            self._answer("error:22" if "G53" in codes else "error:20")
            return True
        travel = [self.settings[130 + k] for k in range(3)]
        if self.settings[20] and not all(-t <= v <= 0 for v, t in zip(target, travel, strict=True)):
            self.alarm(2)
            return True
        fast = self.mode == "G0"
        self.plan.append((target, min(self.feed, 6000.0) / 60 if not fast else 50.0))
        self.lines.append(line)
        if self.state == "Idle":
            self.state = "Run"
        self._answer("ok")
        return True

    def _dwell(self, seconds):
        if self.plan or self.state == "Hold":
            return False
        if not self.busy_until:
            self.busy_until = self.now + seconds
        if self.now < self.busy_until:
            return False
        self.busy_until = 0.0
        self._answer("ok")
        return True

    def alarm(self, number):
        self.state = "Alarm"
        self._clear()
        self.say(f"ALARM:{number}\r\n[MSG:Reset to continue]\r\n")

    def _move(self, seconds):
        if self.state == "Hold" and self.hold_left is not None:
            seconds, self.hold_left = min(seconds, self.hold_left), self.hold_left - seconds
            if self.hold_left <= 0:
                self.hold_left = None
        elif self.state != "Run":
            return
        while seconds > 0 and self.plan:
            target, speed = self.plan[0]
            away = math.dist(target, self.position)
            if away > speed * seconds:
                self.position += (target - self.position) * speed * seconds / away
                seconds = 0.0
            else:
                self.position, seconds = target.copy(), seconds - away / speed
                self.plan.popleft()
            if self.alarm_at_mm is not None and self.position[2] < self.alarm_at_mm:
                self.alarm_at_mm = None
                self.alarm(1)
                return
        if self.state == "Run" and not self.plan:
            self.state = "Idle"
