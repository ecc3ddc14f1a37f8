//! Poses and velocity columns of all bodies at a configuration.

use std::cmp::Ordering;

use glam::DVec3;

use super::Tree;
use super::joint::Column;
use super::pose::Pose;
use crate::force;

/// Motion of a body: angular velocity and velocity of its origin, world axes.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Twist {
    /// Angular velocity [rad/s].
    pub angular: DVec3,
    /// Velocity of the body's origin [m/s].
    pub linear: DVec3,
}

impl Twist {
    /// Velocity [m/s] at the arm [m] from the origin.
    #[inline]
    pub fn at(&self, arm: DVec3) -> DVec3 {
        self.linear + self.angular.cross(arm)
    }
}

/// Poses, columns and velocities of the tree at one state. Reused from step to step.
#[derive(Debug, Clone)]
pub struct Kinematics {
    /// World pose of every body.
    pub pose: Vec<Pose>,
    /// World position of every body's centre of gravity [m].
    pub centre_of_gravity: Vec<DVec3>,
    /// From the origin of its parent to that of every body [m]; zero for those on the world.
    pub arm: Vec<DVec3>,
    /// From every body's origin to its centre of gravity [m].
    pub lever: Vec<DVec3>,
    /// Column of every degree of freedom.
    pub columns: Vec<Column>,
    /// The configuration that all this is at.
    pub q: Vec<f64>,
    /// The time that it is at [s], which forces of waves depend on.
    pub time: f64,
    /// What forces remember of the motion so far, see [`crate::force::memory`] and [`crate::force::slow`]; nothing in statics,
    /// where nothing has moved yet.
    pub past: Vec<f64>,
}

impl Kinematics {
    /// Room for `tree`.
    pub fn new(tree: &Tree) -> Self {
        Self {
            // Those that do not move stay there.
            pose: tree.bodies.iter().map(|body| body.placement).collect(),
            centre_of_gravity: tree.bodies.iter().map(|body| body.placement.position).collect(),
            arm: vec![DVec3::ZERO; tree.bodies.len()],
            lever: vec![DVec3::ZERO; tree.bodies.len()],
            columns: vec![Column::default(); tree.velocities],
            q: vec![0.0; tree.positions],
            time: 0.0,
            past: vec![0.0; force::states(tree)],
        }
    }

    /// Takes over what `other` has of the same tree.
    pub fn copy_from(&mut self, other: &Self) {
        self.pose.copy_from_slice(&other.pose);
        self.centre_of_gravity.copy_from_slice(&other.centre_of_gravity);
        self.arm.copy_from_slice(&other.arm);
        self.lever.copy_from_slice(&other.lever);
        self.columns.copy_from_slice(&other.columns);
        self.q.copy_from_slice(&other.q);
        self.time = other.time;
        self.past.copy_from_slice(&other.past);
    }

    /// Evaluates everything at the configuration `q` and the time `time` [s].
    pub fn update(&mut self, tree: &Tree, q: &[f64], time: f64) {
        self.time = time;
        self.q.clear();
        self.q.extend_from_slice(q);
        for &index in &tree.moving {
            let body = &tree.bodies[index];
            let (above, below) = self.pose.split_at_mut(index);
            let pose = &mut below[0];
            match body.parent {
                None => *pose = body.placement,
                Some(parent) if body.is_turned => *pose = above[parent].compose(&body.placement),
                Some(parent) => *pose = above[parent].shifted(body.placement.position),
            }
            body.joint.place(pose, &q[body.first_position..], &mut self.columns[body.dofs()]);
            if let Some(parent) = body.parent {
                self.arm[index] = pose.position - above[parent].position;
            }
            if !tree.is_point[index] {
                self.lever[index] = pose.rotation * body.centre_of_gravity;
            }
            self.centre_of_gravity[index] = pose.position + self.lever[index];
        }
    }

    /// World position [m] of a point given in a body's frame, or in the world's.
    #[inline]
    pub fn point(&self, body: Option<usize>, local: DVec3) -> DVec3 {
        body.map_or(local, |body| self.pose[body].point(local))
    }

    /// Frame of a body, or of the world.
    pub fn pose_of(&self, body: Option<usize>) -> &Pose {
        body.map_or(&Pose::IDENTITY, |body| &self.pose[body])
    }

    /// World direction of a vector given in a body's axes, or in the world's.
    pub fn turn(&self, body: Option<usize>, local: DVec3) -> DVec3 {
        body.map_or(local, |body| self.pose[body].rotation * local)
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
        for &index in &tree.moving {
            let body = &tree.bodies[index];
            let mut twist = body.parent.map_or_else(Twist::default, |parent| {
                let above = twists[parent];
                Twist { angular: above.angular, linear: above.linear + above.angular.cross(self.arm[index]) }
            });
            let dofs = body.dofs();
            for (column, v) in self.columns[dofs.clone()].iter().zip(&v[dofs]) {
                twist.angular += column.angular * *v;
                twist.linear += column.linear * *v;
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
