//! Ropes that leave a sheave or come back, on the course of a step.

use super::Adaptive;
use crate::event::EventLog;
use crate::state::State;
use crate::stepper::seats;
use crate::system::System;

/// Halvings that find when a rope crosses over.
const HALVINGS: usize = 40;

impl Adaptive {
    /// The share at which a rope first leaves a sheave that it may leave, or touches it again, or `made`: there its
    /// way changes, so the step ends.
    pub(super) fn seated_up_to(&mut self, system: &System, state: &State, made: f64) -> f64 {
        let mut crossed = |theta: f64| {
            self.probe_wraps(system, state, theta);
            let seats = system.sheaves.iter().zip(&state.seats).zip(&self.wraps);
            seats
                .into_iter()
                .any(|((sheave, seat), &wrap)| sheave.may_lift_off && seats::has_crossed(seat, wrap))
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
        seats::wraps(system, &self.next.frame.kinematics, &state.seats, &mut self.wraps);
        for index in 0..state.seats.len() {
            let end = self.wraps[index];
            if !seats::has_crossed(&state.seats[index], end) {
                continue;
            }
            let made = self.made;
            self.crossings[index] = halve(1.0, |share| {
                self.probe_wraps(system, state, share * made);
                seats::has_crossed(&state.seats[index], self.wraps[index])
            });
            seats::wraps(system, &self.next.frame.kinematics, &state.seats, &mut self.wraps);
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

    fn probe_wraps(&mut self, system: &System, state: &State, theta: f64) {
        self.probe_rows(system, state, theta);
        seats::wraps(system, &self.probe.frame.kinematics, &state.seats, &mut self.wraps);
    }
}

/// The least share up to `most` at which `crossed` holds, which it does at `most`.
fn halve(most: f64, mut crossed: impl FnMut(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, most);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if crossed(middle) { high = middle } else { low = middle }
    }
    high
}
