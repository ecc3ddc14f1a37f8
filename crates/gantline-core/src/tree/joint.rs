//! The closed set of joints. Each type is one file that implements [`JointModel`].
//!
//! Velocity coordinates: one *column* per degree of freedom, the angular velocity and the velocity of
//! the body's origin that one unit of it gives. Linear parts are fixed in the parent's axes and the angular
//! parts of a joint all in the parent's or all in the body's, so one bias formula serves all types
//! ([`super::bias`]).

use glam::DVec3;

use super::ball::Ball;
use super::fixed::Fixed;
use super::flow::Flow;
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

/// Which part of a degree of freedom's column there is: loops over columns leave out the other one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Motion {
    /// Translation: no angular part.
    Shift,
    /// Rotation about the body's origin: no linear part.
    Turn,
}

/// What a joint type has to say.
pub trait JointModel {
    /// Numbers in the configuration q.
    const POSITIONS: usize;
    /// What each of the degrees of freedom is.
    const MOTIONS: &'static [Motion];

    /// Moves the pose from that of the joint frame to that of the body; sets the columns in world axes.
    fn place(&self, pose: &mut Pose, q: &[f64], columns: &mut [Column]);

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
    /// Rope that passes.
    Flow(Flow),
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
            Joint::Flow($inner) => $call,
        }
    };
}

fn sizes<J: JointModel>(_: &J) -> (usize, &'static [Motion]) {
    (J::POSITIONS, J::MOTIONS)
}

impl Column {
    /// Of a translation along `axis`.
    pub fn shift(axis: DVec3) -> Self {
        Self { angular: DVec3::ZERO, linear: axis }
    }

    /// Of a rotation about `axis`.
    pub fn turn(axis: DVec3) -> Self {
        Self { angular: axis, linear: DVec3::ZERO }
    }
}

impl Joint {
    /// Numbers in q.
    pub fn positions(&self) -> usize {
        each!(self, joint, sizes(joint).0)
    }

    /// What each of the degrees of freedom is.
    pub fn motions(&self) -> &'static [Motion] {
        each!(self, joint, sizes(joint).1)
    }

    /// See [`JointModel::place`].
    #[inline]
    pub fn place(&self, pose: &mut Pose, q: &[f64], columns: &mut [Column]) {
        each!(self, joint, joint.place(pose, q, columns));
    }

    /// See [`JointModel::advance`].
    pub fn advance(&self, q: &mut [f64], increment: &[f64]) {
        each!(self, joint, joint.advance(q, increment))
    }

    /// False for flows, which are no motion of a body.
    pub fn moves_body(&self) -> bool {
        !matches!(self, Self::Flow(_))
    }

    /// True for joints with one coordinate that a drive can prescribe and a plot can show.
    pub fn has_axis(&self) -> bool {
        matches!(self, Self::Hinge(_) | Self::Slider(_) | Self::Flow(_))
    }
}
