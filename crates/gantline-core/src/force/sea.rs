//! Waves on the water: long-crested components, each a small regular wave (Airy 1845).
//!
//! ```text
//! η(x, t) = g(t) Σ a cos(k·x − ω t + ε)
//! ```
//!
//! g grows from 0 to 1 at the start, with two derivatives that are zero at both ends, so that what rests begins to move
//! without a jerk.

use std::f64::consts::PI;

use glam::DVec2;

/// Looks in the shortest period of a wave.
const LOOKS_IN_WAVE: f64 = 8.0;

/// A regular wave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Component {
    /// ω [rad/s].
    pub frequency: f64,
    /// k [rad/m], world axes.
    pub wave_number: DVec2,
    /// a [m].
    pub amplitude: f64,
    /// ε [rad].
    pub phase: f64,
}

/// Waves that come by.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sea {
    /// What they are made of.
    pub components: Vec<Component>,
    /// Time in which they grow [s].
    pub rise_time: f64,
}

impl Sea {
    /// g and its derivative over time at `time` [s].
    pub fn growth(&self, time: f64) -> (f64, f64) {
        if time >= self.rise_time {
            return (1.0, 0.0);
        }
        let s = (time / self.rise_time).max(0.0);
        let share = s * s * s * (10.0 - s * (15.0 - 6.0 * s));
        let slope = 30.0 * s * s * (1.0 - s) * (1.0 - s);
        (share, slope / self.rise_time)
    }

    /// η of the undisturbed water at a place [m] and `time` [s] [m].
    pub fn elevation(&self, place: DVec2, time: f64) -> f64 {
        let waves = self.components.iter().map(|wave| {
            wave.amplitude * (wave.wave_number.dot(place) - wave.frequency * time + wave.phase).cos()
        });
        self.growth(time).0 * waves.sum::<f64>()
    }

    /// Looks that a time of `length` [s] needs so that no wave comes and goes between two; 0 where there are none.
    pub fn looks(&self, length: f64) -> usize {
        let fastest = self.components.iter().map(|wave| wave.frequency).fold(0.0, f64::max);
        (LOOKS_IN_WAVE * length * fastest / (2.0 * PI)).ceil() as usize
    }

    /// No wave is higher [m].
    pub fn highest(&self) -> f64 {
        self.components.iter().map(|wave| wave.amplitude.abs()).sum()
    }
}
