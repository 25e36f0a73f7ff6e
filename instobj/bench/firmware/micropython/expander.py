"""MCP23017, Microchip DS20001952: sixteen outputs that power sensors."""

DIRECTIONS, LATCHES = 0x00, 0x14


class Expander:
    def __init__(self, bus, address):
        self.bus, self.address, self.latches = bus, address, 0


class Output:
    """One output of an expander, used as a pin."""

    def __init__(self, expander, bit):
        self.expander, self.bit = expander, bit

    def value(self, on):
        """Switch it; all settings are written, as the expander may have lost them."""
        part = self.expander
        part.latches = part.latches & ~(1 << self.bit) | (1 << self.bit if on else 0)
        low, high = part.latches & 0xFF, part.latches >> 8
        part.bus.transfer(part.address, bytes((LATCHES, low, high)))
        part.bus.transfer(part.address, bytes((DIRECTIONS, 0, 0)))
