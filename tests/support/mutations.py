"""Files damaged at random: bytes, text and values, as accidents and as unkind hands do it."""

import copy

import numpy as np

NUMBERS = (
    *("0", "-0.0", "-1", "1e-9", "1e308", "-1e308", "nan", "inf", "-inf", "1e400", "0.5"),
    *("9" * 30, "7" * 5000, "1_0", "0x10", "１２", "true", "1e9"),
)
TEXTS = (
    *("", '"', "'", '"""', "[", "]", "[[", "{", "}", "=", "\\u0000", "\x00", "\ufeff", "\r", "\n"),
    *(",", ";", "#", "$", "*", "é", "𝟙", "../x", "/dev/full", "x" * 5000, "[" * 300, "a.b.c.d"),
)
VALUES = (
    *(0, -1, 1, 3, 1e-9, 1e-3, 0.1, 10.0, 1e3, 1e9, 1e308, float("nan"), float("inf"), 10**30),
    *(True, "", "x", "\x00", "../x", "/dev/full", "x" * 300, [], [[]], [1], [1.0, 2.0], {}),
    *([[0.0, 0.0]] * 2, [float("nan")] * 3, {"x": 1}, [[]] * 3),
)


def damaged_bytes(content: bytes, rng: np.random.Generator) -> bytes:
    """One to four bits flipped, cuts, zeros, repetitions or insertions anywhere."""
    data = bytearray(content)
    for _ in range(rng.integers(1, 5)):
        if not data:
            break
        start = int(rng.integers(len(data)))
        stop = min(len(data), start + int(rng.choice([1, 4, 40, 400, 4000])))
        match rng.integers(6):
            case 0:
                data[start] ^= 1 << int(rng.integers(8))
            case 1:
                del data[start:stop]
            case 2:
                data[start:stop] = bytes(stop - start)
            case 3:
                data[start:start] = data[start:stop]
            case 4:
                data[start:stop] = rng.bytes(stop - start)
            case _:
                del data[start:]
    return bytes(data)


def damaged_text(content: str, rng: np.random.Generator) -> str:
    """Numbers, lines and separators changed, exchanged, repeated or gone."""
    lines = content.splitlines(keepends=True) or [""]
    for _ in range(rng.integers(1, 5)):
        k = int(rng.integers(len(lines)))
        words = lines[k].replace("=", " = ").replace(",", " , ").split(" ")
        w = int(rng.integers(len(words)))
        match rng.integers(6):
            case 0:
                words[w] = str(rng.choice(NUMBERS))
                lines[k] = "".join(words)
            case 1:
                words[w] += str(rng.choice(TEXTS))
                lines[k] = "".join(words)
            case 2:
                words[w] = ""
                lines[k] = "".join(words)
            case 3:
                lines.insert(k, lines[int(rng.integers(len(lines)))])
            case 4:
                other = int(rng.integers(len(lines)))
                lines[k], lines[other] = lines[other], lines[k]
            case _ if len(lines) > 1:
                del lines[k]
    return "".join(lines)


def damaged_tables(content: dict, rng: np.random.Generator) -> dict:
    """One to three values of nested tables replaced, scaled, removed, or moved to another key."""
    changed = copy.deepcopy(content)
    for _ in range(rng.integers(1, 4)):
        table, key = _place(changed, rng)
        if key is None:
            continue
        value = table[key]
        match rng.integers(5):
            case 0:
                table[key] = copy.deepcopy(VALUES[rng.integers(len(VALUES))])
            case 1 if isinstance(value, int | float) and not isinstance(value, bool):
                table[key] = value * float(rng.choice([-1, 0.0, 0.01, 0.3, 3.0, 100.0, 1e9]))
            case 2:
                del table[key]
            case 3:
                table[f"{key}{rng.choice(['x', '', ' ', '.'])}"] = value
            case _ if isinstance(value, list) and value:
                table[key] = value[: rng.integers(len(value))] * int(rng.integers(1, 4))
    return changed


def _place(content: dict, rng: np.random.Generator):
    """A table of the content and one of its keys; no key if it is empty."""
    table = content
    while table:
        key = list(table)[rng.integers(len(table))]
        if isinstance(table[key], dict) and table[key] and rng.random() < 0.9:
            table = table[key]
            continue
        return table, key
    return table, None
