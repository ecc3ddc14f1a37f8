"""A sling that was cut before it carried anything, and a case that said "ok".

What a case cuts at a time of its own was held against the lift as it is given at that time only where a
step puts the rope on, takes it off or cuts it. A load of 20 t on four slings that are slack as the plan
begins, `{cut: D, at_step: hoist}`: its line had 0.0 kN and ended with `ok`, the last line was `all sound`,
and the program ended with 0, as if the load hung as well without D. Cut while it hangs, D leaves two of
the others with twice what they had.
"""

from __future__ import annotations

from pathlib import Path

from four_slings import LIFT
from gantline.scenario import parse_scenario
from gantline.study import run_cases
from verbs import gantline

#: From the hook to a lug, 8 m below it: sqrt(2.5^2 + 1.5^2 + 8^2) = 8.515 m, and a sling has 8.6 m. It is
#: slack until the hook is sqrt(8.6^2 - 2.5^2 - 1.5^2) - 8 = 0.0909 m higher, at 1 m/min after 5.5 s at least.
CASES = """
cases:
  at_once: {cut: A, at_step: lift off}
  slack: {cut: [A, D], at: 5 s}
  taut: {cut: A, at: 60 s}
"""


def test_nothing_is_cut_of_what_is_slack_then() -> None:
    found = run_cases(parse_scenario(LIFT + CASES))
    (at_once,), (slack,), (taut,) = (found.of(name) for name in ("at_once", "slack", "taut"))
    assert at_once.changes_nothing and at_once.in_vain == ("A carries nothing at 0 s as given",)
    assert slack.changes_nothing and slack.in_vain == tuple(
        f"{name} carries nothing at 5 s as given" for name in "AD"
    )
    assert not taut.changes_nothing and taut.in_vain == ()


def test_the_table_says_so(tmp_path: Path) -> None:
    path = tmp_path / "lift.yaml"
    path.write_text(LIFT + CASES, encoding="utf-8")
    lines = [line.split() for line in gantline("cases", str(path)).stdout.splitlines()]
    ends = [line[0] for line in lines if line[-2:] == ["NO", "CHANGE"]]
    assert ends == ["at_once", "slack"]
