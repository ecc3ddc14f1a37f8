"""The command `gantline` and its verbs."""

from __future__ import annotations

import logging
import os
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from gantline.cli import CLOSED_PIPE
from gantline.cli.ballast import ballast
from gantline.cli.cad_group import cad_app
from gantline.cli.cases import cases
from gantline.cli.check import check
from gantline.cli.compare import compare
from gantline.cli.doctor import doctor
from gantline.cli.examples import examples_of
from gantline.cli.export import export
from gantline.cli.hydro import hydro
from gantline.cli.new import NamesLifts, new
from gantline.cli.report import report
from gantline.cli.run import run
from gantline.cli.schema import schema
from gantline.cli.seas import seas
from gantline.cli.statics import statics
from gantline.cli.verb import Verb
from gantline.cli.view import view

#: What there is here, and what other programs call it.
_CALLED = (
    ("'gantline run LIFT' simulates a lift", "simulate solve"),
    ("'gantline statics LIFT' finds how it hangs and its natural motions", "equilibrium modal modes static"),
    ("'gantline statics LIFT --sweep PATH=FROM..TO/N' varies a quantity", "sweep"),
    ("'gantline check LIFT' looks a lift file over", "validate verify"),
    ("'gantline cad FILE' reads CAD files", "import"),
    ("'gantline view RECORDING' shows a result", "open play show"),
    ("'gantline view LIFT' shows the report of a lift file, anew at each save", "watch preview edit"),
    ("'gantline export RECORDING FILE' writes pictures, films and tables", "animate convert film plot"),
    ("'gantline new FOLDER' starts a lift file", "create init"),
    ("'gantline new -h' names the lifts that come with gantline", "examples list scenarios"),
    ("'gantline -h' names the verbs, 'gantline run -h' tells of one", "help"),
    ("'gantline --version' shows it", "version"),
)
#: What is told of a verb of other programs.
OTHER_WORDS = {word: told for told, words in _CALLED for word in words.split()}


class _Verbs(TyperGroup):
    """Tells who gives a lift and no verb, or a verb of another program, what there is to be done with it."""

    # typer has a copy of click inside, so the context's type has no public name.
    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        lift = args[0]
        if lift not in self.commands and Path(lift).exists():
            both = f"'gantline run {lift}' simulates it, 'gantline check {lift}' looks it over"
            ctx.fail(f"'{lift}' is no verb; {both}")
        if lift in OTHER_WORDS and lift not in self.commands:
            ctx.fail(f"'{lift}' is no verb; {OTHER_WORDS[lift]}")
        return super().resolve_command(ctx, args)

    def invoke(self, ctx: Any) -> Any:
        """Run a verb; `| head` ends it without a word, and not with the code of a check that failed."""
        try:
            return super().invoke(ctx)
        except BrokenPipeError:
            # What has not gone out by now would be tried once more at the end, with a traceback.
            os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
            raise typer.Exit(CLOSED_PIPE) from None


app = typer.Typer(
    name="gantline",
    cls=_Verbs,
    help="Simulate heavy lifts: what every rope, sheave, lug and hook carries, and when.",
    rich_markup_mode=None,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
#: Verbs in the order of the help, each with a line that is not cut short there.
_VERBS = (
    (run, "Simulate a lift, write its report."),
    (statics, "How it hangs, without simulating."),
    (cases, "The worst of what may differ."),
    (seas, "In which seas it may be done."),
    (compare, "Two lifts side by side."),
    (check, "Check a file or a result."),
    (hydro, "Hydrostatics of a hull."),
    (ballast, "Find tank contents."),
    (report, "Write the report again."),
    (view, "Show a result in the browser."),
    (export, "Write pictures, films, tables."),
    (new, "Start a lift file."),
    (schema, "Print the JSON Schema."),
    (doctor, "Say what is installed."),
)
for verb, line in _VERBS:
    kind = NamesLifts if verb is new else Verb
    app.command(cls=kind, short_help=line, epilog=examples_of(verb.__name__))(verb)
app.add_typer(cad_app, name="cad", short_help="Weigh and draw CAD files.")


def _print_version(is_wanted: bool) -> None:
    if is_wanted:
        from gantline.version import version

        typer.echo(f"gantline {version()}")
        raise typer.Exit()


@app.callback(
    epilog="Exit codes: 0 done, 1 a check failed, 2 bad input, 3 the simulation could not go on or there is "
    "no equilibrium, 4 no verdict, 130 stopped by Ctrl-C."
)
def _gantline(
    context: typer.Context,
    version: Annotated[
        bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Show the version.")
    ] = False,
) -> None:
    """Simulate heavy lifts: what every rope, sheave, lug and hook carries, and when."""
    # Progress and help know NO_COLOR (no-color.org) by themselves, what verbs print does not.
    if os.environ.get("NO_COLOR"):
        context.color = False


def run_app() -> None:
    """Run the command with the words of this process; `gantline.cli.main` calls it."""
    # Where a home cannot be written to, as on servers, matplotlib tells of the folder that it takes instead.
    logging.getLogger("matplotlib").setLevel(logging.ERROR)
    app(prog_name="gantline")
