//! The way down: Newton's method on the potential, made safe.
//!
//! A step minimises the model
//!
//! ```text
//! ∇V_g·Δ + ½ Δᵀ (λM + K) Δ + Σ ½ ε max(0, T̂ + (e + GΔ)/ε)²
//! ```
//!
//! in which ropes that are slack go taut and contacts close where the step leads them: rows change sides within the
//! model, all at once, until none does (Júdice and Pires 1994), each time by one factorisation. λ is raised until
//! λM + K is positive definite on all motions, which the signs of the pivots tell, and no joint turns too far at once;
//! it follows from the energy that the model promised and the energy that came (Levenberg 1944, Marquardt 1963, Moré 1978).
//! With a large λ the step is that of an implicit step in time from rest, 1/√λ long, so what nothing holds falls, and
//! what nothing moves stays where it was: of neutral motions the nearest in the metric of M.
//!
//! Wind and current push without a potential. What they do in a step is their work along it.
//!
//! λ never falls below [`LEAST`], so that neutral motions do not make the matrix singular; the last steps converge
//! by λ/ω² each, ω the slowest motion that is not neutral.

use super::guard::Guard;
use super::matrix::Matrix;
use super::potential::{Bearing, Part, Potential};
use crate::rope::coil::Coil;
use crate::rope::seat::Winding;
use crate::state::State;
use crate::stepper::frame::Remembered;
use crate::stepper::{seats, spots};
use crate::system::System;
use crate::tree::joint::Motion;

/// λ of the first step [1/s²].
const FIRST: f64 = 1.0;
/// Smallest λ [1/s²].
pub const LEAST: f64 = 1e-6;
/// Beyond this λ no step is worth trying [1/s²].
const MOST: f64 = 1e16;
/// Largest turn of a joint in one step [rad].
const TURN: f64 = 0.8;
/// Rounds in which rows change sides within one step.
const ROUNDS: usize = 12;
/// The same where rows are led down all the way.
const SURE_ROUNDS: usize = 100;
/// Halvings of the way to the next candidate.
const HALVINGS: usize = 40;
/// How often a model is made anew, at most, for one step.
const TRIES: usize = 100;
/// Steps, at most.
const STEPS: usize = 500;
/// What has moved so far falls without end [m].
const ENDLESS: f64 = 1e4;
/// Slope, relative to its terms, at which forces balance.
const BALANCED: f64 = 1e-9;
/// The same where nothing betters it: masses and stiffnesses that are very unlike leave that much to rounding.
const ROUGH: f64 = 1e-5;
/// Energy that a step must gain, relative to what the model promised.
const WORTH: f64 = 1e-3;

/// Rounding of an energy below which nothing can be told from it, in units of that of its terms.
const NOISE: f64 = 160.0;
/// Factor of λ after a step that the model foresaw.
const FASTER: f64 = 0.03;
/// Factor of λ after one that led nowhere.
const SLOWER: f64 = 4.0;

/// Factor of λ after a step that gained this share of what was promised.
fn trust(share: f64) -> f64 {
    match share {
        share if (share - 1.0).abs() < 0.1 => FASTER,
        share if share > 0.75 => 0.3,
        share if share < 0.25 => SLOWER,
        _ => 1.0,
    }
}

/// Why a search ended without equilibrium.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stuck {
    /// This body falls without end.
    Falls(usize),
    /// Two of the places that this rope passes have come together.
    UsedUp(usize),
    /// No step leads on; the slope of this degree of freedom is the largest.
    NoStep(usize),
}

/// What a search took.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Effort {
    /// Steps made.
    pub steps: u64,
    /// Steps tried and not made.
    pub rejected: u64,
}

/// Room for a search. Reused.
#[derive(Debug, Clone)]
pub struct Search {
    /// Where it is.
    pub here: Potential,
    there: Potential,
    /// The matrix at the last place that was linearised.
    pub matrix: Matrix,
    /// What it has taken since the start.
    pub effort: Effort,
    guard: Guard,
    acts: Vec<bool>,
    /// Forces of rows that do not act: what holds gives way with its bound, this way or that.
    known: Vec<f64>,
    step: Vec<f64>,
    tension: Vec<f64>,
    force: Vec<f64>,
    right: Vec<f64>,
    wraps: Vec<Winding>,
    coils: Vec<Coil>,
}

impl Search {
    /// Room for `system`.
    pub fn new(system: &System) -> Self {
        let (rows, size) = (system.rows.count(), system.tree.velocities);
        Self {
            here: Potential::new(system),
            there: Potential::new(system),
            matrix: Matrix::new(system),
            effort: Effort::default(),
            guard: Guard::new(system),
            acts: vec![false; rows],
            known: vec![0.0; rows],
            step: vec![0.0; size],
            tension: vec![0.0; rows],
            force: vec![0.0; size],
            right: vec![0.0; rows],
            wraps: vec![Winding::default(); system.sheaves.len()],
            coils: Vec::new(),
        }
    }

    /// From the configuration of `state` to where all slopes are zero; `state` follows.
    pub fn descend(
        &mut self,
        system: &System,
        state: &mut State,
        bearings: &mut [Bearing],
    ) -> Result<(), Stuck> {
        self.here.q.copy_from_slice(&state.q);
        self.coils.clone_from(&state.coils);
        self.here.update(system, bearings, &Remembered::of(state));
        let start: Vec<_> = self.here.frame.kinematics.centre_of_gravity.clone();
        let mut lambda = if self.here.residual(system) < 1e-3 { 1e-3 * FIRST } else { FIRST };
        for _ in 0..STEPS {
            self.here.update_mass(system);
            self.matrix.linearise(system, &self.here, &Remembered::of(state));
            self.here.turn_bearings(system, bearings);
            if !self.find_step(system, state, bearings, &mut lambda)? {
                return Ok(());
            }
            self.effort.steps += 1;
            std::mem::swap(&mut self.here, &mut self.there);
            state.q.copy_from_slice(&self.here.q);
            self.seat(system, state, bearings);
            self.find_spots(system, state, bearings);
            if let Some(body) = self.endless(system, &start) {
                return Err(Stuck::Falls(body));
            }
        }
        self.end(system).map(|_| ())
    }

    /// Sets `there` to where a step that is worth it leads; false where none is needed.
    fn find_step(
        &mut self,
        system: &System,
        state: &State,
        bearings: &[Bearing],
        lambda: &mut f64,
    ) -> Result<bool, Stuck> {
        let mut is_last = false;
        while *lambda <= MOST {
            let Some(promised) = self.model(system, bearings, lambda) else { break };
            self.there.update(system, bearings, &Remembered::of(state));
            let noise = self.here.rounding + self.there.rounding;
            let mut gained = self.gained();
            if promised.abs() <= NOISE * noise {
                // Energies say no more: it goes on while slopes do.
                let before = self.here.residual(system);
                let (enough, factor) = if self.here.pushed.is_empty() { (0.5, FASTER) } else { (0.9, 1.0) };
                if self.there.residual(system) < enough * before {
                    *lambda = (factor * *lambda).max(LEAST);
                    return Ok(true);
                }
                if before <= BALANCED {
                    return Ok(false);
                }
                if *lambda > LEAST && !is_last {
                    (*lambda, is_last) = (LEAST, true);
                    continue;
                }
            } else {
                if gained <= 0.25 * promised {
                    gained = self.correct(system, state, bearings, gained);
                }
                if gained > WORTH * promised {
                    let factor = trust(gained / promised).max(self.circling(system));
                    *lambda = (factor * *lambda).max(if factor > 1.0 { 1e-3 * FIRST } else { LEAST });
                    return Ok(true);
                }
            }
            self.effort.rejected += 1;
            *lambda = (SLOWER * *lambda).max(1e-3 * FIRST);
        }
        self.end(system)
    }

    /// Energy that falls on the step, with the work of wind and current along it, which have none, by the trapezoidal rule:
    /// what leads down that is an equilibrium where all slopes are zero [J].
    fn gained(&self) -> f64 {
        let pushed = self.here.pushed.iter().zip(&self.there.pushed).zip(&self.step);
        let work: f64 = pushed.map(|((here, there), step)| -0.5 * (here + there) * step).sum();
        self.here.energy - self.there.energy + work
    }

    /// Least factor of λ where wind or current push. The matrix has the symmetric half of what they change by, so steps
    /// without λ may circle around the equilibrium ever farther; with enough of it they come nearer.
    fn circling(&self, system: &System) -> f64 {
        if self.here.pushed.is_empty() {
            return 0.0;
        }
        match self.there.residual(system) / self.here.residual(system) {
            left if left > 0.9 => SLOWER,
            left if left > 0.5 => 1.0,
            _ => 0.0,
        }
    }

    /// Nothing leads on from here.
    fn end(&self, system: &System) -> Result<bool, Stuck> {
        if self.here.residual(system) <= ROUGH {
            return Ok(false);
        }
        if let Some(rope) = self.guard.used_up(system, &self.here) {
            return Err(Stuck::UsedUp(rope));
        }
        let free = (0..self.here.slope.len()).filter(|&dof| system.driven[dof].is_none());
        let imbalance = |dof: &usize| self.here.imbalance(*dof);
        let worst = free.max_by(|a, b| imbalance(a).total_cmp(&imbalance(b)));
        Err(Stuck::NoStep(worst.unwrap_or(0)))
    }

    /// Ropes lie on their sheaves as they do here; where one has changed its way all is evaluated anew.
    fn seat(&mut self, system: &System, state: &mut State, bearings: &[Bearing]) {
        if system.sheaves.is_empty() {
            return;
        }
        let mut changed = false;
        seats::wraps(system, &self.here.frame.kinematics, state, &mut self.wraps);
        for ((seat, &wound), place) in state.seats.iter_mut().zip(&self.wraps).zip(&system.sheaves) {
            changed |= place.may_lift_off && seats::has_crossed(seat, wound.wrap);
            (seat.is_off, seat.wound) = (wound.wrap < 0.0, wound);
        }
        if changed {
            self.here.update(system, bearings, &Remembered::of(state));
        }
    }

    /// Bodies may touch where they are near each other here. What a support bears stays on it: without friction it would
    /// slide, and off the edge in the end.
    fn find_spots(&mut self, system: &System, state: &mut State, bearings: &[Bearing]) {
        let mut changed = false;
        let Potential { frame, follows, .. } = &self.here;
        spots::find(
            system,
            &frame.kinematics,
            &mut state.spots,
            |row| follows[row],
            |_, _, _| changed = true,
        );
        if changed {
            self.here.update(system, bearings, &Remembered::of(state));
        }
    }

    /// The body that has fallen farthest, where that is without end.
    fn endless(&self, system: &System, start: &[glam::DVec3]) -> Option<usize> {
        let centres = &self.here.frame.kinematics.centre_of_gravity;
        let moved = |body: usize| (centres[body] - start[body]).length();
        let farthest = (0..system.tree.bodies.len()).max_by(|&a, &b| moved(a).total_cmp(&moved(b)))?;
        (moved(farthest) > ENDLESS).then_some(farthest)
    }

    /// Poses at `there` = `here` ⊕ step; true where no part of a rope runs through its end on the way.
    fn is_passable(&mut self, system: &System, lambda: f64) -> bool {
        self.there.q.copy_from_slice(&self.here.q);
        system.tree.advance(&mut self.there.q, &self.step);
        // A drum that gives way lets go what lies on it, there and back alike.
        for (place, coil) in system.coils.iter().zip(&self.coils) {
            let let_go = |q: &[f64]| coil.let_go_at(place.wound(q));
            self.there.q[place.supply] += let_go(&self.there.q) - let_go(&self.here.q);
        }
        self.there.frame.kinematics.update(&system.tree, &self.there.q);
        let places = (&self.here, &self.there.frame.kinematics);
        self.guard.holds(system, places, &self.step, (&mut self.matrix, lambda))
    }

    /// Adds to the step what the rows lack that follow it, since they are not as straight as the model has them, and
    /// keeps that where it gains more than `gained` [J]. What is gained then.
    fn correct(&mut self, system: &System, state: &State, bearings: &[Bearing], gained: f64) -> f64 {
        for row in 0..bearings.len() {
            // What contacts have moved along is another way there.
            let turns = matches!(bearings[row].part, Part::Off | Part::Stick(_) | Part::Across);
            self.right[row] = if self.acts[row] && !turns {
                self.reached(system, row) - self.there.value[row]
            } else {
                0.0
            };
        }
        self.force.fill(0.0);
        let first = self.step.clone();
        let mut tension = std::mem::take(&mut self.tension);
        self.matrix.solve(&self.force, &self.right, &mut self.step, &mut tension);
        self.tension = tension;
        for (step, first) in self.step.iter_mut().zip(&first) {
            *step += first;
        }
        let passable = self.is_passable(system, 0.0);
        self.there.update(system, bearings, &Remembered::of(state));
        let corrected = self.gained();
        if passable && corrected > gained {
            return corrected;
        }
        self.step = first;
        self.is_passable(system, 0.0);
        self.there.update(system, bearings, &Remembered::of(state));
        gained
    }

    /// Minimises the model; λ is raised as far as that takes. The energy that the step promises [J]; none where no
    /// λ will do.
    fn model(&mut self, system: &System, bearings: &[Bearing], lambda: &mut f64) -> Option<f64> {
        self.matrix.extra.fill(0.0);
        self.start_sides(bearings);
        for _ in 0..TRIES {
            if !self.settle_rows(system, bearings, *lambda) || self.largest_turn(system) > TURN {
                *lambda = (SLOWER * *lambda).max(1e-3 * FIRST);
            } else if self.is_passable(system, *lambda) {
                return Some(self.promised(system, bearings, *lambda));
            }
        }
        None
    }

    /// Steps of the model until no row changes sides; false where λM + K is not positive definite, or rows go on
    /// changing.
    fn settle_rows(&mut self, system: &System, bearings: &[Bearing], lambda: f64) -> bool {
        for _ in 0..ROUNDS {
            if !self.solve_model(system, bearings, lambda) {
                return false;
            }
            if self.take_sides(system, bearings) {
                return true;
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
            if !self.solve_model(system, bearings, lambda) {
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

    /// The step of the model with rows on these sides; false where λM + K is not positive definite.
    fn solve_model(&mut self, system: &System, bearings: &[Bearing], lambda: f64) -> bool {
        let Self { matrix, acts, .. } = self;
        let compliance = |row: usize| acts[row].then_some(bearings[row].compliance);
        if matrix.factorise(system, lambda, compliance).is_err() || matrix.below(system) > 0 {
            return false;
        }
        self.right_sides(system, bearings);
        self.matrix.solve(&self.force, &self.right, &mut self.step, &mut self.tension);
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
    fn reached(&self, system: &System, row: usize) -> f64 {
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

    fn largest_turn(&self, system: &System) -> f64 {
        let turns = self.step.iter().zip(&system.tree.motions);
        turns.filter(|(_, motion)| **motion == Motion::Turn).map(|(turn, _)| turn.abs()).fold(0.0, f64::max)
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
