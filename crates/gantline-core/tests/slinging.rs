//! Random rigs in which every other rope is put on, taken off and put on again: it carries nothing while it is off, what is
//! recorded of it says so, and the balance closes across it. A rope that is too short where it is put on is an error.

use super::rigs::runs::{SEED, drawing};
use super::rigs::{seeds, torture};
use gantline_core::build::build;
use gantline_core::event::{Event, EventKind, EventLog};
use gantline_core::solver::complementarity::Mode;
use gantline_core::spec::{StepSpec, SystemSpec};
use gantline_core::state::State;
use gantline_core::stepper::StepError;
use gantline_core::stepper::adaptive::{Adaptive, Tolerance};
use gantline_core::stepper::del::Del;
use gantline_core::stepper::frame::Frame;
use gantline_core::system::System;
use proptest::prelude::*;

const DURATION: f64 = 1.0;
/// Steps of fixed length [s].
const STEP: f64 = 1e-3;
/// More steps than any of the rigs needs: a stall.
const MOST_STEPS: u64 = 50_000;

fn slung(seeds: &[f64]) -> SystemSpec {
    let mut spec = torture(seeds);
    let names =
        spec.ropes.iter().step_by(2).map(|rope| format!("\"{}\"", rope.name)).collect::<Vec<_>>().join(", ");
    let step = |name: &str, what: &str| -> StepSpec {
        let until = r#"{"type": "duration", "duration": 0.2}"#;
        let text = format!(r#"{{"name": "{name}", "until": {until}, "{what}": [{names}]}}"#);
        serde_json::from_str(&text).unwrap()
    };
    let wait =
        serde_json::from_str(r#"{"name": "wait", "until": {"type": "duration", "duration": 0.1}}"#).unwrap();
    spec.plan = vec![wait, step("on", "attaches"), step("off", "detaches"), step("again", "attaches")];
    // Sticking and sliding of contacts is another matter.
    for contact in &mut spec.contacts {
        contact.friction = 0.0;
    }
    spec
}

fn start(seeds: &[f64]) -> (System, State, Frame) {
    let (system, state) = build(&slung(seeds)).unwrap();
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    (system, state, frame)
}

/// What is off carries nothing, and there is an event for every change.
fn check(system: &System, state: &State, log: &EventLog) -> Result<(), TestCaseError> {
    for sling in &system.slings {
        let row = system.rows.first[sling.constraint];
        let is_off = state.modes[row] == Mode::Off;
        prop_assert!(!is_off || state.tension[row] == 0.0);
        let changes = |event: &&Event| {
            event.subject == sling.constraint
                && matches!(event.kind, EventKind::Attached | EventKind::Detached)
        };
        let last = log.events.iter().rfind(changes);
        prop_assert_eq!(last.is_none_or(|event| event.kind == EventKind::Detached), is_off);
    }
    Ok(())
}

/// Whether a run ended since a rope was too short; any other error fails.
fn is_short<T>(system: &System, made: Result<T, StepError>) -> Result<bool, TestCaseError> {
    let Err(error) = made else { return Ok(false) };
    let is_sling = system.slings.iter().any(|sling| system.rope_name(sling.constraint) == error.element);
    prop_assert!(is_sling && error.cause.contains(" too short: its ends are "), "{}", error);
    Ok(true)
}

proptest! {
    #![proptest_config(drawing(SEED, 40))]

    #[test]
    fn adaptive_runs_to_the_end(seeds in seeds()) {
        let (system, mut state, mut frame) = start(&seeds);
        let mut method = Adaptive::new(&system, &frame, Tolerance::default_of(&system));
        let mut log = EventLog::new();
        while state.time < DURATION {
            let made = method.step(&system, &mut state, &mut frame, &mut log, DURATION);
            if is_short(&system, made)? {
                return Ok(());
            }
            prop_assert!(state.steps < MOST_STEPS, "stalls at t = {}", state.time);
            check(&system, &state, &log)?;
        }
        prop_assert!(system.slings.iter().all(|sling| sling.wanted(state.plan.begun()).0));
        let remainder = state.ledger.relative_remainder();
        prop_assert!(remainder < 1e-3, "{remainder} {:?}", state.ledger);
    }

    #[test]
    fn del_runs_to_the_end(seeds in seeds()) {
        let (system, mut state, mut frame) = start(&seeds);
        prop_assume!(system.rigid.len() < 2);
        let mut method = Del::new(&system, STEP, true);
        let mut log = EventLog::new();
        for _ in 0..(DURATION / STEP) as usize {
            let made = method.step(&system, &mut state, &mut frame, &mut log);
            if is_short(&system, made)? {
                return Ok(());
            }
            check(&system, &state, &log)?;
        }
    }
}
