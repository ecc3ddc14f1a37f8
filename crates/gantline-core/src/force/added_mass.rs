//! Water that a body in motion accelerates along, by a constant symmetric matrix A in the body's axes.
//!
//! The water has the energy ½ νᵀAν, ν the velocity of a point P of the body and the angular velocity, both in the
//! body's axes. With p = A_ll v + A_la ω and L = A_al v + A_aa ω, its momenta, the body has to give (Kirchhoff 1869)
//!
//! ```text
//! f = A_ll u + A_la α + ω × p        m = A_al u + A_aa α + ω × L + v × p        u = v̇ − ω × v
//! ```
//!
//! with m about P; u is the rate of v in the body's axes. So what is put into the water comes back: it holds energy and
//! loses none.

use glam::{DMat3, DVec3};

use super::square::{Square, skew};
use super::{At, Force, Tangent};
use crate::tree::bias::Wrench;
use crate::tree::kinematics::{Kinematics, Twist};
use crate::tree::pose::Pose;

/// Added mass of a body.
#[derive(Debug, Clone)]
pub struct AddedMass {
    /// Name.
    pub name: String,
    /// Index of the body.
    pub body: usize,
    /// P [m], body frame.
    pub at: DVec3,
    /// A about P, body axes.
    pub matrix: Square,
}

/// Motion of P and what the water has of it, world axes.
struct Moving {
    matrix: Square,
    arm: DVec3,
    /// v of P and ω.
    motion: Twist,
    /// p as `force` and L as `moment`.
    momentum: Wrench,
}

impl AddedMass {
    /// Inertia about the origin of the body at `pose`.
    pub fn inertia_at(&self, pose: &Pose) -> Square {
        self.matrix.turned(&pose.rotation).about(pose.rotation * self.at)
    }

    fn moving(&self, at: &At) -> Moving {
        let matrix = self.matrix.turned(&at.pose.rotation);
        let arm = at.pose.rotation * self.at;
        let motion = Twist { angular: at.twist.angular, linear: at.twist.at(arm) };
        Moving { momentum: matrix.times(&motion), matrix, arm, motion }
    }
}

impl Force for AddedMass {
    fn name(&self) -> &str {
        &self.name
    }

    fn body(&self) -> usize {
        self.body
    }

    fn wrench(&self, at: &At) -> Wrench {
        let Moving { matrix, arm, motion, momentum } = self.moving(at);
        let spin = motion.angular;
        // ω × (ω × r) of P's acceleration and of ω × v cancel.
        let rate = at.rate.at(arm) - spin.cross(at.twist.linear);
        let steady = matrix.times(&Twist { angular: at.rate.angular, linear: rate });
        let force = steady.force + spin.cross(momentum.force);
        let moment = steady.moment + spin.cross(momentum.moment) + motion.linear.cross(momentum.force);
        Wrench { force: -force, moment: -moment - arm.cross(force) }
    }

    fn tangent(&self, at: &At) -> Tangent {
        let Moving { matrix, arm, motion, momentum } = self.moving(at);
        let (spin, swing) = (skew(motion.angular), skew(motion.angular.cross(arm)));
        let (away, along) = (skew(arm), skew(motion.linear));
        // δu over δv and δω of the origin, u = v̇_o + α × r − ω × v_o.
        let over_linear = -spin;
        let over_angular = along - swing;
        // δp and δL over the same: A about P, moved to the origin on the side of the motion only.
        let linear = (matrix.linear, matrix.back);
        let angular = (matrix.cross - matrix.linear * away, matrix.angular - matrix.back * away);
        let column = |rate: DMat3, (p, l): (DMat3, DMat3), turn: DMat3, shift: DMat3| {
            let force = matrix.linear * rate + spin * p - skew(momentum.force) * turn;
            let moment = matrix.back * rate + spin * l - skew(momentum.moment) * turn + along * p
                - skew(momentum.force) * shift;
            (force, moment + away * force)
        };
        let one = DMat3::IDENTITY;
        let (force_linear, moment_linear) = column(over_linear, linear, DMat3::ZERO, one);
        let (force_angular, moment_angular) = column(over_angular, angular, one, -away);
        let velocity = Square {
            linear: force_linear,
            cross: force_angular,
            back: moment_linear,
            angular: moment_angular,
        };
        let acceleration = matrix.about(arm).negated();
        Tangent { velocity: velocity.negated(), acceleration, ..Tangent::NONE }
    }

    fn inertia(&self, kinematics: &Kinematics) -> Option<Square> {
        Some(self.inertia_at(&kinematics.pose[self.body]))
    }
}
