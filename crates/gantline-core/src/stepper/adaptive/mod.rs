//! `adaptive`: error-controlled Rosenbrock steps of order 5 ([`rodas`]) between changes of the rows' modes.
//!
//! In a step the modes are frozen: a taut rope stays a spring even if its tension runs through zero. The course
//! of the step is then looked at: as long as no row is further from its law than the switching tolerance, the
//! step stands, and all rows that have crossed over change side together at its end, each with its own recorded
//! time. Where one goes further the step is cut where it reaches the tolerance. So a hundred slings that go taut
//! within a millisecond cost one restart and not a hundred.

mod books;
mod breaking;
mod error;
pub mod evaluation;
mod looks;
mod places;
pub mod rodas;
mod spins;
mod switching;
mod tableau;
pub mod tangent;

use super::frame::Frame;
use super::{StepError, StepReport};
use super::{flows, parting};
use crate::audit::Flows;
use crate::clock::Stage;
use crate::constraint::Law;
use crate::event::EventLog;
use crate::record::Sample;
use crate::solver::complementarity::Mode;
use crate::solver::symbolic::ZeroPivot;
use crate::state::State;
use crate::system::System;
use crate::tree::kinematics::Twist;
use evaluation::{Evaluation, Point};
use looks::Looks;
use rodas::{Increment, Rodas};

/// What an error may be in one step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Of rope tensions and contact forces [N].
    pub tension: f64,
    /// Of positions [m].
    pub position: f64,
}

impl Tolerance {
    /// A share of the weight that a rope carries on the average, and a tenth of a millimetre.
    pub fn default_of(system: &System) -> Self {
        let mass: f64 = system.tree.bodies.iter().map(|body| body.mass).sum();
        let weight = mass * system.tree.gravity.length();
        let share = weight / system.rope_count.max(1) as f64;
        let tension = if share > 0.0 { 1e-4 * share } else { 1.0 };
        Self { tension, position: 1e-4 }
    }
}

/// Shares of a step at which its course is looked at: Gauss points of order 8, and the end.
const LOOKS: [f64; 5] = [
    0.069_431_844_202_973_71,
    0.330_009_478_207_571_9,
    0.669_990_521_792_428_1,
    0.930_568_155_797_026_3,
    1.0,
];
/// First step of a run [s].
const FIRST_STEP: f64 = 1e-3;
/// A step may not be shorter than this [s].
const STEP_FLOOR: f64 = 1e-10;
/// How far from its law a row may get before it changes side, in tolerances of tension.
const SWITCHING: f64 = 5.0;
/// Rounds in which brakes settle between holding and slipping after a change.
const SETTLING: usize = 20;

/// The integrator with its work arrays.
#[derive(Debug, Clone)]
pub struct Adaptive {
    tolerance: Tolerance,
    rodas: Rodas,
    /// Length of the rotations' arms [m], inertia of every degree of freedom.
    weights: error::Weights,
    probe: Evaluation,
    /// The end of the part of the step that is made.
    next: Evaluation,
    /// What flows in it.
    flows: Flows,
    /// Motion there.
    end: Increment,
    point: Increment,
    rate: Increment,
    looks: Looks,
    support: Vec<f64>,
    rows: Vec<f64>,
    defect: Vec<Twist>,
    /// True while `rodas.here` belongs to the state.
    current: bool,
    /// Share of the last computed step that was made.
    made: f64,
}

impl Adaptive {
    /// An integrator for `system`.
    pub fn new(system: &System, frame: &Frame, tolerance: Tolerance) -> Self {
        let mut rodas = Rodas::new(system);
        let mut probe = Evaluation::new(system);
        // A slack inextensible rope may get as much too long as positions may be wrong.
        probe.rigid_scale = tolerance.tension / tolerance.position;
        rodas.here.rigid_scale = probe.rigid_scale;
        Self {
            tolerance,
            weights: error::Weights::new(system, frame),
            rodas,
            next: probe.clone(),
            probe,
            flows: Flows::default(),
            end: Increment::zero(system),
            point: Increment::zero(system),
            rate: Increment::zero(system),
            looks: Looks::new(system),
            support: vec![0.0; system.groups.len()],
            rows: vec![0.0; system.rows.count()],
            defect: vec![Twist::default(); system.tree.bodies.len()],
            current: false,
            made: 1.0,
        }
    }

    /// Entries of the factors.
    pub fn fill(&self) -> usize {
        self.rodas.matrix.layout.symbolic.l_rows.len()
    }

    /// Forgets what belongs to the state of the last step.
    pub fn forget(&mut self) {
        self.current = false;
    }

    /// Motion and forces at the share `theta` of the last step, which was made from `before`.
    pub fn interpolate(&mut self, system: &System, before: &State, theta: f64, sample: &mut Sample) {
        self.rodas.course.at(theta * self.made, &mut self.point);
        sample.q.copy_from_slice(&before.q);
        system.tree.advance(&mut sample.q, &self.point.phi);
        sample.v.copy_from_slice(&self.point.v);
        sample.acceleration.copy_from_slice(&self.point.a);
        self.looks.sample(system, theta, &mut sample.tension);
    }

    /// The largest force of a rope in the last step [N] and the share of the step at which it was, where it is
    /// more than `least`.
    pub fn peak(&self, row: usize, least: f64) -> Option<(f64, f64)> {
        self.looks.peak(row, least)
    }

    /// One step from `state`, not beyond `until` [s].
    ///
    /// # Errors
    /// [`StepError`] where the matrix is singular, or the step would have to be too short.
    pub fn step(
        &mut self,
        system: &System,
        state: &mut State,
        frame: &mut Frame,
        log: &mut EventLog,
        until: f64,
    ) -> Result<StepReport, StepError> {
        let mut report = StepReport { converged: true, ..StepReport::default() };
        flows::supports(system, &state.tension, &mut self.support);
        let soon = state.time + 1e-12 * (1.0 + state.time);
        state.plan.advance(&system.plan, state.time, soon, &self.support, log);
        state.restart |= parting::cut(system, state, frame, soon, log);
        self.begin(system, state, frame, log).map_err(|pivot| self.singular(system, state.time, pivot))?;
        let stop = state.plan.next_time(&system.plan, soon).min(parting::next_cut(system, soon)).min(until);
        let mut h = if state.next_step > 0.0 { state.next_step } else { FIRST_STEP };
        if state.engaged {
            h = h.min(2.0 * state.engaged_step);
        }
        let (mut rejected, mut last) = (0, f64::INFINITY);
        let (error, reach) = loop {
            let reach = stop - state.time;
            // Never leave a sliver before a stop.
            h = if h >= reach { reach } else { h.min(0.5 * reach) };
            let solved = self.rodas.attempt(system, state, &frame.mass, h);
            solved.map_err(|pivot| self.singular(system, state.time, pivot))?;
            report.factorisations += 1;
            let error = self.weights.norm(system, state, &self.rodas, &self.tolerance);
            if error <= 1.0 {
                break (error, reach);
            }
            rejected += 1;
            // Where the estimate does not fall with the step, the step is far too long.
            let wanted = 0.9 * error.powf(-1.0 / tableau::ERROR_ORDER);
            h *= if error < 0.5 * last { wanted.clamp(0.1, 0.8) } else { 0.1 };
            last = error;
            if h < STEP_FLOOR {
                return Err(self.too_short(system, state));
            }
        };
        let stretch = (0.9 * error.max(1e-8).powf(-1.0 / tableau::ERROR_ORDER)).clamp(0.2, 6.0);
        report.rejected = rejected;
        if state.engaged {
            state.engaged_step = h;
            state.engaged = false;
        }
        system.clock.time(Stage::Events, || self.look(system, state));
        report.cut = self.made < 1.0;
        let whole = self.made == 1.0 && h == reach;
        state.next_step = h * stretch;
        self.advance(system, state, frame, log, if whole { Some(stop) } else { None })
            .map_err(|pivot| self.singular(system, state.time, pivot))?;
        Ok(report)
    }

    /// Makes sure that the start of the step is evaluated and its accelerations are right.
    fn begin(
        &mut self,
        system: &System,
        state: &mut State,
        frame: &Frame,
        log: &mut EventLog,
    ) -> Result<(), ZeroPivot> {
        let driven = system.drives.iter().zip(&state.plan.timelines);
        for (drive, timeline) in driven {
            let (a, _) = timeline.acceleration(state.time, state.time);
            state.restart |= state.acceleration[drive.dof] != a;
            state.acceleration[drive.dof] = a;
            state.v[drive.dof] = timeline.motion(state.time).velocity;
        }
        loop {
            self.settle_forces(system, state, frame)?;
            // What the forces are now may break a rope, and that change the forces.
            if !parting::break_ropes(system, state, frame, log) {
                break;
            }
            state.restart = true;
        }
        self.rodas.linearise(system, state, &frame.mass);
        Ok(())
    }

    /// Evaluates the start of the step; where forces have jumped, with the accelerations that belong to them.
    fn settle_forces(&mut self, system: &System, state: &mut State, frame: &Frame) -> Result<(), ZeroPivot> {
        if state.restart {
            self.restart(system, state, frame)?;
            for _ in 0..SETTLING {
                self.rodas.evaluate(system, state);
                self.current = true;
                if !self.settle(system, state) {
                    break;
                }
                self.restart(system, state, frame)?;
            }
        }
        if !self.current {
            self.rodas.evaluate(system, state);
            self.current = true;
        }
        Ok(())
    }

    /// Accelerations and tensions of inextensible ropes that belong to the modes: M a + Gᵀ T = −imbalance,
    /// G a = −Ġ v.
    fn restart(&mut self, system: &System, state: &mut State, frame: &Frame) -> Result<(), ZeroPivot> {
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
    /// kinetic energy of the correction. Where one has just gone taut, that is the impact (restitution 0).
    fn project(&mut self, system: &System, state: &mut State, frame: &mut Frame) -> Result<(), ZeroPivot> {
        for positions in [true, false] {
            let modes = &state.modes;
            let matrix = &mut self.rodas.matrix;
            system.clock.time(Stage::Factorisation, || {
                matrix.factorise_inertia(system, &frame.mass, &frame.gradient, modes)
            })?;
            self.rows.fill(0.0);
            for &row in system.rigid.iter().filter(|&&row| modes[row] == Mode::Acting) {
                let rate = system.rows.rate(&frame.gradient, row, &state.v);
                self.rows[row] = if positions { -frame.value[row] } else { -rate };
            }
            self.rate.phi.fill(0.0);
            self.rate.a.fill(0.0);
            system.clock.time(Stage::Solution, || matrix.solve(&self.rate.phi, &self.rows, &mut self.rate.a));
            if positions {
                system.tree.advance(&mut state.q, &self.rate.a);
                frame.update(system, state);
            } else {
                for (velocity, change) in state.v.iter_mut().zip(&self.rate.a) {
                    *velocity += change;
                }
            }
        }
        Ok(())
    }

    /// Evaluates the course at one share of the step, rows only.
    fn probe_rows(&mut self, system: &System, state: &State, theta: f64) {
        self.rodas.course.at(theta, &mut self.point);
        let Increment { phi, v, a, rigid } = &self.point;
        let point = Point { base: &state.q, memory: &state.memory, phi, v, a, rigid };
        self.probe.rows(system, &point, &state.modes, &state.slip);
    }

    /// Makes the step up to the share `made`: state, books, changes of modes.
    fn advance(
        &mut self,
        system: &System,
        state: &mut State,
        frame: &mut Frame,
        log: &mut EventLog,
        stop: Option<f64>,
    ) -> Result<(), ZeroPivot> {
        self.book_springs(system, state, -1.0);
        let (start, length) = (state.time, self.made * self.rodas.course.h);
        state.v.copy_from_slice(&self.end.v);
        state.acceleration.copy_from_slice(&self.end.a);
        state.time = stop.unwrap_or(start + length);
        state.steps += 1;
        for (tension, &row) in self.end.rigid.iter().zip(&system.rigid) {
            state.tension[row] = *tension;
        }
        // The last look was at the end of the step: it is the start of the next.
        std::mem::swap(&mut self.next, &mut self.rodas.here);
        let here = &mut self.rodas.here;
        state.q.copy_from_slice(&here.q);
        // There φ counts from here: φ̇ = v.
        here.phi_rate.copy_from_slice(&state.v);
        self.current = true;
        self.book_springs(system, state, 1.0);
        state.ledger.flows += std::mem::take(&mut self.flows);
        let held = self.held(system, state);
        let taut = self.rigid_acting(system, state);
        if system.clock.time(Stage::Events, || self.switch(system, state, log, start, length)) {
            state.restart = true;
            self.rodas.evaluate(system, state);
            state.ledger.flows.method += held - self.held(system, state);
        }
        self.hand_over(system, state);
        self.refresh(system, frame);
        let rigid = self.rigid_acting(system, state);
        if rigid > 0 {
            let before: f64 = flows::stored(system, state, frame).iter().sum();
            self.project(system, state, frame)?;
            self.rodas.evaluate(system, state);
            self.refresh(system, frame);
            self.hand_over(system, state);
            let lost = before - flows::stored(system, state, frame).iter().sum::<f64>();
            let flows = &mut state.ledger.flows;
            *(if rigid > taut { &mut flows.impact } else { &mut flows.method }) += lost;
        }
        flows::store(system, state, frame);
        Ok(())
    }

    /// Forces at the start of the next step, into the state.
    fn hand_over(&self, system: &System, state: &mut State) {
        let here = &self.rodas.here;
        state.trial.copy_from_slice(&here.trial);
        for (row, law) in system.rows.laws.iter().enumerate() {
            let pushes = matches!(law, Law::Unilateral { .. });
            state.tension[row] = if pushes { here.tension[row].max(0.0) } else { here.tension[row] };
        }
    }

    /// Brings `frame` to the configuration that has just been evaluated.
    fn refresh(&self, system: &System, frame: &mut Frame) {
        frame.follow(system, &self.rodas.here.frame);
    }

    /// How many inextensible ropes act.
    fn rigid_acting(&self, system: &System, state: &State) -> usize {
        let ropes = system.rigid.iter().filter(|&&row| row < system.rope_rows());
        ropes.filter(|&&row| state.modes[row] == Mode::Acting).count()
    }

    fn singular(&self, system: &System, time: f64, pivot: ZeroPivot) -> StepError {
        let element = self.rodas.matrix.layout.element(system, pivot.unknown).to_owned();
        super::singular(time, element)
    }

    fn too_short(&self, system: &System, state: &State) -> StepError {
        let element = self.weights.worst(system, state, &self.rodas);
        let cause =
            format!("the step fell below {STEP_FLOOR} s: forces change faster than any step can follow");
        StepError { time: state.time, element, cause }
    }
}
