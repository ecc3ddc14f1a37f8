"""A section of the report: hinges and grippers in which loads turn."""

from __future__ import annotations

from typing import Any

from gantline.checks import values_of
from gantline.report.section import Section
from gantline.report.subject import Subject, typeset
from gantline.results.loads.hinge_peaks import in_words


class Hinges(Section):
    """What each hinge bears at most, how far its load turns in it, and when it opens."""

    anchor = "hinges"
    title = "Hinges"
    template = "hinges.html"

    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given."""
        used = values_of(subject.recording, "hinge_force_of_rated_capacity")
        found = [
            (hinge.name, [(name, typeset(text)) for name, text in in_words(subject.recording, hinge, share)])
            for hinge in subject.rig.hinges
            for share in [used.get(hinge.name)]
        ]
        return {"hinges": found} if found else None
