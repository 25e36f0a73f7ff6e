"""HDF5 files that reach outside of themselves, or for more than they hold; each once a danger.

`FOREIGN` tells how each is made and a word of the refusal. `sealed` puts a checksum behind a file,
as anybody can.
"""

import hashlib
import os

import h5py
import numpy as np


def sealed(content):
    """A file's bytes with their SHA-256 behind them."""
    return content + b"instobj sha256: " + hashlib.sha256(content).digest()


def external_storage(file, beside):
    """A file of the system as an array."""
    place = [(b"/etc/passwd", 0, 64)]
    file.create_dataset("force_n", (64,), "u1", external=place)


def external_pipe(file, beside):
    """An array whose reading never ends."""
    os.mkfifo(beside / "pipe")
    file.create_dataset("force_n", (8,), "f8", external=[(bytes(beside / "pipe"), 0, 64)])


def external_link(file, beside):
    """An array of another file."""
    with h5py.File(beside / "other.h5", "w") as other:
        other["force_n"] = np.arange(3.0)
    file["force_n"] = h5py.ExternalLink(str(beside / "other.h5"), "force_n")


def external_link_in_a_group(file, beside):
    """The same, deeper."""
    file.create_group("deeper/still")["force_n"] = h5py.ExternalLink("other.h5", "force_n")


def soft_link(file, beside):
    """A name for another place."""
    file["there"] = np.arange(3.0)
    file["force_n"] = h5py.SoftLink("/there")


def virtual_array(file, beside):
    """An array made of another file's."""
    layout = h5py.VirtualLayout((3,), "f8")
    layout[:] = h5py.VirtualSource(str(beside / "other.h5"), "force_n", (3,))
    file.create_virtual_dataset("force_n", layout)


def other_filter(file, beside):
    """A filter that HDF5 looks for among its plugins."""
    how = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
    how.set_chunk((4,))
    how.set_filter(32001, h5py.h5z.FLAG_OPTIONAL, (1,))  # Blosc's number
    space = h5py.h5s.create_simple((4,))
    h5py.h5d.create(file.id, b"force_n", h5py.h5t.NATIVE_DOUBLE, space, how)


def references(file, beside):
    """An array of references."""
    file["there"] = np.arange(3.0)
    file.create_dataset("force_n", data=np.array([file["there"].ref], h5py.ref_dtype))


def reference_of_the_whole(file, beside):
    """An attribute that is one."""
    file["force_n"] = np.arange(3.0)
    file.attrs["there"] = file["force_n"].ref


def record(file, beside):
    """An array of records."""
    file["force_n"] = np.zeros(2, [("x", "f8"), ("y", "f8")])


def declared_without_end(file, beside):
    """A terabyte of zeros in a kilobyte."""
    file.create_dataset("force_n", (2**37,), "f8", chunks=(2**16,), compression="gzip")


FOREIGN = {
    external_storage: "stored in another file",
    external_link: "is a link",
    external_link_in_a_group: "/deeper/still/force_n is a link",
    soft_link: "is a link",
    virtual_array: "virtual array",
    other_filter: "filter 32001",
    references: "neither numbers nor texts",
    reference_of_the_whole: "/@there holds neither",
    record: "neither numbers nor texts",
    declared_without_end: "more than 4 GiB",
}
if hasattr(os, "mkfifo"):
    FOREIGN[external_pipe] = "stored in another file"
