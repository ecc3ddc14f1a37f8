//! Resistance of a fluid, water or air, that stands or streams, in gusts if it is wind: linear by a constant matrix,
//! quadratic along the body's axes.
//!
//! ```text
//! F = −B ν − (c_i |w| ν_i, c_j |ν_j| ν_j)        ν = (w, Rᵀ ω)        w = Rᵀ (v_P − u)
//! ```
//!
//! i runs over the translations, whose pressure is that of the whole speed |w|, j over the rotations.
//!
//! ν holds the velocity of a point P of the body against the fluid and the angular velocity, in the body's axes; forces
//! act at P. u is the velocity of the fluid. It does not turn along with the body: a turn δθ changes ν by Rᵀ (δθ × u). In
//! a steady stream that is all that the force knows of the body's place. Wind grows with height by s(z) of a [`Profile`], and
//! in gusts has η, of [`Trains`], on top, another at another place and time: u = (s + η/U) U, U the mean where s is 1.
//!
//! The power F·v splits into what is lost, F·(v − u) + M·ω, never positive, and the work F·u of what drives the fluid.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::profile::Profile;
use super::square::{Square, skew};
use super::trains::{Passing, Trains};
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
    /// U [m/s], world axes.
    pub stream: DVec3,
    /// s; 1 at any height if none.
    pub profile: Option<Profile>,
    /// η [m/s] along the stream.
    pub gusts: Option<Arc<Trains>>,
}

impl Drag {
    /// ν.
    fn motion(&self, at: &At) -> Twist {
        let turn = at.pose.rotation.transpose();
        let linear = at.twist.at(at.pose.rotation * self.at) - self.fluid(at);
        Twist { angular: turn * at.twist.angular, linear: turn * linear }
    }

    /// η, and the direction that it has.
    fn gust(&self, at: &At) -> Option<(DVec3, Passing)> {
        let gusts = self.gusts.as_ref()?;
        let passing = gusts.passing(at.pose.point(self.at).truncate(), at.time);
        Some((self.stream.normalize_or_zero(), passing))
    }

    /// s at P, and its slope [1/m].
    fn share(&self, at: &At) -> (f64, f64) {
        self.profile.map_or((1.0, 0.0), |profile| profile.share(at.pose.point(self.at).z))
    }

    /// u.
    fn fluid(&self, at: &At) -> DVec3 {
        let mean = self.stream * self.share(at).0;
        self.gust(at).map_or(mean, |(along, gust)| mean + along * gust.value)
    }

    /// Derivative of u over the place of P, by columns; none where it is the same everywhere.
    fn spread(&self, at: &At) -> Option<DMat3> {
        if self.profile.is_none() && self.gusts.is_none() {
            return None;
        }
        let upwards = self.stream * self.share(at).1;
        let aside = self.gust(at).map(|(along, gust)| gust.gradient.to_array().map(|slope| along * slope));
        let [x, y] = aside.unwrap_or([DVec3::ZERO; 2]);
        Some(DMat3::from_cols(x, y, upwards))
    }

    /// Derivatives of the wrench over the velocity of the body.
    fn slope(&self, at: &At) -> Square {
        let motion = self.motion(at);
        let mut slope = self.damping;
        // ∂(|w| w_i)/∂w_j = |w| δ_ij + w_i w_j/|w|.
        let (speed, along) = (motion.linear.length(), motion.linear.normalize_or_zero());
        let of_axis = |w: f64| self.linear * motion.linear * w;
        slope.linear += DMat3::from_diagonal(self.linear * speed)
            + DMat3::from_cols(of_axis(along.x), of_axis(along.y), of_axis(along.z));
        slope.angular += DMat3::from_diagonal(self.angular * motion.angular.abs() * 2.0);
        slope.about(self.at).turned(&at.pose.rotation).negated()
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
        let velocity = self.slope(at);
        // δν = δθ × u − δu, and the same at every point of the body.
        let mut moved = DMat3::ZERO;
        let mut turned = skew(self.fluid(at)) * -1.0;
        if let Some(spread) = self.spread(at) {
            moved = spread * -1.0;
            turned -= moved * skew(at.pose.rotation * self.at);
        }
        let place = Square {
            linear: velocity.linear * moved,
            cross: velocity.linear * turned,
            back: velocity.back * moved,
            angular: velocity.back * turned,
        };
        Tangent { place, velocity, ..Tangent::NONE }
    }

    fn over_time(&self, at: &At) -> Option<Wrench> {
        let (along, gust) = self.gust(at)?;
        Some(self.slope(at).times(&Twist { linear: along * -gust.rate, angular: DVec3::ZERO }))
    }

    fn loss(&self, at: &At) -> f64 {
        let Wrench { force, moment } = self.wrench(at);
        force.dot(self.fluid(at) - at.twist.linear) - moment.dot(at.twist.angular)
    }

    fn work(&self, at: &At) -> f64 {
        if self.stream == DVec3::ZERO { 0.0 } else { self.wrench(at).force.dot(self.fluid(at)) }
    }
}
