"""Examples that the help of each verb ends with; a test holds their options against those that there are."""

from __future__ import annotations

#: Command lines by verb, each with what it does.
EXAMPLES: dict[str, tuple[tuple[str, str], ...]] = {
    "run": (
        ("gantline run equalizer", "a lift that comes with gantline, into results/equalizer"),
        ("gantline run mylift -o out --tension-tolerance '10 N'", "your own, more precisely"),
        ("gantline run mylift --refine", "twice, to say how far its figures are the method's"),
        ("gantline run mylift --no-plots --json > checks.json", "for programs"),
    ),
    "statics": (
        ("gantline statics equalizer", "how it hangs at the end of its plan, and its slowest motions"),
        (
            "gantline statics equalizer --time '20 s' --sensitivities",
            "at another time, with what errors change",
        ),
        ("gantline statics mylift -o results/mylift", "for the report in that folder"),
        ("gantline statics equalizer --sweep 'slings.S1.length=23 m..23.1 m/5'", "over a length"),
    ),
    "cases": (
        ("gantline cases goliath", "all cases of the lift file, and the worst of each element"),
        ("gantline cases mylift -o results/mylift", "for the report in that folder"),
    ),
    "seas": (
        (
            "gantline seas crane_barge_in_swell --height '0.6 m, 1 m' --period '6 s, 8 s' -o results/seas",
            "up to which height of swell, for two periods",
        ),
        (
            "gantline seas mylift --height '0.5 m..2.5 m/5' --direction '180 deg, 150 deg' --records 5",
            "and from where, five records of each sea",
        ),
    ),
    "compare": (
        (
            "gantline compare equalizer --b integrator=del --b 'step=1 ms'",
            "a lift with itself by another method",
        ),
        ("gantline compare mylift changed -o out", "two lifts"),
        ("gantline compare before.nc after.nc", "two recordings"),
    ),
    "check": (
        ("gantline check mylift", "is this lift file right?"),
        ("gantline check results/mylift", "does the lift keep its limits? code 1 if not"),
    ),
    "cad file": (
        ("gantline cad file load.3docx --parts", "masses part by part, and a picture"),
        (
            "gantline cad file hull.stl --unit mm --thickness '12 mm'",
            "plates of a plain surface",
        ),
    ),
    "cad block": (
        (
            "gantline cad block block.3docx --length '43 m' --breadth '23 m' --height '11 m' --mass '300 t'",
            "a ship block to try a lift with",
        ),
    ),
    "hydro": (("gantline hydro box:100m,30m,8m --kg '5 m'", "drafts, displacement, GM of a barge"),),
    "ballast": (
        ("gantline ballast floating_crane --step 'hold point 6'", "even keel while the load hangs"),
        (
            "gantline ballast floating_crane --draft '4.4 m' --write ballasted.yaml",
            "with a draft, into a new lift file",
        ),
    ),
    "report": (
        ("gantline report results/mylift", "the report beside its recording, made anew"),
        ("gantline report results/mylift/recording.nc -o lift.html", "somewhere else"),
    ),
    "view": (
        ("gantline view mylift", "while you write it: the report, anew at each save"),
        ("gantline view results/mylift", "of what has been run, and again when it changes"),
    ),
    "export": (
        ("gantline export results/mylift lift.glb", "for Blender"),
        ("gantline export results/mylift t.csv --variable rope_tension", "for spreadsheets"),
        ("gantline export results/mylift lugs.csv --lugs", "for who designs what the slings pull at"),
    ),
    "new": (
        ("gantline new mylift", "a module on four slings, with comments, to change"),
        ("gantline new mylift --from equalizer", "a folder with a lift file to change"),
    ),
    "schema": (
        ("gantline schema -o lift.schema.json", "for an editor"),
        (
            "gantline schema --library -o library.schema.json",
            "for the types of a yard in a file of their own",
        ),
    ),
    "doctor": (("gantline doctor", "what is installed here"),),
}


def examples_of(verb: str) -> str:
    """The examples of a verb as the end of its help, a line each."""
    shown = EXAMPLES[verb]
    lines = (f"  {line}\n      {what}" for line, what in shown)
    # \\b keeps the lines of this paragraph as they are.
    return "\b\nExamples:\n" + "\n".join(lines)
