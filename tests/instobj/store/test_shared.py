"""A shared store: what one machine made, another fetches; damage, strange names and silence are told."""

import json

import fsspec
import pytest

from design.errors import StoreError
from instobj.store import shared
from instobj.store.content import find, stored
from instobj.store.keys import content_key, stage_key
from instobj.store.record import RECORD

FILES = {"table.nc": bytes(range(256)) * 40, "maps/one.png": b"\x89PNG.."}
INPUTS = {"a": 1}


def make(folder):
    for name, content in FILES.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(content)


def never(folder):
    raise AssertionError("made again")


def content(result):
    return {name: (result.folder / name).read_bytes() for name in FILES}


@pytest.fixture
def bucket(tmp_path, monkeypatch):
    """Folder of the shared store, which is reached by a URL."""
    monkeypatch.setenv(shared.URL, f"file://{tmp_path / 'bucket'}")
    return tmp_path / "bucket"


def test_another_machine_fetches_what_was_made(tmp_path, bucket):
    first = stored(tmp_path / "one", "stage", INPUTS, make)
    other = stored(tmp_path / "two", "stage", INPUTS, never)
    assert (first.reused, other.reused) == (False, True)
    assert (other.content, content(other)) == (first.content, FILES)
    assert other.folder.is_relative_to(tmp_path / "two")
    assert not stored(tmp_path / "two", "stage", {"a": 2}, make).reused


def test_what_a_store_already_holds_is_sent_when_it_is_found(tmp_path, monkeypatch, bucket):
    monkeypatch.delenv(shared.URL)
    stored(tmp_path / "one", "stage", INPUTS, make)
    monkeypatch.setenv(shared.URL, f"file://{bucket}")
    stored(tmp_path / "one", "stage", INPUTS, never)
    assert find(tmp_path / "two", "stage", stage_key("stage", INPUTS)) is not None
    assert find(tmp_path / "two", "stage", stage_key("stage", {"a": 2})) is None


def flip(path):
    damaged = bytearray(path.read_bytes())
    damaged[len(damaged) // 2] ^= 1
    path.write_bytes(damaged)


def empty(path):
    path.write_bytes(b"")


def remove(path):
    path.unlink()


@pytest.mark.parametrize("damage", [flip, empty, remove])
@pytest.mark.parametrize("name", [*FILES, RECORD])
def test_damage_there_is_told_made_again_and_replaced(tmp_path, bucket, name, damage):
    stored(tmp_path / "one", "stage", INPUTS, make)
    (file,) = (path for path in bucket.rglob("*") if path.as_posix().endswith(name))
    damage(file)
    said = []
    again = stored(tmp_path / "two", "stage", INPUTS, make, said.append)
    assert (again.reused, content(again)) == (False, FILES)
    missing_record = (name, damage) == (RECORD, remove)
    assert bool(said) == (not missing_record)
    assert all("damaged" in line and str(bucket) in line for line in said)
    assert content(stored(tmp_path / "three", "stage", INPUTS, never)) == FILES


@pytest.mark.parametrize(
    "name", ["../../outside", "/etc/outside", "a/../../outside", "..\\outside"]
)
def test_no_name_leads_out_of_a_result(tmp_path, bucket, name):
    stored(tmp_path / "one", "stage", INPUTS, make)
    (path,) = bucket.rglob(RECORD)
    record = json.loads(path.read_text())
    record["files"] = {name: {"bytes": 1, "sha256": "0"}}
    del record["digest"]
    path.write_text(json.dumps(record | {"digest": content_key(record)}))
    said = []
    stored(tmp_path / "two", "stage", INPUTS, make, said.append)
    assert "no name within a result" in said[0]
    assert not (tmp_path / "outside").exists()


def test_two_machines_that_made_the_same_leave_one_whole_result(tmp_path, bucket):
    """Contents differ, as meshes do; the first that was sent stays."""

    def other(folder):
        make(folder)
        (folder / "table.nc").write_bytes(b"another mesh")

    def while_another_sends(folder):
        stored(tmp_path / "two", "stage", INPUTS, other)
        make(folder)

    own = stored(tmp_path / "one", "stage", INPUTS, while_another_sends)
    fetched = stored(tmp_path / "three", "stage", INPUTS, never)
    assert content(own) == FILES
    assert (fetched.folder / "table.nc").read_bytes() == b"another mesh"


@pytest.mark.parametrize(
    ("url", "told"),
    [("s4://bucket", "no address that fsspec knows"), ("gdrive://bucket", "not installed")],
)
def test_an_address_that_cannot_be_used_is_one_error(tmp_path, monkeypatch, url, told):
    monkeypatch.setenv(shared.URL, url)
    with pytest.raises(StoreError, match=told):
        stored(tmp_path, "stage", INPUTS, make)


def test_what_was_made_is_kept_where_the_shared_store_fails(tmp_path, monkeypatch, bucket):
    failing = fsspec.filesystem("file")

    def refuse(*_, **__):
        raise PermissionError("access denied")

    monkeypatch.setattr(type(failing), "put_file", refuse)
    with pytest.raises(StoreError, match=r"access denied.*kept in the store of this machine"):
        stored(tmp_path / "one", "stage", INPUTS, make)
    monkeypatch.undo()
    assert content(stored(tmp_path / "one", "stage", INPUTS, never)) == FILES


def test_s3(tmp_path, monkeypatch):
    pytest.importorskip("s3fs")
    server_of = pytest.importorskip("moto.server").ThreadedMotoServer
    for key in ("AWS_ACCESS_KEY_ID", "AWS_SECRET_ACCESS_KEY"):
        monkeypatch.setenv(key, "testing")
    server = server_of(ip_address="127.0.0.1", port=0, verbose=False)
    server.start()
    try:
        host, port = server.get_host_and_port()
        monkeypatch.setitem(fsspec.config.conf, "s3", {"endpoint_url": f"http://{host}:{port}"})
        storage = fsspec.filesystem("s3")
        storage.mkdir("bucket")
        monkeypatch.setenv(shared.URL, "s3://bucket/results")
        stored(tmp_path / "one", "stage", INPUTS, make)
        assert content(stored(tmp_path / "two", "stage", INPUTS, never)) == FILES
        (table,) = storage.glob("bucket/results/stage/**/table.nc")
        storage.pipe_file(table, b"damaged")
        said = []
        stored(tmp_path / "three", "stage", INPUTS, make, said.append)
        assert "table.nc has 7 bytes" in said[0]
        assert content(stored(tmp_path / "four", "stage", INPUTS, never)) == FILES
        monkeypatch.setenv(shared.URL, "s3://no-such-bucket")
        with pytest.raises(StoreError, match="cannot be used"):
            stored(tmp_path / "one", "stage", INPUTS, never)
        assert not storage.exists("no-such-bucket")
    finally:
        server.stop()
