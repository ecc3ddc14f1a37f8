//! What waves do to a body: forces of first order, and of second order the slow drift force (Newman 1974).
//!
//! ```text
//! F = g(t) R(ψ) Re Σ a X e^{iθ}  +  g² R(ψ) (Re (Σ a e^{−iθ}) (Σ a D e^{iθ}) − Σ a² D),    θ = k·s + ε − ωt
//! ```
//!
//! s and ψ are the slow place of a point and the slow heading of the body ([`super::slow`]), β the direction of a wave, X
//! force and moment per metre, D the mean surge, sway and yaw per square metre of one wave alone, each in the direction β − ψ a
//! cubic from one that is known to the next, along axes that are level and turn with ψ. They act at a point P of the body. Within a step all
//! of that depends on time alone. With the place of every moment the first part would have terms of second order that are
//! a part of the true ones only; the second has what is slow of all of them, of each two waves. What each pushes with on the
//! whole, Σ a² D, is the mean drift force ([`super::mean_drift`]).

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

/// Where surge, sway and yaw are among the six.
pub(super) const LEVEL: [usize; 3] = [0, 1, 5];

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
    /// a D of surge, sway and yaw, likewise; empty where there are none.
    pub drifts: Vec<[[f64; 3]; TERMS]>,
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
        // Nothing lies before what is no number: then what comes of it is none either, which whoever asked will see.
        let after = self.directions.partition_point(|known| *known <= wanted).max(1);
        let start = self.directions[after - 1];
        let end = if after < count { self.directions[after] } else { first + TAU };
        let slope = 1.0 / (end - start);
        Between { place: after - 1, share: slope * (wanted - start), slope }
    }

    /// F at P and its derivative over time; none before anything has moved.
    fn at_point(&self, past: &[f64], time: f64) -> [Wrench; 2] {
        let Some(Slowly { place: [place, velocity, ..], heading: [heading, turning, ..] }) =
            self.slow.at(past, time)
        else {
            return [Wrench::default(); 2];
        };
        let (mut first, mut slow) = (Rated::<6>::default(), Drifting::default());
        let mut found: Option<(f64, Between)> = None;
        let count = self.directions.len();
        for (k, (wave, &towards)) in self.sea.components.iter().zip(&self.towards).enumerate() {
            let between = match found {
                Some((known, between)) if known == towards => between,
                _ => self.between(towards - heading),
            };
            found = Some((towards, between));
            let (sin, cos) = wave.turned(place, time);
            let pace = wave.wave_number.dot(velocity) - wave.frequency;
            let cubic = &self.phasors[k * count + between.place];
            for j in 0..6 {
                let [[real, d_real], [imaginary, d_imaginary]] =
                    [0, 1].map(|part| between.value(cubic.each_ref().map(|term| term[part][j])));
                first.value[j] += real * cos - imaginary * sin;
                first.rate[j] -=
                    pace * (real * sin + imaginary * cos) + turning * (d_real * cos - d_imaginary * sin);
            }
            if let Some(cubic) = self.drifts.get(k * count + between.place) {
                let drifts = [0, 1, 2].map(|j| between.value(cubic.each_ref().map(|term| term[j])));
                slow.add(wave.amplitude, drifts.map(|[d, slope]| [d, -turning * slope]), [cos, sin], pace);
            }
        }
        let (growth, slope) = self.sea.growth(time);
        let mut sum = first.times(growth, slope);
        let drift = slow.force().times(growth * growth, 2.0 * growth * slope);
        for (k, axis) in LEVEL.into_iter().enumerate() {
            sum.value[axis] += drift.value[k];
            sum.rate[axis] += drift.rate[k];
        }
        let turn = DMat3::from_rotation_z(heading);
        let level = |all: &[f64; 6]| Wrench {
            force: turn * DVec3::from_slice(&all[..3]),
            moment: turn * DVec3::from_slice(&all[3..]),
        };
        let (force, mut rate, spin) = (level(&sum.value), level(&sum.rate), DVec3::Z * turning);
        rate.force += spin.cross(force.force);
        rate.moment += spin.cross(force.moment);
        [force, rate]
    }
}

/// Numbers and their derivatives over time.
#[derive(Debug, Clone, Copy)]
struct Rated<const N: usize> {
    value: [f64; N],
    rate: [f64; N],
}

impl<const N: usize> Default for Rated<N> {
    fn default() -> Self {
        Self { value: [0.0; N], rate: [0.0; N] }
    }
}

impl<const N: usize> Rated<N> {
    /// Times a number that has a derivative over time itself.
    fn times(self, factor: f64, slope: f64) -> Self {
        let rate = std::array::from_fn(|k| factor * self.rate[k] + slope * self.value[k]);
        Self { value: self.value.map(|x| factor * x), rate }
    }
}

/// Sums of the drift force: real and imaginary parts of Σ a e^{iθ} and Σ a D e^{iθ}, and Σ a² D.
#[derive(Debug, Clone, Copy, Default)]
struct Drifting {
    waves: Rated<2>,
    forces: [Rated<2>; 3],
    mean: Rated<3>,
}

impl Drifting {
    /// Adds a wave with its a, a D with their derivatives over time, e^{iθ} and the derivative of θ.
    fn add(&mut self, amplitude: f64, drifts: [[f64; 2]; 3], [cos, sin]: [f64; 2], pace: f64) {
        for (k, [drift, slope]) in drifts.into_iter().enumerate() {
            self.mean.value[k] += amplitude * drift;
            self.mean.rate[k] += amplitude * slope;
        }
        let (phasor, ahead) = ([cos, sin], [-sin, cos]);
        for part in 0..2 {
            self.waves.value[part] += amplitude * phasor[part];
            self.waves.rate[part] += amplitude * pace * ahead[part];
            for (sum, [drift, slope]) in self.forces.iter_mut().zip(drifts) {
                sum.value[part] += drift * phasor[part];
                sum.rate[part] += slope * phasor[part] + drift * pace * ahead[part];
            }
        }
    }

    /// The real part of the product of one with the conjugate of the other, less what is of each wave alone.
    fn force(&self) -> Rated<3> {
        let dot = |one: [f64; 2], other: [f64; 2]| one[0] * other[0] + one[1] * other[1];
        let Self { waves, forces, mean } = self;
        let value = std::array::from_fn(|k| dot(waves.value, forces[k].value) - mean.value[k]);
        let rate = std::array::from_fn(|k| {
            dot(waves.rate, forces[k].value) + dot(waves.value, forces[k].rate) - mean.rate[k]
        });
        Rated { value, rate }
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

    fn over_time(&self, at: &At) -> Option<Wrench> {
        Some(self.about_origin(at, self.at_point(at.past, at.time)[1]))
    }

    fn work(&self, at: &At) -> f64 {
        self.wrench(at).power(&at.twist)
    }
}
