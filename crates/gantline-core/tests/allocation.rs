//! No allocation in a step after warm-up, counted by the allocator itself.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use gantline_core::build::build;
use gantline_core::event::EventLog;
use gantline_core::stepper::del::Del;
use gantline_core::stepper::frame::Frame;

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

#[test]
fn steps_do_not_allocate() {
    let (system, mut state) = build(&serde_json::from_str(RIG).unwrap()).unwrap();
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    let mut method = Del::new(&system, 1e-3, true);
    let mut log = EventLog::new();
    for _ in 0..10 {
        method.step(&system, &mut state, &mut frame, &mut log).unwrap();
    }
    let (before, events) = (COUNT.with(Cell::get), log.events.len());
    for _ in 0..3000 {
        method.step(&system, &mut state, &mut frame, &mut log).unwrap();
    }
    assert_eq!(COUNT.with(Cell::get) - before, 0);
    // The stretch was no idle one: ropes and contacts changed side in it.
    assert!(log.events.len() > events + 5, "{:?}", log.events);
    let counted = COUNT.with(Cell::get);
    drop(vec![0.0_f64; 8]);
    assert_eq!(COUNT.with(Cell::get), counted + 1, "the counter counts");
}
