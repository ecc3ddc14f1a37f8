"""From sections to one page that stands alone."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import cache
from importlib.resources import files
from pathlib import Path

from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape
from markupsafe import Markup

from gantline.arguments import path_of
from gantline.replacing import replace_text
from gantline.report.case_runs import SimulatedCases
from gantline.report.chain_hoists import ChainHoists
from gantline.report.compensators import Compensators
from gantline.report.events import Events
from gantline.report.first_page import FirstPage
from gantline.report.hinges import Hinges
from gantline.report.holds import GaugesAtHoldPoints, HoldPoints
from gantline.report.plots import Attitude, Clearances, HookLoads, Player, Tanks, Tensions, Vessels
from gantline.report.rest import Cases, Modes, Rest
from gantline.report.seas import Seas
from gantline.report.section import Section
from gantline.report.steps import StepsContinued
from gantline.report.subject import Subject
from gantline.report.tables import Checks, Energy, Equalizers, LiftFile
from gantline.results.file.saved import Beside, beside_of, read_beside
from gantline.results.recording import Recording, recorded
from gantline.units import DIMENSIONS
from gantline.viewer import Packed, bundle, pack
from gantline.viewer.inline import json_for_script, policy, script_is_safe

#: Sections in the order of the report.
SECTIONS: tuple[Section, ...] = (
    FirstPage(),
    StepsContinued(),
    Player(),
    Tensions(),
    Equalizers(),
    Compensators(),
    Hinges(),
    ChainHoists(),
    HookLoads(),
    HoldPoints(),
    GaugesAtHoldPoints(),
    Attitude(),
    Vessels(),
    Tanks(),
    Clearances(),
    Checks(),
    Rest(),
    Modes(),
    Cases(),
    SimulatedCases(),
    Seas(),
    Events(),
    Energy(),
    LiftFile(),
)

#: Those of a lift that is still running.
LIVE_SECTIONS: tuple[Section, ...] = (Player(), Tensions(), HookLoads(), Attitude(), Tanks(), Clearances())

_UNITS = "|".join(re.escape(unit) for units in DIMENSIONS.values() for unit in units if unit)
_BEFORE_UNIT = re.compile(rf"(?<=[0-9_]) (?=(?:{_UNITS})(?![\w/^]))")

_STYLES = ("report.css", "first_page.css", "narrow.css", "print.css")


def render_report(
    recording: Recording, *, beside: Beside | None = None, reload_from: str = "", notice: str = ""
) -> str:
    """The report of a recording as HTML.

    Args:
        recording: Any recording.
        beside: Equilibrium, cases and seas of the same lift, where they are known.
        reload_from: Where a served page asks whether the recording has changed; empty for a file.
        notice: What stands above all of it, line by line as given; nothing if empty.

    Returns:
        A page that reads nothing from elsewhere.

    Raises:
        BundleMissing: If the player is not built in this installation.
        ValueError: If the recording cannot be drawn, or has no samples.
    """
    if not len(recording.time):
        raise ValueError(
            "this recording has no samples to show: its run has not begun, or failed in its first step"
        )
    return _rendered(Subject(recording, beside), SECTIONS, reload_from=reload_from, notice=notice)


def render_notice(title: str, notice: str, *, reload_from: str) -> str:
    """A served page that has nothing to show yet, and says why.

    Args:
        title: What the page is called.
        notice: What it says, line by line as given.
        reload_from: Where it asks whether there is something now.

    Raises:
        BundleMissing: If the player is not built in this installation.
    """
    return _page(title, sections=(), packed=None, reload_from=reload_from, notice=notice)


def render_live(recording: Recording) -> str:
    """A page that shows a lift while it runs, as HTML; it asks at `live/` for what is new.

    Args:
        recording: What has been recorded so far.

    Raises:
        BundleMissing: If the player is not built in this installation.
        ValueError: If the recording cannot be drawn.
    """
    return _rendered(Subject(recording), LIVE_SECTIONS, live_from="live/")


def _rendered(
    subject: Subject,
    wanted: tuple[Section, ...],
    *,
    reload_from: str = "",
    live_from: str = "",
    notice: str = "",
) -> str:
    packed = pack(subject.recording)
    environment = _environment()
    sections = []
    for section in wanted:
        content = section.content(subject)
        if content is not None:
            html = environment.get_template(section.template).render(section=section, **content)
            sections.append({"anchor": section.anchor, "title": section.title, "html": Markup(html)})
    return _page(
        _title(subject),
        sections=sections,
        packed=packed,
        reload_from=reload_from,
        live_from=live_from,
        notice=notice,
    )


def _page(
    title: str,
    *,
    sections: Sequence[Mapping[str, str]],
    packed: Packed | None,
    reload_from: str = "",
    live_from: str = "",
    notice: str = "",
) -> str:
    program = bundle()
    if not script_is_safe(program.script):
        raise ValueError("the player's program holds an end of a script element")
    style = f"{program.style}\n{_style()}"
    connect = "'self'" if reload_from or live_from else "'none'"
    template = _environment().get_template("page.html")
    return template.render(
        title=title,
        policy=policy([program.script], [style], connect=connect),
        style=Markup(style),
        script=Markup(program.script),
        header=None if packed is None else Markup(json_for_script(packed.header_text())),
        data=None if packed is None else Markup(packed.data_text()),
        sections=sections,
        notice=notice,
        reload_from=reload_from,
        live_from=live_from,
    )


def write_report(recording: Recording, path: str | Path, *, beside: Beside | None = None) -> Path:
    """Write the report of a recording: one HTML file that opens in any browser without a network.

    Args:
        recording: Any recording.
        path: File to write; an existing one is replaced, and only once the new one is complete.
        beside: Equilibrium, cases and seas of the same lift; by default what lies in the folder of the file.

    Returns:
        The path written.

    Raises:
        OSError: If it cannot be written there.
        BundleMissing: If the player is not built in this installation.
        ValueError: If the recording cannot be drawn, or has no samples.
    """
    target = path_of(path, "a file to write")
    found = beside_of(beside) or read_beside(target.parent, recorded(recording))
    text = render_report(recording, beside=found)
    replace_text(target, text)
    return target


def _title(subject: Subject) -> str:
    rig = subject.rig
    head = f"{rig.number} rev {rig.revision}" if rig.number and rig.revision else rig.number
    return "  ".join(part for part in (head, rig.title) if part) or "Lift"


@cache
def _environment() -> Environment:
    environment = Environment(
        loader=PackageLoader("gantline.report", "templates"),
        autoescape=select_autoescape(default=True, default_for_string=True),
        undefined=StrictUndefined,
    )
    environment.filters["unbroken"] = _unbroken
    return environment


def _unbroken(text: str) -> str:
    """A text in which no line ends between a number, or the room for one, and its unit."""
    return _BEFORE_UNIT.sub("\u00a0", text)


@cache
def _style() -> str:
    folder = files("gantline.report") / "templates"
    # What is narrower, and then paper, comes last.
    return "\n".join((folder / name).read_text(encoding="utf-8") for name in _STYLES)
