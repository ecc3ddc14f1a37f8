//! Pins that are pulled and put in as steps of the plan begin.
//!
//! A pin that is pulled leaves everything where it is and at rest: nothing jumps but accelerations. One is put in only
//! where what it holds is at rest; what is left of its motion ends, and is booked as `impact`.

use super::StepError;
use super::frame::Frame;
use crate::event::{EventKind, EventLog};
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::system::System;

/// A joint that moves faster than this [m/s or rad/s] is not at rest: a pin does not go in.
const REST: f64 = 1e-3;

/// Does what the steps that have begun say; true where any pin changed. `frame` belongs to the state.
///
/// # Errors
/// [`StepError`] where a pin is to be put in and what it holds moves.
pub fn act(system: &System, state: &mut State, frame: &Frame, log: &mut EventLog) -> Result<bool, StepError> {
    let mut any = false;
    for pinning in &system.pins {
        let row = system.rows.first[pinning.pin];
        let (wanted, step) = pinning.wanted(state.plan.begun());
        if wanted == (state.modes[row] == Mode::Acting) {
            continue;
        }
        if wanted {
            put_in(system, state, frame, row)?;
        } else {
            state.modes[row] = Mode::Slack;
            (state.tension[row], state.trial[row]) = (0.0, 0.0);
        }
        let time = step.and_then(|step| log.begin_of(step)).unwrap_or(state.time);
        let kind = if wanted { EventKind::PinPutIn } else { EventKind::PinPulled };
        log.push(time, kind, pinning.pin);
        any = true;
    }
    Ok(any)
}

fn put_in(system: &System, state: &mut State, frame: &Frame, row: usize) -> Result<(), StepError> {
    let speed = system.rows.rate(&frame.gradient, row, &state.v);
    if speed.abs() > REST {
        let element = system.constraint_of_row(row).name().to_owned();
        let cause = format!(
            "its pin cannot be put in while it moves by {:.3} m/s; hold until it is at rest",
            speed.abs()
        );
        return Err(StepError { time: state.time, element, cause });
    }
    let before = frame.mass.quadratic(&state.v);
    for (dof, entry) in system.rows.entries(&frame.gradient, row) {
        state.v[dof] -= speed / entry;
    }
    state.ledger.flows.impact += 0.5 * (before - frame.mass.quadratic(&state.v));
    state.modes[row] = Mode::Acting;
    Ok(())
}
