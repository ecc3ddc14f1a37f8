//! Translation along an axis that is fixed in the parent.

use glam::DVec3;

use super::joint::{Column, JointModel, Motion};
use super::pose::Pose;

/// A slider; its coordinate is the distance along the axis [m].
#[derive(Debug, Clone)]
pub struct Slider {
    /// Unit axis in the joint frame.
    pub axis: DVec3,
}

impl JointModel for Slider {
    const POSITIONS: usize = 1;
    const MOTIONS: &'static [Motion] = &[Motion::Shift];

    #[inline]
    fn place(&self, pose: &mut Pose, q: &[f64], columns: &mut [Column]) {
        let axis = pose.rotation * self.axis;
        columns[0] = Column::shift(axis);
        pose.position += axis * q[0];
    }

    fn advance(&self, q: &mut [f64], increment: &[f64]) {
        q[0] += increment[0];
    }
}
