//! The model of the potential that a step minimises,
//!
//! ```text
//! ∇V_g·Δ + ½ Δᵀ (λM + K) Δ + Σ ½ ε max(0, T̂ + (e + GΔ)/ε)²
//! ```
//!
//! in which ropes that are slack go taut and contacts close where the step leads them: rows change sides within the
//! model, all at once, until none does (Júdice and Pires 1994), each time by one factorisation.

use super::{FIRST, SLOWER, Search};
use crate::statics::bearing::{Bearing, Part};
use crate::system::System;
use crate::tree::joint::Motion;

/// Turn of a joint in one step that is too far, and what is left of it then [rad].
const TOO_FAR: f64 = 1.0;
const TURN: f64 = 0.8;
/// Beyond this imbalance later steps refine the first solution of a model. What follows that is refined: by rounding, rows
/// of friction between soft and stiff ones change sides for ever.
const FAR: f64 = 1e-3;
/// Rounds in which rows change sides within one step.
const ROUNDS: usize = 12;
/// The same where rows are led down all the way.
const SURE_ROUNDS: usize = 100;
/// Halvings of the way to the next candidate.
const HALVINGS: usize = 40;
/// How often a model is made anew, at most, for one step.
const TRIES: usize = 100;

impl Search {
    /// Minimises the model; λ is raised as far as that takes. The energy that the step promises [J]; none where no
    /// λ will do.
    pub(super) fn model(&mut self, system: &System, bearings: &[Bearing], lambda: &mut f64) -> Option<f64> {
        self.matrix.extra.fill(0.0);
        self.start_sides(bearings);
        self.guess_sides(system, bearings, *lambda);
        // What falls over does so as a mass released from rest: there λ keeps turns small as well. So it does where
        // rows would change sides under what holds a joint: how much of that they need is not known.
        let mut falls = false;
        for _ in 0..TRIES {
            let settled = self.settle_rows(system, bearings, *lambda);
            let held = settled
                && (self.turns_too_far(system).is_none() || !falls && self.hold_turns(system, bearings));
            if !held {
                falls = true;
                *lambda = (SLOWER * *lambda).max(1e-3 * FIRST);
            } else if self.is_passable(system) {
                return Some(self.promised(system, bearings, *lambda));
            } else {
                self.brake();
            }
        }
        None
    }

    /// What shortens parts of ropes too much is braked by a number on its diagonal. The others go on as they like, which
    /// may be all that moves it: how far it gives way to a force tells what leaves the wanted share of its way.
    fn brake(&mut self) {
        let Self { matrix, force, right, answer, brakes, .. } = self;
        right.fill(0.0);
        for &(dof, share) in brakes.iter() {
            force.fill(0.0);
            force[dof] = 1.0;
            matrix.solve_roughly(force, right, &mut answer.0, &mut answer.1);
            matrix.extra[dof] += (1.0 / share - 1.0) / answer.0[dof];
        }
    }

    /// What would turn too far turns as far as it may, by a number on its diagonal, and all else follows: one solution
    /// for the force that holds it tells how (Sherman and Morrison 1950). False where rows change sides thereby: then
    /// nothing is held.
    fn hold_turns(&mut self, system: &System, bearings: &[Bearing]) -> bool {
        self.held.clear();
        for _ in 0..TRIES {
            let Some(dof) = self.turns_too_far(system) else {
                // The number is force over turn; what was held first has turned a little on since.
                for (dof, hold) in &self.held {
                    self.matrix.extra[*dof] += hold / self.step[*dof];
                }
                return true;
            };
            self.force.fill(0.0);
            self.force[dof] = 1.0;
            self.right.fill(0.0);
            let Self { matrix, force, right, answer, .. } = self;
            matrix.solve_roughly(force, right, &mut answer.0, &mut answer.1);
            let turn = self.step[dof];
            let hold = (turn - TURN.copysign(turn)) / self.answer.0[dof];
            self.held.push((dof, hold));
            let forces = self.tension.iter_mut().zip(&self.answer.1);
            for (number, answer) in self.step.iter_mut().zip(&self.answer.0).chain(forces) {
                *number -= hold * answer;
            }
            if !self.take_sides(system, bearings) {
                return false;
            }
        }
        false
    }

    /// The degree of freedom that turns farthest, where that is too far.
    fn turns_too_far(&self, system: &System) -> Option<usize> {
        let turns = (0..self.step.len()).filter(|&dof| system.tree.motions[dof] == Motion::Turn);
        let far = turns.filter(|&dof| self.step[dof].abs() > TOO_FAR);
        far.max_by(|&a, &b| self.step[a].abs().total_cmp(&self.step[b].abs()))
    }

    /// Steps of the model until no row changes sides; false where λM + K is not positive definite, or rows go on
    /// changing.
    fn settle_rows(&mut self, system: &System, bearings: &[Bearing], lambda: f64) -> bool {
        for round in 1..=ROUNDS {
            let is_rough = round == 1 && self.here.residual(system) > FAR;
            if !self.solve_model(system, bearings, lambda, is_rough) {
                return false;
            }
            if self.take_sides(system, bearings) {
                return true;
            }
            // Sides that come back do so for ever (Brent's way to see it).
            if round > 2 && self.acts == self.seen.0 && self.known == self.seen.1 {
                break;
            }
            if round > 1 && round.is_power_of_two() {
                self.seen.0.copy_from_slice(&self.acts);
                self.seen.1.copy_from_slice(&self.known);
            }
        }
        self.settle_rows_surely(system, bearings, lambda)
    }

    /// The same for rows that would change for ever, such as many supports under a stiff load: the model is convex and of
    /// second degree in pieces, and its least place is found from the present one on, each time as far along the way to
    /// the next candidate as leads down.
    fn settle_rows_surely(&mut self, system: &System, bearings: &[Bearing], lambda: f64) -> bool {
        let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
        let (size, rows) = (self.step.len(), bearings.len());
        // x, (λM + K) x, and what rows have reached there.
        let (mut at, mut pushed) = (vec![0.0; size], vec![0.0; size]);
        let mut reached = self.here.value.clone();
        self.start_sides(bearings);
        for _ in 0..SURE_ROUNDS {
            if !self.solve_model(system, bearings, lambda, false) {
                return false;
            }
            // By the candidate's own equation.
            let mut push: Vec<f64> = self.here.gravity.iter().map(|gravity| -gravity).collect();
            let mut rates = vec![0.0; rows];
            for row in (0..rows).filter(|&row| bearings[row].part != Part::Off) {
                rates[row] = self.reached(system, row) - reached[row];
                for (dof, entry) in system.rows.entries(&self.here.frame.gradient, row) {
                    push[dof] -= entry * self.tension[row];
                }
            }
            if self.take_sides(system, bearings) {
                return true;
            }
            let way: Vec<f64> = self.step.iter().zip(&at).map(|(to, from)| to - from).collect();
            let pushes: Vec<f64> = push.iter().zip(&pushed).map(|(to, from)| to - from).collect();
            let (level, bend) = (dot(&self.here.gravity, &way) + dot(&pushed, &way), dot(&pushes, &way));
            let slope = |share: f64| {
                let forces = bearings.iter().zip(&reached).zip(&rates);
                let pulls = forces.map(|((bearing, value), rate)| bearing.at(value + share * rate).0 * rate);
                level + share * bend + pulls.sum::<f64>()
            };
            let share = lowest(slope);
            if share == 0.0 {
                // The model is smooth: that is its least place, to rounding, and rows that give way at next to nothing
                // are beyond their bounds on one side or the other.
                self.step.copy_from_slice(&at);
                for (row, bearing) in bearings.iter().enumerate() {
                    (self.tension[row], _, self.acts[row]) = bearing.at(reached[row]);
                    self.known[row] = self.tension[row];
                }
                return true;
            }
            let forward =
                |from: &mut [f64], way: &[f64]| from.iter_mut().zip(way).for_each(|(x, d)| *x += share * d);
            forward(&mut at, &way);
            forward(&mut pushed, &pushes);
            forward(&mut reached, &rates);
            for (row, bearing) in bearings.iter().enumerate() {
                (self.known[row], _, self.acts[row]) = bearing.at(reached[row]);
            }
        }
        false
    }

    /// Rows on the sides where they are here.
    fn start_sides(&mut self, bearings: &[Bearing]) {
        for (row, bearing) in bearings.iter().enumerate() {
            (self.known[row], _, self.acts[row]) = bearing.at(self.here.value[row]);
        }
    }

    /// Where no row acts, and all would fall by `g/λ`, ropes begin as taut if that takes up their slack: where it is
    /// wrong one round tells, and where it is right it spares some. What wind or current push drifts first.
    fn guess_sides(&mut self, system: &System, bearings: &[Bearing], lambda: f64) {
        if self.acts.contains(&true) || !self.here.pushed.is_empty() {
            return;
        }
        let fall = system.tree.gravity.length() / lambda;
        for row in (0..system.rope_rows()).filter(|&row| bearings[row].part == Part::Pull) {
            self.acts[row] = self.here.value[row] > -fall;
        }
    }

    /// The step of the model with rows on these sides; false where λM + K is not positive definite.
    fn solve_model(&mut self, system: &System, bearings: &[Bearing], lambda: f64, is_rough: bool) -> bool {
        let Self { matrix, acts, .. } = self;
        let compliance = |row: usize| acts[row].then_some(bearings[row].compliance);
        if matrix.factorise(system, lambda, compliance).is_err() || matrix.below(system) > 0 {
            return false;
        }
        self.right_sides(system, bearings);
        let Self { matrix, force, right, step, tension, .. } = self;
        if is_rough {
            matrix.solve_roughly(force, right, step, tension);
        } else {
            matrix.solve(force, right, step, tension);
        }
        true
    }

    /// Rows take the sides on which the step leaves them; true where none changes.
    fn take_sides(&mut self, system: &System, bearings: &[Bearing]) -> bool {
        let mut same = true;
        for (row, bearing) in bearings.iter().enumerate() {
            if bearing.part == Part::Off {
                continue;
            }
            let (force, _, follows) = bearing.at(self.reached(system, row));
            same &= follows == self.acts[row] && (follows || force == self.known[row]);
            (self.known[row], self.acts[row]) = (force, follows);
        }
        same
    }

    /// e of a row after the step, by its gradient.
    pub(super) fn reached(&self, system: &System, row: usize) -> f64 {
        self.here.value[row] + system.rows.rate(&self.here.frame.gradient, row, &self.step)
    }

    fn right_sides(&mut self, system: &System, bearings: &[Bearing]) {
        for (force, gravity) in self.force.iter_mut().zip(&self.here.gravity) {
            *force = -gravity;
        }
        for (row, bearing) in bearings.iter().enumerate() {
            self.right[row] = if self.acts[row] {
                -(self.here.value[row] + bearing.compliance * bearing.offset)
            } else {
                0.0
            };
            if let (Part::Hold(_) | Part::Resist(_) | Part::Stick(_), false) = (bearing.part, self.acts[row])
            {
                let force = self.known[row];
                self.right[row] = -force;
                for (dof, entry) in system.rows.entries(&self.here.frame.gradient, row) {
                    self.force[dof] -= entry * force;
                }
            }
        }
    }

    /// The model's energy here less that after the step, both without λ and brakes; by its own equation the quadratic
    /// term with them, Δᵀ (λM + K) Δ, is −(∇V_g + GᵀT)·Δ.
    fn promised(&self, system: &System, bearings: &[Bearing], lambda: f64) -> f64 {
        let along = |(force, step): (&f64, &f64)| force * step;
        let gravity: f64 = self.here.gravity.iter().zip(&self.step).map(along).sum();
        let (mut work, mut elastic) = (0.0, 0.0);
        for (row, bearing) in bearings.iter().enumerate().filter(|(_, bearing)| bearing.part != Part::Off) {
            let reached = self.reached(system, row);
            work += self.tension[row] * (reached - self.here.value[row]);
            elastic += bearing.at(self.here.value[row]).1 - bearing.at(reached).1;
        }
        let extra = self.matrix.extra.iter().zip(&self.step);
        let braked: f64 = extra.map(|(extra, step)| extra * step * step).sum();
        let slowed = lambda * self.here.frame.mass.quadratic(&self.step) + braked;
        elastic - gravity + 0.5 * (gravity + work + slowed)
    }
}

/// Share of the way at which a slope that never falls along it is zero; the whole way where it is still below.
fn lowest(slope: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    if slope(high) <= 0.0 {
        return high;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if slope(middle) <= 0.0 { low = middle } else { high = middle }
    }
    low
}
