"""`instobj assess` without --model: slip in raw channels of CSV and `.pt` files, tensors only."""

import json
import pickle
import subprocess
import sys

import numpy as np
import pytest
import torch

from tests.support.cli import run
from tests.support.recordings.pulled import FRAMES, RATE_HZ, pulled

NAMES = [f"F1-{axis}{chip}" for chip in range(1, 6) for axis in "XYZ"]


@pytest.fixture(scope="module")
def bench(tmp_path_factory):
    folder = tmp_path_factory.mktemp("raw")
    (folder / "pulls").mkdir()
    for name, seed, slips in (("held", 1, False), ("slid", 2, True)):
        values = pulled(seed, slips).values
        torch.save(torch.tensor(values, dtype=torch.float32), folder / "pulls" / f"{name}.pt")
        # a CSV holds whole counts, 0.1 µT each
        rows = np.column_stack([np.arange(FRAMES) / RATE_HZ, np.round(values * 10)])
        header = ",".join(["time_s", *NAMES])
        np.savetxt(folder / f"{name}.csv", rows, "%g", ",", header=header, comments="")
    return folder


def test_tensors_are_judged_without_a_specification(bench):
    done = run("assess", "pulls", "--json", cwd=bench)
    assert done.returncode == 0, done.stderr
    document = json.loads(done.stdout)
    held, slid = document["tables"]["slip"]
    assert (held["recording"], held["slipped"], held["onset frame"]) == ("held.pt", "no", None)
    assert (slid["recording"], slid["slipped"]) == ("slid.pt", "yes")
    assert slid["onset frame"] / RATE_HZ == pytest.approx(pulled(2, True).onset_s, abs=0.1)
    assert document["texts"][0].startswith("1 of 2 holds slipped")
    assert (bench / "runs" / "pulls" / "assess" / "slips.csv").read_text().count("\n") == 3


def test_a_csv_gives_the_same_with_its_own_clock(bench):
    done = run("assess", "held.csv", "slid.csv", "--json", cwd=bench)
    held, slid = json.loads(done.stdout)["tables"]["slip"]
    assert (held["slipped"], slid["slipped"]) == ("no", "yes")
    assert slid["onset s"] == pytest.approx(pulled(2, True).onset_s, abs=0.1)


def test_without_torch_a_tensor_is_refused_and_a_csv_is_read(bench):
    start = """
import sys
class WithoutTorch:
    def find_spec(self, name, *_):
        if name.partition(".")[0] == "torch":
            raise ModuleNotFoundError("No module named 'torch'", name="torch")
sys.meta_path.insert(0, WithoutTorch())
from instobj.cli.app import main
main()
"""
    for name, code, said in (
        ("pulls/slid.pt", 2, "needs torch"),
        ("slid.csv", 0, "1 of 1 holds slipped"),
    ):
        done = subprocess.run(
            [sys.executable, "-c", start, "assess", name],
            cwd=bench, capture_output=True, text=True, encoding="utf-8", check=False,
        )  # fmt: skip
        assert done.returncode == code, done.stderr
        assert said in done.stderr + done.stdout
        assert "Traceback" not in done.stderr


class Thief:
    """Writes a file when it is unpickled."""

    def __reduce__(self):
        return (open, ("stolen", "w"))


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["code.pt"], "cannot be read as tensors alone"),
        (["code_zip.pt"], "cannot be read as tensors alone"),
        (["text.pt"], "cannot be read as tensors alone"),
        (["list.pt"], "must hold one tensor"),
        (["flat.pt"], "shape (5,)"),
        (["nowhere.pt"], "no recording at nowhere.pt"),
        (["rest.pt"], "no contact shows in rest.pt"),
        (["slid.csv", "--limit", "apple"], "Give --model FOLDER"),
        (["slid.csv", "--protocol", "pinch"], "Give --model FOLDER"),
        (["slid.csv", "--out", "contacts.mcap"], "Give --model FOLDER"),
    ],
)
def test_what_cannot_be_read_is_one_error_and_runs_no_code(bench, arguments, said):
    (bench / "code.pt").write_bytes(pickle.dumps(Thief()))
    torch.save({"values": Thief()}, bench / "code_zip.pt")
    (bench / "text.pt").write_text("1,2,3")
    torch.save([1, 2], bench / "list.pt")
    torch.save(torch.zeros(5), bench / "flat.pt")
    torch.save(torch.randn(80, 15, generator=torch.manual_seed(1)), bench / "rest.pt")
    done = run("assess", *arguments, cwd=bench)
    assert done.returncode == 2
    assert said in done.stderr
    assert done.stderr.count("error:") == 1
    assert "Traceback" not in done.stderr
    assert not (bench / "stolen").exists()
