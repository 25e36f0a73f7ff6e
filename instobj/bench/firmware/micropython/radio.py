"""Lines of text over ESP-NOW, to the board that runs bridge.py."""

import espnow
import network

PACKET = 250  # bytes, the most that ESP-NOW carries
EVERYONE = b"\xff" * 6


class Link:
    """Packets go to everyone until a bridge speaks, then to it alone, which acknowledges each."""

    def __init__(self):
        network.WLAN(network.STA_IF).active(True)
        self.radio = espnow.ESPNow()
        self.radio.active(True)
        self.radio.add_peer(EVERYONE)
        self.bridge = None

    def meet(self, mac):
        if mac != self.bridge:
            self.forget()
            self.radio.add_peer(mac)
            self.bridge = mac

    def forget(self):
        if self.bridge is not None:
            self.radio.del_peer(self.bridge)
            self.bridge = None

    def send(self, packet):
        try:
            return self.radio.send(self.bridge or EVERYONE, packet)
        except OSError:
            return False

    def write(self, text):
        """A packet that is lost damages its line, which the check sum of the line says."""
        data = text.encode()
        for first in range(0, len(data), PACKET):
            if not self.send(data[first : first + PACKET]):
                self.forget()

    def asked(self):
        """Return whether a ? came."""
        came = False
        while True:
            mac, packet = self.radio.recv(0)
            if mac is None:
                return came
            self.meet(bytes(mac))
            came = b"?" in packet or came
