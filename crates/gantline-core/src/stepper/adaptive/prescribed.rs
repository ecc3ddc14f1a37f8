//! What prescribed motion alone decides: forces of rows between bodies that drives move, and what those drives pull
//! with where nothing free hangs on them.
//!
//! That motion is known, so that no error of a solution tells how its forces go in a step, and a step would be as long
//! as the plan lets it. But what is recorded of them, which of them change sides, and their work follow from a few
//! looks at the step ([`super::looks`]): it must be short enough for these. The polynomial through the start and the
//! first four looks foretells the last look, at the end,
//!
//! ```text
//! f(1) − p₄(1) = Σ wₖ f(tₖ)        w₅ = 1        wₖ = −Π (1 − tⱼ)/(tₖ − tⱼ) over j ≤ 4 but k
//! ```
//!
//! What it misses falls with h⁵, as the method's own estimate does. All looks together miss less than that.
//!
//! Where something free hangs on a drive, how that moves bounds the step; unless it is balanced, and then only what
//! the drive turns is left: see [`TURN`].
//!
//! What waves do to a vessel whose motion is known is no polynomial, nor is what drives do that go a way together. A step
//! ends where such a motion has what it moves, and is as short as the course between asks, of which the middle is compared
//! with it.

use super::course::Course;
use super::error::ROUNDING;
use super::evaluation::Evaluation;
use super::light::Laying;
use super::looks::{POINTS, TIMES};
use super::point::Point;
use super::{Adaptive, LOOKS};
use crate::constraint::Law;
use crate::plan::drive::Timeline;
use crate::state::State;
use crate::system::System;
use crate::tree::joint::Motion;

/// w, see above.
const WEIGHTS: [f64; POINTS] = {
    let mut weights = [1.0; POINTS];
    let last = POINTS - 1;
    let mut k = 0;
    while k < last {
        weights[k] = -1.0;
        let mut j = 0;
        while j < last {
            if j != k {
                weights[k] *= (TIMES[last] - TIMES[j]) / (TIMES[k] - TIMES[j]);
            }
            j += 1;
        }
        k += 1;
    }
    weights
};
/// Where the course of a force has a kink no step is short enough to foretell it: shorter ones than this [s] are not
/// asked.
const SHORTEST: f64 = 1e-6;

/// A drive turns by no more than this in a step [rad]. What weight does then goes by a sine of which Gauss's four points
/// miss 6e-10, whatever hangs on it and does not notice.
const TURN: f64 = 1.0;

/// Steps in the mean period of what waves do to a drive: none of a course that is sampled less often can be told.
const STEPS_IN_WAVE: f64 = 8.0;

/// Rows and drives that nothing free has a part in, and what the looks of a step say of them.
#[derive(Debug, Clone)]
pub struct Prescribed {
    /// Elastic rows between bodies that drives move.
    rows: Vec<usize>,
    /// Driven degrees of freedom that move only what is driven.
    dofs: Vec<usize>,
    /// What was foretold wrong of them [N or N m], rows first.
    missed: Vec<f64>,
    /// Their largest values.
    largest: Vec<f64>,
}

impl Prescribed {
    /// Those of `system`.
    pub fn new(system: &System) -> Self {
        let driven = |dof: &usize| system.driven[*dof].is_some();
        let dofs_of = |row: usize| &system.rows.dofs[system.rows.start[row]..system.rows.start[row + 1]];
        let told = |row: usize| dofs_of(row).iter().all(driven);
        let elastic = |row: &usize| {
            let law = &system.rows.laws[*row];
            matches!(law, Law::Unilateral { .. } | Law::Spring { .. }) && law.compliance() > 0.0
        };
        let all = 0..system.rows.count();
        let rows: Vec<usize> =
            all.clone().filter(elastic).filter(|&row| !dofs_of(row).is_empty() && told(row)).collect();
        // What pays rope out, or pumps, moves no body: its drive pulls with the tension of a rope, if with any.
        let alone = |dof: &usize| {
            let mut below = system.tree.subtree[system.tree.owner[*dof]].iter();
            below.all(|&body| system.tree.bodies[body].dofs().all(|dof| driven(&dof)))
                && all.clone().filter(|&row| dofs_of(row).contains(dof)).all(told)
                && !system.flows.contains(dof)
        };
        let dofs: Vec<usize> = (0..system.tree.velocities).filter(driven).filter(alone).collect();
        let count = rows.len() + dofs.len();
        Self { rows, dofs, missed: vec![0.0; count], largest: vec![0.0; count] }
    }

    fn begin(&mut self) {
        self.missed.fill(0.0);
        self.largest.fill(0.0);
    }

    /// Notes the forces at point k of [`TIMES`].
    fn note(&mut self, k: usize, at: &Evaluation) {
        let rows = self.rows.iter().map(|&row| at.trial[row]);
        let forces = rows.chain(self.dofs.iter().map(|&dof| at.imbalance[dof]));
        for ((missed, largest), force) in self.missed.iter_mut().zip(&mut self.largest).zip(forces) {
            *missed += WEIGHTS[k] * force;
            *largest = largest.max(force.abs());
        }
    }

    /// The worst of what was foretold wrong, in tolerances of tension `tolerance` [N]; torques count at their `arm` [m].
    fn worst(&self, arm: &[f64], tolerance: f64) -> f64 {
        let arms = self.rows.iter().map(|_| 1.0).chain(self.dofs.iter().map(|&dof| arm[dof]));
        let missed = self.missed.iter().zip(&self.largest).zip(arms);
        missed.fold(0.0, |worst: f64, ((missed, largest), arm)| {
            worst.max(missed.abs() / (tolerance * arm).max(ROUNDING * largest))
        })
    }
}

/// A step of at most `h` [s] in which no drive turns by more than [`TURN`].
pub fn turning_limit(system: &System, state: &State, h: f64) -> f64 {
    let mut limit = h;
    let turning = system.drives.iter().zip(&state.plan.timelines);
    for (_, timeline) in turning.filter(|(drive, _)| system.tree.motions[drive.dof] == Motion::Turn) {
        let from = timeline.motion(state.time).position;
        while (timeline.motion(state.time + limit).position - from).abs() > TURN {
            limit *= 0.5;
        }
    }
    limit
}

/// No step is longer while waves move a drive [s].
pub fn wave_limit(state: &State) -> f64 {
    let waves = state.plan.timelines.iter().filter_map(Timeline::waves);
    waves.map(|waves| waves.mean_period() / STEPS_IN_WAVE).fold(f64::INFINITY, f64::min)
}

impl Adaptive {
    /// Lets the step that has been computed, of length `h` [s], end where drives are that move by no polynomial; by how much
    /// its course missed them, at its end or half-way, in tolerances of positions. As an error of their coordinates that
    /// counts for tensions, too.
    pub(super) fn end_on_curves(&mut self, system: &System, state: &State, h: f64) -> f64 {
        if system.drives.iter().all(|drive| !drive.curved) {
            return 0.0;
        }
        self.rodas.course.at(0.5, &mut self.point);
        let mut missed = 0.0_f64;
        let moved = system.prescribed(&state.plan.timelines);
        for (drive, timeline) in moved.filter(|(drive, _)| drive.curved) {
            let (dof, from) = (drive.dof, state.q[system.tree.bodies[drive.body].first_position]);
            let ends = [0.5, 1.0].map(|theta| timeline.motion(state.time + theta * h));
            let ways = [self.point.phi[dof], self.rodas.course.end.phi[dof]];
            let misses = ways.into_iter().zip(&ends).map(|(way, end)| (from + way - end.position).abs());
            let most = misses.fold(0.0, f64::max);
            missed = missed.max(most * self.weights.arm[dof] / self.tolerance.position);
            // What hangs on it has followed the course: its end is taken from under it by so much.
            let Course { end, error, .. } = &mut self.rodas.course;
            error.phi[dof] = most;
            (end.phi[dof], end.v[dof], end.a[dof]) =
                (ends[1].position - from, ends[1].velocity, ends[1].acceleration);
        }
        missed
    }

    /// Lets the part of the step that is made end where drives are that move by no polynomial, by a way that grows along it
    /// evenly. If it jumped there, no look would see the work of it: a micrometre under 2500 t is 25 J.
    pub(super) fn follow_curves(&mut self, system: &System, state: &State) {
        if self.made == 1.0 || system.drives.iter().all(|drive| !drive.curved) {
            return;
        }
        let course = &mut self.rodas.course;
        course.at(self.made, &mut self.point);
        let time = state.time + self.made * course.h;
        let moved = system.prescribed(&state.plan.timelines);
        for (drive, timeline) in moved.filter(|(drive, _)| drive.curved) {
            let (dof, from) = (drive.dof, state.q[system.tree.bodies[drive.body].first_position]);
            let (there, Course { end, .. }) = (timeline.motion(time), &mut *course);
            end.phi[dof] += (there.position - from - self.point.phi[dof]) / self.made;
            end.v[dof] += (there.velocity - self.point.v[dof]) / self.made;
            end.a[dof] += (there.acceleration - self.point.a[dof]) / self.made;
        }
    }

    /// How well looks at the step that has been computed, of length `h` [s], tell the forces that prescribed motion
    /// alone decides, in tolerances; at most 1 is good.
    pub(super) fn foretell(&mut self, system: &System, state: &State, h: f64) -> f64 {
        if self.prescribed.missed.is_empty() || h < SHORTEST {
            return 0.0;
        }
        self.prescribed.begin();
        self.prescribed.note(0, &self.rodas.here);
        for (index, theta) in LOOKS.into_iter().enumerate() {
            self.rodas.course.at(theta, &mut self.point);
            self.rodas.course.rate_at(theta, &mut self.rate);
            let laying = Laying::Frozen(&self.rodas.here.light);
            let point = Point { a: &self.rate.v, laying, ..Point::of(state, &self.point, theta * h) };
            self.probe.forces(system, &point, &state.modes);
            self.prescribed.note(index + 1, &self.probe);
        }
        self.prescribed.worst(&self.weights.arm, self.tolerance.tension)
    }
}
