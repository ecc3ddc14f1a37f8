//! Water that a body in waves accelerates along, by a constant symmetric matrix A along the axes of their forces: level ones that
//! turn with its slow heading ([`super::slow`]).
//!
//! With R(ψ) from those axes to the world's, which turn with Ω = ψ̇ e_z, ν = (v, ω) the motion of a point P of the body and U the
//! velocity of the slow place there, all in world axes, and A turned along,
//!
//! ```text
//! (p, L) = R A Rᵀ ν        (p, L)˙ = R A Rᵀ (ν̇ − Ω × ν) + Ω × (p, L)        f = ṗ        m = L̇ + U × p
//! ```
//!
//! is what the body has to give, m about P. Where all is slow, v = U and ω = Ω, that is [`super::added_mass`] (Kirchhoff 1869).
//! f and L̇ are rates of what is of the first order, with no part of the second. Of v × p, the moment that the momentum makes as
//! P moves on, (v − U) × p is left out: the velocity in waves times the momentum in waves has a slow part, one of the second order
//! without the others.
//!
//! A that turns by itself takes and gives power. With T = ½ νᵀ(p, L) that of the body is
//!
//! ```text
//! f·v + m·ω = Ṫ + Ω × p·v + Ω × L·ω + U × p·ω
//! ```
//!
//! and what is there beside Ṫ goes into the waves; it is none where all is slow. Before anything has moved, in statics, the axes
//! are those of the body.

use glam::{DMat3, DVec3};

use super::added_mass::AddedMass;
use super::axes::Axes;
use super::slow::{Slow, Slowly};
use super::square::{Square, skew};
use super::{At, Force, Tangent};
use crate::tree::bias::Wrench;
use crate::tree::kinematics::{Kinematics, Twist};

/// Added mass of a body in waves.
#[derive(Debug, Clone)]
pub struct LevelMass {
    /// Along the body's own axes, as at rest.
    pub own: AddedMass,
    /// What its axes turn with.
    pub slow: Slow,
}

/// Motion of P, of the slow place there, and what the water has of the former; world axes.
struct Moving {
    /// A.
    matrix: Square,
    arm: DVec3,
    /// Ω as a vector, and its rate.
    turning: [DVec3; 2],
    /// U, and its rate.
    slow: [DVec3; 2],
    /// ν.
    motion: Twist,
    /// ν̇ − Ω × ν.
    rate: Twist,
    /// p as `force` and L as `moment`.
    momentum: Wrench,
}

/// Force and moment of one motion each, crossed with a vector.
fn crossed(spin: DVec3, Wrench { force, moment }: Wrench) -> Wrench {
    Wrench { force: spin.cross(force), moment: spin.cross(moment) }
}

fn turned(spin: DVec3, Twist { linear, angular }: &Twist) -> Twist {
    Twist { linear: spin.cross(*linear), angular: spin.cross(*angular) }
}

fn sum(parts: &[Wrench]) -> Wrench {
    let add = |all: Wrench, part: &Wrench| Wrench {
        force: all.force + part.force,
        moment: all.moment + part.moment,
    };
    parts.iter().fold(Wrench::default(), add)
}

impl LevelMass {
    /// What `own` is where waves push its body.
    pub fn of(own: &AddedMass, slow: &Slow) -> Self {
        Self { own: own.clone(), slow: slow.clone() }
    }

    /// None at rest.
    fn moving(&self, at: &At) -> Option<Moving> {
        let slowly = self.slow.at(at.past, at.time)?;
        let Axes { turn, arm, .. } = Axes::new(at.pose, self.own.at, Some(slowly));
        let Slowly { velocity, acceleration, turning, quickening, .. } = slowly;
        let [spin, spinning] = [DVec3::Z * turning, DVec3::Z * quickening];
        let beside = turn * (self.own.at - self.slow.point).with_z(0.0);
        let swing = spin.cross(beside);
        let slow = [
            velocity.extend(0.0) + swing,
            acceleration.extend(0.0) + spinning.cross(beside) + spin.cross(swing),
        ];
        let matrix = self.own.matrix.turned(&turn);
        let motion = Twist { linear: at.twist.at(arm), ..at.twist };
        let swung = at.twist.angular.cross(at.twist.angular.cross(arm));
        let left = turned(spin, &motion);
        let rate =
            Twist { linear: at.rate.at(arm) + swung - left.linear, angular: at.rate.angular - left.angular };
        let momentum = matrix.times(&motion);
        Some(Moving { matrix, arm, turning: [spin, spinning], slow, motion, rate, momentum })
    }
}

impl Moving {
    /// U × p.
    fn carried_on(&self) -> DVec3 {
        self.slow[0].cross(self.momentum.force)
    }

    /// f and m.
    fn given(&self) -> Wrench {
        let moment = Wrench { moment: self.carried_on(), ..Wrench::default() };
        sum(&[self.matrix.times(&self.rate), crossed(self.turning[0], self.momentum), moment])
    }

    /// How A that turns changes what it makes of a motion: Ω × Aν − A (Ω × ν).
    fn swept(&self, motion: &Twist) -> Wrench {
        let spin = self.turning[0];
        let left = self.matrix.times(&turned(-spin, motion));
        sum(&[crossed(spin, self.matrix.times(motion)), left])
    }

    /// ∂f and ∂m over v and ω, their rates held.
    fn over_motion(&self) -> Square {
        let (spin, Square { linear, cross, back, angular }) = (skew(self.turning[0]), self.matrix);
        let slow = skew(self.slow[0]);
        let sweep = |part: DMat3| spin * part - part * spin;
        Square {
            linear: sweep(linear),
            cross: sweep(cross),
            back: sweep(back) + slow * linear,
            angular: sweep(angular) + slow * cross,
        }
    }
}

impl Force for LevelMass {
    fn name(&self) -> &str {
        &self.own.name
    }

    fn body(&self) -> usize {
        self.own.body
    }

    fn wrench(&self, at: &At) -> Wrench {
        let Some(moving) = self.moving(at) else { return self.own.wrench(at) };
        let Wrench { force, moment } = moving.given();
        Wrench { force: -force, moment: -moment }.about(moving.arm)
    }

    fn tangent(&self, at: &At) -> Tangent {
        let Some(moving) = self.moving(at) else { return self.own.tangent(at) };
        let Moving { matrix, arm, motion, .. } = &moving;
        let (arm, over) = (*arm, moving.over_motion());
        let Wrench { force, moment } = moving.given();
        // A does not turn along, and the motion of the body and its rate do.
        let accelerated = Twist {
            linear: at.rate.at(arm) + motion.angular.cross(motion.angular.cross(arm)),
            angular: at.rate.angular,
        };
        let of_turn = |by: &Square, motion: &Twist| {
            let (linear, angular) = (-skew(motion.linear), -skew(motion.angular));
            let force = by.linear * linear + by.cross * angular;
            let moment = by.back * linear + by.angular * angular;
            Square { cross: force, angular: moment + skew(arm) * force, ..Square::ZERO }
        };
        let mut place = of_turn(&over, motion);
        place.add(1.0, &of_turn(matrix, &accelerated));
        let mut place = place.negated();
        place.add(1.0, &Tangent::of_what_stays(-force, -moment, arm).place);
        // Over ω the acceleration of P has that of ω × (ω × r).
        let swing = -skew(motion.angular.cross(arm)) - skew(motion.angular) * skew(arm);
        let mut velocity = over.about(arm);
        let (force, moment) = (matrix.linear * swing, matrix.back * swing);
        velocity.add(1.0, &Square { cross: force, angular: moment + skew(arm) * force, ..Square::ZERO });
        Tangent { place, velocity: velocity.negated(), acceleration: matrix.about(arm).negated() }
    }

    fn over_time(&self, at: &At) -> Option<Wrench> {
        let moving = self.moving(at)?;
        let Moving {
            matrix,
            arm,
            turning: [spin, spinning],
            slow: [slow, slowing],
            motion,
            rate,
            momentum,
            ..
        } = &moving;
        let swept = moving.swept(motion);
        let carried = slowing.cross(momentum.force) + slow.cross(swept.force);
        let Wrench { force, moment } = sum(&[
            moving.swept(rate),
            matrix.times(&turned(-*spinning, motion)),
            crossed(*spinning, *momentum),
            crossed(*spin, swept),
            Wrench { moment: carried, ..Wrench::default() },
        ]);
        Some(Wrench { force: -force, moment: -moment }.about(*arm))
    }

    fn work(&self, at: &At) -> f64 {
        let Some(moving) = self.moving(at) else { return 0.0 };
        let Wrench { force, moment } = crossed(moving.turning[0], moving.momentum);
        -force.dot(moving.motion.linear) - (moment + moving.carried_on()).dot(moving.motion.angular)
    }

    fn inertia(&self, kinematics: &Kinematics) -> Option<Square> {
        let pose = &kinematics.pose[self.own.body];
        let Axes { turn, arm, .. } =
            Axes::new(pose, self.own.at, self.slow.at(&kinematics.past, kinematics.time));
        Some(self.own.matrix.turned(&turn).about(arm))
    }
}
