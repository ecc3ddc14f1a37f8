"""A section of a report: what it is called, and what its template is given."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, ClassVar

from gantline.report.subject import Subject


class Section(ABC):
    """One section with one template.

    Attributes:
        anchor: Name of its place in the page.
        title: What it is called.
        template: File among the templates.
    """

    anchor: ClassVar[str]
    title: ClassVar[str]
    template: ClassVar[str]

    @abstractmethod
    def content(self, subject: Subject) -> dict[str, Any] | None:
        """What the template is given; None if this recording has nothing of the kind."""
