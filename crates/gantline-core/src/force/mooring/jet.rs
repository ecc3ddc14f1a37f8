//! A number with its first and second derivatives over three others: formulas are written once, and differentiated by
//! the rules of calculus.

use std::ops::{Add, Div, Mul, Sub};

/// A value, its gradient and its symmetric second derivatives; these are left out where N is 0, else 3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jet<const N: usize = 3> {
    /// Value.
    pub value: f64,
    /// First derivatives.
    pub first: [f64; 3],
    /// Second derivatives.
    pub second: [[f64; 3]; N],
}

impl<const N: usize> Jet<N> {
    /// A constant.
    pub const fn constant(value: f64) -> Self {
        Self { value, first: [0.0; 3], second: [[0.0; 3]; N] }
    }

    /// One of the three that derivatives are over.
    pub const fn variable(value: f64, which: usize) -> Self {
        let mut jet = Self::constant(value);
        jet.first[which] = 1.0;
        jet
    }

    /// f of it, from f, f′ and f″ at its value.
    pub fn of(&self, [f, slope, bend]: [f64; 3]) -> Self {
        Self {
            value: f,
            first: self.first.map(|x| slope * x),
            second: std::array::from_fn(|i| {
                std::array::from_fn(|j| slope * self.second[i][j] + bend * self.first[i] * self.first[j])
            }),
        }
    }

    /// √ of it.
    pub fn sqrt(&self) -> Self {
        let root = self.value.sqrt();
        self.of([root, 0.5 / root, -0.25 / (root * self.value)])
    }

    /// ln(1 + y)/y of it.
    pub fn log_ratio(&self) -> Self {
        self.of(log_ratio(self.value))
    }

    /// 1/x of it.
    fn inverse(&self) -> Self {
        let inverse = 1.0 / self.value;
        let square = inverse * inverse;
        self.of([inverse, -square, 2.0 * square * inverse])
    }

    /// Linear in the values and derivatives of both.
    fn with(&self, other: &Self, of: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            value: of(self.value, other.value),
            first: std::array::from_fn(|i| of(self.first[i], other.first[i])),
            second: std::array::from_fn(|i| {
                std::array::from_fn(|j| of(self.second[i][j], other.second[i][j]))
            }),
        }
    }
}

impl<const N: usize> Add for Jet<N> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.with(&other, |a, b| a + b)
    }
}

impl<const N: usize> Sub for Jet<N> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.with(&other, |a, b| a - b)
    }
}

impl<const N: usize> Mul for Jet<N> {
    type Output = Self;

    // A product's derivatives are sums.
    #[allow(clippy::suspicious_arithmetic_impl)]
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            first: std::array::from_fn(|i| self.first[i] * other.value + self.value * other.first[i]),
            second: std::array::from_fn(|i| {
                std::array::from_fn(|j| {
                    self.second[i][j] * other.value
                        + self.first[i] * other.first[j]
                        + self.first[j] * other.first[i]
                        + self.value * other.second[i][j]
                })
            }),
        }
    }
}

impl<const N: usize> Mul<f64> for Jet<N> {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        self.with(&self, |a, _| factor * a)
    }
}

impl<const N: usize> Div for Jet<N> {
    type Output = Self;

    // What is divided by is inverted first.
    #[allow(clippy::suspicious_arithmetic_impl)]
    fn div(self, other: Self) -> Self {
        self * other.inverse()
    }
}

/// Where ln(1 + y)/y is summed as a series: there its derivatives would cancel.
const SERIES: f64 = 0.05;
/// Terms of the series: the next is below rounding at [`SERIES`].
const TERMS: i32 = 14;

/// ln(1 + y)/y with its first two derivatives.
fn log_ratio(y: f64) -> [f64; 3] {
    if y.abs() > SERIES {
        let f = y.ln_1p() / y;
        let slope = (1.0 / (1.0 + y) - f) / y;
        return [f, slope, (-1.0 / ((1.0 + y) * (1.0 + y)) - 2.0 * slope) / y];
    }
    // Σ (−y)^k/(k + 1)
    let mut sum = [0.0; 3];
    for k in (0..TERMS).rev() {
        let factor = if k % 2 == 0 { 1.0 } else { -1.0 } / f64::from(k + 1);
        let order = f64::from(k);
        sum[0] += factor * y.powi(k);
        if k > 0 {
            sum[1] += factor * order * y.powi(k - 1);
        }
        if k > 1 {
            sum[2] += factor * order * (order - 1.0) * y.powi(k - 2);
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of a formula that uses every rule, against central differences: their own error is some 1e-6 of the second.
    #[test]
    fn derivatives_are_those_of_differences() {
        let formula = |x: [f64; 3]| {
            let [a, b, c] = [0, 1, 2].map(|k| Jet::<3>::variable(x[k], k));
            ((a * b + c * 2.0).sqrt() / (b - a * 0.1) + (a * c).log_ratio()) * c
        };
        for x in [[0.7, 1.3, 2.1], [0.01, 1.3, 2.1], [0.02, 4.0, 2.4999]] {
            let here = formula(x);
            for k in 0..3 {
                let h = 1e-5;
                let moved = |sign: f64| {
                    let mut there = x;
                    there[k] += sign * h;
                    formula(there)
                };
                let (ahead, behind) = (moved(1.0), moved(-1.0));
                let slope = (ahead.value - behind.value) / (2.0 * h);
                assert!((slope - here.first[k]).abs() < 1e-8 * (1.0 + slope.abs()), "{slope} {here:?}");
                for j in 0..3 {
                    let bend = (ahead.first[j] - behind.first[j]) / (2.0 * h);
                    assert!((bend - here.second[k][j]).abs() < 1e-7 * (1.0 + bend.abs()), "{bend} {here:?}");
                }
            }
        }
    }

    /// Both ways of computing meet where one takes over from the other.
    #[test]
    fn series_and_formula_agree() {
        for y in [-SERIES, SERIES] {
            let (series, formula) = (log_ratio(y), log_ratio(y * (1.0 + 1e-15)));
            for (order, tolerance) in [1e-15, 1e-13, 1e-11].into_iter().enumerate() {
                assert!((series[order] - formula[order]).abs() < tolerance, "{series:?} {formula:?}");
            }
        }
    }
}
