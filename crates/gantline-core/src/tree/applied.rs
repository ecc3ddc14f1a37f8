//! What forces on bodies ([`crate::force`]) add to inverse dynamics, the mass matrix and the derivatives.
//!
//! A force takes its wrench from what the joint of its body has to transmit. The derivative over a degree of freedom
//! follows as in [`super::tangent`]: what turns along with the body is handed up with the rest of the wrench, and what
//! is left is the change of the wrench as seen from the body, the force's own derivative times the changes of place,
//! velocity and acceleration seen from there. Line that a winch pays out and what is pumped into a tank are coordinates
//! too: their joints hang on the body, so that the pattern has a place for what they do to it.

use super::Tree;
use super::bias::{NewtonEuler, Wrench};
use super::joint::Motion;
use super::kinematics::{Kinematics, Twist};
use super::mass::MassMatrix;
use super::tangent::{DynamicsTangent, Place};
use crate::force::{AnyForce, At};

impl NewtonEuler {
    /// Takes the wrenches of all forces from what each body needs.
    pub(super) fn apply(&mut self, tree: &Tree, kinematics: &Kinematics) {
        for (index, force) in tree.forces.iter().enumerate() {
            let body = force.body();
            let at = self.at(tree, kinematics, body);
            let (wrench, feed) = force.push(&at);
            self.wrenches[body].force -= wrench.force;
            self.wrenches[body].moment -= wrench.moment;
            self.feeds[index] = feed;
        }
    }

    /// Place and motion of a body at the last update.
    pub fn at<'a>(&'a self, tree: &Tree, kinematics: &'a Kinematics, body: usize) -> At<'a> {
        let (twist, rate) = (self.twists[body], self.accelerations[body]);
        let Kinematics { pose, q, time, past, .. } = kinematics;
        At { pose: &pose[body], twist, rate, gravity: tree.gravity, time: *time, q, v: &self.v, past }
    }
}

impl MassMatrix {
    /// Adds what moves along with bodies: Σ Jᵀ A J.
    pub(super) fn add_inertia(&mut self, tree: &Tree, kinematics: &Kinematics) {
        for force in &tree.forces {
            let body = force.body();
            let Some(inertia) = force.inertia(kinematics) else { continue };
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
    pub(super) fn add_force(&mut self, place: &Place, force: &AnyForce) {
        let Place { tree, kinematics, dynamics, .. } = *place;
        let body = force.body();
        let at = dynamics.at(tree, kinematics, body);
        let tangent = force.tangent(&at);
        let feeding = force.flow().zip(force.feeding(&at));
        if let Some((flow, feeding)) = feeding {
            self.position.take(place, (flow, body), &feeding.wrench[..1]);
            self.velocity.take(place, (flow, body), &feeding.wrench[1..]);
            self.position.add(place, (flow, flow), -feeding.flow[0]);
            self.velocity.add(place, (flow, flow), -feeding.flow[1]);
        }
        for &dof in &tree.support[body] {
            let [(velocity, rate), (sped, speeding)] = self.seen(place, (dof, body));
            let moved = column(tree, kinematics, dof, body);
            let parts = [
                tangent.place.times(&moved),
                tangent.velocity.times(&velocity),
                tangent.acceleration.times(&rate),
            ];
            self.position.take(place, (dof, body), &parts);
            if let Some((flow, feeding)) = feeding {
                let change = work(&moved, &feeding.body[0]) + work(&velocity, &feeding.body[1]);
                self.position.add(place, (flow, dof), -change);
            }
            let parts = [tangent.velocity.times(&sped), tangent.acceleration.times(&speeding)];
            self.velocity.take(place, (dof, body), &parts);
            if let Some((flow, feeding)) = feeding {
                self.velocity.add(place, (flow, dof), -work(&sped, &feeding.body[1]));
            }
        }
    }

    /// Changes of velocity and acceleration of a body, as seen from it, over the position and over the velocity of a
    /// degree of freedom that moves it; gravity does not turn along.
    fn seen(&mut self, place: &Place, (dof, body): (usize, usize)) -> [(Twist, Twist); 2] {
        let Place { tree, kinematics, dynamics, .. } = *place;
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
        let (spin, speeding) = self.carried(place, (top, body), &sped);
        let linear = match tree.motions[dof] {
            Motion::Shift => own.linear,
            Motion::Turn => spin.cross(arm),
        };
        [(velocity, rate), (Twist { angular: spin, linear }, speeding)]
    }

    /// Changes of the velocity of a body as seen from it over the position and over the velocity of a degree of freedom
    /// that moves it.
    pub fn of_motion(
        &mut self,
        tree: &Tree,
        (kinematics, mass, dynamics): (&Kinematics, &MassMatrix, &NewtonEuler),
        v: &[f64],
        dof: (usize, usize),
    ) -> [Twist; 2] {
        let place = Place { tree, kinematics, mass, dynamics, v };
        self.seen(&place, dof).map(|(velocity, _)| velocity)
    }
}

/// Power of a wrench on a motion.
fn work(motion: &Twist, wrench: &Wrench) -> f64 {
    motion.linear.dot(wrench.force) + motion.angular.dot(wrench.moment)
}

impl DynamicsTangent {
    /// Entries of ∂τ/∂v, by row and column.
    pub fn over_velocity(&self, tree: &Tree, mut visit: impl FnMut([usize; 2], f64)) {
        let mass = MassMatrix::new(tree);
        for dof in 0..tree.velocities {
            let diagonal = mass.row_start[dof + 1] - 1;
            for slot in mass.row_start[dof]..diagonal {
                visit([dof, mass.columns[slot]], self.velocity.lower[slot]);
                visit([mass.columns[slot], dof], self.velocity.upper[slot]);
            }
            visit([dof, dof], self.velocity.lower[diagonal]);
        }
    }
}

impl super::tangent::Paired {
    /// Takes wrenches on a body, changes over `dof`, from the rows of all degrees of freedom that move it.
    fn take(&mut self, place: &Place, (dof, body): (usize, usize), parts: &[Wrench]) {
        let Place { tree, kinematics, .. } = *place;
        for &row in &tree.support[body] {
            let own = column(tree, kinematics, row, body);
            let value: f64 = parts.iter().map(|part| work(&own, part)).sum();
            self.add(place, (row, dof), -value);
        }
    }

    /// Adds to the change of the row of one degree of freedom over another.
    fn add(&mut self, place: &Place, (row, dof): (usize, usize), value: f64) {
        if row >= dof {
            self.lower[place.mass.slot(row, dof)] += value;
        } else {
            self.upper[place.mass.slot(dof, row)] += value;
        }
    }
}
