//! Axes along which water pushes a body at a point P of it: the body's own, or, where waves push it, level ones that turn with
//! its slow heading, as the forces of these do.

use glam::{DMat3, DVec3};

use super::slow::Slowly;
use crate::tree::kinematics::Twist;
use crate::tree::pose::Pose;

/// The axes, with P.
pub struct Axes {
    /// From them to world axes.
    pub turn: DMat3,
    /// P from the body's origin, world axes [m].
    pub arm: DVec3,
    /// How fast level ones turn [rad/s]; none of the body's own.
    pub turning: Option<f64>,
}

impl Axes {
    /// Those of a body at `pose`, P being `at` [m] in its frame; level ones where it heads slowly somewhere.
    pub fn new(pose: &Pose, at: DVec3, slowly: Option<Slowly>) -> Self {
        let turn = slowly.map_or(pose.rotation, |slowly| DMat3::from_rotation_z(slowly.heading[0]));
        Self { turn, arm: pose.rotation * at, turning: slowly.map(|slowly| slowly.heading[1]) }
    }

    /// Velocity of P and angular velocity, along the axes.
    pub fn motion(&self, twist: &Twist) -> [f64; 6] {
        self.along(&Twist { linear: twist.at(self.arm), ..*twist })
    }

    /// A motion at P along the axes.
    pub fn along(&self, motion: &Twist) -> [f64; 6] {
        let back = self.turn.transpose();
        let (linear, angular) = (back * motion.linear, back * motion.angular);
        [linear.x, linear.y, linear.z, angular.x, angular.y, angular.z]
    }
}
