"""Tables of cases: one line for each case, and the worst case of each element."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from typing import Protocol

from gantline.checks import Check, governing
from gantline.cli.case_names import (
    AS_GIVEN,
    SHORTEST_LABEL,
    case_name,
    is_numbered,
    listed_names,
    numbered_in,
    told_apart,
)
from gantline.cli.friction import fails_as_it_slides
from gantline.cli.table import ABSENT, show, table, tables
from gantline.results.file.saved import WORST_OF_LOSSES
from gantline.scenario.file.case import ENVELOPE, TOLERANCE
from gantline.study.cases import CasesResult
from gantline.study.state import QUANTITIES, State, Worst, values_of

#: Share of its tension that margins add to a sling from which on they count beside others [1].
_ADDS = 0.01
#: What a line of the worst cases is called.
_LINES = {
    "sling_tension": "{} highest",
    "smallest_sling_tension": "{} lowest",
    "rope_tension": "{}",
    "hook_load": "{} hook load",
    "hoist_load": "{} hoist load",
    "load_tilt": "{} tilt",
    "sheave_travel": "{} travel",
    "rod_out": "{} rod out",
    "hinge_force": "{} force",
}
#: A number with its unit, and no part of a name.
_FIGURE = re.compile(
    r"(?<![\w.,+-])-?\d[\d,]*(?:\.\d+)?(?= (?:deg|%|mm|m|t|kg|kN|MN|N|s|kPa|MPa)(?![\w./]\w))"
)
_WITHOUT_LOSSES = "without losses"


class HasChecks(Protocol):
    """A state or a run that has been checked."""

    @property
    def checks(self) -> Sequence[Check]:
        """Its checks."""


def cases_table(result: CasesResult, *, width: int, variants: bool) -> list[str]:
    """All that is shown of cases.

    Args:
        result: The cases.
        width: Columns that a line may have.
        variants: Whether each variant has a line of its own.
    """
    groups: list[tuple[str, list[State]]]
    if variants:
        bounded = {(state.case, state.variant) for state in result.states if state.losses != "none"}
        groups = [(case_name(state.case, _label(state, bounded)), [state]) for state in result.states]
    else:
        by_case = {name: result.of(name) for name in result.names}
        groups = [
            (case_name(name, _count(states, is_whole=name not in result.not_done)), states)
            for name, states in by_case.items()
        ]

    def in_cases(places: Sequence[int]) -> str:
        return _in_cases(result.states, places)

    slides = fails_as_it_slides(result.states, "'gantline statics --held'")
    why = [
        *([f"  {WORST_OF_LOSSES}"] if result.has_losses and not variants else []),
        *notes(result.states, in_cases, width),
        *(line for told in slides for line in _told(told.strip(), width)),
        *_lines(_in_one(_cautions(result.states)), result.states, in_cases, width),
        *_overshoots(result, width),
        *_at_once(result, width),
    ]
    states, governed = _states(groups, width), nearest_to_limits(groups, width)
    numbered = numbered_in([name for name, _ in groups], [*states, *governed], width)
    parts = [
        [f"{result.title}, at rest", *_standing(result, width)],
        [*states, *why],
        governed,
        numbered,
        *_tensions(result, width),
        *_worst(result.worst, width, len(groups) if numbered else 0),
        *_bands(result),
        [_verdict(result)],
    ]
    return [line for part in parts if part for line in (*part, "")][:-1]


def _standing(result: CasesResult, width: int) -> list[str]:
    """That the lift as it is given stands in part at the time that is looked at."""
    if not result.given.partly_stands:
        return []
    when = f"at {show(result.given.time, 's', 1)} {' and '.join(result.given.partly_stands)}"
    sentence = (
        f"{when}: slings and hooks carry more where it hangs; '--time' asks for another moment, and "
        "'gantline statics --steps' lists how much hangs at the end of each step"
    )
    return textwrap.wrap(sentence, width, initial_indent="  ", subsequent_indent="    ")


def _states(groups: Sequence[tuple[str, Sequence[State]]], width: int) -> list[str]:
    """One line for each named group of states, with the worst of each quantity."""
    rows = [
        (
            "",
            show(_largest(states, "smallest_sling_tension", smallest=True), "kN", 1),
            show(_largest(states, "sling_tension"), "kN", 1),
            show(_largest(states, "hook_load"), "kN", 1),
            show(_largest(states, "load_tilt"), "deg", 2),
            show(_largest(states, "sheave_travel"), "m", 3),
            outcome(states),
        )
        for _, states in groups
    ]
    head = ("", "slings", "to", "hook load", "tilt", "travel", "")
    taken = max(len(line) for line in table(head, rows, "lrrrrrl"))
    room = max(SHORTEST_LABEL, width - taken)
    names = told_apart([name for name, _ in groups], room)
    named = [(name, *row[1:]) for name, row in zip(names, rows, strict=True)]
    return table(("Case", *head[1:]), named, "lrrrrrl")


def _count(states: Sequence[State], *, is_whole: bool) -> str:
    """How many states a case has, where it has not one, and that Ctrl-C kept others from being found."""
    if not is_whole:
        return f"{len(states)} of more"
    return str(len(states)) if len(states) > 1 else ""


def _label(state: State, bounded: Container[tuple[str, str]]) -> str:
    """Variant and losses; that there are none of a variant whose losses are `bounded` by others."""
    is_between = state.losses == "none" and (state.case, state.variant) in bounded
    return ", ".join(part for part in (state.label, _WITHOUT_LOSSES if is_between else "") if part)


def _largest(states: Iterable[State], quantity: str, *, smallest: bool = False) -> float | None:
    values = [value for state in states for value in values_of(state)[quantity].values()]
    if quantity == "sheave_travel":
        return max(values, key=abs, default=None)
    return min(values, default=None) if smallest else max(values, default=None)


def outcome(states: Sequence[State]) -> str:
    """What is wrong with the worst of some states, in a word."""
    if any(state.rest is None and state.starts for state in states):
        return "NONE"
    if any(not state.starts for state in states):
        return "NO START"
    if any(state.rest is not None and not state.rest.is_stable for state in states):
        return "UNSTABLE"
    if any(state.stands for state in states):
        return "STANDS"
    if any(state.failed for state in states):
        return "FAILED"
    # What is asked for and cannot be done; that a change leaves all as it was may be the answer.
    in_vain = all(state.changes_nothing and state.in_vain for state in states)
    return "NO CHANGE" if in_vain else "ok"


def notes(states: Sequence[State], where: Callable[[Sequence[int]], str], width: int) -> Iterator[str]:
    """Why states are not sound, change nothing, or warn of a limit that they are past, each reason once.

    Args:
        states: All of them.
        where: Says which some of them are, from their places among all, in order.
        width: Columns that a line may have.
    """
    reasons: dict[str, list[int]] = {}
    for place, state in enumerate(states):
        if state.rest is None:
            what = "no equilibrium" if state.starts else "cannot start"
            reasons.setdefault(f"{what}: {state.cause}", []).append(place)
        elif not state.rest.is_stable:
            reasons.setdefault(f"unstable: {state.rest.stability}", []).append(place)
        for load in state.stands:
            reasons.setdefault(f"{load} stands on its supports, and hangs as given", []).append(place)
        for check in state.failed:
            reasons.setdefault(f"{check} failed", []).append(place)
        for check in state.past:
            reasons.setdefault(f"{check} past a limit that only warns", []).append(place)
        for vain in state.in_vain:
            reasons.setdefault(f"nothing is cut: {vain}", []).append(place)
        if state.changes_nothing and not state.in_vain:
            reasons.setdefault("nothing changes: forces, tilts and checks are as given", []).append(place)
    yield from _lines(reasons, states, where, width)


def _lines(
    reasons: Mapping[str, Sequence[int]],
    states: Sequence[State],
    where: Callable[[Sequence[int]], str],
    width: int,
) -> Iterator[str]:
    """Each reason with the states that it is true of."""
    for reason, found in reasons.items():
        every = len(found) == len(states) and len(states) > 1
        yield from _told(f"{reason}: {'everywhere' if every else where(found)}", width)


def _in_one(cautions: Mapping[str, Sequence[int]]) -> dict[str, list[int]]:
    """Cautions that differ in their figures alone as one, with the least and the most of each figure.

    Not so what fails: there each case has its own figure, as the time of a cut.
    """
    alike: dict[str, list[str]] = {}
    for caution in cautions:
        alike.setdefault(_FIGURE.sub("0", caution), []).append(caution)
    return {
        _of_all(same): sorted({place for one in same for place in cautions[one]}) for same in alike.values()
    }


def _of_all(sentences: Sequence[str]) -> str:
    """A sentence in place of some that differ in their figures alone."""
    figures = iter(zip(*(_FIGURE.findall(one) for one in sentences), strict=True))

    def least_and_most(_: re.Match[str]) -> str:
        one = sorted(set(next(figures)), key=lambda figure: float(figure.replace(",", "")))
        return one[0] if len(one) == 1 else f"{one[0]} to {one[-1]}"

    return _FIGURE.sub(least_and_most, sentences[0])


def _told(line: str, width: int) -> Iterator[str]:
    """A sentence below a table, in lines of a width."""
    yield from textwrap.wrap(line, max(width, 60), initial_indent="  ", subsequent_indent="    ")


def _cautions(states: Sequence[State]) -> dict[str, list[int]]:
    """What else is to be known of checks, each caution once with the checks that have it, by state."""
    found: dict[str, tuple[list[str], list[int]]] = {}
    for place, state in enumerate(states):
        for check in state.checks:
            for caution in check.cautions:
                names, places = found.setdefault(caution, ([], []))
                names += [check.name] if check.name not in names else []
                places += [place] if place not in places else []
    return {f"{', '.join(names)}: {caution}": places for caution, (names, places) in found.items()}


def _overshoots(result: CasesResult, width: int) -> Iterator[str]:
    """How far the sling goes that goes farthest as others are cut, of each case that cuts some.

    Of one in which a load comes down on something, that what it does on the way is not known.
    """
    for state in result.states:
        if state.cut and state.stands and state.losses == "none":
            down = f"what slings bear as {', '.join(state.stands)} comes down is not in it"
            yield from _told(f"{state.case} is at rest: {down}; a run with 'cut_at' tells", width)
        if state.swings_to:
            sling, force = max(state.swings_to.items(), key=lambda one: one[1])
            goes = f"{sling} swings to {show(force, 'kN', 1)} on the way there, by twice what comes on"
            yield from _told(f"{state.case} is at rest: {goes}, undamped; a run with 'cut_at' tells", width)


def _at_once(result: CasesResult, width: int) -> Iterator[str]:
    """What a sling bears by the centre of gravity and by lengths at once, where both add to it.

    Each case changes one thing: the sling for which the sum of both is the most, to first order.
    """
    most: dict[tuple[str, str], tuple[float, str]] = {}
    for state in result.states:
        for sling, force in values_of(state)["sling_tension"].items() if state.margins else ():
            most[state.margins, sling] = max(most.get((state.margins, sling), (0.0, "")), (force, state.case))
    found = []
    for sling, given in values_of(result.given)["sling_tension"].items():
        pair = [most.get((margins, sling), (0.0, "")) for margins in (ENVELOPE, TOLERANCE)]
        if all(force > (1.0 + _ADDS) * given for force, _ in pair):
            (one, first), (other, second) = pair
            found.append((one + other - given, sling, f"{first} and {second}"))
    if found:
        force, sling, cases = max(found)
        bears = f"with {cases} at once {sling} bears some {show(force, 'kN', 1)}, to first order"
        yield from _told(f"a case changes one thing: {bears}; a 'vary' of several paths tells", width)


def _in_cases(states: Sequence[State], found: Sequence[int]) -> str:
    """Cases that some states belong to, and how many of each."""
    parts = []
    for case in dict.fromkeys(states[place].case for place in found):
        some = sum(states[place].case == case for place in found)
        every = sum(state.case == case for state in states)
        parts.append(case_name(case, f"{some} of {every}" if every > 1 else ""))
    return ", ".join(parts)


def nearest_to_limits(groups: Sequence[tuple[str, Sequence[HasChecks]]], width: int) -> list[str]:
    """The check of each group of states, or runs, that uses most of its limit."""
    rows = {}
    for place, (_, states) in enumerate(groups):
        check = governing([check for state in states for check in state.checks])
        if check is not None:
            used = ABSENT if check.utilisation is None else show(check.utilisation, "%", 1)
            rows[place] = (check.name, used, check.element)
    if not rows:
        return []
    head = ("Nearest to a limit", "check", "used", "by")
    others = max(len(line) for line in table(("", *head[1:]), [("", *row) for row in rows.values()], "llrl"))
    names = told_apart([name for name, _ in groups], max(SHORTEST_LABEL, width - others))
    return table(head, [(names[place], *row) for place, row in rows.items()], "llrl")


def _tensions(result: CasesResult, width: int) -> list[list[str]]:
    """The largest tension of each sling and rope in each case."""
    by_case = {name: [values_of(state) for state in result.of(name)] for name in result.names}
    names = {
        quantity: list(
            dict.fromkeys(name for many in by_case.values() for one in many for name in one[quantity])
        )
        for quantity in ("sling_tension", "rope_tension")
    }
    ropes = [(quantity, name) for quantity, of in names.items() for name in of]
    columns = []
    for case, many in by_case.items():
        highest = (
            max((one[quantity][name] for one in many if name in one[quantity]), default=None)
            for quantity, name in ropes
        )
        columns.append([case or AS_GIVEN, *(show(value, "kN", 1) for value in highest)])
    return tables(["Highest tension", *(name for _, name in ropes)], columns, width=width) if ropes else []


def _worst(worst: Sequence[Worst], width: int, numbered: int) -> list[list[str]]:
    """The worst case of each element, and what variants are whose names are cut off alike.

    Those have numbers behind the first few, `numbered`, which others have already.
    """
    rows = []
    for one in worst:
        unit, digits = QUANTITIES[one.quantity]
        # A hook that bears its load and nothing else has the same twice.
        if one.quantity == "hoist_load" and _repeats(one, worst):
            continue
        share = f"{one.value / one.given:.3f}" if one.given and unit == "kN" else ABSENT
        given, value = show(one.given, unit, digits), show(one.value, unit, digits)
        # What nobody can tell from the lift as it is given has no case for its cause.
        label = AS_GIVEN if value == given else case_name(one.state.case, one.state.label)
        rows.append((_LINES[one.quantity].format(one.element), given, value, share, label))
    if not rows:
        return [[]]
    head = ("Worst case", AS_GIVEN, "worst", "of it", "in")
    taken = max(len(line) for line in table(head, [(*row[:4], "") for row in rows], "lrrrl")) + 2
    room = max(SHORTEST_LABEL, width - taken)
    long = [label for label in dict.fromkeys(row[4] for row in rows) if len(label) > room]
    names = dict(zip(long, told_apart(long, room, numbered), strict=True))
    lines = table(head, [(*row[:4], names.get(row[4], row[4])) for row in rows], "lrrrl")
    return [lines, listed_names(long, width, numbered) if is_numbered(names.values(), numbered) else []]


def _repeats(hoist: Worst, worst: Sequence[Worst]) -> bool:
    same = (one for one in worst if one.quantity == "hook_load" and one.element == hoist.element)
    return any(one.value == hoist.value for one in same)


def _bands(result: CasesResult) -> Iterator[list[str]]:
    """Tensions over the patterns of lengths of each case, by sensitivities and solved anew.

    Those are about the lift without losses.
    """
    given = values_of(result.given)["sling_tension"]
    is_bounded = any(state.losses != "none" for state in result.of(""))
    about = _WITHOUT_LOSSES if is_bounded else AS_GIVEN
    for name in result.names:
        states = [state for state in result.of(name) if state.first_order]
        if not states:
            continue
        solved = [values_of(state)["sling_tension"] for state in states]
        rows = [
            (
                sling,
                show(given.get(sling), "kN", 1),
                _band(state.first_order[sling] for state in states),
                _band(values[sling] for values in solved if sling in values),
            )
            for sling in states[0].first_order
        ]
        yield table((name, about, "by sensitivities", "solved anew"), rows, "lrrr")


def _band(values: Iterable[float]) -> str:
    known = list(values)
    if not known:
        return ABSENT
    return f"{min(known) / 1e3:z.1f} to {show(max(known), 'kN', 1)}"


def _verdict(result: CasesResult) -> str:
    counts = {
        "no equilibrium": 0,
        "cannot start": 0,
        "unstable": 0,
        "on its supports": 0,
        "failed a check": 0,
    }
    for state in result.states:
        if state.rest is None:
            counts["no equilibrium" if state.starts else "cannot start"] += 1
        elif not state.rest.is_stable:
            counts["unstable"] += 1
        elif state.stands:
            counts["on its supports"] += 1
        elif state.failed:
            counts["failed a check"] += 1
    idle = sum(all(state.changes_nothing for state in result.of(name)) for name in result.names)
    without = f"; {idle} case{'' if idle == 1 else 's'} changed nothing" if idle else ""
    bad = ", ".join(f"{count} {what}" for what, count in counts.items() if count)
    cases = len(result.names) - 1
    head = f"{cases} case{'' if cases == 1 else 's'}, {len(result.states)} equilibria asked for"
    if result.not_done:
        head = f"interrupted, not all was asked of {', '.join(result.not_done)}; {head}"
        bad = bad or "those sound"
    return f"{head}: {bad or nothing_hangs(result.states) or 'all sound'}{without}"


def nothing_hangs(states: Sequence[State]) -> str:
    """That no load hangs in any of these states, and why: nothing tells what carries one; else empty."""
    if not all(state.not_lifted for state in states):
        return ""
    return f"nothing hangs then, {'; '.join(states[0].not_lifted)}; '--time' asks for another moment"
