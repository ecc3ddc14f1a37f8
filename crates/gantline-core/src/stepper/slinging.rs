//! Slings that steps of the plan put on and take off.
//!
//! One that is not on carries nothing and holds nothing. People take a sling off where it is slack, and the checks say
//! where it was not: what it held is then lost, as that of a rope that is cut. They put one on where it is long enough for
//! where its ends are: it is slack then, so nothing jumps, and one that is too short is an error. One that has parted while
//! it was on stays parted, whatever the plan says of it.

use super::StepError;
use super::frame::Frame;
use super::parting::let_go;
use crate::event::{EventKind, EventLog};
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::system::System;

/// Rounding of a distance that is as long as a sling, relative to 1 m and the sling.
const ROUNDING: f64 = 1e-9;

/// Does what the steps that have begun say; true where any changed. `frame` belongs to the state.
///
/// # Errors
/// [`StepError`] where a sling is to be put on that is too short for where its ends are.
pub fn act(system: &System, state: &mut State, frame: &Frame, log: &mut EventLog) -> Result<bool, StepError> {
    let mut any = false;
    for sling in &system.slings {
        let row = system.rows.first[sling.constraint];
        let (wanted, step) = sling.wanted(state.plan.begun());
        if state.modes[row] == Mode::Parted || wanted != (state.modes[row] == Mode::Off) {
            continue;
        }
        if wanted {
            refuse_short(system, state, frame, sling.constraint)?;
            state.modes[row] = Mode::Slack;
        } else {
            let_go(system, state, frame, sling.constraint, Mode::Off);
        }
        let time = step.and_then(|step| log.begin_of(step)).unwrap_or(state.time);
        let kind = if wanted { EventKind::Attached } else { EventKind::Detached };
        log.push(time, kind, sling.constraint);
        any = true;
    }
    Ok(any)
}

fn refuse_short(system: &System, state: &State, frame: &Frame, rope: usize) -> Result<(), StepError> {
    let length = system.ropes().nth(rope).map_or(0.0, |rope| rope.length);
    too_short(system, frame, &state.q, rope, ROUNDING * (1.0 + length), "here").map_or(Ok(()), |cause| {
        Err(StepError { time: state.time, element: system.rope_name(rope).to_owned(), cause })
    })
}

/// What is wrong where a sling is to be put on, `when` in words, that is by more than `most` [m] too short for where `frame` has
/// its ends, which belongs to the configuration `q`. It is as long as its chain hoist has made it.
pub fn too_short(
    system: &System,
    frame: &Frame,
    q: &[f64],
    rope: usize,
    most: f64,
    when: &str,
) -> Option<String> {
    // Of a sling that is fed, or bends by a curve, the value of the row is no length.
    if frame.value[system.rows.first[rope]] <= most {
        return None;
    }
    let rope = system.ropes().nth(rope)?;
    let length: f64 = rope.spans.iter().map(|span| span.unstretched(q)).sum();
    let arcs: f64 = rope.spans.iter().map(|span| span.arcs).sum();
    let apart = arcs + rope.straights(&frame.kinematics).map(|straight| straight.length).sum::<f64>();
    Some(format!(
        "it is to be put on {when}, is {length:.3} m long and {:.3} m too short: its ends are {apart:.3} m apart; \
         bring them nearer to each other in a step before, or make it longer",
        apart - length
    ))
}
