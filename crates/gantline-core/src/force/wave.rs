//! What waves of first order do to a body: a force and a moment that time alone decides.
//!
//! ```text
//! F(t) = g(t) Re Σ X e^{−iωt}
//! ```
//!
//! X holds force and moment of every component of the sea, its amplitude and phase included, for the body where it is
//! at the start; they act at a point P of it, along the world's axes. Small motions about that place are what a wave
//! force of first order is for.

use std::sync::Arc;

use glam::DVec3;

use super::square::{Square, skew};
use super::trains::Trains;
use super::{At, Force, Tangent};
use crate::tree::bias::Wrench;

/// Real and imaginary part of force and moment, world axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phasor {
    /// Along cos ωt.
    pub real: Wrench,
    /// Along sin ωt.
    pub imaginary: Wrench,
}

/// Waves on a body.
#[derive(Debug, Clone)]
pub struct WaveForce {
    /// Name.
    pub name: String,
    /// Index of the body.
    pub body: usize,
    /// P [m], body frame.
    pub at: DVec3,
    /// X of every component of the sea.
    pub phasors: Vec<Phasor>,
    /// The waves.
    pub sea: Arc<Trains>,
}

impl WaveForce {
    /// Force, and moment about the body's origin, of what acts at P.
    fn about_origin(&self, at: &At, Wrench { force, moment }: Wrench) -> Wrench {
        let arm = at.pose.rotation * self.at;
        Wrench { force, moment: moment + arm.cross(force) }
    }

    /// F at P and its derivative over time.
    fn at_point(&self, time: f64) -> [Wrench; 2] {
        let (mut sum, mut rate) = (Wrench::default(), Wrench::default());
        for (wave, Phasor { real, imaginary }) in self.sea.components.iter().zip(&self.phasors) {
            let (sin, cos) = (wave.frequency * time).sin_cos();
            sum.force += real.force * cos + imaginary.force * sin;
            sum.moment += real.moment * cos + imaginary.moment * sin;
            rate.force += (imaginary.force * cos - real.force * sin) * wave.frequency;
            rate.moment += (imaginary.moment * cos - real.moment * sin) * wave.frequency;
        }
        let (growth, slope) = self.sea.growth(time);
        let force = rate.force * growth + sum.force * slope;
        let moment = rate.moment * growth + sum.moment * slope;
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
        self.about_origin(at, self.at_point(at.time)[0])
    }

    fn tangent(&self, at: &At) -> Tangent {
        // It does not turn along: seen from the body a turn δθ changes it by F × δθ.
        let Wrench { force, moment } = self.at_point(at.time)[0];
        let (cross, arm) = (skew(force), skew(at.pose.rotation * self.at));
        let angular = skew(moment) + arm * cross;
        Tangent { place: Square { cross, angular, ..Square::ZERO }, ..Tangent::NONE }
    }

    fn drift(&self, at: &At) -> Option<Wrench> {
        Some(self.about_origin(at, self.at_point(at.time)[1]))
    }

    fn work(&self, at: &At) -> f64 {
        let Wrench { force, moment } = self.wrench(at);
        force.dot(at.twist.linear) + moment.dot(at.twist.angular)
    }
}
