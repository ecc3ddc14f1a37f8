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
//! on the right side. So does what the tensions change in the resistance of sheaves that slip, which would make the
//! matrix unsymmetric: losses are a share of tensions, so that converges. What wind and current push with does as well, and
//! as much as it likes: its other half ([`super::stream`]) is in the factors.
//!
//! What λM holds back falls from one solution to the next, but for a motion that nothing else holds. A parameter that sets
//! such a motion going, as the mass on one side of two that are in balance over a sheave, has no derivative, and says so.
//!
//! Where a body's joint sits, ∂/∂p of the right side is the difference of values and gradients, which are exact, over
//! four places of the joint with coordinates and forces as they are.

use glam::DVec3;

use super::bearing::Part;
use super::search::LEAST;
use super::standing::Friction;
use super::{NoEquilibrium, Statics};
use crate::constraint::AnyConstraint;
use crate::constraint::brake::At;
use crate::constraint::rope::Rope;
use crate::constraint::rope::span::Span;
use crate::state::State;
use crate::stepper::frame::Remembered;
use crate::system::System;

/// Solutions with λM moved to the right side, each of which leaves λ/ω² of the error, at least and at most.
const REPEATS: usize = 3;
const MOST_REPEATS: usize = 200;
/// What λM may hold back in the end, as a share of the forces that change; of motions that nothing drives 1e-13 is left.
const HELD_BACK: f64 = 1e-9;
/// Nothing but λM holds what it holds back by this much of what it was a solution before: 0.99 would be ω² = 1e-8/s².
const NEVER_LESS: f64 = 0.99;
/// Change of the resistance of sheaves from one solution to the next, relative to the largest.
const LOSS_LEFT: f64 = 1e-13;
/// Between the places of a joint that are compared [m].
const SHIFT: f64 = 5e-3;
/// Weights of the places at −2, −1, 1 and 2 times that, of fourth order.
const PLACES: [(f64, f64); 4] =
    [(-2.0, 1.0 / 12.0), (-1.0, -2.0 / 3.0), (1.0, 2.0 / 3.0), (2.0, -1.0 / 12.0)];
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
    /// Place of a body's joint along an axis of the world, with all that hangs on the body [m].
    Place(usize, usize),
}

/// Derivatives over one parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensitivity {
    /// Of every degree of freedom.
    pub motion: Vec<f64>,
    /// Of the force of every row [N].
    pub tension: Vec<f64>,
    /// False where the parameter sets something going that nothing holds: then there is no derivative, and these are the
    /// forces with which it gathers speed.
    pub is_held: bool,
}

impl Statics {
    /// Derivatives of the equilibrium in which `state` is since the last [`Statics::settle`], for every parameter, with
    /// contacts that `friction` holds.
    ///
    /// # Errors
    /// [`NoEquilibrium`] where none has been found, or the tangent is singular.
    pub fn sensitivities(
        &mut self,
        system: &System,
        state: &State,
        parameters: &[Parameter],
        friction: Friction,
    ) -> Result<Vec<Sensitivity>, NoEquilibrium> {
        if !self.is_found {
            let cause = "none has been found about which it could be asked".to_owned();
            return Err(NoEquilibrium { element: "the lift".to_owned(), cause });
        }
        let follows = self.taking_part(system, state, friction);
        let Self { search, bearings, .. } = self;
        search.linearise(system, state);
        search.matrix.extra.fill(0.0);
        let compliance = |row: usize| {
            let bearing = &bearings[row];
            let share = if bearing.is_rigid { STIFFER } else { 1.0 };
            follows[row].then_some(bearing.compliance * share)
        };
        search.matrix.factorise_whole(system, LEAST, compliance).map_err(|pivot| {
            let element = search.matrix.layout.element(system, pivot.unknown).to_owned();
            NoEquilibrium { element, cause: "the tangent is singular here".to_owned() }
        })?;
        let mut all = Vec::with_capacity(parameters.len());
        let (mut force, mut right) = (vec![0.0; system.tree.velocities], vec![0.0; system.rows.count()]);
        for parameter in parameters {
            force.fill(0.0);
            right.fill(0.0);
            if let Parameter::Place(body, axis) = *parameter {
                self.shift_joint(system, state, (body, axis), (&mut force, &mut right));
            } else {
                self.right_side(system, *parameter, &mut force, &mut right);
            }
            all.push(self.answer(system, state, &force, &right));
        }
        Ok(all)
    }

    /// The solution of (ST3) with a right side, by repeating it.
    fn answer(&mut self, system: &System, state: &State, force: &[f64], right: &[f64]) -> Sensitivity {
        let mut motion = vec![0.0; force.len()];
        let mut tension = vec![0.0; right.len()];
        let mut resistance = vec![0.0; right.len()];
        let mut inertia = force.to_vec();
        let (mut before, mut held_back) = (motion.clone(), 0.0);
        for round in 1..=MOST_REPEATS {
            let search = &mut self.search;
            search.here.frame.mass.multiply(&motion, &mut inertia);
            before.copy_from_slice(&motion);
            for (inertia, force) in inertia.iter_mut().zip(force) {
                *inertia = LEAST * *inertia + force;
            }
            for (row, change) in resistance.iter().enumerate().filter(|(_, change)| **change != 0.0) {
                for (dof, entry) in system.rows.entries(&search.here.frame.gradient, row) {
                    inertia[dof] -= entry * change;
                }
            }
            search.matrix.solve_whole(&inertia, right, &mut motion, &mut tension);
            let is_settled = self.follow_resistance(system, state, &motion, &tension, &mut resistance);
            let last = held_back;
            held_back = self.held_back(system, (&before, &motion), (force, right), &tension);
            let is_done = held_back <= HELD_BACK || held_back > NEVER_LESS * last;
            if round >= REPEATS && is_settled && is_done {
                break;
            }
        }
        for (tension, change) in tension.iter_mut().zip(&resistance).filter(|(_, change)| **change != 0.0) {
            *tension = *change;
        }
        Sensitivity { motion, tension, is_held: held_back <= HELD_BACK }
    }

    /// What λM held back in the last solution, relative to the forces that change and those that would if nothing moved: the
    /// largest of either over the root of its degree of freedom's mass, so that forces and moments compare.
    fn held_back(
        &self,
        system: &System,
        (before, motion): (&[f64], &[f64]),
        (force, right): (&[f64], &[f64]),
        tension: &[f64],
    ) -> f64 {
        let frame = &self.search.here.frame;
        let moved: Vec<f64> = motion.iter().zip(before).map(|(now, before)| now - before).collect();
        let mut inertia = vec![0.0; moved.len()];
        frame.mass.multiply(&moved, &mut inertia);
        let mut changes: Vec<f64> = force.iter().map(|force| force.abs()).collect();
        for (row, (change, right)) in tension.iter().zip(right).enumerate() {
            let change = change.abs() + right.abs() / self.bearings[row].compliance;
            for (dof, entry) in system.rows.entries(&frame.gradient, row) {
                changes[dof] += entry.abs() * change;
            }
        }
        let largest = |of: &[f64]| {
            let free = self.search.matrix.layout.free.iter();
            free.map(|&dof| of[dof].abs() / frame.mass.diagonal(dof).sqrt()).fold(0.0, f64::max)
        };
        let all = largest(&changes);
        if all > 0.0 { LEAST * largest(&inertia) / all } else { 0.0 }
    }

    /// What a parameter does to the tension of its rope [N] while the force of its row stays: a curve that all of a
    /// rope's stiffness scales, the length of a span that is fed.
    pub(super) fn own_change(&self, system: &System, parameter: Parameter) -> Option<(usize, f64)> {
        let (Parameter::Stiffness(index) | Parameter::Length(index)) = parameter else { return None };
        let AnyConstraint::Rope(rope) = &system.constraints[index] else { return None };
        let force = self.search.here.tension[system.rows.first[index]];
        if let Parameter::Length(_) = parameter {
            let (span, q) = (&rope.spans[0], &self.search.here.q);
            return (!span.feeds.is_empty()).then(|| (index, span.tension_change(q, force, 0.0, 1.0)));
        }
        let curve = rope.spans[0].curve.as_ref()?;
        let still = curve.under(force);
        Some((index, (still.tension - still.growth * force) / curve.axial_stiffness))
    }

    /// What velocities alone do to the tension of every rope, by changes of the forces of rows [N].
    pub(super) fn rope_rates(&self, system: &System, change: &[f64]) -> Vec<f64> {
        let here = &self.search.here;
        let of_span = |span: &Span, row: usize| span.tension_rate(&here.q, here.tension[row], change[row]);
        let ropes = system.ropes().zip(&system.rows.first);
        ropes.map(|(rope, &first)| rope.mean(|span| of_span(&rope.spans[span], first + span))).collect()
    }

    /// What changes of the degrees of freedom and of the forces of rows do to the tension of every rope [N], as it is
    /// recorded: forces of rows are not tensions where rope is fed, and spans of a rope have one each.
    pub(super) fn rope_changes(&self, system: &System, motion: &[f64], change: &[f64]) -> Vec<f64> {
        let here = &self.search.here;
        let of_span = |span: &Span, row: usize| {
            let feeds = span.feeds.iter();
            let supply = feeds.map(|feed| feed.speed_rate(&here.frame.feeding) * motion[feed.dof]).sum();
            span.tension_change(&here.q, here.tension[row], change[row], supply)
        };
        let ropes = system.ropes().zip(&system.rows.first);
        ropes.map(|(rope, &first)| rope.mean(|span| of_span(&rope.spans[span], first + span))).collect()
    }

    /// What a change of motion and tensions does to the forces of sheaves that slip; true if that is known already.
    fn follow_resistance(
        &self,
        system: &System,
        state: &State,
        motion: &[f64],
        tension: &[f64],
        resistance: &mut [f64],
    ) -> bool {
        let here = &self.search.here;
        let (mut moved, mut largest) = (0.0_f64, 0.0_f64);
        for (row, bearing) in self.bearings.iter().enumerate() {
            let (AnyConstraint::Brake(brake), Part::Resist(force)) =
                (system.constraint_of_row(row), bearing.part)
            else {
                continue;
            };
            let at = At { q: &here.q, kinematics: &here.frame.kinematics, seats: &state.seats };
            let sides = brake.spans.iter().filter(|(side, _)| here.tension[*side] > 0.0);
            let mut change: f64 = sides.map(|(side, _)| brake.weight(at, *side) * tension[*side]).sum();
            let dofs = &system.rows.dofs[system.rows.start[row]..system.rows.start[row + 1]];
            brake.add_slopes(at, &here.frame.feeding, &here.tension, |entry, slope| {
                change += slope * motion[dofs[entry]];
            });
            change *= force.signum();
            moved = moved.max((change - resistance[row]).abs());
            largest = largest.max(change.abs());
            resistance[row] = change;
        }
        moved <= LOSS_LEFT * largest
    }

    /// Right side of a shift of a body's joint.
    fn shift_joint(
        &self,
        system: &System,
        state: &State,
        (body, axis): (usize, usize),
        (force, right): (&mut [f64], &mut [f64]),
    ) {
        let here = &self.search.here;
        let (mut moved, mut there) = (system.clone(), here.clone());
        let place = &system.tree.bodies[body];
        let world = DVec3::AXES[axis];
        let pose = |parent: usize| here.frame.kinematics.pose[parent];
        let along = place.parent.map_or(world, |parent| pose(parent).rotation.transpose() * world);
        for (step, weight) in PLACES {
            moved.tree.bodies[body].placement.position = place.placement.position + along * (step * SHIFT);
            there.update(&moved, &self.bearings, &Remembered::of(state));
            let share = weight / SHIFT;
            for (force, gravity) in force.iter_mut().zip(&there.gravity) {
                *force -= share * gravity;
            }
            for (row, bearing) in self.bearings.iter().enumerate() {
                for (dof, entry) in system.rows.entries(&there.frame.gradient, row) {
                    force[dof] -= share * entry * here.tension[row];
                }
                if here.follows[row] && matches!(bearing.part, Part::Pull | Part::Spring) {
                    right[row] -= share * there.frame.value[row];
                }
            }
        }
    }

    /// A rope that pulls, with its row and its tension [N].
    fn pulling<'a>(&self, system: &'a System, rope: usize) -> Option<(&'a Rope, usize, f64)> {
        let AnyConstraint::Rope(constraint) = &system.constraints[rope] else { return None };
        let (row, here) = (system.rows.first[rope], &self.search.here);
        here.follows[row].then(|| (constraint, row, here.tension[row]))
    }

    /// e − ε T with e = ℓ − L and ε = L/EA, over L.
    fn of_length(&self, system: &System, rope: usize, force: &mut [f64], right: &mut [f64]) {
        let Some((rope, row, tension)) = self.pulling(system, rope) else { return };
        let (span, here) = (&rope.spans[0], &self.search.here);
        let stiffness = rope.material.axial_stiffness;
        let pull = if let Some(curve) = &span.curve {
            // g − ε λ with both L f and ε of the length, and the pull w λ with w = f′.
            let still = curve.under(tension);
            let long = 1.0 + still.strain;
            right[row] = still.scale * long;
            tension * curve.at(still.strain).bend * long / (still.scale * rope.length)
        } else if !span.feeds.is_empty() {
            // g − ε λ with L in g alone, ∂g/∂L = −w (1 + ε/2), and the pull w λ with ∂w/∂L = −w/2L.
            let scale = span.scale(&here.q);
            right[row] = scale * (1.0 + 0.5 * scale * tension / stiffness);
            0.5 * tension / span.unstretched(&here.q)
        } else {
            right[row] = 1.0 + tension / stiffness;
            return;
        };
        for (dof, entry) in system.rows.entries(&here.frame.gradient, row) {
            force[dof] += pull * entry;
        }
    }

    /// The same over EA.
    fn of_stiffness(&self, system: &System, rope: usize, right: &mut [f64]) {
        let Some((rope, row, tension)) = self.pulling(system, rope) else { return };
        let stiffness = rope.material.axial_stiffness;
        right[row] = match rope.material.is_inextensible() {
            true => 0.0,
            false => -tension * rope.length / (stiffness * stiffness),
        };
    }

    fn right_side(&self, system: &System, parameter: Parameter, force: &mut [f64], right: &mut [f64]) {
        let kinematics = &self.search.here.frame.kinematics;
        match parameter {
            Parameter::Length(rope) => self.of_length(system, rope, force, right),
            Parameter::Stiffness(rope) => self.of_stiffness(system, rope, right),
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
            Parameter::Place(..) => {}
        }
    }
}
