//! When a rope breaks along the course of a step.

use super::Adaptive;
use crate::constraint::rope::span::Span;
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
            let spans = (system.rows.first[index]..).zip(&rope.spans);
            // One that goes taut does so at the end of the step at the earliest, and breaks after that.
            for (row, span) in spans.filter(|&(row, _)| state.modes[row].carries()) {
                let Some((low, high)) = self.looks.reaches(row, force / span.scale(&self.next.q)) else {
                    continue;
                };
                let share = self.break_between(system, state, [low, high], (row, span, force));
                if first.is_none_or(|first| share < first) {
                    first = Some(share);
                }
            }
        }
        first
    }

    fn break_between(
        &mut self,
        system: &System,
        state: &State,
        bracket: [f64; 2],
        (row, span, force): (usize, &Span, f64),
    ) -> f64 {
        let [mut low, mut high] = bracket.map(|share| share * self.made);
        // Down to the last bit.
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            self.probe_rows(system, state, middle);
            let reached = self.probe.trial[row] * span.scale(&self.probe.q) >= force;
            if reached { high = middle } else { low = middle }
        }
        high
    }
}
