//! Resistance of a fluid, water or air, that stands or streams: linear by a constant matrix, quadratic along the body's
//! axes.
//!
//! ```text
//! F = −B ν − (c_i |w| ν_i, c_j |ν_j| ν_j)        ν = (w, Rᵀ ω)        w = Rᵀ (v_P − u)
//! ```
//!
//! i runs over the translations, whose pressure is that of the whole speed |w|, j over the rotations.
//!
//! ν holds the velocity of a point P of the body against the fluid and the angular velocity, in the body's axes; forces
//! act at P. u is the velocity of the fluid, the same everywhere and always. It does not turn along with the body: a turn
//! δθ changes ν by Rᵀ (δθ × u), and that is all that the force knows of the body's place.
//!
//! The power F·v splits into what is lost, F·(v − u) + M·ω, never positive, and the work F·u of what drives the fluid.

use glam::{DMat3, DVec3};

use super::square::{Square, skew};
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
    /// u [m/s], world axes.
    pub stream: DVec3,
}

impl Drag {
    /// ν.
    fn motion(&self, at: &At) -> Twist {
        let turn = at.pose.rotation.transpose();
        let linear = at.twist.at(at.pose.rotation * self.at) - self.stream;
        Twist { angular: turn * at.twist.angular, linear: turn * linear }
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
        let force = force + self.linear * motion.linear.length() * motion.linear;
        let moment = moment + self.angular * motion.angular.abs() * motion.angular;
        let turn = at.pose.rotation;
        Wrench { force: turn * -force, moment: turn * -(moment + self.at.cross(force)) }
    }

    fn tangent(&self, at: &At) -> Tangent {
        let motion = self.motion(at);
        let mut slope = self.damping;
        // ∂(|w| w_i)/∂w_j = |w| δ_ij + w_i w_j/|w|.
        let (speed, along) = (motion.linear.length(), motion.linear.normalize_or_zero());
        let of_axis = |w: f64| self.linear * motion.linear * w;
        slope.linear += DMat3::from_diagonal(self.linear * speed)
            + DMat3::from_cols(of_axis(along.x), of_axis(along.y), of_axis(along.z));
        slope.angular += DMat3::from_diagonal(self.angular * motion.angular.abs() * 2.0);
        let velocity = slope.about(self.at).turned(&at.pose.rotation).negated();
        // δν = δθ × u, and the same at every point of the body.
        let turned = skew(self.stream) * -1.0;
        let cross = velocity.linear * turned;
        let place = Square { cross, angular: velocity.back * turned, ..Square::ZERO };
        Tangent { place, velocity, ..Tangent::NONE }
    }

    fn loss(&self, at: &At) -> f64 {
        let Wrench { force, moment } = self.wrench(at);
        force.dot(self.stream - at.twist.linear) - moment.dot(at.twist.angular)
    }

    fn work(&self, at: &At) -> f64 {
        if self.stream == DVec3::ZERO { 0.0 } else { self.wrench(at).force.dot(self.stream) }
    }
}
