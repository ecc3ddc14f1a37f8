"""`title: Lift #3` was read as `Lift`, without a word: behind a blank, `#` begins a comment in YAML."""

from pathlib import Path

import pytest

from gantline.scenario import ScenarioError, parse_scenario
from gantline.scenario.file.tree import parse_text

LIFT = (Path(__file__).resolve().parents[2] / "scenarios" / "equalizer" / "scenario.yaml").read_text("utf-8")
TITLE = parse_scenario(LIFT).lift.title


def test_a_number_that_would_be_cut_off_is_told() -> None:
    assert f"title: {TITLE}" in LIFT
    text = LIFT.replace(f"title: {TITLE}", "title: Lift #3, second try")
    with pytest.raises(ScenarioError) as caught:
        parse_scenario(text)
    (problem,) = caught.value.problems
    assert (problem.line, problem.path) == (text[: text.index("#3")].count("\n") + 1, "lift.title")
    assert problem.sentence == (
        "'#3' behind a blank is a comment to YAML, and no part of 'Lift'; "
        "put the text into quotes, \"Lift #3\", or a blank behind the '#' of a comment"
    )


@pytest.mark.parametrize(
    ("written", "read"),
    [
        ('"Lift #3"', "Lift #3"),
        ("'Lift #3'", "Lift #3"),
        ("Lift#3", "Lift#3"),
        ("Lift  # 3 of 5", "Lift"),
        ("Lift  #second", "Lift"),
    ],
)
def test_quotes_and_comments_stand(written: str, read: str) -> None:
    assert parse_scenario(LIFT.replace(f"title: {TITLE}", f"title: {written}")).lift.title == read


def test_an_item_of_a_list_is_told_too() -> None:
    with pytest.raises(ScenarioError) as caught:
        parse_text("names:\n  - Lug #12b\n  - other\n", "lift.yaml")
    (problem,) = caught.value.problems
    assert (problem.line, problem.path) == (2, "names")
    assert '"Lug #12b"' in problem.sentence
