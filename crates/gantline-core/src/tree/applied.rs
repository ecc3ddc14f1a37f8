//! What forces on bodies ([`crate::force`]) add to inverse dynamics, the mass matrix and the derivatives.
//!
//! A force takes its wrench from what the joint of its body has to transmit. The derivative over a degree of freedom
//! follows as in [`super::tangent`]: what turns along with the body is handed up with the rest of the wrench, and what
//! is left is the change of the wrench as seen from the body, the force's own derivative times the changes of place,
//! velocity and acceleration seen from there. The content of a tank that is pumped is a coordinate too: its joint hangs
//! on the body of the tank, so that the pattern has a place for what it does to that body. What it takes to pump stands
//! in its own row. That is a drive's, no equation, and its derivatives are not needed.

use super::Tree;
use super::bias::{NewtonEuler, Wrench};
use super::joint::Motion;
use super::kinematics::{Kinematics, Twist};
use super::mass::MassMatrix;
use super::tangent::{DynamicsTangent, Place};
use crate::force::At;

impl NewtonEuler {
    /// Takes the wrenches of all forces from what each body needs.
    pub(super) fn apply(&mut self, tree: &Tree, kinematics: &Kinematics) {
        for (index, force) in tree.forces.iter().enumerate() {
            let body = force.body();
            let Wrench { force, moment } = force.wrench(&self.at(tree, kinematics, index));
            self.wrenches[body].force -= force;
            self.wrenches[body].moment -= moment;
        }
    }

    /// What pumps have to give along the contents of their tanks.
    pub(super) fn pump(&self, tree: &Tree, kinematics: &Kinematics, out: &mut [f64]) {
        for (index, force) in tree.forces.iter().enumerate() {
            if let Some(content) = force.content() {
                out[content.dof] += force.head(&self.at(tree, kinematics, index));
            }
        }
    }

    /// Place and motion of the body of a force, by its index, at the last update.
    pub fn at<'a>(&self, tree: &Tree, kinematics: &'a Kinematics, force: usize) -> At<'a> {
        let body = tree.forces[force].body();
        let (twist, rate) = (self.twists[body], self.accelerations[body]);
        let pumped = kinematics.pumped[force];
        At { pose: &kinematics.pose[body], twist, rate, gravity: tree.gravity, pumped }
    }
}

impl MassMatrix {
    /// Adds what moves along with bodies: Σ Jᵀ A J.
    pub(super) fn add_inertia(&mut self, tree: &Tree, kinematics: &Kinematics) {
        for (force, pumped) in tree.forces.iter().zip(&kinematics.pumped) {
            let body = force.body();
            let Some(inertia) = force.inertia(&kinematics.pose[body], *pumped) else { continue };
            let support = &tree.support[body];
            for (index, &row) in support.iter().enumerate() {
                let Wrench { force, moment } = inertia.times(&column(tree, kinematics, row, body));
                for &other in &support[..=index] {
                    let above = column(tree, kinematics, other, body);
                    let slot = self.slot(row, other);
                    self.values[slot] += force.dot(above.linear) + moment.dot(above.angular);
                }
            }
        }
    }
}

/// Motion of a body's origin under one unit of a degree of freedom.
fn column(tree: &Tree, kinematics: &Kinematics, dof: usize, body: usize) -> Twist {
    let linear = kinematics.point_column(tree, dof, kinematics.pose[body].position);
    Twist { angular: kinematics.columns[dof].angular, linear }
}

impl DynamicsTangent {
    /// Adds what the wrench of one force does to the derivatives over all degrees of freedom that move its body.
    pub(super) fn add_force(&mut self, place: &Place, index: usize) {
        let Place { tree, kinematics, dynamics, .. } = *place;
        let force = &tree.forces[index];
        let (body, at) = (force.body(), dynamics.at(tree, kinematics, index));
        let tangent = force.tangent(&at);
        if let Some(content) = force.content() {
            self.position.take(place, (content.dof, body), &[force.wrench_per_content(&at)]);
        }
        for &dof in &tree.support[body] {
            let top = tree.owner[dof];
            let own = kinematics.columns[dof];
            let [shifted, sped] = place.seeds(dof);
            let (spin, mut rate) = self.carried(place, (top, body), &shifted);
            let arm = kinematics.pose[body].position - kinematics.pose[top].position;
            let mut velocity = Twist { angular: spin, linear: spin.cross(arm) };
            match tree.motions[dof] {
                Motion::Shift => {
                    let above =
                        tree.bodies[top].parent.map_or(Twist::default(), |parent| dynamics.twists[parent]);
                    velocity.linear += above.angular.cross(own.linear);
                }
                Motion::Turn => {
                    velocity.linear -= own.angular.cross(dynamics.twists[top].linear);
                    // Gravity does not turn along: seen from the body it seems to.
                    rate.linear -= own.angular.cross(tree.gravity);
                }
            }
            let moved = column(tree, kinematics, dof, body);
            let parts = [
                tangent.place.times(&moved),
                tangent.velocity.times(&velocity),
                tangent.acceleration.times(&rate),
            ];
            self.position.take(place, (dof, body), &parts);

            let (spin, rate) = self.carried(place, (top, body), &sped);
            let linear = match tree.motions[dof] {
                Motion::Shift => own.linear,
                Motion::Turn => spin.cross(arm),
            };
            let velocity = Twist { angular: spin, linear };
            let parts = [tangent.velocity.times(&velocity), tangent.acceleration.times(&rate)];
            self.velocity.take(place, (dof, body), &parts);
        }
    }
}

impl DynamicsTangent {
    /// xᵀ (∂τ/∂v) x.
    pub fn velocity_form(&self, tree: &Tree, x: &[f64]) -> f64 {
        let mass = MassMatrix::new(tree);
        let mut sum = 0.0;
        for dof in 0..x.len() {
            let diagonal = mass.row_start[dof + 1] - 1;
            for slot in mass.row_start[dof]..diagonal {
                sum +=
                    (self.velocity.lower[slot] + self.velocity.upper[slot]) * x[dof] * x[mass.columns[slot]];
            }
            sum += self.velocity.lower[diagonal] * x[dof] * x[dof];
        }
        sum
    }
}

impl super::tangent::Paired {
    /// Takes wrenches on a body, changes over `dof`, from the rows of all degrees of freedom that move it.
    fn take(&mut self, place: &Place, (dof, body): (usize, usize), parts: &[Wrench]) {
        let Place { tree, kinematics, mass, .. } = *place;
        for &row in &tree.support[body] {
            let own = column(tree, kinematics, row, body);
            let work = |part: &Wrench| own.linear.dot(part.force) + own.angular.dot(part.moment);
            let value: f64 = parts.iter().map(work).sum();
            if row >= dof {
                self.lower[mass.slot(row, dof)] -= value;
            } else {
                self.upper[mass.slot(dof, row)] -= value;
            }
        }
    }
}
