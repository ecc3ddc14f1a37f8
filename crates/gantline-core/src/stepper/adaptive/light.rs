//! Light sheaves in a step: what passes them follows from the lengths of their rope.
//!
//! In a step sheaves go on to slip or to hold as they do at its start, as all modes do, and the tensions of spans between
//! which sheaves slip are shares of one. At every look at its course the rope is divided anew, from where the look
//! before has left it. As far as the tensions differ the sheaves have turned over; where the difference reaches
//! what is [`allowed`] the step is cut, and at its end the rope lies as it should.
//!
//! The flows are no motion of their own. In the matrix they stand as unknowns that let strains fit: a sheave that
//! holds passes nothing, one that slips keeps the ratio of the tensions on its sides,
//!
//! ```text
//! x_s = 0        or        δT₊ − ρ^{±1} δT₋ = 0,    δT = w y − κ² T δL/2L
//! ```
//!
//! y being κ times the increments of the rows' forces, w the tension per force of a row, δL what passes.

mod dividing;

use std::ops::Range;

use super::Adaptive;
use super::distance::Far;
use super::evaluation::Evaluation;
use crate::rope::light::{Division, Slips};
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::system::{LightSheaves, System};

/// How far the tensions over a row of light sheaves, root mean square, may be from what they should be before the step is
/// cut, in tolerances of tension.
const TURNED: f64 = 0.25;
/// The same in mean tensions of the rope, where that is less: ratios count, however little hangs on a rope, since where it
/// lies while it is nearly loose decides how it shares once it is tight again.
const TURNED_SHARE: f64 = 0.075;
/// But never less than this, in tolerances of tension, for a rope that goes slack.
const TURNED_LEAST: f64 = 0.0075;

/// How far the tensions over a row of light sheaves may be from what they should be, root mean square, if their mean is
/// this [N].
fn allowed(mean: f64, tolerance: f64) -> f64 {
    (TURNED_SHARE * mean).clamp(TURNED_LEAST * tolerance, TURNED * tolerance)
}

/// Where rope lies on all light sheaves.
#[derive(Debug, Clone, Default)]
pub struct Laid {
    /// Rope that has passed every sheave since the start of the run [m].
    passed: Vec<f64>,
    /// Which way every sheave slipped last.
    way: Vec<i8>,
    /// When that was [s]; where the course of the step was then, which goes on as it began, and how fast [m, m/s].
    time: f64,
    course: Vec<f64>,
    speed: Vec<f64>,
}

/// How rope over light sheaves is to be divided at a point.
#[derive(Clone, Copy, Default)]
pub enum Laying<'a> {
    /// As it should be, from where the step starts.
    #[default]
    Anew,
    /// With the sheaves going on as they do at another point.
    Frozen(&'a [Light]),
    /// The same, and as it should be from where it was laid, to compare.
    Watched(&'a [Light], &'a Laid),
    /// As it should be from where it was laid; the other to compare.
    Laid(&'a [Light], &'a Laid),
}

/// Rope over one row of light sheaves at a point.
#[derive(Debug, Clone, Default)]
pub struct Light {
    /// As the forces have it, damping aside.
    lies: Division,
    /// As it should be where forces are frozen, as frozen where they are not.
    other: Division,
    /// Speeds, and rates of tensions.
    runs: Division,
    /// What has passed every sheave as it should be, where that was looked for [m], and which way it slips then.
    judged: Vec<f64>,
    judged_way: Vec<i8>,
    /// Forces of the rows at the end of a step with the sheaves going on as they did in it [N], but for what drums feed.
    pub arriving: Vec<f64>,
    /// Which sheaves slip in what follows.
    pub moving: Slips,
}

impl Light {
    /// Room for all light sheaves of a system.
    pub fn all(system: &System) -> Vec<Self> {
        let room = |light: &LightSheaves| {
            let division = Division::new(light.dofs.len());
            Self {
                moving: division.slips.clone(),
                judged: vec![0.0; light.dofs.len()],
                judged_way: vec![0; light.dofs.len()],
                arriving: vec![0.0; light.rows.len()],
                lies: division.clone(),
                other: division.clone(),
                runs: division,
            }
        };
        system.light.iter().map(room).collect()
    }

    /// How far tensions are from what they should be, root mean square.
    fn turned(&self, tolerance: f64) -> Far {
        let pairs = self.lies.tension.iter().zip(&self.other.tension);
        let sum: f64 = pairs.map(|(one, other)| (one - other).powi(2)).sum();
        let count = self.lies.tension.len() as f64;
        let mean = self.other.tension.iter().sum::<f64>() / count;
        Far::new((sum / count).sqrt(), allowed(mean, tolerance))
    }
}

fn way_of(modes: &[Mode], memory: &[f64], row: usize) -> i8 {
    match modes[row] {
        Mode::Slipping if memory[row] > 0.0 => 1,
        Mode::Slipping => -1,
        _ => 0,
    }
}

impl Laid {
    /// As a state has it.
    pub fn start(&mut self, system: &System, state: &State) {
        self.passed.clear();
        self.way.clear();
        self.speed.clear();
        for light in &system.light {
            self.passed.extend(light.positions.iter().map(|&position| state.q[position]));
            self.way.extend(light.brakes.iter().map(|&row| way_of(&state.modes, &state.memory, row)));
            self.speed.extend(light.dofs.iter().map(|&dof| state.v[dof]));
        }
        self.course.clone_from(&self.passed);
        self.time = state.time;
    }

    /// As it should be at a point that was watched, and as the course has it there.
    pub fn follow(&mut self, system: &System, at: &Evaluation, time: f64) {
        let mut index = 0;
        for (light, now) in system.light.iter().zip(&at.light) {
            for (sheave, (&position, &dof)) in light.positions.iter().zip(&light.dofs).enumerate() {
                self.passed[index] = now.judged[sheave];
                self.way[index] = now.judged_way[sheave];
                (self.course[index], self.speed[index]) = (at.q[position], at.v[dof]);
                index += 1;
            }
        }
        self.time = time;
    }

    /// Where a sheave is to be judged from at `time` [s], when the course has come to `course` [m] with `speed` [m/s]: if
    /// it has turned back since, from where it did.
    fn farthest(&self, sheave: usize, time: f64, [course, speed]: [f64; 2]) -> f64 {
        let way = f64::from(self.way[sheave]);
        if way * self.speed[sheave] <= 0.0 || way * speed >= 0.0 {
            return self.passed[sheave];
        }
        // Hermite's cubic in the share x of the time since; its slope c + b x + a x² falls through zero once.
        let long = time - self.time;
        let (c, end, gone) = (long * self.speed[sheave], long * speed, course - self.course[sheave]);
        let (a, b) = (3.0 * (c + end - 2.0 * gone), 6.0 * gone - 4.0 * c - 2.0 * end);
        let x = (-2.0 * c / (b - (b * b - 4.0 * a * c).max(0.0).sqrt().copysign(c))).clamp(0.0, 1.0);
        let top = self.course[sheave] + x * (c + x * (0.5 * b + x * a / 3.0));
        way * (way * self.passed[sheave]).max(way * top)
    }
}

impl Adaptive {
    /// The end of the part of the step that is made has the flows that follow there; so does its course.
    pub(super) fn lay(&mut self, system: &System, state: &State) {
        for light in &system.light {
            for (&position, &dof) in light.positions.iter().zip(&light.dofs) {
                self.end.phi[dof] = self.next.q[position] - state.q[position];
                (self.end.v[dof], self.end.a[dof]) = (self.next.v[dof], 0.0);
            }
        }
        self.rodas.course.straighten(system, self.made, &self.end);
    }

    /// The same of the ropes that carry.
    pub(super) fn turned(&self, system: &System, modes: &[Mode], at: &Evaluation) -> Far {
        let taut = system.light.iter().zip(&at.light).filter(|(light, _)| carries(light, modes));
        taut.map(|(_, light)| light.turned(self.tolerance.tension)).fold(Far::default(), Far::or)
    }
}

/// Keeps what has passed light sheaves, and which way they slip, as it was found at the end of a step.
pub fn keep(system: &System, here: &Evaluation, state: &mut State) {
    for (light, now) in system.light.iter().zip(&here.light) {
        for (&position, &passed) in light.positions.iter().zip(&now.judged) {
            state.q[position] = passed;
        }
        for (&row, &way) in light.brakes.iter().zip(&now.judged_way) {
            state.modes[row] = if way == 0 { Mode::Acting } else { Mode::Slipping };
            state.memory[row] = f64::from(way);
        }
    }
}

/// Whether all spans of a row of light sheaves carry.
pub fn carries(light: &LightSheaves, modes: &[Mode]) -> bool {
    light.rows.clone().all(|row| modes[row] == Mode::Acting)
}

/// The rates of the flows that belong to rates `r` of all others, with the sheaves slipping as they do at `here`: the
/// linear map that the matrix has too. `moved` is work space for every row.
pub fn follow(system: &System, here: &Evaluation, modes: &[Mode], (r, moved): (&mut [f64], &mut [f64])) {
    for (light, now) in system.light.iter().zip(&here.light) {
        for &dof in &light.dofs {
            r[dof] = 0.0;
        }
        if !carries(light, modes) {
            continue;
        }
        for (row, [_, supply, _]) in light.rows.clone().zip(&here.answers[light.rows.clone()]) {
            moved[row] = system.rows.rate(&here.frame.gradient, row, r) / supply;
        }
        let mut first = 0;
        for sheave in 0..=light.dofs.len() {
            let step = light.ratio.get(sheave).and_then(|&ratio| now.moving.step(sheave, ratio));
            if step.is_none() {
                follow_row(here, (light, now), first..sheave + 1, (r, moved));
                first = sheave + 1;
            }
        }
    }
}

/// The same for spans between which all sheaves slip: of ġ_j/S_j = moved_j + u_j − u_{j−1}, S = −∂g/∂L, all w_j ġ_j/ε_j
/// are shares of one.
fn follow_row(
    here: &Evaluation,
    (light, now): (&LightSheaves, &Light),
    spans: Range<usize>,
    (r, moved): (&mut [f64], &[f64]),
) {
    let rows = light.rows.start + spans.start..light.rows.start + spans.end;
    // ε/wS, as it has been found with the speeds.
    let (soft, moved) = (&here.compliance[rows.clone()], &moved[rows]);
    let sheaves = spans.start..spans.end - 1;
    let step = |sheave: usize| now.moving.step(sheave, light.ratio[sheave]).unwrap_or(1.0);
    let (mut sum, mut slope, mut weight) = (0.0, 0.0, 1.0);
    for (span, (moved, soft)) in spans.clone().zip(moved.iter().zip(soft)) {
        sum += moved;
        slope += weight * soft;
        if span + 1 < spans.end {
            weight *= step(span);
        }
    }
    let common = sum / slope;
    let (mut passed, mut weight) = (0.0, 1.0);
    for (span, (moved, soft)) in sheaves.zip(moved.iter().zip(soft)) {
        passed += weight * common * soft - moved;
        r[light.dofs[span]] = passed;
        weight *= step(span);
    }
}

#[cfg(test)]
mod tests {
    use super::allowed;

    /// A quarter of the tolerance, 7.5 % of the mean where that is less, and 0.75 % of the tolerance of what goes slack: at
    /// 400 N of tolerance 100 N, under a mean of 1 kN 75 N, under none 3 N.
    #[test]
    fn tensions_may_differ_by_a_share_of_tolerance_or_mean() {
        for (mean, expected) in
            [(1e6, 100.0), (1334.0, 100.0), (1e3, 75.0), (100.0, 7.5), (39.0, 3.0), (0.0, 3.0)]
        {
            assert!((allowed(mean, 400.0) - expected).abs() < 1e-9, "{mean}");
        }
    }
}
