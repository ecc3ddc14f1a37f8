import gc
import sys
from collections.abc import Iterator
from functools import cache, lru_cache
from pathlib import Path

import pytest
import typer.main
import typer.testing
from hypothesis import HealthCheck, settings

# Builders that several test modules share (`import sample_lift`).
sys.path.insert(0, str(Path(__file__).parent / "support"))
# What fails in it says with which values, as in a test.
pytest.register_assert_rewrite("promises")

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

# What tests and modules are made of stays until the end: looking through it, again and again, for what nobody
# needs any more took a tenth of the time of all tests.
gc.set_threshold(50_000)


def pytest_collection_finish() -> None:
    """Thousands of tests are there by now, and will be at the end."""
    gc.collect()
    gc.freeze()


@pytest.fixture(autouse=True, scope="session")
def _one_command() -> Iterator[None]:
    """The command `gantline` is made of its verbs once for all tests that call it, and not for each call."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(typer.testing, "_get_command", cache(typer.main.get_command))
        yield


@pytest.fixture(autouse=True, scope="session")
def _one_reading() -> Iterator[None]:
    """A lift file's text that was read without a fault gives the same scenario, which cannot be changed.

    Those that come with gantline are read, with all their cases, by hundreds of tests.
    """
    from gantline.scenario.file import reading

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(reading, "_parsed", lru_cache(maxsize=64)(reading._parsed))
        yield


@pytest.fixture
def occt_loaded(monkeypatch: pytest.MonkeyPatch) -> None:
    """STEP and IGES are read by a program that need not load Open CASCADE first."""
    from occt_loaded import LOADED

    monkeypatch.setattr("gantline.cad.step.subprocess", LOADED)


@pytest.fixture
def player(monkeypatch: pytest.MonkeyPatch) -> None:
    """A program in place of the player of reports, whether that is built here or not."""
    from gantline.viewer.bundle import Bundle

    monkeypatch.setattr("gantline.report.page.bundle", lambda: Bundle("run()", ""))


@pytest.fixture
def blank_pictures(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pictures are made and their files written, but nobody looks at them: their pixels are not computed."""
    import numpy as np
    from PIL import Image

    monkeypatch.setattr("gantline.plot.pictures._drawn", lambda figure: Image.new("RGB", (1, 1)))
    paper = np.ones((1, 1, 4)), (0.0, 1.0, 0.0, 1.0)
    monkeypatch.setattr("gantline.plot.model.rendered", lambda *_: paper)
