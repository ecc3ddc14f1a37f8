"""Wind that grows with height, turned and round structures, free sheaves, in words of other crews.

`wind: {…, wind_shear: 0.14}`, `z0`, `anemometer_height` and `category` were answered with lists of other
keys, `profile: sea` with what a profile is and not with what to write, `terrain: offshore` and `terrain:
II` with all five words and not with the one meant, an exponent of `14 %` with "a plain number like '1.05'",
which is out of its range. `current: {…, profile: …}` was told "known here: there is none". The rotation or
direction of a box was asked "did you mean 'friction'?", the `end_diameter` of a tower "did you mean
'diameter', which is there already?", `guides` of moving sheaves were told to stand too far in. What a `box`
of `type: box` lacks was said of the key and not of the structure. `sheave_distance` and `fleet_angle` of a
drum, `max_wind` of a crane had lists of other keys.
"""

from __future__ import annotations

import pytest

from gantline.scenario import parse_scenario
from gantline.scenario.errors import ScenarioError
from lift_text import BASE, spoiled

PROFILE = "how wind grows with height is its 'profile: {height: 10 m, terrain: sea}'"
TERRAINS = "right is 'sea', 'flat', 'fields', 'suburbs' or 'town'"
EXTENTS = "where it stands and how large it is are its extents, such as 'x: [20 m, 30 m]', 'y' and 'z'"
UPRIGHT = "from where to where it goes up is its 'z', such as 'z: [0 m, 80 m]'"
BOX = "type: box, x: [20 m, 30 m], y: [10 m, 20 m], z: [0 m, 5 m]"
TOWER = "type: cylinder, at: [40 m, 0 m], diameter: 4 m, z: [0 m, 80 m]"


def answers(text: str) -> list[str]:
    """What is said, without file and line, and without the words of the path before the last one."""
    with pytest.raises(ScenarioError) as found:
        parse_scenario(text)
    return [line.partition(": ")[2] for line in str(found.value).splitlines()]


@pytest.mark.parametrize(
    ("keys", "says"),
    [
        ("wind_shear: 0.14", f"wind.wind_shear: 'wind_shear' is not a key of wind: {PROFILE}"),
        ("z0: 3 mm", f"wind.z0: 'z0' is not a key of wind: {PROFILE}"),
        (
            "anemometer_height: 10 m",
            f"wind.anemometer_height: 'anemometer_height' is not a key of wind: {PROFILE}",
        ),
        (
            "profile: sea",
            "wind.profile: found 'sea'; the profile of the wind is a mapping with keys such as height, "
            "terrain, roughness, exponent; write {terrain: sea}",
        ),
        (
            "profile: none",
            "wind.profile: found 'none'; the profile of the wind is a mapping with keys such as height, "
            "terrain, roughness, exponent",
        ),
        (
            "profile: {terrain: Offshore}",
            f"wind.profile.terrain: found 'Offshore'; {TERRAINS}; did you mean 'sea'?",
        ),
        ("profile: {terrain: II}", f"wind.profile.terrain: found 'II'; {TERRAINS}; did you mean 'fields'?"),
        ("profile: {terrain: 4}", f"wind.profile.terrain: found '4'; {TERRAINS}; did you mean 'town'?"),
        (
            "profile: {exponent: 14 %}",
            "wind.profile.exponent: found '14 %'; a plain number like '0.5' is needed",
        ),
        (
            "profile: {shear: 0.14}",
            "wind.profile.shear: 'shear' is not a key of the profile of the wind: a power of the height is "
            "an 'exponent'",
        ),
        (
            "profile: {terrain: sea, anemometer: 10 m}",
            "wind.profile.anemometer: 'anemometer' is not a key of the profile of the wind: where it is "
            "measured is its 'height'",
        ),
        (
            "gusts: {speed: 12 m/s, height: 10 m}",
            "wind.gusts.height: 'height' is not a key of gusts: gusts are those at the height at which the "
            "wind has its speed, 'height' of its 'profile'",
        ),
    ],
)
def test_wind_is_answered_with_what_there_is(keys: str, says: str) -> None:
    assert answers(f"{BASE}wind: {{speed: 8 m/s, direction: 0 deg, {keys}}}\n") == [says]


def test_current_has_no_profile_and_wind_has_it_within() -> None:
    current = f"{BASE}current: {{speed: 1 m/s, direction: 0 deg, profile: {{exponent: 0.14}}}}\n"
    assert answers(current) == [
        "current.profile: 'profile' is not a key of current: current is the same at any depth"
    ]
    assert answers(f"{BASE}wind_profile: {{terrain: sea}}\n") == [
        "wind_profile: 'wind_profile' is not a key of a lift file: how wind grows with height belongs to "
        "'wind': {speed: 10 m/s, direction: 0 deg, profile: {terrain: sea}}"
    ]


@pytest.mark.parametrize("key", ["angle", "rotation", "orientation", "yaw", "turned", "direction"])
def test_what_turns_a_box_is_its_heading(key: str) -> None:
    wrong = f"structures.hall.{key}: '{key}' is not a key of a box; did you mean 'heading'?"
    assert answers(f"{BASE}structures:\n  hall: {{{BOX}, {key}: 30 deg}}\n") == [wrong]


@pytest.mark.parametrize(
    ("structure", "says"),
    [
        (f"{BOX}, size: [10 m, 10 m, 5 m]", f"size: 'size' is not a key of a box: {EXTENTS}"),
        (
            TOWER.replace("z: [0 m, 80 m]", "height: 80 m"),
            f"height: 'height' is not a key of an upright cylinder: {UPRIGHT}",
        ),
        (
            f"{TOWER}, end_diameter: 3 m",
            "end_diameter: 'end_diameter' is not a key of an upright cylinder: it is as wide at any height; "
            "one that tapers is several, one on another",
        ),
        (
            "type: dock, x: [20 m, 30 m], y: [10 m, 20 m], floor: -8 m, heading: 30 deg",
            "heading: 'heading' is not a key of a dock: boxes are turned, and no docks",
        ),
    ],
)
def test_structures_are_answered_with_what_there_is(structure: str, says: str) -> None:
    assert answers(f"{BASE}structures:\n  hall: {{{structure}}}\n")[-1] == f"structures.hall.{says}"


def test_what_a_box_lacks_is_said_of_the_box() -> None:
    said = answers(f"{BASE}structures:\n  hall: {{type: box, box: [10 m, 10 m, 5 m]}}\n")
    assert said == [
        "structures.hall: 'x' is missing; a box needs it (extent along world x)",
        "structures.hall: 'y' is missing; a box needs it (extent along world y)",
        "structures.hall: 'z' is missing; a box needs it (extent in height)",
        f"structures.hall.box: 'box' is not a key of a box: {EXTENTS}",
    ]


@pytest.mark.parametrize("kind", ["monopile", "mast", "tank", "round"])
def test_what_is_round_is_a_cylinder(kind: str) -> None:
    wrong = f"structures.hall: '{kind}' is not a type that is known here"
    right = "what is round and upright is 'type: cylinder'"
    assert answers(f"{BASE}structures:\n  hall: {{{TOWER.replace('cylinder', kind)}}}\n") == [
        f"{wrong}; {right}"
    ]


@pytest.mark.parametrize(
    ("new", "says"),
    [
        ("guided: free", "guided: found 'free'; right is 'vertical' or 'none'; did you mean 'none'?"),
        (
            "guides: none",
            "guides: 'guides' is not a key of moving_sheaves: sheaves that hang free in the equalizing rope "
            "have 'guided: none'",
        ),
    ],
)
def test_sheaves_that_hang_free(new: str, says: str) -> None:
    text = spoiled("moving_sheaves: {", f"moving_sheaves: {{{new}, ")
    assert answers(text)[-1] == f"equalizers.e1.moving_sheaves.{says}"


@pytest.mark.parametrize(
    ("key", "says"),
    [
        ("sheave_distance", "how far away the sheave stands that its rope comes from is 'first_sheave'"),
        (
            "fleet_angle",
            "it follows from its 'first_sheave'; what it may be is 'drum_fleet_angle' of 'limits'",
        ),
        ("width", "how wide it is says 'wraps_per_layer', in turns of its rope"),
    ],
)
def test_what_leads_to_a_drum(key: str, says: str) -> None:
    text = f"{BASE}mechanics:\n  drums:\n    tugger: {{diameter: 1 m, {key}: 3 m}}\n"
    path = "mechanics.drums.tugger"
    assert f"{path}.{key}: '{key}' is not a key of a drum: {says}" in answers(text)


@pytest.mark.parametrize("key", ["max_wind", "wind_speed"])
def test_the_wind_in_which_a_crane_may_lift(key: str) -> None:
    said = answers(spoiled("    rated_capacity: 100 t\n", f"    rated_capacity: 100 t\n    {key}: 12 m/s\n"))
    assert said == [f"cranes.hook.{key}: '{key}' is not a key of a crane; did you mean 'wind_limit'?"]
