//! What waves have a drive do where a step is cut, as where a rope goes taut: place, velocity and acceleration are theirs
//! there, too.

use gantline_core::build::build;
use gantline_core::event::{EventKind, EventLog};
use gantline_core::spec::SystemSpec;
use gantline_core::stepper::adaptive::{Adaptive, Tolerance};
use gantline_core::stepper::frame::Frame;

/// A deck that goes up and down by 1 m with a swell of 9 s, on a rope of 50 m to the ground that is taut while it is up.
const DECK: &str = r#"{
    "gravity": [0, 0, -9.81],
    "bodies": [{
        "name": "deck", "parent": null, "placement": {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]},
        "joint": {"type": "slider", "axis": [0, 0, 1], "drive": "heave"},
        "mass": 5e6, "centre_of_gravity": [0, 0, 0], "inertia": [0, 0, 0, 0, 0, 0]
    }],
    "drives": [{"name": "heave", "waves": {
        "components": [
            {"frequency": 0.7, "wave_number": [0.05, 0], "amplitude": 0.8, "phase": 0.3},
            {"frequency": 0.9, "wave_number": [0.08, 0], "amplitude": 0.2, "phase": 1.1}
        ],
        "rise_time": 20
    }}],
    "ropes": [{
        "name": "stay", "length": 50, "material": {"type": "elastic", "axial_stiffness": 1e6, "damping_time": 0.01},
        "route": [{"type": "end", "body": "deck", "at": [0, 0, 0]}, {"type": "end", "body": null, "at": [0, 0, -50]}]
    }]
}"#;

/// Of the acceleration nothing but rounding is missed: with the 1e-7 m/s² by which a step's own course misses it the next step
/// would begin as if forces had jumped, from 1e-9 on. Place and velocity are put there in any case.
#[test]
fn a_step_that_is_cut_ends_with_what_waves_ask() {
    let spec: SystemSpec = serde_json::from_str(DECK).unwrap();
    let (system, mut state) = build(&spec).unwrap();
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    let mut method = Adaptive::new(&system, &frame, Tolerance { tension: 1.0, position: 1e-4 });
    let (mut log, mut cut) = (EventLog::new(), 0);
    while state.time < 100.0 {
        let report = method.step(&system, &mut state, &mut frame, &mut log, 100.0).unwrap();
        let asked = state.plan.timelines[0].motion(state.time);
        let missed = [
            state.q[0] - asked.position,
            state.v[0] - asked.velocity,
            state.acceleration[0] - asked.acceleration,
        ];
        assert!(missed.iter().all(|missed| missed.abs() < 1e-12), "{missed:?} at {}", state.time);
        cut += usize::from(report.cut);
    }
    let taut = log.events.iter().filter(|event| event.kind == EventKind::Taut).count();
    assert!(cut > 15 && taut > 8, "{cut} steps cut, {taut} times taut");
}
