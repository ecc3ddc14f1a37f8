//! Bodies in a tree and their joints: kinematics, mass matrix, bias forces.

pub mod applied;
pub mod ball;
pub mod bias;
pub mod drift;
pub mod factor;
pub mod fixed;
pub mod flow;
pub mod free;
pub mod hinge;
pub mod joint;
pub mod kinematics;
pub mod mass;
pub mod point;
pub mod pose;
pub mod slider;
pub mod tangent;

use std::ops::Range;

use glam::{DMat3, DVec3};

use crate::force::AnyForce;
use crate::force::buoyancy::Buoyancy;
use joint::{Joint, Motion};
use pose::Pose;

/// A rigid body and the joint by which it hangs on its parent.
#[derive(Debug, Clone)]
pub struct Body {
    /// Unique name.
    pub name: String,
    /// Index of the parent; none is the world.
    pub parent: Option<usize>,
    /// Where the joint sits in the parent's frame.
    pub placement: Pose,
    /// True where that has other axes than the parent's frame.
    pub is_turned: bool,
    /// The joint.
    pub joint: Joint,
    /// Mass [kg].
    pub mass: f64,
    /// Centre of gravity [m], body frame.
    pub centre_of_gravity: DVec3,
    /// Inertia about the centre of gravity [kg m²], body axes.
    pub inertia: DMat3,
    /// First number of its joint in q.
    pub first_position: usize,
    /// First number of its joint in v.
    pub first_velocity: usize,
    /// How many it has there.
    pub velocities: usize,
}

impl Body {
    /// Numbers of its joint in v.
    pub fn dofs(&self) -> Range<usize> {
        self.first_velocity..self.first_velocity + self.velocities
    }
}

/// The tree: bodies in an order in which parents stand before children.
#[derive(Debug, Clone)]
pub struct Tree {
    /// The bodies.
    pub bodies: Vec<Body>,
    /// Acceleration of gravity [m/s²], world axes.
    pub gravity: DVec3,
    /// Length of q, with the supplies of drums and the marks at its end.
    pub positions: usize,
    /// How many of these are supplies: coordinates that no joint has, each with an increment after those of the joints.
    pub supplies: usize,
    /// How many are marks, the last ones: 0 for a mooring line that holds, 1 for one that has parted.
    pub marks: usize,
    /// Length of v.
    pub velocities: usize,
    /// What every degree of freedom is.
    pub motions: Vec<Motion>,
    /// True for bodies whose mass is all at their origin, without inertia: nothing about them turns.
    pub is_point: Vec<bool>,
    /// All bodies but those that are no more than the name of a flow: without mass, at rest on the world, nothing on them.
    pub moving: Vec<usize>,
    /// For every degree of freedom the body whose joint has it.
    pub owner: Vec<usize>,
    /// For every body the degrees of freedom that move it, ascending.
    pub support: Vec<Vec<usize>>,
    /// For every body itself and the bodies that hang on it, parents first.
    pub subtree: Vec<Vec<usize>>,
    /// Viscous damping of every degree of freedom [N s/m or N m s/rad].
    pub damping: Vec<f64>,
    /// Inertia of every degree of freedom itself, beside that of the bodies that it moves [kg].
    pub armature: Vec<f64>,
    /// Forces on single bodies that follow from place and motion.
    pub forces: Vec<AnyForce>,
    /// A typical inertia of every degree of freedom [kg or kg m²], to turn errors into forces.
    pub inertia_scale: Vec<f64>,
}

impl Tree {
    /// A tree of `bodies` (parents first, offsets not yet set) in the field `gravity` [m/s²].
    pub fn new(mut bodies: Vec<Body>, gravity: DVec3) -> Self {
        let (mut positions, mut velocities) = (0, 0);
        let (mut owner, mut motions, mut is_point) = (Vec::new(), Vec::new(), Vec::new());
        let mut support: Vec<Vec<usize>> = Vec::with_capacity(bodies.len());
        for (index, body) in bodies.iter_mut().enumerate() {
            body.first_position = positions;
            body.first_velocity = velocities;
            body.velocities = body.joint.motions().len();
            positions += body.joint.positions();
            let own = body.dofs();
            velocities = own.end;
            motions.extend_from_slice(body.joint.motions());
            is_point.push(body.centre_of_gravity == DVec3::ZERO && body.inertia == DMat3::ZERO);
            owner.extend(own.clone().map(|_| index));
            let mut dofs = body.parent.map_or_else(Vec::new, |parent| support[parent].clone());
            dofs.extend(own);
            support.push(dofs);
        }
        let mut subtree: Vec<Vec<usize>> = vec![Vec::new(); bodies.len()];
        for index in 0..bodies.len() {
            let mut above = Some(index);
            while let Some(body) = above {
                subtree[body].push(index);
                above = bodies[body].parent;
            }
        }
        let is_moving = |&index: &usize| {
            let body: &Body = &bodies[index];
            let is_bare = body.parent.is_none() && body.mass == 0.0 && is_point[index];
            body.joint.moves_body() || !is_bare || subtree[index].len() > 1
        };
        let moving = (0..bodies.len()).filter(is_moving).collect();
        let damping = vec![0.0; velocities];
        let (armature, inertia_scale) = (vec![0.0; velocities], vec![1.0; velocities]);
        Self {
            bodies,
            gravity,
            positions,
            supplies: 0,
            marks: 0,
            velocities,
            motions,
            is_point,
            moving,
            owner,
            support,
            subtree,
            damping,
            armature,
            forces: Vec::new(),
            inertia_scale,
        }
    }

    /// Degrees of freedom that move the point's body; none for the world.
    pub fn support_of(&self, body: Option<usize>) -> &[usize] {
        body.map_or(&[], |body| &self.support[body])
    }

    /// Hulls in water.
    pub fn hulls(&self) -> impl Iterator<Item = &Buoyancy> {
        self.forces.iter().filter_map(|force| match force {
            AnyForce::Buoyancy(buoyancy) => Some(&**buoyancy),
            _ => None,
        })
    }

    /// Length of an increment of q.
    pub fn increments(&self) -> usize {
        self.velocities + self.supplies
    }

    /// q ⊕ h v for the whole tree; without increments of the supplies these stay, and marks do.
    pub fn advance(&self, q: &mut [f64], increment: &[f64]) {
        for body in &self.bodies {
            let positions = body.first_position..body.first_position + body.joint.positions();
            body.joint.advance(&mut q[positions], &increment[body.dofs()]);
        }
        let first = self.positions - self.marks - self.supplies;
        for (q, increment) in q[first..].iter_mut().zip(&increment[self.velocities..]) {
            *q += increment;
        }
    }
}
