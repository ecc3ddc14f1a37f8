//! Drums that turn round, on the course of a step.

use super::Adaptive;
use super::seating::halve;
use crate::state::State;
use crate::system::System;

/// Way of a drum after it has turned round [m] that makes no difference.
const SLIGHT: f64 = 1e-9;
/// Speed [m/s] at which it has turned round for certain: the next step begins with it.
const ROUND: f64 = 1e-9;

impl Adaptive {
    /// The share at which a drum first turns round, or `made`: there other rope begins to pass it, so the step ends.
    pub(super) fn winds_up_to(&mut self, system: &System, state: &State, made: f64) -> f64 {
        let mut made = made;
        for place in &system.coils {
            let before = state.v[place.dof];
            let mut motion = |theta: f64| {
                self.rodas.course.at(theta, &mut self.point);
                (self.point.phi[place.dof], self.point.v[place.dof])
            };
            let (way, after) = motion(made);
            let has_turned = |v: f64| v * before.signum() < -ROUND;
            if before == 0.0 || !has_turned(after) {
                continue;
            }
            let share = halve(made, |theta| has_turned(motion(theta).1));
            if (motion(share).0 - way).abs() > SLIGHT {
                made = share;
            }
        }
        made
    }

    /// Adds one look to the means along the part of the step that is made, after `rate.phi` has the defects.
    pub(super) fn look_at_coils(&mut self, system: &System, duration: f64) {
        for (index, place) in system.coils.iter().enumerate() {
            let frame = &self.probe.frame;
            let course = self.point.v[place.dof] + self.rate.phi[place.dof];
            let pull = self.probe.tension[place.row] * frame.passing[index].supply;
            let Paid { time, let_go, pull: sum } = &mut self.paid[index];
            *time += duration;
            *let_go += duration * frame.feeding[index] * course;
            *sum += duration * pull;
        }
    }

    /// Pieces of rope of different strain follow each other over the rim, at moments that no look knows: what comes
    /// off is known and the looks have their mean of it. Their difference is work of the method on the span.
    pub(super) fn book_pieces(&mut self, system: &System, state: &State) {
        for (index, (place, coil)) in system.coils.iter().zip(&state.coils).enumerate() {
            let Paid { time, let_go, pull } = self.paid[index];
            if !coil.winds && time > 0.0 {
                let known = self.rodas.here.q[place.supply] - state.q[place.supply];
                self.flows.method -= pull / time * (known - let_go);
            }
        }
    }
}

/// What the looks at a step see of a drum.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Paid {
    /// Duration of the looks so far [s].
    pub time: f64,
    /// Unstretched rope let go by them [m].
    pub let_go: f64,
    /// Force on the supply times their duration [N s].
    pub pull: f64,
}
