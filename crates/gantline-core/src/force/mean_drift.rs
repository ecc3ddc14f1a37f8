//! What waves push a body with on the whole, as it makes way through them, and through a current: their mean drift force and
//! wave drift damping (Aranha 1994).
//!
//! ```text
//! F = R(ψ) (s C(ψ) − g² B(ψ) R(ψ)ᵀ (v_P, ω_z))        s = 1 where it is there from the start, else g²
//! ```
//!
//! v_P and F are level, in surge and sway, and turn in yaw. ψ is the slow heading of the body ([`super::slow`]), B and C are
//! those of all waves together, cubics from each of some even headings to the next, g is how far the waves have grown. F acts
//! at a point P of the body.
//!
//! Where nothing has moved yet, as in statics, a force that is there from the start has the heading of the body itself, and
//! g = 1; another is nothing there.

use std::f64::consts::TAU;
use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::axes::Axes;
use super::damping::Push;
use super::slow::{Slow, heading_of};
use super::square::{Square, outer};
use super::trains::Trains;
use super::wave::LEVEL;
use super::{At, Force, Tangent};
use crate::spec::{MeanDriftSpec, TERMS};
use crate::tree::bias::Wrench;
use crate::tree::kinematics::Twist;

/// What all waves push a body with on the whole.
#[derive(Debug, Clone)]
pub struct MeanDrift {
    /// Name.
    pub name: String,
    /// Index of the body.
    pub body: usize,
    /// P [m], body frame.
    pub at: DVec3,
    /// B and C from every heading to the next, by powers of the share of the way; the first is 0.
    pub around: Vec<[MeanDriftSpec; TERMS]>,
    /// True where it is there from the start, and in statics.
    pub settled: bool,
    /// The waves.
    pub sea: Arc<Trains>,
    /// Behind the body.
    pub slow: Slow,
}

/// Where it is looked at: the heading, s and g², each with its rate of change.
#[derive(Debug, Clone, Copy)]
struct Look {
    heading: [f64; 2],
    steady: [f64; 2],
    damped: [f64; 2],
}

impl MeanDrift {
    /// As a body heads and waves have grown, and how that changes with time; where nothing has moved yet, with the heading.
    fn look(&self, at: &At) -> Option<Look> {
        let Some(slowly) = self.slow.at(at.past, at.time) else {
            let still = [1.0, 0.0];
            let heading = [heading_of(at.pose).0, 1.0];
            return self.settled.then_some(Look { heading, steady: still, damped: still });
        };
        let (growth, growing) = self.sea.growth(at.time);
        let damped = [growth * growth, 2.0 * growth * growing];
        let steady = if self.settled { [1.0, 0.0] } else { damped };
        Some(Look { heading: [slowly.heading[0], slowly.heading[1]], steady, damped })
    }

    /// B and C at a heading [rad], and their derivatives over it.
    fn at_heading(&self, heading: f64) -> [MeanDriftSpec; 2] {
        let count = self.around.len();
        let steps = count as f64 / TAU;
        let way = steps * heading.rem_euclid(TAU);
        // Rounding may make a turn of what is a little less.
        let place = (way as usize).min(count - 1);
        let s = way - place as f64;
        let [c0, c1, c2, c3] = &self.around[place];
        let entry = |make: &dyn Fn([f64; TERMS]) -> f64| {
            std::array::from_fn(|i| std::array::from_fn(|j| make([c0[i][j], c1[i][j], c2[i][j], c3[i][j]])))
        };
        [
            entry(&|[a, b, c, d]| a + s * (b + s * (c + s * d))),
            entry(&|[_, b, c, d]| steps * (b + s * (2.0 * c + s * (3.0 * d)))),
        ]
    }

    /// What it does, and how its wrench at P changes by itself.
    fn push(&self, at: &At) -> Option<(Push, Wrench)> {
        let Look { heading: [heading, turning], steady, damped } = self.look(at)?;
        let turn = DMat3::from_rotation_z(heading);
        let axes = Axes { turn, arm: at.pose.rotation * self.at, turning: Some(turning) };
        let motion = Twist { linear: at.twist.at(axes.arm), ..at.twist };
        let [here, slope] = self.at_heading(heading);
        let share = |j: usize| if j == STEADY { steady } else { damped };
        let (matrix, constant) = spread(&turn, |i, j| share(j)[0] * here[i][j]);
        let (matrix_rate, constant_rate) =
            spread(&turn, |i, j| share(j)[1] * here[i][j] + share(j)[0] * turning * slope[i][j]);
        let wrench = sum(matrix.times(&motion), constant);
        let rate = sum(matrix_rate.times(&motion), constant_rate);
        let push = Push { axes, motion, matrix, wrench };
        let turned = push.over_time().unwrap_or_default();
        Some((push, sum(rate, turned)))
    }
}

/// The column of C.
const STEADY: usize = 3;

/// −B and C along world axes.
fn spread(turn: &DMat3, entry: impl Fn(usize, usize) -> f64) -> (Square, Wrench) {
    let (mut rows, mut steady) = ([[0.0; 6]; 6], [0.0; 6]);
    for (i, row) in LEVEL.into_iter().enumerate() {
        for (j, column) in LEVEL.into_iter().enumerate() {
            rows[row][column] = -entry(i, j);
        }
        steady[row] = entry(i, STEADY);
    }
    let [force, moment] = [0, 3].map(|first| *turn * DVec3::from_slice(&steady[first..first + 3]));
    (Square::from_rows(&rows).turned(turn), Wrench { force, moment })
}

fn sum(one: Wrench, other: Wrench) -> Wrench {
    Wrench { force: one.force + other.force, moment: one.moment + other.moment }
}

impl Force for MeanDrift {
    fn name(&self) -> &str {
        &self.name
    }

    fn body(&self) -> usize {
        self.body
    }

    fn wrench(&self, at: &At) -> Wrench {
        self.push(at).map_or(Wrench::default(), |(push, _)| push.about_origin())
    }

    fn tangent(&self, at: &At) -> Tangent {
        let Some((push, rate)) = self.push(at) else { return Tangent::NONE };
        let mut tangent = push.tangent();
        if self.slow.at(at.past, at.time).is_none() {
            // The heading is that of the body, and the rate is over it.
            let (over, turns) = (rate.about(push.axes.arm), heading_of(at.pose).1);
            tangent.place.cross += outer(over.force, turns);
            tangent.place.angular += outer(over.moment, turns);
        }
        tangent
    }

    fn over_time(&self, at: &At) -> Option<Wrench> {
        self.slow.at(at.past, at.time)?;
        self.push(at).map(|(push, rate)| rate.about(push.axes.arm))
    }

    fn work(&self, at: &At) -> f64 {
        self.wrench(at).power(&at.twist)
    }
}
