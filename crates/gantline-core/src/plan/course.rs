//! Prescribed motion: ramps of velocity, integrated in closed form, so position, velocity and
//! acceleration are consistent at any time.

use std::ops::Add;

use serde::{Deserialize, Serialize};

use crate::spec::RampShape;

/// A change of velocity and the steady motion after it, until the next ramp.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Ramp {
    /// Start [s].
    pub at: f64,
    /// Duration [s].
    pub duration: f64,
    /// Velocity at the start [m/s or rad/s].
    pub from: f64,
    /// Velocity at the end.
    pub to: f64,
    /// Position at the start [m or rad].
    pub position: f64,
    /// Course.
    pub shape: RampShape,
}

/// Up to when what is due at a time [s] is due to rounding: times that ought to be one differ in their last bits.
pub fn soon(time: f64) -> f64 {
    time + 1e-12 * (1.0 + time)
}

/// Position, velocity, acceleration of a drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// [m or rad]
    pub position: f64,
    /// [m/s or rad/s]
    pub velocity: f64,
    /// [m/s² or rad/s²]
    pub acceleration: f64,
}

impl RampShape {
    /// Peak acceleration of a unit change of velocity in unit time.
    pub fn peak_acceleration(self) -> f64 {
        match self {
            Self::Linear => 1.0,
            Self::Smooth => 1.5,
        }
    }
}

impl Ramp {
    /// When the velocity has changed [s]. Whoever stops there must see the ramp as over, to the last bit.
    pub(super) fn end(&self) -> f64 {
        self.at + self.duration
    }

    fn motion(&self, time: f64) -> Motion {
        let elapsed = (time - self.at).max(0.0);
        let change = self.to - self.from;
        if elapsed >= self.duration {
            let end = self.position + 0.5 * (self.from + self.to) * self.duration;
            let position = end + self.to * (elapsed - self.duration);
            return Motion { position, velocity: self.to, acceleration: 0.0 };
        }
        let s = elapsed / self.duration;
        // Share of the change of velocity, its integral and its derivative over s.
        let (share, integral, slope) = match self.shape {
            RampShape::Linear => (s, 0.5 * s * s, 1.0),
            RampShape::Smooth => (s * s * (3.0 - 2.0 * s), s * s * s * (1.0 - 0.5 * s), 6.0 * s * (1.0 - s)),
        };
        Motion {
            position: self.position + self.from * elapsed + change * integral * self.duration,
            velocity: self.from + change * share,
            acceleration: change * slope / self.duration,
        }
    }
}

impl Add for Motion {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            position: self.position + other.position,
            velocity: self.velocity + other.velocity,
            acceleration: self.acceleration + other.acceleration,
        }
    }
}

/// Ramps one after another, from rest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Course {
    start: f64,
    pub(super) ramps: Vec<Ramp>,
}

impl Course {
    /// At rest at `start` [m or rad], with room for `ramps`.
    pub fn new(start: f64, ramps: usize) -> Self {
        Self { start, ramps: Vec::with_capacity(ramps) }
    }

    /// Takes over the ramps of `other`; does not allocate once there has been room.
    pub fn copy_from(&mut self, other: &Self) {
        self.start = other.start;
        self.ramps.clone_from(&other.ramps);
    }

    /// Nothing has been asked for any more; it rests at 0.
    pub fn clear(&mut self) {
        self.start = 0.0;
        self.ramps.clear();
    }

    /// All its positions are `by` [m or rad] further.
    pub fn shift(&mut self, by: f64) {
        self.start += by;
        self.ramps.iter_mut().for_each(|ramp| ramp.position += by);
    }

    /// Where it is at `time` [s].
    pub fn motion(&self, time: f64) -> Motion {
        let next = self.ramps.partition_point(|ramp| ramp.at <= time);
        match next.checked_sub(1) {
            Some(last) => self.ramps[last].motion(time),
            None => Motion { position: self.start, velocity: 0.0, acceleration: 0.0 },
        }
    }

    /// Velocity with which it goes on after all ramps.
    pub fn final_velocity(&self) -> f64 {
        self.ramps.last().map_or(0.0, |ramp| ramp.to)
    }

    /// Acceleration at `time` [s] and its derivative, of the piece of motion that is under way at `from`: at the
    /// end of a ramp the value before it and not after it. A step that begins within rounding of where a ramp starts
    /// or ends does not stop there, so that the ramp is under way, or over.
    pub fn acceleration(&self, from: f64, time: f64) -> (f64, f64) {
        let from = soon(from);
        let next = self.ramps.partition_point(|ramp| ramp.at <= from);
        let under_way = next.checked_sub(1).map(|last| &self.ramps[last]);
        let Some(ramp) = under_way.filter(|ramp| from < ramp.end()) else { return (0.0, 0.0) };
        let (s, slope) = ((time - ramp.at) / ramp.duration, (ramp.to - ramp.from) / ramp.duration);
        match ramp.shape {
            RampShape::Linear => (slope, 0.0),
            RampShape::Smooth => (slope * 6.0 * s * (1.0 - s), slope * 6.0 * (1.0 - 2.0 * s) / ramp.duration),
        }
    }

    /// The next time after `time` [s] at which a ramp starts or ends.
    pub fn next_break(&self, time: f64) -> f64 {
        let breaks = self.ramps.iter().flat_map(|ramp| [ramp.at, ramp.end()]);
        breaks.filter(|&at| at > time).fold(f64::INFINITY, f64::min)
    }

    /// From `at` [s] on, within `duration` [s], the velocity goes to `velocity`. Later ramps are dropped.
    /// Returns the end of the ramp [s].
    pub fn ramp(&mut self, at: f64, duration: f64, velocity: f64, shape: RampShape) -> f64 {
        let Motion { position, velocity: from, .. } = self.motion(at);
        self.ramps.retain(|ramp| ramp.at < at);
        self.ramps.push(Ramp { at, duration, from, to: velocity, position, shape });
        at + duration
    }

    /// As [`Course::ramp`], as fast as `acceleration` allows.
    pub fn change(&mut self, at: f64, velocity: f64, acceleration: f64, shape: RampShape) -> f64 {
        let change = (velocity - self.motion(at).velocity).abs();
        self.ramp(at, shape.peak_acceleration() * change / acceleration, velocity, shape)
    }

    /// From `at` [s] on it is `by` [m or rad] further and goes by `velocity` [m/s or rad/s] faster than it did.
    pub fn carry(&mut self, at: f64, by: f64, velocity: f64) {
        self.shift(by);
        if velocity != 0.0 {
            let Motion { position, velocity: from, .. } = self.motion(at);
            let to = from + velocity;
            self.ramps.retain(|ramp| ramp.at < at);
            self.ramps.push(Ramp { at, duration: 0.0, from, to, position, shape: RampShape::Linear });
        }
    }

    /// Moves by `distance` from rest and stops; returns the end [s].
    pub fn travel(&mut self, at: f64, distance: f64, speed: f64, acceleration: f64, shape: RampShape) -> f64 {
        // Each of the two ramps covers v·d/2, d = c v/a; the speed is lowered where both do not fit.
        let gentle = acceleration / shape.peak_acceleration();
        let speed = speed.abs().min((distance.abs() * gentle).sqrt());
        let ramp = speed / gentle;
        let cruise = (distance.abs() / speed - ramp).max(0.0);
        self.ramp(at, ramp, speed.copysign(distance), shape);
        self.ramp(at + ramp + cruise, ramp, 0.0, shape)
    }

    /// What is over at `at` [s] is not carried along: a drive may be asked for thousands of changes.
    pub fn forget(&mut self, at: f64) {
        let over = self.ramps.partition_point(|ramp| ramp.at < at).saturating_sub(1);
        self.ramps.drain(..over);
    }
}
