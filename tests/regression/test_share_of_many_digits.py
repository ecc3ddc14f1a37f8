"""A share of more characters than a message repeats, whose sign of per cent is the last of them.

`250 %` was read, and the same with sixty zeros after the point refused: '250.0000… is 250 %; a share is
written like …'. The sign was looked for in the text as the message would have shortened it.
"""

from __future__ import annotations

import pytest
from pydantic_core import PydanticCustomError

from gantline.scenario.quantities import Share


@pytest.mark.parametrize("zeros", [1, 80])
def test_a_share_keeps_its_sign_of_per_cent(zeros: int) -> None:
    """250/100 is 2.5 to the last digit."""
    assert Share().read(f"250.{'0' * zeros} %") == 2.5


@pytest.mark.parametrize("zeros", [1, 80])
def test_a_plain_number_above_two_is_none(zeros: int) -> None:
    """Whoever writes 95 means 95 %."""
    with pytest.raises(PydanticCustomError, match=r"^'95\.0+(\.\.\.)?' is 9500 %; "):
        Share().read(f"95.{'0' * zeros}")
