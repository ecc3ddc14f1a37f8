//! Three translations without rotation: a node of a rope, a mass point.

use glam::{DMat3, DVec3};

use super::joint::{Column, JointModel};
use super::pose::Pose;

/// A point; its coordinates are its position in the joint frame [m].
#[derive(Debug, Clone)]
pub struct Point;

impl JointModel for Point {
    const POSITIONS: usize = 3;
    const VELOCITIES: usize = 3;

    fn pose(&self, joint: &Pose, q: &[f64]) -> Pose {
        joint.shifted(DVec3::from_slice(q))
    }

    fn columns(&self, joint: &DMat3, _body: &DMat3, columns: &mut [Column]) {
        for (k, column) in columns.iter_mut().enumerate() {
            *column = Column { angular: DVec3::ZERO, linear: joint.col(k) };
        }
    }

    fn advance(&self, q: &mut [f64], increment: &[f64]) {
        for (value, change) in q.iter_mut().zip(increment) {
            *value += change;
        }
    }
}
