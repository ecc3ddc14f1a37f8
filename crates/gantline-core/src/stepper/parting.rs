//! Ropes and mooring lines that part: cut at a time, or broken by their tension. From then on they carry
//! nothing, for good.
//!
//! What a rope held is set free in itself, which is no part of the system: it is lost, and booked as `parting`.

use super::frame::Frame;
use crate::audit::spring_energy;
use crate::event::{EventKind, EventLog};
use crate::force::Force;
use crate::plan::Due;
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::system::System;

/// Rounding of a tension that has reached the breaking force, relative to it.
const ROUNDING: f64 = 1e-9;

/// Cuts the ropes that are due before `to` [s]; true where any parted. `frame` belongs to the state.
pub fn cut(system: &System, state: &mut State, frame: &mut Frame, to: f64, log: &mut EventLog) -> bool {
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
pub fn break_ropes(system: &System, state: &mut State, frame: &mut Frame, log: &mut EventLog) -> bool {
    let mut any = false;
    for (line, mooring) in system.moorings().enumerate() {
        let rope = system.rope_count + line;
        let Some(force) = mooring.breaking_force.filter(|_| is_whole(system, state, rope)) else { continue };
        if mooring.tension_of(&system.tree, &frame.kinematics, &state.v) >= force * (1.0 - ROUNDING) {
            log.push(state.time, EventKind::Broken, rope);
            part(system, state, frame, rope);
            any = true;
        }
    }
    for &(rope, force) in &system.fragile {
        if is_whole(system, state, rope) && tension(system, state, frame, rope) >= force * (1.0 - ROUNDING) {
            log.push(state.time, EventKind::Broken, rope);
            part(system, state, frame, rope);
            any = true;
        }
    }
    any
}

fn is_whole(system: &System, state: &State, rope: usize) -> bool {
    if let Some(line) = rope.checked_sub(system.rope_count) {
        return system.moorings().nth(line).is_some_and(|mooring| mooring.is_whole(&state.q));
    }
    state.modes[system.rows.first[rope]] != Mode::Parted
}

/// The largest tension along a rope [N].
fn tension(system: &System, state: &State, frame: &Frame, rope: usize) -> f64 {
    let forces = &state.tension[system.rows.first[rope]..system.rows.first[rope + 1]];
    let Some(rope) = system.ropes().nth(rope) else { return 0.0 };
    let of = |(span, force): (usize, &f64)| rope.tension(span, &frame.kinematics, &state.q, *force);
    forces.iter().enumerate().map(of).fold(0.0, f64::max)
}

fn part(system: &System, state: &mut State, frame: &mut Frame, rope: usize) {
    if let Some(line) = rope.checked_sub(system.rope_count) {
        if let Some(mooring) = system.moorings().nth(line) {
            let kinematics = &mut frame.kinematics;
            let pose = &kinematics.pose[mooring.body];
            state.ledger.flows.parting += mooring.energy(pose, system.tree.gravity, &state.q);
            // Also where the forces are seen from before all is evaluated anew.
            (state.q[mooring.mark], kinematics.q[mooring.mark]) = (1.0, 1.0);
        }
        return;
    }
    let_go(system, state, frame, rope, Mode::Parted);
}

/// Lets the rows of a rope carry nothing any more, in the mode that says why; what it held is lost.
pub fn let_go(system: &System, state: &mut State, frame: &Frame, rope: usize, mode: Mode) {
    for row in system.rows.first[rope]..system.rows.first[rope + 1] {
        if !state.modes[row].is_absent() {
            state.ledger.flows.parting += spring_energy(&system.rows.laws[row], frame.value[row]);
        }
        state.modes[row] = mode;
        (state.tension[row], state.trial[row]) = (0.0, 0.0);
    }
}
