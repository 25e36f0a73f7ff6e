"""A load over time, and an HX711 as Avia Semiconductor's data sheet describes it."""

_FULL = 1 << 23


class LoadCell:
    """`pins`: data and clock of an HX711, the input of a voltage, or none; `points`: ms and mV/V or mV."""

    def __init__(self, pins, points, sps, now_ms, faulty):
        self.pins, self.points, self.period_ms = tuple(pins), points, 1000 / sps
        self.now_ms, self.faulty = now_ms, faulty
        self.next_ms, self.ready, self.high = 4 * self.period_ms, False, False
        self.pulses, self.last_pulses, self.bit, self.result = 0, 25, 1, 0

    def at(self, ms):
        before = self.points[0]
        for after in self.points:
            if after[0] > ms:
                share = (ms - before[0]) / (after[0] - before[0]) if after[0] > before[0] else 0
                return before[1] + share * (after[1] - before[1])
            before = after
        return before[1]

    def run(self):
        now = self.now_ms()
        while now >= self.next_ms:
            if self.pulses == 0 or self.pulses >= 25:
                gain = {25: 128, 27: 64}.get(self.last_pulses, 0)
                steps = round(1e-3 * self.at(self.next_ms) * gain * (1 << 24))
                self.result = max(-_FULL, min(_FULL - 1, steps))
                self.ready, self.pulses = True, 0
            self.next_ms += self.period_ms

    def clock(self, high):
        self.run()
        rising, self.high = bool(high) and not self.high, bool(high)
        if not rising or not (self.ready or self.pulses):
            return
        self.pulses += 1
        self.last_pulses, self.ready = self.pulses, False
        self.bit = self.result >> (24 - self.pulses) & 1 if self.pulses <= 24 else 1

    def level(self):
        """Of the data line; without a chip the pull-up decides."""
        self.run()
        if self.faulty("gone", -2):
            return 1
        if self.faulty("shorted", -2) or self.ready:
            return 0
        return 1 if self.pulses == 0 or self.pulses > 24 else self.bit
