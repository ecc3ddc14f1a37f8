//! Recursive Newton–Euler (Featherstone 2008, section 5.3) in world axes.
//!
//! For a body with origin o on a parent with origin o_p, r = o − o_p, and columns (a_j, l_j):
//!
//! ```text
//! ω = ω_p + Σ a_j v_j            α = α_p + ω_p × Σ a_j v_j + Σ a_j v̇_j
//! ȯ = ȯ_p + ω_p × r + Σ l_j v_j   ö = ö_p + α_p × r + ω_p × (ω_p × r) + 2 ω_p × Σ l_j v_j + Σ l_j v̇_j
//! ```
//!
//! It holds for every joint type, since the l_j are fixed in the parent and the a_j all in the parent or all in
//! the body: there Σ ȧ_j v_j = (ω_p + Σ a_j v_j) × Σ a_j v_j is ω_p × Σ a_j v_j too. One of each would leave
//! v₁ v₂ a₁ × a₂.

use glam::{DMat3, DVec3};

use super::joint::Motion;
use super::kinematics::{Kinematics, Twist};
use super::{Body, Tree};

/// Force and moment about a body's origin, world axes.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Wrench {
    /// Force [N].
    pub force: DVec3,
    /// Moment about the body's origin [N m].
    pub moment: DVec3,
}

impl Wrench {
    /// Adds a force [N] at the arm [m] from the origin.
    #[inline]
    pub fn add(&mut self, force: DVec3, arm: DVec3) {
        self.force += force;
        self.moment += arm.cross(force);
    }

    /// Its power in a motion of the same point [W].
    #[inline]
    pub fn power(&self, motion: &Twist) -> f64 {
        self.force.dot(motion.linear) + self.moment.dot(motion.angular)
    }

    /// The same about a point from which it acts at `arm` [m].
    pub fn about(self, arm: DVec3) -> Self {
        Self { moment: self.moment + arm.cross(self.force), ..self }
    }
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
    /// Velocity coordinates at the last update of a tree with forces.
    pub v: Vec<f64>,
    /// What every force does to the flow that it depends on [N].
    pub feeds: Vec<f64>,
}

impl NewtonEuler {
    /// Room for `tree`.
    pub fn new(tree: &Tree) -> Self {
        let bodies = tree.bodies.len();
        Self {
            twists: vec![Twist::default(); bodies],
            accelerations: vec![Twist::default(); bodies],
            wrenches: vec![Wrench::default(); bodies],
            v: vec![0.0; tree.velocities],
            feeds: vec![0.0; tree.forces.len()],
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
        self.forward(tree, kinematics, v, acceleration);
        if let Some(applied) = applied {
            for (wrench, known) in self.wrenches.iter_mut().zip(applied) {
                wrench.force -= known.force;
                wrench.moment -= known.moment;
            }
        }
        self.backward(tree, kinematics, out);
    }

    /// Motion of every body from that of its parent, and in `wrenches` what it needs by itself.
    pub fn forward(&mut self, tree: &Tree, kinematics: &Kinematics, v: &[f64], rate: Option<&[f64]>) {
        for &index in &tree.moving {
            let body = &tree.bodies[index];
            let (mut twist, mut acceleration) = match body.parent {
                Some(parent) => {
                    carried(&self.twists[parent], &self.accelerations[parent], kinematics.arm[index])
                }
                None => <(Twist, Twist)>::default(),
            };
            let above = twist.angular;
            let dofs = body.dofs();
            let columns = kinematics.columns[dofs.clone()].iter().zip(&tree.motions[dofs.clone()]);
            for ((column, motion), dof) in columns.zip(dofs) {
                let change = rate.map_or(0.0, |rate| rate[dof]);
                match motion {
                    Motion::Shift => {
                        let shift = column.linear * v[dof];
                        twist.linear += shift;
                        acceleration.linear += above.cross(shift) * 2.0 + column.linear * change;
                    }
                    Motion::Turn => {
                        let turn = column.angular * v[dof];
                        twist.angular += turn;
                        acceleration.angular += above.cross(turn) + column.angular * change;
                    }
                }
            }
            self.wrenches[index] = if tree.is_point[index] {
                Wrench { force: (acceleration.linear - tree.gravity) * body.mass, moment: DVec3::ZERO }
            } else {
                let rotation = &kinematics.pose[index].rotation;
                let lever = kinematics.lever[index];
                inertial_wrench(body, rotation, lever, tree.gravity, &twist, &acceleration)
            };
            self.twists[index] = twist;
            self.accelerations[index] = acceleration;
        }
        if !tree.forces.is_empty() {
            self.v.copy_from_slice(v);
            self.apply(tree, kinematics);
        }
    }

    /// Sums the wrenches up the tree: every body's becomes what its joint has to transmit, and `out` its share along
    /// the degrees of freedom.
    pub fn backward(&mut self, tree: &Tree, kinematics: &Kinematics, out: &mut [f64]) {
        out.fill(0.0);
        for &index in tree.moving.iter().rev() {
            let body = &tree.bodies[index];
            let wrench = self.wrenches[index];
            let dofs = body.dofs();
            let columns = kinematics.columns[dofs.clone()].iter().zip(&tree.motions[dofs.clone()]);
            for ((column, motion), out) in columns.zip(&mut out[dofs]) {
                *out = match motion {
                    Motion::Shift => column.linear.dot(wrench.force),
                    Motion::Turn => column.angular.dot(wrench.moment),
                };
            }
            if let Some(parent) = body.parent {
                let above = &mut self.wrenches[parent];
                above.force += wrench.force;
                above.moment += wrench.moment + kinematics.arm[index].cross(wrench.force);
            }
        }
        for (force, feed) in tree.forces.iter().zip(&self.feeds) {
            if let Some(dof) = force.flow() {
                out[dof] -= feed;
            }
        }
    }
}

/// Velocity and acceleration of the point at `arm` of a body.
fn carried(twist: &Twist, rate: &Twist, arm: DVec3) -> (Twist, Twist) {
    let swing = twist.angular.cross(arm);
    let linear = rate.linear + rate.angular.cross(arm) + twist.angular.cross(swing);
    (Twist { angular: twist.angular, linear: twist.linear + swing }, Twist { angular: rate.angular, linear })
}

/// m (c̈ − g) and its moment about the origin, `lever` = c − o, plus the rotational inertia terms.
fn inertial_wrench(
    body: &Body,
    rotation: &DMat3,
    lever: DVec3,
    gravity: DVec3,
    twist: &Twist,
    acceleration: &Twist,
) -> Wrench {
    let (_, centre) = carried(twist, acceleration, lever);
    let force = (centre.linear - gravity) * body.mass;
    let turn = rotation.transpose();
    let (spin, spin_rate) = (turn * twist.angular, turn * acceleration.angular);
    let couple = *rotation * (body.inertia * spin_rate + spin.cross(body.inertia * spin));
    Wrench { force, moment: couple + lever.cross(force) }
}
