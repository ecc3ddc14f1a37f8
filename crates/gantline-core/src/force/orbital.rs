//! How the water moves in waves that come by, to the first order in their height (Airy 1845).
//!
//! With θ = k·x − ω t + ε, κ = |k|, ζ the height above the still surface and d the depth,
//!
//! ```text
//! η = g Σ a cos θ        u = g Σ a ω (k/κ C cos θ + ẑ S sin θ)        u̇ = g Σ a ω² (k/κ C sin θ − ẑ S cos θ)
//! C = cosh κ(ζ + d)/sinh κd        S = sinh κ(ζ + d)/sinh κd        in deep water both e^{κζ}
//! ```
//!
//! Above the still surface the water moves as at it, which linear theory leaves open, and below the bed as there. What the growth g of the waves adds to u̇ is
//! left out.

use glam::{DMat3, DVec2, DVec3};

use super::square::outer;
use super::trains::Trains;

/// The water at a place and a time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Orbital {
    /// u [m/s].
    pub velocity: DVec3,
    /// u̇ [m/s²].
    pub acceleration: DVec3,
}

/// How it changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrbitalChange {
    /// ∂/∂x of velocity and acceleration.
    pub gradient: [DMat3; 2],
    /// ∂/∂t of both at the place.
    pub rate: [DVec3; 2],
}

/// The surface above a place at a time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Surface {
    /// η above the still surface [m].
    pub height: f64,
    /// ∂η/∂x.
    pub slope: DVec2,
    /// ∂η/∂t.
    pub rate: f64,
    /// ∂²η/∂x²: xx, xy, yy.
    pub bend: [f64; 3],
    /// ∂²η/∂x∂t.
    pub slope_rate: DVec2,
    /// ∂²η/∂t².
    pub rate_rate: f64,
}

impl Trains {
    /// The surface above a place [m] at `time` [s].
    pub fn surface(&self, place: DVec2, time: f64) -> Surface {
        let mut sum = Surface::default();
        for wave in &self.components {
            let (k, w, a) = (wave.wave_number, wave.frequency, wave.amplitude);
            let (sin, cos) = wave.turned(place, time);
            let (up, ahead) = (a * cos, a * sin);
            sum.height += up;
            sum.slope -= k * ahead;
            sum.rate += w * ahead;
            for (bend, product) in sum.bend.iter_mut().zip([k.x * k.x, k.x * k.y, k.y * k.y]) {
                *bend -= product * up;
            }
            sum.slope_rate += k * (w * up);
            sum.rate_rate -= w * w * up;
        }
        let ((g, slope), bend) = (self.growth(time), self.growth_bend(time));
        Surface {
            height: g * sum.height,
            slope: sum.slope * g,
            rate: g * sum.rate + slope * sum.height,
            bend: sum.bend.map(|bend| g * bend),
            slope_rate: sum.slope_rate * g + sum.slope * slope,
            rate_rate: g * sum.rate_rate + 2.0 * slope * sum.rate + bend * sum.height,
        }
    }

    /// The water at a place [m], its height above the still surface [m], at `time` [s]; `up` is ẑ.
    pub fn orbital(&self, (place, height): (DVec2, f64), time: f64, up: DVec3) -> Orbital {
        let mut sum = Orbital::default();
        let (height, _) = self.inside(height);
        for wave in &self.components {
            let (sin, cos) = wave.turned(place, time);
            let number = wave.wave_number.length();
            let [c, s] = self.decay(number, height);
            let (swing, along) = (wave.amplitude * wave.frequency, (wave.wave_number / number).extend(0.0));
            sum.velocity += along * (swing * c * cos) + up * (swing * s * sin);
            let pull = swing * wave.frequency;
            sum.acceleration += along * (pull * c * sin) - up * (pull * s * cos);
        }
        let (g, _) = self.growth(time);
        Orbital { velocity: sum.velocity * g, acceleration: sum.acceleration * g }
    }

    /// How that changes; `water` is what is there.
    pub fn orbital_change(
        &self,
        (place, height): (DVec2, f64),
        time: f64,
        up: DVec3,
        water: &Orbital,
    ) -> OrbitalChange {
        let mut sum = OrbitalChange { gradient: [DMat3::ZERO; 2], rate: [DVec3::ZERO; 2] };
        let (height, share) = self.inside(height);
        for wave in &self.components {
            let (k, number) = (wave.wave_number, wave.wave_number.length());
            let (sin, cos) = wave.turned(place, time);
            let [c, s] = self.decay(number, height);
            let (c_slope, s_slope) = (share * number * s, share * number * c);
            let (ahead, along) = (k.extend(0.0), (k / number).extend(0.0));
            let swing = wave.amplitude * wave.frequency;
            let pull = swing * wave.frequency;
            sum.gradient[0] += outer(along * swing, up * (c_slope * cos) - ahead * (c * sin))
                + outer(up * swing, up * (s_slope * sin) + ahead * (s * cos));
            sum.gradient[1] += outer(along * pull, up * (c_slope * sin) + ahead * (c * cos))
                - outer(up * pull, up * (s_slope * cos) - ahead * (s * sin));
            let turn = pull * wave.frequency;
            sum.rate[1] -= along * (turn * c * cos) + up * (turn * s * sin);
        }
        let (g, slope) = self.growth(time);
        // What is there has grown by g already.
        let growing = if g > 0.0 { slope / g } else { 0.0 };
        let rate =
            [water.acceleration + water.velocity * growing, sum.rate[1] * g + water.acceleration * growing];
        OrbitalChange { gradient: sum.gradient.map(|gradient| gradient * g), rate }
    }

    /// A height between bed and still surface, and whether it is as it was, 1 or 0.
    fn inside(&self, height: f64) -> (f64, f64) {
        let bed = -self.depth.unwrap_or(f64::INFINITY);
        (height.clamp(bed, 0.0), if height < 0.0 && height > bed { 1.0 } else { 0.0 })
    }

    /// C and S of a wave number at a height from the bed to the still surface.
    fn decay(&self, number: f64, height: f64) -> [f64; 2] {
        let Some(depth) = self.depth else { return [(number * height).exp(); 2] };
        // By exponents that are never positive: the bed may be far below.
        let (from_top, from_bed) = ((number * height).exp(), (-number * (height + 2.0 * depth)).exp());
        let whole = -(-2.0 * number * depth).exp_m1();
        [(from_top + from_bed) / whole, (from_top - from_bed) / whole]
    }
}
