//! How ropes lie on their sheaves from step to step: wraps by continuity, ropes that leave a sheave or come back.

use super::StepError;
use crate::constraint::rope::Rope;
use crate::constraint::rope::span::Span;
use crate::event::{EventKind, EventLog};
use crate::rope::seat::{Seat, Winding};
use crate::state::State;
use crate::system::System;
use crate::tree::kinematics::Kinematics;

/// How far ahead a failed step looks for what stopped it [s].
const AHEAD: [f64; 3] = [1e-9, 1e-6, 1e-3];

/// What is wound on all sheaves at the poses, each closest to what its seat in `state` remembers; what a rope that
/// has parted left stays.
pub fn wraps(system: &System, kinematics: &Kinematics, state: &State, out: &mut [Winding]) {
    for (wound, seat) in out.iter_mut().zip(&state.seats) {
        *wound = seat.wound;
    }
    for rope in whole_ropes(system, state).filter(|rope| !rope.route.is_plain) {
        rope.route.wraps(kinematics, &state.seats, |seat, wound| out[seat] = wound);
    }
}

/// Ropes that are on and have not parted.
fn whole_ropes<'a>(system: &'a System, state: &'a State) -> impl Iterator<Item = &'a Rope> {
    let ropes = system.ropes().zip(&system.rows.first);
    ropes.filter(|&(_, &row)| !state.modes[row].is_absent()).map(|(rope, _)| rope)
}

/// True where the rope has crossed over between on and off with this wrap.
pub fn has_crossed(seat: &Seat, wrap: f64) -> bool {
    seat.is_off != (wrap < 0.0)
}

/// Lets the seats follow to `wraps` at the end of a step; `time` says when a seat crossed over, from its number and
/// its wraps before and after. True where a rope has changed its way by that.
pub fn follow(
    system: &System,
    state: &mut State,
    wraps: &[Winding],
    log: &mut EventLog,
    mut time: impl FnMut(usize, f64, f64) -> f64,
) -> bool {
    let mut any = false;
    for (index, (seat, &wound)) in state.seats.iter_mut().zip(wraps).enumerate() {
        if has_crossed(seat, wound.wrap) {
            seat.is_off = !seat.is_off;
            let kind = if seat.is_off { EventKind::RopeOffSheave } else { EventKind::RopeOnSheave };
            log.push(time(index, seat.wound.wrap, wound.wrap), kind, index);
            any |= system.sheaves[index].may_lift_off;
        }
        seat.wound = wound;
    }
    any
}

/// The rope of which nothing is left between two places that it passes, if there is one, as `is` says of a span.
pub fn used_up(system: &System, state: &State, is: impl Fn(&Span, &[f64]) -> bool) -> Option<StepError> {
    let rope = whole_ropes(system, state).find(|rope| rope.spans.iter().any(|span| is(span, &state.q)))?;
    let cause = "there is no rope left between two of the places that it passes".to_owned();
    Some(StepError { time: state.time, element: rope.name.clone(), cause })
}

/// The rope that has no tangent to a sheave where the motion leads, in place of `error` where there is one.
pub fn explain(system: &System, state: &State, error: StepError) -> StepError {
    let mut kinematics = Kinematics::new(&system.tree);
    for ahead in AHEAD {
        let mut q = state.q.clone();
        let increment: Vec<f64> = state.v.iter().map(|v| ahead * v).collect();
        system.tree.advance(&mut q, &increment);
        kinematics.update(&system.tree, &q, state.time);
        for rope in whole_ropes(system, state) {
            if let Some((part, reason)) = rope.route.refusal(&kinematics, &state.seats) {
                let cause = format!("its part {}: {reason}", part + 1);
                return StepError { time: state.time, element: rope.name.clone(), cause };
            }
        }
    }
    error
}
