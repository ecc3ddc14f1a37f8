//! Lengths adjusted after a step: the equalizer without sheaves of the literature before Ham, Roh and Lee (2016), after
//! Cha et al., in our reading. The unstretched length of the more loaded ropes of a group grows, that of the others
//! shrinks by as much in total. With ε = L/EA,
//!
//! ```text
//! ΔL_i = f ε_i (T_i − T̄)        T̄ = Σ ε_i T_i / Σ ε_i
//! ```
//!
//! That is the one mean for which Σ ΔL_i = 0. While the ends of taut ropes stand still, T_i − T̄ becomes (1 − f) times
//! what it was: nothing is left of it at f = 1. A slack rope has T_i = 0 and is shortened; one that has parted or is off
//! takes no part. ε stays that of the length at the start. The row's value is ℓ − L − m, m the sum of all ΔL, which the state remembers.

use crate::audit::spring_energy;
use crate::state::State;
use crate::stepper::frame::{Frame, Remembered};
use crate::system::System;

/// Adjusts the lengths of all groups by the tensions of `state`; `frame` follows, and the books have what the springs
/// give up.
pub fn adjust(system: &System, state: &mut State, frame: &mut Frame) {
    let laws = &system.rows.laws;
    for adjuster in &system.adjusters {
        let (mut weighted, mut total) = (0.0, 0.0);
        let is_on = |row: &&usize| !state.modes[**row].is_absent();
        for &row in adjuster.rows.iter().filter(is_on) {
            weighted += laws[row].compliance() * state.tension[row];
            total += laws[row].compliance();
        }
        let mean = weighted / total;
        for &row in adjuster.rows.iter().filter(is_on) {
            let change = adjuster.factor * laws[row].compliance() * (state.tension[row] - mean);
            let before = frame.value[row];
            let after = before - change;
            state.memory[row] += change;
            state.ledger.flows.adjusting +=
                spring_energy(&laws[row], before) - spring_energy(&laws[row], after);
        }
    }
    if !system.adjusters.is_empty() {
        // Anew, and not by what has changed: a run that is taken up again evaluates them like that.
        frame.rows(system, &state.q, &Remembered::of(state));
    }
}
