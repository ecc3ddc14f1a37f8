import sys
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

# Builders that several test modules share (`import sample_lift`).
sys.path.insert(0, str(Path(__file__).parent / "support"))

# How long examples take says more of the machine than of gantline. Which ones there are is said by
# `--hypothesis-seed` alone, as `make test` does: not by what failed here before, and not by the name of the
# test, as hypothesis has it by itself where an environment says that it is continuous integration.
settings.register_profile(
    "gantline",
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow],
    database=None,
    derandomize=False,
)
settings.load_profile("gantline")


@pytest.fixture
def player(monkeypatch: pytest.MonkeyPatch) -> None:
    """A program in place of the player of reports, whether that is built here or not."""
    from gantline.viewer.bundle import Bundle

    monkeypatch.setattr("gantline.report.page.bundle", lambda: Bundle("run()", ""))
