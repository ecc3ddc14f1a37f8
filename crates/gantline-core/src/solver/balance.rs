//! Newton's method for a step of `del` with light sheaves: which of them slip, which way, and which ropes and contacts carry.
//!
//! Each solution of a step, with every row taking part as it was guessed to, says how the bodies move and so by what every
//! span is stretched. [`crate::rope::light`] tells what the sheaves do under these stretches x, the sign of a rope's or
//! contact's own stretch whether it carries. Where that is what was guessed, the step is found, else it is the next guess:
//! Newton's method for
//!
//! ```text
//! φ(v) = A v − p + h Gᵀ P(x(v)) = 0        P the forces as they should be
//! ```
//!
//! which is linear in pieces. Rope that is nearly loose has pieces so small that it may jump over and back. With d the
//! step that it takes, d·φ then has a zero on the way, to which it goes instead. All the rest is linear in v and balances the
//! forces P̄ of the solutions it comes from, so with X the stretches of the rows along d, over a time of h + τ,
//!
//! ```text
//! d·φ = h Σ X (P − P̄)/(h + τ)
//! ```

use super::brakes::Holding;
use super::complementarity::{Mode, Problem};
use crate::constraint::Law;
use crate::constraint::brake::share_of_ratio;
use crate::rope::light::{Division, Spans};
use crate::system::{LightSheaves, System};

/// Rounds to find a zero on the way.
const SEARCH: usize = 30;
/// Where d·φ has the other sign after the step, and more than this share of its size before, a zero is looked for on the way.
const BEYOND: f64 = 0.5;
/// Share of d·φ before the step that may be left there.
const LEFT: f64 = 0.1;

/// Solutions after which Newton's method goes in circles, and then not all of the way, but shares that never come again.
const STRAIGHT: usize = 12;
/// Of the golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// All rows of a step that are linear in pieces.
#[derive(Debug, Clone)]
pub struct Balance {
    ropes: Vec<LightRope>,
    singles: Vec<Single>,
    /// Rows that these are.
    pub has: Vec<bool>,
    /// Those of them that a rope over light sheaves is divided into, and of what these lose.
    pub is_divided: Vec<bool>,
    /// Solutions that there are to start from.
    solutions: usize,
}

/// A rope, or a contact across, that takes part by itself.
#[derive(Debug, Clone)]
struct Single {
    row: usize,
    /// ε/(h + τ).
    softness: f64,
    /// What its law asks for, and its force, of the solution [N].
    found: [f64; 2],
    /// The same of where Newton's method is.
    here: [f64; 2],
    /// What its law asks for between both.
    between: f64,
}

/// A row of light sheaves, as vectors over its spans.
#[derive(Debug, Clone)]
struct LightRope {
    /// How it should be divided.
    division: Division,
    /// S⁻¹, S = |∂g/∂s|.
    per_supply: Vec<f64>,
    /// Of unstretched rope per tension S T.
    compliance: Vec<f64>,
    /// h + τ [s].
    reach: f64,
    /// What of all stretches together is rounding.
    noise: f64,
    /// x if nothing passes, and tensions S T, of the solution.
    found: [Vec<f64>; 2],
    /// The same of where Newton's method is.
    here: [Vec<f64>; 2],
    /// x between both.
    between: Vec<f64>,
}

/// A solution, and how rows take part, which is told what follows.
pub struct Guess<'a> {
    /// What laws ask for [N].
    pub trial: &'a [f64],
    /// What of it is rounding [N].
    pub noise: &'a [f64],
    /// Forces [N].
    pub tension: &'a [f64],
    /// Velocities.
    pub v: &'a [f64],
    /// Modes.
    pub modes: &'a mut [Mode],
    /// All brakes.
    pub brakes: &'a mut [Holding],
}

impl Single {
    fn read(&mut self, guess: &Guess) {
        self.found = [guess.trial[self.row], guess.tension[self.row]];
    }

    /// Its part of d·φ/h at the share `theta` of the way to what was found.
    fn slope(&mut self, theta: f64) -> f64 {
        let [between, balanced] = [0, 1].map(|k| self.here[k] + theta * (self.found[k] - self.here[k]));
        self.between = between;
        (self.found[0] - self.here[0]) * self.softness * (between.max(0.0) - balanced)
    }

    fn go(&mut self, theta: f64) {
        for (here, found) in self.here.iter_mut().zip(self.found) {
            *here += theta * (found - *here);
        }
    }

    /// How it should take part; as it does where rounding alone says something else.
    fn mode(&self, guess: &Guess) -> Mode {
        let carries = match guess.modes[self.row] {
            Mode::Slack => self.between > guess.noise[self.row],
            _ => self.between >= -guess.noise[self.row],
        };
        if carries { Mode::Acting } else { Mode::Slack }
    }
}

impl LightRope {
    fn new(light: &LightSheaves) -> Self {
        let room = || vec![0.0; light.rows.len()];
        Self {
            division: Division::new(light.dofs.len()),
            per_supply: room(),
            compliance: room(),
            reach: 0.0,
            noise: 0.0,
            found: [room(), room()],
            here: [room(), room()],
            between: room(),
        }
    }

    fn read(&mut self, system: &System, light: &LightSheaves, h: f64, guess: &Guess) {
        self.reach = h + system.rows.laws[light.rows.start].damping_time();
        self.noise = 0.0;
        for (index, row) in light.rows.clone().enumerate() {
            let after = light.dofs.get(index).map_or(0.0, |&dof| guess.v[dof]);
            let before = index.checked_sub(1).map_or(0.0, |sheave| guess.v[light.dofs[sheave]]);
            let (per, compliance) = (self.per_supply[index], system.rows.laws[row].compliance());
            self.compliance[index] = compliance * per * per;
            self.found[0][index] = guess.trial[row] * compliance * per - self.reach * (after - before);
            self.found[1][index] = guess.tension[row] / per;
            self.noise += guess.noise[row] * compliance * per;
        }
    }

    /// Its part of d·φ/h at the share `theta` of the way to what was found, where it is divided.
    fn slope(&mut self, light: &LightSheaves, theta: f64) -> f64 {
        for ((between, here), found) in self.between.iter_mut().zip(&self.here[0]).zip(&self.found[0]) {
            *between = here + theta * (found - here);
        }
        let Self { division, between: stretch, compliance, .. } = self;
        division.slips.is_loose = stretch.iter().sum::<f64>() <= 0.0;
        if division.slips.is_loose {
            division.slips.way.fill(0);
            division.tension.fill(0.0);
        } else {
            division.divide(Spans { ratio: &light.ratio, stretch, compliance, softening: 0.0 });
        }
        let change = |k: usize| self.found[k].iter().zip(&self.here[k]);
        let moved = change(0).map(|(found, here)| found - here);
        let balanced = change(1).map(|(found, here)| here + theta * (found - here));
        let parts = moved.zip(division.tension.iter().zip(balanced));
        parts.map(|(moved, (divided, balanced))| moved * (divided - balanced)).sum::<f64>() / self.reach
    }

    fn go(&mut self, theta: f64) {
        for (here, found) in self.here.iter_mut().zip(&self.found) {
            here.iter_mut().zip(found).for_each(|(here, found)| *here += theta * (found - *here));
        }
    }

    /// Its own mode as it was divided last.
    fn mode(&self) -> Mode {
        if self.division.slips.is_loose { Mode::Slack } else { Mode::Acting }
    }

    /// What its brakes should do as it was divided last: their rows, modes and ways.
    fn sheaves<'a>(&'a self, light: &'a LightSheaves) -> impl Iterator<Item = (usize, Mode, i8)> + 'a {
        light.brakes.iter().zip(&self.division.slips.way).map(|(&row, &way)| {
            let mode = if way == 0 { Mode::Acting } else { Mode::Slipping };
            (row, mode, way)
        })
    }

    /// True where it is just as long as its way, without any tension: that is so whether it counts as loose or not.
    fn is_just_loose(&self) -> bool {
        let mut stretches = self.found[1].iter().zip(&self.compliance);
        self.found[0].iter().sum::<f64>().abs() <= self.noise
            && stretches.all(|(tension, compliance)| (tension * compliance).abs() <= self.noise)
    }

    /// True where that is how the guess had it.
    fn agrees(&self, light: &LightSheaves, first_brake: usize, guess: &Guess) -> bool {
        if self.is_just_loose() {
            return true;
        }
        guess.modes[light.rows.start] == self.mode()
            && self.sheaves(light).all(|(row, mode, way)| {
                let as_guessed = way == 0 || guess.brakes[row - first_brake].way == f64::from(way);
                guess.modes[row] == mode && as_guessed
            })
    }

    /// Makes it the next guess.
    fn tell(&self, light: &LightSheaves, first_brake: usize, guess: &mut Guess) {
        guess.modes[light.rows.clone()].fill(self.mode());
        for (row, mode, way) in self.sheaves(light) {
            guess.modes[row] = mode;
            if way != 0 {
                guess.brakes[row - first_brake].way = f64::from(way);
            }
        }
    }
}

impl Balance {
    /// Room for the rows of a system; none where it has no light sheaves.
    pub fn new(system: &System) -> Self {
        let mut is_divided = vec![false; system.rows.count()];
        for light in &system.light {
            light.rows.clone().chain(light.brakes.iter().copied()).for_each(|row| is_divided[row] = true);
        }
        let mut has = is_divided.clone();
        let soft = |row: &usize| matches!(system.rows.laws[*row], Law::Unilateral { compliance, .. } if compliance > 0.0);
        let rows: Vec<usize> = if system.light.is_empty() {
            Vec::new()
        } else {
            (0..has.len()).filter(|row| !has[*row]).filter(soft).collect()
        };
        rows.iter().for_each(|&row| has[row] = true);
        let single = |row| Single { row, softness: 0.0, found: [0.0; 2], here: [0.0; 2], between: 0.0 };
        Self {
            ropes: system.light.iter().map(LightRope::new).collect(),
            singles: rows.into_iter().map(single).collect(),
            has,
            is_divided,
            solutions: 0,
        }
    }

    /// Begins a step with the gradients at its start: ρ is that of the tensions S T, by which rope pulls at its sheaves.
    ///
    /// At the start of a run spans are slack or not each by itself: over light sheaves they then all carry.
    pub fn begin(&mut self, system: &System, gradient: &[f64], modes: &mut [Mode], brakes: &mut [Holding]) {
        let first_brake = system.first_brake_row();
        for (light, rope) in system.light.iter().zip(&mut self.ropes) {
            let spans = &mut modes[light.rows.clone()];
            if spans.contains(&Mode::Acting) && spans.contains(&Mode::Slack) {
                spans.fill(Mode::Acting);
            }
            for (index, row) in light.rows.clone().enumerate() {
                let flow = light.dofs[index.min(light.dofs.len() - 1)];
                let supply = system.rows.entries(gradient, row).find(|(dof, _)| *dof == flow);
                rope.per_supply[index] = supply.map_or(1.0, |(_, supply)| supply.abs().recip());
            }
            // The search starts from what the state knows, as after a restore: the same bytes.
            for (way, &row) in rope.division.slips.way.iter_mut().zip(&light.brakes) {
                let towards = brakes[row - first_brake].way;
                *way = if modes[row] == Mode::Slipping { if towards > 0.0 { 1 } else { -1 } } else { 0 };
            }
            for (row, ratio) in light.brakes.iter().zip(&light.ratio) {
                for (span, weight) in &mut brakes[row - first_brake].pressed {
                    *weight = share_of_ratio(*ratio) / rope.per_supply[*span - light.rows.start];
                }
            }
        }
    }

    /// The next solution is of another problem than those before it.
    pub fn forget(&mut self) {
        self.solutions = 0;
    }

    /// After a solution, sets how rows take part in the next; true where that is how they did.
    pub fn settle(&mut self, system: &System, problem: &Problem, mut guess: Guess) -> bool {
        for (light, rope) in system.light.iter().zip(&mut self.ropes) {
            rope.read(system, light, problem.h, &guess);
        }
        for single in &mut self.singles {
            let law = &system.rows.laws[single.row];
            single.softness = law.compliance() / (problem.h + law.damping_time());
            single.read(&guess);
        }
        if self.solutions == 0 {
            self.go(1.0);
        }
        self.solutions += 1;
        let last = self.slope(system, guess.modes, 1.0);
        if self.agrees(system, &guess) {
            return true;
        }
        let mut theta = self.search(system, guess.modes, last);
        if self.solutions > STRAIGHT {
            theta *= (GOLDEN * self.solutions as f64).fract();
        }
        self.slope(system, guess.modes, theta);
        self.go(theta);
        self.tell(system, &mut guess);
        false
    }

    /// True where all rows should take part as they were guessed to.
    fn agrees(&self, system: &System, guess: &Guess) -> bool {
        let first_brake = system.first_brake_row();
        let mut ropes = system.light.iter().zip(&self.ropes);
        let mut singles = self.singles.iter();
        ropes.all(|(light, rope)| {
            guess.modes[light.rows.start].is_absent() || rope.agrees(light, first_brake, guess)
        }) && singles.all(|single| {
            let mode = guess.modes[single.row];
            mode.is_absent() || single.mode(guess) == mode
        })
    }

    /// Makes how they should take part where they were looked at last the next guess.
    fn tell(&self, system: &System, guess: &mut Guess) {
        let first_brake = system.first_brake_row();
        for (light, rope) in system.light.iter().zip(&self.ropes) {
            if !guess.modes[light.rows.start].is_absent() {
                rope.tell(light, first_brake, guess);
            }
        }
        for single in &self.singles {
            if !guess.modes[single.row].is_absent() {
                guess.modes[single.row] = single.mode(guess);
            }
        }
    }

    fn go(&mut self, theta: f64) {
        self.ropes.iter_mut().for_each(|rope| rope.go(theta));
        self.singles.iter_mut().for_each(|single| single.go(theta));
    }

    /// d·φ/h at the share `theta` of the way; all rows are then as they should be there.
    fn slope(&mut self, system: &System, modes: &[Mode], theta: f64) -> f64 {
        let ropes = system.light.iter().zip(&mut self.ropes);
        let ropes = ropes.filter(|(light, _)| !modes[light.rows.start].is_absent());
        let singles = self.singles.iter_mut().filter(|single| !modes[single.row].is_absent());
        ropes.map(|(light, rope)| rope.slope(light, theta)).sum::<f64>()
            + singles.map(|single| single.slope(theta)).sum::<f64>()
    }

    /// How far to go: all the way, or where that would lead too far, with d·φ/h = `last` there, to the zero of it or just
    /// beyond. False position with the Illinois rule.
    fn search(&mut self, system: &System, modes: &[Mode], last: f64) -> f64 {
        let first = self.slope(system, modes, 0.0);
        if first >= 0.0 || last <= -BEYOND * first {
            return 1.0;
        }
        let ((mut low, mut below), (mut high, mut above)) = ((0.0, first), (1.0, last));
        let mut reached = last;
        for _ in 0..SEARCH {
            let middle = low + (high - low) * (below / (below - above)).clamp(0.05, 0.95);
            let slope = self.slope(system, modes, middle);
            if slope < 0.0 {
                (low, below) = (middle, slope);
                above *= 0.5;
            } else {
                (high, above, reached) = (middle, slope, slope);
                below *= 0.5;
            }
            if reached <= -LEFT * first {
                break;
            }
        }
        high
    }
}
