//! Supports that are taken away, at a time or as a step of the plan begins. From then on they carry nothing, for good.
//!
//! What a support held is set free in itself: it is lost, and booked as `parting`, like that of a rope that is cut.

use super::frame::Frame;
use super::parting::moment;
use super::spots::note_lift_off;
use crate::audit::spring_energy;
use crate::constraint::AnyConstraint;
use crate::event::{EventKind, EventLog};
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::system::System;

/// Takes away the supports that are due before `to` [s]; true where any went. `frame` belongs to the state.
pub fn remove(system: &System, state: &mut State, frame: &Frame, to: f64, log: &mut EventLog) -> bool {
    let mut any = false;
    for removal in &system.removals {
        let rows = system.rows.first[removal.touch]..system.rows.first[removal.touch + 1];
        if state.modes[rows.start] == Mode::Parted || !removal.due.is_before(to, &state.plan) {
            continue;
        }
        let time = moment(removal.due, state, log);
        log.push(time, EventKind::SupportRemoved, removal.touch);
        let carried = state.modes[rows.start].carries();
        for row in rows {
            if state.modes[row].carries() || row == system.rows.first[removal.touch] {
                state.ledger.flows.parting += spring_energy(&system.rows.laws[row], frame.value[row]);
            }
            state.modes[row] = Mode::Parted;
            (state.tension[row], state.trial[row]) = (0.0, 0.0);
        }
        if let (AnyConstraint::Touch(touch), true) = (&system.constraints[removal.touch], carried) {
            note_lift_off(system, state, touch.group, time, log);
        }
        any = true;
    }
    any
}

/// When the next support is taken away, not before `from` [s], as far as that is a time.
pub fn next_removal(system: &System, from: f64) -> f64 {
    system.removals.iter().map(|removal| removal.due.time_from(from)).fold(f64::INFINITY, f64::min)
}
