//! Torture rigs by seed and number, and what either method has to keep on them.

use std::time::{Duration, Instant};

use gantline_core::build::build;
use gantline_core::constraint::Law;
use gantline_core::event::EventLog;
use gantline_core::state::State;
use gantline_core::stepper::adaptive::{Adaptive, Tolerance};
use gantline_core::stepper::del::Del;
use gantline_core::stepper::frame::Frame;
use gantline_core::system::System;
use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestRunner};

use super::{Seeds, seeds, torture};

/// How long a rig runs [s].
const DURATION: f64 = 1.0;
/// More steps than any of the rigs needs: a stall.
const MOST_STEPS: u64 = 200_000;
/// So that a rig that stalls does not hang the tests; the others need milliseconds.
const LONGEST: Duration = Duration::from_secs(20);

/// How the rigs of a seed are drawn: the same ones on every machine.
pub fn drawing(seed: u64, cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        max_shrink_iters: 30,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(seed),
        ..ProptestConfig::default()
    }
}

/// The first rigs of a seed.
pub fn drawn(seed: u64, count: u32) -> Vec<Seeds> {
    let rigs = std::cell::RefCell::new(Vec::new());
    let noted = TestRunner::new(drawing(seed, count)).run(&seeds(), |seeds| {
        rigs.borrow_mut().push(seeds);
        Ok(())
    });
    noted.expect("nothing fails");
    rigs.into_inner()
}

fn start(seeds: &[f64]) -> (System, State, Frame) {
    let (system, state) = build(&torture(seeds)).unwrap();
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    (system, state, frame)
}

/// `adaptive` runs to the end, its forces keep their laws and its energy balance closes. Returns the steps.
pub fn adaptive_closes(seeds: &[f64]) -> Result<u64, TestCaseError> {
    let (system, mut state, mut frame) = start(seeds);
    let tolerance = Tolerance::default_of(&system);
    let mut method = Adaptive::new(&system, &frame, tolerance);
    let mut log = EventLog::new();
    let began = Instant::now();
    while state.time < DURATION {
        let step = method.step(&system, &mut state, &mut frame, &mut log, DURATION);
        step.map_err(|error| TestCaseError::fail(error.to_string()))?;
        let stalls = state.steps >= MOST_STEPS || began.elapsed() > LONGEST;
        prop_assert!(!stalls, "stalls at t = {} after {} steps", state.time, state.steps);
        for (law, tension) in system.rows.laws.iter().zip(&state.tension) {
            let pulls = matches!(law, Law::Friction { .. }) || *tension >= 0.0;
            prop_assert!(tension.is_finite() && pulls);
        }
    }
    prop_assert!(state.time == DURATION);
    // Steps near impacts are cut at the tolerance; what that costs is far below a thousandth.
    let remainder = state.ledger.relative_remainder();
    prop_assert!(remainder < 1e-3, "{remainder} {:?}", state.ledger);
    Ok(state.steps)
}

/// `del` at 1 ms runs to the end, its forces keep their laws and it does not feed the rig.
pub fn del_stays_bounded(seeds: &[f64]) -> Result<(), TestCaseError> {
    let (system, mut state, mut frame) = start(seeds);
    // Several inextensible ropes may repeat one another in a step; `del` refuses that by name.
    prop_assume!(system.rigid.len() < 2);
    let mut method = Del::new(&system, 1e-3, true);
    let mut log = EventLog::new();
    let stored = |state: &State| {
        let [kinetic, gravity, elastic, ..] = state.ledger.values();
        kinetic + gravity + elastic
    };
    let (before, mut scale) = (stored(&state), 0.0_f64);
    for _ in 0..1000 {
        let report = method.step(&system, &mut state, &mut frame, &mut log);
        let report = report.map_err(|error| TestCaseError::fail(error.to_string()))?;
        let most = state.tension.iter().fold(1.0_f64, |most, tension| most.max(tension.abs()));
        prop_assert!(!report.converged || report.complementarity_residual <= 1e-6 * most);
        let [kinetic, gravity, elastic, ..] = state.ledger.values();
        scale = scale.max(kinetic + elastic + gravity.abs());
    }
    // A fixed step of 1 ms cannot follow these rigs, but it must not feed them.
    prop_assert!(stored(&state) - before < 0.5 * scale, "{:?}", state.ledger);
    Ok(())
}
