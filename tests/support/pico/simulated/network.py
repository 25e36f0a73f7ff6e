"""The part of MicroPython's `network` that the firmware uses."""

STA_IF = 0


class WLAN:
    def __init__(self, interface):
        assert interface == STA_IF

    def active(self, on):
        assert on
