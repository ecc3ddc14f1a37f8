"""Text put into a page so that it can do no harm: JSON in script elements, and what the page may do."""

from __future__ import annotations

import base64
import hashlib
from collections.abc import Iterable

_ESCAPES = {ord(sign): f"\\u{ord(sign):04x}" for sign in "<>&\u2028\u2029"}


def json_for_script(text: str) -> str:
    """JSON text for a script element: no sign in it can end the element or begin markup.

    JSON has these signs in its strings alone, where an escape means the same.
    """
    return text.translate(_ESCAPES)


def script_is_safe(text: str) -> bool:
    """Whether a program can stand in a script element as it is."""
    lowered = text.lower()
    return "</script" not in lowered and "<!--" not in lowered


def policy(scripts: Iterable[str], styles: Iterable[str], *, connect: str = "'none'") -> str:
    """Content security policy of a page: these programs and styles by their digests, and nothing else.

    Args:
        scripts: Programs that stand in the page.
        styles: Style sheets that stand in the page.
        connect: Where the page may read from.
    """
    script, style = (" ".join(f"'sha256-{_digest(one)}'" for one in parts) for parts in (scripts, styles))
    return (
        f"default-src 'none'; script-src {script}; style-src {style}; img-src data: blob:; "
        f"connect-src {connect}; base-uri 'none'; form-action 'none'"
    )


def _digest(text: str) -> str:
    return base64.b64encode(hashlib.sha256(text.encode("utf-8")).digest()).decode("ascii")
