//! Resistance of still water: linear by a constant matrix, quadratic along each of the body's axes.
//!
//! ```text
//! F = −B ν − (c_i |ν_i| ν_i)
//! ```
//!
//! ν holds the velocity of a point P of the body and the angular velocity, in the body's axes; forces act at P.

use glam::{DMat3, DVec3};

use super::square::Square;
use super::{At, Force, Tangent};
use crate::tree::bias::Wrench;
use crate::tree::kinematics::Twist;

/// Resistance of a body.
#[derive(Debug, Clone)]
pub struct Drag {
    /// Name.
    pub name: String,
    /// Index of the body.
    pub body: usize,
    /// P [m], body frame.
    pub at: DVec3,
    /// B about P, body axes.
    pub damping: Square,
    /// c of the three translations [N s²/m²].
    pub linear: DVec3,
    /// c of the three rotations [N m s²].
    pub angular: DVec3,
}

impl Drag {
    /// ν.
    fn motion(&self, at: &At) -> Twist {
        let turn = at.pose.rotation.transpose();
        Twist { angular: turn * at.twist.angular, linear: turn * at.twist.at(at.pose.rotation * self.at) }
    }
}

impl Force for Drag {
    fn name(&self) -> &str {
        &self.name
    }

    fn body(&self) -> usize {
        self.body
    }

    fn wrench(&self, at: &At) -> Wrench {
        let motion = self.motion(at);
        let Wrench { force, moment } = self.damping.times(&motion);
        let force = force + self.linear * motion.linear.abs() * motion.linear;
        let moment = moment + self.angular * motion.angular.abs() * motion.angular;
        let turn = at.pose.rotation;
        Wrench { force: turn * -force, moment: turn * -(moment + self.at.cross(force)) }
    }

    fn tangent(&self, at: &At) -> Tangent {
        let motion = self.motion(at);
        let mut slope = self.damping;
        slope.linear += DMat3::from_diagonal(self.linear * motion.linear.abs() * 2.0);
        slope.angular += DMat3::from_diagonal(self.angular * motion.angular.abs() * 2.0);
        let velocity = slope.about(self.at).turned(&at.pose.rotation).negated();
        Tangent { velocity, ..Tangent::NONE }
    }

    fn loss(&self, at: &At) -> f64 {
        let Wrench { force, moment } = self.wrench(at);
        -force.dot(at.twist.linear) - moment.dot(at.twist.angular)
    }
}
