"""Scenario, recording and report in notebooks: static, escaped, in a frame of its own."""

from __future__ import annotations

from html.parser import HTMLParser
from pathlib import Path

import pytest

import gantline
from hostile import EVIL, hostile_recording
from plumb_lift import plumb_lift
from sample_lift import ringing_lift


class Elements(HTMLParser):
    """All elements with their attributes, and all text."""

    def __init__(self, html: str) -> None:
        super().__init__(convert_charrefs=True)
        self.found: list[tuple[str, dict[str, str | None]]] = []
        self.text = ""
        self.feed(html)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        self.text += f"{data}\n"


def tags(html: str) -> set[str]:
    return {tag for tag, _ in Elements(html).found}


def test_a_recording_tells_what_it_is() -> None:
    page = Elements(ringing_lift()._repr_html_())
    assert {tag for tag, _ in page.found} <= {"div", "strong", "table", "tbody", "tr", "th", "td"}
    assert "0 s to 40 s, 2001 samples" in page.text
    assert "largest sling tension" in page.text and "sling.S" in page.text


def test_a_recording_of_a_stranger_cannot_act() -> None:
    html = hostile_recording()._repr_html_()
    assert tags(html) <= {"div", "strong", "table", "tbody", "tr", "th", "td"}
    assert EVIL in Elements(html).text


def test_a_scenario_tells_what_it_describes(tmp_path: Path) -> None:
    file = tmp_path / "lift.yaml"
    file.write_text(plumb_lift("heavy: {set: {load.weight.simulate: design}}"), encoding="utf-8")
    scenario = gantline.load_scenario(file)
    page = Elements(scenario._repr_html_())
    assert scenario.lift.title in page.text
    assert "1: heavy" in page.text
    assert "4: SA, SB, SC, SD" in page.text and str(file) in page.text


@pytest.mark.usefixtures("player")
def test_a_report_stands_in_a_frame_without_rights() -> None:
    report = gantline.Report(hostile_recording())
    page = Elements(report._repr_html_())
    frames = [attributes for tag, attributes in page.found if tag == "iframe"]
    assert len(frames) == 1 and {tag for tag, _ in page.found} == {"iframe", "div", "small"}
    assert frames[0]["sandbox"] == "allow-scripts"
    assert frames[0]["srcdoc"] == report.html
    assert f"{len(report.html.encode()) / 1e6:.1f} MB in this notebook" in page.text
