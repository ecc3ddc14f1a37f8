"""`explicit` began a lift over sheaves with losses and no inertia, and then ended it as singular.

It refuses friction, but looked for it among rows with forces of their own; those of light sheaves have none.
"""

from __future__ import annotations

import pytest

from lossy_rigs import CAPSTAN, atwood
from mechanics import simulation


@pytest.mark.parametrize("inertia", [0.0, 10.0], ids=["light", "inertia"])
def test_explicit_refuses_losses_of_sheaves(inertia: float) -> None:
    with pytest.raises(ValueError, match=r"explicit knows no friction of sheaves, .* such as that of sheave"):
        simulation(atwood(10.0, 20.0, inertia, ratio=CAPSTAN), 1.0, type="explicit")
