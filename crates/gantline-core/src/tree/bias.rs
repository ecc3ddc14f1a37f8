//! Recursive Newton–Euler (Featherstone 2008, section 5.3) in world axes.
//!
//! For a body with origin o on a parent with origin o_p, r = o − o_p, and columns (a_j, l_j):
//!
//! ```text
//! ω = ω_p + Σ a_j v_j            α = α_p + ω_p × Σ a_j v_j + Σ a_j v̇_j
//! ȯ = ȯ_p + ω_p × r + Σ l_j v_j   ö = ö_p + α_p × r + ω_p × (ω_p × r) + 2 ω_p × Σ l_j v_j + Σ l_j v̇_j
//! ```
//!
//! It holds for every joint type, since l_j is fixed in the parent and a_j in the parent or in the body.

use glam::DVec3;

use super::Tree;
use super::kinematics::{Kinematics, Twist};

/// Force and moment about a body's origin, world axes.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Wrench {
    /// Force [N].
    pub force: DVec3,
    /// Moment about the body's origin [N m].
    pub moment: DVec3,
}

/// Inverse dynamics. Reused from step to step.
#[derive(Debug, Clone)]
pub struct NewtonEuler {
    /// Velocities of all bodies at the last update.
    pub twists: Vec<Twist>,
    /// Accelerations of all bodies at the last update.
    pub accelerations: Vec<Twist>,
    /// After [`NewtonEuler::update`]: what the joint of every body has to transmit to it.
    pub wrenches: Vec<Wrench>,
}

impl NewtonEuler {
    /// Room for `tree`.
    pub fn new(tree: &Tree) -> Self {
        let bodies = tree.bodies.len();
        Self {
            twists: vec![Twist::default(); bodies],
            accelerations: vec![Twist::default(); bodies],
            wrenches: vec![Wrench::default(); bodies],
        }
    }

    /// Generalised force M v̇ + c(q, v) − f_gravity that the motion needs; `acceleration` none is v̇ = 0.
    ///
    /// `applied` adds known forces on the bodies (about their origins): they need not be transmitted.
    pub fn update(
        &mut self,
        tree: &Tree,
        kinematics: &Kinematics,
        v: &[f64],
        acceleration: Option<&[f64]>,
        applied: Option<&[Wrench]>,
        out: &mut [f64],
    ) {
        kinematics.twists(tree, v, &mut self.twists);
        self.forward(tree, kinematics, v, acceleration);
        for (index, body) in tree.bodies.iter().enumerate() {
            let wrench = inertial_wrench(
                body.mass,
                kinematics.centre_of_gravity[index] - kinematics.pose[index].position,
                tree.gravity,
                kinematics.pose[index].rotation,
                body.inertia,
                &self.twists[index],
                &self.accelerations[index],
            );
            let known = applied.map_or_else(Wrench::default, |applied| applied[index]);
            self.wrenches[index] =
                Wrench { force: wrench.force - known.force, moment: wrench.moment - known.moment };
        }
        self.backward(tree, kinematics, out);
    }

    fn forward(&mut self, tree: &Tree, kinematics: &Kinematics, v: &[f64], rate: Option<&[f64]>) {
        for (index, body) in tree.bodies.iter().enumerate() {
            let mut acceleration = Twist::default();
            let mut parent_angular = DVec3::ZERO;
            if let Some(parent) = body.parent {
                let arm = kinematics.pose[index].position - kinematics.pose[parent].position;
                let above = &self.accelerations[parent];
                parent_angular = self.twists[parent].angular;
                acceleration.angular = above.angular;
                acceleration.linear =
                    above.linear + above.angular.cross(arm) + parent_angular.cross(parent_angular.cross(arm));
            }
            for k in 0..body.joint.velocities() {
                let dof = body.first_velocity + k;
                let column = &kinematics.columns[dof];
                acceleration.angular += parent_angular.cross(column.angular * v[dof]);
                acceleration.linear += 2.0 * parent_angular.cross(column.linear * v[dof]);
                if let Some(rate) = rate {
                    acceleration.angular += column.angular * rate[dof];
                    acceleration.linear += column.linear * rate[dof];
                }
            }
            self.accelerations[index] = acceleration;
        }
    }

    fn backward(&mut self, tree: &Tree, kinematics: &Kinematics, out: &mut [f64]) {
        for index in (0..tree.bodies.len()).rev() {
            let body = &tree.bodies[index];
            let wrench = self.wrenches[index];
            for k in 0..body.joint.velocities() {
                let dof = body.first_velocity + k;
                let column = &kinematics.columns[dof];
                out[dof] = column.angular.dot(wrench.moment) + column.linear.dot(wrench.force);
            }
            if let Some(parent) = body.parent {
                let arm = kinematics.pose[index].position - kinematics.pose[parent].position;
                let above = &mut self.wrenches[parent];
                above.force += wrench.force;
                above.moment += wrench.moment + arm.cross(wrench.force);
            }
        }
    }
}

/// m (c̈ − g) and its moment about the origin, `arm` = c − o, plus the rotational inertia terms.
fn inertial_wrench(
    mass: f64,
    arm: DVec3,
    gravity: DVec3,
    rotation: glam::DMat3,
    inertia: glam::DMat3,
    twist: &Twist,
    acceleration: &Twist,
) -> Wrench {
    let centre =
        acceleration.linear + acceleration.angular.cross(arm) + twist.angular.cross(twist.angular.cross(arm));
    let force = (centre - gravity) * mass;
    let turn = rotation.transpose();
    let (spin, spin_rate) = (turn * twist.angular, turn * acceleration.angular);
    let couple = rotation * (inertia * spin_rate + spin.cross(inertia * spin));
    Wrench { force, moment: couple + arm.cross(force) }
}
