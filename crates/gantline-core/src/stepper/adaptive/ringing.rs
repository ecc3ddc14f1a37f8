//! How long a step may be after forces have jumped.
//!
//! A swing that begins at once, of a load whose hook starts or of a sheave whose sling goes taut, has the amplitude A and the
//! circular frequency ω. With x = hω the error estimate of a step is A |ΔR(ix)|, the difference of the method's two stability
//! functions:
//!
//! ```text
//! x        1        3       4.6    10     30     50     60     100    500
//! |ΔR|     2e-4     0.05    0.2    0.61   0.38   0.24   0.20   0.12   0.02
//! ```
//!
//! Both go to zero, since the method is L-stable: a step that is far too long ends where the swing would come to rest, and
//! its estimate says that this is right. Steps that grow sixfold cannot pass over where it is seen, x from 4.6 to 60; after a
//! jump the last step says nothing, so there x ≤ 50, where a swing by [`SWITCHING`] tolerances still counts as more than one.
//!
//! With Δë the jump of a row's second derivative, k = 1/ε, and 1/m = Σ G²/M over the free degrees of freedom, the row swings
//! with the force m |Δë|; a row that has just begun to act, with ė, with √(k m) ė. ω² = Σ (Σ k G²)/M is the trace of the
//! stiffness that its degrees of freedom have of all rows: no less than any of their frequencies, but for the inertia that they
//! share.

use super::{Adaptive, SWITCHING};
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::system::System;

/// hω up to which the error estimate sees a swing.
const SEEN: f64 = 50.0;

impl Adaptive {
    /// The longest step [s] that sees what rings after the jump before it; infinite where there was none.
    pub(super) fn ringing_limit(&mut self, system: &System, state: &State) -> f64 {
        if !self.jumped && !state.engaged {
            return f64::INFINITY;
        }
        let is_free = |dof: usize| system.driven[dof].is_none() && !system.is_light[dof];
        let (tree, gradient) = (&system.tree, &self.rodas.here.frame.gradient);
        let springs = || {
            let acting = |row: &usize| state.modes[*row] == Mode::Acting;
            let all =
                (0..system.rows.count()).filter(acting).map(|row| (row, system.rows.laws[row].compliance()));
            all.filter(|(_, compliance)| *compliance > 0.0)
        };
        let stiffness = &mut self.rate.phi[..state.v.len()];
        stiffness.fill(0.0);
        for (row, compliance) in springs() {
            for (dof, entry) in system.rows.entries(gradient, row) {
                stiffness[dof] += entry * entry / compliance;
            }
        }
        let visible = SWITCHING * self.tolerance.tension;
        let mut limit = f64::INFINITY;
        for (row, compliance) in springs() {
            let (mut mobility, mut square, mut jump) = (0.0, 0.0, 0.0);
            for (dof, entry) in system.rows.entries(gradient, row) {
                jump += entry * (state.acceleration[dof] - self.before[dof]);
                if is_free(dof) {
                    mobility += entry * entry / tree.inertia_scale[dof];
                    square += stiffness[dof] / tree.inertia_scale[dof];
                }
            }
            if mobility == 0.0 {
                continue;
            }
            let mut swing = jump.abs() / mobility;
            if state.engaged && state.tension[row] <= visible {
                let rate = system.rows.rate(gradient, row, &state.v);
                swing += rate.max(0.0) / (compliance * mobility).sqrt();
            }
            if swing > visible {
                limit = limit.min(SEEN / square.sqrt());
            }
        }
        limit
    }
}

#[cfg(test)]
mod tests {
    use super::SEEN;
    use crate::stepper::adaptive::SWITCHING;
    use crate::stepper::adaptive::tableau::{A, C, GAMMA, STAGES};

    type Complex = [f64; 2];

    fn times(a: Complex, b: Complex) -> Complex {
        [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
    }

    fn over(a: Complex, b: Complex) -> Complex {
        times(a, [b[0], -b[1]]).map(|part| part / b[0].hypot(b[1]).powi(2))
    }

    fn sum(weights: &[f64], stages: &[Complex]) -> Complex {
        weights.iter().zip(stages).fold([0.0, 0.0], |[re, im], (w, k)| [re + w * k[0], im + w * k[1]])
    }

    /// |ΔR(ix)|: the last stage of a step of the length x of y' = iy from y = 1.
    fn seen(x: f64) -> f64 {
        let mut stages: Vec<Complex> = Vec::new();
        for i in 0..STAGES {
            let at = sum(A[i], &stages);
            let [re, im] = times([0.0, x], [1.0 + at[0], at[1]]);
            let before = sum(C[i], &stages);
            stages.push(over([re + before[0], im + before[1]], [1.0 / GAMMA, -x]));
        }
        let [re, im] = stages[STAGES - 1];
        re.hypot(im)
    }

    /// The table above, to the digits that it has.
    #[test]
    fn the_estimate_of_a_swing_falls_to_both_sides() {
        let table =
            [(1.0, 2.29e-4), (3.0, 0.0533), (4.6, 0.217), (10.0, 0.610), (50.0, 0.239), (500.0, 0.0246)];
        for (x, expected) in table {
            assert!((seen(x) / expected - 1.0).abs() < 5e-3, "{x}: {}", seen(x));
        }
    }

    /// A swing of as many tolerances as count rejects the step.
    #[test]
    fn what_counts_is_seen_at_the_limit() {
        assert!(SWITCHING * seen(SEEN) > 1.0);
    }
}
