"""The command `gantline` and its verbs."""

from __future__ import annotations

from typing import Annotated

import typer

from gantline.cli.ballast import ballast
from gantline.cli.cad_group import cad_app
from gantline.cli.cases import cases
from gantline.cli.check import check
from gantline.cli.compare import compare
from gantline.cli.export import export
from gantline.cli.hydro import hydro
from gantline.cli.new import new
from gantline.cli.report import report
from gantline.cli.run import run
from gantline.cli.schema import schema
from gantline.cli.statics import statics
from gantline.cli.view import view

app = typer.Typer(
    name="gantline",
    help="Simulate heavy lifts: what every rope, sheave, lug and hook carries, and when.",
    rich_markup_mode=None,
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
app.command()(run)
app.command()(statics)
app.command()(cases)
app.command()(compare)
app.command()(check)
app.add_typer(cad_app, name="cad")
app.command()(hydro)
app.command()(ballast)
app.command()(report)
app.command()(view)
app.command()(export)
app.command()(new)
app.command()(schema)


def _print_version(is_wanted: bool) -> None:
    if is_wanted:
        from gantline.version import version

        typer.echo(f"gantline {version()}")
        raise typer.Exit()


@app.callback(epilog="Exit codes: 0 done, 1 a check failed, 2 bad input, 3 the simulation could not go on.")
def _gantline(
    version: Annotated[
        bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Show the version.")
    ] = False,
) -> None:
    """Simulate heavy lifts: what every rope, sheave, lug and hook carries, and when."""


def main() -> None:
    """Entry point of the command."""
    app(prog_name="gantline")
