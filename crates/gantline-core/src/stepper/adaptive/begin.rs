//! How a step begins: what drives and brakes ask at its time, and forces that have jumped.

use super::Adaptive;
use crate::event::EventLog;
use crate::solver::complementarity::Mode;
use crate::solver::symbolic::ZeroPivot;
use crate::state::State;
use crate::stepper::frame::Frame;
use crate::stepper::{coils, parting};
use crate::system::System;

/// Rounds in which brakes settle between holding and slipping after a change.
const SETTLING: usize = 20;
/// Accelerations that differ by less have not jumped [1 + m/s²].
const ROUNDING: f64 = 1e-9;

impl Adaptive {
    /// Makes sure that the start of the step is evaluated and its accelerations are right.
    pub(super) fn begin(
        &mut self,
        system: &System,
        state: &mut State,
        frame: &mut Frame,
        log: &mut EventLog,
    ) -> Result<(), ZeroPivot> {
        self.before.copy_from_slice(&state.acceleration);
        self.jumped = false;
        for (drive, timeline) in system.prescribed(&state.plan.timelines) {
            let (a, _) = timeline.acceleration(state.time, state.time);
            // A step that ends at a given time ends where waves have it but for rounding.
            let rounding = timeline.waves().map_or(0.0, |_| ROUNDING * (1.0 + a.abs()));
            state.restart |= (state.acceleration[drive.dof] - a).abs() > rounding;
            state.acceleration[drive.dof] = a;
            state.v[drive.dof] = timeline.motion(state.time).velocity;
        }
        for &(_, drive) in system.motors.iter().filter(|(row, _)| state.modes[*row] == Mode::Acting) {
            let timeline = &state.plan.timelines[drive];
            let (dof, wanted) = (system.drives[drive].dof, timeline.acceleration(state.time, state.time).0);
            state.restart |= (state.acceleration[dof] - wanted).abs() > ROUNDING * (1.0 + wanted.abs());
            state.v[dof] = timeline.motion(state.time).velocity;
        }
        for &(_, drive) in &system.motors {
            // Kept in the state, so that a run that goes on from one starts no other way.
            let changed = state.plan.timelines[drive].notice(state.time);
            self.current &= !changed;
            state.restart |= changed;
        }
        self.current &= !coils::turn(system, state);
        loop {
            self.settle_forces(system, state, frame)?;
            if coils::turn(system, state) {
                self.current = false;
                self.settle_forces(system, state, frame)?;
            }
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
            self.jumped = true;
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
}
