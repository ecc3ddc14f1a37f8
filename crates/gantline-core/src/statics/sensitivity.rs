//! How an equilibrium answers to what is uncertain: lengths, stiffness, weights and their places.
//!
//! With the tangent of the equilibrium factorised, each parameter p costs one more solution:
//!
//! ```text
//! [ K   Gᵀ ] [ dq/dp ]     [ ∂(∂V/∂q)/∂p   ]
//! [ G   −ε ] [ dT/dp ] = − [ ∂(e − ε T)/∂p ]
//! ```
//!
//! What nothing holds would make the matrix singular, so K + λM stands in it, and λM dq/dp of the last solution comes back
//! on the right side.

use glam::DVec3;

use super::search::LEAST;
use super::{NoEquilibrium, Statics};
use crate::constraint::AnyConstraint;
use crate::state::State;
use crate::system::System;

/// Solutions with λM moved to the right side, each of which leaves λ/ω² of the error.
const REPEATS: usize = 3;
/// Compliance of rows that have none, as a share of what the search gave them.
const STIFFER: f64 = 1e-9;

/// What may differ from its plan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Parameter {
    /// Unstretched length of a rope [m].
    Length(usize),
    /// Axial stiffness EA of a rope [N].
    Stiffness(usize),
    /// Centre of gravity of a body along an axis of its own [m].
    Centre(usize, usize),
    /// Mass of a body at its centre of gravity [kg].
    Mass(usize),
}

/// Derivatives over one parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensitivity {
    /// Of every degree of freedom.
    pub motion: Vec<f64>,
    /// Of the force of every row [N].
    pub tension: Vec<f64>,
}

impl Statics {
    /// Derivatives of the equilibrium in which `state` is since the last [`Statics::settle`], for every parameter.
    ///
    /// # Errors
    /// [`NoEquilibrium`] where the tangent is singular, or a rope asked about is fed by a drum or a sheave with
    /// losses: its length is then no number of the plan.
    pub fn sensitivities(
        &mut self,
        system: &System,
        state: &State,
        parameters: &[Parameter],
    ) -> Result<Vec<Sensitivity>, NoEquilibrium> {
        let Self { search, bearings, .. } = self;
        search.here.update_mass(system);
        search.matrix.linearise(system, &search.here, &state.seats);
        search.matrix.extra.fill(0.0);
        let follows = &search.here.follows;
        let compliance = |row: usize| {
            let bearing = &bearings[row];
            let share = if bearing.is_rigid { STIFFER } else { 1.0 };
            follows[row].then_some(bearing.compliance * share)
        };
        search.matrix.factorise(system, LEAST, compliance).map_err(|pivot| {
            let element = search.matrix.layout.element(system, pivot.unknown).to_owned();
            NoEquilibrium { element, cause: "the tangent is singular here".to_owned() }
        })?;
        let mut all = Vec::with_capacity(parameters.len());
        let (mut force, mut right) = (vec![0.0; system.tree.velocities], vec![0.0; system.rows.count()]);
        let mut inertia = force.clone();
        for parameter in parameters {
            force.fill(0.0);
            right.fill(0.0);
            self.right_side(system, *parameter, &mut force, &mut right)?;
            let mut motion = vec![0.0; force.len()];
            let mut tension = vec![0.0; right.len()];
            let search = &mut self.search;
            for _ in 0..REPEATS {
                search.here.frame.mass.multiply(&motion, &mut inertia);
                for (inertia, force) in inertia.iter_mut().zip(&force) {
                    *inertia = LEAST * *inertia + force;
                }
                search.matrix.solve(&inertia, &right, &mut motion, &mut tension);
            }
            all.push(Sensitivity { motion, tension });
        }
        Ok(all)
    }

    fn right_side(
        &self,
        system: &System,
        parameter: Parameter,
        force: &mut [f64],
        right: &mut [f64],
    ) -> Result<(), NoEquilibrium> {
        let kinematics = &self.search.here.frame.kinematics;
        match parameter {
            Parameter::Length(rope) | Parameter::Stiffness(rope) => {
                let AnyConstraint::Rope(constraint) = &system.constraints[rope] else { return Ok(()) };
                if constraint.spans.iter().any(|span| !span.feeds.is_empty()) {
                    let cause = "its length is not that of the plan: a drum or a sheave feeds it".to_owned();
                    return Err(NoEquilibrium { element: constraint.name.clone(), cause });
                }
                let row = system.rows.first[rope];
                if self.search.here.follows[row] {
                    // e − ε T with e = ℓ − L and ε = L/EA.
                    let (tension, stiffness) =
                        (self.search.here.tension[row], constraint.material.axial_stiffness);
                    right[row] = match parameter {
                        Parameter::Length(_) => 1.0 + tension / stiffness,
                        _ if constraint.material.is_inextensible() => 0.0,
                        _ => -tension * constraint.length / (stiffness * stiffness),
                    };
                }
            }
            Parameter::Centre(body, axis) => {
                let mass = system.tree.bodies[body].mass;
                let shift = kinematics.pose[body].rotation * DVec3::AXES[axis];
                let moment = shift.cross(system.tree.gravity * mass);
                for &dof in system.tree.support_of(Some(body)) {
                    force[dof] = kinematics.columns[dof].angular.dot(moment);
                }
            }
            Parameter::Mass(body) => {
                for &dof in system.tree.support_of(Some(body)) {
                    let centre = kinematics.centre_of_gravity[body];
                    let column = kinematics.point_column(&system.tree, dof, centre);
                    force[dof] = column.dot(system.tree.gravity);
                }
            }
        }
        Ok(())
    }
}
