//! Pins that are pulled and put in as steps of the plan begin.
//!
//! A pin that is pulled leaves everything where it is and at rest: nothing jumps but accelerations. One is put in only
//! where what it holds is at rest. What is left of its motion then ends at once: an impact, M Δv + Gᵀ p = 0 with
//! q̇ = 0 of the pin's joint, which each method solves in its own way and books as `impact`.

use super::StepError;
use super::frame::Frame;
use crate::event::{EventKind, EventLog};
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::system::System;
use crate::tree::joint::Motion;

/// A joint that moves faster than this [m/s or rad/s] is not at rest: a pin does not go in.
const REST: f64 = 1e-3;

/// What [`act`] did.
#[derive(Debug, Clone, Copy, Default)]
pub struct Acted {
    /// True where any pin changed.
    pub any: bool,
    /// True where one was put in: what it holds may still move.
    pub put_in: bool,
}

/// Does what the steps that have begun say. `frame` belongs to the state.
///
/// # Errors
/// [`StepError`] where a pin is to be put in and what it holds moves.
pub fn act(
    system: &System,
    state: &mut State,
    frame: &Frame,
    log: &mut EventLog,
) -> Result<Acted, StepError> {
    let mut acted = Acted::default();
    for pinning in &system.pins {
        let row = system.rows.first[pinning.constraint];
        let (wanted, step) = pinning.wanted(state.plan.begun());
        if wanted == (state.modes[row] == Mode::Acting) {
            continue;
        }
        if wanted {
            refuse_motion(system, state, frame, row)?;
            state.modes[row] = Mode::Acting;
            acted.put_in = true;
        } else {
            state.modes[row] = Mode::Slack;
            (state.tension[row], state.trial[row]) = (0.0, 0.0);
        }
        let time = step.and_then(|step| log.begin_of(step)).unwrap_or(state.time);
        let kind = if wanted { EventKind::PinPutIn } else { EventKind::PinPulled };
        log.push(time, kind, pinning.constraint);
        acted.any = true;
    }
    Ok(acted)
}

fn refuse_motion(system: &System, state: &State, frame: &Frame, row: usize) -> Result<(), StepError> {
    let speed = system.rows.rate(&frame.gradient, row, &state.v).abs();
    if speed <= REST {
        return Ok(());
    }
    let element = system.constraint_of_row(row).name().to_owned();
    let turns =
        system.rows.entries(&frame.gradient, row).any(|(dof, _)| system.tree.motions[dof] == Motion::Turn);
    let unit = if turns { "rad/s" } else { "m/s" };
    let cause =
        format!("its pin cannot be put in while it moves by {speed:.3} {unit}; hold until it is at rest");
    Err(StepError { time: state.time, element, cause })
}
