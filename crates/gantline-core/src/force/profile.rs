//! How wind grows with height: its speed over that at the height where it was measured.
//!
//! ```text
//! s(h) = ln(h/h₀)/ln(H/h₀)   or   (h/H)^α        h = z − level, no less than the lowest
//! ```
//!
//! H is the height of the measurement, h₀ the roughness of what it blows over.

/// By what the speed grows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Growth {
    /// The logarithm of the height over a roughness h₀ [m].
    Logarithm(f64),
    /// A power α of the height.
    Power(f64),
}

/// Speed over height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Profile {
    /// z from which heights count [m].
    pub level: f64,
    /// H [m].
    pub height: f64,
    /// Below this height it blows as there [m].
    pub lowest: f64,
    /// How it grows.
    pub growth: Growth,
}

impl Profile {
    /// s at the height z, and its slope there [1/m].
    pub fn share(&self, z: f64) -> (f64, f64) {
        let height = (z - self.level).max(self.lowest);
        let grows = if height > self.lowest { 1.0 } else { 0.0 };
        match self.growth {
            Growth::Logarithm(roughness) => {
                let whole = (self.height / roughness).ln();
                ((height / roughness).ln() / whole, grows / (height * whole))
            }
            Growth::Power(exponent) => {
                let share = (height / self.height).powf(exponent);
                (share, grows * exponent * share / height)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 10 m/s at 10 m over the sea (3 mm, EN 1991-1-4, table 4.1) are 10 ln(100/0.003)/ln(10/0.003) = 12.839 m/s at 100 m;
    /// by the power 0.14 they are 10 · 10^0.14 = 13.804 m/s. Below 1 m it blows as at 1 m. Slopes against differences.
    #[test]
    fn grows_with_height() {
        let of = |growth| Profile { level: 2.0, height: 10.0, lowest: 1.0, growth };
        let sea = of(Growth::Logarithm(0.003));
        let power = of(Growth::Power(0.14));
        assert!((10.0 * sea.share(102.0).0 - 12.838_6).abs() < 1e-4, "{}", sea.share(102.0).0);
        assert!((10.0 * power.share(102.0).0 - 13.803_8).abs() < 1e-4, "{}", power.share(102.0).0);
        for profile in [sea, power] {
            assert!((profile.share(12.0).0 - 1.0).abs() < 1e-15);
            assert_eq!(profile.share(-5.0), (profile.share(3.0).0, 0.0));
            for z in [3.5, 12.0, 80.0] {
                let difference = (profile.share(z + 1e-4).0 - profile.share(z - 1e-4).0) / 2e-4;
                assert!((difference - profile.share(z).1).abs() < 1e-8);
            }
        }
    }
}
