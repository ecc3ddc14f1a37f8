"""What one lift in ten comes to, from the checks of some records."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from gantline.checks import Check, Verdict
from gantline.results.file.saved_seas import SavedExtreme
from gantline.study import Gumbel, Sea, SeaRecord

VALUES = (10.0, 12.0, 11.0, 15.0, 10.5)
#: By (SE2): b0 = 11.7, b1 = (10.5 + 2·11 + 3·12 + 4·15)/4/5 = 6.425; (2 b1 − b0)/ln 2 and b0 − γ·scale.
SCALE = 1.15 / np.log(2.0)
LOCATION = 11.7 - 0.5772156649015329 * SCALE
#: −ln(−ln 0.9).
REDUCED = 2.2503673273124454


def sea(values: Any = VALUES, **words: Any) -> Sea:
    """A sea of one record for each of these values of a check with a limit of 20."""
    whole: dict[str, Any] = {"limit": 20.0, **words}
    checks = [Check("load", Verdict.OK, "a load", value=value, element="L", **whole) for value in values]
    return Sea(
        1.0, 8.0, 0.0, 9.0, [SeaRecord(number=number, checks=[one]) for number, one in enumerate(checks, 1)]
    )


def test_by_hand() -> None:
    gumbel = Gumbel.of(VALUES)
    assert gumbel.scale == pytest.approx(SCALE, rel=1e-12)
    assert gumbel.location == pytest.approx(LOCATION, rel=1e-12)
    assert gumbel.exceeded_by(0.1) == pytest.approx(LOCATION + REDUCED * SCALE, rel=1e-12)
    error = SCALE * np.sqrt((1.1128 + 0.4574 * REDUCED + 0.8046 * REDUCED**2) / 5)
    assert gumbel.error(0.1) == pytest.approx(error, rel=1e-12)


def test_of_a_largest_value_that_is_allowed() -> None:
    (found,) = sea().extremes()
    assert found.check.value == 15.0
    assert found.value == pytest.approx(LOCATION + REDUCED * SCALE, rel=1e-12)
    assert found.utilisation == pytest.approx(found.value / 20.0, rel=1e-12)
    assert found.utilisation_error == pytest.approx(found.error / 20.0, rel=1e-12)
    (rarer,) = sea().extremes(0.01)
    assert rarer.value > found.value


def test_of_a_smallest_value_that_is_allowed() -> None:
    """What is worse is smaller: minus the values have the distribution, the share is limit/value."""
    (found,) = sea([30.0 - value for value in VALUES], at_least=True, limit=5.0).extremes()
    assert found.check.value == 15.0
    assert found.value == pytest.approx(30.0 - (LOCATION + REDUCED * SCALE), rel=1e-12)
    assert found.utilisation == pytest.approx(5.0 / found.value, rel=1e-12)
    assert found.utilisation_error == pytest.approx(5.0 / found.value**2 * found.error, rel=1e-12)


def test_values_that_are_all_alike_have_no_spread() -> None:
    (found,) = sea([0.1 + 0.2] * 7).extremes()
    assert found.value == pytest.approx(0.1 + 0.2, rel=4e-16)  # that of a mean of seven
    assert found.error == 0.0


@pytest.mark.parametrize(
    "none",
    [
        sea(VALUES[:4]),
        sea([*VALUES, None]),
        sea([*VALUES, np.inf]),
        Sea(1.0, 8.0, 0.0, 9.0, [*sea().records, *sea(limit=21.0).records]),
        Sea(1.0, 8.0, 0.0, 9.0, [*sea().records, SeaRecord(number=6)]),
        Sea(1.0, 8.0, 0.0, 9.0, [*sea().records, SeaRecord(number=6, cause="a rope parted")]),
        Sea(1.0, 8.0, 0.0, 9.0),
    ],
    ids=["four", "no value", "infinite", "other limits", "not checked in one", "stopped in one", "not run"],
)
def test_what_has_none(none: Sea) -> None:
    assert none.extremes() == []
    assert none.to_json()["extremes"] == []


@pytest.mark.parametrize("share", [0.0, 1.0, -0.1, float("nan")])
def test_no_such_share(share: float) -> None:
    with pytest.raises(ValueError, match="none between 0 and 1"):
        sea().extremes(share)


def test_without_a_limit_there_is_a_value() -> None:
    (found,) = sea(limit=None).extremes()
    assert found.value == pytest.approx(LOCATION + REDUCED * SCALE, rel=1e-12)
    assert (found.utilisation, found.utilisation_error) == (None, None)


def test_none_of_a_sea_in_which_a_run_gave_up() -> None:
    """What it would have come to is not known, also where its checks have values."""
    whole = sea()
    gave_up = SeaRecord(number=1, checks=whole.records[0].checks, cause="it gave up")
    assert whole.extremes()
    assert replace(whole, records=[gave_up, *whole.records[1:]]).extremes() == []


@pytest.mark.parametrize(
    ("used", "error", "shown"),
    [(0.914, 0.023, "91 ± 2 %"), (0.914, 0.004, "91.4 ± 0.4 %"), (1.0004, 0.02, "100.04 ± 2.00 %")],
)
def test_shares_as_people_read_them(used: float, error: float, shown: str) -> None:
    assert SavedExtreme(used, error, "load", "L").share == shown
