//! The size of a step's error estimate, in tolerances.
//!
//! Three measures, of which the largest counts: the error of positions [m] (rotations times the radius of
//! gyration); the root mean square of the error of tensions of the rows that act (moments over it); and the same for velocities,
//! turned into the tension to which they will lead: an error δv of a mass m on a stiffness k swings out to
//! √(k m) δv.

use super::Tolerance;
use super::course::Increment;
use super::rodas::Rodas;
use crate::constraint::{AnyConstraint, Law};
use crate::force::memory::memories;
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::stepper::frame::Frame;
use crate::system::System;

/// An error of the largest force that is rounding: no step is short enough to do better.
pub(super) const ROUNDING: f64 = 1e-9;

/// Lengths and inertias that turn errors into metres and newtons.
#[derive(Debug, Clone)]
pub struct Weights {
    /// Radius of gyration of rotations [m]; 1 for translations.
    pub(super) arm: Vec<f64>,
    stiffness: Vec<f64>,
}

impl Weights {
    /// Weights of `system`, whose first frame is `frame`.
    pub fn new(system: &System, frame: &Frame) -> Self {
        let arm = |dof: usize| {
            let column = &frame.kinematics.columns[dof];
            if column.angular == glam::DVec3::ZERO {
                return 1.0;
            }
            let below = &system.tree.subtree[system.tree.owner[dof]];
            let mass: f64 = below.iter().map(|&body| system.tree.bodies[body].mass).sum();
            if mass > 0.0 { (frame.mass.diagonal(dof) / mass).sqrt() } else { 1.0 }
        };
        let size = system.tree.velocities;
        Self { arm: (0..size).map(arm).collect(), stiffness: vec![0.0; size] }
    }

    /// Error in tolerances; at most 1 is good.
    pub fn norm(&mut self, system: &System, state: &State, rodas: &Rodas, tolerance: &Tolerance) -> f64 {
        let position = self.of_places(system, state, &rodas.course.error) / tolerance.position;
        let (tension, largest) = self.of_tensions(system, state, rodas);
        let force = tolerance.tension.max(ROUNDING * largest);
        let tension = tension / force;
        let velocity = self.of_swinging(system, &rodas.course.error) / force;
        if position.is_nan() || tension.is_nan() || velocity.is_nan() {
            return f64::INFINITY;
        }
        position.max(tension).max(velocity)
    }

    /// Largest error of a place [m].
    fn of_places(&self, system: &System, state: &State, error: &Increment) -> f64 {
        let mut largest = 0.0_f64;
        for dof in free_dofs(system) {
            largest = largest.max((error.phi[dof] * self.arm[dof]).abs());
            // Nothing holds it: what it does to positions within a second counts.
            largest = largest.max(0.1 * error.v[dof].abs() * self.arm[dof]);
        }
        // A rope that carries nothing yet is wound all the same, and how much of it is as good as a place.
        let idle = |row: usize| state.modes[row] == Mode::Slack;
        let supplies = system.coils.iter().zip(&error.phi[error.v.len()..]);
        for (_, supply) in supplies.filter(|(place, _)| idle(place.row)) {
            largest = largest.max(supply.abs());
        }
        // What water remembers counts as the way of its body that it is made of.
        for memory in memories(&system.tree) {
            let turns = system.tree.support[memory.body].iter().map(|&dof| self.arm[dof]);
            let arm = turns.fold(1.0, f64::max);
            let arms = [1.0, 1.0, 1.0, arm, arm, arm];
            for (error, arm) in error.past[memory.states()].iter().zip(arms.iter().cycle()) {
                largest = largest.max((error * arm).abs());
            }
        }
        largest
    }

    /// Root mean square of the errors of tensions, and the largest force [N]; notes how stiff rows are.
    fn of_tensions(&mut self, system: &System, state: &State, rodas: &Rodas) -> (f64, f64) {
        let (error, here) = (&rodas.course.error, &rodas.here);
        self.stiffness.fill(0.0);
        let (mut sum, mut count, mut largest) = (0.0, 0.0, 0.0_f64);
        for (row, law) in system.rows.laws.iter().enumerate() {
            if state.modes[row] != Mode::Acting || law.compliance() == 0.0 {
                continue;
            }
            let arm = self.arm_of(system, row);
            largest = largest.max(here.tension[row].abs() / arm);
            let mut stretch = 0.0;
            for (dof, entry) in system.rows.entries(&here.frame.gradient, row) {
                stretch += entry * (error.phi[dof] + law.damping_time() * error.v[dof]);
                self.stiffness[dof] += entry * entry / law.compliance();
            }
            if matches!(law, Law::Unilateral { .. } | Law::Spring { .. }) {
                stretch += self.beside(system, rodas, row);
                sum += (stretch / law.compliance() / arm).powi(2);
                count += 1.0;
            }
        }
        for (error, &row) in error.rigid.iter().zip(&system.rigid) {
            if state.modes[row] == Mode::Acting {
                largest = largest.max(here.tension[row].abs());
                sum += error * error;
                count += 1.0;
            }
        }
        for (error_anchor, &row) in error.anchor.iter().zip(&system.friction) {
            if state.modes[row] == Mode::Slipping {
                // The spring is what carries when it sticks again.
                let stretch = system.rows.rate(&here.frame.gradient, row, &error.phi) - error_anchor;
                sum += (stretch / system.rows.laws[row].compliance()).powi(2);
                count += 1.0;
            }
        }
        (root_mean(sum, count), largest)
    }

    /// Root mean square of the tensions to which errors of velocities lead [N], by how stiff rows are.
    fn of_swinging(&self, system: &System, error: &Increment) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for dof in free_dofs(system) {
            let impedance = (self.stiffness[dof] * system.tree.inertia_scale[dof]).sqrt() / self.arm[dof];
            let swing = error.v[dof] * impedance;
            sum += swing * swing;
            count += 1.0;
        }
        root_mean(sum, count)
    }

    /// What the force of a row is over to be one in newtons: the arm of a hinge of its stops and spring [m], else 1.
    fn arm_of(&self, system: &System, row: usize) -> f64 {
        if row < system.rope_rows() {
            return 1.0;
        }
        match system.constraint_of_row(row) {
            AnyConstraint::Stop(stop) => self.arm[stop.dof],
            _ => 1.0,
        }
    }

    /// What the errors of supplies do to a row beside those of the drums' flows.
    fn beside(&self, system: &System, rodas: &Rodas, row: usize) -> f64 {
        let (error, frame) = (&rodas.course.error, &rodas.here.frame);
        let own = system.coils.iter().enumerate().filter(|(_, place)| place.row == row);
        let terms = own.map(|(index, place)| {
            let supply = error.phi[error.v.len() + index];
            frame.passing[index].supply * (supply - frame.feeding[index] * error.phi[place.dof])
        });
        terms.sum()
    }

    /// Name of the element with the largest error.
    pub fn worst(&self, system: &System, rodas: &Rodas) -> String {
        let error = &rodas.course.error;
        let size = |dof: usize| (error.v[dof] * self.arm[dof]).abs();
        let worst = (0..error.v.len()).max_by(|&a, &b| size(a).total_cmp(&size(b)));
        worst.map_or_else(String::new, |dof| system.tree.bodies[system.tree.owner[dof]].name.clone())
    }
}

/// Degrees of freedom that are neither driven nor flows of light sheaves.
fn free_dofs(system: &System) -> impl Iterator<Item = usize> + '_ {
    (0..system.tree.velocities).filter(|&dof| system.driven[dof].is_none() && !system.is_light[dof])
}

/// Root of the mean of squares, 0 of none.
fn root_mean(sum: f64, count: f64) -> f64 {
    if count > 0.0 { f64::sqrt(sum / count) } else { 0.0 }
}
