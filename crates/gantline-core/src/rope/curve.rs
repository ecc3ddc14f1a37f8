//! Tension of a rope whose stiffness is not one number, by its strain: straight between given points.
//!
//! The row of such a rope keeps one compliance L/EA. Its value is the stretch of a rope of that stiffness with the same
//! energy: with the strain s, the tension G(s) and u = ∫ G ds
//!
//! ```text
//! g = L f(s)        f = √(2u/EA)        w = ∂g/∂ℓ = f′ = G/(EA f)        ∂²g/∂ℓ² = f″/L        f″ = (G′/EA − w²)/f
//! ```
//!
//! so that the force λ = EA f of the row pulls with T = w λ = G, as where rope is fed ([`crate::constraint::rope::span`]).
//! EA is chosen such that w = 1 at the last point; a line without bend has w = 1 everywhere.

/// Tension over strain, from nothing upwards; beyond the last point along its last line.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// EA of the row [N].
    pub axial_stiffness: f64,
    /// Where its lines begin.
    knots: Vec<Knot>,
}

/// Where a line of a curve begins.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Knot {
    /// Strain.
    strain: f64,
    /// Tension there [N].
    tension: f64,
    /// Energy per length up to there [N].
    energy: f64,
    /// Slope from there on [N].
    slope: f64,
}

/// A curve at one strain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bent {
    /// f.
    pub value: f64,
    /// w = f′.
    pub scale: f64,
    /// f″.
    pub bend: f64,
}

/// A rope that hangs still.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Still {
    /// T [N].
    pub tension: f64,
    /// Its strain.
    pub strain: f64,
    /// w = T/λ.
    pub scale: f64,
    /// dT/dλ.
    pub growth: f64,
}

impl Curve {
    /// The curve through points (strain, tension [N]) after (0, 0), both of which rise; none where they do not.
    pub fn through(points: &[[f64; 2]]) -> Option<Self> {
        let mut knots: Vec<Knot> = Vec::with_capacity(points.len());
        let (mut strain, mut tension, mut energy) = (0.0, 0.0, 0.0);
        for &[next, force] in points {
            let slope = (force - tension) / (next - strain);
            if !(next > strain && slope > 0.0) {
                return None;
            }
            knots.push(Knot { strain, tension, energy, slope });
            energy += 0.5 * (force + tension) * (next - strain);
            (strain, tension) = (next, force);
        }
        let axial_stiffness = 0.5 * tension * tension / energy;
        // Of no points, or of ones that are no numbers, it is none either.
        axial_stiffness.is_finite().then_some(Self { axial_stiffness, knots })
    }

    /// The last of its lines that begins where `of` is no more than `most`.
    fn line(&self, most: f64, of: impl Fn(&Knot) -> f64) -> &Knot {
        &self.knots[self.knots.partition_point(|knot| of(knot) <= most).max(1) - 1]
    }

    /// How the row answers a strain; a slack rope goes on along the line from nothing.
    pub fn at(&self, strain: f64) -> Bent {
        let Knot { strain: begin, tension, energy, slope } = *self.line(strain, |knot| knot.strain);
        if begin == 0.0 {
            let scale = (slope / self.axial_stiffness).sqrt();
            return Bent { value: scale * strain, scale, bend: 0.0 };
        }
        let over = strain - begin;
        let now = tension + slope * over;
        let value = (2.0 * (energy + 0.5 * (tension + now) * over) / self.axial_stiffness).sqrt();
        let scale = now / (self.axial_stiffness * value);
        Bent { value, scale, bend: (slope / self.axial_stiffness - scale * scale) / value }
    }

    /// A rope that hangs still under a force λ [N] of its row.
    pub fn under(&self, force: f64) -> Still {
        let energy = 0.5 * force * force.abs() / self.axial_stiffness;
        let Knot { strain, tension, energy: below, slope } = *self.line(energy, |knot| knot.energy);
        if strain == 0.0 {
            let scale = (slope / self.axial_stiffness).sqrt();
            return Still { tension: scale * force, strain: scale * force / slope, scale, growth: scale };
        }
        let now = (tension * tension + 2.0 * slope * (energy - below)).sqrt();
        let growth = slope * force / (self.axial_stiffness * now);
        Still { tension: now, strain: strain + (now - tension) / slope, scale: now / force, growth }
    }
}

#[cfg(test)]
mod tests {
    use super::Curve;

    fn curve() -> Curve {
        Curve::through(&[[0.01, 1e5], [0.02, 3e5], [0.03, 4e5]]).expect("points rise")
    }

    #[test]
    fn its_row_pulls_as_the_points_have_it() {
        let curve = curve();
        for (strain, tension) in
            [(0.005, 0.5e5), (0.01, 1e5), (0.015, 2e5), (0.02, 3e5), (0.025, 3.5e5), (0.05, 6e5)]
        {
            let bent = curve.at(strain);
            let force = curve.axial_stiffness * bent.value;
            assert!((bent.scale * force / tension - 1.0).abs() < 1e-14, "at {strain}");
            let still = curve.under(force);
            assert!((still.tension / tension - 1.0).abs() < 1e-14, "at {strain}");
            assert!((still.strain / strain - 1.0).abs() < 1e-14, "at {strain}");
            assert!((still.scale / bent.scale - 1.0).abs() < 1e-14, "at {strain}");
        }
        assert_eq!(curve.at(-0.5).value, -0.5 * curve.at(0.005).scale);
        // Slack, however far: what pulls back would have the energy of its last line.
        let slack = curve.under(curve.axial_stiffness * curve.at(-0.5).value);
        assert!((slack.strain / -0.5 - 1.0).abs() < 1e-14 && (slack.tension / -5e6 - 1.0).abs() < 1e-14);
        assert_eq!((curve.under(0.0).strain, curve.under(0.0).scale), (0.0, curve.at(0.0).scale));
        assert!((curve.at(0.03).scale - 1.0).abs() < 1e-15);
    }

    #[test]
    fn its_slopes_are_those_of_differences() {
        let curve = curve();
        for strain in [0.005, 0.012, 0.018, 0.025, 0.04] {
            let step = 1e-6;
            let [before, here, after] = [strain - step, strain, strain + step].map(|strain| curve.at(strain));
            // Central differences of steps of 1e-6: 1e-9 of their own order, and the rounding of values.
            assert!(((after.value - before.value) / (2.0 * step) / here.scale - 1.0).abs() < 1e-8);
            assert!(
                ((after.scale - before.scale) / (2.0 * step) - here.bend).abs()
                    < 1e-6 * (1.0 + here.bend.abs())
            );
            let force = curve.axial_stiffness * here.value;
            let [low, high] = [1.0 - 1e-6, 1.0 + 1e-6].map(|share| curve.under(force * share).tension);
            assert!(((high - low) / (2e-6 * force) / curve.under(force).growth - 1.0).abs() < 1e-8);
        }
    }

    #[test]
    fn points_rise() {
        for points in [
            &[[0.0, 1e5]][..],
            &[[0.01, 1e5], [0.01, 2e5]],
            &[[0.01, 1e5], [0.02, 1e5]],
            &[],
            &[[0.01, f64::NAN]],
            &[[0.01, f64::INFINITY]],
            &[[1e-310, 1e5]],
        ] {
            assert_eq!(Curve::through(points), None);
        }
    }
}
