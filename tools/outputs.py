"""Writes the output that pages show anew: `python tools/outputs.py [PAGE ...]`, all pages if none is named.

Numbers and the widths of columns are renewed. Where the program says other words, the page has to be mended
by hand: the command is named, and its lines stay as they are. How pages show output stands in
`tests/support/shown.py`.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tests" / "support")]

from shown import PAGES, NotSaidError, prepare, renewed, said_by, shown_on  # noqa: E402


def renew(page: Path) -> bool:
    """Run the commands of a page and write it anew; the answer is whether all of them say what it shows."""
    is_whole = True
    lines = page.read_text(encoding="utf-8").splitlines()
    with tempfile.TemporaryDirectory() as folder:
        prepare(page, Path(folder))
        for shown in shown_on(page):
            said = said_by(shown.command, Path(folder))
            try:
                lines[shown.first : shown.first + len(shown.lines)] = renewed(shown, said)
            except NotSaidError as problem:
                print(problem, file=sys.stderr)
                is_whole = False
    page.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return is_whole


def main() -> None:
    """Renew the pages that are named, or all of them."""
    pages = [Path(name).resolve() for name in sys.argv[1:]] or PAGES
    sys.exit(0 if all([renew(page) for page in pages if any(shown_on(page))]) else 1)


if __name__ == "__main__":
    main()
