//! The forces of all rows along the part of a step that is made, as polynomials through its start and the looks at its course: crossings,
//! peaks and samples cost no further evaluation.

use super::LOOKS;
use super::evaluation::Evaluation;
use crate::constraint::Law;
use crate::record::pulls::Bearers;
use crate::solver::complementarity::Mode;
use crate::system::System;

/// The start of a step and its looks.
pub(super) const POINTS: usize = LOOKS.len() + 1;

/// Shares of the step at the start and the looks.
pub(super) const TIMES: [f64; POINTS] = [0.0, LOOKS[0], LOOKS[1], LOOKS[2], LOOKS[3], LOOKS[4]];

/// How far a polynomial through values at these times goes past the largest of them at most, of what the values span:
/// (Λ − 1)/2 with Λ = 2.43, the largest sum of the sizes of Lagrange's polynomials. What rests is searched for no peak.
const OVERSHOOT: f64 = 0.72;

/// One over the time between point k and the one `order` before it, by order and k.
const SPANS: [[f64; POINTS]; POINTS] = {
    let mut spans = [[0.0; POINTS]; POINTS];
    let mut order = 1;
    while order < POINTS {
        let mut k = order;
        while k < POINTS {
            spans[order][k] = 1.0 / (TIMES[k] - TIMES[k - order]);
            k += 1;
        }
        order += 1;
    }
    spans
};

/// What the looks saw.
#[derive(Debug, Clone)]
pub struct Looks {
    /// Rows of ropes with a curve.
    curved: Vec<usize>,
    /// Forces of all rows at the start and the looks [N]: of ropes and normals without their bound, of friction
    /// with its mode. After them tensions of ropes with a curve, which follow no force of a row alone.
    forces: [Vec<f64>; POINTS],
    /// Divided differences of the forces (Newton's form).
    terms: [Vec<f64>; POINTS],
    /// How far every look is from its law, the worst row, in what the tolerance allows.
    pub far: [f64; LOOKS.len()],
    /// How far the worst of them is from its law, as a force [N].
    pub broken: f64,
}

impl Looks {
    /// Room for `system`.
    pub fn new(system: &System) -> Self {
        let ropes = system.rows.first.iter().copied().zip(system.ropes());
        let curved: Vec<_> = ropes.filter(|(_, rope)| rope.has_curve()).map(|(row, _)| row).collect();
        let rows = || std::array::from_fn(|_| vec![0.0; system.rows.count() + curved.len()]);
        let (forces, terms) = (rows(), rows());
        Self { curved, forces, terms, far: [0.0; LOOKS.len()], broken: 0.0 }
    }

    /// Keeps the forces at point k: 0 the start, k the look k − 1.
    pub fn note(&mut self, system: &System, k: usize, at: &Evaluation) {
        let forces = self.forces[k].iter_mut().zip(&system.rows.laws);
        for ((force, law), (trial, tension)) in forces.zip(at.trial.iter().zip(&at.tension)) {
            *force = if matches!(law, Law::Unilateral { .. }) { *trial } else { *tension };
        }
        let tensions = &mut self.forces[k][system.rows.count()..];
        for (tension, &row) in tensions.iter_mut().zip(&self.curved) {
            *tension = system.curved_tension(row, at.trial[row], &at.frame.kinematics);
        }
    }

    /// Keeps for rows over light sheaves the forces at the end of the part that is made before sheaves turn over, where no drum
    /// feeds them. Rope that is gone bears nothing, whatever its way would stretch it to.
    pub fn note_arriving(&mut self, system: &System, at: &Evaluation, modes: &[Mode]) {
        let lights = system.light.iter().zip(&at.light);
        for (light, now) in lights.filter(|(light, _)| !modes[light.rows.start].is_absent()) {
            self.forces[POINTS - 1][light.rows.clone()].copy_from_slice(&now.arriving);
        }
    }

    /// Puts polynomials through what was noted.
    pub fn fit(&mut self) {
        for (terms, forces) in self.terms.iter_mut().zip(&self.forces) {
            terms.copy_from_slice(forces);
        }
        for (order, spans) in SPANS.iter().enumerate().skip(1) {
            for k in (order..POINTS).rev() {
                let (before, from) = self.terms.split_at_mut(k);
                for (term, before) in from[0].iter_mut().zip(&before[k - 1]) {
                    *term = (*term - before) * spans[k];
                }
            }
        }
    }

    /// Forces of all rows at the share `x` of the step [N], not below zero where the law is one-sided.
    pub fn sample(&self, system: &System, x: f64, out: &mut [f64]) {
        out.copy_from_slice(&self.terms[POINTS - 1][..out.len()]);
        for (terms, time) in self.terms.iter().zip(TIMES).rev().skip(1) {
            for (out, term) in out.iter_mut().zip(terms) {
                *out = *out * (x - time) + term;
            }
        }
        for (force, law) in out.iter_mut().zip(&system.rows.laws) {
            if matches!(law, Law::Unilateral { .. }) {
                *force = force.max(0.0);
            }
        }
    }

    /// The force of a row at the start of the step [N], without bound.
    pub fn start(&self, row: usize) -> f64 {
        self.forces[0][row]
    }

    /// The force of one row at the share `x` of the step [N], without bound.
    fn at(&self, row: usize, x: f64) -> f64 {
        self.terms.iter().zip(TIMES).rev().fold(0.0, |sum, (terms, time)| sum * (x - time) + terms[row])
    }

    /// Whether the force of a row is on the given side of zero at the share `x` of the step.
    pub fn is_over(&self, row: usize, upwards: bool, x: f64) -> bool {
        (self.at(row, x) > 0.0) == upwards
    }

    /// The share of the step at which the force of a row goes through zero to the given side.
    pub fn crossing(&self, row: usize, upwards: bool) -> f64 {
        let last = (1..POINTS).find(|&k| (self.forces[k][row] > 0.0) == upwards).unwrap_or(POINTS - 1);
        let (mut low, mut high) = (TIMES[last - 1], TIMES[last]);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if (self.at(row, middle) > 0.0) == upwards { high = middle } else { low = middle }
        }
        high
    }

    /// Where the tension of a rope with a curve stands among the forces, in place of its row.
    fn place(&self, row: usize) -> usize {
        let rows = self.forces[0].len() - self.curved.len();
        self.curved.binary_search(&row).map_or(row, |index| rows + index)
    }

    /// Two shares of the step between which the force of a row, or the tension of a rope with a curve, reaches `force` [N]
    /// for the first time, if it does.
    pub fn reaches(&self, row: usize, force: f64) -> Option<(f64, f64)> {
        let place = self.place(row);
        if let Some(k) = (1..POINTS).find(|&k| self.forces[k][place] >= force) {
            return Some((TIMES[k - 1], TIMES[k]));
        }
        let (_, share) = self.peak(row, force)?;
        let before = (1..POINTS).rfind(|&k| TIMES[k] < share).map_or(0.0, |k| TIMES[k]);
        Some((before, share))
    }

    /// The largest force of a row, or tension of a rope with a curve, [N] and the share of the step at which it was, where it is more than `least`.
    pub fn peak(&self, row: usize, least: f64) -> Option<(f64, f64)> {
        let row = self.place(row);
        highest(self.forces.each_ref().map(|forces| forces[row]), |x| self.at(row, x), least)
    }

    /// The largest of what rows bear together and the share of the step at which it was, where it is more than `least`.
    pub fn pull(&self, bearers: &Bearers, least: f64) -> Option<(f64, f64)> {
        let forces = self.forces.each_ref().map(|forces| bearers.together(|row| forces[self.place(row)]));
        highest(forces, |x| bearers.together(|row| self.at(self.place(row), x)), least)
    }
}

/// The largest of a course whose values at the start and the looks are `forces`, and the share of the step at which it was,
/// where it is more than `least`.
fn highest(forces: [f64; POINTS], at: impl Fn(f64) -> f64, least: f64) -> Option<(f64, f64)> {
    let highest = (0..POINTS).max_by(|&a, &b| forces[a].total_cmp(&forces[b]))?;
    // Between points 0.3 of a step apart a course that such steps can follow rises by a few per cent at most; the
    // tension of a rope with a curve has corners, between which a polynomial may rise by anything.
    let most = forces[highest] / 0.9;
    let lowest = forces.iter().copied().fold(f64::INFINITY, f64::min);
    if most.min(forces[highest] + OVERSHOOT * (forces[highest] - lowest)) < least {
        return None;
    }
    let mut low = TIMES[highest.saturating_sub(1)];
    let mut high = TIMES[(highest + 1).min(POINTS - 1)];
    // To 1e-4 of the time between points; the value is right to the square of that.
    for _ in 0..24 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if at(a) < at(b) { low = a } else { high = b }
    }
    let share = 0.5 * (low + high);
    let inside = (at(share).min(most), share);
    // The search comes near the ends of the step and never there.
    let point = (forces[highest], TIMES[highest]);
    let (value, share) = if point.0 > inside.0 { point } else { inside };
    (value > least).then_some((value, share))
}

#[cfg(test)]
mod tests {
    use super::{OVERSHOOT, POINTS, TIMES};

    /// Σ |l(x)| of Lagrange's polynomials through these times, at a thousand places between them.
    #[test]
    fn no_polynomial_goes_farther_past_its_values() {
        let size = |x: f64, i: usize| {
            let others = (0..POINTS).filter(|&j| j != i);
            others.map(|j| (x - TIMES[j]) / (TIMES[i] - TIMES[j])).product::<f64>().abs()
        };
        let sums = (0..=1000).map(|k| (0..POINTS).map(|i| size(f64::from(k) / 1000.0, i)).sum::<f64>());
        let largest = sums.fold(0.0, f64::max);
        assert!((largest - 2.429).abs() < 1e-3, "{largest}");
        assert!(largest < 1.0 + 2.0 * OVERSHOOT);
    }
}
