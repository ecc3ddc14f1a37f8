//! How the mean drift force of waves changes as a body makes slow way through them, and what a current adds to it: wave drift
//! damping (Aranha 1994).
//!
//! ```text
//! F = g² R(ψ) (C(ψ) − B(ψ) R(ψ)ᵀ (v_P, ω_z))
//! ```
//!
//! v_P and F are level, in surge and sway, and turn in yaw. ψ is the slow heading of the body ([`super::slow`]), B and C are
//! those of all waves together, cubics from each of some even headings to the next, g is how far the waves have grown. F acts
//! at a point P of the body. Nothing pushes where nothing has moved yet.

use std::f64::consts::TAU;
use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::axes::Axes;
use super::damping::Push;
use super::slow::Slow;
use super::square::Square;
use super::trains::Trains;
use super::wave::LEVEL;
use super::{At, Force, Tangent};
use crate::spec::{SlowingSpec, TERMS};
use crate::tree::bias::Wrench;
use crate::tree::kinematics::Twist;

/// What the waves take of slow way.
#[derive(Debug, Clone)]
pub struct DriftDamping {
    /// Name.
    pub name: String,
    /// Index of the body.
    pub body: usize,
    /// P [m], body frame.
    pub at: DVec3,
    /// B and C from every heading to the next, by powers of the share of the way; the first is 0.
    pub around: Vec<[SlowingSpec; TERMS]>,
    /// The waves.
    pub sea: Arc<Trains>,
    /// Behind the body.
    pub slow: Slow,
}

impl DriftDamping {
    /// B and C at a heading [rad], and their derivatives over it.
    fn at_heading(&self, heading: f64) -> [SlowingSpec; 2] {
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

    /// What it does, and the derivative over time of its wrench at P; none before anything has moved.
    fn push(&self, at: &At) -> Option<(Push, Wrench)> {
        let slowly = self.slow.at(at.past, at.time)?;
        let axes = Axes::new(at.pose, self.at, Some(slowly));
        let motion = Twist { linear: at.twist.at(axes.arm), ..at.twist };
        let [here, slope] = self.at_heading(slowly.heading[0]);
        let (growth, growing) = self.sea.growth(at.time);
        let (square, rising) = (growth * growth, 2.0 * growth * growing);
        let changing = |i: usize, j: usize| rising * here[i][j] + square * slowly.heading[1] * slope[i][j];
        let (matrix, steady) = spread(&axes.turn, |i, j| square * here[i][j]);
        let (matrix_rate, steady_rate) = spread(&axes.turn, changing);
        let wrench = sum(matrix.times(&motion), steady);
        let push = Push { axes, motion, matrix, wrench };
        let rate = sum(matrix_rate.times(&motion), steady_rate);
        let turned = push.over_time().unwrap_or_default();
        Some((push, sum(rate, turned)))
    }
}

/// −B and C along world axes.
fn spread(turn: &DMat3, entry: impl Fn(usize, usize) -> f64) -> (Square, Wrench) {
    let (mut rows, mut steady) = ([[0.0; 6]; 6], [0.0; 6]);
    for (i, row) in LEVEL.into_iter().enumerate() {
        for (j, column) in LEVEL.into_iter().enumerate() {
            rows[row][column] = -entry(i, j);
        }
        steady[row] = entry(i, 3);
    }
    let [force, moment] = [0, 3].map(|first| *turn * DVec3::from_slice(&steady[first..first + 3]));
    (Square::from_rows(&rows).turned(turn), Wrench { force, moment })
}

fn sum(one: Wrench, other: Wrench) -> Wrench {
    Wrench { force: one.force + other.force, moment: one.moment + other.moment }
}

impl Force for DriftDamping {
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
        self.push(at).map_or(Tangent::NONE, |(push, _)| push.tangent())
    }

    fn over_time(&self, at: &At) -> Option<Wrench> {
        self.push(at).map(|(push, rate)| rate.about(push.axes.arm))
    }

    fn work(&self, at: &At) -> f64 {
        let Wrench { force, moment } = self.wrench(at);
        force.dot(at.twist.linear) + moment.dot(at.twist.angular)
    }
}
