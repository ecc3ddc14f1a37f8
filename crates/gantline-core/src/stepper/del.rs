//! `del`: the discrete Euler–Lagrange equation of Ham, Roh and Lee (2016) with regularised constraints,
//! their eq. (15), carried over to tree coordinates q with mass matrix M(q).
//!
//! The paper writes, with V the potential and ε the compliance,
//!
//! ```text
//! (10)  M (q₊ − 2q + q₋)/h = −h ∂V/∂q + h Gᵀλ        (11)  g + G (q₊ − q) = 0
//! (13)  ελ + g = 0
//! (15)  [ M  −Gᵀ   ] [ q₊  ]   [ M(2q − q₋) − h² ∂V/∂q ]
//!       [ G   ε/h² ] [ h²λ ] = [ −g + G q              ]
//! ```
//!
//! With the velocity of a step v₊ = (q₊ − q)/h, the one before v = (q − q₋)/h, and the tension T = −λ,
//! dividing by h gives
//!
//! ```text
//! M v₊ + h Gᵀ T = M v − h ∂V/∂q          G v₊ − ε T/h = −g/h
//! ```
//!
//! What `del` adds: velocity-dependent forces c, with those of water, damping time τ (T = (e + τ ė)/ε at the end of the step),
//! joint damping D, the geometric stiffness K of taut ropes, unilateral rows and driven joints:
//!
//! ```text
//! (M + hD + h²αK) v₊ + Gᵀ y = (M + h²K/4) v + h (f − c)       y = h T
//! G v₊ − ε/(h (h+τ)) y       = −g/(h+τ)                       0 ≤ T where a row is unilateral
//! q₊ = q ⊕ h v₊
//! ```
//!
//! A brake, what holds a sheave or joint, has a row without compliance, G v₊ = w, or where it slips its force at the end of the step
//! ([`crate::solver::brakes`]).
//!
//! c has the force of what water remembers ([`crate::force::memory`]) at the start of the step, as of springs. It goes on by
//! the trapezoidal rule with the step's velocity, z₊ = z + h (p (z + z₊)/2 + ν(v₊)), ν being the mean of both ends: what
//! the force then takes along the mean velocity of two steps is never negative in the whole, where K is passive.
//!
//! α, between ¼ and 1, damps K only where the step cannot follow ([`crate::solver::stiffness`]). c is taken at (v + v₊)/2, so a body that turns freely keeps its energy and angular momentum. With
//! `paper`, K = 0; with constant M, D = 0, τ = 0 and all rows acting that is eq. (15) to the letter.

use super::flows::{self, StepFlows};
use super::frame::Frame;
use super::loosening::Loosening;
use super::{StepError, StepReport, adjust, coils, parting, pinning, removing, seats, slinging, spots};
use glam::DVec3;

use crate::clock::Stage;
use crate::constraint::rope::span::Span;
use crate::event::EventLog;
use crate::force::{self, memory};
use crate::plan::condition::Support;
use crate::record::Sample;
use crate::rope::seat::Winding;
use crate::solver::brakes::holdings;
use crate::solver::complementarity::{Complementarity, Problem};
use crate::solver::kkt::Kkt;
use crate::solver::symbolic::ZeroPivot;
use crate::state::State;
use crate::system::System;
use crate::tree::bias::NewtonEuler;

/// Fixed-point rounds for the velocity-dependent forces.
const BIAS_ROUNDS: usize = 12;
/// Change of a velocity-dependent force that ends the rounds, relative to the largest generalised force.
const BIAS_TOLERANCE: f64 = 1e-12;
/// The same relative to the largest wrench that bodies need, of which as much is rounding.
const BIAS_ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Change, relative to the largest generalised force at the old velocity, after which rounds come to no end.
const RUNAWAY: f64 = 1e30;
/// Beyond this a velocity [m/s, rad/s] is an error of the step: nothing is faster than light.
const FASTEST: f64 = 3e8;

/// The integrator with its work arrays.
#[derive(Debug, Clone)]
pub struct Del {
    /// Step h [s].
    pub h: f64,
    /// K in the tangent.
    pub geometric_stiffness: bool,
    kkt: Kkt,
    rows: Complementarity,
    bias: NewtonEuler,
    c: Vec<f64>,
    /// What of c is resistance of water, and what is of dampers of mooring lines; empty where there is none.
    resistance: [Vec<f64>; 2],
    previous: Vec<f64>,
    middle: Vec<f64>,
    momentum: Vec<f64>,
    force: Vec<f64>,
    v: Vec<f64>,
    increment: Vec<f64>,
    support: Vec<Support>,
    /// Configuration at the start of the step.
    before: Vec<f64>,
    wraps: Vec<Winding>,
    loosening: Loosening,
}

impl Del {
    /// An integrator of step `h` [s] for `system`.
    pub fn new(system: &System, h: f64, geometric_stiffness: bool) -> Self {
        let zeros = vec![0.0; system.tree.velocities];
        Self {
            h,
            geometric_stiffness,
            kkt: Kkt::new(system),
            rows: Complementarity::new(system),
            bias: NewtonEuler::new(&system.tree),
            c: zeros.clone(),
            resistance: [(), ()]
                .map(|()| if system.tree.forces.is_empty() { Vec::new() } else { zeros.clone() }),
            previous: zeros.clone(),
            middle: zeros.clone(),
            momentum: zeros.clone(),
            force: zeros.clone(),
            v: zeros.clone(),
            increment: zeros,
            support: vec![Support::default(); system.groups.len()],
            before: Vec::new(),
            wraps: vec![Winding::default(); system.sheaves.len()],
            loosening: Loosening::new(system),
        }
    }

    /// Entries of the factor L.
    pub fn fill(&self) -> usize {
        self.kkt.fill()
    }

    /// Motion within the last step, from `before` to `after`.
    pub fn interpolate(
        &mut self,
        system: &System,
        states: (&State, &State),
        share: f64,
        sample: &mut Sample,
    ) {
        flows::interpolate(system, states, (share, self.h), &mut self.increment, sample);
    }

    /// One step from `state`, which `frame` belongs to; both are moved on.
    ///
    /// # Errors
    /// [`StepError`] where the matrix is singular or the motion faster than light; `state` is then as before
    /// but for the plan.
    pub fn step(
        &mut self,
        system: &System,
        state: &mut State,
        frame: &mut Frame,
        log: &mut EventLog,
    ) -> Result<StepReport, StepError> {
        let end = (state.steps + 1) as f64 * self.h;
        let pinned = self.act(system, state, frame, end, log)?;
        self.assemble(system, state, frame, end);
        let report = self.solve(system, state, frame)?;
        self.book(system, state, frame, pinned, log);
        self.move_on(system, state, frame, end);
        self.lay_anew(system, state, frame, log)?;
        flows::carry_tensions(system, [&self.before, &state.q], &mut state.tension);
        adjust::adjust(system, state, frame);
        flows::store(system, state, frame);
        Ok(report)
    }

    /// What the plan and the loads themselves change by the `end` of the step; true where a pin was put in.
    fn act(
        &mut self,
        system: &System,
        state: &mut State,
        frame: &mut Frame,
        end: f64,
        log: &mut EventLog,
    ) -> Result<bool, StepError> {
        flows::supports(system, &frame.kinematics, (&state.spots, &state.tension), &mut self.support);
        flows::advance_plan(system, state, frame, (end, &self.support), log);
        parting::cut(system, state, frame, end, log);
        parting::break_ropes(system, state, frame, log);
        removing::remove(system, state, frame, end, log);
        slinging::act(system, state, frame, log)?;
        Ok(pinning::act(system, state, frame, log)?.put_in)
    }

    /// Both sides but for c, and what is known of v₊.
    fn assemble(&mut self, system: &System, state: &State, frame: &mut Frame, end: f64) {
        let h = self.h;
        // Left side: M + hD + h²αK, G, −ε/(h (h+τ)).
        system.clock.time(Stage::Assembly, || {
            self.kkt.stiffness.update(system, state, frame, h, self.geometric_stiffness);
            self.kkt.assemble(system, &frame.mass, &frame.gradient, h);
        });
        holdings(system, state, frame, h, &mut self.rows.brakes);
        self.rows.begin(system, &frame.gradient, &state.modes, &state.tension);

        // Driven coordinates are known: their mean velocity over the step.
        self.v.copy_from_slice(&state.v);
        for (drive, timeline) in system.prescribed(&state.plan.timelines) {
            let travel = timeline.motion(end).position - timeline.motion(state.time).position;
            self.v[drive.dof] = travel / h;
        }
        self.middle.fill(0.0);
        for drive in system.drives.iter().filter(|drive| !drive.is_limited) {
            self.middle[drive.dof] = self.v[drive.dof];
        }
        // Right side: M (v − v_driven) + h² K v/4 − …, what the driven columns contribute taken off.
        for (increment, (old, known)) in self.increment.iter_mut().zip(state.v.iter().zip(&self.middle)) {
            *increment = old - known;
        }
        frame.mass.multiply(&self.increment, &mut self.momentum);
        self.kkt.stiffness.add_force(&self.middle, &state.v, -h * h, &mut self.momentum);
        for (index, place) in system.coils.iter().enumerate() {
            self.momentum[place.dof] += h * frame.coil_force(system, index);
        }
    }

    /// v₊ and the forces, with c, which holds −f of gravity, at the mean velocity by fixed point, and the waves of half-way.
    fn solve(&mut self, system: &System, state: &State, frame: &mut Frame) -> Result<StepReport, StepError> {
        let h = self.h;
        let mut report = StepReport { converged: true, ..StepReport::default() };
        frame.kinematics.time = state.time + 0.5 * h;
        let (mut scale, mut settled) = (0.0, false);
        for round in 0..BIAS_ROUNDS {
            for (middle, (old, new)) in self.middle.iter_mut().zip(state.v.iter().zip(&self.v)) {
                *middle = 0.5 * (old + new);
            }
            self.previous.copy_from_slice(&self.c);
            system.clock.time(Stage::Assembly, || {
                self.bias.update(&system.tree, &frame.kinematics, &self.middle, None, None, &mut self.c);
            });
            let change = distance(&self.c, &self.previous);
            if round > 0 && change <= (BIAS_TOLERANCE * largest(&self.c)).max(self.rounding()) {
                settled = true;
                break;
            }
            if round == 0 {
                scale = largest(&self.c);
            }
            // Where the step is far too long for how fast things turn, each round squares the error of the last, and c
            // at the old velocity would drive them faster still: then it is weight alone.
            let runs_away = round > 0 && change > RUNAWAY * scale;
            if runs_away {
                self.middle.fill(0.0);
                self.bias.update(&system.tree, &frame.kinematics, &self.middle, None, None, &mut self.c);
            }
            for (dof, force) in self.force.iter_mut().enumerate() {
                *force = self.momentum[dof] - h * self.c[dof];
            }
            let problem = Problem { h, value: &frame.value, gradient: &frame.gradient, force: &self.force };
            let solved = system
                .clock
                .time(Stage::Events, || self.rows.solve(system, &mut self.kkt, &problem, &mut self.v));
            let outcome = solved.map_err(|pivot| self.singular(system, state.time, pivot))?;
            report.factorisations += outcome.factorisations;
            report.converged = outcome.converged;
            if runs_away {
                break;
            }
        }
        report.converged &= settled;
        if let Some(dof) = self.v.iter().position(|velocity| velocity.is_nan() || velocity.abs() > FASTEST) {
            let element = system.tree.bodies[system.tree.owner[dof]].name.clone();
            let cause = format!(
                "a velocity is beyond that of light: the step of {h} s is too long, or forces or masses are out of any scale"
            );
            return Err(seats::explain(system, state, StepError { time: state.time, element, cause }));
        }
        report.complementarity_residual = self.rows.residual(system);
        Ok(report)
    }

    /// Rounding of c: where nothing weighs along the joints it may be that alone of the wrenches that it is made from
    /// [N, N m].
    fn rounding(&self) -> f64 {
        let wrenches = self.bias.wrenches.iter().flat_map(|wrench| [wrench.force, wrench.moment]);
        BIAS_ROUNDING * wrenches.map(DVec3::length).fold(0.0, f64::max)
    }

    /// What the step does to the energy, to the modes of the rows and to what the next one sets out from.
    fn book(&mut self, system: &System, state: &mut State, frame: &Frame, pinned: bool, log: &mut EventLog) {
        let (mut fluid_power, mut turning_power) = (0.0, 0.0);
        if !system.tree.forces.is_empty() {
            let [fluid, lines] = &mut self.resistance;
            force::resistance(&system.tree, &frame.kinematics, &self.middle, fluid);
            force::line_damping(&system.tree, &frame.kinematics, &self.middle, lines);
            fluid_power = force::stream_work(&system.tree, &frame.kinematics, &self.middle)
                + force::wave_work(&system.tree, &frame.kinematics, [&self.middle, &self.v])
                + force::submerged_work(&system.tree, &frame.kinematics, &self.middle);
            turning_power = force::turning_work(&system.tree, &frame.kinematics, &self.middle);
        }
        let flow = StepFlows {
            h: self.h,
            pinned,
            v: &self.v,
            c: &self.c,
            resistance: self.resistance.each_ref().map(Vec::as_slice),
            fluid_power,
            turning_power,
            rows: &self.rows,
            stiffness: &self.kkt.stiffness,
        };
        flow.book(system, state, frame, &mut self.increment);
        flow.change(state).events(system, state, log);
        flow.remember(system, state, frame);
    }

    /// q₊ = q ⊕ h v₊, and everything that goes with it.
    fn move_on(&mut self, system: &System, state: &mut State, frame: &mut Frame, end: f64) {
        let h = self.h;
        self.before.clone_from(&state.q);
        coils::supply(system, state, frame, &self.v, h);
        for (increment, velocity) in self.increment.iter_mut().zip(&self.v) {
            *increment = h * velocity;
        }
        system.tree.advance(&mut state.q, &self.increment);
        state.steps += 1;
        state.time = end;
        memory::set_out(&system.tree, &frame.kinematics, (&self.v, h), &mut state.past);
        flows::set_driven(system, state);
        coils::remember(system, state, frame);
        coils::turn(system, state);
        frame.update(system, state);
        memory::arrive(&system.tree, &mut frame.kinematics, (&self.v, h), &mut state.past);
        frame.follow_slowly(system, state);
    }

    /// How ropes lie and bodies touch where the step has led.
    fn lay_anew(
        &mut self,
        system: &System,
        state: &mut State,
        frame: &mut Frame,
        log: &mut EventLog,
    ) -> Result<(), StepError> {
        if let Some(error) = seats::used_up(system, state, Span::has_run_out) {
            return Err(error);
        }
        if !system.sheaves.is_empty() {
            let mut values = frame.value.iter().zip(&state.modes);
            if let Some(row) = values.position(|(value, mode)| !value.is_finite() && !mode.is_absent()) {
                let element = system.constraint_of_row(row).name().to_owned();
                let error =
                    StepError { time: state.time, element, cause: "it has no length here".to_owned() };
                return Err(seats::explain(system, state, error));
            }
            self.follow_seats(system, state, frame, log);
        }
        if !system.finders.is_empty() {
            self.follow_spots(system, state, frame, log);
        }
        if self.loosening.pass(system, state, frame) {
            // See where the rows of slack rope are booked.
            let method = state.ledger.flows.method;
            renew(system, state, frame);
            state.ledger.flows.rope_damping +=
                std::mem::replace(&mut state.ledger.flows.method, method) - method;
        }
        Ok(())
    }

    /// Follows where bodies may touch; what that does to springs at once is the method's loss.
    fn follow_spots(&mut self, system: &System, state: &mut State, frame: &mut Frame, log: &mut EventLog) {
        let held = |state: &State, frame: &Frame| flows::stored(system, state, frame).elastic;
        let before = held(state, frame);
        if spots::follow(system, &frame.kinematics, &frame.value, state, log).any {
            frame.update(system, state);
            state.ledger.flows.method += before - held(state, frame);
        }
    }

    /// Follows wraps; where a rope leaves a sheave or comes back, its time by running the wrap linearly, and what its
    /// change of length does at once to the method's loss.
    fn follow_seats(&mut self, system: &System, state: &mut State, frame: &mut Frame, log: &mut EventLog) {
        let (end, h) = (state.time, self.h);
        seats::wraps(system, &frame.kinematics, state, &mut self.wraps);
        let linearly = |_, before: f64, after: f64| end - h * (after / (after - before)).clamp(0.0, 1.0);
        if seats::follow(system, state, &self.wraps, log, linearly) {
            renew(system, state, frame);
        }
    }

    fn singular(&self, system: &System, time: f64, pivot: ZeroPivot) -> StepError {
        super::singular(time, self.kkt.element(system, pivot.unknown).to_owned())
    }
}

/// Evaluates everything again where ropes lie in another way; what that does to springs at once is the method's loss.
fn renew(system: &System, state: &mut State, frame: &mut Frame) {
    let held = |state: &State, frame: &Frame| flows::stored(system, state, frame).elastic;
    let before = held(state, frame);
    frame.update(system, state);
    state.ledger.flows.method += before - held(state, frame);
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| value.abs().max(most))
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |most, (a, b)| (a - b).abs().max(most))
}
