"""Sensors of the object: started, read, and started again where one was lost."""

import time

import plan
from bus import Bus
from chip import RESULTS, move, read, setup, undervoltage
from expander import Expander, Output
from machine import Pin

ATTEMPTS = 2


class Sensors:
    def __init__(self):
        self.supply_errors = 0
        self.alive = [False] * len(plan.PLACES)
        self.expanders = {}
        self.reset = None if plan.RESET is None else Pin(plan.RESET, Pin.OUT, value=1)
        self.open_route = {}
        self.buses = [Bus(*bus, plan.HERTZ, self.recover) for bus in plan.BUSES]
        self.pins = [self.supply_of(place) for place in plan.PLACES]
        self.buffer = bytearray(RESULTS)
        self.reset_parts()
        time.sleep_ms(20)  # supplies fall, so that every chip has its factory address again
        for number in range(len(self.alive)):
            self.revive(number)
        time.sleep_ms(plan.CONVERSION_MS)

    def supply_of(self, place):
        """The pin that powers a sensor, of the board or of an expander."""
        bus, supply = place[0], place[5]
        if supply is None:
            return None
        if isinstance(supply, int):
            return Pin(supply, Pin.OUT, value=0)
        if (bus, supply[0]) not in self.expanders:
            self.expanders[bus, supply[0]] = Expander(self.buses[bus], supply[0])
        return Output(self.expanders[bus, supply[0]], supply[1])

    def reset_parts(self):
        """Close all channels of multiplexers, and cut off all outputs of expanders."""
        self.open_route = {}
        for expander in self.expanders.values():
            expander.latches = 0
        if self.reset is not None:
            self.reset.value(0)
            time.sleep_us(2)
            self.reset.value(1)

    def recover(self, stuck):
        if stuck or not self.expanders:
            self.reset_parts()
        for number, pin in enumerate(self.pins):
            if stuck and pin is not None and not self.expanders:
                self.lose(number)
            elif stuck and pin is not None:  # cut off by the reset, without the bus
                self.alive[number] = False

    def reach(self, place):
        """Open the channel of the sensor's multiplexer, and close the one open before."""
        number, multiplexer, channel = place[0], place[3], place[4]
        if multiplexer is None:
            return True
        bus, last_route = self.buses[number], self.open_route.get(number)
        if last_route == (multiplexer, channel):
            return True
        if (
            last_route is not None
            and last_route[0] != multiplexer
            and not bus.transfer(last_route[0], b"\x00")
        ):
            return False
        self.open_route.pop(number, None)
        if not bus.transfer(multiplexer, bytes((1 << channel,))):
            return False
        self.open_route[number] = (multiplexer, channel)
        return True

    def power(self, number, on):
        if self.pins[number] is not None:
            self.pins[number].value(on)

    def lose(self, number):
        """A chip that is not read any more keeps neither supply nor its factory address."""
        self.alive[number] = False
        self.power(number, 0)

    def revive(self, number):
        place = plan.PLACES[number]
        bus, factory, address = self.buses[place[0]], place[1], place[2]
        self.power(number, 1)
        time.sleep_ms(plan.POWER_UP_MS)
        self.alive[number] = (
            self.reach(place)
            and (factory == address or move(bus, factory, address))
            and setup(bus, address)
        )
        if not self.alive[number]:
            self.power(number, 0)

    def read(self, number):
        """Temperature, X, Y, Z in counts; None where the sensor is silent."""
        if not self.alive[number]:
            return None
        place = plan.PLACES[number]
        for _ in range(ATTEMPTS):
            values = self.reach(place) and read(self.buses[place[0]], place[2], self.buffer)
            if values:
                return values
        self.lose(number)
        return None

    def watch(self):
        """Once a second: undervoltage of the sensors that answer, and another start of the others."""
        revived = False
        for number, place in enumerate(plan.PLACES):
            if not self.alive[number]:
                self.revive(number)
                revived = True
            elif self.reach(place) and undervoltage(self.buses[place[0]], place[2]):
                self.supply_errors += 1
        if revived:
            time.sleep_ms(plan.CONVERSION_MS)
