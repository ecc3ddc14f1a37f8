//! Changes of the rows' modes: seen along the course of a step, made at its end.

use super::books::WEIGHTS;
use super::light::Laying;
use super::point::Point;
use super::{Adaptive, LOOKS, STEP_FLOOR};
use crate::constraint::AnyConstraint;
use crate::constraint::brake::Brake;
use crate::constraint::contact::Contact;
use crate::constraint::touch::Touch;
use crate::event::{EventKind, EventLog};
use crate::plan::Seen;
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::stepper::STANDSTILL;
use crate::stepper::flows::{supports, tension_at};
use crate::system::System;

impl Adaptive {
    /// Looks at the course of the step that has been computed and decides how much of it is made: up to where a row
    /// reaches the switching tolerance, or where the plan's condition is fulfilled.
    pub(super) fn look(&mut self, system: &System, state: &State) {
        self.looks.note(system, 0, &self.rodas.here);
        self.made = 1.0;
        let crossed = self.survey(system, state, 1.0);
        let made = crossed.map_or(1.0, |look| self.cut(system, state, look));
        let made = self.condition(system, state, made);
        let made = self.seated_up_to(system, state, made);
        let made = self.winds_up_to(system, state, made);
        let made = self.wets_up_to(system, state, made);
        if made < 1.0 {
            self.made = made;
            self.survey(system, state, f64::INFINITY);
        }
        self.look_at_seats(system, state);
        self.looks.fit();
        if let Some(share) = self.first_break(system, state) {
            self.made = share;
            self.survey(system, state, f64::INFINITY);
            self.looks.fit();
        }
    }

    /// Looks along the part of the step that is made: what flows, and how far rows are from their laws; ends at the
    /// first look that is further than `allowed`, in what the tolerance allows, and tells which.
    fn survey(&mut self, system: &System, state: &State, allowed: f64) -> Option<usize> {
        // Steps with light sheaves are cut more often than not: what flows is then looked for where none is.
        let is_doubtful = allowed.is_finite() && !system.light.is_empty();
        self.follow_curves(system, state);
        self.begin_looks(system, state);
        self.laid_before.start(system, state);
        self.looks.broken = 0.0;
        let length = self.made * self.rodas.course.h;
        for (index, (theta, weight)) in LOOKS.into_iter().zip(WEIGHTS).enumerate() {
            if is_doubtful {
                self.look_at_rows(system, state, theta * self.made);
            } else {
                self.book_look(system, state, theta * self.made, weight * length);
            }
            self.laid.follow(system, &self.probe, state.time + theta * length);
            self.looks.note(system, index + 1, &self.probe);
            self.note_far(system, state, index);
            if self.looks.far[index] > allowed {
                return Some(index);
            }
            if is_doubtful {
                std::mem::swap(&mut self.probe, &mut self.seen[index]);
            }
        }
        self.arrive(system, state);
        self.note_arrival(system, state);
        let last = LOOKS.len() - 1;
        self.note_far(system, state, last);
        if self.looks.far[last] > allowed {
            return Some(last);
        }
        if is_doubtful {
            for (index, (theta, weight)) in LOOKS.into_iter().zip(WEIGHTS).enumerate() {
                std::mem::swap(&mut self.probe, &mut self.seen[index]);
                self.book_seen(system, state, theta * self.made, weight * length);
            }
        }
        None
    }

    /// Keeps how far the look `index` is from what it should be.
    fn note_far(&mut self, system: &System, state: &State, index: usize) {
        let at = if index + 1 == LOOKS.len() { &self.next } else { &self.probe };
        let far = self.farthest(system, state, at);
        self.looks.far[index] = far.share;
        self.looks.broken = self.looks.broken.max(far.force);
    }

    /// Keeps the forces at the end of the part that is made, before light sheaves turn over: forces jump there, and no
    /// polynomial goes through a jump. Those after it are the first of the next step.
    fn note_arrival(&mut self, system: &System, state: &State) {
        if system.coils.is_empty() || system.light.is_empty() {
            self.looks.note(system, LOOKS.len(), &self.next);
            self.looks.note_arriving(system, &self.next, &state.modes);
        } else {
            // What drums feed is known where all rows are.
            self.probe_frozen(system, state, self.made);
            self.looks.note(system, LOOKS.len(), &self.probe);
        }
    }

    /// Evaluates the end of the part that is made. Driven joints are put exactly where their drives are, so that
    /// rounding does not add up.
    fn arrive(&mut self, system: &System, state: &State) {
        self.rodas.course.at(self.made, &mut self.end);
        let time = state.time + self.made * self.rodas.course.h;
        for (drive, timeline) in system.prescribed(&state.plan.timelines) {
            let motion = timeline.motion(time);
            let position = state.q[system.tree.bodies[drive.body].first_position];
            self.end.phi[drive.dof] = motion.position - position;
            self.end.v[drive.dof] = motion.velocity;
        }
        self.hold_pins(system, state);
        let elapsed = self.made * self.rodas.course.h;
        let laying = Laying::Laid(&self.rodas.here.light, &self.laid);
        let point = Point { laying, ..Point::of(state, &self.end, elapsed) };
        self.next.all(system, &point, &state.modes);
        self.lay(system, state);
    }

    /// Keeps what pins hold exactly where it is, so that rounding does not add up there either.
    fn hold_pins(&mut self, system: &System, state: &State) {
        for pinning in &system.pins {
            let row = system.rows.first[pinning.constraint];
            if state.modes[row] == Mode::Acting {
                for (dof, _) in system.rows.entries(&self.next.frame.gradient, row) {
                    (self.end.phi[dof], self.end.v[dof]) = (0.0, 0.0);
                }
            }
        }
    }

    /// Share of the step at which a row reaches the switching tolerance before the look `index`.
    fn cut(&mut self, system: &System, state: &State, index: usize) -> f64 {
        let (mut low, mut high) = (if index == 0 { 0.0 } else { LOOKS[index - 1] }, LOOKS[index]);
        // Anything between half of the tolerance and the tolerance will do. False position with the Illinois
        // rule: an end that stays counts half.
        let aim = |far: f64| far - 0.75;
        let mut below = aim(if index == 0 { 0.0 } else { self.looks.far[index - 1] });
        let mut above = aim(self.looks.far[index]);
        for _ in 0..60 {
            let share = (below / (below - above)).clamp(0.01, 0.99);
            let middle = low + share * (high - low);
            self.probe_rows(system, state, middle);
            let far = self.farthest(system, state, &self.probe).share;
            if far > 1.0 {
                (high, above) = (middle, aim(far));
                below *= 0.5;
            } else {
                (low, below) = (middle, aim(far));
                above *= 0.5;
                if far > 0.5 {
                    break;
                }
            }
        }
        if low > 0.0 { low } else { high }
    }

    /// The share at which the condition of the plan is first fulfilled, or `made`. Waves and gusts may fulfil it
    /// for a moment within the step.
    fn condition(&mut self, system: &System, state: &State, made: f64) -> f64 {
        if !state.plan.waits_for_condition() {
            return made;
        }
        let length = made * self.rodas.course.h;
        let looks = system.sea.looks(length).max(system.gusts.looks(length)).max(1);
        let share = |look: usize| made * (look as f64 / looks as f64);
        let Some(first) = (1..=looks).find(|&look| self.fulfilled(system, state, share(look))) else {
            return made;
        };
        let (mut low, mut high) = (share(first - 1), share(first));
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if self.fulfilled(system, state, middle) { high = middle } else { low = middle }
        }
        // A part so short moves nothing, and what rounding has left unfulfilled at its end would stay so.
        high.max(STEP_FLOOR / self.rodas.course.h).min(made)
    }

    fn fulfilled(&mut self, system: &System, state: &State, theta: f64) -> bool {
        self.probe_rows(system, state, theta);
        let probe = &self.probe;
        let (kinematics, motion) = (&probe.frame.kinematics, [probe.q.as_slice(), &self.point.v]);
        supports(system, kinematics, (&state.spots, &probe.tension), &mut self.support);
        let tension = |row: usize| tension_at(system, kinematics, (row, &probe.tension), motion);
        state.plan.is_fulfilled(&system.plan, &Seen { support: &self.support, tension: &tension, kinematics })
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
        for (index, constraint) in system.exerting().iter().enumerate() {
            match constraint {
                AnyConstraint::Rope(_) => any |= self.switch_rope(system, state, log, index, (start, length)),
                AnyConstraint::Brake(brake) => any |= self.switch_brake(system, state, index, brake),
                AnyConstraint::Pin(_) => {}
                AnyConstraint::Stop(_) => {
                    let row = system.rows.first[index];
                    if let Some(hit) = self.turn_over(system, state, row) {
                        any = true;
                        let crossing = self.crossing(row);
                        let kind = if hit { EventKind::StopHit } else { EventKind::StopLeft };
                        log.push(start + length * crossing, kind, index);
                    }
                }
                AnyConstraint::Contact(Contact { group, .. }) | AnyConstraint::Touch(Touch { group, .. }) => {
                    let row = system.rows.first[index];
                    if let Some(taut) = self.turn_over(system, state, row) {
                        any = true;
                        let crossing = self.crossing(row);
                        self.set_friction(system, state, row, state.modes[row]);
                        self.log_group(system, state, log, *group, taut, start + length * crossing);
                    }
                    any |= self.switch_friction(system, state, log, index);
                }
            }
        }
        any
    }

    /// Lets a rope or normal row change side where it has crossed over: whether it acts now.
    fn turn_over(&self, system: &System, state: &mut State, row: usize) -> Option<bool> {
        if self.distance(system, state, row, &self.rodas.here) <= 0.0 || self.loosens(system, state, row) {
            return None;
        }
        let taut = state.modes[row] == Mode::Slack;
        state.modes[row] = if taut { Mode::Acting } else { Mode::Slack };
        state.engaged |= taut;
        Some(taut)
    }

    /// The share of the step at which a row crossed that has.
    fn crossing(&self, row: usize) -> f64 {
        self.looks.crossing(row, self.rodas.here.trial[row] > 0.0)
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
            if self.turn_over(system, state, row).is_none() {
                continue;
            }
            // A row that is over by then did not cross later.
            let is_over = |share: f64| self.looks.is_over(row, self.rodas.here.trial[row] > 0.0, share);
            last = match last {
                Some(share) if is_over(share) => Some(share),
                _ => Some(last.unwrap_or(0.0_f64).max(self.crossing(row))),
            };
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

    /// Holding and slipping of the brake `index`.
    fn switch_brake(&self, system: &System, state: &mut State, index: usize, brake: &Brake) -> bool {
        let row = system.rows.first[index];
        if self.distance(system, state, row, &self.rodas.here) <= 0.0 {
            return false;
        }
        if state.modes[row] == Mode::Slipping {
            state.modes[row] = Mode::Acting;
            // So slow that it makes no difference to what moves along; the books see to its energy.
            let spin = brake.spin.map_or(0.0, |spin| state.v[spin]);
            state.v[brake.dof] = self.rodas.here.asked[row] + spin;
        } else {
            state.modes[row] = Mode::Slipping;
            state.memory[row] = self.rodas.here.trial[row].signum();
        }
        true
    }

    /// Lets brakes slip that cannot hold, and hold where a flow at rest is pulled back; true where any changed. The
    /// start of the step has been evaluated.
    pub(super) fn settle(&self, system: &System, state: &mut State) -> bool {
        let mut any = false;
        for &index in system.fed.iter().take_while(|&&index| index < system.first_light) {
            let AnyConstraint::Brake(brake) = &system.constraints[index] else { continue };
            let (row, here) = (system.rows.first[index], &self.rodas.here);
            let slips = match state.modes[row] {
                Mode::Slipping => {
                    let resting = here.rate[row] * state.memory[row] <= 0.0;
                    !(resting && self.lag(system, state, row, brake) * state.memory[row] < 0.0)
                }
                _ => here.trial[row].abs() > here.bound[row],
            };
            if slips != (state.modes[row] == Mode::Slipping) {
                state.modes[row] = if slips { Mode::Slipping } else { Mode::Acting };
                state.memory[row] = here.trial[row].signum();
                any = true;
            }
        }
        any
    }

    /// Keeps which motors do not follow their drives.
    pub(super) fn note_slipping(&mut self, system: &System, state: &State) {
        self.slipping.clear();
        self.slipping.extend(system.motors.iter().map(|&(row, _)| state.modes[row] == Mode::Slipping));
    }

    /// Logs those that have begun to slip, or to follow again, since they were kept.
    pub(super) fn log_slipping(&mut self, system: &System, state: &State, log: &mut EventLog) {
        for (&(row, _), slipped) in system.motors.iter().zip(&mut self.slipping) {
            let slips = state.modes[row] == Mode::Slipping;
            if slips != std::mem::replace(slipped, slips) {
                let kind = if slips { EventKind::DrumSlips } else { EventKind::DrumHolds };
                log.push(state.time, kind, system.constraint_index(row));
            }
        }
    }

    /// True for a slack inextensible rope that is at its length and not about to be pulled: one that rounding, or
    /// another rope that is let go in the same moment, has put there.
    fn loosens(&self, system: &System, state: &State, row: usize) -> bool {
        let rigid = system.rows.laws[row].compliance() == 0.0;
        rigid && state.modes[row] == Mode::Slack && self.rodas.here.rate[row] < STANDSTILL
    }

    /// Acceleration of a flow against what the drive of its motor asks for [m/s²].
    fn lag(&self, system: &System, state: &State, row: usize, brake: &Brake) -> f64 {
        let motor = system.motors.iter().find(|(other, _)| *other == row);
        let asked = |drive: usize| state.plan.timelines[drive].acceleration(state.time, state.time).0;
        brake.along(&state.acceleration) - motor.map_or(0.0, |&(_, drive)| asked(drive))
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
        let touching = touching.filter(|&&contact| state.modes[system.rows.first[contact]].carries());
        match (touching.count(), closed) {
            (0, false) => log.push(time, EventKind::LiftOff, group),
            (1, true) => log.push(time, EventKind::SetDown, group),
            _ => {}
        }
    }
}
