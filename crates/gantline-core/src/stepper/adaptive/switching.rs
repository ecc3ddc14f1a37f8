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

/// Speed of an anchor against the direction of sliding that counts as much as the switching tolerance of a force
/// [m/s].
const REVERSAL: f64 = 1e-6;

impl Adaptive {
    /// Looks at the course of the step that has been computed and decides how much of it is made: up to where a row
    /// reaches the switching tolerance, or where the plan's condition is fulfilled.
    pub(super) fn look(&mut self, system: &System, state: &State) {
        self.looks.note(system, 0, &self.rodas.here);
        self.made = 1.0;
        let allowed = SWITCHING * self.tolerance.tension;
        let crossed = self.survey(system, state, allowed);
        let made = crossed.map_or(1.0, |look| self.cut(system, state, look, allowed));
        let made = self.condition(system, state, made);
        if made < 1.0 {
            self.made = made;
            self.survey(system, state, f64::INFINITY);
        }
        self.looks.fit();
        if let Some(share) = self.first_break(system, state) {
            self.made = share;
            self.survey(system, state, f64::INFINITY);
            self.looks.fit();
        }
    }

    /// Looks along the part of the step that is made: what flows, and how far rows are from their laws; ends at the
    /// first look that is further than `allowed` [N] and tells which.
    fn survey(&mut self, system: &System, state: &State, allowed: f64) -> Option<usize> {
        self.flows = Flows::default();
        let length = self.made * self.rodas.course.h;
        for (index, (theta, weight)) in LOOKS.into_iter().zip(WEIGHTS).enumerate() {
            self.book_look(system, state, theta * self.made, weight * length);
            self.looks.note(system, index + 1, &self.probe);
            self.looks.far[index] = self.farthest(system, state, &self.probe);
            if self.looks.far[index] > allowed {
                return Some(index);
            }
        }
        self.arrive(system, state);
        self.looks.note(system, LOOKS.len(), &self.next);
        let last = LOOKS.len() - 1;
        self.looks.far[last] = self.farthest(system, state, &self.next);
        (self.looks.far[last] > allowed).then_some(last)
    }

    /// Evaluates the end of the part that is made. Driven joints are put exactly where their drives are, so that
    /// rounding does not add up.
    fn arrive(&mut self, system: &System, state: &State) {
        self.rodas.course.at(self.made, &mut self.end);
        let time = state.time + self.made * self.rodas.course.h;
        for (drive, timeline) in system.drives.iter().zip(&state.plan.timelines) {
            let motion = timeline.motion(time);
            let position = state.q[system.tree.bodies[drive.body].first_position];
            self.end.phi[drive.dof] = motion.position - position;
            self.end.v[drive.dof] = motion.velocity;
        }
        let Increment { phi, v, a, rigid } = &self.end;
        let point = Point { base: &state.q, memory: &state.memory, phi, v, a, rigid };
        self.next.all(system, &point, &state.modes, &state.slip);
    }

    /// Share of the step at which a row reaches the switching tolerance before the look `index`.
    fn cut(&mut self, system: &System, state: &State, index: usize, allowed: f64) -> f64 {
        let (mut low, mut high) = (if index == 0 { 0.0 } else { LOOKS[index - 1] }, LOOKS[index]);
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
        if low > 0.0 { low } else { high }
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
            (_, Mode::Parted) => 0.0,
            (Law::Unilateral { .. }, Mode::Slack) => at.trial[row],
            (Law::Unilateral { .. }, _) => -at.trial[row],
            (Law::Friction { normal, .. }, _) if row != normal + 1 => 0.0,
            (Law::Friction { .. }, Mode::Slack) => 0.0,
            (Law::Friction { coefficient, normal, .. }, Mode::Acting) => {
                at.trial[row].hypot(at.trial[row + 1]) - coefficient * at.trial[normal].max(0.0)
            }
            (Law::Friction { coefficient, normal, .. }, Mode::Slipping) => {
                // The anchor slides as long as the point moves faster than a growing bound stretches the spring.
                let along = at.rate[row] * state.slip[row] + at.rate[row + 1] * state.slip[row + 1];
                let anchor = along - coefficient * at.rate[normal];
                -anchor / REVERSAL * SWITCHING * self.tolerance.tension
            }
            (Law::Brake { .. }, Mode::Slack) => 0.0,
            (Law::Brake { .. }, Mode::Acting) => at.trial[row].abs() - at.bound[row],
            (Law::Brake { impedance, .. }, Mode::Slipping) => {
                (-at.rate[row] * state.slip[row] * impedance).min(2.0 * at.bound[row])
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
            match constraint {
                AnyConstraint::Rope(_) => any |= self.switch_rope(system, state, log, index, (start, length)),
                AnyConstraint::Brake(brake) => any |= self.switch_brake(system, state, index, brake.dof),
                AnyConstraint::Stop(_) => {
                    if let Some((hit, crossing)) = self.turn_over(system, state, system.rows.first[index]) {
                        any = true;
                        let kind = if hit { EventKind::StopHit } else { EventKind::StopLeft };
                        log.push(start + length * crossing, kind, index);
                    }
                }
                AnyConstraint::Contact(contact) => {
                    let row = system.rows.first[index];
                    if let Some((taut, crossing)) = self.turn_over(system, state, row) {
                        any = true;
                        self.set_friction(state, row, state.modes[row]);
                        self.log_group(system, state, log, contact.group, taut, start + length * crossing);
                    }
                    any |= self.switch_friction(system, state, log, index);
                }
            }
        }
        any
    }

    /// Lets a rope or normal row change side where it has crossed over: whether it acts now, and the share of the
    /// step at which it crossed.
    fn turn_over(&self, system: &System, state: &mut State, row: usize) -> Option<(bool, f64)> {
        if self.distance(system, state, row, &self.rodas.here) <= 0.0 {
            return None;
        }
        let taut = state.modes[row] == Mode::Slack;
        state.modes[row] = if taut { Mode::Acting } else { Mode::Slack };
        state.engaged |= taut;
        Some((taut, self.looks.crossing(row, self.rodas.here.trial[row] > 0.0)))
    }

    /// The rows of a rope; it is slack where any of them is.
    fn switch_rope(
        &self,
        system: &System,
        state: &mut State,
        log: &mut EventLog,
        index: usize,
        (start, length): (f64, f64),
    ) -> bool {
        let rows = system.rows.first[index]..system.rows.first[index + 1];
        let taut = |state: &State| state.modes[rows.clone()].iter().all(|mode| *mode != Mode::Slack);
        let before = taut(state);
        let mut last = None;
        for row in rows.clone() {
            if let Some((_, crossing)) = self.turn_over(system, state, row) {
                last = Some(last.unwrap_or(0.0_f64).max(crossing));
            }
        }
        let after = taut(state);
        if let (Some(crossing), true) = (last, before != after) {
            log.push(
                start + length * crossing,
                if after { EventKind::Taut } else { EventKind::Slack },
                index,
            );
        }
        last.is_some()
    }

    /// Holding and slipping of the brake `index` on a flow.
    fn switch_brake(&self, system: &System, state: &mut State, index: usize, dof: usize) -> bool {
        let row = system.rows.first[index];
        if self.distance(system, state, row, &self.rodas.here) <= 0.0 {
            return false;
        }
        if state.modes[row] == Mode::Slipping {
            state.modes[row] = Mode::Acting;
            // Inertia of a flow is its own: stopping it moves nothing else.
            state.ledger.flows.friction += 0.5 * system.tree.armature[dof] * state.v[dof] * state.v[dof];
            state.v[dof] = 0.0;
        } else {
            state.modes[row] = Mode::Slipping;
            state.slip[row] = self.rodas.here.trial[row].signum();
        }
        true
    }

    /// Lets brakes slip that cannot hold, and hold where a flow at rest is pulled back; true where any changed. The
    /// start of the step has been evaluated.
    pub(super) fn settle(&self, system: &System, state: &mut State) -> bool {
        let mut any = false;
        for &index in &system.fed {
            let AnyConstraint::Brake(brake) = &system.constraints[index] else { continue };
            let (row, here) = (system.rows.first[index], &self.rodas.here);
            let slips = match state.modes[row] {
                Mode::Slipping => {
                    let resting = state.v[brake.dof] * state.slip[row] <= 0.0;
                    !(resting && state.acceleration[brake.dof] * state.slip[row] < 0.0)
                }
                _ => here.trial[row].abs() > here.bound[row],
            };
            if slips != (state.modes[row] == Mode::Slipping) {
                state.modes[row] = if slips { Mode::Slipping } else { Mode::Acting };
                state.slip[row] = here.trial[row].signum();
                any = true;
            }
        }
        any
    }

    /// Sticking and sliding of the contact `index`.
    fn switch_friction(&self, system: &System, state: &mut State, log: &mut EventLog, index: usize) -> bool {
        let first = system.rows.first[index] + 1;
        let here = &self.rodas.here;
        if state.modes[first] == Mode::Slipping {
            let direction = here.slip_direction(first - 1, &state.slip);
            let turned = self.distance(system, state, first, here) > 0.0;
            if turned {
                // The anchor is where spring and damper carry the present force.
                for k in 0..2 {
                    let row = first + k;
                    let Law::Friction { coefficient, normal, compliance, damping_time } =
                        system.rows.laws[row]
                    else {
                        continue;
                    };
                    let force = coefficient * here.trial[normal].max(0.0) * state.slip[row];
                    let stretch = force * compliance - damping_time * here.rate[row];
                    state.memory[row] += here.frame.value[row] - stretch;
                }
                self.set_modes(state, first, Mode::Acting);
                log.push(state.time, EventKind::Stick, index);
            } else {
                state.slip[first..first + 2].copy_from_slice(&direction);
            }
            return turned;
        }
        if self.distance(system, state, first, here) > 0.0 {
            let size = here.trial[first].hypot(here.trial[first + 1]);
            for k in 0..2 {
                state.slip[first + k] = here.trial[first + k] / size;
            }
            self.set_modes(state, first, Mode::Slipping);
            log.push(state.time, EventKind::Slip, index);
            return true;
        }
        false
    }

    /// Friction follows its normal force: a contact that closes sticks where it touches.
    fn set_friction(&self, state: &mut State, normal: usize, mode: Mode) {
        for row in [normal + 1, normal + 2] {
            state.memory[row] += self.rodas.here.frame.value[row];
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
}
