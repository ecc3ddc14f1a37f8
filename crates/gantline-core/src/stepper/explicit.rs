//! `explicit`: semi-implicit Euler with a fixed step, ropes and contacts as springs with dampers. A baseline: what is
//! solved here is as simple as can be, and stable for short steps only.
//!
//! ```text
//! T = max(0, (e + τ ė)/ε) at q, v          M(q) a = −c(q, v) − D v − Gᵀ T
//! v₊ = v + h a                             q₊ = q ⊕ h v₊
//! ```
//!
//! c holds velocity terms less gravity. A mass on a damped spring, ω² = k/m, goes by a map of determinant 1 − hω²τ and
//! trace 2 − h²ω² − hω²τ: stable where h²ω² + 2hω²τ < 4, without damping h < 2/ω.
//!
//! Forces of the new state close the step, and begin the next. Contacts slip as their law says; the anchor of one that
//! slips follows so that spring and damper carry μN ([`flows::deflection`]).

use super::adjust::adjust;
use super::flows::{self, Change, deflection, is_friction};
use super::frame::Frame;
use super::{StepError, StepReport, coils};
use crate::audit::spring_energy;
use crate::clock::Stage;
use crate::constraint::Law;
use crate::event::EventLog;
use crate::plan::condition::Support;
use crate::record::Sample;
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::system::System;
use crate::tree::bias::NewtonEuler;
use crate::tree::factor::MassFactor;
use crate::tree::mass::MassMatrix;

/// Light: what is faster has been thrown, and would soon be no number any more.
const FASTEST: f64 = 3e8;
/// Of the largest energy that a lift has held and its drives have worked what the method may put in of its own. It is some
/// thousandths where steps are short enough; past a half of all what moves is its own doing, and no figure stands for the
/// lift. One that shakes a stiff rope, which damps it again, puts in many times as much.
const OF_ITS_OWN: f64 = 0.5;

/// The integrator with its work arrays.
#[derive(Debug, Clone)]
pub struct Explicit {
    /// Step h [s].
    pub h: f64,
    factor: MassFactor,
    bias: NewtonEuler,
    /// c + D v + Gᵀ T.
    imbalance: Vec<f64>,
    a: Vec<f64>,
    v: Vec<f64>,
    /// c(q, v₊).
    c: Vec<f64>,
    work: Vec<f64>,
    /// e and ė of every row at the start of the step, and ė there under v₊.
    value: Vec<f64>,
    rate: Vec<f64>,
    moved: Vec<f64>,
    modes: Vec<Mode>,
    tension: Vec<f64>,
    trial: Vec<f64>,
    support: Vec<Support>,
}

impl Explicit {
    /// An integrator of step `h` [s] for `system`.
    pub fn new(system: &System, h: f64) -> Self {
        let (zeros, rows) = (vec![0.0; system.tree.velocities], vec![0.0; system.rows.count()]);
        let free = system.driven.iter().map(Option::is_none).collect();
        Self {
            h,
            factor: MassFactor::new(&MassMatrix::new(&system.tree), free),
            bias: NewtonEuler::new(&system.tree),
            imbalance: zeros.clone(),
            a: zeros.clone(),
            v: zeros.clone(),
            c: zeros.clone(),
            work: zeros,
            value: rows.clone(),
            rate: rows.clone(),
            moved: rows.clone(),
            modes: vec![Mode::Slack; rows.len()],
            tension: rows.clone(),
            trial: rows,
            support: vec![Support::default(); system.groups.len()],
        }
    }

    /// What it cannot simulate; none where it can all.
    pub fn refusal(system: &System) -> Option<String> {
        if !system.sheaves.is_empty() {
            return Some(
                "the integrator explicit knows half turns only, no sheaves with true tangents".to_owned(),
            );
        }
        if !system.tree.forces.is_empty() {
            return Some(
                "the integrator explicit knows no water, no wind and no catenaries; use adaptive or del"
                    .to_owned(),
            );
        }
        if !system.cuts.is_empty() || !system.fragile.is_empty() {
            return Some("the integrator explicit knows no ropes that part; use adaptive or del".to_owned());
        }
        if !system.slings.is_empty() {
            return Some(
                "the integrator explicit knows no slings that are put on or taken off; use adaptive or del"
                    .to_owned(),
            );
        }
        if let Some(finder) = system.finders.first() {
            let name = system.constraints[finder.touch()].name();
            return Some(format!(
                "the integrator explicit knows no supports, no round loads on the ground and no contact between bodies, such as \
                 {name}; use adaptive or del"
            ));
        }
        if let Some((_, brake)) = system.brakes().next() {
            return Some(format!(
                "the integrator explicit knows no friction of sheaves, drums and joints, such as that of {}; use adaptive or del",
                brake.name
            ));
        }
        let row = *system.rigid.first()?;
        let name = system.constraint_of_row(row).name();
        Some(match system.rows.laws[row] {
            Law::Pin => {
                format!("the integrator explicit knows no pins, such as that of {name}; use adaptive or del")
            }
            _ => format!(
                "the integrator explicit knows springs only, and {name} is inextensible; give it an axial stiffness, \
                 or use adaptive or del"
            ),
        })
    }

    /// Entries of the factors.
    pub fn fill(&self) -> usize {
        self.factor.fill()
    }

    /// Motion within the last step, from `before` to `after`.
    pub fn interpolate(
        &mut self,
        system: &System,
        states: (&State, &State),
        share: f64,
        sample: &mut Sample,
    ) {
        flows::interpolate(system, states, (share, self.h), &mut self.work, sample);
    }

    /// One step from `state`, which `frame` belongs to; both are moved on.
    ///
    /// # Errors
    /// [`StepError`] where a body has no inertia or is faster than anything; `state` is then as before but for the plan.
    pub fn step(
        &mut self,
        system: &System,
        state: &mut State,
        frame: &mut Frame,
        log: &mut EventLog,
    ) -> Result<StepReport, StepError> {
        self.refuse_runaway(system, state, frame)?;
        let h = self.h;
        let end = (state.steps + 1) as f64 * h;
        flows::supports(system, &frame.kinematics, (&state.spots, &state.tension), &mut self.support);
        flows::advance_plan(system, state, frame, (end, &self.support), log);
        if state.steps == 0 {
            let State { v, bias, .. } = state;
            self.bias.update(&system.tree, &frame.kinematics, v, None, None, bias);
        }
        self.accelerate(system, state, frame, end)?;
        self.book_motion(system, state, frame);

        for (increment, velocity) in self.work.iter_mut().zip(&self.v) {
            *increment = h * velocity;
        }
        coils::supply(system, state, frame, &self.v, h);
        system.tree.advance(&mut state.q, &self.work);
        let start = std::mem::replace(&mut state.time, end);
        state.steps += 1;
        flows::set_driven(system, state);
        coils::remember(system, state, frame);
        coils::turn(system, state);
        self.value.copy_from_slice(&frame.value);
        self.move_anchors(system, state);
        frame.update(system, state);
        self.book_bias(system, state, frame);
        state.v.copy_from_slice(&self.v);
        state.acceleration.copy_from_slice(&self.a);
        for row in 0..system.rows.count() {
            self.book_row(system, state, frame, row);
        }
        self.forces(system, state, frame);
        self.book_openings(system, state, frame);
        if !system.adjusters.is_empty() {
            // By the tensions that the step has come to; those that it leaves follow from the new lengths.
            std::mem::swap(&mut state.tension, &mut self.tension);
            adjust(system, state, frame);
            std::mem::swap(&mut state.tension, &mut self.tension);
            self.forces(system, state, frame);
        }
        let (modes, tension, trial) = (&self.modes, &self.tension, &self.trial);
        Change { start, h, modes, tension, trial }.events(system, state, log);
        state.modes.copy_from_slice(modes);
        state.tension.copy_from_slice(tension);
        state.trial.copy_from_slice(trial);
        flows::store(system, state, frame);
        Ok(StepReport { converged: true, factorisations: 1, ..StepReport::default() })
    }

    /// # Errors
    /// [`StepError`] where the method drives the lift by energy of its own, ½h² aᵀMa of a step; at what has most of that.
    fn refuse_runaway(&mut self, system: &System, state: &State, frame: &Frame) -> Result<(), StepError> {
        let share = state.ledger.share_of_method();
        if share <= OF_ITS_OWN {
            return Ok(());
        }
        frame.mass.multiply(&state.acceleration, &mut self.work);
        let energy = |dof: &usize| self.work[*dof] * state.acceleration[*dof];
        let most = (0..self.work.len()).max_by(|one, other| energy(one).total_cmp(&energy(other)));
        let cause = format!(
            "the method has put in {share:.2} times the largest energy that the lift has held and its drives have worked: {}",
            too_long(self.h)
        );
        Err(StepError { time: state.time, element: name_of(system, most.unwrap_or(0)), cause })
    }

    /// Imbalance, acceleration and velocity after the step. Driven joints have their mean velocity over the step.
    fn accelerate(
        &mut self,
        system: &System,
        state: &State,
        frame: &Frame,
        end: f64,
    ) -> Result<(), StepError> {
        let h = self.h;
        for (dof, imbalance) in self.imbalance.iter_mut().enumerate() {
            *imbalance = state.bias[dof] + system.tree.damping[dof] * state.v[dof];
        }
        for (row, tension) in state.tension.iter().enumerate().filter(|(_, tension)| **tension != 0.0) {
            for (dof, entry) in system.rows.entries(&frame.gradient, row) {
                self.imbalance[dof] += entry * tension;
            }
        }
        for (index, place) in system.coils.iter().enumerate() {
            self.imbalance[place.dof] -= frame.coil_force(system, index);
        }
        self.a.fill(0.0);
        for (drive, timeline) in system.drives.iter().zip(&state.plan.timelines) {
            let travel = timeline.motion(end).position - timeline.motion(state.time).position;
            self.a[drive.dof] = (travel / h - state.v[drive.dof]) / h;
        }
        frame.mass.multiply(&self.a, &mut self.work);
        for (dof, a) in self.a.iter_mut().enumerate().filter(|(dof, _)| system.driven[*dof].is_none()) {
            *a = -self.imbalance[dof] - self.work[dof];
        }
        let made = system.clock.time(Stage::Factorisation, || self.factor.factorise(&frame.mass));
        made.map_err(|error| super::singular(state.time, name_of(system, error.dof)))?;
        system.clock.time(Stage::Solution, || self.factor.solve(&frame.mass, &mut self.a));
        for (velocity, (old, a)) in self.v.iter_mut().zip(state.v.iter().zip(&self.a)) {
            *velocity = old + h * a;
        }
        if let Some(dof) = self.v.iter().position(|velocity| velocity.is_nan() || velocity.abs() > FASTEST) {
            let cause = format!("a velocity has passed all bounds: {}", too_long(h));
            return Err(StepError { time: state.time, element: name_of(system, dof), cause });
        }
        Ok(())
    }

    /// Multiplying the step's equation by v₊ᵀ splits the change of energy into work and losses, as in `del`.
    fn book_motion(&mut self, system: &System, state: &mut State, frame: &Frame) {
        let h = self.h;
        let ledger = &mut state.ledger.flows;
        ledger.method += 0.5 * h * h * frame.mass.quadratic(&self.a);
        for (dof, damping) in system.tree.damping.iter().enumerate() {
            let (old, new) = (state.v[dof], self.v[dof]);
            ledger.joint_damping += h * damping * new * new;
            ledger.method += h * damping * new * (old - new);
        }
        if !system.drives.is_empty() {
            frame.mass.multiply(&self.a, &mut self.work);
            for drive in &system.drives {
                let force = self.work[drive.dof] + self.imbalance[drive.dof];
                *ledger.work_of(drive) += h * force * self.v[drive.dof];
            }
        }
        for row in 0..system.rows.count() {
            self.rate[row] = system.rows.rate(&frame.gradient, row, &state.v);
            self.moved[row] = system.rows.rate(&frame.gradient, row, &self.v);
        }
        self.bias.update(&system.tree, &frame.kinematics, &self.v, None, None, &mut self.c);
    }

    /// c at the start did work. Energies of gravity and of motion change by the integral of v₊·c(q, v₊) along the step,
    /// by the trapezoidal rule. Leaves c of the new state there.
    fn book_bias(&mut self, system: &System, state: &mut State, frame: &Frame) {
        let State { bias, ledger, .. } = state;
        let work = |c: &[f64]| self.h * self.v.iter().zip(c).map(|(v, c)| v * c).sum::<f64>();
        let taken = work(bias) - 0.5 * work(&self.c);
        self.bias.update(&system.tree, &frame.kinematics, &self.v, None, None, bias);
        ledger.flows.method += taken - 0.5 * work(bias);
    }

    /// The anchor of a contact that slips follows so that spring and damper carry the force, that of an open one so
    /// that its spring holds nothing.
    fn move_anchors(&self, system: &System, state: &mut State) {
        for (row, law) in system.rows.laws.iter().enumerate() {
            let mode = state.modes[row];
            if is_friction(law) && mode != Mode::Acting {
                let after = deflection(law, mode, state.tension[row], self.value[row], self.h);
                state.memory[row] += self.value[row] + self.h * self.moved[row] - after;
            }
        }
    }

    /// Loss in a row: what its force took from the motion, less what its spring kept. The spring's way is by the
    /// trapezoidal rule too, so that a wrong gradient shows in the remainder.
    fn book_row(&mut self, system: &System, state: &mut State, frame: &Frame, row: usize) {
        let (h, law) = (self.h, &system.rows.laws[row]);
        let (force, before) = (state.tension[row], self.value[row]);
        let way = 0.5 * h * (self.moved[row] + system.rows.rate(&frame.gradient, row, &self.v));
        let flow = h * force * self.moved[row];
        let ledger = &mut state.ledger.flows;
        let compliance = law.compliance();
        if is_friction(law) && state.modes[row] == Mode::Slack {
            return;
        }
        if is_friction(law) && state.modes[row] == Mode::Slipping {
            let after = frame.value[row];
            let stretched = after - before;
            let damper = law.damping_time() / compliance * stretched * stretched / h;
            let taken = force * stretched;
            ledger.friction += flow - taken;
            ledger.contact_damping += damper;
            ledger.method += taken - damper - spring_energy(law, after) + spring_energy(law, before);
            return;
        }
        let spring = law.stretch(before) / compliance;
        let damper = h * (force - spring) * self.rate[row];
        *(if row < system.rope_rows() { &mut ledger.rope_damping } else { &mut ledger.contact_damping }) +=
            damper;
        ledger.method += flow - damper - spring_energy(law, before + way) + spring_energy(law, before);
    }

    /// Forces and modes at the new state, by the laws.
    fn forces(&mut self, system: &System, state: &State, frame: &Frame) {
        let laws = &system.rows.laws;
        for (row, law) in laws.iter().enumerate() {
            let rate = system.rows.rate(&frame.gradient, row, &state.v);
            self.trial[row] = (frame.value[row] + law.damping_time() * rate) / law.compliance();
        }
        for (row, law) in laws.iter().enumerate() {
            let trial = self.trial[row];
            let Law::Friction { coefficient, normal, .. } = *law else {
                let acts = trial > 0.0 || matches!(law, Law::Spring { .. });
                (self.modes[row], self.tension[row]) =
                    if acts { (Mode::Acting, trial) } else { (Mode::Slack, 0.0) };
                continue;
            };
            let bound = coefficient * self.tension[normal];
            let size = self.trial[normal + 1].hypot(self.trial[normal + 2]);
            (self.modes[row], self.tension[row]) = if self.modes[normal] == Mode::Slack {
                (Mode::Slack, 0.0)
            } else if size <= bound {
                (Mode::Acting, trial)
            } else {
                (Mode::Slipping, bound * trial / size)
            };
        }
    }

    /// A contact that has opened lets go what its tangential springs hold, and its damper takes it. One that has closed
    /// begins with what its anchor is off, the curvature of the point's path in a step.
    fn book_openings(&self, system: &System, state: &mut State, frame: &Frame) {
        for (row, law) in system.rows.laws.iter().enumerate() {
            let held = [state.modes[row], self.modes[row]].map(|mode| mode != Mode::Slack);
            match held {
                _ if !is_friction(law) => {}
                [true, false] => state.ledger.flows.contact_damping += spring_energy(law, frame.value[row]),
                [false, true] => state.ledger.flows.method -= spring_energy(law, frame.value[row]),
                _ => {}
            }
        }
    }
}

fn too_long(h: f64) -> String {
    // Units of lift files leave rounding in the last digit: 2.6 ms are 0.0026000000000000003 s.
    let digits = format!("{h:.9e}");
    let step = digits.parse().unwrap_or(h);
    format!(
        "the step of {step} s is too long for an explicit method; it must be shorter than 2/ω of the fastest oscillation, shorter \
         still with damping"
    )
}

fn name_of(system: &System, dof: usize) -> String {
    system.tree.bodies[system.tree.owner[dof]].name.clone()
}
