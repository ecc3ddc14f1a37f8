"""`gantline cad`: a file's name shows the file, a verb's name makes one."""

from __future__ import annotations

from typing import Any

import typer
from typer.core import TyperGroup

from gantline.cli.cad import cad
from gantline.cli.cad_block import make_ship_block
from gantline.cli.examples import examples_of
from gantline.cli.verb import Verb

__all__ = ["cad_app"]

_FILE = "file"


class _FileOrVerb(TyperGroup):
    """Reads `cad X` as `cad file X` where X is no verb: `gantline cad load.3docx` needs no verb."""

    # typer has a copy of click inside, so the context's type has no public name.
    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        if args and args[0] not in self.commands and args[0] not in ctx.help_option_names:
            args = [_FILE, *args]
        return super().parse_args(ctx, args)


cad_app = typer.Typer(cls=_FileOrVerb, no_args_is_help=True, rich_markup_mode=None)
# Each with a line that is not cut short in the help of the group.
_VERBS = (
    (_FILE, cad, "Weigh and draw a CAD file."),
    ("block", make_ship_block, "Make a ship block of a given mass."),
)
for name, verb, line in _VERBS:
    cad_app.command(name, cls=Verb, short_help=line, epilog=examples_of(f"cad {name}"))(verb)


@cad_app.callback(epilog="`gantline cad FILE` is short for `gantline cad file FILE`.")
def _cad() -> None:
    """Weigh and draw CAD files, or make a ship block."""
