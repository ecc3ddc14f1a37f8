//! Water around a load that is lowered into it: pressure, water that is accelerated along, blows where it goes in, drag.
//!
//! The load is a lattice of cells, each with a share of its volume V, of the added mass A and of the drag c of its three axes. With
//! h the depth of a cell below the surface of the moment and s(h) the wet share of it,
//!
//! ```text
//! F = s ρV (g ẑ + u̇) − s (A (v̇ − u̇) + ω × A w − A (ω × w)) − s′ḣ⁺ A w − s R c |w| Rᵀw        M = r × F − s w × A w
//! ```
//!
//! u is the velocity of the water there, of waves and current ([`super::orbital`]), w = v − u. The first part is the pressure of the
//! water as if the cell were not there, the second the rate of the momentum s A w of what is accelerated along, along the axes of
//! the body, with the moment of [`super::added_mass`]; what becomes wet takes momentum, the third part, and
//! what becomes dry leaves it to the water. So half of the work of the blow is in the water that is accelerated along, and half in spray.
//!
//! A cell gets wet over twice its height 2H, from h = −H to h = H, with a hat for s′, so that cells side by side make even shares
//! of the depth.
//!
//! Power of all that, with the energy ½ s v·A v that the mass matrix has and U = ρ g V ∫ s dh of still water, is
//!
//! ```text
//! F·v + M·ω + d/dt (½ s v·A v) + U̇ = work − loss        loss = s c |w|³ + ½ |s′ḣ| w·A w
//! ```
//!
//! Without waves and current the work is zero.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::orbital::{Orbital, OrbitalChange, Surface};
use super::square::{Square, outer};
use super::trains::Trains;
use super::{At, Force, Tangent};
use crate::tree::bias::Wrench;
use crate::tree::kinematics::{Kinematics, Twist};
use crate::tree::pose::Pose;

/// A part of a load in water.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cell {
    /// Its middle [m], body frame.
    pub at: DVec3,
    /// H [m].
    pub height: f64,
    /// V [m³].
    pub volume: f64,
    /// A along the axes of the body [kg].
    pub added: DVec3,
    /// c along the axes of the body [N s²/m²].
    pub drag: DVec3,
}

/// A load in water.
#[derive(Debug, Clone)]
pub struct Submerged {
    /// Name.
    pub name: String,
    /// Index of the body.
    pub body: usize,
    /// What it is made of.
    pub cells: Vec<Cell>,
    /// ρ [kg/m³].
    pub density: f64,
    /// ẑ, and ρ g [N/m³].
    pub up: DVec3,
    /// See `up`.
    pub weight: f64,
    /// Height of the still surface above the world's origin [m].
    pub level: f64,
    /// Velocity of the current [m/s], world axes.
    pub stream: DVec3,
    /// The waves.
    pub sea: Arc<Trains>,
}

/// How wet a cell is: s, s′ [1/m], s″ [1/m²] and ∫ s dh [m], by its depth.
#[derive(Debug, Clone, Copy, Default)]
struct Share {
    value: f64,
    slope: f64,
    bend: f64,
    sum: f64,
}

impl Share {
    fn at(depth: f64, height: f64) -> Self {
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
struct Wet<'a> {
    cell: &'a Cell,
    share: Share,
    /// r, v, w and ω.
    arm: DVec3,
    velocity: DVec3,
    relative: DVec3,
    spin: DVec3,
    /// A, and A w.
    added: DMat3,
    momentum: DVec3,
    /// ∇h, and ḣ.
    normal: DVec3,
    pace: f64,
    surface: Surface,
    water: Orbital,
    /// ẑ, ρ [kg/m³] and ρ g [N/m³].
    up: DVec3,
    density: f64,
    weight: f64,
    /// c |w| Rᵀw in world axes, and its derivative over w.
    drag: DVec3,
    drag_slope: DMat3,
    /// W − I − D of what is wholly wet, see [`Wet::whole`].
    whole: DVec3,
}

/// A small change of what a cell feels.
#[derive(Debug, Clone, Copy, Default)]
struct Change {
    /// Of h, and of ḣ.
    depth: f64,
    pace: f64,
    /// Of w, v̇ − u̇, u̇, ẑ and ω.
    relative: DVec3,
    rate: DVec3,
    water: DVec3,
    up: DVec3,
    spin: DVec3,
}

impl Wet<'_> {
    /// Rate of the momentum of what is wet, without s.
    fn inertia(&self, rate: DVec3) -> DVec3 {
        self.added * (rate - self.spin.cross(self.relative)) + self.spin.cross(self.momentum)
    }

    /// s′ḣ⁺.
    fn entry(&self) -> f64 {
        self.share.slope * self.pace.max(0.0)
    }

    fn wrench(&self) -> Wrench {
        let force = self.whole * self.share.value - self.momentum * self.entry();
        let moment = self.arm.cross(force) - self.relative.cross(self.momentum) * self.share.value;
        Wrench { force, moment }
    }

    /// How the wrench changes.
    fn change(&self, change: &Change) -> Wrench {
        let Share { value, slope, bend, .. } = self.share;
        let Change { depth, pace, relative, rate, water, up, spin } = *change;
        let entering = if self.pace > 0.0 { bend * depth * self.pace + slope * pace } else { 0.0 };
        let momentum = self.added * relative;
        let pressure = (up * self.weight + water * self.density) * self.cell.volume;
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
    fn moved(&self, around: &OrbitalChange, shift: DVec3, turn: DVec3) -> Change {
        let place = shift + turn.cross(self.arm);
        let Surface { bend: [xx, xy, yy], slope_rate, .. } = self.surface;
        let Self { velocity, normal, water, .. } = self;
        let bent = DVec3::new(xx * velocity.x + xy * velocity.y, xy * velocity.x + yy * velocity.y, 0.0);
        let pace = (bent + slope_rate.extend(0.0)).dot(place) + velocity.cross(*normal).dot(turn);
        let fluid = *velocity - self.relative;
        let relative = turn.cross(fluid) - around.gradient[0] * place;
        let water = around.gradient[1] * place - turn.cross(water.acceleration);
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
    fn sped(&self, linear: DVec3, spin: DVec3) -> Change {
        let relative = linear + spin.cross(self.arm);
        let rate = spin.cross(self.spin.cross(self.arm)) + self.spin.cross(spin.cross(self.arm));
        Change { pace: self.normal.dot(relative), relative, rate, spin, ..Change::default() }
    }

    /// That of time alone.
    fn later(&self, around: &OrbitalChange) -> Change {
        let Surface { rate, slope_rate, rate_rate, .. } = self.surface;
        let [fluid, water] = around.rate;
        Change {
            depth: rate,
            pace: rate_rate + slope_rate.extend(0.0).dot(self.velocity),
            relative: -fluid,
            rate: -water,
            water,
            ..Change::default()
        }
    }

    /// Derivatives of the wrench over a motion, of which `change` says what the cell feels of it.
    fn derivative(&self, change: impl Fn(DVec3, DVec3) -> Change) -> Square {
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

    /// s c |w|³ + ½ |s′ḣ| w·A w.
    fn loss(&self) -> f64 {
        self.share.value * self.drag.dot(self.relative)
            + 0.5 * (self.share.slope * self.pace).abs() * self.relative.dot(self.momentum)
    }

    /// d/dt ½ s v·A v while the velocity of the body stays.
    fn gathered(&self) -> f64 {
        let Self { velocity, spin, .. } = *self;
        let moved = self.added * velocity;
        let turned = spin.cross(moved) + self.added * spin.cross(spin.cross(self.arm));
        0.5 * self.share.slope * self.pace * velocity.dot(moved) + self.share.value * velocity.dot(turned)
    }
}

impl Submerged {
    /// Cells that are wet where the body is at `pose`, with the places from its origin [m] and their surfaces and shares.
    fn wet_at(&self, pose: &Pose, time: f64) -> impl Iterator<Item = (&Cell, DVec3, f64, Surface, Share)> {
        let highest = self.sea.highest();
        self.cells.iter().filter_map(move |cell| {
            let arm = pose.rotation * cell.at;
            let place = pose.position + arm;
            let height = self.up.dot(place) - self.level;
            if height > highest + cell.height {
                return None;
            }
            let surface = self.sea.surface(place.truncate(), time);
            let share = Share::at(surface.height - height, cell.height);
            (share.value > 0.0).then_some((cell, arm, height, surface, share))
        })
    }

    fn wet<'a>(&'a self, at: &'a At) -> impl Iterator<Item = Wet<'a>> {
        let (turn, up) = (at.pose.rotation, self.up);
        self.wet_at(at.pose, at.time).map(move |(cell, arm, height, surface, share)| {
            let place = (at.pose.position + arm).truncate();
            let water = self.sea.orbital((place, height), at.time, up);
            let spin = at.twist.angular;
            let velocity = at.twist.at(arm);
            let relative = velocity - water.velocity - self.stream;
            let own = |axes: DVec3| turn * DMat3::from_diagonal(axes) * turn.transpose();
            let (added, resists) = (own(cell.added), own(cell.drag));
            let normal = surface.slope.extend(0.0) - up;
            let (speed, along) = (relative.length(), relative.normalize_or_zero());
            let mut wet = Wet {
                cell,
                share,
                arm,
                velocity,
                relative,
                spin,
                added,
                momentum: added * relative,
                normal,
                pace: surface.rate + normal.dot(velocity),
                surface,
                water,
                up,
                density: self.density,
                weight: self.weight,
                drag: resists * relative * speed,
                // ∂(|w| w)/∂w = |w| 1 + w wᵀ/|w|.
                drag_slope: resists * (DMat3::from_diagonal(DVec3::splat(speed)) + outer(relative, along)),
                whole: DVec3::ZERO,
            };
            let rate = at.rate.at(arm) + spin.cross(spin.cross(arm)) - water.acceleration;
            let pressure = (up * self.weight + water.acceleration * self.density) * cell.volume;
            wet.whole = pressure - wet.inertia(rate) - wet.drag;
            wet
        })
    }

    /// How the water around a cell changes.
    fn around(&self, wet: &Wet, at: &At) -> OrbitalChange {
        let place = at.pose.position + wet.arm;
        let height = self.up.dot(place) - self.level;
        self.sea.orbital_change((place.truncate(), height), at.time, self.up, &wet.water)
    }

    /// What still water presses the body with, the wrench that has the energy U.
    fn still(&self, pose: &Pose) -> Wrench {
        let mut sum = Wrench::default();
        for cell in &self.cells {
            let arm = pose.rotation * cell.at;
            let share = Share::at(self.level - self.up.dot(pose.position + arm), cell.height);
            let force = self.up * (self.weight * cell.volume * share.value);
            sum.force += force;
            sum.moment += arm.cross(force);
        }
        sum
    }

    /// The wrench less that of still water: what flows, and what resists.
    pub fn resisting(&self, at: &At) -> Wrench {
        let (whole, still) = (self.wrench(at), self.still(at.pose));
        Wrench { force: whole.force - still.force, moment: whole.moment - still.moment }
    }

    /// How fast the energy of the water that is accelerated along would grow if the body's velocity stayed [W].
    pub fn gathered(&self, at: &At) -> f64 {
        self.wet(at).map(|wet| wet.gathered()).sum()
    }

    /// True where the surface of the waves may pass one of its cells.
    pub fn may_be_passed(&self, pose: &Pose) -> bool {
        let highest = self.sea.highest();
        highest > 0.0
            && self.cells.iter().any(|cell| {
                let height = self.up.dot(pose.point(cell.at)) - self.level;
                height.abs() < highest + cell.height
            })
    }

    /// Volume that is wet [m³].
    pub fn displaced(&self, pose: &Pose, time: f64) -> f64 {
        self.wet_at(pose, time).map(|(cell, _, _, _, share)| share.value * cell.volume).sum()
    }
}

impl Force for Submerged {
    fn name(&self) -> &str {
        &self.name
    }

    fn body(&self) -> usize {
        self.body
    }

    fn wrench(&self, at: &At) -> Wrench {
        let mut sum = Wrench::default();
        for wet in self.wet(at) {
            let Wrench { force, moment } = wet.wrench();
            sum.force += force;
            sum.moment += moment;
        }
        sum
    }

    fn tangent(&self, at: &At) -> Tangent {
        let mut sum = Tangent::NONE;
        for wet in self.wet(at) {
            let around = self.around(&wet, at);
            sum.place.add(1.0, &wet.derivative(|shift, turn| wet.moved(&around, shift, turn)));
            sum.velocity.add(1.0, &wet.derivative(|linear, spin| wet.sped(linear, spin)));
            let added = Square { linear: wet.added, ..Square::ZERO };
            sum.acceleration.add(-wet.share.value, &added.about(wet.arm));
        }
        sum
    }

    fn energy(&self, pose: &Pose, _gravity: DVec3, _q: &[f64]) -> f64 {
        let of_cell = |cell: &Cell| {
            let depth = self.level - self.up.dot(pose.position + pose.rotation * cell.at);
            cell.volume * Share::at(depth, cell.height).sum
        };
        self.weight * self.cells.iter().map(of_cell).sum::<f64>()
    }

    fn energy_rate(&self, at: &At) -> f64 {
        -self.still(at.pose).power(&at.twist)
    }

    fn over_time(&self, at: &At) -> Option<Wrench> {
        if self.sea.components.is_empty() {
            return None;
        }
        let mut sum = Wrench::default();
        for wet in self.wet(at) {
            let Wrench { force, moment } = wet.change(&wet.later(&self.around(&wet, at)));
            sum.force += force;
            sum.moment += moment;
        }
        Some(sum)
    }

    fn loss(&self, at: &At) -> f64 {
        self.wet(at).map(|wet| wet.loss()).sum()
    }

    fn work(&self, at: &At) -> f64 {
        if self.sea.components.is_empty() && self.stream == DVec3::ZERO {
            return 0.0;
        }
        // The wrench and the energy of what is accelerated along are alike in v̇.
        let steady = At { rate: Twist::default(), ..*at };
        let of_cell = |wet: Wet| wet.wrench().power(&at.twist) + wet.gathered() + wet.loss();
        self.wet(&steady).map(of_cell).sum::<f64>() + self.energy_rate(at)
    }

    fn inertia(&self, kinematics: &Kinematics) -> Option<Square> {
        let pose = &kinematics.pose[self.body];
        let turn = pose.rotation;
        let mut sum = Square::ZERO;
        for (cell, arm, _, _, share) in self.wet_at(pose, kinematics.time) {
            let added = turn * DMat3::from_diagonal(cell.added) * turn.transpose();
            let part = Square { linear: added, ..Square::ZERO };
            sum.add(share.value, &part.about(arm));
        }
        Some(sum)
    }
}
