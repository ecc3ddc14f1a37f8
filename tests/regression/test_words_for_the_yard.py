"""Words of the first page at which a foreman stumbled who has nothing but the page, on a phone.

"Stop if travel is over 90 % of its stroke" is about moving sheaves, and was read as the travel of the crane.
"97.4 %, past the 90.0 % of the lift file" left open of what. Lines ended between 7.0 and its s, and heads of
columns between 25 and its %.
"""

from __future__ import annotations

import html
import re
from functools import cache

import gantline
from gantline.report import render_report
from gantline.report.first_page import FirstPage, stop_if
from gantline.report.subject import Subject
from gantline.results import Recording


@cache
def yard() -> Recording:
    """The moving sheave e1.1 uses 1.85 m of 1.90 m, 97.4 %, and the lift file allows 90 %."""
    return gantline.simulate("equalizer_yard")


def test_what_stops_the_lift_names_the_sheave() -> None:
    assert "a sheave is over 90 % of its stroke" in stop_if(Subject(yard()))


def test_a_warning_names_its_limit() -> None:
    content = FirstPage().content(Subject(yard()))
    assert content is not None
    (travel,) = (
        one for one in content["verdict"]["warned"] if one["about"] == "equalizer travel used, e1.1 down"
    )
    assert re.match(r"97\.4 %, past its limit of 90\.0 %, at \d+\.\d s, “[^”]+”; ", travel["text"])
    # Nobody has limited how far the load yaws.
    (yaw,) = (one for one in content["verdict"]["warned"] if one["about"].startswith("load yaw"))
    assert re.match(r"20\d\.\d deg, past 45\.0 deg, at 300\.0 s; a limit of its own", yaw["text"])


def test_what_nobody_looked_at_is_said_first() -> None:
    # "... are not part of a recording" told a foreman nothing, who has none.
    assert "Not looked at here: other weights, centres of gravity, sling lengths" in render_report(yard())


def test_no_line_ends_between_a_number_and_its_unit() -> None:
    page = html.unescape(render_report(yard()))
    heads = re.findall("<th>at (\\d+\u00a0%)</th>", page)
    assert heads == ["25\u00a0%", "50\u00a0%", "75\u00a0%", "100\u00a0%"]
    (stop,) = re.findall(r'<ul class="stop">(.*?)</ul>', page, re.DOTALL)
    assert "a sheave is over 90\u00a0% of its stroke" in stop
    named = re.compile(r"<span>.*?</span>")  # of a step, such as "clear 0.3 m", as the lift file writes it
    (steps,) = re.findall(r'<ol class="steps">(.*?)</ol>', page, re.DOTALL)
    assert "hoist 0.3\u00a0m/min by 0.3\u00a0m" in steps
    assert not re.search(r"\d (%|s|m|deg|m/s|m/min)(?![\w/])", stop + named.sub("", steps))
