//! Water that a body in waves accelerates along, by a constant symmetric matrix A: what is slow of its motion along the axes of
//! the body, and what is fast along those of the wave forces, level ones that turn with its slow heading ([`super::slow`]).
//!
//! With ν = (v, ω) the motion of a point P of the body and ν̄ = (U, Ω) that of the slow place there, in world axes, and
//! A and Ā the matrix along both axes,
//!
//! ```text
//! (p, L) = A ν̄ + Ā (ν − ν̄)        (P, ·) = A ν̄        f = ṗ        m = L̇ + v × P + U × (p − P)
//! ```
//!
//! is what the body has to give, m about P. Where all is slow that is [`super::added_mass`] (Kirchhoff 1869), and so it is to
//! the first order in what differs from slow, be that waves or a lag of the slow motion. What is left out is fast twice:
//!
//! ```text
//! (A − Ā)(ν − ν̄)        (v − U) × (p − P)
//! ```
//!
//! In waves both have a slow part, one of the second order without the others.
//!
//! A that turns by itself takes and gives power. With T = ½ νᵀ Ā ν that of the body is f·v + m·ω, and what is there beside Ṫ
//! goes into the waves; it is none where all is slow. Before anything has moved, in statics, the axes are those of the body.

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
    /// What the level axes turn with.
    pub slow: Slow,
}

/// Motion of P and of the slow place there; world axes.
struct Moving {
    /// A.
    own: Square,
    /// Ā.
    level: Square,
    arm: DVec3,
    /// ν, and its rate.
    motion: [Twist; 2],
    /// ν̄, and its rates.
    slow: [Twist; 3],
}

fn difference(one: &Twist, other: &Twist) -> Twist {
    Twist { linear: one.linear - other.linear, angular: one.angular - other.angular }
}

fn turned(spin: DVec3, Twist { linear, angular }: &Twist) -> Twist {
    Twist { linear: spin.cross(*linear), angular: spin.cross(*angular) }
}

fn crossed(spin: DVec3, Wrench { force, moment }: Wrench) -> Wrench {
    Wrench { force: spin.cross(force), moment: spin.cross(moment) }
}

fn opposite(Wrench { force, moment }: Wrench) -> Wrench {
    Wrench { force: -force, moment: -moment }
}

fn sum(parts: &[Wrench]) -> Wrench {
    let add = |all: Wrench, part: &Wrench| Wrench {
        force: all.force + part.force,
        moment: all.moment + part.moment,
    };
    parts.iter().fold(Wrench::default(), add)
}

/// How a matrix that turns changes what it makes of a motion: Ω × Aν − A (Ω × ν).
fn swept(spin: DVec3, matrix: &Square, motion: &Twist) -> Wrench {
    sum(&[crossed(spin, matrix.times(motion)), opposite(matrix.times(&turned(spin, motion)))])
}

/// The same as matrices of Ω, for the force and for the moment.
fn sweeping(matrix: &Square, motion: &Twist) -> [DMat3; 2] {
    let Wrench { force, moment } = matrix.times(motion);
    let [linear, angular] = [skew(motion.linear), skew(motion.angular)];
    [
        matrix.linear * linear + matrix.cross * angular - skew(force),
        matrix.back * linear + matrix.angular * angular - skew(moment),
    ]
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
        let swung = at.twist.angular.cross(at.twist.angular.cross(arm));
        let motion = [
            Twist { linear: at.twist.at(arm), ..at.twist },
            Twist { linear: at.rate.at(arm) + swung, ..at.rate },
        ];
        let (own, level) = (self.own.matrix.turned(&at.pose.rotation), self.own.matrix.turned(&turn));
        Some(Moving { own, level, arm, motion, slow: self.slowly(&slowly, &turn) })
    }

    /// ν̄ and its rates: `place` is that of another point, from which P is a level way off that turns with the heading.
    fn slowly(&self, Slowly { place, heading }: &Slowly, turn: &DMat3) -> [Twist; 3] {
        let away = turn * (self.own.at - self.slow.point).with_z(0.0);
        let [spin, spinning, beyond] = [1, 2, 3].map(|k| DVec3::Z * heading[k]);
        let swing = spin.cross(away);
        let swings = [
            swing,
            spinning.cross(away) + spin.cross(swing),
            beyond.cross(away) + 3.0 * spinning.cross(swing) + spin.cross(spin.cross(swing)),
        ];
        std::array::from_fn(|k| Twist {
            linear: place[k + 1].extend(0.0) + swings[k],
            angular: DVec3::Z * heading[k + 1],
        })
    }
}

impl Moving {
    /// Ω.
    fn spin(&self) -> DVec3 {
        self.slow[0].angular
    }

    /// ν − ν̄.
    fn fast(&self) -> Twist {
        difference(&self.motion[0], &self.slow[0])
    }

    /// ν̇ − ν̄˙.
    fn fast_rate(&self) -> Twist {
        difference(&self.motion[1], &self.slow[1])
    }

    /// f and m.
    fn given(&self) -> Wrench {
        let [Twist { linear: velocity, angular }, _] = self.motion;
        let [slow, slow_rate, _] = &self.slow;
        let (held, fast) = (self.own.times(slow).force, self.level.times(&self.fast()).force);
        let carried_on = velocity.cross(held) + slow.linear.cross(fast);
        sum(&[
            swept(angular, &self.own, slow),
            self.own.times(slow_rate),
            swept(self.spin(), &self.level, &self.fast()),
            self.level.times(&self.fast_rate()),
            Wrench { moment: carried_on, ..Wrench::default() },
        ])
    }

    /// ∂f and ∂m over v and ω, their rates held.
    fn over_motion(&self) -> Square {
        let (spin, Square { linear, cross, back, angular }) = (skew(self.spin()), self.level);
        let (slow, held) = (skew(self.slow[0].linear), self.own.times(&self.slow[0]).force);
        let sweep = |part: DMat3| spin * part - part * spin;
        let [force, moment] = sweeping(&self.own, &self.slow[0]);
        Square {
            linear: sweep(linear),
            cross: sweep(cross) + force,
            back: sweep(back) + slow * linear - skew(held),
            angular: sweep(angular) + slow * cross + moment,
        }
    }

    /// ∂f and ∂m as A turns by itself.
    fn over_own_axes(&self) -> [DMat3; 2] {
        let [Twist { linear: velocity, angular }, _] = self.motion;
        let [slow, slow_rate, _] = &self.slow;
        let of = [slow, slow_rate, &turned(angular, slow)].map(|motion| sweeping(&self.own, motion));
        let [force, moment] = [0, 1].map(|k| skew(angular) * of[0][k] + of[1][k] - of[2][k]);
        [force, moment + skew(velocity) * of[0][0]]
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
        opposite(moving.given()).about(moving.arm)
    }

    fn tangent(&self, at: &At) -> Tangent {
        let Some(moving) = self.moving(at) else { return self.own.tangent(at) };
        let Moving { level, arm, motion: [motion, rate], .. } = &moving;
        let (arm, over) = (*arm, moving.over_motion());
        // Both at P, for turns of the body about its origin.
        let about = |force: DMat3, moment: DMat3| Square {
            cross: force,
            angular: moment + skew(arm) * force,
            ..Square::ZERO
        };
        // The motion of the body and its rate turn along, and so does A.
        let along = |by: &Square, motion: &Twist| {
            let (linear, angular) = (-skew(motion.linear), -skew(motion.angular));
            about(by.linear * linear + by.cross * angular, by.back * linear + by.angular * angular)
        };
        let [force, moment] = moving.over_own_axes();
        let mut place = along(&over, motion);
        place.add(1.0, &along(level, rate));
        place.add(1.0, &about(force, moment));
        let mut place = place.negated();
        let given = opposite(moving.given());
        place.add(1.0, &Tangent::of_what_stays(given.force, given.moment, arm).place);
        // Over ω the acceleration of P has that of ω × (ω × r).
        let swing = -skew(motion.angular.cross(arm)) - skew(motion.angular) * skew(arm);
        let mut velocity = over.about(arm);
        velocity.add(1.0, &about(level.linear * swing, level.back * swing));
        Tangent { place, velocity: velocity.negated(), acceleration: level.about(arm).negated() }
    }

    fn over_time(&self, at: &At) -> Option<Wrench> {
        let moving = self.moving(at)?;
        let Moving { own, level, arm, motion: [motion, _], slow: [slow, slow_rate, slow_bend] } = &moving;
        let (spin, fast) = (slow.angular, moving.fast());
        let sweep = |motion: &Twist| swept(spin, level, motion);
        let swings = sweep(&fast);
        let [held, fast_force] = [own.times(slow_rate).force, level.times(&fast).force];
        let fast_pace = swings.force - level.times(slow_rate).force;
        let carried_on =
            motion.linear.cross(held) + slow_rate.linear.cross(fast_force) + slow.linear.cross(fast_pace);
        let given = sum(&[
            swept(motion.angular, own, slow_rate),
            own.times(slow_bend),
            swept(slow_rate.angular, level, &fast),
            opposite(sweep(slow_rate)),
            crossed(spin, swings),
            opposite(sweep(&turned(spin, &fast))),
            sweep(&moving.fast_rate()),
            opposite(level.times(slow_bend)),
            Wrench { moment: carried_on, ..Wrench::default() },
        ]);
        Some(opposite(given).about(*arm))
    }

    fn work(&self, at: &At) -> f64 {
        let Some(mut moving) = self.moving(at) else { return 0.0 };
        // Ṫ and what is given are alike in ν̇.
        moving.motion[1] = Twist::default();
        let motion = &moving.motion[0];
        crossed(moving.spin(), moving.level.times(motion)).power(motion) - moving.given().power(motion)
    }

    fn inertia(&self, kinematics: &Kinematics) -> Option<Square> {
        let pose = &kinematics.pose[self.own.body];
        let Axes { turn, arm, .. } =
            Axes::new(pose, self.own.at, self.slow.at(&kinematics.past, kinematics.time));
        Some(self.own.matrix.turned(&turn).about(arm))
    }
}
