//! Cells in layers of four, and the waves at all of them at once.
//!
//! A cell is at P ± r_x ± r_y + n r_z, so that the phase of a wave there is the product of four phasors, and how the wave has
//! decayed one of four exponentials: sines are taken for the lattice and not for each cell.

use glam::{DVec2, DVec3};

use super::trains::{Component, Trains};
use crate::tree::pose::Pose;

/// Cells of a layer.
pub const COLUMNS: usize = 4;
/// Layers, at most.
pub const LAYERS: usize = 16;
/// Cells, at most.
pub const CELLS: usize = COLUMNS * LAYERS;

/// Cells that are all alike.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lattice {
    /// Middle of the lowest layer [m], body frame.
    pub at: DVec3,
    /// Half of the distances of its columns along the x and y of the body [m].
    pub half: DVec2,
    /// From layer to layer along its z, and H [m].
    pub height: f64,
    /// How many layers.
    pub layers: usize,
    /// Of one cell: V [m³].
    pub volume: f64,
    /// A along the axes of the body [kg].
    pub added: DVec3,
    /// c along the axes of the body [N s²/m²].
    pub drag: DVec3,
}

/// A lattice in the world.
#[derive(Debug, Clone, Copy)]
pub struct Grid {
    /// P [m].
    base: DVec3,
    /// r_x, r_y, r_z [m].
    ways: [DVec3; 3],
    layers: usize,
}

impl Lattice {
    /// Where it is with its body at `pose`.
    pub fn grid(&self, pose: &Pose) -> Grid {
        let [x, y, z] = [pose.rotation.x_axis, pose.rotation.y_axis, pose.rotation.z_axis];
        let ways = [x * self.half.x, y * self.half.y, z * self.height];
        Grid { base: pose.point(self.at), ways, layers: self.layers }
    }
}

/// Signs of r_x and r_y of a column.
fn signs(column: usize) -> [f64; 2] {
    [if column < 2 { -1.0 } else { 1.0 }, if column.is_multiple_of(2) { -1.0 } else { 1.0 }]
}

/// A complex number, its sine and cosine part.
type Phasor = (f64, f64);

/// e^{i(a + b)} of both.
fn times((sin, cos): Phasor, (other_sin, other_cos): Phasor) -> Phasor {
    (sin * other_cos + cos * other_sin, cos * other_cos - sin * other_sin)
}

impl Grid {
    /// How many cells it has.
    pub fn count(&self) -> usize {
        COLUMNS * self.layers
    }

    /// Where a cell is [m].
    pub fn place(&self, cell: usize) -> DVec3 {
        let [x, y, z] = self.ways;
        let [along, across] = signs(cell % COLUMNS);
        self.base + x * along + y * across + z * (cell / COLUMNS) as f64
    }

    /// Heights of its lowest and its highest cell along `up` [m].
    pub fn heights(&self, up: DVec3) -> [f64; 2] {
        let [x, y, z] = self.ways.map(|way| way.dot(up));
        let (aside, whole) = (x.abs() + y.abs(), z * (self.layers - 1) as f64);
        let base = self.base.dot(up);
        [base - aside + whole.min(0.0), base + aside + whole.max(0.0)]
    }

    /// Visits every cell with sine and cosine of the phase of a wave there at `time` [s].
    pub fn phases(&self, wave: &Component, time: f64, mut visit: impl FnMut(usize, Phasor)) {
        let turned = |way: DVec3| wave.wave_number.dot(way.truncate()).sin_cos();
        let [x, y, step] = self.ways.map(turned);
        let base = wave.turned(self.base.truncate(), time);
        for column in 0..COLUMNS {
            let [along, across] = signs(column);
            let mut phase = times(times(base, (along * x.0, x.1)), (across * y.0, y.1));
            for layer in 0..self.layers {
                visit(COLUMNS * layer + column, phase);
                phase = times(phase, step);
            }
        }
    }

    /// Sets `out` to what is left of a wave at every cell: C and S of [`super::orbital`], with the heights of the cells above the
    /// still surface [m] and `up` being ẑ.
    pub fn decays(
        &self,
        sea: &Trains,
        wave: &Component,
        (up, heights): (DVec3, &[f64]),
        out: &mut [[f64; 2]],
    ) {
        let number = wave.number;
        let step = (number * self.ways[2].dot(up)).exp();
        let Some(depth) = sea.depth else {
            for column in 0..COLUMNS {
                let mut left = (number * heights[column]).exp();
                for layer in 0..self.layers {
                    let cell = COLUMNS * layer + column;
                    out[cell] = [if heights[cell] < 0.0 { left } else { 1.0 }; 2];
                    left *= step;
                }
            }
            return;
        };
        // By exponents that are never large: the bed may be far below.
        let at_bed = (-number * depth).exp();
        let whole = 1.0 - at_bed * at_bed;
        for column in 0..COLUMNS {
            let mut left = (number * heights[column]).exp();
            let mut back = (-number * (heights[column] + 2.0 * depth)).exp();
            for layer in 0..self.layers {
                let cell = COLUMNS * layer + column;
                let (from_top, from_bed) = if heights[cell] >= 0.0 {
                    (1.0, at_bed * at_bed)
                } else if heights[cell] <= -depth {
                    (at_bed, at_bed)
                } else {
                    (left, back)
                };
                out[cell] = [(from_top + from_bed) / whole, (from_top - from_bed) / whole];
                left *= step;
                back /= step;
            }
        }
    }
}
