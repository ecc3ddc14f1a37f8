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
            let forward = self.turn_over(spans, 1, &may);
            if !self.turn_over(spans, -1, &may) && !forward {
                return;
            }
            self.share(spans);
        }
        for _ in 0..NESTED_ROUNDS {
            // Each of these rounds settles at least one sheave for good.
            for _ in 0..=self.passed.len() {
                if !self.turn_over(spans, 1, &may) {
                    break;
                }
                self.share(spans);
            }
            if !self.turn_over(spans, -1, &may) {
                return;
            }
            self.share(spans);
        }
        self.tension.fill(f64::NAN);
    }

    /// Lets the sheaves that slip this way hold where rope runs against them, and those that hold slip where they
    /// cannot; true where any changed.
    fn turn_over(&mut self, spans: Spans, way: i8, may: impl Fn(usize, i8) -> bool) -> bool {
        let mut any = false;
        for (sheave, slip) in self.slips.way.iter_mut().enumerate() {
            let (mut low, mut high) = (self.tension[sheave], self.tension[sheave + 1]);
            if way < 0 {
                (low, high) = (high, low);
            }
            let turned = if *slip == way {
                (f64::from(way) * self.passed[sheave] < -NOTHING).then_some(0)
            } else {
                let beyond = high - spans.ratio[sheave] * low;
                let slips = *slip == 0 && beyond > ROUNDING * (high.abs() + low.abs()) && may(sheave, way);
                slips.then_some(way)
            };
            if let Some(turned) = turned {
                *slip = turned;
                any = true;
            }
        }
        any
    }

    /// Tensions, and what passes, with the sheaves slipping as they do.
    pub fn share(&mut self, spans: Spans) {
        let mut first = 0;
        self.weight[0] = 1.0;
        for sheave in 0..self.passed.len() {
            self.weight[sheave + 1] = match self.slips.step(sheave, spans.ratio[sheave]) {
                Some(step) => self.weight[sheave] * step,
                None => {
                    self.passed[sheave] = 0.0;
                    self.share_row(spans, first, sheave + 1);
                    first = sheave + 1;
                    1.0
                }
            };
        }
        self.share_row(spans, first, self.tension.len());
    }

    /// The same for the spans from `first` to before `end`, between which all sheaves slip.
    fn share_row(&mut self, spans: Spans, first: usize, end: usize) {
        let (stretch, compliance) = (&spans.stretch[first..end], &spans.compliance[first..end]);
        let weight = &self.weight[first..end];
        let long: f64 = stretch.iter().sum();
        let soft: f64 = weight.iter().zip(compliance).map(|(weight, compliance)| weight * compliance).sum();
        let common = long / soft;
        let tensions = self.tension[first..end].iter_mut().zip(weight);
        tensions.for_each(|(tension, weight)| *tension = weight * common);
        let mut passed = 0.0;
        let rope = self.tension[first..end].iter().zip(compliance).zip(stretch);
        for (out, ((tension, compliance), stretch)) in self.passed[first..end - 1].iter_mut().zip(rope) {
            passed += compliance * tension - stretch;
            *out = passed;
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
