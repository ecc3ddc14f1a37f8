//! Poses and velocity columns of all bodies at a configuration.

use std::cmp::Ordering;

use glam::DVec3;

use super::Tree;
use super::joint::Column;
use super::pose::Pose;

/// Motion of a body: angular velocity and velocity of its origin, world axes.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Twist {
    /// Angular velocity [rad/s].
    pub angular: DVec3,
    /// Velocity of the body's origin [m/s].
    pub linear: DVec3,
}

/// Poses, columns and velocities of the tree at one state. Reused from step to step.
#[derive(Debug, Clone)]
pub struct Kinematics {
    /// World pose of every body.
    pub pose: Vec<Pose>,
    /// World position of every body's centre of gravity [m].
    pub centre_of_gravity: Vec<DVec3>,
    /// Column of every degree of freedom.
    pub columns: Vec<Column>,
}

impl Kinematics {
    /// Room for `tree`.
    pub fn new(tree: &Tree) -> Self {
        Self {
            pose: vec![Pose::IDENTITY; tree.bodies.len()],
            centre_of_gravity: vec![DVec3::ZERO; tree.bodies.len()],
            columns: vec![Column::default(); tree.velocities],
        }
    }

    /// Evaluates everything at the configuration `q`.
    pub fn update(&mut self, tree: &Tree, q: &[f64]) {
        for (index, body) in tree.bodies.iter().enumerate() {
            let joint = match (body.parent, body.is_turned) {
                (None, _) => body.placement,
                (Some(parent), true) => self.pose[parent].compose(&body.placement),
                (Some(parent), false) => self.pose[parent].shifted(body.placement.position),
            };
            let pose = body.joint.pose(&joint, &q[body.first_position..]);
            let own = body.first_velocity..body.first_velocity + body.joint.velocities();
            body.joint.columns(&joint.rotation, &pose.rotation, &mut self.columns[own]);
            self.centre_of_gravity[index] = pose.point(body.centre_of_gravity);
            self.pose[index] = pose;
        }
    }

    /// World position [m] of a point given in a body's frame, or in the world's.
    pub fn point(&self, body: Option<usize>, local: DVec3) -> DVec3 {
        body.map_or(local, |body| self.pose[body].point(local))
    }

    /// Velocity that degree of freedom `dof` gives to a world point [m] of a body that it moves.
    pub fn point_column(&self, tree: &Tree, dof: usize, point: DVec3) -> DVec3 {
        let column = &self.columns[dof];
        column.linear + column.angular.cross(point - self.pose[tree.owner[dof]].position)
    }

    /// Change of the column of `row` at a world point [m] when `dof` moves; both move the point's body. Both are
    /// given with their columns at the point.
    ///
    /// A degree of freedom above the column's joint turns the column, one below it moves the point. Within a
    /// joint the columns of rotations are fixed in the body and turn with it.
    pub fn column_change(
        &self,
        tree: &Tree,
        (row, row_column): (usize, DVec3),
        (dof, dof_column): (usize, DVec3),
        point: DVec3,
    ) -> DVec3 {
        let (row_owner, dof_owner) = (tree.owner[row], tree.owner[dof]);
        match dof_owner.cmp(&row_owner) {
            Ordering::Less => self.columns[dof].angular.cross(row_column),
            Ordering::Equal => {
                let arm = point - self.pose[row_owner].position;
                self.columns[dof].angular.cross(self.columns[row].angular.cross(arm))
            }
            Ordering::Greater => self.columns[row].angular.cross(dof_column),
        }
    }

    /// Velocities of all bodies under the velocity coordinates `v`.
    pub fn twists(&self, tree: &Tree, v: &[f64], twists: &mut [Twist]) {
        for (index, body) in tree.bodies.iter().enumerate() {
            let mut twist = body.parent.map_or_else(Twist::default, |parent| {
                let arm = self.pose[index].position - self.pose[parent].position;
                let above = twists[parent];
                Twist { angular: above.angular, linear: above.linear + above.angular.cross(arm) }
            });
            for k in 0..body.joint.velocities() {
                let dof = body.first_velocity + k;
                twist.angular += self.columns[dof].angular * v[dof];
                twist.linear += self.columns[dof].linear * v[dof];
            }
            twists[index] = twist;
        }
    }

    /// Velocity [m/s] of a world point [m] of a body, or of the world.
    pub fn point_velocity(&self, twists: &[Twist], body: Option<usize>, point: DVec3) -> DVec3 {
        body.map_or(DVec3::ZERO, |body| {
            let twist = &twists[body];
            twist.linear + twist.angular.cross(point - self.pose[body].position)
        })
    }
}
