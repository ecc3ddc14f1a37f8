"""`gantline cad`: verbs of CAD files; a file's name instead of a verb shows the file."""

from __future__ import annotations

import typer
from typer.core import TyperGroup

from gantline.cli.cad_block import block

__all__ = ["cad_app"]


class _FileOrVerb(TyperGroup):
    """Takes what is no verb for the file of the verb `file`."""


cad_app = typer.Typer(
    cls=_FileOrVerb, no_args_is_help=True, rich_markup_mode=None, help="Ship structure and loads from CAD."
)
cad_app.command()(block)
