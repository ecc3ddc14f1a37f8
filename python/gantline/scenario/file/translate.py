"""From the validator's errors to sentences that a lifting engineer understands."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from pydantic_core import ErrorDetails

from gantline.scenario.errors import PathPart, Problem, closest, is_or_are, nearest, shorten
from gantline.scenario.file.tree import ListNode, MapNode, TextNode, problem_at
from gantline.scenario.plan.plan import VERBS
from gantline.scenario.plan.steps import HoistStep, HoldStep
from gantline.scenario.quantities import found

__all__ = ["translate"]

#: What people look for at another place of a lift file than where it is.
_ELSEWHERE = {
    "gravity": "it belongs to 'simulation': {gravity: 9.81 m/s^2}",
    "gusts": "gusts belong to 'wind': {speed: 10 m/s, direction: 0 deg, gusts: {speed: 14 m/s}}",
    "title": "it belongs to 'lift': {title: Four slings lift a module}",
}
#: Keys by other words, which are not written like them; the first that may stand there is meant.
_MEANT = {
    "active_heave_compensation": ("heave_compensation",),
    "acceptance": ("limits",),
    "ahc": ("heave_compensation", "compensate_heave"),
    "bend_diameter": ("bends_about",),
    "buoyancy": ("displaced_volume",),
    "ca": ("added_mass",),
    "chain_fall": ("chain_hoist",),
    "capacity": ("rated_capacity", "working_load_limit"),
    "cd": ("drag_coefficients",),
    "class": ("construction",),
    "cog": ("centre_of_gravity",),
    "criteria": ("limits",),
    "cs": ("slamming_coefficient",),
    "cylinder": ("chain_hoist",),
    "dia": ("diameter",),
    "dimensions": ("shape",),
    "disconnect": ("detach",),
    "distance": ("by",),
    "connect": ("attach",),
    "daf": ("dynamic_amplification_factor",),
    "drag": ("drag_coefficients",),
    "during": ("from_step",),
    "ea": ("axial_stiffness",),
    "gamma": ("peak_enhancement",),
    "hmax": ("height",),
    "hs": ("significant_height",),
    "in_step": ("from_step",),
    "height": ("to",),
    "hook": ("from", "cranes"),
    "hook_on": ("attach",),
    "hooks": ("cranes",),
    "hydraulic_cylinder": ("chain_hoist",),
    "inclination": ("load_tilt",),
    "jacks": ("drums",),
    "keel_blocks": ("supports",),
    "leveller": ("chain_hoist",),
    "lifting": ("hoist",),
    "lifting_points": ("lugs",),
    "load_leveller": ("chain_hoist",),
    "location": ("position", "at"),
    "lug": ("to",),
    "mass": ("weight", "calculated"),
    "mbf": ("minimum_breaking_force",),
    "mu": ("friction",),
    "operations": ("plan",),
    "position": ("at",),
    "pitch": ("load_tilt", "trim"),
    "pin_diameter": ("bends_about",),
    "put_on": ("attach",),
    "radius": ("diameter", "pitch_diameter", "sheave_diameter"),
    "schedule": ("plan",),
    "sea": ("waves",),
    "sequence": ("plan",),
    "size": ("shape",),
    "skl": ("skew_load_factor",),
    "slack": ("slings",),
    "slamming": ("slamming_coefficient",),
    "steps": ("plan",),
    "strand_jacks": ("drums",),
    "stiffness": ("axial_stiffness", "stops"),
    "stiffness_curve": ("curve",),
    "take_off": ("detach",),
    "taut": ("slings",),
    "tilt": ("load_tilt",),
    "tp": ("peak_period",),
    "turnbuckle": ("chain_hoist",),
    "unhook": ("detach",),
    "volume": ("displaced_volume",),
    "weight": ("mass",),
    "winch": ("chain_hoist",),
    "winches": ("drums",),
    "working_load_limit": ("rated_capacity", "capacity"),
    "wll": ("working_load_limit", "rated_capacity", "capacity"),
    # <!-- words: off -->
    "barge": ("vessels",),
    "barges": ("vessels",),
    "cable": ("rope",),
    "cables": ("ropes",),
    "chain_block": ("chain_hoist",),
    "elongation": ("curve",),
    "fixed_pulleys": ("fixed_sheaves",),
    "mbl": ("minimum_breaking_force",),
    "moving_pulleys": ("moving_sheaves",),
    "pad_eyes": ("lugs",),
    "padeyes": ("lugs",),
    "pulleys": ("sheaves",),
    "ship": ("vessels",),
    "ships": ("vessels",),
    "swl": ("working_load_limit", "rated_capacity", "capacity"),
    "wire": ("rope",),
    "wire_ropes": ("ropes",),
    "wires": ("ropes",),
    # <!-- words: on -->
}
_TANKS = (
    "liquid in it stands under its 'tanks', such as "
    "'tanks: {inside: {box: [4 m, 4 m, 3 m], bottom: [0 m, 0 m, 0 m], content: 20 t}}'"
)
_WET = "what water does to a load that is lowered into it stands under its 'in_water'"
_JONSWAP = "a sea has the spectrum of JONSWAP; with 'peak_enhancement: 1' it is that of Pierson and Moskowitz"
_OF_A_ROPE = "it belongs to a kind of rope under 'ropes', which the sling names by 'rope'"
_MEAN_PERIOD = (
    "a sea goes by its 'peak_period', which is 1.29 times its mean period of zero crossings for the usual "
    "'peak_enhancement' of 3.3, and 1.41 times for 1, a fully developed sea"
)
_IN_WATER = (
    "added_mass",
    "buoyancy",
    "displaced_volume",
    "drag",
    "drag_coefficient",
    "drag_coefficients",
    "hull",
    "slamming",
    "slamming_coefficient",
    "volume",
    "water_damping",
)
_SHEAVES = (
    "losses of its sheaves stand under 'sheaves', such as 'sheaves: {loss: 2 %}' or '{bearing: roller}'"
)
_OF_ITS_SHEAVES = (
    "bearing",
    "efficiency",
    "loss",
    "losses",
    "sheave_efficiency",
    "sheave_friction",
    "sheave_loss",
    "sheave_losses",
)
_MECHANICS = "it stands under 'mechanics'"
_BY_ROPE = "a drum has no place to go to; 'by' says how much rope it takes up or lets out"
_UPEND = "a load is upended by one hook that hoists or lowers, 'until: {load_tilt: {above: 80 deg}}'"
#: Sailors and forecasts say where it comes from.
_COMES_FROM = ("coming_from", "from", "from_direction")
_GOES_TO = (
    "'direction' is where it goes to, from world x towards y: what comes from 30 deg has 'direction: 210 deg'"
)
#: What people look for and is not there: what there is in its place, by what it is looked for in.
_INSTEAD = {
    "until": dict.fromkeys(
        ("sling_tension", "tension"),
        "no step waits for the tension of a sling; end it 'by' the length that 'gantline statics' finds, or "
        "wait for 'hoist_load' or 'load_tilt'",
    ),
    "a crane": {
        "vessel": "a fixed hook hangs in the world; a crane of 'type: floating_crane' is on a vessel",
        "winch": "a fixed hook moves by its 'hoist', or hangs in falls from a drum by 'reeving' and 'drum'",
    },
    "a rope": {
        **dict.fromkeys(("cd", "drag", "drag_coefficient"), "neither water nor wind drags at ropes here"),
        **dict.fromkeys(("bending_stiffness", "ei"), "ropes bend without resistance here"),
    },
    "a sling": dict.fromkeys(
        (
            "axial_stiffness",
            "construction",
            "diameter",
            "ea",
            "grade",
            "mass",
            "minimum_breaking_force",
        ),
        _OF_A_ROPE,
    ),
    "a hoist step": dict.fromkeys(("upend", "upending"), _UPEND),
    "a lower step": dict.fromkeys(("upend", "upending"), _UPEND),
    "a haul_in step": {"to": _BY_ROPE},
    "a pay_out step": {"to": _BY_ROPE},
    "a lift file": {
        **dict.fromkeys(("bodies", "body_contacts", "contacts", "drums"), _MECHANICS),
        **dict.fromkeys(("jacks", "strand_jacks", "winches"), "they are 'drums' under 'mechanics'"),
    },
    "an equalizer": dict.fromkeys(_OF_ITS_SHEAVES, _SHEAVES),
    "an equalizer type": dict.fromkeys(_OF_ITS_SHEAVES, _SHEAVES),
    "a vessel": dict.fromkeys(
        ("displacement_raos", "motion", "motion_file", "motions", "rao", "raos", "record", "time_series"),
        "RAOs of displacement stand in 'wave_motion: {raos: vessel.csv, phases: lag, at: [50 m, 0 m, 4 m]}', "
        "a motion over time in 'wave_motion: {record: motion.csv, at: [50 m, 0 m, 4 m]}'; "
        "'wave_forces' and 'radiation' name a hydrodynamic database, by which it answers what hangs from it",
    ),
    "limits": {
        **dict.fromkeys(
            ("clearance", "clearances", "distance", "distances"),
            "distances that have to be kept stand under 'watch', each with its 'smallest'",
        ),
        **dict.fromkeys(
            ("wind", "wind_limit", "wind_speed"),
            "the wind in which a crane may lift is its own 'wind_limit', held against that of the lift",
        ),
    },
    "wind": dict.fromkeys(_COMES_FROM, _GOES_TO),
    "current": dict.fromkeys(_COMES_FROM, _GOES_TO),
    "waves": {
        **dict.fromkeys(_COMES_FROM, _GOES_TO),
        **dict.fromkeys(
            ("mean_period", "tz", "zero_crossing_period", "zero_up_crossing_period"), _MEAN_PERIOD
        ),
        "spectrum": _JONSWAP,
        "type": _JONSWAP,
        "spreading": "waves run in one direction; several 'waves' with directions of their own spread a sea",
    },
    "a floating crane": dict.fromkeys(
        ("base_mass", "counterweight", "upper_mass"),
        "what slews with the boom stands under 'upper_masses' by name, each with 'mass' and 'at'",
    ),
    "the load": {
        **dict.fromkeys(("ballast", "content", "contents", "flooded", "liquid", "trapped_water"), _TANKS),
        **dict.fromkeys(_IN_WATER, _WET),
    },
}
#: What steps do, by other words.
_VERBS = {
    "deballast": "pump",
    "drain": "pump",
    "empty": "pump",
    "fill": "pump",
    "flood": "pump",
    "lengthen": "veer",
    "lift": "hoist",
    "move": "travel",
    "pause": "hold",
    "raise": "hoist",
    "rotate": "slew",
    "shorten": "haul",
    "swing": "slew",
    "take_in": "haul",
    "turn": "slew",
    "upend": "hoist",
    "wait": "hold",
}
#: What else is to be known of them.
_BESIDE = {"radius": ", twice as much"}


def translate(errors: Sequence[ErrorDetails], tree: MapNode) -> list[Problem]:
    """Problems for validation errors, with the lines of the tree that was validated."""
    whole = {**_nameless(errors, tree), **_sections_within(errors, tree)}
    depths = {len(path) for path in whole}
    told = [error for error in errors if not any(_locate(error["loc"], tree)[0][:d] in whole for d in depths)]
    misspelt = _misspelt(told, tree)
    return [*whole.values(), *(_problem(one, tree) for one in told if _place(one, tree) not in misspelt)]


def _place(error: ErrorDetails, tree: MapNode) -> tuple[PathPart, ...] | None:
    """Path of a key that is missing; None of any other error."""
    return (*_locate(error["loc"], tree)[0], error["loc"][-1]) if error["type"] == "missing" else None


def _misspelt(errors: Sequence[ErrorDetails], tree: MapNode) -> set[tuple[PathPart, ...] | None]:
    """Paths of the keys that unknown ones are told to be meant for: what is misspelt is not missing, too."""
    unknown = [_locate(error["loc"], tree) for error in errors if error["type"] == "extra_forbidden"]
    meant = ((path[:-1], _meant(str(path[-1]), around)) for path, _, around in unknown if around)
    return {(*path, key) for path, key in meant if key is not None}


def _sections_within(errors: Sequence[ErrorDetails], tree: MapNode) -> dict[tuple[PathPart, ...], Problem]:
    """Sections of a lift file that stand among the names of another one, and what to say of each."""
    told: dict[tuple[PathPart, ...], Problem] = {}
    for error in errors:
        path, _, around = _locate(error["loc"], tree)
        if len(path) < 2 or path[:2] in told or not isinstance(path[1], str):
            continue
        section, (names, given) = path[1], (around[1], around[1][path[1]])
        is_own = isinstance(given, MapNode) and any(key in given.allowed for key in given)
        if section in tree.allowed and section not in tree and not names.allowed and not is_own:
            wrong = f"'{section}' is not a name in '{path[0]}', but a section of {tree.what}"
            told[path[:2]] = problem_at(tree, path[:2], f"{wrong}: it stands too far in")
    return told


def _nameless(errors: Sequence[ErrorDetails], tree: MapNode) -> dict[tuple[PathPart, ...], Problem]:
    """Where keys of a thing stand in place of its name, by the path of the mapping, and what to say of it.

    Each of these keys, read as a name, is an error by itself, and so is all that stands below them.
    """
    told: dict[tuple[PathPart, ...], Problem] = {}
    for error in errors:
        context = error.get("ctx") or {}
        path, node, around = _locate(error["loc"], tree)
        if path[:-1] in told or not path or path[-1] not in context.get("keys", ()):
            continue
        names = around[-1]
        if not isinstance(names, MapNode) or names.allowed:
            continue
        key, what, section = path[-1], context["of"], shorten(str(path[-2])) if len(path) > 1 else ""
        value = shorten(str(node)) if isinstance(node, TextNode) else "…"
        right = f"{section}: {{first: {{{key}: {value}, …}}}}"
        wrong = f"'{key}' is a key of {what}, and stands where the name of one is needed"
        told[path[:-1]] = problem_at(
            tree, path, f"{wrong}; a name of yours comes before it, such as '{right}'"
        )
    return told


def _problem(error: ErrorDetails, tree: MapNode) -> Problem:
    loc = error["loc"]
    if "key" in (error.get("ctx") or {}):
        loc = (*loc, error["ctx"]["key"])
    path, node, around = _locate(loc, tree)
    return problem_at(tree, path, _sentence(error, node, around))


def _locate(loc: Sequence[PathPart], tree: MapNode) -> tuple[tuple[PathPart, ...], Any, list[Any]]:
    """Path in the file of a place in the models (tags of unions left out), its node, the nodes around it."""
    path: list[PathPart] = []
    node: Any = tree
    around: list[Any] = []
    for part in loc:
        inside = isinstance(node, MapNode) and part in node
        inside = inside or (isinstance(node, ListNode) and isinstance(part, int) and part < len(node))
        if inside:
            path.append(part)
            around.append(node)
            node = node[part]
    return tuple(path), node, around


def _sentence(error: ErrorDetails, node: Any, around: Sequence[Any]) -> str:
    kind = error["type"]
    context: Mapping[str, Any] = error.get("ctx") or {}
    last = str(error["loc"][-1]) if error["loc"] else ""
    if kind == "gantline":
        return error["msg"]
    if kind == "no_verb":
        return _no_verb(error["msg"], node)
    if kind == "missing":
        return _missing(last, node)
    if kind == "extra_forbidden":
        return _unknown_key(last, around)
    if kind == "literal_error":
        return f"found {found(node)}; right is {context.get('expected', 'another word')}"
    if kind in ("union_tag_invalid", "union_tag_not_found"):
        return _kind_of_thing(context, node)
    if kind == "too_short" and not context.get("actual_length"):
        return "is empty; leave it out or fill it"
    if kind == "too_short":
        return f"found {context['actual_length']} entries; at least {context['min_length']} needed"
    if kind in ("dict_type", "model_type", "model_attributes_type"):
        return f"found {found(node)}; a mapping is needed"
    if kind in ("list_type", "tuple_type"):
        return f"found {found(node)}; a list is needed"
    return f"found {found(node)}, which is not right here"


def _no_verb(sentence: str, node: Any) -> str:
    """What is to be said of a step that does nothing which is known here."""
    known = {*HoistStep.keys(), *HoldStep.keys()}
    for key in node if isinstance(node, MapNode) else ():
        if key in known:
            continue
        verb = _VERBS.get(key.lower()) or closest(key, VERBS)
        if verb is not None:
            return f"'{shorten(key)}' is not what a step can do; did you mean '{verb}'?"
    return sentence


def _missing(key: str, node: Any) -> str:
    if not isinstance(node, MapNode):
        return f"'{key}' is missing"
    if key == "format":
        return f"'{key}' is missing; a lift file begins with 'format: 1'"
    what = node.what or "this mapping"
    need = "need" if is_or_are(what) == "are" else "needs"
    return f"'{key}' is missing; {what} {need} it{_explained(key, node)}"


def _explained(key: str, node: MapNode) -> str:
    """What a key says, in brackets; nothing where that is no more than its name."""
    said = "" if node.explained is None else node.explained(key)
    if {*said.lower().split()} <= {*key.split("_"), "its", "the", "of"}:
        return ""
    first = said[0].lower() if said[1].islower() else said[0]
    return f" ({first}{said[1:]})"


def _at_other_level(key: str, around: Sequence[Any]) -> str | None:
    """What to say of a key that is right farther out, or one mapping farther in; None of another.

    Indented wrongly a key stands in another mapping.
    """
    parent = around[-1]
    wrong = f"'{shorten(key)}' is not a key of {parent.what}"
    for outer in reversed(around[:-1]):
        if isinstance(outer, MapNode) and key in outer.allowed and key not in outer:
            return f"{wrong}, but of {outer.what}: it stands too far in"
    for name, inner in parent.items():
        if isinstance(inner, MapNode) and key in inner.allowed and key not in inner:
            return f"{wrong}, but of '{shorten(str(name))}' in it: it stands too far out"
    return None


def _elsewhere(key: str, around: Sequence[Any]) -> str | None:
    """What to say of an unknown key in whose place there is something else; None of any other."""
    shown, parent = shorten(key), around[-1] if around else None
    if key in _ELSEWHERE:
        return f"'{shown}' has another place: {_ELSEWHERE[key]}"
    if not isinstance(parent, MapNode) or not parent.allowed:
        return f"'{shown}' is not a key that is known here"
    instead = _INSTEAD.get(parent.what or "", {}).get(key.lower())
    if instead is not None:
        return f"'{shown}' is not a key of {parent.what}: {instead}"
    return _at_other_level(key, around)


def _meant(key: str, around: Sequence[Any]) -> str | None:
    """The key of its mapping that an unknown one is told to be meant for, which is not given there."""
    if _elsewhere(key, around) is not None:
        return None
    parent = around[-1]
    unused = [name for name in parent.allowed if name not in parent] or list(parent.allowed)
    other_words = [name for name in _MEANT.get(key.lower(), ()) if name in parent.allowed]
    # Of all: beside `cranes`, `crane` is that, and not what is left and written most alike, `cases`.
    is_used = not other_words and closest(key, parent.allowed) not in (None, *unused)
    by_words = (name for name in other_words if name in unused)
    return next(by_words, None if is_used else closest(key, unused))


def _unknown_key(key: str, around: Sequence[Any]) -> str:
    elsewhere = _elsewhere(key, around)
    if elsewhere is not None:
        return elsewhere
    parent, meant = around[-1], _meant(key, around)
    wrong = f"'{shorten(key)}' is not a key of {parent.what}"
    if meant is not None:
        beside = _BESIDE.get(key.lower(), "") if meant in _MEANT.get(key.lower(), ()) else ""
        return f"{wrong}; did you mean '{meant}'{beside}?"
    likely = closest(key, parent.allowed)
    if likely is not None:
        return f"{wrong}; did you mean '{likely}', which is there already?"
    return f"{wrong}; {nearest(key, [name for name in parent.allowed if name not in parent])}"


def _kind_of_thing(context: Mapping[str, Any], node: Any) -> str:
    if not isinstance(node, dict):
        return f"found {found(node)}; a mapping with a 'type' is needed"
    if "type" not in node:
        return "'type' is missing; it says what kind of thing this is"
    known = [tag.strip(" '") for tag in str(context.get("expected_tags", "")).split(",")]
    return f"{found(node['type'])} is not a type that is known here; {nearest(str(node['type']), known)}"
