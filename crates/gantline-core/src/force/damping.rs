//! Resistance of water by a constant matrix, along the axes of the forces of waves that push the body: level ones that turn with
//! its slow heading ([`super::slow`]).
//!
//! ```text
//! F = −R(ψ) B R(ψ)ᵀ (v_P, ω)
//! ```
//!
//! F acts at a point P of the body. Along the body's own axes, as [`super::drag`] has it where there are no waves, it would
//! leave a mean of the second order beside them, a part of the drift force without the rest.

use glam::DVec3;

use super::axes::Axes;
use super::drag::Drag;
use super::slow::Slow;
use super::square::{Square, skew};
use super::{At, Force, Tangent};
use crate::tree::bias::Wrench;
use crate::tree::kinematics::Twist;

/// Damping of a body in waves.
#[derive(Debug, Clone)]
pub struct Damping {
    name: String,
    body: usize,
    /// P [m], body frame.
    at: DVec3,
    /// B about P.
    matrix: Square,
    /// What its axes turn with.
    pub slow: Slow,
}

/// What a matrix along such axes does at a place, by itself or with more.
pub(super) struct Push {
    /// The axes, with P.
    pub axes: Axes,
    /// v_P and ω, world axes.
    pub motion: Twist,
    /// −B, world axes.
    pub matrix: Square,
    /// At P.
    pub wrench: Wrench,
}

impl Push {
    /// About the body's origin.
    pub fn about_origin(&self) -> Wrench {
        self.wrench.about(self.axes.arm)
    }

    /// As seen from the body, about its origin.
    pub fn tangent(&self) -> Tangent {
        let Self { axes, motion, matrix, wrench } = self;
        let velocity = matrix.about(axes.arm);
        if axes.turning.is_none() {
            return Tangent { velocity, ..Tangent::NONE };
        }
        // It does not turn along, and the motion of the body does.
        let (linear, angular) = (-skew(motion.linear), -skew(motion.angular));
        let force = matrix.linear * linear + matrix.cross * angular;
        let moment = matrix.back * linear + matrix.angular * angular + skew(axes.arm) * force;
        let mut place = Tangent::of_what_stays(wrench.force, wrench.moment, axes.arm).place;
        place.add(1.0, &Square { cross: force, angular: moment, ..Square::ZERO });
        Tangent { place, velocity, ..Tangent::NONE }
    }

    /// Derivative of the wrench at P over time alone, as the axes turn; none along the body's own.
    pub fn over_time(&self) -> Option<Wrench> {
        let Self { axes, motion, matrix, wrench } = self;
        let spin = DVec3::Z * axes.turning?;
        let (linear, angular) = (spin.cross(motion.linear), spin.cross(motion.angular));
        let left = matrix.times(&Twist { linear, angular });
        let force = spin.cross(wrench.force) - left.force;
        let moment = spin.cross(wrench.moment) - left.moment;
        Some(Wrench { force, moment })
    }
}

impl Damping {
    /// What `drag` is where waves push its body; none where it is more than a matrix in water that stands.
    pub fn of(drag: &Drag, slow: &Slow) -> Option<Self> {
        let is_linear = drag.linear == DVec3::ZERO && drag.angular == DVec3::ZERO;
        (is_linear && drag.stream == DVec3::ZERO).then(|| Self {
            name: drag.name.clone(),
            body: drag.body,
            at: drag.at,
            matrix: drag.damping,
            slow: slow.clone(),
        })
    }

    fn push(&self, at: &At) -> Push {
        let axes = Axes::new(at.pose, self.at, self.slow.at(at.past, at.time));
        let motion = Twist { linear: at.twist.at(axes.arm), ..at.twist };
        let matrix = self.matrix.turned(&axes.turn).negated();
        let wrench = matrix.times(&motion);
        Push { axes, motion, matrix, wrench }
    }
}

impl Force for Damping {
    fn name(&self) -> &str {
        &self.name
    }

    fn body(&self) -> usize {
        self.body
    }

    fn wrench(&self, at: &At) -> Wrench {
        self.push(at).about_origin()
    }

    fn tangent(&self, at: &At) -> Tangent {
        self.push(at).tangent()
    }

    fn over_time(&self, at: &At) -> Option<Wrench> {
        let push = self.push(at);
        push.over_time().map(|rate| rate.about(push.axes.arm))
    }

    fn loss(&self, at: &At) -> f64 {
        let Push { motion, wrench, .. } = self.push(at);
        -wrench.power(&motion)
    }
}
