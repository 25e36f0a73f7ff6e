"""The part of MicroPython's `espnow` that the firmware uses; packets lie in air.txt, a line each.

Where air.txt lies there at the start, its packets arrive (`MAC packet`, in hexadecimal), and the program ends
after the last one; else packets that are sent are written there (`to packet`).
"""

import os

_arriving = "air.txt" in os.listdir()
_OBJECT = b"\x02\x00\x00\x00\x00\x01"


class ESPNow:
    def __init__(self):
        self.peers, self.on = set(), False
        self.air = open("air.txt", "r" if _arriving else "w")  # noqa: SIM115

    def active(self, on):
        self.on = on

    def add_peer(self, mac):
        if mac in self.peers:
            raise OSError(-12395, "ESP_ERR_ESPNOW_EXIST")
        self.peers.add(mac)

    def del_peer(self, mac):
        self.peers.remove(mac)

    def send(self, mac, packet, sync=True):
        assert self.on
        assert 0 < len(packet) <= 250
        if mac not in self.peers:
            raise OSError(-12393, "ESP_ERR_ESPNOW_NOT_FOUND")
        if not _arriving:
            self.air.write(f"{_OBJECT.hex()} {packet.hex()}\n")
            self.air.flush()
        return True

    def recv(self, timeout_ms):
        if not _arriving:
            return None, None
        line = self.air.readline()
        if not line:
            raise SystemExit
        mac, packet = line.split()
        return bytes.fromhex(mac), bytes.fromhex(packet)
