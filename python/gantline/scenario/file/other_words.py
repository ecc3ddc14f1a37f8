"""Words of other crews for what a lift file has, and what there is in place of what it has not."""

from __future__ import annotations

from gantline.scenario.file.other_sections import SECTIONS_INSTEAD, SECTIONS_MEANT

__all__ = ["BESIDE", "ELSEWHERE", "INSTEAD", "KINDS", "MEANT", "VALUES_MEANT", "VERBS_MEANT"]

#: What people look for at another place of a lift file than where it is.
ELSEWHERE = {
    "gravity": "it belongs to 'simulation': {gravity: 9.81 m/s^2}",
    "gusts": "gusts belong to 'wind': {speed: 10 m/s, direction: 0 deg, gusts: {speed: 14 m/s}}",
    "title": "it belongs to 'lift': {title: Four slings lift a module}",
}
#: Keys by other words, which are not written like them; the first that may stand there is meant.
MEANT = {
    **SECTIONS_MEANT,
    "active_heave_compensation": ("heave_compensation",),
    "acceptance": ("limits",),
    "ahc": ("heave_compensation", "compensate_heave"),
    "angle": ("heading",),
    "azimuth": ("heading",),
    "based_on": ("type",),
    "bend_diameter": ("bends_about",),
    "buoyancy": ("displaced_volume",),
    "ca": ("added_mass",),
    "chain_fall": ("chain_hoist",),
    "capacity": ("rated_capacity", "working_load_limit"),
    "capacity_chart": ("rating",),
    "chart": ("rating",),
    "cd": ("drag_coefficients",),
    "class": ("construction",),
    "clearance": ("watch",),
    "clearances": ("watch",),
    "cog": ("centre_of_gravity",),
    "criteria": ("limits",),
    "cs": ("slamming_coefficient",),
    "cylinder": ("chain_hoist",),
    "dia": ("diameter",),
    "dimensions": ("shape",),
    "direction": ("heading",),
    "disconnect": ("detach",),
    "distance": ("by",),
    "connect": ("attach",),
    "daf": ("dynamic_amplification_factor",),
    "drag": ("drag_coefficients",),
    "during": ("from_step",),
    "extends": ("type",),
    "end_trucks": ("end_carriages",),
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
    "import": ("library",),
    "imports": ("library",),
    "inclination": ("load_tilt",),
    "include": ("library",),
    "includes": ("library",),
    "inherits": ("type",),
    "jacks": ("drums",),
    "keel_blocks": ("supports",),
    "leveller": ("chain_hoist",),
    "lifting": ("hoist",),
    "like": ("type",),
    "line_types": ("mooring_line_types",),
    "lifting_points": ("lugs",),
    "load_chart": ("rating",),
    "load_leveller": ("chain_hoist",),
    "location": ("position", "at"),
    "lug": ("at", "to"),
    "mass": ("weight", "calculated"),
    "max_wind": ("wind_limit", "wind"),
    "maximum_wind": ("wind_limit", "wind"),
    "mbf": ("minimum_breaking_force",),
    "mu": ("friction",),
    "on": ("stands_on",),
    "orientation": ("heading",),
    "operations": ("plan",),
    "position": ("at",),
    "pivot": ("heel_pins",),
    "pitch": ("load_tilt", "trim"),
    "pin_diameter": ("bends_about",),
    "rail_height": ("rail_level",),
    "rails": ("rail_level",),
    "rails_at": ("rail_level",),
    "runway": ("rail_level",),
    "put_on": ("attach",),
    "radius": ("diameter", "pitch_diameter", "sheave_diameter"),
    "rotate": ("heading",),
    "rotated": ("heading",),
    "rotation": ("heading",),
    "schedule": ("plan",),
    "sea": ("waves",),
    "sequence": ("plan",),
    "size": ("shape",),
    "skl": ("skew_load_factor",),
    "slack": ("slings",),
    "slamming": ("slamming_coefficient",),
    "steps": ("plan",),
    "supported_by": ("stands_on",),
    "strand_jacks": ("drums",),
    "stiffness": ("axial_stiffness", "stops"),
    "stiffness_curve": ("curve",),
    "take_off": ("detach",),
    "taut": ("slings",),
    "tilt": ("load_tilt",),
    "taglines": ("tag_lines",),
    "tp": ("peak_period",),
    "trunnion": ("bends_about",),
    "trunnions": ("lugs",),
    "tugger": ("tag_lines",),
    "tugger_lines": ("tag_lines",),
    "tuggers": ("tag_lines",),
    "turned": ("heading",),
    "turnbuckle": ("chain_hoist",),
    "unhook": ("detach",),
    "volume": ("displaced_volume",),
    "wheel_base": ("base",),
    "wheel_load": ("corner_load",),
    "wheel_loads": ("corner_load",),
    "wheelbase": ("base",),
    "weight": ("mass",),
    "winch": ("chain_hoist",),
    "winches": ("drums",),
    "wind_speed": ("wind_limit", "wind"),
    "yaw": ("heading",),
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
    "pad_eye": ("lug", "at", "to"),
    "pad_eyes": ("lugs",),
    "padeye": ("lug", "at", "to"),
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
_SET_DOWN = "a load that comes down on its supports is 'supports: touched', one that stands 'slings: slack'"
_OUTLINE = "what of it displaces water is its 'hull', such as 'hull: {box: [60 m, 14 m, 3 m]}'"
_LET_GO = (
    "beside what it does a step lets go of a tag line by 'cut: tag.west', "
    "of a slack sling by 'detach: sling.S1'"
)
_LASHED = (
    "what holds a load to a deck or the ground are ropes under 'mechanics', each from it to there, with "
    "'length: as_routed', until a step lets go of them: 'cut: [lash.1, lash.2]'"
)
_LASHINGS = (
    "fastened_to",
    "fixed_to",
    "lashed_to",
    "lashing",
    "lashings",
    "sea_fastening",
    "sea_fastenings",
    "seafastened_to",
    "seafastening",
    "seafastenings",
    "tie_downs",
    "tied_to",
)
_STUCK = (
    "what holds a load to its bed or grillage is a rope under 'mechanics' from it to the world or the deck, "
    "with 'length: as_routed', 'comes_free: true' and, in 'breaks_at', the force at which it does"
)
_SUCTION = ("break_out_force", "breakout", "breakout_force", "hull_suction", "mud", "mud_suction", "suction")
#: By what wind grows, in words of several crews, where it is a power, a roughness and a height.
_POWER = ("alpha", "gradient", "hellmann", "power", "power_law", "shear", "shear_exponent", "wind_shear")
_ROUGHNESS = ("roughness_length", "surface_roughness", "z0")
_MEASURED_AT = (
    "anemometer",
    "anemometer_height",
    "at",
    "at_height",
    "hub_height",
    "measured_at",
    "reference_height",
    "z_ref",
)
_CATEGORY = ("category", "exposure", "terrain_category")
_BY_WHAT = ("formula", "law", "model", "type")
_GROWS = (
    *("height", "terrain", "roughness", "exponent", "growth", "wind_profile"),
    *_POWER,
    *_ROUGHNESS,
    *_MEASURED_AT,
    *_CATEGORY,
)
_LED_TO_DRUM = {
    **dict.fromkeys(
        ("distance", "distance_to_sheave", "lead_distance", "sheave_at", "sheave_distance"),
        "how far away the sheave stands that its rope comes from is 'first_sheave'",
    ),
    "fleet_angle": "it follows from its 'first_sheave'; what it may be is 'drum_fleet_angle' of 'limits'",
    "width": "how wide it is says 'wraps_per_layer', in turns of its rope",
}
_FREE_SHEAVES = "sheaves that hang free in the equalizing rope have 'guided: none'"
_AXIS = "where its middle stands is 'at', such as 'at: [40 m, 0 m]'"
_EXTENTS = "where it stands and how large it is are its extents, such as 'x: [20 m, 30 m]', 'y' and 'z'"
_FLOOR = "how deep it is says its 'floor', such as 'floor: -8 m'"
_TAPER = "it is as wide at any height; one that tapers is several, one on another"
_UPRIGHT = "from where to where it goes up is its 'z', such as 'z: [0 m, 80 m]'"
#: Sailors and forecasts say where it comes from.
_COMES_FROM = ("coming_from", "from", "from_direction")
_GOES_TO = (
    "'direction' is where it goes to, from world x towards y: what comes from 30 deg has 'direction: 210 deg'"
)
#: What people look for and is not there: what there is in its place, by what it is looked for in.
INSTEAD = {
    "until": {
        **dict.fromkeys(
            ("sling_tension", "tension"),
            "no step waits for a tension; of slings end it 'by' the length that 'gantline statics' finds, "
            "or wait for 'hoist_load' or 'load_tilt'",
        ),
        **dict.fromkeys(("clear", "lift_off", "load"), "a load that hangs clear is 'supports: clear'"),
        **dict.fromkeys(("landed", "set_down", "touch_down", "touchdown"), _SET_DOWN),
    },
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
    "a hold step": dict.fromkeys(("let_go", "release"), _LET_GO),
    "a haul_in step": {"to": _BY_ROPE},
    "a pay_out step": {"to": _BY_ROPE},
    "a lift file": {
        **SECTIONS_INSTEAD,
        **dict.fromkeys(
            ("wind_profile", "wind_shear"),
            "how wind grows with height belongs to 'wind': {speed: 10 m/s, direction: 0 deg, "
            "profile: {terrain: sea}}",
        ),
        **dict.fromkeys(("bodies", "body_contacts", "contacts", "drums"), _MECHANICS),
        **dict.fromkeys(("jacks", "strand_jacks", "winches"), "they are 'drums' under 'mechanics'"),
        **dict.fromkeys(_LASHINGS, _LASHED),
        **dict.fromkeys(_SUCTION, _STUCK),
    },
    "a box": dict.fromkeys(
        ("at", "box", "breadth", "centre", "height", "length", "position", "size", "width"), _EXTENTS
    ),
    "a drum": _LED_TO_DRUM,
    "the drum of a hoist": _LED_TO_DRUM,
    "a dock": {
        **dict.fromkeys(("bottom", "depth", "z"), _FLOOR),
        **dict.fromkeys(("angle", "heading", "rotation", "turned"), "boxes are turned, and no docks"),
    },
    "an upright cylinder": {
        **dict.fromkeys(("center", "centre", "middle", "x", "y"), _AXIS),
        **dict.fromkeys(("height", "length", "level", "top"), _UPRIGHT),
        **dict.fromkeys(("bottom_diameter", "end_diameter", "taper", "tip_diameter", "top_diameter"), _TAPER),
    },
    "moving_sheaves": dict.fromkeys(("free", "guides", "hangs", "hangs_free", "unguided"), _FREE_SHEAVES),
    "an equalizer": dict.fromkeys(_OF_ITS_SHEAVES, _SHEAVES),
    "an equalizer type": dict.fromkeys(_OF_ITS_SHEAVES, _SHEAVES),
    "a vessel": {
        "at": "where it lies is its 'position', x and y of the world, and its 'heading'",
        **dict.fromkeys(("beam", "breadth", "depth", "length", "width"), _OUTLINE),
        **dict.fromkeys(
            ("displacement_raos", "motion", "motion_file", "motions", "rao", "raos", "record", "time_series"),
            "RAOs of displacement stand in 'wave_motion: {raos: vessel.csv, phases: lag, "
            "at: [50 m, 0 m, 4 m]}', a motion over time in 'wave_motion: {record: motion.csv, "
            "at: [50 m, 0 m, 4 m]}'; 'wave_forces' and 'radiation' name a hydrodynamic database, by which it "
            "answers what hangs from it",
        ),
    },
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
    "wind": {
        **dict.fromkeys(_COMES_FROM, _GOES_TO),
        **dict.fromkeys(_GROWS, "how wind grows with height is its 'profile: {height: 10 m, terrain: sea}'"),
    },
    "the profile of the wind": {
        **dict.fromkeys(_POWER, "a power of the height is an 'exponent'"),
        **dict.fromkeys(_ROUGHNESS, "the roughness of what it blows over is 'roughness'"),
        **dict.fromkeys(_MEASURED_AT, "where it is measured is its 'height'"),
        **dict.fromkeys(
            _CATEGORY, "categories 0 to IV of EN 1991-1-4 are 'terrain: sea', flat, fields, suburbs and town"
        ),
        **dict.fromkeys(
            _BY_WHAT, "with 'terrain' or 'roughness' it is a logarithm, with 'exponent' a power of the height"
        ),
    },
    "gusts": dict.fromkeys(
        ("at", "height", "measured_at"),
        "gusts are those at the height at which the wind has its speed, 'height' of its 'profile'",
    ),
    "current": {
        **dict.fromkeys(_COMES_FROM, _GOES_TO),
        **dict.fromkeys(("depth", "exponent", "profile"), "current is the same at any depth"),
    },
    "waves": {
        **dict.fromkeys(_COMES_FROM, _GOES_TO),
        **dict.fromkeys(
            ("mean_period", "tz", "zero_crossing_period", "zero_up_crossing_period"), _MEAN_PERIOD
        ),
        "spectrum": _JONSWAP,
        "type": _JONSWAP,
        "spreading": "waves run in one direction; several 'waves' with directions of their own spread a sea",
    },
    "a crawler crane": dict.fromkeys(
        ("outrigger", "outrigger_base", "outrigger_mats", "outrigger_pads", "outriggers", "stabilisers"),
        "a mobile crane has its outriggers as 'tracks: {length: 8.5 m, width: 0.6 m, gauge: 8.3 m, "
        "outrigger_mats: 4 m^2}': how far apart they are along and across, its feet, and the mat under each",
    ),
    "a floating crane": dict.fromkeys(
        ("base_mass", "counterweight", "upper_mass"),
        "what slews with the boom stands under 'upper_masses' by name, each with 'mass' and 'at'",
    ),
    "the load": {
        **dict.fromkeys(("ballast", "content", "contents", "flooded", "liquid", "trapped_water"), _TANKS),
        **dict.fromkeys(_IN_WATER, _WET),
        **dict.fromkeys(_LASHINGS, _LASHED),
        **dict.fromkeys(_SUCTION, _STUCK),
    },
}
#: What steps do, by other words.
VERBS_MEANT = {
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
    "tandem": "lead",
    "take_in": "haul",
    "turn": "slew",
    "upend": "hoist",
    "wait": "hold",
}
#: What else is to be known of them.
BESIDE = {"radius": ", twice as much"}
_DOCK = "a hole in the ground, with water in it or without, is 'type: dock'"
_BOX = "what stands in the yard is 'type: box'"
_ROUND = "what is round and upright is 'type: cylinder'"
_OPENING = "an opening is what several of 'type: box' around it leave free"
#: Types of structures by other words.
KINDS = {
    **dict.fromkeys(("basin", "canal", "dry_dock", "pit", "river"), _DOCK),
    **dict.fromkeys(("building", "floor", "house", "pier", "quay", "roof", "slab", "wall"), _BOX),
    **dict.fromkeys(("chimney", "circle", "column", "cone", "leg", "mast", "monopile"), _ROUND),
    **dict.fromkeys(("pile", "pipe", "round", "silo", "tank", "tower", "tube"), _ROUND),
    **dict.fromkeys(("hatch", "hole", "opening"), _OPENING),
}
#: What stands for a value by other words, by the key that has it; categories are those of EN 1991-1-4.
VALUES_MEANT = {
    "terrain": {
        **dict.fromkeys(("0", "coast", "ocean", "offshore", "open sea", "open_sea", "water"), "sea"),
        **dict.fromkeys(("1", "i", "desert", "lake", "lakes", "open"), "flat"),
        **dict.fromkeys(("2", "ii", "country", "farmland", "grass", "grassland", "land"), "fields"),
        **dict.fromkeys(("3", "iii", "forest", "industrial", "suburb", "village", "villages"), "suburbs"),
        **dict.fromkeys(("4", "iv", "city", "urban"), "town"),
    },
    "guided": dict.fromkeys(("free", "false", "no", "unguided"), "none")
    | dict.fromkeys(("frame", "true", "yes"), "vertical"),
}
