//! Ropes that part: cut at a time, or broken by their tension. From then on they carry nothing, for good.
//!
//! What a rope held is set free in itself, which is no part of the system: it is lost, and booked as `parting`.

use super::frame::Frame;
use crate::audit::spring_energy;
use crate::event::{EventKind, EventLog};
use crate::plan::Due;
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::system::System;

/// Rounding of a tension that has reached the breaking force, relative to it.
const ROUNDING: f64 = 1e-9;

/// Cuts the ropes that are due before `to` [s]; true where any parted. `frame` belongs to the state.
pub fn cut(system: &System, state: &mut State, frame: &Frame, to: f64, log: &mut EventLog) -> bool {
    let mut any = false;
    for cut in &system.cuts {
        if cut.due.is_before(to, &state.plan) && is_whole(system, state, cut.rope) {
            log.push(moment(cut.due, state, log), EventKind::Cut, cut.rope);
            part(system, state, frame, cut.rope);
            any = true;
        }
    }
    any
}

/// When the next rope is cut, not before `from` [s], as far as that is a time.
pub fn next_cut(system: &System, from: f64) -> f64 {
    system.cuts.iter().map(|cut| cut.due.time_from(from)).fold(f64::INFINITY, f64::min)
}

/// When what is due happens [s].
pub fn moment(due: Due, state: &State, log: &EventLog) -> f64 {
    match due {
        Due::At(time) => time,
        Due::Step(step) => log.begin_of(step).unwrap_or(state.time),
    }
}

/// Breaks the ropes whose tension has reached their breaking force; true where any did. `frame` belongs to the state.
pub fn break_ropes(system: &System, state: &mut State, frame: &Frame, log: &mut EventLog) -> bool {
    let mut any = false;
    for &(rope, force) in &system.fragile {
        if is_whole(system, state, rope) && tension(system, state, rope) >= force * (1.0 - ROUNDING) {
            log.push(state.time, EventKind::Broken, rope);
            part(system, state, frame, rope);
            any = true;
        }
    }
    any
}

fn is_whole(system: &System, state: &State, rope: usize) -> bool {
    state.modes[system.rows.first[rope]] != Mode::Parted
}

/// The largest tension along a rope [N].
fn tension(system: &System, state: &State, rope: usize) -> f64 {
    let spans = system.ropes().nth(rope).into_iter().flat_map(|rope| &rope.spans);
    let forces = spans.zip(&state.tension[system.rows.first[rope]..]);
    forces.map(|(span, force)| span.scale(&state.q) * force).fold(0.0, f64::max)
}

fn part(system: &System, state: &mut State, frame: &Frame, rope: usize) {
    for row in system.rows.first[rope]..system.rows.first[rope + 1] {
        state.ledger.flows.parting += spring_energy(&system.rows.laws[row], frame.value[row]);
        state.modes[row] = Mode::Parted;
        (state.tension[row], state.trial[row]) = (0.0, 0.0);
    }
}
