//! How rope divides over light sheaves: those with losses whose inertia is neglected.
//!
//! Between two light sheaves the rope has one tension. Where a sheave holds, no rope passes; where it slips towards the
//! end of the route, the tension after it is ρ times the one before it, towards the start 1/ρ times:
//!
//! ```text
//! c_j T_j/(1 + k T_j) = x_j + s_j − s_{j−1}      1/ρ ≤ T_{j+1}/T_j ≤ ρ,  s_j > 0 only at ρ,  s_j < 0 only at 1/ρ
//! ```
//!
//! x being what every span is stretched by if nothing passes, s what does, and k what its strain takes off that:
//! stretched rope is longer than the rope that it holds. Over a row of sheaves that slip all tensions are shares of one, which
//! the sum over its spans gives; so what is to be found is which sheaves slip. Written as
//!
//! ```text
//! max( T_j − ρ T_{j+1}, min( s_j, ρ T_j − T_{j+1} ) ) = 0
//! ```
//!
//! every piece of every row answers to its own s alone with the other sign than to its neighbours', and not less: an
//! M-function, which has one zero (Rheinboldt 1970). It is looked for by changing all sheaves that are wrong at
//! once, which nearly always ends after two or three rounds, and if not by settling the minimum for each choice of the
//! maximum, which improves all along (Hoffman and Karp 1966).
//!
//! Tensions on both sides of a sheave come to nothing together, so a rope is slack as a whole, and then as loose
//! everywhere.

use std::ops::Range;

/// Rounds in which all sheaves that are wrong change at once.
const ROUNDS: usize = 16;
/// Rounds, if that did not end, in which those change that slip towards the start, each after all others have settled.
const NESTED_ROUNDS: usize = 1000;
/// Rounding of a ratio of tensions.
const ROUNDING: f64 = 1e-12;
/// A ratio of tensions so near its bound is there.
const TOUCHING: f64 = 1e-9;
/// What has passed and is rounding [m, m/s].
const NOTHING: f64 = 1e-12;
/// Newton's steps for the tension of a row of spans, at most: strains are small, so that one is enough nearly always.
const STEPS: usize = 6;
/// Change of a strain after which the next step would be rounding.
const CLOSE: f64 = 1e-8;

/// Which way every sheave slips.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Slips {
    /// 1 towards the end of the route, −1 towards its start, 0 where it holds.
    pub way: Vec<i8>,
    /// True where the rope is loose, and nothing holds it.
    pub is_loose: bool,
}

impl Slips {
    /// Tension after a sheave over that before it, by its ρ; none where it holds.
    pub fn step(&self, sheave: usize, ratio: f64) -> Option<f64> {
        step(self.way[sheave], self.is_loose, ratio)
    }

    /// The first span of the row that a span belongs to.
    fn first_with(&self, span: usize) -> usize {
        if self.is_loose {
            return 0;
        }
        self.way[..span].iter().rposition(|&way| way == 0).map_or(0, |sheave| sheave + 1)
    }

    /// Takes over others of the same sheaves.
    pub fn copy_from(&mut self, other: &Self) {
        self.way.copy_from_slice(&other.way);
        self.is_loose = other.is_loose;
    }
}

/// See [`Slips::step`].
#[inline]
fn step(way: i8, is_loose: bool, ratio: f64) -> Option<f64> {
    match way {
        _ if is_loose => Some(1.0),
        0 => None,
        way if way > 0 => Some(ratio),
        _ => Some(1.0 / ratio),
    }
}

/// A row of light sheaves, with what lies between them.
#[derive(Clone, Copy)]
pub struct Spans<'a> {
    /// ρ of every sheave.
    pub ratio: &'a [f64],
    /// x of every span; one more than sheaves.
    pub stretch: &'a [f64],
    /// c of every span.
    pub compliance: &'a [f64],
    /// k, the same for all: 1/EA, or 0 for rates and small changes.
    pub softening: f64,
}

/// Rope over a row of light sheaves. Reused.
#[derive(Debug, Clone, Default)]
pub struct Division {
    /// T of every span.
    pub tension: Vec<f64>,
    /// s of every sheave.
    pub passed: Vec<f64>,
    /// Which sheaves slip.
    pub slips: Slips,
    weight: Vec<f64>,
    /// Which sheaves have turned over since tensions were shared, ascending; what stands after them is of earlier times.
    turned: Vec<usize>,
}

impl Division {
    /// Room for so many sheaves.
    pub fn new(sheaves: usize) -> Self {
        Self {
            tension: vec![0.0; sheaves + 1],
            passed: vec![0.0; sheaves],
            slips: Slips { way: vec![0; sheaves], is_loose: false },
            weight: vec![1.0; sheaves + 1],
            turned: vec![0; sheaves],
        }
    }

    /// Divides the rope, which is loose or not as `slips` says; which sheaves slip is where the search starts. Tensions
    /// are no numbers where lengths are none.
    pub fn divide(&mut self, spans: Spans) {
        self.search(spans, |_, _| true);
    }

    /// The same of rates, T and s being those of tensions and rope: of the sheaves at their bound in `lies` those slip
    /// that way which do not hold.
    pub fn turn(&mut self, spans: Spans, lies: &Slips) {
        self.slips.copy_from(lies);
        self.search(spans, |sheave, way| lies.way[sheave] == way);
    }

    /// Finds which sheaves slip, each of them only as it `may`.
    fn search(&mut self, spans: Spans, may: impl Fn(usize, i8) -> bool) {
        self.share(spans);
        if self.slips.is_loose {
            return;
        }
        for _ in 0..ROUNDS {
            if !self.turn_over(spans, |_| true, &may) {
                return;
            }
        }
        for _ in 0..NESTED_ROUNDS {
            // Each of these rounds settles at least one sheave for good.
            for _ in 0..=self.passed.len() {
                if !self.turn_over(spans, |way| way > 0, &may) {
                    break;
                }
            }
            if !self.turn_over(spans, |way| way < 0, &may) {
                return;
            }
        }
        self.tension.fill(f64::NAN);
    }

    /// Lets the sheaves that slip one of these ways hold where rope runs against them, and those that hold slip where
    /// they cannot; true where any changed, and tensions with them.
    fn turn_over(
        &mut self,
        spans: Spans,
        is_asked: impl Fn(i8) -> bool,
        may: impl Fn(usize, i8) -> bool,
    ) -> bool {
        let mut count = 0;
        let sides = self.tension.windows(2).zip(spans.ratio);
        let sheaves = self.slips.way.iter_mut().zip(&self.passed).zip(sides);
        for (sheave, ((slip, passed), (sides, ratio))) in sheaves.enumerate() {
            let slips = |low: f64, high: f64| high - ratio * low > ROUNDING * (high.abs() + low.abs());
            *slip = match *slip {
                0 if is_asked(1) && slips(sides[0], sides[1]) && may(sheave, 1) => 1,
                0 if is_asked(-1) && slips(sides[1], sides[0]) && may(sheave, -1) => -1,
                way if is_asked(way) && f64::from(way) * passed < -NOTHING => 0,
                _ => continue,
            };
            self.turned[count] = sheave;
            count += 1;
        }
        self.share_beside_turned(spans, count);
        count > 0
    }

    /// Tensions, and what passes, with the sheaves slipping as they do.
    pub fn share(&mut self, spans: Spans) {
        let mut first = 0;
        while first < self.tension.len() {
            first = self.share_from(spans, first);
        }
    }

    /// The same of the spans that the `count` sheaves which have turned over bound or join.
    fn share_beside_turned(&mut self, spans: Spans, count: usize) {
        let mut settled = 0;
        for index in 0..count {
            let sheave = self.turned[index];
            // The spans on both sides; where it slips they are in one row.
            for span in [sheave, sheave + 1] {
                if span >= settled {
                    settled = self.share_from(spans, self.slips.first_with(span));
                }
            }
        }
    }

    /// The same of the row of spans that begins with the span `first`; returns where it ends.
    fn share_from(&mut self, spans: Spans, first: usize) -> usize {
        let (long, plain) = (spans.stretch[first], spans.compliance[first]);
        let mut row = Row { long, plain, soft: plain, largest: 1.0 };
        let (mut end, mut weight) = (first + 1, 1.0);
        self.weight[first] = weight;
        let sheaves = self.slips.way[first..].iter().zip(&spans.ratio[first..]);
        let after = spans.stretch[end..].iter().zip(&spans.compliance[end..]);
        let after = after.zip(&mut self.weight[end..]);
        for ((&way, &ratio), ((stretch, compliance), after)) in sheaves.zip(after) {
            let Some(step) = step(way, self.slips.is_loose, ratio) else { break };
            weight *= step;
            *after = weight;
            row.long += stretch;
            row.soft += weight * compliance;
            row.plain += compliance;
            row.largest = row.largest.max(weight);
            end += 1;
        }
        // What is loose has no strain.
        let k = if row.long > 0.0 { spans.softening } else { 0.0 };
        if end == first + 1 {
            self.tension[first] = row.long / (row.plain - k * row.long);
        } else {
            self.share_row(spans, (first..end, row), k);
        }
        // Where the rope goes on, a sheave holds.
        if let Some(passed) = self.passed.get_mut(end - 1) {
            *passed = 0.0;
        }
        end
    }

    /// Tensions of several spans between which all sheaves slip, and what passes these.
    fn share_row(&mut self, spans: Spans, (range, row): (Range<usize>, Row), k: f64) {
        let (stretch, compliance) = (&spans.stretch[range.clone()], &spans.compliance[range.clone()]);
        let weights = &self.weight[range.clone()];
        let common = row.common((weights, compliance), k);
        let mut so_far = 0.0;
        let own = weights.iter().zip(compliance).zip(stretch);
        let out = self.tension[range.clone()].iter_mut().zip(&mut self.passed[range.start..range.end - 1]);
        for (((weight, compliance), stretch), (tension, passed)) in own.zip(out) {
            *tension = weight * common;
            let strained = compliance * *tension;
            so_far += if k == 0.0 { strained } else { strained / (1.0 + k * *tension) } - stretch;
            *passed = so_far;
        }
        self.tension[range.end - 1] = self.weight[range.end - 1] * common;
    }

    /// Counts sheaves that hold, and could hold no more, as slipping: [`Division::turn`] knows whether they do.
    pub fn mark(&mut self, ratio: &[f64]) {
        if self.slips.is_loose {
            return;
        }
        for (sheave, (way, ratio)) in self.slips.way.iter_mut().zip(ratio).enumerate() {
            let (before, after) = (self.tension[sheave], self.tension[sheave + 1]);
            let holds = ratio * (1.0 - TOUCHING);
            *way = match *way {
                0 if after >= holds * before => 1,
                0 if before >= holds * after => -1,
                way => way,
            };
        }
    }
}

/// Sums over spans between which all sheaves slip.
struct Row {
    /// Of what they are stretched by [m].
    long: f64,
    /// Of their compliances, and of these times their weights.
    plain: f64,
    soft: f64,
    /// Largest weight.
    largest: f64,
}

impl Row {
    /// The tension that the weights of the spans are shares of.
    fn common(&self, (weights, compliances): (&[f64], &[f64]), k: f64) -> f64 {
        // Right where all weights are one, and where strains do not count.
        let mut common = self.long / (self.soft * (1.0 - k * self.long / self.plain));
        if k == 0.0 {
            return common;
        }
        for _ in 0..STEPS {
            let (mut excess, mut slope) = (-self.long, 0.0);
            for (weight, compliance) in weights.iter().zip(compliances) {
                let share = 1.0 / (1.0 + k * weight * common);
                let soft = weight * compliance * share;
                excess += soft * common;
                slope += soft * share;
            }
            let change = excess / slope;
            common -= change;
            if k * self.largest * change.abs() <= CLOSE {
                break;
            }
        }
        common
    }
}
