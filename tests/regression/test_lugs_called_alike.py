"""Lugs of two spreaders that are called alike could not be told apart on the first page of a report.

A ship block on two spreaders with lugs `T1`, `T2` and `B1` to `B4` had two rows with lug `T1`, and `B4, P1`
beside `B4, P3`: who reads it does not know of which spreader. Spreaders now name theirs.
"""

from __future__ import annotations

from pathlib import Path

import gantline


def test_lugs_of_spreaders_have_the_name_of_theirs(tmp_path: Path) -> None:
    recording = gantline.simulate("spreader_bar", duration=2.0)
    gantline.write_report(recording, tmp_path / "report.html")
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    for sling in recording.rig.slings:
        lugs = [name if of == "module" else f"{of}.{name}" for _, of, name in sling.at_lugs()]
        assert f"<td>{', '.join(lugs)}</td>" in page, lugs
    assert "<td>bar.T1</td>" in page
