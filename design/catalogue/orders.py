"""Order numbers and guide prices of parts that are bought: maker's number, pack, price range, date.

Prices are estimates of `PRICED`, not offers: what one piece (or the smallest pack) costs at shops in Europe
without shipping, from experience. No distributor was asked; they rank plans and size a budget. `seen`
says where a number was found, and when that was looked up; numbers without it are from memory. Check
number, price and stock before you order.
"""

from __future__ import annotations

from dataclasses import dataclass

PRICED = "2025-11"
_PROJECTS = "parts lists of public projects; looked up 2026-11"
"""Not the maker's own words, but of people who ordered by that number."""


@dataclass(frozen=True)
class Order:
    """A part as it is ordered: number of its maker, pieces in a pack, prices of a pack (EUR)."""

    title: str
    maker: str
    number: str
    price_eur: tuple[float, float]
    pieces: int = 1
    note: str = ""
    seen: str = ""

    @property
    def middle_eur(self) -> float:
        """Middle of the price range, a piece."""
        return sum(self.price_eur) / 2 / self.pieces

    def packs(self, pieces: int) -> int:
        """Number of packs that hold `pieces`."""
        return -(-pieces // self.pieces)


def _tmag(letter: str, version: int) -> Order:
    name = f"TMAG5273{letter}{version}"
    return Order(
        f"Hall sensor {name}", "Texas Instruments", f"{name}QDBVR", (0.9, 2.2),
        note="QDBVT is the small reel",
        seen="TMAG5273A2QDBVT of Texas Instruments SLYS045, by its scheme; looked up 2026-11",
    )  # fmt: skip


def _tle(address: int) -> Order:
    return Order(
        f"Hall sensor TLE493D-W2B6 A{address}", "Infineon", f"TLE493DW2B6A{address}HTSA1", (1.2, 3.0),
        seen="TLE493DW2B6A1HTSA1 of Infineon's forum, by its scheme; looked up 2026-11",
    )  # fmt: skip


HX711, LOAD_CELL, VERNIER, BTA_ADAPTER = "HX711", "load cell", "force sensor", "BTA adapter"
MUX, SHIFTER, BUFFER, RESISTOR, WIRE, STRIP, SCREW, GLUE, PRIMER, ADHESIVE, RELEASE = (
    "multiplexer board",
    "level shifter",
    "supply buffer",
    "pull-up resistor",
    "wire",
    "stripboard",
    "M3 x 16",
    "instant adhesive",
    "primer",
    "silicone adhesive",
    "release agent",
)
SILICONE_KIT_G = 900.0
"""Mass of both parts together, in the kits below."""

ORDERS = {
    **{f"TMAG5273{letter}{v}": _tmag(letter, v) for letter in "ABCD" for v in (1, 2)},
    "MLX90393": Order(
        "Hall sensor MLX90393", "Melexis", "MLX90393SLW-ABA-011-RE", (2.0, 4.5),
        seen="Melexis' data sheet at a parts index; looked up 2026-11",
    ),
    "MLX90393-0x18": Order(
        "MLX90393 on a board, at 0x18 to 0x1B by its pins", "Adafruit", "4022", (12.0, 18.0),
        note="older ones answer at 0x0C: then sensors.part is MLX90393",
    ),
    **{f"TLE493DW2B6A{k}": _tle(k) for k in range(4)},
    "100 nF": Order(
        "capacitor 100 nF, 0402", "Murata", "GRM155R71C104KA88D", (0.02, 0.1), seen=_PROJECTS
    ),
    "mega2560": Order("Arduino Mega 2560 Rev3", "Arduino", "A000067", (38.0, 50.0), seen=_PROJECTS),
    "pico": Order("Raspberry Pi Pico H", "Raspberry Pi", "SC0917", (4.5, 7.0), seen=_PROJECTS),
    MUX: Order(
        "TCA9548A on a board", "Adafruit", "2717", (6.0, 9.0),
        seen="Adafruit's manual of 2717; looked up 2026-11",
    ),
    SHIFTER: Order(
        "level shifter, 4 channels, BSS138", "Adafruit", "757", (3.0, 5.0), seen=_PROJECTS
    ),
    BUFFER: Order(
        "hex buffer CD74HC4050E, DIP-16", "Texas Instruments", "CD74HC4050E", (0.5, 1.2), seen=_PROJECTS
    ),
    RESISTOR: Order("resistor, 1 %, 0.6 W, axial", "Vishay", "MRS25 series", (0.05, 0.2)),
    HX711: Order(
        "HX711 on a board", "SparkFun", "SEN-13879", (9.0, 14.0),
        note="80 readings per second: cut the jumper RATE; the older SEN-13230 is retired",
        seen=_PROJECTS,
    ),
    LOAD_CELL: Order(
        "load cell 5 kg, 1 mV/V", "HT Sensor Technology", "TAL220B", (8.0, 14.0), seen=_PROJECTS
    ),
    VERNIER: Order(
        "Dual-Range Force Sensor", "Vernier", "DFS-BTA", (110.0, 170.0), note="in its ±50 N range",
        seen=_PROJECTS,
    ),
    BTA_ADAPTER: Order(
        "analogue adapter BTA to pins", "Vernier", "BTA-ELV", (10.0, 20.0),
        seen="Vernier's page on connectors, til/818; looked up 2026-11",
    ),
    WIRE: Order("stranded wire AWG 30, PTFE, 10 m", "various", "AWG 30 (7/38) PTFE", (4.0, 12.0)),
    STRIP: Order("stripboard, 100 × 50 mm", "various", "RM 2.54", (1.5, 4.0)),
    "Platsil Gel-10": Order("PlatSil Gel-10, 0.91 kg kit", "Polytek", "PlatSil Gel-10", (35.0, 60.0)),
    "Ecoflex 00-30": Order("Ecoflex 00-30, 0.9 kg kit", "Smooth-On", "Ecoflex 00-30", (35.0, 55.0)),
    "Dragon Skin 10": Order("Dragon Skin 10, 0.9 kg kit", "Smooth-On", "Dragon Skin 10", (35.0, 55.0)),
    "Dragon Skin 20": Order("Dragon Skin 20, 0.9 kg kit", "Smooth-On", "Dragon Skin 20", (35.0, 55.0)),
    "Dragon Skin 30": Order("Dragon Skin 30, 0.9 kg kit", "Smooth-On", "Dragon Skin 30", (35.0, 55.0)),
    "magnet": Order("magnet, by size and grade", "various", "see the specification", (0.1, 0.5)),
    "sensor board": Order("printed circuit board of a sensor", "any board house", "own drawing", (0.5, 3.0)),
    "TPU 85A": Order("TPU filament 85A 1.75 mm, 0.5 kg", "NinjaTek", "NinjaFlex 85A", (40.0, 65.0)),
    "fdm": Order("PETG filament 1.75 mm, 1 kg", "various", "PETG 1.75 mm", (15.0, 28.0)),
    "resin": Order("resin for the printer, 1 kg", "various", "as the printer's maker says", (25.0, 60.0)),
    "sls": Order("PA12 prints of a service", "various", "the parts' 3MF files", (40.0, 150.0)),
    "USB mega2560": Order("USB cable A to B", "various", "USB 2.0 A–B", (3.0, 7.0)),
    "USB pico": Order("USB cable A to micro-B", "various", "USB 2.0 A–micro-B", (3.0, 7.0)),
    SCREW: Order(
        "M3 × 16 screw with nut, 20 pieces", "various", "ISO 4762 / ISO 4032", (2.0, 5.0),
        20, "flanges of the mould's halves",
    ),
    GLUE: Order(
        "instant adhesive, 20 g", "Henkel", "Loctite 401", (9.0, 20.0),
        note="boards or magnets into the core",
    ),
    PRIMER: Order(
        "primer for addition-cure silicone, 310 ml", "Dow", "DOWSIL 92-023", (60.0, 120.0),
        note="on the core; or what the silicone's maker names",
    ),
    ADHESIVE: Order(
        "silicone adhesive, 85 g", "Smooth-On", "Sil-Poxy", (22.0, 40.0),
        note="between core and shell",
    ),
    RELEASE: Order(
        "release agent, 400 ml", "Mann", "Ease Release 200", (18.0, 35.0),
        note="on the mould, never on the core",
    ),
}  # fmt: skip
"""Parts that many makers sell alike have the standard or the trade name in place of a number."""
