"""What pictures show."""

from __future__ import annotations

from matplotlib.artist import Artist
from matplotlib.text import Text


def text_of(artist: Artist) -> str:
    """All that is written in a figure or a panel, a text per line."""
    texts: list[Text] = artist.findobj(Text)
    return "\n".join(text.get_text() for text in texts)
