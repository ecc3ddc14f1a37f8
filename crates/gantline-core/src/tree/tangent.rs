//! Derivatives of inverse dynamics τ = M(q) v̇ + c(q, v) − f_gravity over coordinates and velocities.
//!
//! An increment of an angular degree of freedom k turns everything below it as one rigid whole, by a_k about
//! the joint's origin. Seen from there, the velocities and accelerations that come from above have changed by
//! −a_k × (·), and nothing else; the change runs down the tree by the same recursion as the motion itself
//! ([`super::bias`]), and the forces run up again. An increment of a linear degree of freedom moves the whole
//! without turning it. One sweep over the subtree of each degree of freedom gives its column, so the cost is
//! the number of pairs in the tree. Increments are those of [`super::Tree::advance`]: rotation vectors in body
//! axes for ball and free joints, which makes the derivative unsymmetric.

use glam::{DMat3, DVec3};

use super::Tree;
use super::bias::{NewtonEuler, Wrench};
use super::kinematics::{Kinematics, Twist};
use super::mass::MassMatrix;

/// A square matrix with the mass matrix's pattern, unsymmetric: entry (j, k) of the lower triangle and (k, j)
/// of the upper one share a slot.
#[derive(Debug, Clone)]
pub struct Paired {
    /// Lower triangle, diagonal included.
    pub lower: Vec<f64>,
    /// Upper triangle; diagonal not used.
    pub upper: Vec<f64>,
}

/// ∂τ/∂q and ∂τ/∂v. Reused from step to step.
#[derive(Debug, Clone)]
pub struct DynamicsTangent {
    /// ∂τ/∂q.
    pub position: Paired,
    /// ∂τ/∂v.
    pub velocity: Paired,
    /// Change of every body's angular velocity in the subtree of a sweep.
    spin: Vec<DVec3>,
    /// Change of every body's acceleration.
    rate: Vec<Twist>,
    wrench: Vec<Wrench>,
}

/// What starts a sweep: change of the motion of the topmost body, seen from the moved subtree.
struct Seed {
    /// Change of the angular velocity.
    spin: DVec3,
    /// Change of the acceleration.
    rate: Twist,
}

impl DynamicsTangent {
    /// Room for `tree` with the pattern of `mass`.
    pub fn new(tree: &Tree, mass: &MassMatrix) -> Self {
        let zeros = || Paired { lower: vec![0.0; mass.values.len()], upper: vec![0.0; mass.values.len()] };
        Self {
            position: zeros(),
            velocity: zeros(),
            spin: vec![DVec3::ZERO; tree.bodies.len()],
            rate: vec![Twist::default(); tree.bodies.len()],
            wrench: vec![Wrench::default(); tree.bodies.len()],
        }
    }

    /// Evaluates both derivatives at the motion of the last update of `dynamics`, in which no applied forces
    /// were given.
    pub fn update(
        &mut self,
        tree: &Tree,
        kinematics: &Kinematics,
        mass: &MassMatrix,
        dynamics: &NewtonEuler,
        v: &[f64],
    ) {
        for dof in 0..tree.velocities {
            let body = tree.owner[dof];
            let column = kinematics.columns[dof];
            let (above, above_rate) = parent_motion(tree, dynamics, body);
            let joint_spin = dynamics.twists[body].angular - above.angular;

            let turned = -column.angular.cross(above.angular);
            let arm_change = column.linear;
            let here = dynamics.accelerations[body].linear - tree.gravity;
            let seed = Seed {
                spin: turned,
                rate: Twist {
                    angular: turned.cross(joint_spin) - column.angular.cross(above_rate.angular),
                    linear: above_rate.angular.cross(arm_change)
                        + above.angular.cross(above.angular.cross(arm_change))
                        - column.angular.cross(here),
                },
            };
            self.sweep(tree, kinematics, dynamics, v, body, &seed);
            collect(tree, kinematics, mass, (dof, body), (&self.wrench, Some(dynamics)), &mut self.position);

            let seed = Seed {
                spin: column.angular,
                rate: Twist {
                    angular: above.angular.cross(column.angular),
                    linear: 2.0 * above.angular.cross(column.linear),
                },
            };
            self.sweep(tree, kinematics, dynamics, v, body, &seed);
            collect(tree, kinematics, mass, (dof, body), (&self.wrench, None), &mut self.velocity);
        }
    }

    /// Changes of all wrenches in the subtree of `top`, seen from the moved subtree.
    fn sweep(
        &mut self,
        tree: &Tree,
        kinematics: &Kinematics,
        dynamics: &NewtonEuler,
        v: &[f64],
        top: usize,
        seed: &Seed,
    ) {
        self.spin[top] = seed.spin;
        self.rate[top] = seed.rate;
        for &index in &tree.subtree[top][1..] {
            self.pass_on(tree, kinematics, dynamics, v, index);
        }
        for &index in &tree.subtree[top] {
            let body = &tree.bodies[index];
            let pose = &kinematics.pose[index];
            let arm = kinematics.centre_of_gravity[index] - pose.position;
            let inertia = pose.rotation * body.inertia * pose.rotation.transpose();
            let spin = dynamics.twists[index].angular;
            self.wrench[index] =
                wrench_change(body.mass, arm, inertia, spin, self.spin[index], &self.rate[index]);
        }
        for &index in tree.subtree[top][1..].iter().rev() {
            let parent = tree.bodies[index].parent.unwrap_or(top);
            let arm = kinematics.pose[index].position - kinematics.pose[parent].position;
            let wrench = self.wrench[index];
            let above = &mut self.wrench[parent];
            above.force += wrench.force;
            above.moment += wrench.moment + arm.cross(wrench.force);
        }
    }

    /// Change of a body's motion from that of its parent: the recursion of [`super::bias`], linearised.
    fn pass_on(
        &mut self,
        tree: &Tree,
        kinematics: &Kinematics,
        dynamics: &NewtonEuler,
        v: &[f64],
        index: usize,
    ) {
        let body = &tree.bodies[index];
        let parent = body.parent.unwrap_or(index);
        let arm = kinematics.pose[index].position - kinematics.pose[parent].position;
        let (change, spin) = (self.spin[parent], dynamics.twists[parent].angular);
        let Twist { mut angular, mut linear } = self.rate[parent];
        linear += angular.cross(arm) + change.cross(spin.cross(arm)) + spin.cross(change.cross(arm));
        for k in 0..body.joint.velocities() {
            let dof = body.first_velocity + k;
            let column = &kinematics.columns[dof];
            angular += change.cross(column.angular * v[dof]);
            linear += 2.0 * change.cross(column.linear * v[dof]);
        }
        self.spin[index] = change;
        self.rate[index] = Twist { angular, linear };
    }
}

fn parent_motion(tree: &Tree, dynamics: &NewtonEuler, body: usize) -> (Twist, Twist) {
    match tree.bodies[body].parent {
        Some(parent) => (dynamics.twists[parent], dynamics.accelerations[parent]),
        None => (Twist::default(), Twist::default()),
    }
}

fn wrench_change(mass: f64, arm: DVec3, inertia: DMat3, spin: DVec3, change: DVec3, rate: &Twist) -> Wrench {
    let centre =
        rate.linear + rate.angular.cross(arm) + change.cross(spin.cross(arm)) + spin.cross(change.cross(arm));
    let force = centre * mass;
    let couple = inertia * rate.angular + change.cross(inertia * spin) + spin.cross(inertia * change);
    Wrench { force, moment: couple + arm.cross(force) }
}

/// Projects the changes of the wrenches on the columns: rows of the subtree and of the joints above. With
/// `dynamics` the subtree itself has moved, which turns or shifts what it hands up.
fn collect(
    tree: &Tree,
    kinematics: &Kinematics,
    mass: &MassMatrix,
    (dof, top): (usize, usize),
    (wrench, dynamics): (&[Wrench], Option<&NewtonEuler>),
    out: &mut Paired,
) {
    let column = kinematics.columns[dof];
    let carried = dynamics.map_or_else(Wrench::default, |dynamics| dynamics.wrenches[top]);
    let handed = Wrench {
        force: wrench[top].force + column.angular.cross(carried.force),
        moment: wrench[top].moment
            + column.angular.cross(carried.moment)
            + column.linear.cross(carried.force),
    };
    for &index in &tree.subtree[top] {
        let body = &tree.bodies[index];
        for row in body.first_velocity..body.first_velocity + body.joint.velocities() {
            let own = &kinematics.columns[row];
            let force = if index == top { handed.force } else { wrench[index].force };
            let value = own.angular.dot(wrench[index].moment) + own.linear.dot(force);
            if row >= dof {
                out.lower[mass.slot(row, dof)] = value;
            } else {
                out.upper[mass.slot(dof, row)] = value;
            }
        }
    }
    let origin = kinematics.pose[top].position;
    for slot in mass.row_start[dof]..mass.row_start[dof + 1] {
        let row = mass.columns[slot];
        if tree.owner[row] != top {
            let above = &kinematics.columns[row];
            let linear = kinematics.point_column(tree, row, origin);
            out.upper[slot] = above.angular.dot(handed.moment) + linear.dot(handed.force);
        }
    }
}
