//! When a rope breaks along the course of a step.

use super::{Adaptive, LOOKS};
use crate::constraint::rope::Rope;
use crate::force::mooring::Mooring;
use crate::state::State;
use crate::system::System;

impl Adaptive {
    /// The share of the course at which a rope first reaches its breaking force, where one does in the part that is
    /// made. It then ends there, and the rope breaks at the start of the next step.
    ///
    /// The polynomials through the looks say between which points; the course itself is asked for the time.
    pub(super) fn first_break(&mut self, system: &System, state: &State) -> Option<f64> {
        let mut first = None;
        for &(index, force) in &system.fragile {
            let Some(rope) = system.ropes().nth(index) else { continue };
            let begin = system.rows.first[index];
            let spans = (begin..).zip(&rope.spans);
            // One that goes taut does so at the end of the step at the earliest, and breaks after that.
            for (row, span) in spans.filter(|&(row, _)| state.modes[row].carries()) {
                let reached = self.looks.reaches(row, force / span.scale(&self.next.q));
                let Some((low, high)) = reached else { continue };
                let share = self.break_between(system, state, [low, high], (row, rope, row - begin), force);
                if first.is_none_or(|first| share < first) {
                    first = Some(share);
                }
            }
        }
        for mooring in system.moorings().filter(|mooring| mooring.is_whole(&state.q)) {
            let Some(force) = mooring.breaking_force else { continue };
            let share = self.line_breaks(system, state, mooring, force);
            first = first.into_iter().chain(share).reduce(f64::min);
        }
        first
    }

    /// When a mooring line first reaches its breaking force, as far as the looks tell.
    fn line_breaks(&mut self, system: &System, state: &State, mooring: &Mooring, force: f64) -> Option<f64> {
        let made = self.made;
        let mut reached = |share: f64| {
            self.probe_rows(system, state, share);
            mooring.tension_of(&system.tree, &self.probe.frame.kinematics, &self.point.v) >= force
        };
        let mut low = 0.0;
        for look in LOOKS.map(|look| look * made) {
            if reached(look) {
                let mut high = look;
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    *(if reached(middle) { &mut high } else { &mut low }) = middle;
                }
                return Some(high);
            }
            low = look;
        }
        None
    }

    fn break_between(
        &mut self,
        system: &System,
        state: &State,
        bracket: [f64; 2],
        (row, rope, span): (usize, &Rope, usize),
        force: f64,
    ) -> f64 {
        let [mut low, mut high] = bracket.map(|share| share * self.made);
        // Down to the last bit.
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            self.probe_rows(system, state, middle);
            let probe = &self.probe;
            let tension = rope.tension(span, &probe.frame.kinematics, &probe.q, probe.trial[row]);
            if tension >= force { high = middle } else { low = middle }
        }
        high
    }
}
