//! What water does to one cell of a load: the law of [`super::submerged`], and how it changes.

use glam::{DMat3, DVec3};

use super::orbital::{Water, WaterChange};
use super::square::Square;
use crate::tree::bias::Wrench;

/// How wet a cell is: s, s′ [1/m], s″ [1/m²] and ∫ s dh [m], by its depth.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Share {
    pub(super) value: f64,
    pub(super) slope: f64,
    pub(super) bend: f64,
    pub(super) sum: f64,
}

impl Share {
    pub(super) fn at(depth: f64, height: f64) -> Self {
        let t = depth / height;
        if t <= -1.0 {
            return Self::default();
        }
        if t >= 1.0 {
            return Self { value: 1.0, slope: 0.0, bend: 0.0, sum: depth };
        }
        let (off, bend) = (1.0 - t.abs(), 1.0 / (height * height));
        let (square, cube) = (0.5 * off * off, height * off * off * off / 6.0);
        let (value, bend, sum) =
            if t < 0.0 { (square, bend, cube) } else { (1.0 - square, -bend, depth + cube) };
        Self { value, slope: off / height, bend, sum }
    }
}

/// A cell that is wet, world axes.
pub(super) struct Wet {
    /// V [m³].
    pub(super) volume: f64,
    pub(super) share: Share,
    /// r, v, w and ω.
    pub(super) arm: DVec3,
    pub(super) velocity: DVec3,
    pub(super) relative: DVec3,
    pub(super) spin: DVec3,
    /// A, and A w.
    pub(super) added: DMat3,
    pub(super) momentum: DVec3,
    /// ∇h, and ḣ.
    pub(super) normal: DVec3,
    pub(super) pace: f64,
    pub(super) water: Water,
    pub(super) changes: WaterChange,
    /// ẑ, ρ [kg/m³] and ρ g [N/m³].
    pub(super) up: DVec3,
    pub(super) density: f64,
    pub(super) weight: f64,
    /// c |w| Rᵀw in world axes, and its derivative over w.
    pub(super) drag: DVec3,
    pub(super) drag_slope: DMat3,
    /// Pressure less inertia and drag of all of it, without s.
    pub(super) whole: DVec3,
}

/// A small change of what a cell feels.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Change {
    /// Of h, and of ḣ.
    pub(super) depth: f64,
    pub(super) pace: f64,
    /// Of w, v̇ − u̇, u̇, ẑ and ω.
    pub(super) relative: DVec3,
    pub(super) rate: DVec3,
    pub(super) water: DVec3,
    pub(super) up: DVec3,
    pub(super) spin: DVec3,
}

impl Wet {
    /// Rate of the momentum of what is wet, without s.
    pub(super) fn inertia(&self, rate: DVec3) -> DVec3 {
        self.added * (rate - self.spin.cross(self.relative)) + self.spin.cross(self.momentum)
    }

    /// s′ḣ⁺.
    pub(super) fn entry(&self) -> f64 {
        self.share.slope * self.pace.max(0.0)
    }

    pub(super) fn wrench(&self) -> Wrench {
        let force = self.whole * self.share.value - self.momentum * self.entry();
        let moment = self.arm.cross(force) - self.relative.cross(self.momentum) * self.share.value;
        Wrench { force, moment }
    }

    /// How the wrench changes.
    pub(super) fn change(&self, change: &Change) -> Wrench {
        let Share { value, slope, bend, .. } = self.share;
        let Change { depth, pace, relative, rate, water, up, spin } = *change;
        let entering = if self.pace > 0.0 { bend * depth * self.pace + slope * pace } else { 0.0 };
        let momentum = self.added * relative;
        let pressure = (up * self.weight + water * self.density) * self.volume;
        let inertia = self.added * (rate - spin.cross(self.relative) - self.spin.cross(relative))
            + spin.cross(self.momentum)
            + self.spin.cross(momentum);
        let whole = pressure - inertia - self.drag_slope * relative;
        let force =
            self.whole * (slope * depth) + whole * value - self.momentum * entering - momentum * self.entry();
        let swept = self.relative.cross(self.momentum) * (slope * depth)
            + (relative.cross(self.momentum) + self.relative.cross(momentum)) * value;
        Wrench { force, moment: self.arm.cross(force) - swept }
    }

    /// That of a motion of the body as seen from there: water, surface and plumb turn the other way.
    pub(super) fn moved(&self, shift: DVec3, turn: DVec3) -> Change {
        let place = shift + turn.cross(self.arm);
        let WaterChange { bend: [xx, xy, yy], slope_rate, gradient, .. } = self.changes;
        let Self { velocity, normal, .. } = *self;
        let bent = DVec3::new(xx * velocity.x + xy * velocity.y, xy * velocity.x + yy * velocity.y, 0.0);
        let pace = (bent + slope_rate.extend(0.0)).dot(place) + velocity.cross(normal).dot(turn);
        let fluid = velocity - self.relative;
        let relative = turn.cross(fluid) - gradient[0] * place;
        let water = gradient[1] * place - turn.cross(self.water.acceleration);
        Change {
            depth: normal.dot(place),
            pace,
            relative,
            rate: -water,
            water,
            up: -turn.cross(self.up),
            spin: DVec3::ZERO,
        }
    }

    /// That of its velocity.
    pub(super) fn sped(&self, linear: DVec3, spin: DVec3) -> Change {
        let relative = linear + spin.cross(self.arm);
        let rate = spin.cross(self.spin.cross(self.arm)) + self.spin.cross(spin.cross(self.arm));
        Change { pace: self.normal.dot(relative), relative, rate, spin, ..Change::default() }
    }

    /// That of time alone.
    pub(super) fn later(&self) -> Change {
        let WaterChange { slope_rate, rate_rate, pace: [fluid, water], .. } = self.changes;
        Change {
            depth: self.water.rate,
            pace: rate_rate + slope_rate.extend(0.0).dot(self.velocity),
            relative: -fluid,
            rate: -water,
            water,
            ..Change::default()
        }
    }

    /// Derivatives of the wrench over a motion, of which `change` says what the cell feels of it.
    pub(super) fn derivative(&self, change: impl Fn(DVec3, DVec3) -> Change) -> Square {
        let by = |linear: DVec3, angular: DVec3| self.change(&change(linear, angular));
        let linear = DVec3::AXES.map(|axis| by(axis, DVec3::ZERO));
        let angular = DVec3::AXES.map(|axis| by(DVec3::ZERO, axis));
        let columns = |of: [DVec3; 3]| DMat3::from_cols(of[0], of[1], of[2]);
        Square {
            linear: columns(linear.map(|wrench| wrench.force)),
            cross: columns(angular.map(|wrench| wrench.force)),
            back: columns(linear.map(|wrench| wrench.moment)),
            angular: columns(angular.map(|wrench| wrench.moment)),
        }
    }

    /// s |w| w·R c Rᵀw + ½ |s′ḣ| w·A w.
    pub(super) fn loss(&self) -> f64 {
        self.share.value * self.drag.dot(self.relative)
            + 0.5 * (self.share.slope * self.pace).abs() * self.relative.dot(self.momentum)
    }

    /// d/dt ½ s v·A v while the velocity of the body stays.
    pub(super) fn gathered(&self) -> f64 {
        let Self { velocity, spin, .. } = *self;
        let moved = self.added * velocity;
        let turned = spin.cross(moved) + self.added * spin.cross(spin.cross(self.arm));
        0.5 * self.share.slope * self.pace * velocity.dot(moved) + self.share.value * velocity.dot(turned)
    }
}
