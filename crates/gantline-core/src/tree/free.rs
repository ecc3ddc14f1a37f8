//! Six degrees of freedom: translation in the joint frame's axes, rotation in body axes.

use glam::DVec3;

use super::ball::{quaternion, rotate};
use super::joint::{Column, JointModel, Motion};
use super::pose::Pose;

/// A free body; q holds position [m] and unit quaternion (w first), both in the joint frame.
#[derive(Debug, Clone)]
pub struct Free;

impl JointModel for Free {
    const POSITIONS: usize = 7;
    const MOTIONS: &'static [Motion] =
        &[Motion::Shift, Motion::Shift, Motion::Shift, Motion::Turn, Motion::Turn, Motion::Turn];

    fn place(&self, pose: &mut Pose, q: &[f64], columns: &mut [Column]) {
        let joint = *pose;
        *pose = joint.compose(&Pose::new(quaternion(&q[3..7]), DVec3::from_slice(q)));
        for k in 0..3 {
            columns[k] = Column::shift(joint.rotation.col(k));
            columns[3 + k] = Column::turn(pose.rotation.col(k));
        }
    }

    fn advance(&self, q: &mut [f64], increment: &[f64]) {
        for k in 0..3 {
            q[k] += increment[k];
        }
        rotate(&mut q[3..7], &increment[3..6]);
    }
}
