"""I2C buses: transfers that end in time, and recovery of a bus that hangs."""

import time
from errno import ETIMEDOUT  # ESP32s have another number than others

from machine import I2C, Pin

TIMEOUT_US = 2500
CLOCKS_TO_FREE = 9


class Bus:
    """One controller; `stuck` is called where the data line stays low after its recovery."""

    errors = 0
    recoveries = 0

    def __init__(self, number, sda, scl, hertz, stuck):
        self.number, self.sda, self.scl, self.hertz, self.stuck = number, sda, scl, hertz, stuck
        self.open()

    def open(self):
        self.i2c = I2C(
            self.number, sda=Pin(self.sda), scl=Pin(self.scl), freq=self.hertz, timeout=TIMEOUT_US
        )

    def transfer(self, address, out, into=None):
        """Write, then read after a repeated start; False where a byte was not acknowledged."""
        try:
            self.i2c.writeto(address, out, into is None)
            if into is not None:
                self.i2c.readfrom_into(address, into)
            return True
        except OSError as error:
            Bus.errors += 1
            if error.args[0] == ETIMEDOUT:
                self.recover()
            return False

    def recover(self):
        """Clock a chip that holds the data line to the end of its byte, then stop (UM10204, 3.1.16)."""
        sda = Pin(self.sda, Pin.OPEN_DRAIN, value=1)
        scl = Pin(self.scl, Pin.OPEN_DRAIN, value=1)
        for _ in range(CLOCKS_TO_FREE):
            if sda.value():
                break
            scl.value(0)
            time.sleep_us(5)
            scl.value(1)
            time.sleep_us(5)
        low = not sda.value()
        sda.value(0)
        time.sleep_us(5)
        sda.value(1)
        self.open()
        Bus.recoveries += 1
        self.stuck(low)
