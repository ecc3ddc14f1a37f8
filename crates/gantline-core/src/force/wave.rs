//! What waves of first order do to a body.
//!
//! ```text
//! F = g(t) R(ψ) Re Σ a X(β − ψ) e^{i(k·s + ε − ωt)}
//! ```
//!
//! s and ψ are the slow place of a point and the slow heading of the body ([`super::slow`]), β the direction of a wave, X
//! force and moment per metre, a cubic from each direction to the next, along axes that are level and turn with ψ. They act
//! at a point P of the body. Within a step all of that depends on time alone. With the place of every moment F would have terms of second
//! order that are a part of the true ones only.

use std::f64::consts::TAU;
use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::slow::{Slow, Slowly};
use super::trains::Trains;
use super::{At, Force, Tangent};
use crate::spec::TERMS;
use crate::tree::bias::Wrench;

/// X of force and moment: what goes with the cosine of the phase, then what goes with its sine.
pub type Phasor = [[f64; 6]; 2];

/// Waves on a body.
#[derive(Debug, Clone)]
pub struct WaveForce {
    /// Name.
    pub name: String,
    /// Index of the body.
    pub body: usize,
    /// P [m], body frame.
    pub at: DVec3,
    /// Directions that X are for, from forward to port [rad], rising within a turn.
    pub directions: Vec<f64>,
    /// a X of every component of the sea, from all directions to the next, by powers of the share of the way.
    pub phasors: Vec<[Phasor; TERMS]>,
    /// The waves.
    pub sea: Arc<Trains>,
    /// Direction β of each [rad].
    pub towards: Vec<f64>,
    /// Behind the body.
    pub slow: Slow,
}

/// Between two directions: the place of the first, the share of the way to the second, and how fast that grows [1/rad].
#[derive(Debug, Clone, Copy)]
struct Between {
    place: usize,
    share: f64,
    slope: f64,
}

impl Between {
    /// A cubic there, and its derivative over the direction [1/rad].
    fn value(self, [c0, c1, c2, c3]: [f64; TERMS]) -> [f64; 2] {
        let Self { share, slope, .. } = self;
        [
            c0 + share * (c1 + share * (c2 + share * c3)),
            slope * (c1 + share * (2.0 * c2 + share * (3.0 * c3))),
        ]
    }
}

impl WaveForce {
    /// Force, and moment about the body's origin, of what acts at P.
    fn about_origin(&self, at: &At, wrench: Wrench) -> Wrench {
        wrench.about(at.pose.rotation * self.at)
    }

    fn between(&self, direction: f64) -> Between {
        let (count, first) = (self.directions.len(), self.directions[0]);
        let wanted = first + (direction - first).rem_euclid(TAU);
        let after = self.directions.partition_point(|known| *known <= wanted);
        let start = self.directions[after - 1];
        let end = if after < count { self.directions[after] } else { first + TAU };
        let slope = 1.0 / (end - start);
        Between { place: after - 1, share: slope * (wanted - start), slope }
    }

    /// F at P and its derivative over time.
    fn at_point(&self, past: &[f64], time: f64) -> [Wrench; 2] {
        let Slowly { place, velocity, heading, turning } = self.slow.at(past, time);
        let (mut sum, mut rate) = ([0.0; 6], [0.0; 6]);
        let mut found: Option<(f64, Between)> = None;
        let each = self.sea.components.iter().zip(&self.towards);
        for ((wave, &towards), phasors) in each.zip(self.phasors.chunks_exact(self.directions.len())) {
            let between = match found {
                Some((known, between)) if known == towards => between,
                _ => self.between(towards - heading),
            };
            found = Some((towards, between));
            let (sin, cos) = (wave.wave_number.dot(place) - wave.frequency * time + wave.phase).sin_cos();
            let pace = wave.wave_number.dot(velocity) - wave.frequency;
            let cubic = &phasors[between.place];
            for k in 0..6 {
                let [[real, d_real], [imaginary, d_imaginary]] =
                    [0, 1].map(|part| between.value(cubic.each_ref().map(|term| term[part][k])));
                sum[k] += real * cos - imaginary * sin;
                rate[k] -=
                    pace * (real * sin + imaginary * cos) + turning * (d_real * cos - d_imaginary * sin);
            }
        }
        let (growth, slope) = self.sea.growth(time);
        let turn = DMat3::from_rotation_z(heading);
        let level = |all: &[f64; 6]| Wrench {
            force: turn * DVec3::from_slice(&all[..3]),
            moment: turn * DVec3::from_slice(&all[3..]),
        };
        let (sum, rate, spin) = (level(&sum), level(&rate), DVec3::Z * turning);
        let force = (rate.force + spin.cross(sum.force)) * growth + sum.force * slope;
        let moment = (rate.moment + spin.cross(sum.moment)) * growth + sum.moment * slope;
        [Wrench { force: sum.force * growth, moment: sum.moment * growth }, Wrench { force, moment }]
    }
}

impl Force for WaveForce {
    fn name(&self) -> &str {
        &self.name
    }

    fn body(&self) -> usize {
        self.body
    }

    fn wrench(&self, at: &At) -> Wrench {
        self.about_origin(at, self.at_point(at.past, at.time)[0])
    }

    fn tangent(&self, at: &At) -> Tangent {
        let Wrench { force, moment } = self.at_point(at.past, at.time)[0];
        Tangent::of_what_stays(force, moment, at.pose.rotation * self.at)
    }

    fn drift(&self, at: &At) -> Option<Wrench> {
        Some(self.about_origin(at, self.at_point(at.past, at.time)[1]))
    }

    fn work(&self, at: &At) -> f64 {
        let Wrench { force, moment } = self.wrench(at);
        force.dot(at.twist.linear) + moment.dot(at.twist.angular)
    }
}
