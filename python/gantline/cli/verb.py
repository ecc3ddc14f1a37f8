"""What every verb refuses before it begins: empty words for files, and words where others belong."""

from __future__ import annotations

import inspect
from itertools import pairwise
from pathlib import Path
from typing import Any, get_args, get_type_hints

import typer
from typer.core import TyperCommand

from gantline.cli.messages import stop

__all__ = ["Verb"]


class Verb(TyperCommand):
    """A verb of the command line.

    An empty path is what a script passes on of a variable that is not set. Python takes it for the folder
    that one is in, where the files of a run would land among others.
    """

    # typer has a copy of click inside, so the context's type has no public name.
    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Read what was typed.

        Raises:
            typer.Exit: With 2 where a path is empty.
        """
        if any(not word.partition("=")[2 if "=" in word else 0].strip() for word in args):
            self._refuse_empty_paths(ctx, args)
        typed = list(args)  # what click takes it from as it reads
        self._refuse_words_behind_switches(ctx, typed)
        try:
            return super().parse_args(ctx, args)
        except typer.BadParameter as problem:
            if not problem.message:  # of what is missing click itself makes one
                self._tell_what_took_it(ctx, typed, problem.param)
            raise

    def _tell_what_took_it(self, ctx: Any, args: list[str], missing: Any) -> None:
        """Say of the lift or recording that is missing that an option has taken the word for its value."""
        if missing is not next(one for one in self.params if one.param_type_name == "argument"):
            return
        parameters: list[Any] = list(self.params)  # of which click's own base has no types of values
        options = [one for one in parameters if one.param_type_name == "option" and not one.is_flag]
        takers = {name: one for one in options for name in one.opts}
        for option, word in reversed(list(pairwise(args))):
            if option in takers:
                kind = takers[option].metavar or takers[option].type.name.upper()
                ctx.fail(
                    f"Missing argument '{missing.metavar}'; '{word}' was taken for the {kind} of {option}"
                )

    def _refuse_words_behind_switches(self, ctx: Any, args: list[str]) -> None:
        """Say of a word that is too many that a switch takes none, where it stands behind one."""
        flags = [one for one in self.params if getattr(one, "is_flag", False)]
        switches = {name for one in flags for name in (*one.opts, *one.secondary_opts)}
        if not switches & set(args):
            return
        _, left, _ = self.make_parser(ctx).parse_args(args=list(args))
        folder = any("--output" in one.opts for one in self.params)
        for switch, word in pairwise(args):
            if switch in switches and word in left:
                is_file = "/" in word or Path(word).suffix[1:].isalpha()
                instead = "; --output says where it is written" if folder and is_file else ""
                ctx.fail(f"{switch} is a switch and takes no value; '{word}' stands behind it{instead}")

    def _refuse_empty_paths(self, ctx: Any, args: list[str]) -> None:
        assert self.callback is not None  # every verb does something
        hints = get_type_hints(inspect.unwrap(self.callback))
        typed, _, _ = self.make_parser(ctx).parse_args(args=list(args))
        for parameter in self.params:
            hint = hints.get(str(parameter.name))
            given = typed.get(str(parameter.name))
            # What stands without an option is a file, a folder, or the name of a lift.
            is_path = Path in (hint, *get_args(hint)) or parameter.param_type_name == "argument"
            if is_path and isinstance(given, str) and not given.strip():
                name = next((one for one in parameter.opts if one.startswith("--")), parameter.metavar)
                stop(f"{name}: an empty path is no place; '.' is the folder that you are in")
