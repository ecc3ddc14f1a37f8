//! The elastic catenary: how a heavy line hangs between two points (Irvine 1981; with the sea bed Jonkman 2007).
//!
//! A line of unstretched length L, weight w per unstretched length and axial stiffness EA has the horizontal force H all
//! along and, at the unstretched distance u from its upper end, the vertical force V − w u. With T = √(H² + V²) along it,
//!
//! ```text
//! X = ∫ H (1/T + 1/EA) du        Z = ∫ V (1/T + 1/EA) du
//! ```
//!
//! are the distances of its ends. Both are the slopes of Φ(H, V) = ∫ (T + T²/2EA) du, which is convex: for any distances
//! there is one H and one V, where Φ − H X − V Z is least, and −Φ + H X + V Z is the energy of the line, elastic and of its
//! weight, above its lower end:
//!
//! ```text
//! U = H X + V Z − Φ        ∂U/∂X = H        ∂U/∂Z = V        ∂U/∂L = −(T₂ + T₂²/2EA)
//! ```
//!
//! T₂ at the lower end. With s the length that is off the bed, V₂ the vertical force at the lower end of that, S = T₁ + T₂ and
//! M = V + V₂, the integrals are (differences of square roots and logarithms written so that they do not cancel for a
//! light or taut line)
//!
//! ```text
//! X = s (Λ + H/EA)        Z = s (M/S + M/2EA)        Λ = H ln(1 + y)/(w s)
//! y = w s (1 + |M|/S)/(β + B)        β, B: V₂, T₂ where M ≥ 0, else −V, T₁
//! ∫ T du = s (S/2 + M²/2S + H Λ)/2
//! ```
//!
//! What lies on a level bed without friction has V = 0 and T = H: s = V/w and V₂ = 0, and L − s lies there. Where even
//! H = 0 leaves more on the bed than fits, the rest lies in heaps: the line hangs down plumb.

use super::jet::Jet;

/// Of the distances, relative to all lengths together.
const ROUNDING: f64 = 1e-16;

/// A line between two points in a vertical plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Catenary {
    /// w [N/m], of unstretched line.
    pub weight: f64,
    /// EA [N].
    pub stiffness: f64,
    /// True where the lower end lies on a level bed, on which the line can rest.
    pub on_bed: bool,
}

/// How it hangs, with derivatives over the two distances [m] of its ends and its unstretched length; without second ones
/// where N is 0, else 3.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hanging<const N: usize = 3> {
    /// H, the horizontal force [N].
    pub horizontal: f64,
    /// V, what the upper end carries [N].
    pub vertical: f64,
    /// X, the distance aside [m].
    pub reach: f64,
    /// Unstretched length that lies on the bed [m].
    pub grounded: f64,
    /// U [J]; its first derivatives are H, V and ∂U/∂L.
    pub energy: Jet<N>,
    /// Mean strain along the line.
    pub strain: Jet<N>,
}

/// X, Z, ∫ T du [N m] and the tension at the lower end, over (H, V, L); without second derivatives where N is 0.
struct Spans<const N: usize> {
    reach: Jet<N>,
    rise: Jet<N>,
    tension: Jet<N>,
    lower: Jet<N>,
    grounded: Jet<N>,
}

/// Rounds to the forces: quadratic from a good guess, a decade each from the worst.
const ROUNDS: usize = 200;
/// Change of the forces, relative to them, at which they are found.
const FOUND: f64 = 1e-13;

impl Catenary {
    /// How the line hangs where its upper end is `reach` > 0 [m] aside of and `rise` [m] above the lower end, with the
    /// unstretched `length` > 0 [m]. On a bed `rise` must be more than zero.
    pub fn hang<const N: usize>(&self, reach: f64, rise: f64, length: f64) -> Hanging<N> {
        if self.on_bed {
            // V with H = 0: V/w (1 + V/2EA) = Z.
            let whole = 2.0 * self.weight * rise;
            let plumb = whole / (1.0 + (1.0 + whole / self.stiffness).sqrt());
            if plumb <= self.weight * length && reach <= length - plumb / self.weight {
                return self.heaped(plumb, [reach, rise], length);
            }
        }
        let [h, v] = self.forces(reach, rise, length);
        let spans = self.spans::<N>([h, v], length);
        let inverse = 1.0 / self.stiffness;
        // (H, V) over (X, Z, L): J y′ = (X, Z, 0)′ − ∂(X, Z)/∂L.
        let rows = [&spans.reach, &spans.rise];
        let first: [[f64; 3]; 2] = {
            let columns: [[f64; 2]; 3] = std::array::from_fn(|p| {
                let right: [f64; 2] =
                    std::array::from_fn(|row| if p < 2 { f64::from(p == row) } else { -rows[row].first[2] });
                solve(rows, right)
            });
            std::array::from_fn(|row| columns.map(|column| column[row]))
        };
        // All three variables of the jets over (X, Z, L).
        let chain = [first[0], first[1], [0.0, 0.0, 1.0]];
        let along = |jet: &Jet<N>, p: usize, q: usize| -> f64 {
            let terms = (0..9).map(|k| jet.second[k / 3][k % 3] * chain[k / 3][p] * chain[k % 3][q]);
            terms.sum()
        };
        let over = |jet: &Jet<N>| -> Jet<N> {
            let slope = |p: usize| (0..3).map(|k| jet.first[k] * chain[k][p]).sum::<f64>();
            let bend = |p: usize, q: usize| {
                let right = rows.map(|row| -along(row, p, q));
                let [h, v] = solve(rows, right);
                along(jet, p, q) + jet.first[0] * h + jet.first[1] * v
            };
            Jet {
                value: jet.value,
                first: std::array::from_fn(slope),
                second: std::array::from_fn(|p| std::array::from_fn(|q| bend(p, q))),
            }
        };
        let lower = over(&(spans.lower + spans.lower * spans.lower * (0.5 * inverse)));
        let squares = {
            let off = length - spans.grounded.value;
            let [sum, difference] = [2.0 * v - self.weight * off, self.weight * off];
            off * (h * h + 0.25 * sum * sum + difference * difference / 12.0) + spans.grounded.value * h * h
        };
        let value =
            h * spans.reach.value + v * spans.rise.value - spans.tension.value - 0.5 * squares * inverse;
        let last = lower.first.map(|slope| -slope);
        let second = [[first[0][0], first[0][1], last[0]], [first[1][0], first[1][1], last[1]], last];
        let energy =
            Jet { value, first: [h, v, -lower.value], second: std::array::from_fn(|row| second[row]) };
        let strain = over(&(spans.tension * inverse / Jet::variable(length, 2)));
        Hanging { horizontal: h, vertical: v, reach, grounded: spans.grounded.value, energy, strain }
    }

    /// Hanging down to the bed, with the vertical force `v` [N] above.
    fn heaped<const N: usize>(&self, v: f64, [reach, rise]: [f64; 2], length: f64) -> Hanging<N> {
        let (w, inverse) = (self.weight, 1.0 / self.stiffness);
        let slope = w / (1.0 + v * inverse);
        let mut energy = Jet::constant(v * rise - v * v / (2.0 * w) - v * v * v * inverse / (6.0 * w));
        energy.first[1] = v;
        if let Some(row) = energy.second.get_mut(1) {
            row[1] = slope;
        }
        // ∫ T du = V²/2w, V over Z.
        let force = Jet::variable(rise, 1).of([v, slope, -slope * slope * inverse / (1.0 + v * inverse)]);
        let strain = force * force * (0.5 * inverse / w) / Jet::variable(length, 2);
        Hanging { horizontal: 0.0, vertical: v, reach, grounded: length - v / w, energy, strain }
    }

    /// Distances and what else is integrated along the line, with derivatives over (H, V, L).
    fn spans<const N: usize>(&self, [h, v]: [f64; 2], length: f64) -> Spans<N> {
        let (horizontal, vertical) = (Jet::<N>::variable(h, 0), Jet::variable(v, 1));
        let whole = Jet::variable(length, 2);
        let rests = self.on_bed && v < self.weight * length;
        let (off, below) = if rests {
            (vertical * (1.0 / self.weight), Jet::constant(0.0))
        } else {
            (whole, vertical - whole * self.weight)
        };
        let inverse = 1.0 / self.stiffness;
        let square = horizontal * horizontal;
        let (above, lower) = ((square + vertical * vertical).sqrt(), (square + below * below).sqrt());
        let (sum, middle) = (above + lower, vertical + below);
        let tilt = middle / sum;
        let is_up = middle.value >= 0.0;
        let (base, size) = if is_up { (below, lower) } else { (vertical * -1.0, above) };
        let lean = if is_up { tilt } else { tilt * -1.0 };
        // β + B, which for a negative β is H²/(B − β).
        let foot = if base.value >= 0.0 { base + size } else { square / (size - base) };
        let spread = (lean + Jet::constant(1.0)) / foot;
        let y = off * spread * self.weight;
        let flat = horizontal * spread * y.log_ratio();
        let tension = off * (sum * 0.5 + middle * tilt * 0.5 + horizontal * flat) * 0.5;
        let mut spans = Spans {
            reach: off * (flat + horizontal * inverse),
            rise: off * (tilt + middle * (0.5 * inverse)),
            tension,
            lower,
            grounded: Jet::constant(0.0),
        };
        if rests {
            let grounded = whole - off;
            spans.reach = spans.reach + grounded * (horizontal * inverse + Jet::constant(1.0));
            spans.tension = spans.tension + grounded * horizontal;
            spans.grounded = grounded;
        }
        spans
    }

    /// H and V, by Newton's method on the slopes of a convex function, with steps that do not climb.
    fn forces(&self, reach: f64, rise: f64, length: f64) -> [f64; 2] {
        let mut at = self.guess(reach, rise, length);
        let mut spans = self.spans::<0>(at, length);
        let miss = |spans: &Spans<0>| [spans.reach.value - reach, spans.rise.value - rise];
        for _ in 0..ROUNDS {
            let missed = miss(&spans);
            if missed.iter().all(|miss| miss.abs() <= ROUNDING * (reach + rise.abs() + length)) {
                break;
            }
            let step = solve([&spans.reach, &spans.rise], missed.map(|miss| -miss));
            let downhill = -(missed[0] * step[0] + missed[1] * step[1]);
            let mut share = 1.0_f64;
            if step[0] < 0.0 {
                share = share.min(-0.9 * at[0] / step[0]);
            }
            if self.on_bed && step[1] < 0.0 {
                share = share.min(-0.9 * at[1] / step[1]);
            }
            let scale = at[0].abs() + at[1].abs();
            let small = step[0].abs() <= FOUND * at[0].abs() && step[1].abs() <= FOUND * scale;
            let before = at;
            loop {
                at = std::array::from_fn(|k| before[k] + share * step[k]);
                spans = self.spans(at, length);
                let [x, z] = miss(&spans);
                // The slope along the step only grows: where it has gone past zero by more than it was, that is too far.
                let climb = x * step[0] + z * step[1];
                if climb <= 0.9 * downhill || share < 1e-6 || small {
                    break;
                }
                share *= (downhill / (downhill + climb)).max(0.1);
            }
            if small || at == before {
                break;
            }
        }
        at
    }

    /// A first guess: by the stretch of a straight line where it is taut, else Jonkman's.
    fn guess(&self, reach: f64, rise: f64, length: f64) -> [f64; 2] {
        let chord = reach.hypot(rise);
        let (w, half) = (self.weight, 0.5 * self.weight * length);
        let [h, v] = if length <= chord {
            let tension = self.stiffness * (chord / length - 1.0) + half;
            [tension * reach / chord, tension * rise / chord + half]
        } else {
            let lambda = (3.0 * ((length * length - rise * rise) / (reach * reach) - 1.0)).sqrt().max(1e-3);
            [0.5 * w * reach / lambda, 0.5 * w * (rise / lambda.tanh() + length)]
        };
        [h, if self.on_bed { v.max(0.1 * w * rise.min(length)) } else { v }]
    }

    /// A place along the line, at a share of its unstretched length from its lower end (0) to its upper (1): aside of and
    /// above the lower end [m], for the forces of [`Catenary::hang`].
    pub fn place<const N: usize>(&self, hanging: &Hanging<N>, length: f64, share: f64) -> [f64; 2] {
        let Hanging { horizontal: h, vertical: v, reach, grounded, .. } = *hanging;
        let along = share * length;
        // Heaps are drawn as a line that lies straight.
        let lying = if h > 0.0 { 1.0 + h / self.stiffness } else { reach / grounded };
        if along <= grounded {
            return [along * lying, 0.0];
        }
        let off = along - grounded;
        let above = v - self.weight * (length - along);
        if h == 0.0 {
            return [reach, off * (1.0 + 0.5 * above / self.stiffness)];
        }
        let spans = Self { on_bed: false, ..*self }.spans::<0>([h, above], off);
        [grounded * lying + spans.reach.value, spans.rise.value]
    }
}

/// x of J x = `right`, J the derivatives of two jets over their first two variables: symmetric and positive definite.
fn solve<const N: usize>(rows: [&Jet<N>; 2], right: [f64; 2]) -> [f64; 2] {
    let [[a, b], [c, d]] = rows.map(|row| [row.first[0], row.first[1]]);
    let determinant = a * d - b * c;
    [(right[0] * d - b * right[1]) / determinant, (a * right[1] - c * right[0]) / determinant]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Distances and energy by Simpson's rule along the line, with more points where it bends.
    fn by_quadrature(line: &Catenary, [h, v]: [f64; 2], length: f64) -> [f64; 3] {
        let Catenary { weight, stiffness, on_bed } = *line;
        let off = if on_bed { length.min(v / weight) } else { length };
        // u = (V − h sinh t)/w makes ∫ dt of what is smooth.
        let [from, to] = [v, v - weight * off].map(|v| (v / h).asinh());
        let (parts, step) = (4000, (from - to) / 4000.0);
        let mut sum = [0.0; 3];
        for part in 0..=parts {
            let t = to + step * f64::from(part);
            let (along, tension) = (h * t.sinh(), h * t.cosh());
            let share = if part == 0 || part == parts { 1.0 } else { f64::from(2 + 2 * (part % 2)) };
            let each = [h * (1.0 / tension + 1.0 / stiffness), along * (1.0 / tension + 1.0 / stiffness)];
            let held = tension * tension / (2.0 * stiffness);
            let weights = share * step / 3.0 * tension / weight;
            sum[0] += weights * each[0];
            sum[1] += weights * each[1];
            sum[2] += weights * (tension + held);
        }
        let rest = length - off;
        sum[0] += rest * (1.0 + h / stiffness);
        sum[2] += rest * (h + h * h / (2.0 * stiffness));
        [sum[0], sum[1], h * sum[0] + v * sum[1] - sum[2]]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]

        /// Forces lead back to the distances, for lines from plumb to level, slack to taut, light to heavy.
        #[test]
        fn hangs_between_its_ends(
            [reach, slack, bend] in [-6.0..0.5_f64, -6.0..0.3, 0.02..3.0_f64],
            [weight, stiffness] in [-1.0..3.0_f64, 5.0..11.0_f64],
            (on_bed, size, under) in (any::<bool>(), 1.0..300.0_f64, any::<bool>()),
        ) {
            let line = Catenary { weight: 10f64.powf(weight), stiffness: 10f64.powf(stiffness), on_bed };
            let (aside, up) = (10f64.powf(reach).min(1.0), bend / 3.0);
            let up = if under && !on_bed { -up } else { up };
            let (reach, rise) = (size * aside, size * up);
            let chord = reach.hypot(rise);
            // Between a strain of some 2 % and a length twice the chord.
            let length = if slack < -1.0 { chord * (1.0 + 0.02 * (slack + 1.0) / 5.0) } else { chord * (1.0 + 10f64.powf(slack)) };
            let hanging: Hanging = line.hang(reach, rise, length);
            let Hanging { horizontal: h, vertical: v, .. } = hanging;
            prop_assert!(h.is_finite() && v.is_finite() && h >= 0.0, "{hanging:?}");
            let [x, z] = line.place(&hanging, length, 1.0);
            // An error of the forces of one part in 1e13 moves the ends of a stiff line by less than that.
            prop_assert!((x - reach).abs() + (z - rise).abs() < 1e-11 * (length + chord), "{x} {reach} {z} {rise} {hanging:?}");
            let tension = h.hypot(v.abs() + line.weight * length);
            // The energy is a difference of Φ from H X + V Z, which all are of the size of T L.
            // Where the line hardly bends or is all but plumb, the quadrature itself cancels.
            if h > 1e-7 * tension && line.weight * length > 1e-4 * tension {
                let [x, z, energy] = by_quadrature(&line, [h, v], length);
                prop_assert!((x - reach).abs() + (z - rise).abs() < 1e-8 * length, "{x} {reach} {z} {rise}");
                prop_assert!((energy - hanging.energy.value).abs() < 1e-8 * tension * length, "{energy} {hanging:?}");
            }
        }

        /// First and second derivatives of energy and strain, and the forces as slopes of the energy, against differences.
        #[test]
        fn derivatives_are_those_of_differences(
            [reach, rise, length] in [0.2..1.2_f64, 0.1..0.9_f64, 1.0..1.8_f64],
            (on_bed, weight, stiffness) in (any::<bool>(), 0.5..20.0_f64, 1.0..1e3_f64),
        ) {
            let line = Catenary { weight, stiffness, on_bed };
            let hang = |at: [f64; 3]| -> Hanging { line.hang(at[0], at[1], at[2]) };
            let at = [reach, rise, length];
            let here = hang(at);
            // Where the line first comes down to the bed, or heaps up, second derivatives have a corner.
            prop_assume!(!on_bed || ((here.vertical / weight - length).abs() > 1e-3 && here.horizontal > 1e-3 * weight));
            let step = 1e-5;
            for k in 0..3 {
                let moved = |sign: f64| { let mut there = at; there[k] += sign * step; hang(there) };
                let (more, less) = (moved(1.0), moved(-1.0));
                for (ahead, behind, jet) in [(more.energy, less.energy, here.energy), (more.strain, less.strain, here.strain)] {
                    let slope = (ahead.value - behind.value) / (2.0 * step);
                    let size = 1.0 + jet.value.abs() + jet.second[k][k].abs();
                    prop_assert!((slope - jet.first[k]).abs() < 1e-6 * size, "{k}: {slope} {jet:?}");
                    for j in 0..3 {
                        let bend = (ahead.first[j] - behind.first[j]) / (2.0 * step);
                        let size = 1.0 + jet.second[k][k].abs() + jet.second[j][j].abs();
                        prop_assert!((bend - jet.second[k][j]).abs() < 1e-4 * size, "{k} {j}: {bend} {jet:?}");
                    }
                }
            }
        }
    }

    /// Heaps on the bed leave the line plumb, of the weight of what hangs, and move nothing sideways.
    #[test]
    fn heaps_hang_plumb() {
        let line = Catenary { weight: 100.0, stiffness: 1e9, on_bed: true };
        let hanging: Hanging = line.hang(3.0, 10.0, 20.0);
        assert_eq!(hanging.horizontal, 0.0);
        // Z = V/w + V²/2wEA
        let v = hanging.vertical;
        assert!((v / 100.0 + v * v / (2.0 * 100.0 * 1e9) - 10.0).abs() < 1e-9);
        assert!((hanging.energy.second[1][1] - 100.0 / (1.0 + v / 1e9)).abs() < 1e-9);
        assert!((hanging.grounded - 10.0).abs() < 1e-4);
        let [x, z] = line.place(&hanging, 20.0, 0.25);
        assert!((x - 3.0 * 5.0 / hanging.grounded).abs() < 1e-12 && z == 0.0);
        // The force is continuous where the heap is used up.
        let straight: Hanging = line.hang(hanging.grounded + 1e-6, 10.0, 20.0);
        assert!(straight.horizontal < 1e-3 && (straight.vertical - v).abs() < 1e-3, "{straight:?}");
    }

    /// A heaped line that stretches by a tenth where it leaves its fairlead: what hangs stores ∫ V dZ over
    /// Z = V/w (1 + V/2EA), which is V²/2w + V³/3wEA, and is u (1 + w u/2EA) long where u of it is unstretched.
    #[test]
    fn heaps_store_what_lifting_them_took() {
        let (w, stiffness, v) = (100.0, 1e4, 1e3);
        let rise = v / w * (1.0 + v / (2.0 * stiffness));
        let line = Catenary { weight: w, stiffness, on_bed: true };
        let hanging: Hanging = line.hang(3.0, rise, 20.0);
        assert!((hanging.vertical - v).abs() < 1e-9);
        let energy = v * v / (2.0 * w) + v * v * v / (3.0 * w * stiffness);
        assert!((hanging.energy.value - energy).abs() < 1e-9 * energy, "{hanging:?}");
        // 10 m of 20 m lie on the bed; from there on the height is that of what hangs.
        for (share, unstretched) in [(0.5, 0.0), (0.75, 5.0), (1.0, 10.0)] {
            let [x, z] = line.place(&hanging, 20.0, share);
            let above = unstretched * (1.0 + w * unstretched / (2.0 * stiffness));
            assert!((x - 3.0).abs() < 1e-9 && (z - above).abs() < 1e-9, "{x} {z}");
        }
    }
}
