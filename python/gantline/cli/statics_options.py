"""Options of `gantline statics`, and which of them go with which question."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

from gantline.cli.lift import folder_option
from gantline.cli.messages import stop

__all__ = [
    "Adjust",
    "AsJson",
    "Held",
    "Level",
    "Lost",
    "Margins",
    "Modes",
    "Most",
    "Output",
    "Plumb",
    "Sensitivities",
    "StateFile",
    "Steps",
    "Sweep",
    "Want",
    "refuse_unrelated",
]

Modes = Annotated[int, typer.Option("--modes", metavar="N", min=0, help="How many natural motions to show.")]
Sensitivities = Annotated[
    bool, typer.Option("--sensitivities", help="Show what lengths, stiffness and weight change.")
]
Margins = Annotated[
    bool,
    typer.Option("--margins", help="Show how far the centre of gravity may be elsewhere, by solving anew."),
]
Sweep = Annotated[
    str | None,
    typer.Option(
        metavar="PATH=FROM..TO/N",
        help="Show tensions and tilt over N values of a quantity of the lift file, such as "
        "'cranes.hook.at.z=36 m..37 m/5'.",
    ),
]
Level = Annotated[
    bool, typer.Option("--level", help="Find lengths of slings with which the load hangs level.")
]
Want = Annotated[
    str | None,
    typer.Option(
        metavar="NAME=VALUE,…",
        help="Find lengths of slings for 'slope_x', 'slope_y' and 'heading' of the load, or a sling's "
        "share of it, such as 'heading=90 deg, S1=25 %'.",
    ),
]
Plumb = Annotated[
    bool, typer.Option("--plumb", help="Find places of hooks, trolleys, cranes: falls hang plumb.")
]
Adjust = Annotated[
    str | None,
    typer.Option(metavar="NAME,…", help="Slings or hooks that these may change.  [default: all]"),
]
Most = Annotated[
    str | None,
    typer.Option(metavar="LENGTH", help="Most by which a length may change.  [default: a tenth of it]"),
]
Held = Annotated[
    bool,
    typer.Option("--held", help="Let friction of contacts and sheaves hold what it can, from the start on."),
]
Lost = Annotated[
    str | None,
    typer.Option(
        metavar="LOAD", help="Show how vessels swing that lose this load at once, and whether they come back."
    ),
]
Steps = Annotated[
    bool, typer.Option("--steps", help="Show how it hangs at the end of every step of the plan.")
]
StateFile = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE", help="Ask for the equilibrium of where a run had got to, by the state that it left."
    ),
]
Output = Annotated[
    Path | None,
    folder_option("Folder for the equilibrium and one period of each motion shown, as recordings."),
]
AsJson = Annotated[
    bool, typer.Option("--json", help="Print all numbers as JSON, SI units, and nothing else.")
]

_OF_LENGTHS = ("--adjust", "--most", "--time", "--json", "--output")
#: What each question is about, and the options that go with it; without any the equilibrium is asked for.
#: Of several the first is that whose options count.
_QUESTIONS: dict[str, tuple[str, tuple[str, ...]]] = {
    "--state": (
        "is about where a run had got to, at a time of its own",
        ("--modes", "--sensitivities", "--json", "--output"),
    ),
    "--sweep": ("makes a table of many equilibria", ("--time", "--json")),
    "--steps": ("shows the ends of all steps", ("--held", "--json")),
    "--lost": ("shows vessels that lose a load", ("--held", "--time", "--json", "--output")),
    "--plumb": ("moves hooks until none is pulled aside", ("--adjust", "--time", "--json", "--output")),
    "--want": ("finds lengths of slings", ("--level", *_OF_LENGTHS)),
    "--level": ("finds lengths of slings", ("--want", *_OF_LENGTHS)),
}
#: Options that belong to questions alone.
_OF_QUESTIONS = ("--adjust", "--most")


def refuse_unrelated(context: typer.Context) -> None:
    """End the program where an option was given that has nothing to do with what is asked."""
    given = _options(context)
    question = next((one for one in _QUESTIONS if one in given), None)
    if question is None:
        for option in given:
            if option in _OF_QUESTIONS:
                owners = [name for name, (_, allowed) in _QUESTIONS.items() if option in allowed]
                stop(f"{option}: belongs to {_listed(owners, 'or')}")
        return
    about, allowed = _QUESTIONS[question]
    unrelated = [one for one in given if one not in (question, *allowed)]
    if unrelated:
        does = "does" if len(unrelated) == 1 else "do"
        stop(f"{question}: {about}; {_listed(unrelated)} {does} not go with it, {_listed(allowed)} do")


def _options(context: typer.Context) -> list[str]:
    """Options that were given, in the order of the help."""
    return [
        next(name for name in one.opts if name.startswith("--"))
        for one in context.command.params
        if one.param_type_name == "option" and _is_given(context, one.name or "")
    ]


def _is_given(context: typer.Context, name: str) -> bool:
    source = context.get_parameter_source(name)
    return source is not None and source.name == "COMMANDLINE"


def _listed(words: Sequence[str], last: str = "and") -> str:
    return f" {last} ".join(filter(None, [", ".join(words[:-1]), words[-1]]))
