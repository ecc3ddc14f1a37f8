//! Six degrees of freedom: translation in the joint frame's axes, rotation in body axes.

use glam::{DMat3, DVec3};

use super::ball::{quaternion, rotate};
use super::joint::{Column, JointModel};
use super::pose::Pose;

/// A free body; q holds position [m] and unit quaternion (w first), both in the joint frame.
#[derive(Debug, Clone)]
pub struct Free;

impl JointModel for Free {
    const POSITIONS: usize = 7;
    const VELOCITIES: usize = 6;

    fn pose(&self, joint: &Pose, q: &[f64]) -> Pose {
        joint.compose(&Pose::new(quaternion(&q[3..7]), DVec3::from_slice(q)))
    }

    fn columns(&self, joint: &DMat3, body: &DMat3, columns: &mut [Column]) {
        for k in 0..3 {
            columns[k] = Column { angular: DVec3::ZERO, linear: joint.col(k) };
            columns[3 + k] = Column { angular: body.col(k), linear: DVec3::ZERO };
        }
    }

    fn advance(&self, q: &mut [f64], increment: &[f64]) {
        for k in 0..3 {
            q[k] += increment[k];
        }
        rotate(&mut q[3..7], &increment[3..6]);
    }
}
