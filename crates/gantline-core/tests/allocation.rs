//! No allocation in a step after warm-up, counted by the allocator itself.

use gantline_core::build::build;
use gantline_core::event::EventLog;
use gantline_core::spec::{AdjusterSpec, SystemSpec};
use gantline_core::state::State;
use gantline_core::stepper::adaptive::{Adaptive, Tolerance};
use gantline_core::stepper::del::Del;
use gantline_core::stepper::explicit::Explicit;
use gantline_core::stepper::frame::Frame;
use gantline_core::system::System;

/// A load swinging on two ropes over the ground, dropped so that ropes go slack and corners touch.
const RIG: &str = include_str!("dropped_load.json");

/// A pendulum that swings against a sheave and away from it, in space: its rope leaves it and comes back.
const LEAVING: &str = r#"{"gravity": [0, 0, -9.81], "bodies": [{
    "name": "bob", "parent": null, "mass": 100, "centre_of_gravity": [0, 0, 0], "inertia": [0, 0, 0, 0, 0, 0],
    "placement": {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]},
    "joint": {"type": "point", "position": [-0.3, 0.01, -4], "velocity": [0, 0, 0]}}],
  "ropes": [{"name": "r", "length": null, "material": {"type": "elastic", "axial_stiffness": 1e6, "damping_time": 0.01},
    "route": [{"type": "end", "body": null, "at": [0, 0, 0]},
      {"type": "sheave", "body": null, "at": [0.2, 0, -2], "axis": [0, -1, 0], "radius": 0.2, "may_lift_off": true},
      {"type": "end", "body": "bob", "at": [0, 0, 0]}]}]}"#;

/// A load that rings on its fall while a drum hauls it up and a rope of other strain is wound in every step.
const HAULED: &str = r#"{"gravity": [0, 0, -9.81], "bodies": [{
    "name": "load", "parent": null, "mass": 1000, "centre_of_gravity": [0, 0, 0], "inertia": [0, 0, 0, 0, 0, 0],
    "placement": {"position": [0, 0, -50], "orientation": [1, 0, 0, 0]},
    "joint": {"type": "slider", "axis": [0, 0, 1], "stops": {"lower": -0.5, "stiffness": 1e6}}}, {
    "name": "drum", "parent": null, "mass": 0, "centre_of_gravity": [0, 0, 0], "inertia": [0, 0, 0, 0, 0, 0],
    "placement": {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]},
    "joint": {"type": "flow", "inertia": 100, "drive": "haul"}}],
  "drives": [{"name": "haul", "ramps": [{"at": 0, "duration": 0.5, "velocity": -0.5}]}],
  "ropes": [{"name": "r", "length": 50.2, "material": {"type": "elastic", "axial_stiffness": 1e7, "damping_time": 0},
    "route": [{"type": "end", "body": "load", "at": [0, 0, 0]},
      {"type": "end", "body": null, "at": [0, 0, 0], "drum": {"flow": "drum", "rate": 1.0}}]}]}"#;

/// Makes `warm` and then `counted` steps; says how often the latter allocated and how many events they had.
fn count(
    warm: usize,
    counted: usize,
    mut step: impl FnMut(&System, &mut State, &mut Frame, &mut EventLog),
    system: &System,
    mut state: State,
) -> (u64, usize) {
    let mut frame = Frame::new(system);
    frame.update(system, &state);
    let mut log = EventLog::new();
    for _ in 0..warm {
        step(system, &mut state, &mut frame, &mut log);
    }
    let events = log.events.len();
    let allocated = allocation_counter::measure(|| {
        for _ in 0..counted {
            step(system, &mut state, &mut frame, &mut log);
        }
    });
    (allocated.count_total, log.events.len() - events)
}

#[test]
fn steps_of_del_do_not_allocate() {
    check_del(RIG, 5);
}

#[test]
fn steps_of_adaptive_do_not_allocate() {
    check_adaptive(RIG, 5);
}

#[test]
fn ropes_that_leave_sheaves_do_not_allocate() {
    // 3 s with del, and more with adaptive: a swing to and fro takes 3.5 s.
    check_del(LEAVING, 1);
    check_adaptive(LEAVING, 1);
}

#[test]
fn drums_that_remember_do_not_allocate() {
    check_del(HAULED, 0);
    check_adaptive(HAULED, 0);
}

/// A weight that swings in the bight of a rope over light sheaves, one of them moving.
const LIGHT: &str = r#"{"gravity": [0, 0, -9.81], "bodies": [{
    "name": "weight", "parent": null, "mass": 1000, "centre_of_gravity": [0, 0, 0], "inertia": [0, 0, 0, 0, 0, 0],
    "placement": {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]},
    "joint": {"type": "point", "position": [2, 0, 0], "velocity": [0, 1, 0]}}, {
    "name": "moving", "parent": null, "mass": 0, "centre_of_gravity": [0, 0, 0], "inertia": [0, 0, 0, 0, 0, 0],
    "placement": {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]}, "joint": {"type": "flow", "inertia": 0}}, {
    "name": "held", "parent": null, "mass": 0, "centre_of_gravity": [0, 0, 0], "inertia": [0, 0, 0, 0, 0, 0],
    "placement": {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]}, "joint": {"type": "flow", "inertia": 0}}],
  "ropes": [{"name": "r", "length": null, "material": {"type": "elastic", "axial_stiffness": 1e7, "damping_time": 0.002},
    "route": [{"type": "end", "body": null, "at": [-1, 0, 10]},
      {"type": "half_turn", "body": "weight", "enter": [-1, 0, 0], "leave": [0, 0, 0], "bulge": [0, 0, -1],
        "flow": "moving", "ratio": 1.05},
      {"type": "half_turn", "body": null, "enter": [0, 0, 10], "leave": [1, 0, 10], "bulge": [0, 0, 1],
        "flow": "held", "ratio": 1.05},
      {"type": "end", "body": null, "at": [1, 0, 0]}]}]}"#;

#[test]
fn light_sheaves_do_not_allocate() {
    // Sheaves that turn over are no events.
    assert_eq!(count_adaptive(LIGHT), (0, 0));
}

/// A cube that bobs and rolls with all that water does to it and in it.
const AFLOAT: &str = r#"{"gravity": [0, 0, -9.81], "bodies": [{
    "name": "cube", "parent": null, "mass": 4000, "centre_of_gravity": [0, 0, 0.6], "inertia": [3000, 3000, 3000, 0, 0, 0],
    "placement": {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]},
    "joint": {"type": "free", "position": [0, 0, -0.5], "orientation": [1, 0, 0, 0], "velocity": [1, 0, 0],
      "angular_velocity": [0.6, 0.2, 0.1]}}],
  "forces": [{"type": "buoyancy", "name": "hull", "body": "cube", "density": 1000, "level": 0, "vertices":
      [[-1,-1,0],[-1,-1,2],[-1,1,0],[-1,1,2],[1,-1,0],[1,-1,2],[1,1,0],[1,1,2]], "triangles":
      [[0,1,3],[0,3,2],[4,6,7],[4,7,5],[0,4,5],[0,5,1],[2,3,7],[2,7,6],[0,2,6],[0,6,4],[1,5,7],[1,7,3]]},
    {"type": "tank", "name": "tank", "body": "cube", "density": 1000, "volume": 0.5, "vertices":
      [[-1,-0.5,0],[-1,-0.5,1],[-1,0.5,0],[-1,0.5,1],[1,-0.5,0],[1,-0.5,1],[1,0.5,0],[1,0.5,1]], "triangles":
      [[0,1,3],[0,3,2],[4,6,7],[4,7,5],[0,4,5],[0,5,1],[2,3,7],[2,7,6],[0,2,6],[0,6,4],[1,5,7],[1,7,3]]},
    {"type": "added_mass", "name": "added", "body": "cube", "at": [0, 0, 0.5], "matrix": [[500,0,0,0,0,0],
      [0,500,0,0,0,0],[0,0,2000,0,0,0],[0,0,0,100,0,0],[0,0,0,0,100,0],[0,0,0,0,0,100]]},
    {"type": "drag", "name": "drag", "body": "cube", "at": [0, 0, 0.5], "quadratic": [9, 9, 9, 9, 9, 9], "damping":
      [[9,0,0,0,0,0],[0,9,0,0,0,0],[0,0,9,0,0,0],[0,0,0,9,0,0],[0,0,0,0,9,0],[0,0,0,0,0,9]]},
    {"type": "memory", "name": "past", "body": "cube", "at": [0, 0, 0.5], "terms": [{"pole": [-0.6, 0.8], "real":
      [[80,0,0,0,0,0],[0,80,0,0,0,0],[0,0,800,0,0,0],[0,0,0,40,0,0],[0,0,0,0,40,0],[0,0,0,0,0,40]], "imaginary":
      [[60,0,0,0,0,0],[0,60,0,0,0,0],[0,0,600,0,0,0],[0,0,0,30,0,0],[0,0,0,0,30,0],[0,0,0,0,0,30]]}]}]}"#;

#[test]
fn bodies_in_water_do_not_allocate() {
    let (system, state) = build(&serde_json::from_str(AFLOAT).unwrap()).unwrap();
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    let mut adaptive = Adaptive::new(&system, &frame, Tolerance::default_of(&system));
    let step = |system: &System, state: &mut State, frame: &mut Frame, log: &mut EventLog| {
        adaptive.step(system, state, frame, log, 1e3).unwrap();
    };
    assert_eq!(count(10, 300, step, &system, state.clone()).0, 0);
    let mut del = Del::new(&system, 1e-3, true);
    let step = |system: &System, state: &mut State, frame: &mut Frame, log: &mut EventLog| {
        del.step(system, state, frame, log).unwrap();
    };
    assert_eq!(count(10, 3000, step, &system, state).0, 0);
}

fn check_del(rig: &str, least: usize) {
    let (system, state) = build(&serde_json::from_str(rig).unwrap()).unwrap();
    let mut method = Del::new(&system, 1e-3, true);
    let step = |system: &System, state: &mut State, frame: &mut Frame, log: &mut EventLog| {
        method.step(system, state, frame, log).unwrap();
    };
    let (allocations, events) = count(10, 3000, step, &system, state);
    assert_eq!(allocations, 0);
    // The stretch was no idle one: ropes and contacts changed side in it.
    assert!(events > least, "{events}");
}

#[test]
fn steps_of_explicit_do_not_allocate() {
    let mut spec: SystemSpec = serde_json::from_str(RIG).unwrap();
    let ropes = spec.ropes.iter().map(|rope| rope.name.clone()).collect();
    spec.adjusters = vec![AdjusterSpec { name: "equalizer".into(), ropes, factor: 0.01 }];
    let (system, state) = build(&spec).unwrap();
    let mut method = Explicit::new(&system, 1e-3);
    let step = |system: &System, state: &mut State, frame: &mut Frame, log: &mut EventLog| {
        method.step(system, state, frame, log).unwrap();
    };
    let (allocations, events) = count(10, 3000, step, &system, state);
    assert_eq!(allocations, 0);
    assert!(events > 5, "{events}");
}

fn check_adaptive(rig: &str, least: usize) {
    let (allocations, events) = count_adaptive(rig);
    assert_eq!(allocations, 0);
    assert!(events > least, "{events}");
}

fn count_adaptive(rig: &str) -> (u64, usize) {
    let (system, state) = build(&serde_json::from_str(rig).unwrap()).unwrap();
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    let mut method = Adaptive::new(&system, &frame, Tolerance::default_of(&system));
    let step = |system: &System, state: &mut State, frame: &mut Frame, log: &mut EventLog| {
        method.step(system, state, frame, log, 1e3).unwrap();
    };
    count(10, 300, step, &system, state)
}

#[test]
fn the_counter_counts() {
    let allocated = allocation_counter::measure(|| drop(std::hint::black_box(vec![0.0_f64; 8])));
    assert_eq!(allocated.count_total, 1);
}
