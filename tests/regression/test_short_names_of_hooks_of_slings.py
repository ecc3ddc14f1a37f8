"""`U1` would do for a hook of a Goliath crane in the plan, and was no hook under `slings`.

A name means a hook by the same rule in both: its own, or the only one that ends so.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from gantline.scenario import ScenarioError, parse_scenario, resolve

SCENARIOS = Path(__file__).resolve().parents[2] / "scenarios"


def text_of(name: str, *replaced: tuple[str, str]) -> str:
    text = (SCENARIOS / name / "scenario.yaml").read_text(encoding="utf-8")
    for old, new in replaced:
        assert old in text
        text = text.replace(old, new)
    return text


def test_a_sling_hangs_from_a_hook_by_its_short_name() -> None:
    name = "crane_barge_in_swell"
    full, short = (parse_scenario(text_of(name, *new)) for new in ((), [("from: sheerleg.H1", "from: H1")]))
    hooks = [{sling: one.hook for sling, one in resolve(lift).slings.items()} for lift in (full, short)]
    assert hooks[0] == hooks[1]
    assert set(hooks[1].values()) == {"sheerleg.H1"}


def test_an_equalizer_does_too_and_slings_below_it() -> None:
    lift = resolve(parse_scenario(text_of("floating_crane", ("hangs_from: fc.H1", "hangs_from: H1"))))
    assert lift.equalizers["E1"].hook == "fc.H1"
    assert {one.hook for one in lift.slings.values() if one.equalizer == "E1"} == {"fc.H1"}


@pytest.mark.parametrize("text", ["H9", "1", "sheerleg"])
def test_what_means_no_hook_is_told(text: str) -> None:
    with pytest.raises(ScenarioError, match="neither a moving sheave nor a hook"):
        parse_scenario(text_of("crane_barge_in_swell", ("from: sheerleg.H1", f"from: {text}")))
