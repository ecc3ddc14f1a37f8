//! `adaptive`: error-controlled Rosenbrock steps of order 5 ([`rodas`]) between changes of the rows' modes.
//!
//! In a step the modes are frozen: a taut rope stays a spring even if its tension runs through zero. The course
//! of the step is then looked at: as long as no row is further from its law than the switching tolerance, the
//! step stands, and all rows that have crossed over change side together at its end, each with its own recorded
//! time. Where one goes further the step is cut where it reaches the tolerance. So a hundred slings that go taut
//! within a millisecond cost one restart and not a hundred.

mod begin;
mod books;
mod breaking;
pub mod course;
mod crests;
mod distance;
mod error;
pub mod evaluation;
mod impact;
mod length;
pub mod light;
mod looks;
mod places;
pub mod point;
mod prescribed;
mod ringing;
pub mod rodas;
mod seating;
mod spins;
mod switching;
mod tableau;
pub mod tangent;
mod wetting;
mod winding;

use super::frame::Frame;
use super::{StepError, StepReport, coils, flows, parting, pinning, removing, seats, slinging, spots};
use crate::audit::Flows;
use crate::clock::Stage;
use crate::constraint::Law;
use crate::constraint::rope::span::Span;
use crate::event::{EventLog, standstill};
use crate::force;
use crate::plan::condition::Support;
use crate::plan::soon;
use crate::record::Sample;
use crate::record::pulls::Bearers;
use crate::rope::seat::Winding;
use crate::solver::complementarity::Mode;
use crate::solver::symbolic::ZeroPivot;
use crate::state::State;
use crate::system::System;
use crate::tree::kinematics::Twist;
use books::WEIGHTS;
use course::Increment;
use evaluation::Evaluation;
use light::Laid;
use looks::Looks;
use prescribed::Prescribed;
use rodas::Rodas;
use winding::Paid;

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
        let share = system.weight_on_ropes() / system.whole_ropes().max(1) as f64;
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

/// The integrator with its work arrays.
#[derive(Debug, Clone)]
pub struct Adaptive {
    tolerance: Tolerance,
    rodas: Rodas,
    /// Length of the rotations' arms [m], inertia of every degree of freedom.
    weights: error::Weights,
    prescribed: Prescribed,
    probe: Evaluation,
    /// The looks at a step that may yet be cut, but for the last.
    seen: Vec<Evaluation>,
    /// The end of the part of the step that is made.
    next: Evaluation,
    /// What flows in it, and the part of that which looks along its course have seen.
    flows: Flows,
    looked: Flows,
    /// Motion there.
    end: Increment,
    point: Increment,
    rate: Increment,
    looks: Looks,
    /// Where the last look has left rope on light sheaves.
    laid: Laid,
    /// Where it was at the start of the step.
    laid_before: Laid,
    support: Vec<Support>,
    rows: Vec<f64>,
    defect: Vec<Twist>,
    /// Work space of [`crate::tree::drift::power`].
    changes: Vec<Twist>,
    /// What is wound on all sheaves at the end of the part that is made, and the share of it at which a rope left one
    /// or came back.
    wraps: Vec<Winding>,
    crossings: Vec<f64>,
    /// What the looks see of the drums, by [`System::coils`].
    paid: Vec<Paid>,
    /// What was wound a moment ago.
    unwound: Vec<Winding>,
    /// Which inextensible ropes acted before modes changed, by [`System::rigid`].
    taut: Vec<bool>,
    /// Which motors slipped when that was looked at last, by [`System::motors`].
    slipping: Vec<bool>,
    /// Where the course of the last step starts; there from the first step on.
    start: Option<Box<State>>,
    /// True while `rodas.here` belongs to the state.
    current: bool,
    /// True where the state is another than that to which steps have led.
    is_restored: bool,
    /// Accelerations at the end of the last step, and whether forces have jumped since.
    before: Vec<f64>,
    jumped: bool,
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
            prescribed: Prescribed::new(system),
            rodas,
            next: probe.clone(),
            seen: if system.light.is_empty() { Vec::new() } else { vec![probe.clone(); WEIGHTS.len()] },
            probe,
            flows: Flows::default(),
            looked: Flows::default(),
            end: Increment::zero(system),
            point: Increment::zero(system),
            rate: Increment::zero(system),
            looks: Looks::new(system),
            laid: Laid::default(),
            laid_before: Laid::default(),
            support: vec![Support::default(); system.groups.len()],
            rows: vec![0.0; system.rows.count()],
            defect: vec![Twist::default(); system.tree.bodies.len()],
            changes: vec![Twist::default(); system.tree.bodies.len()],
            wraps: vec![Winding::default(); system.sheaves.len()],
            unwound: vec![Winding::default(); system.sheaves.len()],
            crossings: vec![0.0; system.sheaves.len()],
            paid: vec![Paid::default(); system.coils.len()],
            taut: Vec::with_capacity(system.rigid.len()),
            slipping: Vec::with_capacity(system.motors.len()),
            start: None,
            current: false,
            is_restored: false,
            before: vec![0.0; system.tree.velocities],
            jumped: false,
            made: 1.0,
        }
    }

    /// What an error may be in one step.
    pub fn tolerance(&self) -> Tolerance {
        self.tolerance
    }

    /// Entries of the factors.
    pub fn fill(&self) -> usize {
        self.rodas.matrix.layout.symbolic.l_rows.len()
    }

    /// Forgets what belongs to the state of the last step.
    pub fn forget(&mut self) {
        self.current = false;
        self.is_restored = true;
    }

    /// Motion and forces at the share `theta` of the last step, which was made from `before`.
    pub fn interpolate(&mut self, system: &System, before: &State, theta: f64, sample: &mut Sample) {
        self.rodas.course.at(theta * self.made, &mut self.point);
        sample.q.copy_from_slice(&before.q);
        system.tree.advance(&mut sample.q, &self.point.phi);
        sample.v.copy_from_slice(&self.point.v);
        sample.acceleration.copy_from_slice(&self.point.a);
        sample.past.copy_from_slice(&self.point.past);
        self.looks.sample(system, theta, &mut sample.tension);
    }

    /// The largest force of a rope in the last step [N] and the share of the step at which it was, where it is
    /// more than `least`.
    pub fn peak(&self, row: usize, least: f64) -> Option<(f64, f64)> {
        self.looks.peak(row, least)
    }

    /// The same of what rows bear together.
    pub fn pull(&self, bearers: &Bearers, least: f64) -> Option<(f64, f64)> {
        self.looks.pull(bearers, least)
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
        if std::mem::take(&mut self.is_restored) && !system.light.is_empty() {
            // What springs over light sheaves hold is what steps see there, also as a rope is let go: the same bytes.
            self.rodas.evaluate(system, state);
            self.refresh(system, frame);
        }
        self.note_slipping(system, state);
        flows::supports(system, &frame.kinematics, (&state.spots, &state.tension), &mut self.support);
        let soon = soon(state.time);
        flows::advance_plan(system, state, frame, (soon, &self.support), log);
        state.restart |= parting::cut(system, state, frame, soon, log);
        state.restart |= removing::remove(system, state, frame, soon, log);
        state.restart |= slinging::act(system, state, frame, log)?;
        let pins = pinning::act(system, state, frame, log)?;
        state.restart |= pins.any;
        if pins.put_in {
            self.stop_pinned(system, state, frame, log)
                .map_err(|pivot| self.singular(system, state, pivot))?;
        }
        self.begin(system, state, frame, log).map_err(|pivot| self.singular(system, state, pivot))?;
        self.log_slipping(system, state, log);
        match &mut self.start {
            Some(start) => start.copy_from(state),
            None => self.start = Some(Box::new(state.clone())),
        }
        let due = parting::next_cut(system, soon).min(removing::next_removal(system, soon));
        let stop = state.plan.next_time(&system.plan, soon).min(due).min(until);
        let error = self.compute(system, state, &frame.mass, stop, &mut report)?;
        let h = self.rodas.course.h;
        if state.engaged {
            state.engaged_step = h;
            state.engaged = false;
        }
        state.next_step = h * (0.9 * error.max(1e-8).powf(-1.0 / tableau::ERROR_ORDER)).clamp(0.2, 6.0);
        system.clock.time(Stage::Events, || self.look(system, state));
        report.cut = self.made < 1.0;
        report.complementarity_residual = self.looks.broken;
        let whole = self.made == 1.0 && h == stop - state.time;
        self.advance(system, state, frame, log, if whole { Some(stop) } else { None })
            .map_err(|pivot| self.singular(system, state, pivot))?;
        self.log_slipping(system, state, log);
        frame.follow_slowly(system, state);
        // Rope on drums, what slides and what waves do is evaluated anew from what the state knows, as after a restore: the
        // same bytes.
        let slides = system.friction.iter().any(|&row| state.modes[row] == Mode::Slipping);
        self.current &= system.coils.is_empty() && !slides;
        self.current &= !force::has_waves(&system.tree);
        Ok(report)
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
        self.looked = self.flows;
        self.book_springs(system, state, -1.0);
        let (start, length) = (state.time, self.made * self.rodas.course.h);
        self.take_end(system, state);
        state.time = stop.unwrap_or(start + length);
        // The last look was at the end of the step: it is the start of the next.
        std::mem::swap(&mut self.next, &mut self.rodas.here);
        let method = self.flows.method;
        self.book_pieces(system, state);
        self.looked.method += self.flows.method - method;
        let here = &mut self.rodas.here;
        state.q.copy_from_slice(&here.q);
        light::keep(system, here, state);
        // There φ counts from here: φ̇ = v.
        here.phi_rate[..state.v.len()].copy_from_slice(&state.v);
        self.current = true;
        self.book_springs(system, state, 1.0);
        state.ledger.flows += std::mem::take(&mut self.flows);
        coils::remember(system, state, &self.rodas.here.frame);
        self.note_taut(system, state);
        self.rate.v.copy_from_slice(&state.v);
        if self.follow_seats(system, state, log, (start, length)) {
            let held = self.held(system, state);
            state.restart = true;
            self.rodas.evaluate(system, state);
            state.ledger.flows.method += held - self.held(system, state);
        }
        if !system.finders.is_empty() {
            self.follow_spots(system, state, log);
        }
        let held = self.held(system, state);
        if system.clock.time(Stage::Events, || self.switch(system, state, log, start, length)) {
            state.restart = true;
            self.rodas.evaluate(system, state);
            state.ledger.flows.contact_damping += held - self.held(system, state);
        }
        self.hand_over(system, state);
        self.refresh(system, frame);
        if self.rate.v != state.v {
            // Brakes have stopped what hardly moved.
            let lost = frame.mass.quadratic(&self.rate.v) - frame.mass.quadratic(&state.v);
            state.ledger.flows.friction += 0.5 * lost;
        }
        if system.inextensible.iter().any(|&row| state.modes[row] == Mode::Acting) {
            self.keep_lengths(system, state, frame, log)?;
        }
        flows::store(system, state, frame);
        Ok(())
    }

    /// Velocities, forces and anchors as at the end of the step; places follow with their springs.
    fn take_end(&self, system: &System, state: &mut State) {
        state.v.copy_from_slice(&self.end.v);
        state.acceleration.copy_from_slice(&self.end.a);
        state.past.copy_from_slice(&self.end.past);
        state.steps += 1;
        for (tension, &row) in self.end.rigid.iter().zip(&system.rigid) {
            state.tension[row] = *tension;
        }
        for (anchor, &row) in self.end.anchor.iter().zip(&system.friction) {
            state.memory[row] += anchor;
        }
    }

    /// Puts inextensible ropes that act to their length: an impact if one was slack, else the method's loss.
    fn keep_lengths(
        &mut self,
        system: &System,
        state: &mut State,
        frame: &mut Frame,
        log: &mut EventLog,
    ) -> Result<(), ZeroPivot> {
        let mut were_taut = system.inextensible.iter().zip(&self.taut);
        let hit = were_taut.any(|(&row, &taut)| !taut && state.modes[row] == Mode::Acting);
        let before = flows::stored(system, state, frame).sum();
        let work = self.project(system, state, frame, log, hit)?;
        self.rodas.evaluate(system, state);
        self.refresh(system, frame);
        self.hand_over(system, state);
        let lost = before + work.put_in() - flows::stored(system, state, frame).sum();
        let flows = &mut state.ledger.flows;
        *flows += work;
        *(if hit { &mut flows.impact } else { &mut flows.method }) += lost;
        Ok(())
    }

    /// Follows where bodies may touch; what that does to springs at once is the method's loss.
    fn follow_spots(&mut self, system: &System, state: &mut State, log: &mut EventLog) {
        let held = self.held(system, state);
        let Frame { kinematics, value, .. } = &self.rodas.here.frame;
        let followed = spots::follow(system, kinematics, value, state, log);
        if followed.any {
            state.restart |= followed.carrying;
            self.rodas.evaluate(system, state);
            state.ledger.flows.method += held - self.held(system, state);
        }
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

    fn singular(&self, system: &System, state: &State, pivot: ZeroPivot) -> StepError {
        let element = self.rodas.matrix.layout.element(system, pivot.unknown).to_owned();
        seats::explain(system, state, super::singular(state.time, element))
    }

    fn too_short(&self, system: &System, state: &State) -> StepError {
        if let Some(error) = seats::used_up(system, state, Span::is_used_up) {
            return error;
        }
        let met = standstill::has_met(system, &self.rodas.here.frame.kinematics);
        let (element, cause) = met.unwrap_or_else(|| {
            let cause = "forces change faster than any step can follow";
            let worst = self.weights.worst(system, &self.rodas);
            (worst, format!("the step fell below {STEP_FLOOR} s: {cause}"))
        });
        seats::explain(system, state, StepError { time: state.time, element, cause })
    }
}
