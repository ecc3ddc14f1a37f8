//! Derivatives of inverse dynamics τ = M(q) v̇ + c(q, v) − f_gravity over coordinates and velocities.
//!
//! An increment of an angular degree of freedom k turns everything below it as one rigid whole, by a_k about
//! the joint's origin. Seen from there, the velocities and accelerations that come from above have changed by
//! −a_k × (·), and nothing else; the change runs down the tree by the same recursion as the motion itself
//! ([`super::bias`]), and the forces run up again. An increment of a linear degree of freedom moves the whole
//! without turning it. One sweep over the subtree of each degree of freedom gives its column, so the cost is
//! the number of pairs in the tree. Where what comes from above neither turns nor is turned faster, the subtree is
//! accelerated as one, and the composites of the mass matrix know what that takes; where nothing moves at all, τ is of
//! second order in the velocities. Increments are those of [`super::Tree::advance`]: rotation vectors in body
//! axes for ball and free joints, which makes the derivative unsymmetric.

use glam::{DMat3, DVec3};

use super::Tree;
use super::bias::{NewtonEuler, Wrench};
use super::joint::Motion;
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
    /// Inertia of every body about its centre of gravity, world axes; not set for those that are points.
    inertia: Vec<DMat3>,
    /// Change of every body's angular velocity in the subtree of a sweep.
    spin: Vec<DVec3>,
    /// Change of every body's acceleration.
    rate: Vec<Twist>,
    wrench: Vec<Wrench>,
}

/// Where and how the tree moves.
#[derive(Clone, Copy)]
pub(super) struct Place<'a> {
    pub tree: &'a Tree,
    pub kinematics: &'a Kinematics,
    pub mass: &'a MassMatrix,
    pub dynamics: &'a NewtonEuler,
    pub v: &'a [f64],
}

/// What starts a sweep: change of the motion of the topmost body, seen from the moved subtree.
pub(super) struct Seed {
    /// Change of the angular velocity.
    pub spin: DVec3,
    /// Change of the acceleration, with that of gravity taken off.
    pub rate: Twist,
}

impl DynamicsTangent {
    /// Room for `tree` with the pattern of `mass`.
    pub fn new(tree: &Tree, mass: &MassMatrix) -> Self {
        let zeros = || Paired { lower: vec![0.0; mass.values.len()], upper: vec![0.0; mass.values.len()] };
        Self {
            position: zeros(),
            velocity: zeros(),
            inertia: vec![DMat3::ZERO; tree.bodies.len()],
            spin: vec![DVec3::ZERO; tree.bodies.len()],
            rate: vec![Twist::default(); tree.bodies.len()],
            wrench: vec![Wrench::default(); tree.bodies.len()],
        }
    }

    /// Evaluates both derivatives at the motion of the last update of `dynamics`, in which no applied forces
    /// were given; `mass` has been updated there.
    pub fn update(
        &mut self,
        tree: &Tree,
        kinematics: &Kinematics,
        mass: &MassMatrix,
        dynamics: &NewtonEuler,
        v: &[f64],
    ) {
        let place = Place { tree, kinematics, mass, dynamics, v };
        let motion = dynamics.twists.iter().chain(&dynamics.accelerations);
        let is_still = motion.into_iter().all(|part| *part == Twist::default());
        if is_still {
            self.velocity.lower.fill(0.0);
            self.velocity.upper.fill(0.0);
        } else {
            for (index, body) in tree.bodies.iter().enumerate().filter(|(index, _)| !tree.is_point[*index]) {
                let rotation = kinematics.pose[index].rotation;
                self.inertia[index] = rotation * body.inertia * rotation.transpose();
            }
        }
        for dof in tree.moving.iter().flat_map(|&index| tree.bodies[index].dofs()) {
            let [position, velocity] = place.seeds(dof);
            self.sweep(&place, dof, &position);
            collect(&place, dof, &self.wrench, Some(dynamics), &mut self.position);
            if !is_still {
                self.sweep(&place, dof, &velocity);
                collect(&place, dof, &self.wrench, None, &mut self.velocity);
            }
        }
        for force in &tree.forces {
            self.add_force(&place, force);
        }
    }

    /// Change of the angular velocity and of the acceleration, with that of gravity taken off, of a body below the
    /// degree of freedom that `seed` changes, seen from the body.
    pub(super) fn carried(
        &mut self,
        place: &Place,
        (top, body): (usize, usize),
        seed: &Seed,
    ) -> (DVec3, Twist) {
        if body == top {
            (self.spin[body], self.rate[body]) = (seed.spin, seed.rate);
        } else {
            self.carried(place, (top, place.tree.bodies[body].parent.unwrap_or(top)), seed);
            self.pass_on(place, body);
        }
        (self.spin[body], self.rate[body])
    }

    /// Changes of all wrenches in the subtree of a degree of freedom, seen from the moved subtree.
    fn sweep(&mut self, place: &Place, dof: usize, seed: &Seed) {
        let top = place.tree.owner[dof];
        if seed.spin == DVec3::ZERO && seed.rate.angular == DVec3::ZERO {
            for &index in &place.tree.subtree[top] {
                self.wrench[index] = place.mass.accelerated(index, seed.rate.linear);
            }
        } else {
            self.sweep_turn(place, top, seed);
        }
    }

    fn sweep_turn(&mut self, place: &Place, top: usize, seed: &Seed) {
        let Place { tree, kinematics, dynamics, .. } = *place;
        self.spin[top] = seed.spin;
        self.rate[top] = seed.rate;
        for &index in &tree.subtree[top] {
            if index != top {
                self.pass_on(place, index);
            }
            let (change, rate) = (self.spin[index], &self.rate[index]);
            self.wrench[index] = if tree.is_point[index] {
                Wrench { force: rate.linear * tree.bodies[index].mass, moment: DVec3::ZERO }
            } else {
                let (spin, lever) = (dynamics.twists[index].angular, kinematics.lever[index]);
                wrench_change(tree.bodies[index].mass, lever, &self.inertia[index], spin, change, rate)
            };
        }
        for &index in tree.subtree[top][1..].iter().rev() {
            let parent = tree.bodies[index].parent.unwrap_or(top);
            let wrench = self.wrench[index];
            let above = &mut self.wrench[parent];
            above.force += wrench.force;
            above.moment += wrench.moment + kinematics.arm[index].cross(wrench.force);
        }
    }

    /// Change of a body's motion from that of its parent: the recursion of [`super::bias`], linearised.
    fn pass_on(&mut self, place: &Place, index: usize) {
        let body = &place.tree.bodies[index];
        let parent = body.parent.unwrap_or(index);
        let arm = place.kinematics.arm[index];
        let (change, spin) = (self.spin[parent], place.dynamics.twists[parent].angular);
        let Twist { mut angular, mut linear } = self.rate[parent];
        linear += angular.cross(arm) + change.cross(spin.cross(arm)) + spin.cross(change.cross(arm));
        for (dof, motion) in body.dofs().zip(body.joint.motions()) {
            let column = &place.kinematics.columns[dof];
            match motion {
                Motion::Shift => linear += change.cross(column.linear) * (2.0 * place.v[dof]),
                Motion::Turn => angular += change.cross(column.angular) * place.v[dof],
            }
        }
        self.spin[index] = change;
        self.rate[index] = Twist { angular, linear };
    }
}

impl Place<'_> {
    /// Seeds of the derivatives over the position and the velocity of a degree of freedom.
    pub(super) fn seeds(&self, dof: usize) -> [Seed; 2] {
        let Place { tree, kinematics, dynamics, .. } = *self;
        let body = tree.owner[dof];
        let column = &kinematics.columns[dof];
        let (above, above_rate) = parent_motion(tree, dynamics, body);
        match tree.motions[dof] {
            Motion::Shift => {
                let swing = above.angular.cross(column.linear);
                let moved = above_rate.angular.cross(column.linear) + above.angular.cross(swing);
                [moved, swing * 2.0]
                    .map(|linear| Seed { spin: DVec3::ZERO, rate: Twist { angular: DVec3::ZERO, linear } })
            }
            Motion::Turn => {
                let turned = -column.angular.cross(above.angular);
                let joint_spin = dynamics.twists[body].angular - above.angular;
                let angular = turned.cross(joint_spin) - column.angular.cross(above_rate.angular);
                let linear = column.angular.cross(tree.gravity - dynamics.accelerations[body].linear);
                let swing = Twist { angular: above.angular.cross(column.angular), linear: DVec3::ZERO };
                [
                    Seed { spin: turned, rate: Twist { angular, linear } },
                    Seed { spin: column.angular, rate: swing },
                ]
            }
        }
    }
}

fn parent_motion(tree: &Tree, dynamics: &NewtonEuler, body: usize) -> (Twist, Twist) {
    match tree.bodies[body].parent {
        Some(parent) => (dynamics.twists[parent], dynamics.accelerations[parent]),
        None => (Twist::default(), Twist::default()),
    }
}

fn wrench_change(
    mass: f64,
    lever: DVec3,
    inertia: &DMat3,
    spin: DVec3,
    change: DVec3,
    rate: &Twist,
) -> Wrench {
    let centre = rate.linear
        + rate.angular.cross(lever)
        + change.cross(spin.cross(lever))
        + spin.cross(change.cross(lever));
    let force = centre * mass;
    let couple = *inertia * rate.angular + change.cross(*inertia * spin) + spin.cross(*inertia * change);
    Wrench { force, moment: couple + lever.cross(force) }
}

/// Projects the changes of the wrenches on the columns: rows of the subtree and of the joints above. With
/// `moved` the subtree itself has moved, which turns or shifts what it hands up.
fn collect(place: &Place, dof: usize, wrench: &[Wrench], moved: Option<&NewtonEuler>, out: &mut Paired) {
    let Place { tree, kinematics, mass, .. } = *place;
    let top = tree.owner[dof];
    let column = kinematics.columns[dof];
    let carried = moved.map_or_else(Wrench::default, |dynamics| dynamics.wrenches[top]);
    let handed = Wrench {
        force: wrench[top].force + column.angular.cross(carried.force),
        moment: wrench[top].moment
            + column.angular.cross(carried.moment)
            + column.linear.cross(carried.force),
    };
    for &index in &tree.subtree[top] {
        let body = &tree.bodies[index];
        let force = if index == top { handed.force } else { wrench[index].force };
        for (row, motion) in body.dofs().zip(body.joint.motions()) {
            let own = &kinematics.columns[row];
            let value = match motion {
                Motion::Shift => own.linear.dot(force),
                Motion::Turn => own.angular.dot(wrench[index].moment),
            };
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
