"""A section of the report: compensators."""

from __future__ import annotations

from typing import Any

from gantline.report.section import Section
from gantline.report.subject import Subject, typeset
from gantline.results.cranes.compensators import in_words


class Compensators(Section):
    """Rod, stroke, gas, what hangs below it, pin and stops of each compensator."""

    anchor = "compensators"
    title = "Compensators"
    template = "compensators.html"

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        found = [
            (one.name, [(name, typeset(text)) for name, text in in_words(subject.recording, one)])
            for one in subject.rig.compensators
        ]
        return {"compensators": found} if found else None
