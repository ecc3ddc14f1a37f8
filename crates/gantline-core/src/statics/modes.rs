//! Natural modes about an equilibrium, with taut ropes, closed contacts and held brakes as they are there.
//!
//! ```text
//! K x = ω² M x      xᵀ M x = 1      ζ = xᵀ D x/2ω
//! ```
//!
//! K = ∂²V/∂q² with geometric stiffness and gravity, rows that act condensed; rows without compliance hold their
//! direction. D holds joint damping, linear resistance of water and τ/ε of rows. ζ is that of a mode by itself, as usual where damping is light:
//! what couples modes through D is left out. Water that remembers has the M and D of the mode's own frequency,
//! A(ω) and B(ω).

use super::Statics;
use super::eigen::{Square, vibrations};
use crate::force::memory::{self, memories};
use crate::state::State;
use crate::system::System;

/// From so many degrees of freedom on modes are found one by one, where no more than the `FEW`th part is asked for.
const LARGE: usize = 120;
const FEW: usize = 8;
/// Where water remembers: rounds in which a mode finds its own frequency, and the share to which it does.
const ROUNDS: usize = 50;
const SAME: f64 = 1e-10;

/// A mode.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// ω² [1/s²]; negative where the motion leads away.
    pub square: f64,
    /// ζ; none where nothing swings.
    pub damping_ratio: Option<f64>,
    /// x over all degrees of freedom [1/√kg times m or rad], zero for driven ones.
    pub shape: Vec<f64>,
    /// What it adds to the force of every row [N].
    pub tension: Vec<f64>,
}

impl Statics {
    /// The `count` slowest modes about the equilibrium in which `state` is since the last [`Statics::settle`], slowest
    /// first; all without a count. A few of a large lift are found by [`super::lowest`], all else by dense matrices. Where
    /// water remembers, each has the added mass and the damping of its own frequency.
    pub fn modes(&mut self, system: &System, state: &State, count: Option<usize>) -> Vec<Mode> {
        let size = self.search.matrix.layout.free.len();
        let count = count.unwrap_or(size).min(size);
        self.search.linearise(system, state);
        let mut found = self.slowest(system, count);
        if memories(&system.tree).next().is_some() {
            for place in 0..found.len() {
                let mut omega = f64::NAN;
                for _ in 0..ROUNDS {
                    let last = std::mem::replace(&mut omega, found[place].0.max(0.0).sqrt());
                    if (omega - last).abs() <= SAME * omega {
                        break;
                    }
                    self.search.matrix.take_water(system, &self.search.here, Some(omega));
                    if let Some(own) = self.slowest(system, count).into_iter().nth(place) {
                        found[place] = own;
                    }
                }
            }
            self.search.matrix.take_water(system, &self.search.here, None);
        }
        found.into_iter().map(|(square, shape)| self.mode(system, square, shape)).collect()
    }

    /// Motions about the same equilibrium that others have found from [`Statics::linear`], ω² and x over the free degrees of
    /// freedom, as modes.
    pub fn modes_of(&mut self, system: &System, state: &State, found: Vec<(f64, Vec<f64>)>) -> Vec<Mode> {
        self.search.linearise(system, state);
        let modes =
            found.into_iter().map(|(square, free)| self.mode(system, square, self.whole(system, free)));
        modes.collect()
    }

    /// A shape over all degrees of freedom.
    fn whole(&self, system: &System, free: Vec<f64>) -> Vec<f64> {
        let mut shape = vec![0.0; system.tree.velocities];
        self.search.matrix.layout.free.iter().zip(free).for_each(|(&dof, entry)| shape[dof] = entry);
        shape
    }

    /// The slowest modes, ω² and x.
    fn slowest(&mut self, system: &System, count: usize) -> Vec<(f64, Vec<f64>)> {
        let size = self.search.matrix.layout.free.len();
        let is_few = size >= LARGE && FEW * count <= size;
        if let Some(found) = is_few.then(|| self.lowest(system, count)).flatten() {
            return found;
        }
        let mut found = self.all_modes(system);
        found.truncate(count);
        found
    }

    /// All modes, by dense matrices. Their ω² lie off by rounding of the largest; those of their shapes,
    /// [`Statics::square_of`], do not.
    pub(super) fn all_modes(&self, system: &System) -> Vec<(f64, Vec<f64>)> {
        let (follows, matrix) = (&self.search.here.follows, &self.search.matrix);
        let size = matrix.layout.free.len();
        let (mass, stiffness) = matrix.dense(system, &self.bearings, follows);
        let held = self.held_rows(system);
        let found = vibrations(&Square::new(size, mass), &Square::new(size, stiffness), &held);
        let (_, shapes) = found.unwrap_or_default();
        let shapes = shapes.into_iter().map(|free| self.whole(system, free));
        let mut found: Vec<_> = shapes.map(|shape| (self.square_of(system, &shape), shape)).collect();
        found.sort_by(|(one, _), (other, _)| one.total_cmp(other));
        found
    }

    /// ω² = xᵀ K x of a shape with xᵀ M x = 1, what rows stretch by and not K summed: of a slow motion they stretch by next to
    /// nothing, which is lost in K. An error of the shape enters by its square (Rayleigh).
    fn square_of(&self, system: &System, shape: &[f64]) -> f64 {
        let here = &self.search.here;
        let elastic = |row: &usize| here.follows[*row] && !self.bearings[*row].is_rigid;
        let rows = (0..self.bearings.len()).filter(elastic).map(|row| {
            let rate = system.rows.rate(&here.frame.gradient, row, shape);
            rate * rate / self.bearings[row].compliance
        });
        self.search.matrix.stiffness_along(shape) + rows.sum::<f64>()
    }

    fn mode(&self, system: &System, square: f64, mut shape: Vec<f64>) -> Mode {
        let sign = if shape.iter().sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
        shape.iter_mut().for_each(|entry| *entry *= sign);
        let joints = shape.iter().zip(&system.tree.damping);
        let mut damping: f64 = joints.map(|(entry, damping)| damping * entry * entry).sum();
        damping += self.search.matrix.resistance(system, &shape);
        let kinematics = &self.search.here.frame.kinematics;
        damping += memory::resistance(&system.tree, kinematics, square.max(0.0).sqrt(), &shape);
        let mut tension = vec![0.0; system.rows.count()];
        for row in (0..tension.len()).filter(|&row| self.stretches(row)) {
            let rate = system.rows.rate(&self.search.here.frame.gradient, row, &shape);
            tension[row] = rate / self.bearings[row].compliance;
            damping += system.rows.laws[row].damping_time() * tension[row] * rate;
        }
        let swings = square > super::NEUTRAL;
        let damping_ratio = swings.then(|| 0.5 * damping / square.sqrt());
        Mode { square, damping_ratio, shape, tension }
    }
}
