//! How the water moves in waves that come by, to the first order in their height (Airy 1845).
//!
//! With θ = k·x − ω t + ε, κ = |k|, ζ the height above the still surface and d the depth,
//!
//! ```text
//! η = g Σ a cos θ        u = g Σ a ω (k/κ C cos θ + ẑ S sin θ)        u̇ = g Σ a ω² (k/κ C sin θ − ẑ S cos θ) + u ġ/g
//! C = cosh κ(ζ + d)/sinh κd        S = sinh κ(ζ + d)/sinh κd        in deep water both e^{κζ}
//! ```
//!
//! Above the still surface the water moves as at it, which linear theory leaves open, and below the bed as there. While the waves
//! grow u̇ has the rate of g too: what floats without a trace goes on as the water does.

use glam::{DMat3, DVec2, DVec3};

use super::lattice::{CELLS, Grid};
use super::square::outer;
use super::trains::Trains;

/// The water at a place and a time, and the surface above it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Water {
    /// η above the still surface [m].
    pub height: f64,
    /// ∂η/∂x.
    pub slope: DVec2,
    /// ∂η/∂t.
    pub rate: f64,
    /// u [m/s].
    pub velocity: DVec3,
    /// u̇ [m/s²].
    pub acceleration: DVec3,
}

impl Water {
    /// Water that stands.
    pub const STILL: Self =
        Self { height: 0.0, slope: DVec2::ZERO, rate: 0.0, velocity: DVec3::ZERO, acceleration: DVec3::ZERO };
}

/// How that changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaterChange {
    /// ∂²η/∂x²: xx, xy, yy.
    pub bend: [f64; 3],
    /// ∂²η/∂x∂t.
    pub slope_rate: DVec2,
    /// ∂²η/∂t².
    pub rate_rate: f64,
    /// ∂/∂x of u and u̇.
    pub gradient: [DMat3; 2],
    /// ∂/∂t of both at the place.
    pub pace: [DVec3; 2],
}

impl WaterChange {
    /// That of water that stands.
    pub const NONE: Self = Self {
        bend: [0.0; 3],
        slope_rate: DVec2::ZERO,
        rate_rate: 0.0,
        gradient: [DMat3::ZERO; 2],
        pace: [DVec3::ZERO; 2],
    };
}

impl Trains {
    /// Sets `out` to the water at every cell at `time` [s]; `up` is ẑ, and `heights` are those of the cells above the still
    /// surface [m].
    pub fn water(&self, grid: &Grid, time: f64, (up, heights): (DVec3, &[f64]), out: &mut [Water]) {
        out.fill(Water::STILL);
        let mut decays = [[0.0; 2]; CELLS];
        for wave in &self.components {
            grid.decays(self, wave, (up, heights), &mut decays);
            let (k, w) = (wave.wave_number, wave.frequency);
            let along = (k / wave.number).extend(0.0);
            grid.phases(wave, time, |cell, (sin, cos)| {
                let (sum, [c, s]) = (&mut out[cell], decays[cell]);
                let (crest, ahead) = (wave.amplitude * cos, wave.amplitude * sin);
                sum.height += crest;
                sum.slope -= k * ahead;
                sum.rate += w * ahead;
                sum.velocity += along * (w * c * crest) + up * (w * s * ahead);
                sum.acceleration += along * (w * w * c * ahead) - up * (w * w * s * crest);
            });
        }
        let (g, growing) = self.growth(time);
        for sum in out {
            *sum = Water {
                height: g * sum.height,
                slope: sum.slope * g,
                rate: g * sum.rate + growing * sum.height,
                velocity: sum.velocity * g,
                acceleration: sum.acceleration * g + sum.velocity * growing,
            };
        }
    }

    /// Sets `out` to the height of the surface over every cell at `time` [s], that of [`Trains::water`] [m].
    pub fn surface(&self, grid: &Grid, time: f64, out: &mut [f64]) {
        out.fill(0.0);
        for wave in &self.components {
            grid.phases(wave, time, |cell, (_, cos)| out[cell] += wave.amplitude * cos);
        }
        let (g, _) = self.growth(time);
        for height in out {
            *height *= g;
        }
    }

    /// Sets in `out` how that changes with the place.
    pub fn over_place(
        &self,
        grid: &Grid,
        time: f64,
        (up, heights): (DVec3, &[f64]),
        out: &mut [WaterChange],
    ) {
        let (g, growing) = self.growth(time);
        let bed = -self.depth.unwrap_or(f64::INFINITY);
        let mut decays = [[0.0; 2]; CELLS];
        for wave in &self.components {
            grid.decays(self, wave, (up, heights), &mut decays);
            let (k, w, number) = (wave.wave_number, wave.frequency, wave.number);
            let (ahead, along) = (k.extend(0.0), (k / number).extend(0.0));
            grid.phases(wave, time, |cell, (sin, cos)| {
                let (sum, [c, s]) = (&mut out[cell], decays[cell]);
                let is_inside = heights[cell] < 0.0 && heights[cell] > bed;
                let [c_slope, s_slope] = if is_inside { [number * s, number * c] } else { [0.0; 2] };
                let [high, swing, pull] = [1.0, w, w * w].map(|factor| g * wave.amplitude * factor);
                for (bend, product) in sum.bend.iter_mut().zip([k.x * k.x, k.x * k.y, k.y * k.y]) {
                    *bend -= product * high * cos;
                }
                sum.slope_rate += k * (swing * cos - growing * wave.amplitude * sin);
                sum.gradient[0] += outer(along * swing, up * (c_slope * cos) - ahead * (c * sin))
                    + outer(up * swing, up * (s_slope * sin) + ahead * (s * cos));
                sum.gradient[1] += outer(along * pull, up * (c_slope * sin) + ahead * (c * cos))
                    - outer(up * pull, up * (s_slope * cos) - ahead * (s * sin));
            });
        }
        // What is there has grown by g already.
        let grows = if g > 0.0 { growing / g } else { 0.0 };
        for sum in out {
            sum.gradient[1] += sum.gradient[0] * grows;
        }
    }

    /// Sets in `out` how it changes as time goes on; `water` is what is there.
    pub fn over_time(
        &self,
        grid: &Grid,
        time: f64,
        (up, heights, water): (DVec3, &[f64], &[Water]),
        out: &mut [WaterChange],
    ) {
        let ((g, growing), bending) = (self.growth(time), self.growth_bend(time));
        let mut decays = [[0.0; 2]; CELLS];
        for wave in &self.components {
            grid.decays(self, wave, (up, heights), &mut decays);
            let (k, w) = (wave.wave_number, wave.frequency);
            let along = (k / wave.number).extend(0.0);
            grid.phases(wave, time, |cell, (sin, cos)| {
                let (sum, [c, s]) = (&mut out[cell], decays[cell]);
                let [swing, pull] = [w, w * w].map(|factor| g * wave.amplitude * factor);
                sum.slope_rate += k * (swing * cos - growing * wave.amplitude * sin);
                sum.rate_rate -=
                    pull * cos - 2.0 * growing * wave.amplitude * w * sin - bending * wave.amplitude * cos;
                sum.pace[1] -= along * (w * pull * c * cos) + up * (w * pull * s * sin);
            });
        }
        // What is there has grown by g already.
        let [grows, bends] = if g > 0.0 { [growing / g, bending / g] } else { [0.0; 2] };
        for (sum, here) in out.iter_mut().zip(water) {
            sum.pace[0] = here.acceleration;
            // ü = g ∂³ + 2 ġ ∂² + g̈ ∂ of the sum, of which u̇ has ġ ∂ beside g ∂².
            sum.pace[1] +=
                (here.acceleration - here.velocity * grows) * (2.0 * grows) + here.velocity * bends;
        }
    }
}
