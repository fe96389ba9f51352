"""Pages for other machines: only with people and TLS, and under the one address that was given."""

from __future__ import annotations

import json
import shutil
import signal
import ssl
import stat
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect
from websockets.typing import Origin

from sitewright.app.project import new_project
from sitewright.app.serving.door import NAME, Door, door_of, opened
from sitewright.app.serving.reached import Tls, host_fault, place_of
from sitewright.app.serving.users import new_user
from sitewright.cli.main import exit_code
from sitewright.cli.serve_command import _qr_code
from sitewright.errors import BackendError
from sitewright.interaction_twin.roles import Role

PROGRAM = str(Path(sys.executable).with_name("sitewright"))
OPENSSL = shutil.which("openssl")
PATIENCE_S = 60.0
TOKEN = "t" * 43


def certificate(folder: Path) -> Tls:
    """Make a certificate that nobody else vouches for."""
    made = Tls(folder / "cert.pem", folder / "key.pem")
    asked = (
        "req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 -subj /CN=cell"
    )
    subject = ["-addext", "subjectAltName=IP:127.0.0.1,DNS:cell.local"]
    files = ["-keyout", str(made.key), "-out", str(made.certificate)]
    if OPENSSL is None:
        pytest.skip("needs openssl: apt-get install openssl")
    subprocess.run([OPENSSL, *asked.split(), *subject, *files], check=True, capture_output=True)
    return made


@pytest.fixture(scope="module")
def tls(tmp_path_factory: pytest.TempPathFactory) -> Tls:
    return certificate(tmp_path_factory.mktemp("tls"))


@pytest.fixture(scope="module")
def users(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    file = tmp_path_factory.mktemp("users") / "users.toml"
    return file, new_user(file, "ann", Role.OPERATOR)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("--host 127.0.0.1", "--host lets other machines in"),
        ("--host 127.0.0.1 --users U", "--host lets other machines in"),
        ("--host 127.0.0.1 --tls-cert C --tls-key K", "--host lets other machines in"),
        ("--users U --tls-cert C", "belong together"),
        ("--users U --tls-cert K --tls-key C", "are no certificate with its key"),
        ("--users U --tls-cert C --tls-key nothing.pem", "are no certificate with its key"),
        ("--host 0.0.0.0 --users U --tls-cert C --tls-key K", "stands for every address"),
        ("--host a/b --users U --tls-cert C --tls-key K", "no address and no name"),
        ("--tablet", "--tablet needs --host"),
    ],
)
def test_what_would_let_in_too_much_is_wrong_usage(
    given: str,
    said: str,
    tls: Tls,
    users: tuple[Path, str],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    stands_for = {"U": users[0], "C": tls.certificate, "K": tls.key}
    words = [str(stands_for.get(word, word)) for word in given.split()]
    assert exit_code(["serve", str(tmp_path), "--no-browser", *words]) == 2
    assert said in capsys.readouterr().err


class Served:
    """A server with TLS, as a user starts it."""

    def __init__(self, folder: Path, tls: Tls, users: Path) -> None:
        command = [
            PROGRAM,
            "serve",
            str(folder),
            "--port",
            "0",
            "--no-browser",
            "--json",
            "--tablet",
        ]
        command += ["--host", "127.0.0.1", "--users", str(users)]
        command += ["--tls-cert", str(tls.certificate), "--tls-key", str(tls.key)]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        text = ""
        assert self.process.stdout is not None
        while not text.endswith("}\n"):
            text += self.process.stdout.readline()
        self.origin = json.loads(text)["url"].rstrip("/")
        self.trusted = ssl.create_default_context(cafile=tls.certificate)

    def client(self, **headers: str) -> httpx.Client:
        own = {"origin": self.origin, **headers}
        return httpx.Client(
            base_url=self.origin, verify=self.trusted, timeout=PATIENCE_S, headers=own
        )


@pytest.fixture(scope="module")
def served(
    tmp_path_factory: pytest.TempPathFactory, tls: Tls, users: tuple[Path, str]
) -> Iterator[tuple[Served, Path]]:
    place = tmp_path_factory.mktemp("served")
    folder = new_project(place / "frame")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_STATE_HOME", str(place / "state"))
        server = Served(folder, tls, users[0])
        yield server, folder
        server.process.send_signal(signal.SIGINT)
        assert server.process.wait(PATIENCE_S) == 0
        assert server.process.stdout is not None
        server.process.stdout.close()
        assert not (folder / "runs" / NAME).exists()


def test_the_cookie_goes_over_tls_only_and_other_addresses_are_refused(
    served: tuple[Served, Path], users: tuple[Path, str]
) -> None:
    server, _ = served
    assert server.origin.startswith("https://127.0.0.1:"), "the link has no token"
    assert "#" not in server.origin
    with server.client() as page:
        signed = page.post("/api/session", json={"user": "ann", "token": users[1]})
        assert signed.status_code == 200
        assert "Secure" in signed.headers["set-cookie"]
        assert page.get("/api/session").json()["who"] == "ann"
        port = server.origin.rsplit(":", 1)[1]
        for host in (f"localhost:{port}", f"cell.local:{port}", "127.0.0.1"):
            assert page.get("/api/state", headers={"host": host}).json()["error"] == "host"
        for origin in (server.origin.replace("https", "http"), "https://cell.local"):
            answer = page.post("/api/ws-ticket", json={}, headers={"origin": origin})
            assert (answer.status_code, answer.json()["error"]) == (403, "origin")
        ticket = page.post("/api/ws-ticket", json={}).json()["ticket"]
    url = server.origin.replace("https", "wss") + "/ws"
    with connect(url, ssl=server.trusted, origin=Origin(server.origin)) as link:
        link.send(json.dumps({"ticket": ticket, "after": None}))
        assert json.loads(link.recv(PATIENCE_S))["type"] == "caught-up"
    evil = Origin("https://evil.example")
    with pytest.raises(InvalidStatus), connect(url, ssl=server.trusted, origin=evil):
        pass


def test_where_people_have_tokens_a_command_needs_one_of_them(
    served: tuple[Served, Path],
    users: tuple[Path, str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    _, folder = served
    file = folder / "runs" / NAME
    assert stat.S_IMODE(file.stat().st_mode) == 0o600
    assert door_of(folder).token == ""
    command = ["approve", "0000-0000", "--project", str(folder)]
    assert exit_code(command) == 7
    assert "SITEWRIGHT_TOKEN" in capsys.readouterr().err
    monkeypatch.setenv("SITEWRIGHT_TOKEN", "somebody-else's")
    assert exit_code(command) == 7
    assert "Nobody is signed in" in capsys.readouterr().err
    monkeypatch.setenv("SITEWRIGHT_TOKEN", users[1])
    assert exit_code(command) == 7  # by TLS, whose certificate is the one in the door
    assert any(
        words in capsys.readouterr().err for words in ("No plan waits", "The plan that is open is")
    )


def test_a_place_answers_to_its_own_names_and_the_usual_port_may_be_left_out() -> None:
    assert place_of(None, 8765, is_secure=False).hosts == {"127.0.0.1:8765", "localhost:8765"}
    assert place_of("Cell.local", 443, is_secure=True).hosts == {"cell.local", "cell.local:443"}
    assert place_of("fe80::1", 8765, is_secure=True).origin == "https://[fe80::1]:8765"
    assert host_fault("192.168.1.20") == host_fault("fe80::1") == host_fault("cell-1.local") == ""


def test_the_code_for_the_camera_is_a_square_of_blocks_with_its_three_corners() -> None:
    link = "https://192.168.1.20:8765/#token=abcdefghijklmnopqrstuvwxyz0123456789"
    rows = _qr_code(link).splitlines()
    assert {len(row) for row in rows} == {len(rows) * 2 - 1}  # two rows of dots to a line
    assert " ▄▄▄▄▄ " in rows[2] or " ▄▄▄▄▄ " in rows[1]
    assert _qr_code(link) != _qr_code(link + "x")


def test_a_door_is_private_and_goes_with_its_server(tmp_path: Path) -> None:
    with opened(tmp_path / "runs", Door(origin="http://127.0.0.1:1", token=TOKEN)):
        assert door_of(tmp_path).token == TOKEN
        later = Door(origin="http://127.0.0.1:2")
        with opened(tmp_path / "runs", later):
            assert stat.S_IMODE((tmp_path / "runs" / NAME).stat().st_mode) == 0o600
            first: Any = (tmp_path / "runs" / NAME).read_text()
        (tmp_path / "runs" / NAME).write_text(first)
    assert door_of(tmp_path) == later  # not its own: left alone
    (tmp_path / "runs" / NAME).unlink()
    with pytest.raises(BackendError, match="No server serves"):
        door_of(tmp_path)
