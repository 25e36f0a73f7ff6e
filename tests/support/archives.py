"""Archives of numbers for pages, read back as the page reads them."""

import gzip
import json
import struct

import numpy as np


def unpack(packed):
    """Return what `pack` was given, arrays with a step as floats, NaN where there is no number."""
    raw = gzip.decompress(packed)
    (size,) = struct.unpack_from("<I", raw)
    content = json.loads(raw[4 : 4 + size])
    arrays = {}
    for name, entry in content.pop("arrays").items():
        kind, count = np.dtype(f"<{entry['kind']}"), int(np.prod(entry["shape"]))
        data = np.frombuffer(raw, kind, count, 4 + size + entry["at"]).reshape(entry["shape"])
        if entry["step"] != 1.0 or entry["gaps"]:
            none = entry["gaps"] & (data == np.iinfo(kind).max)
            data = np.where(none, np.nan, data * entry["step"])
        arrays[name] = data
    return content, arrays
