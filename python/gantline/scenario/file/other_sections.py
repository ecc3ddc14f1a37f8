"""Words of other crews for the sections of a lift file."""

from __future__ import annotations

__all__ = ["SECTIONS_INSTEAD", "SECTIONS_MEANT"]

#: Sections by other words, which are not written like them.
SECTIONS_MEANT = {
    **dict.fromkeys(
        ("steps", "sequence", "procedure", "stages", "schedule", "phases", "operations", "moves"), ("plan",)
    ),
    **dict.fromkeys(("cargo", "object", "module", "item", "piece"), ("load",)),
    **dict.fromkeys(("pontoon", "pontoons", "floaters", "hulls"), ("vessels",)),
    **dict.fromkeys(("quay", "jetty", "building", "buildings", "obstacles", "obstructions"), ("structures",)),
    **dict.fromkeys(("soil", "seabed", "floor"), ("ground",)),
    **dict.fromkeys(("tide", "sea_level", "water_level"), ("water",)),
    **dict.fromkeys(("sea_state", "sea", "seas", "swell"), ("waves",)),
    **dict.fromkeys(("safety_factors", "factors", "load_factors"), ("rules",)),
    **dict.fromkeys(
        (
            "yoke",
            "yokes",
            "beams",
            "frames",
            "lifting_beam",
            "lifting_beams",
            "lifting_frame",
            "lifting_frames",
        ),
        ("spreaders",),
    ),
    **dict.fromkeys(("time_step", "dt", "solver", "integrator", "method"), ("simulation",)),
    **dict.fromkeys(("load_cases", "scenarios", "variants", "variations"), ("cases",)),
    **dict.fromkeys(("heave_compensators", "shock_absorbers"), ("compensators",)),
    **dict.fromkeys(("bumpers", "guide_posts", "landing_guides"), ("guides",)),
    **dict.fromkeys(("moorings", "anchors", "anchor_lines"), ("mooring_lines",)),
    **dict.fromkeys(("end_time", "simulation_time", "total_time"), ("duration",)),
    "criteria": ("limits",),
    # <!-- words: off -->
    "wire_rope": ("ropes",),
    # <!-- words: on -->
}

#: What there is in place of a section that there is not.
SECTIONS_INSTEAD = {
    "environment": "its parts stand by themselves: 'wind', 'waves', 'current', 'water'",
    "rigging": "its parts stand by themselves: 'slings', 'shackles', 'ropes', 'equalizers', 'spreaders'",
    **dict.fromkeys(
        ("output", "outputs", "results"),
        "a run writes all it computes; 'gantline run LIFT -o FOLDER' says where, and 'report' of a step what "
        "its line in the report shows",
    ),
    "units": "each quantity has its unit beside it, such as '300 t'",
    **dict.fromkeys(("name", "number", "revision", "remark"), "it belongs to 'lift', as the 'title'"),
    **dict.fromkeys(
        ("client", "project", "author", "engineer", "date"), "words for people are the 'remark' of 'lift'"
    ),
    **dict.fromkeys(("mass", "weights", "cog"), "it belongs to the 'load'"),
    **dict.fromkeys(("hoists", "trolleys", "booms"), "each belongs to its crane, under 'cranes'"),
    **dict.fromkeys(
        ("tolerance", "tolerances"),
        "that of slings is the 'tolerance' of 'sling_defaults', that of the method 'tension_tolerance' of "
        "'simulation'",
    ),
    "friction": "that of the ground belongs to 'ground', that of a support to 'supports'",
    "daf": "factors on loads belong to 'rules'",
    "g": "it belongs to 'simulation': {gravity: 9.81 m/s^2}",
}
