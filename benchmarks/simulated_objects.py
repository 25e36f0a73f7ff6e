"""Objects × steps a second of `instobj.sim.HallObject`: one object after another, and all in one call.

    python benchmarks/simulated_objects.py [CONTACTS.nc]

Each object has as many contacts, anywhere on its faces. Without a file the object is one of analytic
presses, with the paper's cube's channels. Rounds take turns; the ratio is the median over them.
On a processor one thread works, and seconds are those that the process had it.
"""

import sys
import time
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

import numpy as np
import torch

from design.layout.body import face_frames
from estimator.inversion.storage import save_inversion
from instobj.sim import HallObject

OBJECTS, CONTACTS, ROUNDS = (1, 100, 1000), (1, 2, 4), 5
LOOPED = 200
"""Steps of the loop that are timed in a round."""
LEAST_S = 0.5
"""Time that batched steps are repeated for in a round."""


def main(path: Path) -> None:
    """Print one line for each number of objects and contacts."""
    devices = ["cpu", *(["cuda"] if torch.cuda.is_available() else [])]
    torch.set_num_threads(1)
    for device in devices:
        name = torch.cuda.get_device_name() if device == "cuda" else "one core"
        print(f"{name}: objects, contacts, loop steps/s, batched steps/s, ratio")
        for contacts in CONTACTS:
            for objects in OBJECTS:
                rounds = [measured(path, device, objects, contacts) for _ in range(ROUNDS)]
                loop, batch = (median(column) for column in zip(*rounds, strict=True))
                ratio = median(batched / looped for looped, batched in rounds)
                print(f"{objects:5d} {contacts:2d} {loop:10.0f} {batch:12.0f} {ratio:8.1f}")


def measured(path: Path, device: str, objects: int, contacts: int) -> tuple[float, float]:
    """Return objects × steps a second of a loop over objects, and of one call for all."""
    cube = HallObject(path)
    rng = np.random.default_rng(objects)
    points, force = frames(cube, rng, objects, contacts)
    turn = np.broadcast_to(np.eye(3), (objects, 3, 3)).copy()
    clock = time.perf_counter if device == "cuda" else time.process_time
    start = clock()
    for step in range(LOOPED):
        number = step % objects
        cube.read(points[number], force[number], turn[number])
    looped = LOOPED / (clock() - start)
    tensors = [torch.as_tensor(given, device=device) for given in (points, force, turn)]
    cube.read(*tensors)
    steps, start = 0, clock()
    while clock() - start < LEAST_S:
        cube.read(*tensors)
        if device == "cuda":
            torch.cuda.synchronize()
        steps += 1
    return looped, steps * objects / (clock() - start)


def frames(
    cube: HallObject, rng: np.random.Generator, objects: int, contacts: int
) -> tuple[np.ndarray, np.ndarray]:
    """Return contact points (object, contact, 3) in mm and forces (object, contact) in N."""
    faces = face_frames(cube.spec)
    points = np.empty((objects, contacts, 3))
    for index in np.ndindex(objects, contacts):
        frame = faces[rng.integers(len(faces))]
        place = rng.uniform(-0.5, 0.5, 2) * frame.half_extents_mm
        points[index] = frame.to_object(np.append(place, 0.0))
    return points, rng.uniform(1.0, 6.0, (objects, contacts))


if __name__ == "__main__":
    if len(sys.argv) > 1:
        main(Path(sys.argv[1]))
    else:
        from tests.support.mechanics.inverted import inverted

        with TemporaryDirectory() as folder:
            save_inversion(inverted(), Path(folder) / "contacts.nc")
            main(Path(folder) / "contacts.nc")
