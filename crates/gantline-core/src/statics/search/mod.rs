//! The way down: Newton's method on the potential, made safe.
//!
//! A step is where the [`model`] of the potential about a place has its least value. λ is raised until λM + K is positive
//! definite on all motions, which the signs of the pivots tell, and no joint turns too far at once; it follows from the
//! energy that the model promised and the energy that came (Levenberg 1944, Marquardt 1963, Moré 1978). With a large λ
//! the step is that of an implicit step in time from rest, 1/√λ long, so what nothing holds falls, and
//! what nothing moves stays where it was: of neutral motions the nearest in the metric of M.
//!
//! Wind and current push without a potential. What they do in a step is their work along it. Where that leads no further,
//! since the matrix has the symmetric half of what they change by, [`relax`] goes on. What that half has moved along
//! neutral motions [`back`] brings back.
//!
//! A step that runs bodies into or [`through`] one another is none.
//!
//! λ never falls below [`LEAST`], so that neutral motions do not make the matrix singular; the last steps converge
//! by λ/ω² each, ω the slowest motion that is not neutral.

mod back;
mod model;
mod relax;
mod through;

use super::bearing::{Bearing, Part};
use super::guard::Guard;
use super::matrix::Matrix;
use super::potential::Potential;
use crate::rope::coil::Coil;
use crate::rope::seat::Winding;
use crate::state::State;
use crate::stepper::frame::Remembered;
use crate::stepper::{seats, spots};
use crate::system::System;
use crate::tree::kinematics::Kinematics;

/// λ of the first step [1/s²].
const FIRST: f64 = 1.0;
/// Smallest λ [1/s²].
pub const LEAST: f64 = 1e-6;
/// Beyond this λ no step is worth trying [1/s²].
const MOST: f64 = 1e16;
/// Steps, at most.
const STEPS: usize = 500;
/// What has moved so far falls without end [m].
const ENDLESS: f64 = 1e4;
/// Slope, relative to its terms, at which forces balance.
pub(super) const BALANCED: f64 = 1e-9;
/// The same where nothing betters it: masses and stiffnesses that are very unlike leave that much to rounding.
const ROUGH: f64 = 1e-5;
/// And what rounding leaves of the sum of a few terms where nothing stretches.
const ROUNDED: f64 = 4.0 * f64::EPSILON;
/// Energy that a step must gain, relative to what the model promised.
const WORTH: f64 = 1e-3;

/// Rounding of an energy below which nothing can be told from it, in units of that of its terms.
const NOISE: f64 = 160.0;
/// What is gained beyond this much rounding has been gained, whatever was promised: what is written of rounding is that of
/// single terms, of which the sum has no more than once or twice as a rule.
const TOLD: f64 = 16.0;
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
    /// True where that is `here`.
    is_linearised: bool,
    /// True where its factors are near enough: one more step with them leaves rounding.
    is_near: bool,
    /// What it has taken since the start.
    pub effort: Effort,
    /// Sum of the steps of one descent.
    gone: Vec<f64>,
    guard: Guard,
    acts: Vec<bool>,
    /// Forces of rows that do not act: what holds gives way with its bound, this way or that.
    known: Vec<f64>,
    /// Both after an earlier round of the same model.
    seen: (Vec<bool>, Vec<f64>),
    step: Vec<f64>,
    tension: Vec<f64>,
    force: Vec<f64>,
    right: Vec<f64>,
    /// Increments and forces that a force on one degree of freedom brings.
    answer: (Vec<f64>, Vec<f64>),
    /// Degrees of freedom that would turn too far, and what holds them.
    held: Vec<(usize, f64)>,
    /// Degrees of freedom that would shorten parts of ropes too much, and how much of their way is left.
    brakes: Vec<(usize, f64)>,
    wraps: Vec<Winding>,
    coils: Vec<Coil>,
    /// Part of a step, and where it leads.
    part: Vec<f64>,
    way: Vec<f64>,
    between: Kinematics,
}

impl Search {
    /// Room for `system`.
    pub fn new(system: &System) -> Self {
        let (rows, size) = (system.rows.count(), system.tree.velocities);
        Self {
            here: Potential::new(system),
            there: Potential::new(system),
            matrix: Matrix::new(system),
            is_linearised: false,
            is_near: false,
            effort: Effort::default(),
            gone: vec![0.0; size],
            guard: Guard::new(system),
            acts: vec![false; rows],
            known: vec![0.0; rows],
            seen: (vec![false; rows], vec![0.0; rows]),
            step: vec![0.0; size],
            tension: vec![0.0; rows],
            force: vec![0.0; size],
            right: vec![0.0; rows],
            answer: (vec![0.0; size], vec![0.0; rows]),
            held: Vec::new(),
            brakes: Vec::new(),
            wraps: vec![Winding::default(); system.sheaves.len()],
            coils: Vec::new(),
            part: vec![0.0; size],
            way: vec![0.0; system.tree.positions],
            between: Kinematics::new(&system.tree),
        }
    }

    /// From the configuration of `state` to where all slopes are zero; `state` follows.
    pub fn descend(
        &mut self,
        system: &System,
        state: &mut State,
        bearings: &mut [Bearing],
    ) -> Result<(), Stuck> {
        self.gone.fill(0.0);
        self.go_down(system, state, bearings)?;
        self.come_back(system, state, bearings);
        Ok(())
    }

    fn go_down(&mut self, system: &System, state: &mut State, bearings: &mut [Bearing]) -> Result<(), Stuck> {
        self.here.q.copy_from_slice(&state.q);
        self.coils.clone_from(&state.coils);
        self.here.place(system);
        self.evaluate(system, state, bearings);
        let start: Vec<_> = self.here.frame.kinematics.centre_of_gravity.clone();
        let mut lambda = if self.here.residual(system) < 1e-3 { 1e-3 * FIRST } else { FIRST };
        for _ in 0..STEPS {
            self.here.turn_bearings(system, bearings);
            let before = self.here.residual(system);
            if before <= ROUNDED {
                // Rounding is all that is left: no step could better it.
                return Ok(());
            }
            if !self.step_again(system, state, bearings) {
                self.linearise(system, state);
                match self.find_step(system, state, bearings, &mut lambda) {
                    Ok(true) => {}
                    Ok(false) => return Ok(()),
                    Err(Stuck::NoStep(_)) if self.relax(system, state, bearings) => return Ok(()),
                    Err(stuck) => return Err(stuck),
                }
            }
            self.go_there(state);
            let after = self.here.residual(system);
            // The same factors leave the same share once more.
            self.is_near = after * after <= ROUNDED * before && self.acts == self.here.follows;
            self.seat(system, state, bearings);
            self.find_spots(system, state, bearings);
            if let Some(body) = self.endless(system, &start) {
                return Err(Stuck::Falls(body));
            }
        }
        match self.end(system) {
            Err(Stuck::NoStep(_)) if self.relax(system, state, bearings) => Ok(()),
            end => end.map(|_| ()),
        }
    }

    /// Takes the step to `there`.
    fn go_there(&mut self, state: &mut State) {
        self.effort.steps += 1;
        self.gone.iter_mut().zip(&self.step).for_each(|(gone, step)| *gone += step);
        std::mem::swap(&mut self.here, &mut self.there);
        (self.is_near, self.is_linearised) = (false, false);
        state.q.copy_from_slice(&self.here.q);
    }

    /// Evaluates everything at the poses where it is anew, since `state` remembers something else.
    pub fn evaluate(&mut self, system: &System, state: &State, bearings: &[Bearing]) {
        self.here.evaluate(system, bearings, &Remembered::of(state));
        (self.is_near, self.is_linearised) = (false, false);
    }

    /// Evaluates M, K and G where it is, unless that is where the matrix has them from.
    pub fn linearise(&mut self, system: &System, state: &State) {
        if !self.is_linearised {
            self.here.update_mass(system);
            self.matrix.linearise(system, &self.here, &Remembered::of(state));
            self.is_linearised = true;
        }
    }

    /// Sets `there` to where the factors of the step before lead, which are near enough; false where they are not.
    fn step_again(&mut self, system: &System, state: &State, bearings: &[Bearing]) -> bool {
        if !self.is_near {
            return false;
        }
        for (force, slope) in self.force.iter_mut().zip(&self.here.slope) {
            *force = -slope;
        }
        self.right.fill(0.0);
        let Self { matrix, force, right, step, tension, .. } = self;
        matrix.solve_roughly(force, right, step, tension);
        self.is_near = self.is_passable(system);
        self.there.evaluate(system, bearings, &Remembered::of(state));
        let is_better = self.there.residual(system) < 0.5 * self.here.residual(system);
        self.is_near &= is_better && self.there.energy.is_finite();
        self.is_near
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
            self.there.evaluate(system, bearings, &Remembered::of(state));
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
                // Along a valley that bends forces may get worse on the way down.
                let is_worth_it = gained > (WORTH * promised).max(TOLD * noise);
                if self.here.pushed.is_empty() && is_worth_it && !self.runs_into(system, state) {
                    *lambda = (trust(gained / promised) * *lambda).max(LEAST);
                    return Ok(true);
                }
                if *lambda > LEAST && !is_last {
                    (*lambda, is_last) = (LEAST, true);
                    continue;
                }
            } else {
                if gained <= 0.25 * promised {
                    gained = self.correct(system, state, bearings, gained);
                }
                if gained > WORTH * promised && !self.runs_into(system, state) {
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
            self.evaluate(system, state, bearings);
        }
    }

    /// Bodies may touch where they are near each other here. What a support bears stays on it: without friction it would
    /// slide, and off the edge in the end. Where it comes to stand anew friction holds nothing yet, and a place that followed
    /// each step by its depth would keep a load that rolls from ever settling.
    fn find_spots(&mut self, system: &System, state: &mut State, bearings: &[Bearing]) {
        let mut changed = false;
        let Potential { frame, follows, .. } = &self.here;
        let mut spots = std::mem::take(&mut state.spots);
        spots::find(
            system,
            &frame.kinematics,
            &mut spots,
            f64::INFINITY,
            |row| follows[row],
            |touch, old, new| {
                changed = true;
                let value = follows[system.rows.first[touch.index]].then_some(frame.value.as_slice());
                spots::stand_elsewhere(system, &frame.kinematics, (touch, old, new), value, state);
            },
        );
        state.spots = spots;
        if changed {
            self.evaluate(system, state, bearings);
        }
    }

    /// The body that has fallen farthest, where that is without end.
    fn endless(&self, system: &System, start: &[glam::DVec3]) -> Option<usize> {
        let centres = &self.here.frame.kinematics.centre_of_gravity;
        let moved = |body: usize| (centres[body] - start[body]).length();
        let bodies = &system.tree.bodies;
        let mut farthest = (0..bodies.len()).max_by(|&a, &b| moved(a).total_cmp(&moved(b)))?;
        if moved(farthest) <= ENDLESS {
            return None;
        }
        // What is fixed to another falls with it.
        while let (0, Some(parent)) = (bodies[farthest].velocities, bodies[farthest].parent) {
            farthest = parent;
        }
        Some(farthest)
    }

    /// Poses at `there` = `here` ⊕ step; true where no part of a rope runs through its end on the way.
    fn is_passable(&mut self, system: &System) -> bool {
        self.there.q.copy_from_slice(&self.here.q);
        system.tree.advance(&mut self.there.q, &self.step);
        // A drum that gives way lets go what lies on it, there and back alike.
        for (place, coil) in system.coils.iter().zip(&self.coils) {
            let let_go = |q: &[f64]| coil.let_go_at(place.wound(q));
            self.there.q[place.supply] += let_go(&self.there.q) - let_go(&self.here.q);
        }
        self.there.place(system);
        let places = (&self.here, &self.there.frame.kinematics);
        self.guard.look(system, places, &self.step, &mut self.brakes);
        self.brakes.is_empty()
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
        let passable = self.is_passable(system);
        self.there.evaluate(system, bearings, &Remembered::of(state));
        let corrected = self.gained();
        if passable && corrected > gained {
            return corrected;
        }
        self.step = first;
        self.is_passable(system);
        self.there.evaluate(system, bearings, &Remembered::of(state));
        gained
    }
}
