//! Three translations without rotation: a node of a rope, a mass point.

use glam::DVec3;

use super::joint::{Column, JointModel, Motion};
use super::pose::Pose;

/// A point; its coordinates are its position in the joint frame [m].
#[derive(Debug, Clone)]
pub struct Point;

impl JointModel for Point {
    const POSITIONS: usize = 3;
    const MOTIONS: &'static [Motion] = &[Motion::Shift; 3];

    fn place(&self, pose: &mut Pose, q: &[f64], columns: &mut [Column]) {
        for (k, column) in columns.iter_mut().enumerate() {
            *column = Column::shift(pose.rotation.col(k));
        }
        pose.position = pose.point(DVec3::from_slice(q));
    }

    fn advance(&self, q: &mut [f64], increment: &[f64]) {
        for (value, change) in q.iter_mut().zip(increment) {
            *value += change;
        }
    }
}
