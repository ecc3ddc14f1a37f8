//! The potential energy of a system at rest, its slope, and what every row carries.
//!
//! ```text
//! V(q) = −Σ m g·c + U + Σ ½ ε T²        T = max(0, T̂ + e/ε) of ropes, contacts and stops
//!                                        T = T̂ + e/ε within ± its bound, of brakes that hold
//! ```
//!
//! U is the energy of the water that hulls displace ([`crate::force::buoyancy`]). Where a row has no compliance ε is a small one of statics' own and T̂ the multiplier, which is moved to T until
//! nothing is left of e: the augmented Lagrangian (Hestenes 1969, Powell 1969). Else T̂ = 0, and V is the energy.
//!
//! A contact that holds where it stands has both its tangential rows in one law, with s how far it has moved along its
//! plane: V = s²/2ε while s/ε is within its bound b, b (|s| − ½ ε b) beyond. Its rows are taken along s and across it:
//! along, the law is that of a brake; across, a force b that turns with s has the stiffness b/|s|.

use super::bearing::{Bearing, Part};
use crate::audit::gravity_energy;
use crate::force::{self, Energies};
use crate::stepper::frame::{Frame, Remembered};
use crate::system::System;
use crate::tree::bias::NewtonEuler;
use crate::tree::joint::Motion;

/// ε of what holds nothing [m/N].
const FREE: f64 = 1e6;
/// Rounding of a sum of lengths, relative to the longest.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Weight of what a degree of freedom moves, times its radius of gyration where that turns [N, N m].
fn weight_of(system: &System, dof: usize) -> f64 {
    let tree = &system.tree;
    let inertia = tree.inertia_scale[dof];
    let below: f64 = tree.subtree[tree.owner[dof]].iter().map(|&body| tree.bodies[body].mass).sum();
    let turns = tree.motions[dof] == Motion::Turn && below > 0.0;
    tree.gravity.length() * if turns { (inertia * below).sqrt() } else { inertia }
}

/// Rounding of the value of a row [m], places being up to `reach` [m] from the origin.
fn rounding(bearing: &Bearing, reach: f64) -> f64 {
    ROUNDING * (bearing.length + reach)
}

/// Everything at one configuration. Reused.
#[derive(Debug, Clone)]
pub struct Potential {
    /// Configuration.
    pub q: Vec<f64>,
    /// Poses, rows, gradients, mass matrix.
    pub frame: Frame,
    /// Inverse dynamics without any motion.
    pub dynamics: NewtonEuler,
    /// ∂V/∂q of gravity and buoyancy, less what wind and current push with.
    pub gravity: Vec<f64>,
    /// The opposite of what wind and current push with, which has no V; empty where there are none.
    pub pushed: Vec<f64>,
    /// ∂V/∂q.
    pub slope: Vec<f64>,
    /// Sum of the sizes of the terms of every slope.
    pub terms: Vec<f64>,
    /// What rounding makes of every slope.
    pub noise: Vec<f64>,
    /// e of every row as statics counts it [m].
    pub value: Vec<f64>,
    /// T of every row [N].
    pub tension: Vec<f64>,
    /// True where T follows e.
    pub follows: Vec<bool>,
    /// V [J].
    pub energy: f64,
    /// Rounding of V [J].
    pub rounding: f64,
    /// Directions in which contacts that hold have moved, along their two tangents, and ε across, by contact.
    along: Vec<([f64; 2], f64)>,
    still: Vec<f64>,
    /// Weight that a degree of freedom moves, times the radius of gyration where it turns [N, N m].
    weight: Vec<f64>,
}

impl Potential {
    /// Room for `system`.
    pub fn new(system: &System) -> Self {
        let (rows, size) = (system.rows.count(), system.tree.velocities);
        let mut frame = Frame::new(system);
        // Nothing has moved yet, and no wave has come.
        frame.kinematics.past.clear();
        Self {
            q: vec![0.0; system.tree.positions],
            frame,
            dynamics: NewtonEuler::new(&system.tree),
            gravity: vec![0.0; size],
            pushed: if force::has_stream(&system.tree) { vec![0.0; size] } else { Vec::new() },
            slope: vec![0.0; size],
            terms: vec![0.0; size],
            noise: vec![0.0; size],
            value: vec![0.0; rows],
            tension: vec![0.0; rows],
            follows: vec![false; rows],
            energy: 0.0,
            rounding: 0.0,
            along: vec![([1.0, 0.0], 0.0); system.friction.len() / 2],
            still: vec![0.0; size],
            weight: (0..size).map(|dof| weight_of(system, dof)).collect(),
        }
    }

    /// Evaluates everything at `self.q`, with ropes on their sheaves and drums as the state has them.
    pub fn update(&mut self, system: &System, bearings: &[Bearing], by: &Remembered) {
        self.place(system);
        self.evaluate(system, bearings, by);
    }

    /// Poses at `self.q`, before any wave comes.
    pub fn place(&mut self, system: &System) {
        self.frame.kinematics.update(&system.tree, &self.q, 0.0);
    }

    /// Evaluates everything else, at the poses of `self.q`.
    pub fn evaluate(&mut self, system: &System, bearings: &[Bearing], by: &Remembered) {
        let Self { q, frame, dynamics, gravity, .. } = self;
        frame.rows(system, q, by);
        dynamics.update(&system.tree, &frame.kinematics, &self.still, None, None, gravity);
        if !self.pushed.is_empty() {
            force::resistance(&system.tree, &self.frame.kinematics, &self.still, &mut self.pushed);
        }
        self.slope.copy_from_slice(&self.gravity);
        for (terms, gravity) in self.terms.iter_mut().zip(&self.gravity) {
            *terms = gravity.abs();
        }
        self.noise.fill(0.0);
        let places = self.frame.kinematics.centre_of_gravity.iter();
        let reach = places.fold(1.0_f64, |most, place| most.max(place.abs().max_element()));
        let Energies { fluid, lines } = force::energy(&system.tree, &self.frame.kinematics);
        let gravity = gravity_energy(system, &self.frame.kinematics);
        self.energy = gravity + fluid + lines;
        self.rounding = gravity.abs() + fluid.abs() + lines.abs();
        for (row, bearing) in bearings.iter().enumerate() {
            self.value[row] = bearing.held.map_or(self.frame.value[row], |held| held.value(&self.q));
            if matches!(bearing.part, Part::Stick(_) | Part::Across) {
                continue;
            }
            let (tension, energy, follows) = bearing.at(self.value[row]);
            (self.tension[row], self.follows[row]) = (tension, follows);
            let doubt = if follows { rounding(bearing, reach) / bearing.compliance } else { 0.0 };
            self.add(system, row, energy, doubt);
        }
        self.hold_contacts(system, bearings, reach);
        self.rounding *= f64::EPSILON;
    }

    /// Adds the energy of a row, its force to the slopes, and what rounding makes of that, `doubt` [N]: nothing where the
    /// force does not follow the value.
    fn add(&mut self, system: &System, row: usize, energy: f64, doubt: f64) {
        let tension = self.tension[row];
        self.energy += energy;
        self.rounding += energy;
        if tension != 0.0 {
            for (dof, entry) in system.rows.entries(&self.frame.gradient, row) {
                self.slope[dof] += entry * tension;
                self.terms[dof] += (entry * tension).abs();
                self.noise[dof] += entry.abs() * doubt;
            }
        }
    }

    /// Contacts that hold where they stand. Forces are along their tangents, values and gradients from then on
    /// along s and across it.
    fn hold_contacts(&mut self, system: &System, bearings: &[Bearing], reach: f64) {
        for (contact, rows) in system.friction.chunks_exact(2).enumerate() {
            let [one, other] = [rows[0], rows[1]];
            let bearing = Bearing { offset: 0.0, ..bearings[one] };
            let Part::Stick(bound) = bearing.part else { continue };
            let moved = [self.value[one], self.value[other]];
            let size = moved[0].hypot(moved[1]);
            let way = if size > 0.0 { moved.map(|part| part / size) } else { [1.0, 0.0] };
            let (tension, energy, follows) = bearing.at(size);
            (self.follows[one], self.follows[other]) = (follows, true);
            // Where it holds nothing at all ε across is without end: next to nothing holds it then.
            let across = if follows { bearing.compliance } else { size / bound.max(f64::MIN_POSITIVE) };
            self.along[contact] = (way, across.min(FREE));
            // A force that is all it can be still turns with what it has moved.
            let doubt = rounding(&bearing, reach) / across;
            for (row, share) in [(one, way[0]), (other, way[1])] {
                self.tension[row] = tension * share;
                self.add(system, row, energy * share * share, doubt);
            }
            (self.value[one], self.value[other]) = (size, 0.0);
            let start = [system.rows.start[one], system.rows.start[other]];
            for entry in 0..system.rows.start[one + 1] - start[0] {
                let places = [start[0] + entry, start[1] + entry];
                let [a, b] = places.map(|place| self.frame.gradient[place]);
                self.frame.gradient[places[0]] = way[0] * a + way[1] * b;
                self.frame.gradient[places[1]] = way[0] * b - way[1] * a;
            }
        }
    }

    /// Writes into the bearings of contacts that hold how they answer across what they have moved, as it is here.
    pub fn turn_bearings(&self, system: &System, bearings: &mut [Bearing]) {
        for (rows, (_, across)) in system.friction.chunks_exact(2).zip(&self.along) {
            if matches!(bearings[rows[0]].part, Part::Stick(_)) {
                bearings[rows[1]].compliance = *across;
            }
        }
    }

    /// What ropes, contacts and stops that follow pull back at each degree of freedom by itself [N/m, N m].
    pub fn stiffness_beside(&self, system: &System, bearings: &[Bearing]) -> Vec<f64> {
        let mut stiffness = vec![0.0; self.slope.len()];
        let elastic = |row: &usize| self.follows[*row] && !bearings[*row].is_rigid;
        for row in (0..bearings.len()).filter(elastic) {
            for (dof, entry) in system.rows.entries(&self.frame.gradient, row) {
                stiffness[dof] += entry * entry / bearings[row].compliance;
            }
        }
        stiffness
    }

    /// The mass matrix at the poses of the last update; here it measures ways, so what has no mass gets some.
    pub fn update_mass(&mut self, system: &System) {
        self.frame.mass.update(&system.tree, &self.frame.kinematics);
        for &dof in system.light.iter().flat_map(|light| &light.dofs) {
            self.frame.mass.values[self.frame.mass.row_start[dof + 1] - 1] = system.tree.inertia_scale[dof];
        }
    }

    /// Slope of a degree of freedom, beyond rounding, relative to the forces that meet there, or to its weight where
    /// they are less.
    pub fn imbalance(&self, dof: usize) -> f64 {
        let excess = (self.slope[dof].abs() - self.noise[dof]).max(0.0);
        excess / self.terms[dof].max(self.weight[dof]).max(f64::MIN_POSITIVE)
    }

    /// Largest imbalance of a free degree of freedom.
    pub fn residual(&self, system: &System) -> f64 {
        let free = (0..self.slope.len()).filter(|&dof| system.driven[dof].is_none());
        free.map(|dof| self.imbalance(dof)).fold(0.0, f64::max)
    }
}
