//! No motion.

use super::joint::{Column, JointModel, Motion};
use super::pose::Pose;

/// A rigid connection.
#[derive(Debug, Clone)]
pub struct Fixed;

impl JointModel for Fixed {
    const POSITIONS: usize = 0;
    const MOTIONS: &'static [Motion] = &[];

    fn place(&self, _pose: &mut Pose, _q: &[f64], _columns: &mut [Column]) {}

    fn advance(&self, _q: &mut [f64], _increment: &[f64]) {}
}
