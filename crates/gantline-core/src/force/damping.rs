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

/// What it does at a place.
struct Push {
    axes: Axes,
    /// v_P and ω, world axes.
    motion: Twist,
    /// −B, world axes.
    matrix: Square,
    /// At P.
    wrench: Wrench,
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
        let Push { axes, wrench, .. } = self.push(at);
        wrench.about(axes.arm)
    }

    fn tangent(&self, at: &At) -> Tangent {
        let Push { axes, motion, matrix, wrench } = self.push(at);
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

    fn over_time(&self, at: &At) -> Option<Wrench> {
        let Push { axes, motion, matrix, wrench } = self.push(at);
        let spin = DVec3::Z * axes.turning?;
        let (linear, angular) = (spin.cross(motion.linear), spin.cross(motion.angular));
        let left = matrix.times(&Twist { linear, angular });
        let force = spin.cross(wrench.force) - left.force;
        let moment = spin.cross(wrench.moment) - left.moment;
        Some(Wrench { force, moment }.about(axes.arm))
    }

    fn loss(&self, at: &At) -> f64 {
        let Push { motion, wrench, .. } = self.push(at);
        -wrench.force.dot(motion.linear) - wrench.moment.dot(motion.angular)
    }
}
