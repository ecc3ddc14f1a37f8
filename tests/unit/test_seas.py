"""A lift in the seas of a grid: what is run, what is left out, and what is told of it."""

from __future__ import annotations

import json
import pickle
import re
from typing import Any

import pytest

from column_in_waves import ALIKE, SEA, STRENGTH, column
from gantline import Simulation, simulate
from gantline.checks import Check, Outcome, Verdict, check_recording
from gantline.cli.seas_table import seas_table
from gantline.results.file.saved_seas import SavedSea, SavedSeas, degrees
from gantline.scenario import Scenario, parse_scenario
from gantline.study import SeasResult, run_seas
from gantline.study.sea import NoSeaError, Sea, SeaRecord


def lift(waves: str = SEA, **words: Any) -> Scenario:
    return parse_scenario(column(waves, duration="20 s", **words))


def outcomes(found: SeasResult) -> list[str | None]:
    return [sea.outcome and sea.outcome.value for sea in found.seas]


def test_each_record_is_a_run_of_the_changed_lift_file() -> None:
    """Record 2 has the seed after that of the file."""
    given = lift()
    found = run_seas(given, heights=[1.5], periods=[8.0], directions=[0.5], records=2)
    (sea,) = found.seas
    for record, seed in zip(sea.records, (1, 2), strict=True):
        changes = {"significant_height": "1.5 m", "peak_period": "8 s", "direction": "0.5 rad", "seed": seed}
        same = simulate(given.changed({f"waves.swell.{key}": value for key, value in changes.items()}))
        assert [(one.name, one.value) for one in record.checks] == [
            (one.name, one.value) for one in check_recording(same)
        ]
    assert sea.records[0].checks != sea.records[1].checks
    assert sea.worst in sea.records


def test_gusts_have_other_records_too() -> None:
    words = "wind: {speed: 8 m/s, direction: 0 deg, gusts: {speed: 12 m/s, seed: 5}}\n"
    given = parse_scenario(
        column(ALIKE, duration="20 s", more=words).replace(
            "  in_water:",
            "  wind_areas: {side: {area: 20 m^2, coefficient: 1, along: x}}\n  in_water:",
        )
    )
    (sea,) = run_seas(given, records=2).seas
    same = simulate(given.changed({"wind.gusts.seed": 6}))
    assert [one.value for one in sea.records[1].checks] == [one.value for one in check_recording(same)]


@pytest.mark.parametrize(
    ("verdicts", "outcome", "allowed", "refused"),
    [
        ((Verdict.OK, Verdict.OK), Outcome.GO, True, False),
        ((Verdict.OK, Verdict.WARNING), Outcome.GO_WITH_WARNINGS, True, False),
        ((Verdict.OK, Verdict.FAILED, Verdict.WARNING), Outcome.NO_GO, False, True),
        ((Verdict.OK, None), Outcome.NO_GO, False, True),
    ],
)
def test_the_worst_of_its_records_is_the_outcome_of_a_sea(
    verdicts: tuple[Verdict | None, ...], outcome: Outcome, allowed: bool, refused: bool
) -> None:
    """None stands for a lift that could not go on, which has no checks and is no go."""
    records = [
        SeaRecord(number=number, cause="it sank")
        if verdict is None
        else SeaRecord(number=number, checks=[Check("sling_tension", verdict, "", value=1.0, limit=2.0)])
        for number, verdict in enumerate(verdicts, 1)
    ]
    sea = Sea(2.0, 8.0, 0.0, 5.0, records)
    assert (sea.outcome, sea.is_allowed, sea.is_refused) == (outcome, allowed, refused)
    assert sea.worst is not None and sea.worst.outcome is outcome


@pytest.mark.parametrize(
    ("verdicts", "allowed"),
    [
        ((Verdict.OK, Verdict.WARNING, Verdict.FAILED), 2.0),
        ((Verdict.OK, Verdict.FAILED, Verdict.OK), 1.0),
        ((Verdict.FAILED, Verdict.OK, Verdict.OK), None),
    ],
)
def test_no_height_beyond_one_that_is_no_go_is_allowed(
    verdicts: tuple[Verdict, ...], allowed: float | None
) -> None:
    """Seas of 1, 2 and 3 m; what a period suits may pass where a lower sea does not."""
    checks = [Check("sling_tension", verdict, "", value=1.0, limit=2.0) for verdict in verdicts]
    seas = [
        Sea(height, 8.0, 0.0, 5.0, [SeaRecord(number=1, checks=[check])])
        for height, check in zip((1.0, 2.0, 3.0), checks, strict=True)
    ]
    found = SeasResult("a lift", "", "swell", is_regular=False, records=1, seas=seas)
    assert found.allowed_height(0.0, 8.0) == allowed


def test_no_higher_sea_is_run_than_the_first_that_is_no_go() -> None:
    """The lift weighs some 780 kN in still water: a little less is allowed."""
    given = lift(ALIKE, least="770 kN")
    heights = [4.0, 0.1, 2.0, 3.0]  # are put in order
    stopped = run_seas(given, heights=heights, periods=[6.0])
    assert stopped.heights == (0.1, 2.0, 3.0, 4.0)
    assert outcomes(stopped) == ["GO", "NO-GO", None, None]
    every = run_seas(given, heights=heights, periods=[6.0], all_heights=True, workers=1)
    assert outcomes(every) == ["GO", "NO-GO", "NO-GO", "NO-GO"]
    assert every.seas[:2] == stopped.seas[:2], "no matter how many work at a time"
    assert stopped.allowed_height(0.0, 6.0) == every.allowed_height(0.0, 6.0) == 0.1
    assert not stopped.is_allowed
    with pytest.raises(KeyError, match="no sea with a direction"):
        stopped.allowed_height(1.0, 6.0)


@pytest.mark.parametrize(
    ("waves", "highest"),
    [(SEA, 9.81 * 16 / (2 * 3.141592653589793) / 15), (ALIKE, 0.142 * 9.81 * 16 / (2 * 3.141592653589793))],
)
def test_there_are_no_steeper_waves(waves: str, highest: float) -> None:
    """At 4 s: 1/15 of the length in deep water (DNV-RP-C205, 3.5.4); alike 0.142 of it (Michell)."""
    found = run_seas(lift(waves), heights=[0.99 * highest, 1.01 * highest], periods=[4.0])
    assert [sea.highest for sea in found.seas] == pytest.approx([highest, highest])
    assert outcomes(found) == ["GO", None]
    assert [sea.is_too_steep for sea in found.seas] == [False, True]
    assert found.is_allowed, "in all seas that there are"


def test_a_sea_in_which_the_lift_cannot_start_says_why(monkeypatch: pytest.MonkeyPatch) -> None:
    """Such as waves shorter than a database of a vessel knows."""
    prepare = Simulation.__init__

    def refuses(self: Simulation, given: Scenario, **settings: Any) -> None:
        if given.waves is not None and given.waves["swell"].main_height > 0.6:
            raise given.error(("waves", "swell"), "these are too short for it")
        prepare(self, given, **settings)

    monkeypatch.setattr(Simulation, "__init__", refuses)
    found = run_seas(
        lift("{significant_height: 0.5 m, peak_period: 7 s, direction: 0 deg}"), heights=[0.5, 1.0]
    )
    assert outcomes(found) == ["GO", "NO-GO"]
    (record,) = found.seas[1].records
    assert not record.starts
    assert record.cause == "waves.swell: these are too short for it"
    assert SavedSeas.from_json(found.to_json()).seas[1].told == "NO START"


def test_a_run_that_cannot_go_on_is_no_go(monkeypatch: pytest.MonkeyPatch) -> None:
    from gantline.simulation import SimulationError

    run = Simulation.run

    def breaks(self: Simulation, **how: Any) -> Any:
        recording = run(self, **how)
        raise SimulationError(recording, 3.0, "sling.S1", "it gave up", b"")

    monkeypatch.setattr(Simulation, "run", breaks)
    found = run_seas(lift(), heights=[0.5, 1.0])
    assert outcomes(found) == ["NO-GO", None]
    (record,) = found.seas[0].records
    assert record.starts and "it gave up" in record.cause
    saved = SavedSeas.from_json(found.to_json())
    assert saved.seas[0].told == "STOPPED"
    assert saved.seas[0].share == ""


def test_ctrl_c_keeps_what_there_is(monkeypatch: pytest.MonkeyPatch) -> None:
    """A sea of which a record is missing has not been run."""
    run, runs = Simulation.run, []

    def interrupted(self: Simulation, **how: Any) -> Any:
        runs.append(self)
        if len(runs) > 3:
            raise KeyboardInterrupt
        return run(self, **how)

    monkeypatch.setattr(Simulation, "run", interrupted)
    found = run_seas(lift(), heights=[0.5, 1.0, 1.5], records=2, workers=1)
    assert found.interrupted
    assert outcomes(found) == ["GO", None, None]
    assert not found.is_allowed


def test_a_lift_whose_gear_is_not_known_gives_no_verdict() -> None:
    text = column(SEA, duration="20 s")
    for strength in (", capacity: 150 t", "    rated_capacity: 150 t\n", STRENGTH):
        text = text.replace(strength, "")
    given = parse_scenario(text)
    found = run_seas(given, heights=[0.5, 1.0])
    assert outcomes(found) == ["NO VERDICT", "NO VERDICT"]
    assert found.allowed_height(0.0, 7.0) is None
    saved = SavedSeas.from_json(found.to_json())
    assert [sea.told for sea in saved.seas] == ["no verdict", "no verdict"]
    stopper = saved.stopper(0.0, 7.0)
    assert stopper is not None and stopper.verdict.startswith("NO VERDICT: no force has been held")


@pytest.mark.parametrize(
    ("asked", "expected"),
    [
        ({"waves": "sea"}, "waves: the lift has no 'sea'; it has swell"),
        ({"heights": []}, "heights: there are none"),
        ({"heights": [0.0]}, "heights: 0 is none that waves can have"),
        ({"periods": [-1.0]}, "periods: -1 is none that waves can have"),
        ({"directions": [float("nan")]}, "directions: nan is none that waves can have"),
        ({"records": 0}, "records: 0 are none"),
    ],
)
def test_what_cannot_be_asked(asked: dict[str, Any], expected: str) -> None:
    with pytest.raises(NoSeaError) as refused:
        run_seas(lift(), **asked)
    assert str(refused.value) == expected
    assert pickle.loads(pickle.dumps(refused.value)).sentence == refused.value.sentence


def test_which_waves_are_meant() -> None:
    with pytest.raises(NoSeaError, match="records: waves that are all alike"):
        run_seas(lift(ALIKE), records=2)
    without = parse_scenario(column(duration="20 s").replace("waves:\n  swell: " + ALIKE + "\n", ""))
    with pytest.raises(NoSeaError, match="waves: there are none in this lift"):
        run_seas(without)
    two = parse_scenario(column(f"{ALIKE}\n  wind_sea: {SEA}", duration="20 s"))
    with pytest.raises(NoSeaError, match="waves: the lift has swell, wind_sea; name one of them"):
        run_seas(two)
    found = run_seas(two, waves="wind_sea", heights=[0.5], records=2)
    assert found.waves == "wind_sea" and not found.is_regular
    assert len(found.seas[0].records) == 2


def test_numbers_as_json_are_those_of_tables() -> None:
    """What tables, pictures and reports show is read from it."""
    found = run_seas(lift(least="781 kN"), heights=[0.1, 2.0], periods=[5.0, 6.0], records=2)
    document = json.loads(json.dumps(found.to_json(), allow_nan=False))
    saved = SavedSeas.from_json(document)
    assert saved.heights == found.heights
    assert saved.periods == found.periods
    for sea, shown in zip(found.seas, saved.seas, strict=True):
        assert (shown.height, shown.period, shown.direction) == (sea.height, sea.period, sea.direction)
        assert shown.is_allowed is sea.is_allowed
        if sea.worst is not None:
            assert sea.worst.governing is not None
            assert (shown.record, shown.check) == (sea.worst.number, sea.worst.governing.name)
            assert shown.used == sea.worst.governing.utilisation
    assert saved.allowed == {key: found.allowed_height(*key) for key in saved.allowed}
    assert saved.records == 2
    assert saved.duration == 20.0


def test_a_height_that_records_keep_and_too_many_lifts_would_not() -> None:
    """It stays allowed, and the table says so."""
    document = run_seas(lift(), heights=[0.5]).to_json()
    used = {"check": "load_tilt", "element": "column", "utilisation": 1.042, "utilisation_error": 0.03}
    document["seas"][0]["extremes"] = [used, {**used, "utilisation": 0.9}, {**used, "utilisation": None}]
    lines = seas_table(SavedSeas.from_json(document), 100)
    assert any(re.search(r"0\.5 m +104 ± 3 % OVER +load_tilt column$", line) for line in lines)
    assert any(line.split() == ["allowed", "0.5", "m"] for line in lines)


@pytest.mark.parametrize(
    "spoil",
    [
        lambda document: document.pop("seas"),
        lambda document: document.update(records="two"),
        lambda document: document["seas"][0].pop("height"),
        lambda document: document["seas"][0].update(records=[3]),
        lambda document: document["allowed"].append(4),
        lambda document: document.pop("waves"),
    ],
)
def test_a_file_of_something_else_is_refused(spoil: Any) -> None:
    document = run_seas(lift(ALIKE), heights=[0.1]).to_json()
    spoil(document)
    with pytest.raises(ValueError, match=r"no list|no number|no text|an object"):
        SavedSeas.from_json(document)


@pytest.mark.parametrize(
    ("direction", "shown"), [(3.141592653589793, "180 deg"), (0.39269908169872414, "22.5 deg")]
)
def test_directions_as_people_read_them(direction: float, shown: str) -> None:
    assert degrees(direction) == shown


def test_the_worst_outcome_counts() -> None:
    found = run_seas(lift(), heights=[0.5])
    assert found.seas[0].outcome is Outcome.GO
    assert repr(found) == "<SeasResult 'A column in waves': 1 seas of 'swell', 1 of them run>"


@pytest.mark.parametrize(
    ("is_allowed", "used", "shown"),
    [(True, 0.9996, "100 %"), (False, 1.0004, "100.04 %"), (False, 1.34, "134 %"), (False, None, "")],
)
def test_a_sea_past_a_limit_does_not_read_as_if_at_it(
    is_allowed: bool, used: float | None, shown: str
) -> None:
    sea = SavedSea(
        height=1.5,
        period=8.0,
        direction=0.0,
        is_too_steep=False,
        is_allowed=is_allowed,
        is_refused=not is_allowed,
        record=1,
        used=used,
        check="load_tilt",
        element="load",
        cause="",
        starts=True,
        verdict="",
    )
    assert sea.share == shown
