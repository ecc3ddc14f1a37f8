//! Water around a load that is lowered into it: pressure, water that is accelerated along, blows where it goes in, drag.
//!
//! The load is made of lattices of cells ([`super::lattice`]), each with a share of its volume V, of the added mass A and of the drag c of its three axes. With
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
//! F·v + M·ω + d/dt (½ s v·A v) + U̇ = work − loss        loss = s |w| w·R c Rᵀw + ½ |s′ḣ| w·A w
//! ```
//!
//! Without waves and current the work is zero.

use std::sync::Arc;

use glam::{DMat3, DVec3};

use super::cell::{Share, Wet};
use super::lattice::{CELLS, Grid, Lattice};
use super::orbital::{Water, WaterChange};
use super::square::{Square, outer};
use super::trains::Trains;
use super::{At, Force, Tangent};
use crate::tree::bias::Wrench;
use crate::tree::kinematics::{Kinematics, Twist};
use crate::tree::pose::Pose;

/// A load in water.
#[derive(Debug, Clone)]
pub struct Submerged {
    /// Name.
    pub name: String,
    /// Index of the body.
    pub body: usize,
    /// What it is made of.
    pub lattices: Vec<Lattice>,
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

/// Cells of a lattice, the water at them and how it changes.
struct Cells {
    grid: Grid,
    /// Above the still surface [m].
    heights: [f64; CELLS],
    water: [Water; CELLS],
    changes: [WaterChange; CELLS],
}

/// Over what changes of the water are asked for.
#[derive(Debug, Clone, Copy)]
enum Over {
    Nothing,
    Place,
    Time,
}

impl Submerged {
    /// Cells of a lattice with the water at `time` [s] and how it changes; none where all are dry.
    fn cells(&self, lattice: &Lattice, pose: &Pose, time: f64, over: Over) -> Option<Cells> {
        let (grid, up, sea) = (lattice.grid(pose), self.up, &self.sea);
        if self.is_above_waves(lattice, &grid) {
            return None;
        }
        let count = grid.count();
        let mut cells = Cells {
            grid,
            heights: [0.0; CELLS],
            water: [Water::STILL; CELLS],
            changes: [WaterChange::NONE; CELLS],
        };
        let Cells { heights, water, changes, .. } = &mut cells;
        for (cell, height) in heights[..count].iter_mut().enumerate() {
            *height = up.dot(grid.place(cell)) - self.level;
        }
        if !sea.components.is_empty() {
            sea.water(&grid, time, (up, heights), &mut water[..count]);
            let (water, changes) = (&water[..count], &mut changes[..count]);
            match over {
                Over::Nothing => {}
                Over::Place => sea.over_place(&grid, time, (up, heights), changes),
                Over::Time => sea.over_time(&grid, time, (up, heights, water), changes),
            }
        }
        Some(cells)
    }

    /// True where no crest gets to a cell.
    fn is_above_waves(&self, lattice: &Lattice, grid: &Grid) -> bool {
        grid.heights(self.up)[0] - self.level > self.sea.highest() + lattice.height
    }

    /// True where no trough gets to a cell, so that all are wholly wet.
    fn is_below_waves(&self, lattice: &Lattice, grid: &Grid) -> bool {
        grid.heights(self.up)[1] - self.level < -(self.sea.highest() + lattice.height)
    }

    /// Visits all wet cells, with how the water there changes.
    fn each(&self, at: &At, over: Over, mut visit: impl FnMut(&Wet)) {
        let (turn, up, spin) = (at.pose.rotation, self.up, at.twist.angular);
        for lattice in &self.lattices {
            let Some(cells) = self.cells(lattice, at.pose, at.time, over) else { continue };
            let own = |axes: DVec3| turn * DMat3::from_diagonal(axes) * turn.transpose();
            let (added, resists) = (own(lattice.added), own(lattice.drag));
            for cell in 0..cells.grid.count() {
                let water = cells.water[cell];
                let share = Share::at(water.height - cells.heights[cell], lattice.height);
                if share.value == 0.0 {
                    continue;
                }
                let arm = cells.grid.place(cell) - at.pose.position;
                let velocity = at.twist.at(arm);
                let relative = velocity - water.velocity - self.stream;
                let normal = water.slope.extend(0.0) - up;
                let (speed, along) = (relative.length(), relative.normalize_or_zero());
                let mut wet = Wet {
                    volume: lattice.volume,
                    share,
                    arm,
                    velocity,
                    relative,
                    spin,
                    added,
                    momentum: added * relative,
                    normal,
                    pace: water.rate + normal.dot(velocity),
                    water,
                    changes: cells.changes[cell],
                    up,
                    density: self.density,
                    weight: self.weight,
                    drag: resists * relative * speed,
                    // ∂(|w| w)/∂w = |w| 1 + w wᵀ/|w|.
                    drag_slope: resists
                        * (DMat3::from_diagonal(DVec3::splat(speed)) + outer(relative, along)),
                    whole: DVec3::ZERO,
                };
                let rate = at.rate.at(arm) + spin.cross(spin.cross(arm)) - water.acceleration;
                let pressure = (up * self.weight + water.acceleration * self.density) * lattice.volume;
                wet.whole = pressure - wet.inertia(rate) - wet.drag;
                visit(&wet);
            }
        }
    }

    /// Σ of what a wet cell has.
    fn sum(&self, at: &At, of: impl Fn(&Wet) -> f64) -> f64 {
        let mut sum = 0.0;
        self.each(at, Over::Nothing, |wet| sum += of(wet));
        sum
    }

    /// The same of wrenches.
    fn sum_wrench(&self, at: &At, over: Over, of: impl Fn(&Wet) -> Wrench) -> Wrench {
        let mut sum = Wrench::default();
        self.each(at, over, |wet| {
            let Wrench { force, moment } = of(wet);
            sum.force += force;
            sum.moment += moment;
        });
        sum
    }

    /// Lattices with the places of their cells from the body's origin and how wet these are in still water.
    fn at_rest(&self, pose: &Pose) -> impl Iterator<Item = (&Lattice, DVec3, Share)> {
        self.lattices.iter().flat_map(move |lattice| {
            let grid = lattice.grid(pose);
            (0..grid.count()).map(move |cell| {
                let place = grid.place(cell);
                let share = Share::at(self.level - self.up.dot(place), lattice.height);
                (lattice, place - pose.position, share)
            })
        })
    }

    /// What still water presses the body with, the wrench that has the energy U.
    fn still(&self, pose: &Pose) -> Wrench {
        let mut sum = Wrench::default();
        for (lattice, arm, share) in self.at_rest(pose) {
            let force = self.up * (self.weight * lattice.volume * share.value);
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

    /// What waves and current put in beside [`Submerged::gathered`] under a velocity alone [W].
    pub fn pushed(&self, at: &At) -> f64 {
        self.sum(at, |wet| wet.wrench().power(&at.twist) + wet.loss()) + self.energy_rate(at)
    }

    /// How fast the energy of the water that is accelerated along would grow if the body's velocity stayed [W].
    pub fn gathered(&self, at: &At) -> f64 {
        self.sum(at, Wet::gathered)
    }

    /// True where the surface of the waves may pass one of its cells.
    pub fn may_be_passed(&self, pose: &Pose) -> bool {
        let near = |lattice: &Lattice| {
            let grid = lattice.grid(pose);
            !self.is_above_waves(lattice, &grid) && !self.is_below_waves(lattice, &grid)
        };
        !self.sea.components.is_empty() && self.lattices.iter().any(near)
    }

    /// Volume that is wet [m³].
    pub fn displaced(&self, pose: &Pose, time: f64) -> f64 {
        let mut sum = 0.0;
        self.shares(pose, time, |lattice, _, share| sum += share * lattice.volume);
        sum
    }

    /// Visits all cells that are wet with their places from the body's origin [m] and shares.
    fn shares(&self, pose: &Pose, time: f64, mut visit: impl FnMut(&Lattice, DVec3, f64)) {
        for lattice in &self.lattices {
            let grid = lattice.grid(pose);
            if self.is_above_waves(lattice, &grid) {
                continue;
            }
            let mut surface = [0.0; CELLS];
            // Below the waves all is wholly wet under still water too.
            if !self.is_below_waves(lattice, &grid) {
                self.sea.surface(&grid, time, &mut surface[..grid.count()]);
            }
            for (cell, height) in surface.iter().enumerate().take(grid.count()) {
                let place = grid.place(cell);
                let share = Share::at(height - (self.up.dot(place) - self.level), lattice.height).value;
                if share > 0.0 {
                    visit(lattice, place - pose.position, share);
                }
            }
        }
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
        self.sum_wrench(at, Over::Nothing, Wet::wrench)
    }

    fn tangent(&self, at: &At) -> Tangent {
        let mut sum = Tangent::NONE;
        self.each(at, Over::Place, |wet| {
            sum.place.add(1.0, &wet.derivative(|shift, turn| wet.moved(shift, turn)));
            sum.velocity.add(1.0, &wet.derivative(|linear, spin| wet.sped(linear, spin)));
            let added = Square { linear: wet.added, ..Square::ZERO };
            sum.acceleration.add(-wet.share.value, &added.about(wet.arm));
        });
        sum
    }

    fn energy(&self, pose: &Pose, _gravity: DVec3, _q: &[f64]) -> f64 {
        self.weight * self.at_rest(pose).map(|(lattice, _, share)| lattice.volume * share.sum).sum::<f64>()
    }

    fn energy_rate(&self, at: &At) -> f64 {
        -self.still(at.pose).power(&at.twist)
    }

    fn over_time(&self, at: &At) -> Option<Wrench> {
        let has_waves = !self.sea.components.is_empty();
        has_waves.then(|| self.sum_wrench(at, Over::Time, |wet| wet.change(&wet.later())))
    }

    fn loss(&self, at: &At) -> f64 {
        self.sum(at, Wet::loss)
    }

    fn work(&self, at: &At) -> f64 {
        let [_, work] = self.powers(at);
        work
    }

    fn powers(&self, at: &At) -> [f64; 2] {
        if self.sea.components.is_empty() && self.stream == DVec3::ZERO {
            return [self.loss(at), 0.0];
        }
        // The wrench and the energy of what is accelerated along are alike in v̇.
        let steady = At { rate: Twist::default(), ..*at };
        let (mut lost, mut given) = (0.0, 0.0);
        self.each(&steady, Over::Nothing, |wet| {
            let loss = wet.loss();
            lost += loss;
            given += wet.wrench().power(&at.twist) + wet.gathered() + loss;
        });
        [lost, given + self.energy_rate(at)]
    }

    fn inertia(&self, kinematics: &Kinematics) -> Option<Square> {
        let pose = &kinematics.pose[self.body];
        let turn = pose.rotation;
        let mut sum = Square::ZERO;
        self.shares(pose, kinematics.time, |lattice, arm, share| {
            let added = turn * DMat3::from_diagonal(lattice.added) * turn.transpose();
            sum.add(share, &Square { linear: added, ..Square::ZERO }.about(arm));
        });
        Some(sum)
    }
}
