"""Several workers on one search in a real PostgreSQL server, which the tests start and stop."""

import itertools
import os
import pwd
import shutil
import socket
import subprocess
import sys
import tempfile
import traceback
from pathlib import Path

import optuna
import pytest
import sqlalchemy.exc

from design.errors import InputError
from instobj.search.database import open_database, patiently, without_secrets
from instobj.search.loop import run_search
from instobj.search.study import open_study
from tests.support.objects.search_cases import answering, made_up_score, made_up_space

TRIALS = 45
HERE = Path(__file__).parent


def _programs():
    """Folder of PostgreSQL's programs, or None."""
    config = shutil.which("pg_config")
    if config:
        folder = subprocess.run([config, "--bindir"], capture_output=True, text=True, check=True)
        if Path(folder.stdout.strip(), "initdb").exists():
            return Path(folder.stdout.strip())
    found = sorted(Path("/usr/lib/postgresql").glob("*/bin/initdb"))
    return found[-1].parent if found else None


def _user():
    """Whom the server runs as: it refuses root."""
    if os.getuid() != 0:
        return None
    for name in ("postgres", "nobody"):
        try:
            return pwd.getpwnam(name)
        except KeyError:
            continue
    pytest.skip("PostgreSQL does not run as root, and there is no other user")


def _free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


@pytest.fixture(scope="module")
def server():
    """Address of a new server, without the database's name."""
    programs = _programs()
    if programs is None:
        pytest.skip("PostgreSQL is not installed (no pg_config, nothing in /usr/lib/postgresql)")
    pytest.importorskip("psycopg", reason="the driver comes with instobj[cluster]")
    user = _user()
    identity = (
        {} if user is None else {"user": user.pw_uid, "group": user.pw_gid, "extra_groups": []}
    )
    folder = Path(tempfile.mkdtemp(prefix="instobj-pg-"))
    if user is not None:
        os.chown(folder, user.pw_uid, user.pw_gid)
    data, port = folder / "data", _free_port()

    def call(program, *arguments):
        command = [str(programs / program), *arguments]
        subprocess.run(
            command, check=True, capture_output=True, cwd=folder, timeout=120, **identity
        )

    try:
        call("initdb", "-D", str(data), "-U", "search", "--auth=trust", "--no-sync")
        options = f"-p {port} -k {folder} -c listen_addresses=127.0.0.1 -c fsync=off"
        call("pg_ctl", "-D", str(data), "-o", options, "-l", str(folder / "log"), "-w", "start")
        try:
            yield f"postgresql+psycopg://search:secret@127.0.0.1:{port}"
        finally:
            call("pg_ctl", "-D", str(data), "-m", "immediate", "stop")
    finally:
        shutil.rmtree(folder)


WORK = """
import sys
from pathlib import Path
from tests.support.objects.search_cases import answering, made_up_score, made_up_space
from instobj.search.loop import run_search
from instobj.search.study import open_study
space = made_up_space(trials=int(sys.argv[4]))
kept = open_study(space.spec, sys.argv[1], join=True)
print("ready", flush=True)
sys.stdin.readline()
run_search(space, kept, answering(made_up_score), lambda line: None, worker=int(sys.argv[2]))
"""


def _worker(url, number):
    return subprocess.Popen(
        [sys.executable, "-c", WORK, url, str(number), str(HERE), str(TRIALS)],
        cwd=HERE.parents[2], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        text=True,
    )  # fmt: skip


def test_workers_share_one_search(server):
    url = f"{server}/postgres"
    space = made_up_space(trials=TRIALS)
    kept = open_study(space.spec, url)
    other = _worker(url, 1)
    assert other.stdout.readline() == "ready\n"
    other.stdin.write("go\n")
    other.stdin.flush()
    run_search(space, kept, answering(made_up_score), lambda line: None, worker=2)
    assert other.communicate(timeout=240)[1] == ""
    assert other.returncode == 0
    trials = kept.finished()
    assert TRIALS <= len(trials) < TRIALS + 16 * 2
    places = {trial.params["magnet1_x_mm"] for trial in trials}
    assert len(places) == len(trials), "two workers tried the same layouts"
    resumed = open_study(made_up_space(trials=TRIALS + 10).spec, url, resume=True)
    run_search(
        made_up_space(trials=TRIALS + 10),
        resumed,
        answering(made_up_score),
        print,
    )
    assert len(resumed.trials()) >= TRIALS + 10
    with pytest.raises(InputError, match="another specification"):
        open_study(made_up_space(reach=12.0).spec, url, resume=True)


def test_an_unreachable_database_is_one_clear_error_without_its_password():
    pytest.importorskip("psycopg", reason="the driver comes with instobj[cluster]")
    url = f"postgresql+psycopg://search:secret@127.0.0.1:{_free_port()}/postgres"
    with pytest.raises(InputError, match="cannot reach the database") as error:
        open_study(made_up_space().spec, url)
    assert "secret" not in str(error.value)


@pytest.mark.parametrize(
    "url",
    [
        "postgresql+psycopg://search@127.0.0.1:1/db?password=secret",
        "postgresql+psycopg://127.0.0.1:1/db?user=a&sslpassword=secret&sslmode=prefer",
        "postgresql+psycopg://:secret@/db",
        "postgresql+psycopg://search:secret@127.0.0.1:port/db",
        "postgresql+psycopg://search:secret@127.0.0.1:/db",
        "sqlite:////no/such/folder/x.db?password=secret",
    ],
)
def test_no_password_is_ever_printed(url):
    pytest.importorskip("psycopg", reason="the driver comes with instobj[cluster]")
    assert "secret" not in without_secrets(url)
    with pytest.raises(InputError, match="cannot reach the database") as error:
        open_database(url)
    text = "".join(traceback.format_exception(error.value))
    assert "secret" not in text


def test_workers_that_start_together_all_find_their_tables(monkeypatch):
    """The one that comes second is told that a table exists already, and tries again."""
    tried = []

    def tables(url, **options):
        tried.append(url)
        if len(tried) < 3:
            raise sqlalchemy.exc.ProgrammingError(
                "CREATE TABLE studies", {}, Exception('relation "studies" already exists')
            )
        return "tables"

    monkeypatch.setattr("instobj.search.database.RDBStorage", tables)
    monkeypatch.setattr("time.sleep", lambda seconds: None)
    assert open_database("sqlite://") == "tables"
    assert len(tried) == 3


def test_a_database_that_goes_away_is_asked_again_for_two_minutes():
    pauses, said = [], []

    def gone():
        raise sqlalchemy.exc.OperationalError("SELECT", {}, Exception("server closed"))

    with pytest.raises(sqlalchemy.exc.OperationalError):
        patiently(gone, said.append, pauses.append)
    assert 110 < sum(pauses) < 130
    assert all(a < b for a, b in itertools.pairwise(pauses))
    answers = iter([optuna.exceptions.StorageInternalError("gone"), 7])

    def back():
        answer = next(answers)
        if isinstance(answer, Exception):
            raise answer
        return answer

    assert patiently(back, said.append, pauses.append) == 7
    assert "does not answer" in said[-1]


def test_a_database_lost_for_good_ends_a_search_with_one_clear_error(tmp_path, monkeypatch):
    monkeypatch.setattr("instobj.search.database._PAUSES_S", (0.01,))
    kept = open_study(made_up_space().spec, f"sqlite:///{tmp_path}/search.db")

    def gone(*given, **options):
        raise sqlalchemy.exc.OperationalError("SELECT", {}, Exception("server closed"))

    monkeypatch.setattr(kept.study, "get_trials", gone)
    with pytest.raises(InputError, match="cannot read trials from sqlite"):
        kept.trials()


@pytest.mark.parametrize("url", ["nonsense://somewhere/x", "postgresql+nodriver://h/x"])
def test_a_database_of_no_known_kind_is_one_clear_error(url):
    with pytest.raises(InputError, match="database"):
        open_study(made_up_space().spec, url)
