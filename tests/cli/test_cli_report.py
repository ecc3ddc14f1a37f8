"""`gantline report` and `gantline view`, and the report at the end of `gantline run`."""

from __future__ import annotations

import socket
import threading
import time
import urllib.request
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

import gantline.report
import gantline.report.page
import gantline.viewer.server
from gantline.cli.app import app
from gantline.cli.view import view
from gantline.viewer import BundleMissing
from gantline.viewer.bundle import Bundle
from sample_lift import ringing_lift


def says(*words: object) -> Result:
    return CliRunner().invoke(app, [str(word) for word in words])


@pytest.fixture
def no_player(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing() -> Bundle:
        raise BundleMissing("the player is not built in this installation")

    monkeypatch.setattr(gantline.report.page, "bundle", missing)


@pytest.mark.usefixtures("player")
def test_a_run_leaves_a_report_and_says_where(tmp_path: Path) -> None:
    result = says("run", "pulleys", "--duration", "1 s", "--no-plots", "-o", tmp_path)
    assert result.exit_code == 0, result.output
    assert result.stdout.rstrip().endswith(f"Report      {tmp_path / 'report.html'}")
    assert "<!doctype html>" in (tmp_path / "report.html").read_text(encoding="utf-8")


@pytest.mark.usefixtures("no_player")
def test_a_run_without_a_player_warns_and_is_done(tmp_path: Path) -> None:
    result = says("run", "pulleys", "--duration", "1 s", "--no-plots", "-o", tmp_path)
    assert result.exit_code == 0, result.output
    assert "no report: the player is not built" in result.stderr
    assert not (tmp_path / "report.html").exists()


@pytest.mark.usefixtures("player")
def test_a_report_stands_beside_its_recording_or_where_it_is_wanted(tmp_path: Path) -> None:
    recording = ringing_lift().save(tmp_path / "recording.nc")
    assert says("report", recording).stdout == f"Report      {tmp_path / 'report.html'}\n"
    assert says("report", tmp_path, "-o", tmp_path / "other.html").exit_code == 0
    assert (tmp_path / "other.html").read_bytes() == (tmp_path / "report.html").read_bytes()


def test_what_is_no_recording_gets_one_sentence(tmp_path: Path) -> None:
    (tmp_path / "text.nc").write_text("no recording")
    for verb, of_folder in (("report", "is no recording"), ("view", "a lift file or its folder is needed")):
        for asked, words in (
            (tmp_path / "nothing.nc", "nothing.nc"),
            (tmp_path / "text.nc", "text.nc"),
            (tmp_path / "folder", of_folder),
        ):
            result = says(verb, asked)
            assert result.exit_code == 2, result.output
            assert words in result.stderr and result.stdout == ""
            assert "Traceback" not in result.output


@pytest.mark.usefixtures("no_player")
def test_without_a_player_there_is_no_report(tmp_path: Path) -> None:
    recording = ringing_lift().save(tmp_path / "recording.nc")
    for verb in ("report", "view"):
        result = says(verb, recording)
        assert result.exit_code == 2 and "is not built" in result.stderr


@pytest.mark.usefixtures("player")
def test_a_report_that_cannot_be_written_gets_one_sentence(tmp_path: Path) -> None:
    recording = ringing_lift().save(tmp_path / "recording.nc")
    assert "is a folder" in says("report", recording, "-o", tmp_path).stderr
    result = says("report", recording, "-o", tmp_path / "missing" / "report.html")
    assert result.exit_code == 2 and "cannot be written" in result.stderr


def count_pages(monkeypatch: pytest.MonkeyPatch) -> list[object]:
    """Recordings of which a page is made from now on."""
    made = list[object]()
    render = gantline.report.render_report

    def counted(recording: Any, **more: Any) -> str:
        made.append(recording)
        return render(recording, **more)

    monkeypatch.setattr(gantline.report, "render_report", counted)
    return made


@pytest.mark.usefixtures("player")
def test_view_says_at_once_what_it_does(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A recording of 71 MB was read for seven seconds without a word."""
    recording = ringing_lift().save(tmp_path / "recording.nc")

    def slow(*_: object, **__: object) -> str:
        raise ValueError("as if it took for ever")

    monkeypatch.setattr(gantline.report, "render_report", slow)
    monkeypatch.setattr("gantline.cli.view.LARGE", recording.stat().st_size)
    lines = says("view", recording, "--no-browser").stderr.splitlines()
    assert lines[0].startswith(f"making the page of {recording} (")
    assert lines[1] == f"error: {recording}: as if it took for ever"


def test_a_port_that_cannot_be_used(tmp_path: Path) -> None:
    recording = ringing_lift().save(tmp_path / "recording.nc")
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        result = says("view", recording, "--port", port, "--no-browser")
    assert result.exit_code == 2
    assert result.stderr == f"error: --port: {port} cannot be used (address already in use)\n"


@pytest.mark.usefixtures("player")
def test_view_serves_the_report_and_notices_that_its_recording_has_changed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    recording = ringing_lift().save(tmp_path / "recording.nc")
    servers: list[gantline.viewer.server.PageServer] = []
    serve = gantline.viewer.server.PageServer.serve_forever

    def remember(self: gantline.viewer.server.PageServer, poll_interval: float = 0.5) -> None:
        servers.append(self)
        serve(self, poll_interval)

    monkeypatch.setattr(gantline.viewer.server.PageServer, "serve_forever", remember)
    made = count_pages(monkeypatch)
    thread = threading.Thread(target=view, args=(recording, 0, False), daemon=True)
    thread.start()
    deadline = time.monotonic() + 60.0
    while not servers and time.monotonic() < deadline:
        time.sleep(0.02)
    address = servers[0].address

    def read(name: str = "") -> str:
        with urllib.request.urlopen(address + name, timeout=30) as answer:
            return str(answer.read().decode())

    told = capsys.readouterr()
    assert told.out.startswith(f"{address}\n")
    assert told.err == "", "it is small"
    assert '<meta name="gantline-reload" content="version">' in read()
    assert read() == read() and len(made) == 1, "what was made to see whether it can be is what is shown"
    state = read("version")
    ringing_lift(events=[]).save(recording)
    assert read("version") != state
    assert read() == read() and len(made) == 2
    for beside in ("cases.json", "equilibrium.nc"):
        state = read("version")
        (tmp_path / beside).write_text("{}")
        assert read("version") != state, f"the report shows {beside} too"
    state = read("version")
    (tmp_path / "cases.json").unlink()
    assert read("version") != state
    recording.unlink()
    assert read("version") == "gone", "then the page stays as it is"
    servers[0].shutdown()
    thread.join(timeout=30)
    assert not thread.is_alive()
