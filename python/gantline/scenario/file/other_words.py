"""Words of other crews for what a lift file has, and what there is in place of what it has not."""

from __future__ import annotations

__all__ = ["BESIDE", "ELSEWHERE", "INSTEAD", "KINDS", "MEANT", "VERBS_MEANT"]

#: What people look for at another place of a lift file than where it is.
ELSEWHERE = {
    "gravity": "it belongs to 'simulation': {gravity: 9.81 m/s^2}",
    "gusts": "gusts belong to 'wind': {speed: 10 m/s, direction: 0 deg, gusts: {speed: 14 m/s}}",
    "title": "it belongs to 'lift': {title: Four slings lift a module}",
}
#: Keys by other words, which are not written like them; the first that may stand there is meant.
MEANT = {
    "active_heave_compensation": ("heave_compensation",),
    "acceptance": ("limits",),
    "ahc": ("heave_compensation", "compensate_heave"),
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
    "disconnect": ("detach",),
    "distance": ("by",),
    "connect": ("attach",),
    "daf": ("dynamic_amplification_factor",),
    "drag": ("drag_coefficients",),
    "during": ("from_step",),
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
    "inclination": ("load_tilt",),
    "jacks": ("drums",),
    "keel_blocks": ("supports",),
    "leveller": ("chain_hoist",),
    "lifting": ("hoist",),
    "lifting_points": ("lugs",),
    "load_chart": ("rating",),
    "load_leveller": ("chain_hoist",),
    "location": ("position", "at"),
    "lug": ("at", "to"),
    "mass": ("weight", "calculated"),
    "mbf": ("minimum_breaking_force",),
    "mu": ("friction",),
    "on": ("stands_on",),
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
#: Sailors and forecasts say where it comes from.
_GROWS = ("height", "reference_height", "measured_at", "terrain", "roughness", "exponent", "shear", "alpha")
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
        **dict.fromkeys(("bodies", "body_contacts", "contacts", "drums"), _MECHANICS),
        **dict.fromkeys(("jacks", "strand_jacks", "winches"), "they are 'drums' under 'mechanics'"),
        **dict.fromkeys(_LASHINGS, _LASHED),
        **dict.fromkeys(_SUCTION, _STUCK),
    },
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
        **dict.fromkeys(("alpha", "power", "shear_exponent"), "a power of the height is an 'exponent'"),
        **dict.fromkeys(("z0", "roughness_length"), "the roughness of what it blows over is 'roughness'"),
        **dict.fromkeys(("at", "reference_height", "measured_at"), "where it is measured is its 'height'"),
        "category": "categories 0 to IV of EN 1991-1-4 are 'terrain: sea', flat, fields, suburbs and town",
    },
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
    **dict.fromkeys(("building", "floor", "pier", "quay", "roof", "slab", "wall"), _BOX),
    **dict.fromkeys(("chimney", "column", "leg", "pile", "pipe", "silo", "tower"), _ROUND),
    **dict.fromkeys(("hatch", "hole", "opening"), _OPENING),
}
