//! Changes of the rows' modes: seen along the course of a step, made at its end.

use super::books::WEIGHTS;
use super::evaluation::{Evaluation, Point};
use super::rodas::Increment;
use super::{Adaptive, LOOKS, SWITCHING};
use crate::audit::Flows;
use crate::constraint::{AnyConstraint, Law};
use crate::event::{EventKind, EventLog};
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::system::System;

/// A rope whose ends come closer by more than this [m/s] loosens; less is rounding.
pub(super) const STANDSTILL: f64 = 1e-9;

/// What the laws ask at the shares [`LOOKS`] of a step.
#[derive(Debug, Clone)]
pub struct Looks {
    /// Without bound, of every row [N].
    trial: [Vec<f64>; LOOKS.len()],
    /// At the start of the step.
    start: Vec<f64>,
    /// How far every look is from its law, the worst row [N].
    far: [f64; LOOKS.len()],
}

impl Looks {
    /// Room for `system`.
    pub fn new(system: &System) -> Self {
        let zeros = || vec![0.0; system.rows.count()];
        Self { trial: std::array::from_fn(|_| zeros()), start: zeros(), far: [0.0; LOOKS.len()] }
    }
}

impl Adaptive {
    /// Looks at the course of the step that has been computed: how far rows are from their laws, and what flows.
    pub(super) fn look(&mut self, system: &System, state: &State) {
        self.looks.start.copy_from_slice(&self.rodas.here.trial);
        self.flows = Flows::default();
        let h = self.rodas.course.h;
        for (index, (theta, weight)) in LOOKS.into_iter().zip(WEIGHTS).enumerate() {
            self.book_look(system, state, theta, weight * h);
            self.looks.far[index] = self.farthest(system, state, &self.probe);
            self.looks.trial[index].copy_from_slice(&self.probe.trial);
        }
        self.set_driven(system, state);
        let Increment { phi, v, a, rigid, anchor } = &self.rodas.course.end;
        let point = Point { base: &state.q, memory: &state.memory, phi, v, a, rigid, anchor };
        self.next.all(system, &point, &state.modes);
        self.looks.far[WEIGHTS.len()] = self.farthest(system, state, &self.next);
        self.looks.trial[WEIGHTS.len()].copy_from_slice(&self.next.trial);
    }

    /// Puts driven joints exactly where their drives are at the end of the step, so that rounding does not add up.
    fn set_driven(&mut self, system: &System, state: &State) {
        let course = &mut self.rodas.course;
        let time = state.time + course.h;
        for (drive, timeline) in system.drives.iter().zip(&state.plan.timelines) {
            let motion = timeline.motion(time);
            let position = state.q[system.tree.bodies[drive.body].first_position];
            course.end.phi[drive.dof] = motion.position - position;
            course.end.v[drive.dof] = motion.velocity;
        }
    }

    /// Share of the step that may be made: up to where a row reaches the switching tolerance, or where the plan's
    /// condition is fulfilled.
    pub(super) fn cut(&mut self, system: &System, state: &State) -> f64 {
        let allowed = SWITCHING * self.tolerance.tension;
        let mut made = 1.0;
        if let Some(index) = self.looks.far.iter().position(|&far| far > allowed) {
            let mut low = if index == 0 { 0.0 } else { LOOKS[index - 1] };
            let mut high = LOOKS[index];
            // Anything between half of the tolerance and the tolerance will do. False position with the Illinois
            // rule: an end that stays counts half.
            let aim = |far: f64| far - 0.75 * allowed;
            let mut below = aim(if index == 0 { 0.0 } else { self.looks.far[index - 1] });
            let mut above = aim(self.looks.far[index]);
            for _ in 0..60 {
                let share = (below / (below - above)).clamp(0.01, 0.99);
                let middle = low + share * (high - low);
                self.probe_rows(system, state, middle);
                let far = self.farthest(system, state, &self.probe);
                if far > allowed {
                    (high, above) = (middle, aim(far));
                    below *= 0.5;
                } else {
                    (low, below) = (middle, aim(far));
                    above *= 0.5;
                    if far > 0.5 * allowed {
                        break;
                    }
                }
            }
            made = if low > 0.0 { low } else { high };
        }
        self.condition(system, state, made)
    }

    /// The share at which the condition of the plan is first fulfilled, or `made`.
    fn condition(&mut self, system: &System, state: &State, made: f64) -> f64 {
        if !self.fulfilled(system, state, made) {
            return made;
        }
        let (mut low, mut high) = (0.0, made);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if self.fulfilled(system, state, middle) { high = middle } else { low = middle }
        }
        high
    }

    fn fulfilled(&mut self, system: &System, state: &State, theta: f64) -> bool {
        if !state.plan.waits_for_condition() {
            return false;
        }
        self.probe_rows(system, state, theta);
        for (sum, group) in self.support.iter_mut().zip(&system.groups) {
            let normals = group.contacts.iter().map(|&contact| system.rows.first[contact]);
            *sum = normals.map(|row| self.probe.tension[row].max(0.0)).sum();
        }
        state.plan.is_fulfilled(&system.plan, &self.support)
    }

    /// The largest distance of a row from its law [N].
    fn farthest(&self, system: &System, state: &State, at: &Evaluation) -> f64 {
        (0..system.rows.count()).map(|row| self.distance(system, state, row, at)).fold(0.0, f64::max)
    }

    /// How far the frozen mode of a row is from its law [N]; not positive where it is right.
    fn distance(&self, system: &System, state: &State, row: usize, at: &Evaluation) -> f64 {
        match (system.rows.laws[row], state.modes[row]) {
            // An inextensible rope that is loosening need not be caught: only what it is longer than at the start.
            (Law::Unilateral { compliance: 0.0, .. }, Mode::Slack) if at.rate[row] < STANDSTILL => {
                at.trial[row] - self.looks.start[row].max(0.0)
            }
            (Law::Unilateral { .. }, Mode::Slack) => at.trial[row],
            (Law::Unilateral { .. }, _) => -at.trial[row],
            (Law::Friction { normal, .. }, _) if row != normal + 1 => 0.0,
            (Law::Friction { .. }, Mode::Slack) => 0.0,
            (Law::Friction { coefficient, normal, .. }, mode) => {
                let beyond = at.trial[row].hypot(at.trial[row + 1]) - coefficient * at.trial[normal].max(0.0);
                if mode == Mode::Slipping { -beyond } else { beyond }
            }
        }
    }

    /// Lets every row that has crossed over change side at the new state; true where any did. The step started
    /// at `start` [s] and was `length` [s] long.
    pub(super) fn switch(
        &mut self,
        system: &System,
        state: &mut State,
        log: &mut EventLog,
        start: f64,
        length: f64,
    ) -> bool {
        let mut any = false;
        for (index, constraint) in system.constraints.iter().enumerate() {
            let row = system.rows.first[index];
            if self.distance(system, state, row, &self.rodas.here) > 0.0 && !self.loosens(system, state, row)
            {
                any = true;
                let taut = state.modes[row] == Mode::Slack;
                state.modes[row] = if taut { Mode::Acting } else { Mode::Slack };
                state.engaged |= taut;
                let time = start + length * self.crossing(row);
                match constraint {
                    AnyConstraint::Rope(_) => {
                        log.push(time, if taut { EventKind::Taut } else { EventKind::Slack }, index);
                    }
                    AnyConstraint::Contact(contact) => {
                        let mode = if taut { Mode::Acting } else { Mode::Slack };
                        self.set_friction(system, state, row, mode);
                        self.log_group(system, state, log, contact.group, taut, time);
                    }
                }
            }
            if let AnyConstraint::Contact(_) = constraint {
                any |= self.switch_friction(system, state, log, index);
            }
        }
        any
    }

    /// True for a slack inextensible rope that is at its length and not about to be pulled: one that rounding, or
    /// another rope that is let go in the same moment, has put there.
    fn loosens(&self, system: &System, state: &State, row: usize) -> bool {
        let rigid = system.rows.laws[row].compliance() == 0.0;
        rigid && state.modes[row] == Mode::Slack && self.rodas.here.rate[row] < STANDSTILL
    }

    /// Sticking and sliding of the contact `index`.
    fn switch_friction(&self, system: &System, state: &mut State, log: &mut EventLog, index: usize) -> bool {
        let first = system.rows.first[index] + 1;
        if self.distance(system, state, first, &self.rodas.here) <= 0.0 {
            return false;
        }
        let sticks = state.modes[first] == Mode::Slipping;
        self.set_modes(state, first, if sticks { Mode::Acting } else { Mode::Slipping });
        log.push(state.time, if sticks { EventKind::Stick } else { EventKind::Slip }, index);
        true
    }

    /// Friction follows its normal force: a contact that closes sticks where it touches.
    fn set_friction(&mut self, system: &System, state: &mut State, normal: usize, mode: Mode) {
        let here = &mut self.rodas.here;
        for row in [normal + 1, normal + 2] {
            let law = &system.rows.laws[row];
            state.memory[row] += std::mem::take(&mut here.frame.value[row]);
            // The damper acts from the first moment.
            here.trial[row] = law.damping_time() * here.rate[row] / law.compliance();
        }
        self.set_modes(state, normal + 1, mode);
    }

    fn set_modes(&self, state: &mut State, first: usize, mode: Mode) {
        state.modes[first] = mode;
        state.modes[first + 1] = mode;
    }

    /// Lift-off when the last contact of a group has opened, set-down when the first has closed.
    fn log_group(
        &self,
        system: &System,
        state: &State,
        log: &mut EventLog,
        group: usize,
        closed: bool,
        time: f64,
    ) {
        let touching = system.groups[group].contacts.iter();
        let touching = touching.filter(|&&contact| state.modes[system.rows.first[contact]] != Mode::Slack);
        match (touching.count(), closed) {
            (0, false) => log.push(time, EventKind::LiftOff, group),
            (1, true) => log.push(time, EventKind::SetDown, group),
            _ => {}
        }
    }

    /// Share of the step that was made at which the trial force of a row went through zero.
    fn crossing(&self, row: usize) -> f64 {
        let course = RowCourse::through(self.looks.values(row));
        let new_sign = self.rodas.here.trial[row] > 0.0;
        let last = (1..POINTS).find(|&k| (course.values[k] > 0.0) == new_sign).unwrap_or(POINTS - 1);
        let (mut low, mut high) = (TIMES[last - 1], TIMES[last]);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if (course.at(middle) > 0.0) == new_sign { high = middle } else { low = middle }
        }
        (high / self.made).min(1.0)
    }

    /// The largest force of a rope in the last step [N] and the share of the step at which it was, where it is
    /// more than `least`.
    pub fn peak(&self, row: usize, least: f64) -> Option<(f64, f64)> {
        let values = self.looks.values(row);
        let highest = (0..POINTS).max_by(|&a, &b| values[a].total_cmp(&values[b]))?;
        // Between points 0.3 of a step apart a course that such steps can follow rises by a few per cent at most.
        if values[highest] < 0.9 * least {
            return None;
        }
        let course = RowCourse::through(values);
        let mut low = TIMES[highest.saturating_sub(1)].min(self.made);
        let mut high = TIMES[(highest + 1).min(POINTS - 1)].min(self.made);
        // To 1e-4 of the time between points; the value is right to the square of that.
        for _ in 0..24 {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if course.at(a) < course.at(b) { low = a } else { high = b }
        }
        let (share, value) = (0.5 * (low + high), course.at(0.5 * (low + high)));
        (value > least).then_some((value, share / self.made))
    }
}

/// The start of a step and its looks.
const POINTS: usize = LOOKS.len() + 1;

/// Shares of the step at the start and the looks.
const TIMES: [f64; POINTS] = [0.0, LOOKS[0], LOOKS[1], LOOKS[2], LOOKS[3], LOOKS[4]];

/// One over the time between point k and the one `order` before it, by order and k.
const SPANS: [[f64; POINTS]; POINTS] = {
    let mut spans = [[0.0; POINTS]; POINTS];
    let mut order = 1;
    while order < POINTS {
        let mut k = order;
        while k < POINTS {
            spans[order][k] = 1.0 / (TIMES[k] - TIMES[k - order]);
            k += 1;
        }
        order += 1;
    }
    spans
};

/// What the law asks of one row along a step: the polynomial through the start and the looks.
struct RowCourse {
    values: [f64; POINTS],
    /// Divided differences (Newton's form).
    terms: [f64; POINTS],
}

impl Looks {
    fn values(&self, row: usize) -> [f64; POINTS] {
        std::array::from_fn(|k| if k == 0 { self.start[row] } else { self.trial[k - 1][row] })
    }
}

impl RowCourse {
    fn through(values: [f64; POINTS]) -> Self {
        let mut terms = values;
        for order in 1..POINTS {
            for k in (order..POINTS).rev() {
                terms[k] = (terms[k] - terms[k - 1]) * SPANS[order][k];
            }
        }
        Self { values, terms }
    }

    fn at(&self, x: f64) -> f64 {
        let terms = self.terms.iter().zip(TIMES).rev();
        terms.fold(0.0, |sum, (term, time)| sum * (x - time) + term)
    }
}
