//! Ropes that leave a sheave or come back, on the course of a step.

use super::Adaptive;
use crate::event::EventLog;
use crate::rope::seat::Winding;
use crate::state::State;
use crate::stepper::seats;
use crate::system::System;

/// How much a wrap may change in a step [rad]. Of angles that differ by whole turns the next is the closest to the
/// last, so that half a turn would be too much.
const MOST_WOUND: f64 = 1.0;
/// Time over which the rate of a wrap is seen [s].
const GLANCE: f64 = 1e-3;
/// Halvings that find when a rope crosses over.
const HALVINGS: usize = 40;

impl Adaptive {
    /// The longest step in which no wrap changes by more than [`MOST_WOUND`], by its rate and acceleration at the
    /// start of the step [s].
    pub(super) fn winding_limit(&mut self, system: &System, state: &State) -> f64 {
        if state.seats.is_empty() {
            return f64::INFINITY;
        }
        let mut change = |time: f64, into: &mut Vec<Winding>| {
            let motion = state.v.iter().zip(&state.acceleration);
            for (phi, (v, a)) in self.point.phi.iter_mut().zip(motion) {
                *phi = time * (v + 0.5 * time * a);
            }
            self.probe.q.copy_from_slice(&state.q);
            system.tree.advance(&mut self.probe.q, &self.point.phi);
            self.probe.frame.kinematics.update(&system.tree, &self.probe.q, state.time);
            seats::wraps(system, &self.probe.frame.kinematics, state, into);
        };
        change(GLANCE, &mut self.wraps);
        change(-GLANCE, &mut self.unwound);
        let wraps = self.wraps.iter().zip(&self.unwound).zip(&state.seats);
        let limit = |after: f64, before: f64, now: f64| {
            let rate = (after - before).abs() / (2.0 * GLANCE);
            let bend = (after - 2.0 * now + before).abs() / (GLANCE * GLANCE);
            // h β̇ + h² β̈/2 is no more than the most.
            2.0 * MOST_WOUND / (rate + (rate * rate + 2.0 * MOST_WOUND * bend).sqrt())
        };
        let limits = wraps.map(|((after, before), seat)| {
            let angles = |wound: &Winding| [wound.wrap, wound.arrived];
            let [after, before, now] = [after, before, &seat.wound].map(angles);
            limit(after[0], before[0], now[0]).min(limit(after[1], before[1], now[1]))
        });
        limits.fold(f64::INFINITY, f64::min)
    }

    /// The share at which a rope first leaves a sheave that it may leave, or touches it again, or `made`: there its
    /// way changes, so the step ends.
    pub(super) fn seated_up_to(&mut self, system: &System, state: &State, made: f64) -> f64 {
        let mut crossed = |theta: f64| {
            self.probe_wraps(system, state, theta);
            let seats = system.sheaves.iter().zip(&state.seats).zip(&self.wraps);
            seats
                .into_iter()
                .any(|((sheave, seat), wound)| sheave.may_lift_off && seats::has_crossed(seat, wound.wrap))
        };
        if !system.sheaves.iter().any(|sheave| sheave.may_lift_off) || !crossed(made) {
            return made;
        }
        halve(made, crossed)
    }

    /// Where on the part of the step that is made, of which the end is evaluated, ropes cross over.
    pub(super) fn look_at_seats(&mut self, system: &System, state: &State) {
        if state.seats.is_empty() {
            return;
        }
        seats::wraps(system, &self.next.frame.kinematics, state, &mut self.wraps);
        for index in 0..state.seats.len() {
            let end = self.wraps[index].wrap;
            if !seats::has_crossed(&state.seats[index], end) {
                continue;
            }
            let made = self.made;
            self.crossings[index] = halve(1.0, |share| {
                self.probe_wraps(system, state, share * made);
                seats::has_crossed(&state.seats[index], self.wraps[index].wrap)
            });
            seats::wraps(system, &self.next.frame.kinematics, state, &mut self.wraps);
        }
    }

    /// Lets the seats follow to the end of the step, which started at `start` [s] and was `length` [s] long; true
    /// where a rope changed its way.
    pub(super) fn follow_seats(
        &mut self,
        system: &System,
        state: &mut State,
        log: &mut EventLog,
        (start, length): (f64, f64),
    ) -> bool {
        let time = |index: usize, _, _| start + length * self.crossings[index];
        seats::follow(system, state, &self.wraps, log, time)
    }

    /// False where the step leads to where a rope has no tangent to a sheave; a slack rope alone does not show.
    pub(super) fn has_tangents(&mut self, system: &System, state: &State) -> bool {
        if state.seats.is_empty() {
            return true;
        }
        self.probe_frozen(system, state, 1.0);
        let values = self.probe.frame.value.iter().zip(&state.modes);
        values.into_iter().all(|(value, mode)| value.is_finite() || mode.is_absent())
    }

    fn probe_wraps(&mut self, system: &System, state: &State, theta: f64) {
        self.probe_rows(system, state, theta);
        seats::wraps(system, &self.probe.frame.kinematics, state, &mut self.wraps);
    }
}

/// The least share up to `most` at which `crossed` holds, which it does at `most`.
pub(super) fn halve(most: f64, mut crossed: impl FnMut(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, most);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if crossed(middle) { high = middle } else { low = middle }
    }
    high
}
