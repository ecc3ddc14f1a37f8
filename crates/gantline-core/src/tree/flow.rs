//! Rope that passes a sheave or leaves a drum: a number, moved by nothing but the rope.
//!
//! Its joint moves no body; its inertia, that of what turns over the square of its radius, stands in
//! [`super::Tree::armature`].

use glam::DVec3;

use super::joint::{Column, JointModel, Motion};
use super::pose::Pose;

/// A flow; its coordinate is the length of rope that has passed [m].
#[derive(Debug, Clone)]
pub struct Flow;

impl JointModel for Flow {
    const POSITIONS: usize = 1;
    const MOTIONS: &'static [Motion] = &[Motion::Shift];

    fn place(&self, _pose: &mut Pose, _q: &[f64], columns: &mut [Column]) {
        columns[0] = Column::shift(DVec3::ZERO);
    }

    fn advance(&self, q: &mut [f64], increment: &[f64]) {
        q[0] += increment[0];
    }
}
