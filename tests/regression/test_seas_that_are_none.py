"""`gantline seas` in seas that are all too steep to be ended with 0, as if the lift were a go in them.

It "simulated 0 s" in each, and said by how much one more record might be worse than those that were not run.
"""

from __future__ import annotations

from verbs import gantline


def test_no_verdict_where_there_is_no_such_sea() -> None:
    result = gantline("seas", "crane_barge_in_swell", "--height", "20 m")
    assert result.exit_code == 4, result.stdout
    said = " ".join(result.stdout.split())
    assert "too steep: there are no such waves (DNV-RP-C205, 3.5.4)" in said
    assert "1 record of each sea, 300 s; share of the limit" in said
    assert "the chance that one more" not in said
