//! No allocation in a step after warm-up, counted by the allocator itself.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use gantline_core::build::build;
use gantline_core::event::EventLog;
use gantline_core::spec::{AdjusterSpec, SystemSpec};
use gantline_core::state::State;
use gantline_core::stepper::adaptive::{Adaptive, Tolerance};
use gantline_core::stepper::del::Del;
use gantline_core::stepper::explicit::Explicit;
use gantline_core::stepper::frame::Frame;
use gantline_core::system::System as SystemUnderTest;

thread_local! {
    static COUNT: Cell<u64> = const { Cell::new(0) };
}

struct Counting;

// The only unsafe code of the project: it hands on to the system's allocator and counts.
#[allow(unsafe_code)]
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.with(|count| count.set(count.get() + 1));
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        COUNT.with(|count| count.set(count.get() + 1));
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// A load swinging on two ropes over the ground, dropped so that ropes go slack and corners touch.
const RIG: &str = include_str!("dropped_load.json");

/// Makes `warm` and then `counted` steps; says how often the latter allocated and how many events they had.
fn count(
    warm: usize,
    counted: usize,
    mut step: impl FnMut(&SystemUnderTest, &mut State, &mut Frame, &mut EventLog),
    system: &SystemUnderTest,
    mut state: State,
) -> (u64, usize) {
    let mut frame = Frame::new(system);
    frame.update(system, &state);
    let mut log = EventLog::new();
    for _ in 0..warm {
        step(system, &mut state, &mut frame, &mut log);
    }
    let (before, events) = (COUNT.with(Cell::get), log.events.len());
    for _ in 0..counted {
        step(system, &mut state, &mut frame, &mut log);
    }
    (COUNT.with(Cell::get) - before, log.events.len() - events)
}

#[test]
fn steps_of_del_do_not_allocate() {
    let (system, state) = build(&serde_json::from_str(RIG).unwrap()).unwrap();
    let mut method = Del::new(&system, 1e-3, true);
    let step = |system: &SystemUnderTest, state: &mut State, frame: &mut Frame, log: &mut EventLog| {
        method.step(system, state, frame, log).unwrap();
    };
    let (allocations, events) = count(10, 3000, step, &system, state);
    assert_eq!(allocations, 0);
    // The stretch was no idle one: ropes and contacts changed side in it.
    assert!(events > 5, "{events}");
}

#[test]
fn steps_of_explicit_do_not_allocate() {
    let mut spec: SystemSpec = serde_json::from_str(RIG).unwrap();
    let ropes = spec.ropes.iter().map(|rope| rope.name.clone()).collect();
    spec.adjusters = vec![AdjusterSpec { name: "equalizer".into(), ropes, factor: 0.01 }];
    let (system, state) = build(&spec).unwrap();
    let mut method = Explicit::new(&system, 1e-3);
    let step = |system: &SystemUnderTest, state: &mut State, frame: &mut Frame, log: &mut EventLog| {
        method.step(system, state, frame, log).unwrap();
    };
    let (allocations, events) = count(10, 3000, step, &system, state);
    assert_eq!(allocations, 0);
    assert!(events > 5, "{events}");
}

#[test]
fn steps_of_adaptive_do_not_allocate() {
    let (system, state) = build(&serde_json::from_str(RIG).unwrap()).unwrap();
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    let mut method = Adaptive::new(&system, &frame, Tolerance::default_of(&system));
    let step = |system: &SystemUnderTest, state: &mut State, frame: &mut Frame, log: &mut EventLog| {
        method.step(system, state, frame, log, 1e3).unwrap();
    };
    let (allocations, events) = count(10, 300, step, &system, state);
    assert_eq!(allocations, 0);
    assert!(events > 5, "{events}");
}

#[test]
fn the_counter_counts() {
    let counted = COUNT.with(Cell::get);
    drop(vec![0.0_f64; 8]);
    assert_eq!(COUNT.with(Cell::get), counted + 1);
}
