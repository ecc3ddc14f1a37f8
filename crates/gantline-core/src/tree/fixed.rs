//! No motion.

use glam::DMat3;

use super::joint::{Column, JointModel};
use super::pose::Pose;

/// A rigid connection.
#[derive(Debug, Clone)]
pub struct Fixed;

impl JointModel for Fixed {
    const POSITIONS: usize = 0;
    const VELOCITIES: usize = 0;

    fn pose(&self, joint: &Pose, _q: &[f64]) -> Pose {
        *joint
    }

    fn columns(&self, _joint: &DMat3, _body: &DMat3, _columns: &mut [Column]) {}

    fn advance(&self, _q: &mut [f64], _increment: &[f64]) {}
}
