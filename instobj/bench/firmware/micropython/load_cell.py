"""The load cell: an HX711 or a voltage, read whenever the program passes by; its lines wait for time."""

import time

import plan
from machine import ADC, Pin, disable_irq, enable_irq

ROOM = 64
BITS = 24
MEAN_MS = 25
CONVERSIONS = 8  # at every passing
SKIPPED_MS = 100


def newtons(value):
    """Text of the force; LOAD_SCALE is 0.1 mN per step with 24 bits behind its point."""
    tenths = ((value - plan.LOAD_ZERO) * plan.LOAD_SCALE + (1 << 23)) >> 24
    size = min(abs(tenths), 9_999_999)
    return "%s%d.%04d" % ("-" if tenths < 0 else "", size // 10_000, size % 10_000)


class NoCell:
    def poll(self):
        pass

    def take(self):
        return ()


class Cell:
    """Readings (ms, value) that wait; where nobody takes them, the oldest go."""

    def __init__(self):
        self.waiting = []

    def keep(self, ms, value):
        if len(self.waiting) == ROOM:
            self.waiting.pop(0)
        self.waiting.append((ms, value))

    def take(self):
        numbers, self.waiting = self.waiting, []
        return numbers


class Hx711(Cell):
    def __init__(self, data, clock):
        super().__init__()
        self.data = Pin(data, Pin.IN, Pin.PULL_UP)  # without a chip: never ready
        self.clock = Pin(clock, Pin.OUT, value=0)
        self.skipped_ms = None

    def pulse(self):
        """A bit; 60 µs of a high clock would power the chip down."""
        state = disable_irq()
        self.clock.value(1)
        self.clock.value(0)
        enable_irq(state)
        return self.data.value()

    def poll(self):
        if self.data.value():
            return
        now = time.ticks_ms()
        if self.skipped_ms is not None and time.ticks_diff(now, self.skipped_ms) < SKIPPED_MS:
            return
        value = 0
        for _ in range(BITS):
            value = value << 1 | self.pulse()
        # gain 128 of the next conversion; where the line stays low, that is for another reason
        self.skipped_ms = None if self.pulse() else now
        if self.skipped_ms is None:
            self.keep(now, value - (1 << BITS) if value >> (BITS - 1) else value)


class Voltage(Cell):
    """Means over 25 ms, in 1/256 of a step."""

    def __init__(self, pin):
        super().__init__()
        self.adc = ADC(Pin(pin))
        self.start_ms, self.total, self.count = time.ticks_ms(), 0, 0

    def poll(self):
        now = time.ticks_ms()
        if time.ticks_diff(now, self.start_ms) >= MEAN_MS:
            if self.count:
                middle = time.ticks_add(self.start_ms, time.ticks_diff(now, self.start_ms) // 2)
                self.keep(middle, 256 * self.total // self.count)
            self.start_ms, self.total, self.count = now, 0, 0
        for _ in range(CONVERSIONS):
            self.total += self.adc.read_u16()
        self.count += CONVERSIONS


def load_cell():
    """Return the load cell of the plan."""
    kinds = {None: NoCell, "hx711": Hx711, "analog": Voltage}
    return kinds[plan.LOAD_CELL](*plan.LOAD_PINS)
