//! Light sheaves in a step: what passes them follows from the lengths of their rope.
//!
//! In a step sheaves go on to slip or to hold as they do at its start, as all modes do, and the tensions of spans between
//! which sheaves slip are shares of one. At every look at its course the rope is divided anew, from where the look
//! before has left it. As far as the tensions differ the sheaves have turned over; where the difference reaches
//! [`TURNED`] the step is cut, and at its end the rope lies as it should.
//!
//! The flows are no motion of their own. In the matrix they stand as unknowns that let strains fit: a sheave that
//! holds passes nothing, one that slips keeps the ratio of the tensions on its sides,
//!
//! ```text
//! x_s = 0        or        δT₊ − ρ^{±1} δT₋ = 0,    δT = w y − κ² T δL/2L
//! ```
//!
//! y being κ times the increments of the rows' forces, w the tension per force of a row, δL what passes.

use std::ops::Range;

use super::Adaptive;
use super::evaluation::Evaluation;
use super::point::Point;
use crate::constraint::rope::Rope;
use crate::constraint::rope::span::Stretch;
use crate::constraint::{AnyConstraint, Moving};
use crate::rope::coil::Coil;
use crate::rope::light::{Division, Slips, Spans};
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::stepper::coils::feeding;
use crate::system::{LightSheaves, System};

/// How far the tensions over a row of light sheaves, root mean square, may be from what they should be before the step is
/// cut, in tolerances of tension.
const TURNED: f64 = 0.25;
/// Newton's steps for the tensions of a rope, at most: strains are small, so that two are enough nearly always.
const STEPS: usize = 6;
/// Change of a tension, relative to EA, after which the next step would be rounding.
const CLOSE: f64 = 1e-8;

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
    /// What has passed every sheave as it should be, where that was looked for [m].
    judged: Vec<f64>,
    /// Which sheaves slip in what follows.
    pub moving: Slips,
    /// w, −∂g/∂L and L of every span.
    pub answers: Vec<[f64; 3]>,
}

impl Light {
    /// Room for all light sheaves of a system.
    pub fn all(system: &System) -> Vec<Self> {
        let room = |light: &LightSheaves| {
            let division = Division::new(light.dofs.len());
            Self {
                moving: division.slips.clone(),
                answers: vec![[1.0; 3]; light.rows.len()],
                judged: vec![0.0; light.dofs.len()],
                lies: division.clone(),
                other: division.clone(),
                runs: division,
            }
        };
        system.light.iter().map(room).collect()
    }

    /// How far tensions are from what they should be, root mean square, over how far they may be, in units of a
    /// tolerance [N].
    fn turned(&self) -> f64 {
        let pairs = self.lies.tension.iter().zip(&self.other.tension);
        let sum: f64 = pairs.map(|(one, other)| (one - other).powi(2)).sum();
        (sum / self.lies.tension.len() as f64).sqrt() / TURNED
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
                self.way[index] = now.other.slips.way[sheave];
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

/// The rope that runs over a row of light sheaves, if it is one, and where its first span stands among its spans.
fn rope_of<'a>(system: &'a System, light: &LightSheaves) -> Option<(&'a Rope, usize)> {
    match &system.constraints[light.rope] {
        AnyConstraint::Rope(rope) => Some((rope, light.rows.start - system.rows.first[light.rope])),
        _ => None,
    }
}

impl Evaluation {
    /// Measures the ropes over light sheaves and divides them; coordinates and velocities of their flows follow. The
    /// velocities of the bodies are known.
    pub(super) fn divide(&mut self, system: &System, at: &Point, modes: &[Mode]) {
        let (mut first, mut measured) = (0, usize::MAX);
        for (index, light) in system.light.iter().enumerate() {
            let Some((rope, place)) = rope_of(system, light) else { continue };
            if measured != light.rope {
                measured = light.rope;
                self.measure(system, at, (light.rope, rope));
            }
            let spans = place..place + light.rows.len();
            let own = first..first + light.dofs.len();
            first = own.end;
            let mut both = std::mem::take(&mut self.light[index]);
            let on = (light, rope, spans);
            let drums = (at.coils, modes);
            place_all(light, &mut self.q, |sheave| at.base[light.positions[sheave]]);
            match at.laying {
                Laying::Anew => {
                    for (way, &row) in both.lies.slips.way.iter_mut().zip(&light.brakes) {
                        *way = way_of(modes, at.memory, row);
                    }
                    self.lay(on.clone(), &mut both.lies, false);
                    self.run(system, on, drums, (&mut both, false));
                }
                Laying::Frozen(frozen) => self.freeze(system, on, drums, (&mut both, &frozen[index])),
                Laying::Watched(frozen, laid) => {
                    self.freeze(system, on.clone(), drums, (&mut both, &frozen[index]));
                    self.judge(on, &mut both, (laid, own), at.schedule.time);
                    let passed = &both.lies.passed;
                    place_all(light, &mut self.q, |sheave| at.base[light.positions[sheave]] + passed[sheave]);
                }
                Laying::Laid(frozen, laid) => {
                    self.freeze(system, on.clone(), drums, (&mut both, &frozen[index]));
                    self.judge(on.clone(), &mut both, (laid, own), at.schedule.time);
                    let Light { lies, other, .. } = &mut both;
                    std::mem::swap(lies, other);
                    self.run(system, on, drums, (&mut both, false));
                }
            }
            self.light[index] = both;
        }
    }

    /// Lengths of the spans of a rope and their rates, in place of values and rates of its rows.
    fn measure(&mut self, system: &System, at: &Point, (index, rope): (usize, &Rope)) {
        let own = system.rows.first[index]..system.rows.first[index + 1];
        let lines = system.rows.lines[index]..system.rows.lines[index + 1];
        let (kinematics, twists) = (&self.frame.kinematics, self.dynamics.twists.as_slice());
        let moving = Moving { kinematics, twists, q: &self.q, v: &self.v, seats: at.seats, spots: at.spots };
        let (length, rate) = (&mut self.frame.value[own.clone()], &mut self.rate[own]);
        rope.measure(&moving, length, rate, &mut self.lines[lines]);
    }

    /// Divides a rope with its sheaves going on as they do at another point.
    fn freeze(
        &mut self,
        system: &System,
        on: (&LightSheaves, &Rope, Range<usize>),
        drums: (&[Coil], &[Mode]),
        (both, frozen): (&mut Light, &Light),
    ) {
        both.lies.slips.copy_from(&frozen.moving);
        self.lay(on.clone(), &mut both.lies, true);
        self.run(system, on, drums, (both, true));
    }

    /// Divides a rope that has been frozen as it should be, from where it was laid.
    fn judge(
        &mut self,
        on: (&LightSheaves, &Rope, Range<usize>),
        both: &mut Light,
        (laid, own): (&Laid, Range<usize>),
        time: f64,
    ) {
        let light = on.0;
        both.other.slips.way.copy_from_slice(&laid.way[own.clone()]);
        for (sheave, (&position, &dof)) in light.positions.iter().zip(&light.dofs).enumerate() {
            self.q[position] = laid.farthest(own.start + sheave, time, [self.q[position], self.v[dof]]);
        }
        self.lay(on, &mut both.other, false);
        for (judged, &position) in both.judged.iter_mut().zip(&light.positions) {
            *judged = self.q[position];
        }
    }

    /// Divides a rope from where the flows of `q` have it, and lets them follow.
    fn lay(
        &mut self,
        (light, rope, spans): (&LightSheaves, &Rope, Range<usize>),
        lies: &mut Division,
        is_frozen: bool,
    ) {
        // ℓ T/(EA + T) = x + s_j − s_{j−1}, x = ℓ − L̂, linearised about what the tensions would be if nothing passed.
        let (rows, stiffness) = (light.rows.clone(), rope.material.axial_stiffness);
        let length = &self.frame.value[rows.clone()];
        let known = &mut self.known[rows.clone()];
        let mut excess = 0.0;
        let starts = length.iter().zip(&mut *known).zip(&mut lies.tension);
        for (span, ((length, known), tension)) in rope.spans[spans].iter().zip(starts) {
            let unstretched = span.unstretched(&self.q);
            *known = length - unstretched;
            excess += *known;
            *tension = stiffness * *known / unstretched;
        }
        if !is_frozen {
            lies.slips.is_loose = excess <= 0.0;
        }
        let (stretch, compliance) = (&mut self.stretch[rows.clone()], &mut self.compliance[rows.clone()]);
        let tried = &mut self.tried[rows];
        for _ in 0..STEPS {
            tried.copy_from_slice(&lies.tension);
            let linear = stretch.iter_mut().zip(&mut *compliance);
            let about = length.iter().zip(&*known).zip(&*tried);
            for ((stretch, compliance), ((length, known), tension)) in linear.zip(about) {
                let share = tension / (stiffness + tension);
                *compliance = length * (1.0 - share) * (1.0 - share) / stiffness;
                *stretch = known - length * share * share;
            }
            let given = Spans { ratio: &light.ratio, stretch, compliance };
            if is_frozen {
                lies.share(given)
            } else {
                lies.divide(given)
            }
            let changes = lies.tension.iter().zip(&*tried);
            let change = changes.fold(0.0_f64, |most, (now, tried)| most.max((now - tried).abs()));
            if change <= CLOSE * stiffness {
                break;
            }
        }
        if !is_frozen {
            lies.mark(&light.ratio);
        }
        for (&position, passed) in light.positions.iter().zip(&lies.passed) {
            self.q[position] += passed;
        }
    }

    /// Speeds over the sheaves: those that let dampers pull in the ratios of the springs.
    fn run(
        &mut self,
        system: &System,
        (light, rope, spans): (&LightSheaves, &Rope, Range<usize>),
        (wound, modes): (&[Coil], &[Mode]),
        (both, is_frozen): (&mut Light, bool),
    ) {
        let rows = light.rows.clone();
        for &dof in &light.dofs {
            self.v[dof] = 0.0;
        }
        let spans = &rope.spans[spans];
        for ((span, row), answer) in spans.iter().zip(rows.clone()).zip(&mut both.answers) {
            let Stretch { unstretched, scale, supply, .. } = span.stretch(&self.q, self.frame.value[row]);
            *answer = [scale, -supply, unstretched];
            self.stretch[row] = -scale * self.rate[row] / supply;
            self.compliance[row] = -system.rows.laws[row].compliance() / (scale * supply);
        }
        // What else feeds the rope does so at its ends.
        for place in [0, spans.len() - 1] {
            let (span, row) = (&spans[place], rows.start + place);
            let strain = self.frame.value[row] / both.answers[place][2] - 1.0;
            let outside = if modes[row].carries() { strain.max(0.0) } else { 0.0 };
            let coils = span.feeds.iter().filter_map(|feed| Some((feed.coil?, feed.dof)));
            let let_go = coils.map(|(coil, dof)| {
                feeding(&system.coils[coil], &wound[coil], &self.q, outside).1 * self.v[dof]
            });
            self.stretch[row] -= span.speed(&self.v) + let_go.sum::<f64>();
        }
        let Light { lies, runs, moving, .. } = both;
        let given = Spans {
            ratio: &light.ratio,
            stretch: &self.stretch[rows.clone()],
            compliance: &self.compliance[rows],
        };
        if is_frozen {
            runs.slips.copy_from(&lies.slips);
            runs.share(given);
        } else {
            runs.turn(given, &lies.slips);
        }
        moving.copy_from(&runs.slips);
        for (&dof, speed) in light.dofs.iter().zip(&runs.passed) {
            self.v[dof] = *speed;
        }
    }
}

/// Puts the flows of light sheaves where they are to be divided from.
fn place_all(light: &LightSheaves, q: &mut [f64], place: impl Fn(usize) -> f64) {
    for (sheave, &position) in light.positions.iter().enumerate() {
        q[position] = place(sheave);
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
        self.rodas.straighten(system, self.made, &self.end);
    }

    /// The same of the worst rope that carries.
    pub(super) fn turned(&self, system: &System, modes: &[Mode], at: &Evaluation) -> f64 {
        let taut = system.light.iter().zip(&at.light).filter(|(light, _)| carries(light, modes));
        taut.map(|(_, light)| light.turned()).fold(0.0, f64::max)
    }
}

/// Keeps which way light sheaves slip.
pub fn keep(system: &System, here: &Evaluation, state: &mut State) {
    for (light, now) in system.light.iter().zip(&here.light) {
        for (&row, &way) in light.brakes.iter().zip(&now.lies.slips.way) {
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
        for (row, [_, supply, _]) in light.rows.clone().zip(&now.answers) {
            moved[row] = system.rows.rate(&here.frame.gradient, row, r) / supply;
        }
        let mut first = 0;
        for sheave in 0..=light.dofs.len() {
            let step = light.ratio.get(sheave).and_then(|&ratio| now.moving.step(sheave, ratio));
            if step.is_none() {
                follow_row(system, (light, now), first..sheave + 1, (r, moved));
                first = sheave + 1;
            }
        }
    }
}

/// The same for spans between which all sheaves slip: of ġ_j/S_j = moved_j + u_j − u_{j−1}, S = −∂g/∂L, all w_j ġ_j/ε_j
/// are shares of one.
fn follow_row(
    system: &System,
    (light, now): (&LightSheaves, &Light),
    spans: Range<usize>,
    (r, moved): (&mut [f64], &[f64]),
) {
    let soft = |span: usize| {
        let [scale, supply, _] = now.answers[span];
        system.rows.laws[light.rows.start + span].compliance() / (scale * supply)
    };
    let step = |sheave: usize| now.moving.step(sheave, light.ratio[sheave]).unwrap_or(1.0);
    let (mut sum, mut slope, mut weight) = (0.0, 0.0, 1.0);
    for span in spans.clone() {
        sum += moved[light.rows.start + span];
        slope += weight * soft(span);
        if span + 1 < spans.end {
            weight *= step(span);
        }
    }
    let common = sum / slope;
    let (mut passed, mut weight) = (0.0, 1.0);
    for span in spans.start..spans.end - 1 {
        passed += weight * common * soft(span) - moved[light.rows.start + span];
        r[light.dofs[span]] = passed;
        weight *= step(span);
    }
}
