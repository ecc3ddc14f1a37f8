//! How rope divides over light sheaves: those with losses whose inertia is neglected.
//!
//! Between two light sheaves the rope has one tension. Where a sheave holds, no rope passes; where it slips towards the
//! end of the route, the tension after it is ρ times the one before it, towards the start 1/ρ times:
//!
//! ```text
//! c_j T_j = x_j + s_j − s_{j−1}      1/ρ ≤ T_{j+1}/T_j ≤ ρ,  s_j > 0 only at ρ,  s_j < 0 only at 1/ρ
//! ```
//!
//! x being what every span is stretched by if nothing passes and s what does. Over a row of sheaves that slip all tensions
//! are shares of one, which the sum over its spans gives; so what is to be found is which sheaves slip. Written as
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
        match self.way[sheave] {
            _ if self.is_loose => Some(1.0),
            0 => None,
            way if way > 0 => Some(ratio),
            _ => Some(1.0 / ratio),
        }
    }

    /// Takes over others of the same sheaves.
    pub fn copy_from(&mut self, other: &Self) {
        self.way.copy_from_slice(&other.way);
        self.is_loose = other.is_loose;
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
}

impl Division {
    /// Room for so many sheaves.
    pub fn new(sheaves: usize) -> Self {
        Self {
            tension: vec![0.0; sheaves + 1],
            passed: vec![0.0; sheaves],
            slips: Slips { way: vec![0; sheaves], is_loose: false },
            weight: vec![1.0; sheaves + 1],
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
            self.share(spans);
        }
        for _ in 0..NESTED_ROUNDS {
            // Each of these rounds settles at least one sheave for good.
            for _ in 0..=self.passed.len() {
                if !self.turn_over(spans, |way| way > 0, &may) {
                    break;
                }
                self.share(spans);
            }
            if !self.turn_over(spans, |way| way < 0, &may) {
                return;
            }
            self.share(spans);
        }
        self.tension.fill(f64::NAN);
    }

    /// Lets the sheaves that slip one of these ways hold where rope runs against them, and those that hold slip where
    /// they cannot; true where any changed.
    fn turn_over(
        &mut self,
        spans: Spans,
        is_asked: impl Fn(i8) -> bool,
        may: impl Fn(usize, i8) -> bool,
    ) -> bool {
        let mut any = false;
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
            any = true;
        }
        any
    }

    /// Tensions, and what passes, with the sheaves slipping as they do.
    pub fn share(&mut self, spans: Spans) {
        let (mut first, mut weight, mut long, mut soft) = (0, 1.0, 0.0, 0.0);
        let sheaves = spans.ratio.len();
        let rope = spans.stretch.iter().zip(spans.compliance);
        for (sheave, ((stretch, compliance), ratio)) in rope.zip(spans.ratio).enumerate() {
            self.weight[sheave] = weight;
            long += stretch;
            soft += weight * compliance;
            match self.slips.step(sheave, *ratio) {
                Some(step) => weight *= step,
                None => {
                    self.share_row(spans, first..sheave + 1, long / soft);
                    (first, weight, long, soft) = (sheave + 1, 1.0, 0.0, 0.0);
                }
            }
        }
        self.weight[sheaves] = weight;
        let common = (long + spans.stretch[sheaves]) / (soft + weight * spans.compliance[sheaves]);
        self.share_row(spans, first..sheaves + 1, common);
    }

    /// The same for spans between which all sheaves slip, by the tension that the weights are shares of.
    fn share_row(&mut self, spans: Spans, row: Range<usize>, common: f64) {
        let last = row.end - 1;
        let tensions = self.tension[row.clone()].iter_mut().zip(&self.weight[row.clone()]);
        tensions.for_each(|(tension, weight)| *tension = weight * common);
        let own = spans.compliance[row.clone()].iter().zip(&spans.stretch[row.clone()]);
        let mut so_far = 0.0;
        for (passed, (tension, (compliance, stretch))) in
            self.passed[row.start..last].iter_mut().zip(self.tension[row].iter().zip(own))
        {
            so_far += compliance * tension - stretch;
            *passed = so_far;
        }
        // Where the rope goes on, a sheave holds.
        if let Some(passed) = self.passed.get_mut(last) {
            *passed = 0.0;
        }
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
