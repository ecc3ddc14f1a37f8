//! The closed set of joints. Each type is one file that implements [`JointModel`].
//!
//! Velocity coordinates: one *column* per degree of freedom, the angular velocity and the velocity of
//! the body's origin that one unit of it gives. Linear parts are fixed in the parent's axes and angular
//! parts in the parent's or the body's, so one bias formula serves all types ([`super::bias`]).

use glam::{DMat3, DVec3};

use super::ball::Ball;
use super::fixed::Fixed;
use super::free::Free;
use super::hinge::Hinge;
use super::point::Point;
use super::pose::Pose;
use super::slider::Slider;

/// Velocity that one unit of one degree of freedom gives to the body, world axes.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Column {
    /// Angular velocity [rad/s].
    pub angular: DVec3,
    /// Velocity of the body's origin [m/s].
    pub linear: DVec3,
}

/// What a joint type has to say.
pub trait JointModel {
    /// Numbers in the configuration q.
    const POSITIONS: usize;
    /// Degrees of freedom.
    const VELOCITIES: usize;

    /// Pose of the body, that of the joint frame given.
    fn pose(&self, joint: &Pose, q: &[f64]) -> Pose;

    /// Columns in world axes; `joint` and `body` are the world rotations of the joint frame and the body.
    fn columns(&self, joint: &DMat3, body: &DMat3, columns: &mut [Column]);

    /// q ⊕ δ: moves the configuration by an increment of the velocity coordinates.
    fn advance(&self, q: &mut [f64], increment: &[f64]);
}

/// Any joint.
#[derive(Debug, Clone)]
pub enum Joint {
    /// No motion.
    Fixed(Fixed),
    /// Rotation about an axis.
    Hinge(Hinge),
    /// Translation along an axis.
    Slider(Slider),
    /// Free rotation.
    Ball(Ball),
    /// Free translation.
    Point(Point),
    /// Free motion.
    Free(Free),
}

macro_rules! each {
    ($joint:expr, $inner:ident, $call:expr) => {
        match $joint {
            Joint::Fixed($inner) => $call,
            Joint::Hinge($inner) => $call,
            Joint::Slider($inner) => $call,
            Joint::Ball($inner) => $call,
            Joint::Point($inner) => $call,
            Joint::Free($inner) => $call,
        }
    };
}

fn sizes<J: JointModel>(_: &J) -> (usize, usize) {
    (J::POSITIONS, J::VELOCITIES)
}

impl Joint {
    /// Numbers in q.
    pub fn positions(&self) -> usize {
        each!(self, joint, sizes(joint).0)
    }

    /// Degrees of freedom.
    pub fn velocities(&self) -> usize {
        each!(self, joint, sizes(joint).1)
    }

    /// See [`JointModel::pose`].
    pub fn pose(&self, frame: &Pose, q: &[f64]) -> Pose {
        each!(self, joint, joint.pose(frame, q))
    }

    /// See [`JointModel::columns`].
    pub fn columns(&self, frame: &DMat3, body: &DMat3, columns: &mut [Column]) {
        each!(self, joint, joint.columns(frame, body, columns))
    }

    /// See [`JointModel::advance`].
    pub fn advance(&self, q: &mut [f64], increment: &[f64]) {
        each!(self, joint, joint.advance(q, increment))
    }

    /// True for joints with one coordinate that a drive can prescribe and a plot can show.
    pub fn has_axis(&self) -> bool {
        matches!(self, Self::Hinge(_) | Self::Slider(_))
    }
}
