//! How far a drive goes along a way that several drives go together: a series of Chebyshev polynomials.
//!
//! Over the share σ of the way, 0 to 1, with x = 2σ − 1,
//!
//! ```text
//! f(σ) = Σ cₖ Tₖ(x)        T₀ = 1   T₁ = x   Tₖ₊₁ = 2x Tₖ − Tₖ₋₁
//! ```
//!
//! and its derivatives by the derivatives of that recursion. What cranes have to do so that their hooks go along a line is
//! analytic, so that some dozens of terms have it to rounding, and derivatives with it.

use std::sync::Arc;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::course::Motion;

/// A series over the way, which begins at 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// c, of which the first is such that the way begins at 0 [m or rad].
    coefficients: Vec<f64>,
}

/// Value and the first three derivatives over σ.
type Jet = [f64; 4];

impl Series {
    /// The series of `coefficients` less what it is at the beginning [m or rad].
    pub fn new(mut coefficients: Vec<f64>) -> Self {
        let start: f64 = coefficients.iter().enumerate().map(|(k, c)| if k % 2 == 0 { *c } else { -c }).sum();
        if let Some(first) = coefficients.first_mut() {
            *first -= start;
        }
        Self { coefficients }
    }

    /// At σ, where that is 0 exactly 0.
    fn jet(&self, sigma: f64) -> Jet {
        let x = 2.0 * sigma - 1.0;
        let (mut before, mut here) = ([0.0; 4], [1.0, 0.0, 0.0, 0.0]);
        let mut sum = [0.0; 4];
        for (k, c) in self.coefficients.iter().enumerate() {
            for (sum, one) in sum.iter_mut().zip(here) {
                *sum += c * one;
            }
            let factor = if k == 0 { 1.0 } else { 2.0 };
            let next = std::array::from_fn(|order| {
                let product = f64::from(order as u8) * if order == 0 { 0.0 } else { here[order - 1] };
                factor * (x * here[order] + product) - if k == 0 { 0.0 } else { before[order] }
            });
            (before, here) = (here, next);
        }
        let value = if sigma == 0.0 { 0.0 } else { sum[0] };
        [value, 2.0 * sum[1], 4.0 * sum[2], 8.0 * sum[3]]
    }

    /// Where a drive is that goes along it, where `along` is how far that has come: f, f′σ̇, f″σ̇² + f′σ̈.
    pub fn motion(&self, along: Motion) -> Motion {
        let [position, first, second, _] = self.jet(along.position);
        Motion {
            position,
            velocity: first * along.velocity,
            acceleration: second * along.velocity.powi(2) + first * along.acceleration,
        }
    }

    /// Acceleration and its derivative, of the piece of motion along the way that has the acceleration σ̈ and its
    /// derivative: f″σ̇² + f′σ̈ and f‴σ̇³ + 3f″σ̇σ̈ + f′σ⃛.
    pub fn acceleration(&self, along: Motion, (second, third): (f64, f64)) -> (f64, f64) {
        let Motion { position, velocity, .. } = along;
        let [_, f1, f2, f3] = self.jet(position);
        let jerk = f3 * velocity.powi(3) + 3.0 * f2 * velocity * second + f1 * third;
        (f2 * velocity.powi(2) + f1 * second, jerk)
    }
}

/// A saved state has the whole series in it: a run goes on with the same bits.
pub fn save<S: Serializer>(series: &Option<Arc<Series>>, serializer: S) -> Result<S::Ok, S::Error> {
    series.as_ref().map(|one| &one.coefficients).serialize(serializer)
}

/// Takes it up again. Nothing is subtracted once more: it begins at 0 already, but for rounding.
pub fn restore<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Arc<Series>>, D::Error> {
    let given = Option::<Vec<f64>>::deserialize(deserializer)?;
    Ok(given.map(|coefficients| Arc::new(Series { coefficients })))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// cos(2x) = J₀(2) + 2 Σ (−1)ᵏ J₂ₖ(2) T₂ₖ(x), Abramowitz and Stegun 9.1.46: values of the Bessel functions there.
    #[test]
    fn a_series_has_its_function_and_derivatives() {
        let bessel = [
            0.223_890_779_141,
            0.352_834_028_616,
            0.033_995_719_807,
            0.001_202_428_972,
            0.000_022_179_553,
            0.000_000_251_539,
        ];
        let mut coefficients = vec![bessel[0]];
        for (k, value) in bessel.iter().enumerate().skip(1) {
            coefficients.extend([0.0, if k % 2 == 0 { 2.0 } else { -2.0 } * value]);
        }
        let series = Series::new(coefficients);
        for sigma in [0.0, 0.2, 0.5, 0.83, 1.0] {
            let angle = 2.0 * (2.0 * sigma - 1.0);
            let [value, first, second, third] = series.jet(sigma);
            // What is left out, J₁₂(2) = 1.9e-9, has twice T₁₂ and its derivatives, at the ends 144, 6864 and 192 192,
            // times 2, 4 and 8 for σ; the values above end at 5e-13.
            assert!((value - (angle.cos() - (-2.0_f64).cos())).abs() < 1e-8, "{sigma} {value}");
            assert!((first + 4.0 * angle.sin()).abs() < 1.2e-6);
            assert!((second + 16.0 * angle.cos()).abs() < 1.2e-4);
            assert!((third - 64.0 * angle.sin()).abs() < 7e-3);
        }
        assert_eq!(series.jet(0.0)[0], 0.0);
    }

    #[test]
    fn what_goes_along_has_consistent_derivatives() {
        let series = Series::new(vec![0.3, 1.0, -0.4, 0.1, 0.02]);
        // σ = 0.1 + 0.05 t + 0.01 t²
        let along = |t: f64| Motion {
            position: 0.1 + 0.05 * t + 0.01 * t * t,
            velocity: 0.05 + 0.02 * t,
            acceleration: 0.02,
        };
        let (t, d) = (3.0, 1e-4);
        let [before, here, after] = [t - d, t, t + d].map(|t| series.motion(along(t)));
        assert!(((after.position - before.position) / (2.0 * d) - here.velocity).abs() < 1e-9);
        assert!(((after.velocity - before.velocity) / (2.0 * d) - here.acceleration).abs() < 1e-9);
        let (acceleration, jerk) = series.acceleration(along(t), (0.02, 0.0));
        assert_eq!(acceleration, here.acceleration);
        assert!(((after.acceleration - before.acceleration) / (2.0 * d) - jerk).abs() < 1e-9);
    }
}
