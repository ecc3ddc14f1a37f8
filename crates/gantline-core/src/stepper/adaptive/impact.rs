//! What happens at once: accelerations after a change of modes, impacts of inextensible ropes that go taut, and their
//! return to their length after each step.

use super::Adaptive;
use super::rodas::Rodas;
use crate::audit::Flows;
use crate::clock::Stage;
use crate::constraint::brake::Brake;
use crate::event::{EventKind, EventLog};
use crate::solver::complementarity::Mode;
use crate::solver::symbolic::ZeroPivot;
use crate::state::State;
use crate::stepper::STANDSTILL;
use crate::stepper::frame::Frame;
use crate::system::System;

/// A pushing impulse that is rounding, relative to the largest.
const ROUNDING: f64 = 1e-9;

impl Adaptive {
    /// Accelerations and tensions of inextensible ropes that belong to the modes: M a + Gᵀ T = −imbalance,
    /// G a = −Ġ v.
    pub(super) fn restart(
        &mut self,
        system: &System,
        state: &mut State,
        frame: &Frame,
    ) -> Result<(), ZeroPivot> {
        for (dof, acceleration) in state.acceleration.iter_mut().enumerate() {
            if system.driven[dof].is_none() {
                *acceleration = 0.0;
            }
        }
        for &row in &system.rigid {
            state.tension[row] = 0.0;
        }
        self.rodas.evaluate(system, state);
        let Rodas { matrix, here, .. } = &mut self.rodas;
        let gradient = &here.frame.gradient;
        system.clock.time(Stage::Factorisation, || {
            matrix.factorise_inertia(system, &frame.mass, gradient, &state.modes)
        })?;
        for (force, imbalance) in self.rate.phi.iter_mut().zip(&here.imbalance) {
            *force = -imbalance;
        }
        self.rows.fill(0.0);
        for (pull, &row) in here.pull.iter().zip(&system.rigid) {
            if state.modes[row] == Mode::Acting {
                self.rows[row] = -pull;
            }
        }
        self.rate.a.fill(0.0);
        system.clock.time(Stage::Solution, || matrix.solve(&self.rate.phi, &self.rows, &mut self.rate.a));
        for (dof, acceleration) in state.acceleration.iter_mut().enumerate() {
            if system.driven[dof].is_none() {
                *acceleration = self.rate.a[dof];
            }
        }
        for &row in &system.rigid {
            if state.modes[row] == Mode::Acting {
                state.tension[row] = matrix.row_solution(row);
            }
        }
        state.restart = false;
        self.current = false;
        Ok(())
    }

    /// Puts inextensible ropes that act back to their length and their ends to equal speed, both with the least
    /// kinetic energy of the correction. Where one has just gone taut (`hit`), that is the impact (restitution 0),
    /// in which others at their length take part: 0 ≤ p ⟂ G v₊ ≤ 0. One after the other, two ropes that tighten
    /// each other would hand an impact to and fro for ever. Dry friction takes no part in it. Returns what drives put in
    /// at once.
    pub(super) fn project(
        &mut self,
        system: &System,
        state: &mut State,
        frame: &mut Frame,
        log: &mut EventLog,
        hit: bool,
    ) -> Result<Flows, ZeroPivot> {
        self.note_taut(system, state);
        let mut settled = false;
        while !settled {
            self.correct(system, state, frame, |row| -frame.value[row])?;
            settled = true;
            for &row in system.inextensible.iter().filter(|_| hit) {
                let moved = system.rows.rate(&frame.gradient, row, &self.rate.a);
                if state.modes[row] == Mode::Slack && frame.value[row] + moved > 0.0 {
                    state.modes[row] = Mode::Acting;
                    settled = false;
                }
            }
        }
        system.tree.advance(&mut state.q, &self.rate.a);
        frame.update(system, state);
        self.hit(system, state, frame, log, hit)
    }

    /// Stops at once what pins that have just been put in hold: as an impact, which changes the velocities of all
    /// that is coupled to it by masses and inextensible ropes.
    pub(super) fn stop_pinned(
        &mut self,
        system: &System,
        state: &mut State,
        frame: &Frame,
        log: &mut EventLog,
    ) -> Result<(), ZeroPivot> {
        self.note_taut(system, state);
        let before = frame.mass.quadratic(&state.v);
        let work = self.hit(system, state, frame, log, true)?;
        for row in pins(system).filter(|&row| state.modes[row] == Mode::Acting) {
            for (dof, _) in system.rows.entries(&frame.gradient, row) {
                state.v[dof] = 0.0;
            }
        }
        let flows = &mut state.ledger.flows;
        *flows += work;
        flows.impact += 0.5 * (before - frame.mass.quadratic(&state.v)) + work.put_in();
        Ok(())
    }

    /// Brings the ends of inextensible ropes that act to equal speed, and what pins hold to rest. Where that is an
    /// impact (`hit`), others at their length take part. Returns what drives put in at once.
    fn hit(
        &mut self,
        system: &System,
        state: &mut State,
        frame: &Frame,
        log: &mut EventLog,
        hit: bool,
    ) -> Result<Flows, ZeroPivot> {
        let held = if hit { release(system, state) } else { Vec::new() };
        self.equalise(system, state, frame, hit)?;
        if self.hold_again(system, state, &held) {
            self.equalise(system, state, frame, hit)?;
        }
        let work = self.work_at_once(system, state, frame);
        for (velocity, change) in state.v.iter_mut().zip(&self.rate.a) {
            *velocity += change;
        }
        self.turn_friction(system, state);
        for (&row, &was) in system.inextensible.iter().zip(&self.taut) {
            let taut = state.modes[row] == Mode::Acting;
            if taut != was {
                let rope = system.constraint_index(row);
                log.push(state.time, if taut { EventKind::Taut } else { EventKind::Slack }, rope);
            }
        }
        Ok(work)
    }

    /// The change of velocities, in `self.rate.a`, that brings the ends of inextensible ropes to equal speed.
    fn equalise(
        &mut self,
        system: &System,
        state: &mut State,
        frame: &Frame,
        hit: bool,
    ) -> Result<(), ZeroPivot> {
        // Exchanging one at a time ends (Murty 1974); the bound is against rounding.
        for _ in 0..100 + 4 * system.inextensible.len() {
            let rate = |row| -system.rows.rate(&frame.gradient, row, &state.v);
            self.correct(system, state, frame, rate)?;
            let Some(row) = self.wrong(system, state, frame).filter(|_| hit) else { break };
            let taut = state.modes[row] == Mode::Slack;
            state.modes[row] = if taut { Mode::Acting } else { Mode::Slack };
        }
        Ok(())
    }

    /// Lets brakes that the impact leaves where they are hold again, of those `held` before; true where any does.
    fn hold_again(&self, system: &System, state: &mut State, held: &[usize]) -> bool {
        let mut any = false;
        for (row, brake) in brakes(system).filter(|(row, _)| held.contains(row)) {
            if brake.along(&self.rate.a).abs() <= STANDSTILL {
                state.modes[row] = Mode::Acting;
                any = true;
            }
        }
        any
    }

    /// Friction is against the velocity after the impact.
    fn turn_friction(&self, system: &System, state: &mut State) {
        for (row, brake) in brakes(system) {
            let speed = brake.along(&state.v);
            let jumps = brake.along(&self.rate.a).abs() > STANDSTILL && speed.abs() > STANDSTILL;
            if jumps && state.modes[row] == Mode::Slipping {
                state.memory[row] = speed.signum();
            }
        }
    }

    /// Notes which inextensible ropes act.
    pub(super) fn note_taut(&mut self, system: &System, state: &State) {
        self.taut.clear();
        self.taut.extend(system.inextensible.iter().map(|&row| state.modes[row] == Mode::Acting));
    }

    /// The change of coordinates or velocities, in `self.rate.a`, of least kinetic energy that gives each inextensible
    /// rope that acts, and each pin that is in, the change `wanted` of length or speed; brakes that hold keep their
    /// velocity.
    fn correct(
        &mut self,
        system: &System,
        state: &State,
        frame: &Frame,
        wanted: impl Fn(usize) -> f64,
    ) -> Result<(), ZeroPivot> {
        let matrix = &mut self.rodas.matrix;
        system.clock.time(Stage::Factorisation, || {
            matrix.factorise_inertia(system, &frame.mass, &frame.gradient, &state.modes)
        })?;
        self.rows.fill(0.0);
        for row in told(system).filter(|&row| state.modes[row] == Mode::Acting) {
            self.rows[row] = wanted(row);
        }
        self.rate.phi.fill(0.0);
        self.rate.a.fill(0.0);
        system.clock.time(Stage::Solution, || matrix.solve(&self.rate.phi, &self.rows, &mut self.rate.a));
        // What they hold they hold exactly: rounding of each step would add up.
        for (row, brake) in brakes(system).filter(|(_, brake)| brake.spin.is_none()) {
            if state.modes[row] == Mode::Acting {
                self.rate.a[brake.dof] = 0.0;
            }
        }
        Ok(())
    }

    /// What drives put in at once: each keeps its velocity against the impulses p that change those of the others,
    /// which takes M Δv + Gᵀ p. `correct` has just found Δv and p.
    fn work_at_once(&mut self, system: &System, state: &State, frame: &Frame) -> Flows {
        let impulse = &mut self.rate.phi;
        frame.mass.multiply(&self.rate.a, impulse);
        for row in told(system).filter(|&row| state.modes[row] == Mode::Acting) {
            for (dof, entry) in system.rows.entries(&frame.gradient, row) {
                impulse[dof] += entry * self.rodas.matrix.row_solution(row);
            }
        }
        let mut flows = Flows::default();
        for (drive, _) in system.prescribed(&state.plan.timelines) {
            *flows.work_of(drive) += impulse[drive.dof] * state.v[drive.dof];
        }
        flows
    }

    /// An inextensible rope on the wrong side of an impact: it pushes, or its ends move apart at its full length.
    fn wrong(&self, system: &System, state: &State, frame: &Frame) -> Option<usize> {
        let acts = |row: usize| state.modes[row] == Mode::Acting;
        let impulse = |row: usize| self.rodas.matrix.row_solution(row);
        let acting = system.inextensible.iter().filter(|&&row| acts(row));
        let largest = acting.fold(0.0, |most: f64, &row| most.max(impulse(row).abs()));
        system.inextensible.iter().copied().rfind(|&row| {
            if acts(row) {
                return impulse(row) < -ROUNDING * largest;
            }
            let after = system.rows.rate(&frame.gradient, row, &state.v)
                + system.rows.rate(&frame.gradient, row, &self.rate.a);
            // One that has parted, or is off, has ends that no length holds together.
            let is_there = !state.modes[row].is_absent();
            is_there && frame.value[row] > -self.tolerance.position && after > STANDSTILL
        })
    }
}

/// Rows of pins.
fn pins(system: &System) -> impl Iterator<Item = usize> {
    system.pins.iter().map(|pinning| system.rows.first[pinning.constraint])
}

/// Rows whose speed an impact gives: of inextensible ropes and pins.
fn told(system: &System) -> impl Iterator<Item = usize> {
    system.inextensible.iter().copied().chain(pins(system))
}

/// Brakes and their rows, but for those of light sheaves.
fn brakes(system: &System) -> impl Iterator<Item = (usize, &Brake)> {
    system.exerting_brakes()
}

/// Lets all brakes go, whose rows are returned: a force that is bounded has no share in an impact.
fn release(system: &System, state: &mut State) -> Vec<usize> {
    let held: Vec<usize> =
        brakes(system).map(|(row, _)| row).filter(|&row| state.modes[row] == Mode::Acting).collect();
    for &row in &held {
        state.modes[row] = Mode::Slipping;
    }
    held
}
