//! The books of a step of `del`: energy that flowed and what contacts remember. Events of a step of fixed length, and
//! the motion within it.

use crate::audit::{Stored, elastic_energy, gravity_energy, spring_energy};
use crate::constraint::{AnyConstraint, Law};
use crate::contact::spot::Spot;
use crate::event::{EventKind, EventLog};
use crate::force::{self, Energies};
use crate::plan::Seen;
use crate::plan::condition::Support;
use crate::plan::course::Motion;
use crate::plan::drive::Timeline;
use crate::record::Sample;
use crate::solver::complementarity::{Complementarity, Mode};
use crate::solver::stiffness::Stiffness;
use crate::state::State;
use crate::stepper::frame::Frame;
use crate::system::System;
use crate::tree::kinematics::Kinematics;

/// A step that has been solved and not yet made: `state` and `frame` are still those of its start.
pub struct StepFlows<'a> {
    /// Step [s].
    pub h: f64,
    /// True where a pin has just been put in: what it holds comes to rest in this step.
    pub pinned: bool,
    /// v₊.
    pub v: &'a [f64],
    /// Velocity-dependent forces minus gravity.
    pub c: &'a [f64],
    /// What of c is resistance of water and air, and push of waves, and what is of dampers of mooring lines; empty where there is none.
    pub resistance: [&'a [f64]; 2],
    /// Power that wind, current and waves put in [W].
    pub fluid_power: f64,
    /// Power that added mass along axes that turn by themselves puts in [W].
    pub turning_power: f64,
    /// Forces and modes.
    pub rows: &'a Complementarity,
    /// Geometric stiffness of the step.
    pub stiffness: &'a Stiffness,
}

impl StepFlows<'_> {
    /// Adds the flows to the ledger and moves velocity, forces and modes into the state.
    ///
    /// Multiplying the step's equation by v₊ᵀ splits the change of energy into work and losses. The method
    /// loses ½ Δvᵀ M Δv, what geometric stiffness takes beyond the work of the tension along the curved path,
    /// in each spring the convexity of its energy over the step, and what [`StepFlows::book_bias`] says.
    pub fn book(&self, system: &System, state: &mut State, frame: &Frame, work: &mut [f64]) {
        let h = self.h;
        self.book_bias(state);
        for (rate, (new, old)) in state.acceleration.iter_mut().zip(self.v.iter().zip(&state.v)) {
            *rate = new - old;
        }
        let jump = 0.5 * frame.mass.quadratic(&state.acceleration);
        if self.pinned || self.goes_taut_at_once(system, state) {
            state.ledger.flows.impact += jump;
        } else {
            state.ledger.flows.method += jump;
        }
        state.ledger.flows.method += self.stiffness.loss(&frame.kinematics, self.v, &state.v, h);
        for (dof, damping) in system.tree.damping.iter().enumerate() {
            state.ledger.flows.joint_damping += h * damping * self.v[dof] * self.v[dof];
        }
        self.book_drives(system, state, frame, work);
        for row in 0..system.rows.count() {
            self.book_row(system, state, frame, row);
        }
        for rate in &mut state.acceleration {
            *rate /= h;
        }
        state.v.copy_from_slice(self.v);
    }

    /// c is held while q moves by h v, but gravity and kinetic energy change by the integral of v·c along that way,
    /// by the trapezoidal rule h v·(c + c₊)/2: the last step lost −½ h v·(c₊ − c). Known one step later.
    fn book_bias(&self, state: &mut State) {
        if state.steps > 0 {
            let changes = self.c.iter().zip(&state.bias).zip(&state.v);
            let gained: f64 = changes.map(|((new, old), v)| v * (new - old)).sum();
            let resisted: f64 = self.resistance.iter().map(|force| power(force, &state.v)).sum();
            let gained = gained - resisted;
            state.ledger.flows.method -= 0.5 * self.h * gained;
        }
        state.bias.copy_from_slice(self.c);
        // Resistance takes what it takes in the step.
        let [fluid, lines] = self.resistance;
        state.ledger.flows.drag += self.h * (power(fluid, self.v) + self.fluid_power);
        state.ledger.flows.fluid_work += self.h * (self.fluid_power + self.turning_power);
        state.ledger.flows.rope_damping += self.h * power(lines, self.v);
        for (bias, force) in state.bias.iter_mut().zip(fluid.iter().zip(lines)) {
            *bias -= force.0 + force.1;
        }
    }

    /// Work of the drives: the residual of their rows times their motion. `state.acceleration` holds Δv.
    fn book_drives(&self, system: &System, state: &mut State, frame: &Frame, work: &mut [f64]) {
        if system.drives.is_empty() {
            return;
        }
        let h = self.h;
        frame.mass.multiply(&state.acceleration, work);
        self.stiffness.add_force(self.v, &state.v, h * h, work);
        for drive in system.drives.iter().filter(|drive| !drive.is_limited) {
            let damping = system.tree.damping[drive.dof] * self.v[drive.dof];
            work[drive.dof] += h * (self.c[drive.dof] + damping);
        }
        for row in 0..system.rows.count() {
            for (dof, entry) in system.rows.entries(&frame.gradient, row) {
                work[dof] += h * entry * self.rows.tension[row];
            }
        }
        for (index, place) in system.coils.iter().enumerate() {
            work[place.dof] -= h * frame.coil_force(system, index);
        }
        for drive in system.drives.iter().filter(|drive| !drive.is_limited) {
            *state.ledger.flows.work_of(drive) += work[drive.dof] * self.v[drive.dof];
        }
    }

    fn book_row(&self, system: &System, state: &mut State, frame: &Frame, row: usize) {
        let law = &system.rows.laws[row];
        let rate = system.rows.rate(&frame.gradient, row, self.v);
        let flow = self.h * self.rows.tension[row] * rate;
        let compliance = law.compliance();
        if self.rows.modes[row].is_absent() {
            return;
        }
        if compliance == 0.0 {
            let slips = self.rows.modes[row] == Mode::Slipping;
            let asked = self.rows.asked(system, row);
            let driven = self.h * self.rows.tension[row] * asked;
            state.ledger.flows.drive_work -= driven;
            let lost = if slips { &mut state.ledger.flows.friction } else { &mut state.ledger.flows.method };
            *lost += flow - driven;
            return;
        }
        let before = frame.value[row];
        if is_friction(law) && self.rows.modes[row] != Mode::Acting {
            let after = deflection(law, self.rows.modes[row], self.rows.tension[row], before, self.h);
            let spring = spring_energy(law, after) - spring_energy(law, before);
            if self.rows.modes[row] == Mode::Slack {
                state.ledger.flows.contact_damping -= spring;
                return;
            }
            let stretched = after - before;
            let damper = law.damping_time() / compliance * stretched * stretched / self.h;
            let taken = self.rows.tension[row] * stretched;
            state.ledger.flows.friction += flow - taken;
            state.ledger.flows.contact_damping += damper;
            state.ledger.flows.method += taken - damper - spring;
            return;
        }
        let after = before + self.h * rate;
        if self.rows.modes[row] == Mode::Slack && system.light.iter().any(|light| light.rows.contains(&row)) {
            // A span may be stretched until rope has passed from the others, which takes that back.
            state.ledger.flows.rope_damping -= spring_energy(law, after);
            state.ledger.flows.method += spring_energy(law, before);
            return;
        }
        let spring = law.stretch(after) / compliance;
        let damper = flow - self.h * spring * rate;
        if row < system.rope_rows() {
            state.ledger.flows.rope_damping += damper;
        } else {
            state.ledger.flows.contact_damping += damper;
        }
        state.ledger.flows.method +=
            self.h * spring * rate - spring_energy(law, after) + spring_energy(law, before);
    }

    fn goes_taut_at_once(&self, system: &System, state: &State) -> bool {
        let changed = self.rows.modes.iter().zip(&state.modes);
        changed
            .zip(&system.rows.laws)
            .any(|((new, old), law)| *new != Mode::Slack && *old == Mode::Slack && law.compliance() == 0.0)
    }

    /// What the rows of the step become.
    pub fn change(&self, state: &State) -> Change<'_> {
        let Complementarity { modes, tension, trial, .. } = self.rows;
        Change { start: state.time, h: self.h, modes, tension, trial }
    }

    /// Moves forces, modes and the anchors of friction rows into the state. An anchor that slips follows so that
    /// spring and damper carry the force; one that sticks stays.
    pub fn remember(&self, system: &System, state: &mut State, frame: &Frame) {
        for (row, law) in system.rows.laws.iter().enumerate() {
            if is_friction(law) && self.rows.modes[row] != Mode::Acting {
                let travel = self.h * system.rows.rate(&frame.gradient, row, self.v);
                let (mode, force) = (self.rows.modes[row], self.rows.tension[row]);
                let deflection = deflection(law, mode, force, frame.value[row], self.h);
                state.memory[row] += frame.value[row] + travel - deflection;
            }
        }
        for brake in &self.rows.brakes {
            state.memory[brake.row] = brake.way;
        }
        state.tension.copy_from_slice(&self.rows.tension);
        state.trial.copy_from_slice(&self.rows.trial);
        state.modes.copy_from_slice(&self.rows.modes);
    }
}

/// Power of forces along every degree of freedom.
fn power(force: &[f64], v: &[f64]) -> f64 {
    force.iter().zip(v).map(|(force, v)| force * v).sum()
}

/// What the rows become in a step, for its events.
pub struct Change<'a> {
    /// Start of the step [s].
    pub start: f64,
    /// Its length [s].
    pub h: f64,
    /// Modes after it.
    pub modes: &'a [Mode],
    /// Forces after it [N].
    pub tension: &'a [f64],
    /// What the laws ask for after it [N].
    pub trial: &'a [f64],
}

impl Change<'_> {
    /// Logs what changed in the step. A time within it is found by letting the law's value run linearly.
    pub fn events(&self, system: &System, state: &State, log: &mut EventLog) {
        for (rope, first) in system.rows.first[..=system.rope_count].windows(2).enumerate() {
            let taut = |modes: &[Mode]| modes[first[0]..first[1]].iter().all(|mode| *mode != Mode::Slack);
            let (old, new) = (taut(&state.modes), taut(self.modes));
            if old != new {
                let changed = (first[0]..first[1]).filter(|&row| state.modes[row] != self.modes[row]);
                let time = changed.map(|row| self.crossing(state, row)).fold(self.start, f64::max);
                log.push(time, if new { EventKind::Taut } else { EventKind::Slack }, rope);
            }
        }
        for (index, group) in system.groups.iter().enumerate() {
            let normals = || group.contacts.iter().map(|&contact| system.rows.first[contact]);
            let old = normals().any(|row| state.tension[row] > 0.0);
            let new = normals().any(|row| self.tension[row] > 0.0);
            if old && !new {
                let left = normals().filter(|&row| state.tension[row] > 0.0);
                let time = left.map(|row| self.crossing(state, row)).fold(self.start, f64::max);
                log.push(time, EventKind::LiftOff, index);
            } else if new && !old && self.start > 0.0 {
                let met = normals().filter(|&row| self.tension[row] > 0.0);
                let time = met.map(|row| self.crossing(state, row)).fold(f64::INFINITY, f64::min);
                log.push(time, EventKind::SetDown, index);
            }
        }
        for (index, constraint) in system.constraints.iter().enumerate().skip(system.rope_count) {
            let first = system.rows.first[index];
            let modes = |row: usize| (state.modes[row], self.modes[row]);
            match constraint {
                AnyConstraint::Stop(_) => {
                    let kind = match modes(first) {
                        (Mode::Slack, Mode::Acting) => EventKind::StopHit,
                        (Mode::Acting, Mode::Slack) => EventKind::StopLeft,
                        _ => continue,
                    };
                    log.push(self.crossing(state, first), kind, index);
                }
                AnyConstraint::Contact(_) | AnyConstraint::Touch(_) => {
                    let kind = match modes(first + 1) {
                        (Mode::Acting, Mode::Slipping) => EventKind::Slip,
                        (Mode::Slipping, Mode::Acting) => EventKind::Stick,
                        _ => continue,
                    };
                    log.push(self.start, kind, index);
                }
                AnyConstraint::Rope(_) | AnyConstraint::Pin(_) | AnyConstraint::Brake(_) => {}
            }
        }
        for &(row, _) in &system.motors {
            let slips = |modes: &[Mode]| modes[row] == Mode::Slipping;
            let kind = match (slips(&state.modes), slips(self.modes)) {
                (false, true) => EventKind::DrumSlips,
                (true, false) => EventKind::DrumHolds,
                _ => continue,
            };
            log.push(self.start, kind, system.constraint_index(row));
        }
    }

    fn crossing(&self, state: &State, row: usize) -> f64 {
        let (before, after) = (state.trial[row], self.trial[row]);
        let share = if before == after { 0.0 } else { (before / (before - after)).clamp(0.0, 1.0) };
        self.start + share * self.h
    }
}

/// Deflection of the spring of a tangential row after a step in which its anchor has moved, from `before` on:
/// spring and damper carry the force, ε T = s₊ + τ (s₊ − s)/h. Nothing where there is no contact.
pub fn deflection(law: &Law, mode: Mode, force: f64, before: f64, h: f64) -> f64 {
    if mode == Mode::Slack {
        return 0.0;
    }
    before + h * (force * law.compliance() - before) / (h + law.damping_time())
}

/// Motion within a step of fixed length `h`, from `before` to `after`: straight in the coordinates; forces linear.
pub fn interpolate(
    system: &System,
    (before, after): (&State, &State),
    (share, h): (f64, f64),
    increment: &mut [f64],
    sample: &mut Sample,
) {
    // A step has one velocity; before the first one there is that of the start.
    sample.v.copy_from_slice(if share > 0.0 { &after.v } else { &before.v });
    sample.acceleration.copy_from_slice(&after.acceleration);
    if share >= 1.0 {
        sample.q.copy_from_slice(&after.q);
        sample.tension.copy_from_slice(&after.tension);
        sample.past.copy_from_slice(&after.past);
        return;
    }
    for (increment, velocity) in increment.iter_mut().zip(&after.v) {
        *increment = share * h * velocity;
    }
    sample.q.copy_from_slice(&before.q);
    system.tree.advance(&mut sample.q, increment);
    for place in &system.coils {
        sample.q[place.supply] += share * (after.q[place.supply] - before.q[place.supply]);
    }
    let forces = before.tension.iter().zip(&after.tension);
    for (tension, (before, after)) in sample.tension.iter_mut().zip(forces) {
        *tension = before + share * (after - before);
    }
    let states = before.past.iter().zip(&after.past);
    for (past, (before, after)) in sample.past.iter_mut().zip(states) {
        *past = before + share * (after - before);
    }
}

/// Turns the forces of rows of ropes that are fed from those of the configuration `from` into those of `to`, tensions staying
/// what they were in the step.
pub fn carry_tensions(system: &System, [from, to]: [&[f64]; 2], force: &mut [f64]) {
    for (constraint, &first) in system.constraints[..system.rope_count].iter().zip(&system.rows.first) {
        let AnyConstraint::Rope(rope) = constraint else { continue };
        let fed = rope.spans.iter().zip(&mut force[first..]).filter(|(span, _)| !span.feeds.is_empty());
        fed.for_each(|(span, force)| *force *= span.scale(from) / span.scale(to));
    }
}

/// True for a tangential row of a contact.
pub fn is_friction(law: &Law) -> bool {
    matches!(law, Law::Friction { .. })
}

/// What every contact group does under the forces of all rows [N], where bodies and spots are.
pub fn supports(
    system: &System,
    kinematics: &Kinematics,
    (spots, tension): (&[Spot], &[f64]),
    out: &mut [Support],
) {
    for (sum, group) in out.iter_mut().zip(&system.groups) {
        *sum = Support::default();
        for &contact in &group.contacts {
            let first = system.rows.first[contact];
            let force = [tension[first], tension[first + 1], tension[first + 2]];
            // What does not press has no friction either.
            if force[0] > 0.0 {
                sum.pressed += force[0];
                sum.borne += system.lift_of(contact, kinematics, spots, force);
            }
        }
    }
}

/// Tension that a row of a rope stands for [N] under the forces of all rows; mooring lines count on from the rows.
pub fn tension_at(
    system: &System,
    kinematics: &Kinematics,
    (row, force): (usize, &[f64]),
    [q, v]: [&[f64]; 2],
) -> f64 {
    match force.get(row) {
        Some(force) => system.rope_tension(row, *force, q, kinematics),
        None => {
            let line = system.moorings().nth(row - force.len());
            line.map_or(0.0, |mooring| mooring.tension_of(&system.tree, kinematics, v))
        }
    }
}

/// Lets the plan act on everything that is due before `to` [s], by the support forces [N] and what is in the state.
///
/// `frame` belongs to the state.
pub fn advance_plan(
    system: &System,
    state: &mut State,
    frame: &Frame,
    (to, support): (f64, &[Support]),
    log: &mut EventLog,
) {
    let kinematics = &frame.kinematics;
    let tension = |row: usize| tension_at(system, kinematics, (row, &state.tension), [&state.q, &state.v]);
    let seen = Seen { support, tension: &tension, kinematics };
    state.plan.advance(&system.plan, state.time, to, Some(&seen), log);
}

/// Puts driven joints exactly where their drives are, so rounding does not add up.
pub fn set_driven(system: &System, state: &mut State) {
    place_driven(system, state, Timeline::motion);
}

/// The same in still water, for an equilibrium.
pub fn set_driven_calm(system: &System, state: &mut State) {
    place_driven(system, state, Timeline::calm);
}

fn place_driven(system: &System, state: &mut State, motion: fn(&Timeline, f64) -> Motion) {
    for (drive, timeline) in system.prescribed(&state.plan.timelines) {
        let position = system.tree.bodies[drive.body].first_position;
        state.q[position] = motion(timeline, state.time).position;
    }
}

/// Energy that a state holds.
pub fn stored(system: &System, state: &State, frame: &Frame) -> Stored {
    let Energies { fluid, lines } = force::energy(&system.tree, &frame.kinematics);
    Stored {
        kinetic: 0.5 * frame.mass.quadratic(&state.v),
        gravity: gravity_energy(system, &frame.kinematics),
        elastic: elastic_energy(system, &frame.value, &state.modes) + lines,
        fluid,
    }
}

/// Notes the stored energies of the new state.
pub fn store(system: &System, state: &mut State, frame: &Frame) {
    state.ledger.store(stored(system, state, frame));
}
