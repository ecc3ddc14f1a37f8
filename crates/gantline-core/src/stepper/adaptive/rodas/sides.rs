//! What a stage knows before it is solved: r and ρ, r_α and r_z, and the right sides of (AD3).

use super::Rodas;
use crate::constraint::Law;
use crate::force::memory::memories;
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::stepper::adaptive::course::add;
use crate::stepper::adaptive::light;
use crate::stepper::adaptive::tableau::{C, D, GAMMA, TIMES};
use crate::stepper::adaptive::tangent::rows::{brake_of, slip_weights};
use crate::stepper::coils;
use crate::system::System;
use crate::tree::mass::MassMatrix;

impl Rodas {
    /// r, ρ and r_α, and x of driven degrees of freedom: their acceleration is known, so (AD2) gives it.
    pub(super) fn know(&mut self, system: &System, state: &State, stage: usize, h: f64) {
        let kappa = GAMMA * h;
        let at = if stage == 0 { &self.here } else { &self.stage };
        self.r.copy_from_slice(&at.phi_rate);
        self.rho.copy_from_slice(&self.point.a);
        for (&weight, k) in C[stage].iter().zip(&self.k) {
            add(&mut self.r, weight / h, &k.phi);
            add(&mut self.rho, weight / h, &k.v);
        }
        coils::follow(system, &state.coils, &self.here.frame.feeding, &mut self.r);
        light::follow(system, &self.here, &state.modes, (&mut self.r, &mut self.rows));
        for (drive, timeline) in system.prescribed(&state.plan.timelines) {
            let dof = drive.dof;
            let (now, _) = timeline.acceleration(state.time, state.time + TIMES[stage] * h);
            let (_, jerk) = timeline.acceleration(state.time, state.time);
            let k_a = now - self.point.a[dof] + h * D[stage] * jerk;
            self.x[dof] = self.r[dof] + kappa * (k_a + self.rho[dof]);
        }
        for (index, &row) in system.friction.iter().enumerate() {
            if state.modes[row] == Mode::Slipping {
                let others = C[stage].iter().zip(&self.k);
                let before: f64 = others.map(|(&weight, k)| weight / h * k.anchor[index]).sum();
                self.slid[index] = at.anchor_rate[index] + before;
            }
        }
    }

    /// First right side of (AD3).
    pub(super) fn motion_side(&mut self, system: &System, mass: &MassMatrix, stage: usize, h: f64) {
        let kappa = GAMMA * h;
        for dof in 0..self.sum.len() {
            self.sum[dof] = kappa * self.rho[dof] + self.r[dof];
        }
        mass.multiply(&self.sum, &mut self.force);
        self.matrix.add_damping(system, mass, &self.r[..self.sum.len()], kappa, &mut self.force);
        let at = if stage == 0 { &self.here } else { &self.stage };
        for (force, imbalance) in self.force.iter_mut().zip(&at.imbalance) {
            *force -= kappa * imbalance;
        }
        add(&mut self.force, -kappa * h * D[stage], &self.over_time);
        // Flows of light sheaves have no motion of their own: their equations say how tensions compare.
        for &dof in system.light.iter().flat_map(|light| &light.dofs) {
            self.force[dof] = 0.0;
        }
    }

    /// Second right side of (AD3), of rows by their laws and modes.
    pub(super) fn row_sides(&mut self, system: &System, state: &State, stage: usize, h: f64) {
        let kappa = GAMMA * h;
        for (row, law) in system.exerting_laws().iter().enumerate() {
            let tau = law.damping_time();
            self.rows[row] = match state.modes[row] {
                Mode::Acting if tau > 0.0 => {
                    tau * system.rows.rate(&self.here.frame.gradient, row, &self.r) / (kappa + tau)
                }
                _ => 0.0,
            };
        }
        self.drum_sides(system, state, kappa);
        self.inextensible_sides(system, state, stage, kappa);
        self.motor_sides(system, state, stage, h);
        for index in 0..system.friction.len() {
            self.slip_side(system, state, kappa, index);
        }
    }

    /// What is known of the rope that drums let go.
    fn drum_sides(&mut self, system: &System, state: &State, kappa: f64) {
        for (index, place) in system.coils.iter().enumerate() {
            if state.modes[place.row] == Mode::Acting {
                let feeding = self.here.frame.feeding[index];
                let beside = self.r[self.sum.len() + index] - feeding * self.r[place.dof];
                let known = (kappa, beside);
                self.rows[place.row] -= self.matrix.coils.known(system, &self.here.frame, index, known);
            }
        }
    }

    /// −κγ + G (κρ + r) + κ γ_v r of inextensible ropes that act.
    fn inextensible_sides(&mut self, system: &System, state: &State, stage: usize, kappa: f64) {
        let at = if stage == 0 { &self.here } else { &self.stage };
        for (index, &row) in system.rigid.iter().enumerate() {
            if state.modes[row] == Mode::Acting {
                let along = system.rows.rate(&self.here.frame.gradient, row, &self.sum);
                let turning = self.matrix.pull_rate(system, index, &self.r);
                self.rows[row] = along + kappa * (turning - at.pull[index]);
            }
        }
    }

    /// Motors follow the speed that their drives ask for; one that slips has a friction that depends on its own.
    fn motor_sides(&mut self, system: &System, state: &State, stage: usize, h: f64) {
        let kappa = GAMMA * h;
        for &(row, drive) in system.motors.iter().filter(|(row, _)| state.modes[*row] == Mode::Acting) {
            let (_, jerk) = state.plan.timelines[drive].acceleration(state.time, state.time);
            self.rows[row] += kappa * h * D[stage] * jerk;
        }
        for &(row, _) in system.motors.iter().filter(|(row, _)| state.modes[*row] == Mode::Slipping) {
            if let (Some(brake), None) = (brake_of(system, row), self.here.held[row]) {
                let driven = -state.memory[row] * state.v[brake.dof];
                self.rows[row] = -kappa * brake.slope(driven) * self.r[brake.dof];
            }
        }
    }

    /// Right side of a tangential row, by [`System::friction`], where it slides: what is known of its anchor's
    /// motion and of its damper's turns the force.
    fn slip_side(&mut self, system: &System, state: &State, kappa: f64, index: usize) {
        let row = system.friction[index];
        let law = &system.rows.laws[row];
        let Law::Friction { normal, damping_time, .. } = *law else { return };
        if state.modes[row] == Mode::Slipping {
            let partner = 2 * normal + 3 - row;
            let known = |row: usize, index: usize| {
                let rate = system.rows.rate(&self.here.frame.gradient, row, &self.r);
                damping_time * rate + kappa * self.slid[index]
            };
            let [own, other] = slip_weights(law, &self.here, kappa, row);
            self.rows[row] = own * known(row, index) + other * known(partner, index + partner - row);
        }
    }

    /// What is known of the increments of what water remembers before the motion of the stage is, and what that does to
    /// the right side.
    pub(super) fn recall(&mut self, system: &System, stage: usize, h: f64) {
        if self.recalled.is_empty() {
            return;
        }
        let kappa = GAMMA * h;
        let at = if stage == 0 { &self.here } else { &self.stage };
        self.recalled.fill(0.0);
        for (&weight, k) in C[stage].iter().zip(&self.k) {
            add(&mut self.recalled, weight / h, &k.past);
        }
        for (memory, tangent) in memories(&system.tree).zip(&self.matrix.memories) {
            let place = at.dynamics.at(&system.tree, &at.frame.kinematics, memory.body);
            let (now, before) = (memory.motion(&place), tangent.motion(None, &self.r));
            let motion = std::array::from_fn(|k| now[k] - before[k] + h * D[stage] * tangent.over_time[k]);
            memory.add_rate(&self.point.past, &motion, 1.0, &mut self.recalled);
        }
        let known = &mut self.k[stage].past;
        for (known, rate) in known.iter_mut().zip(&mut self.recalled) {
            *rate *= kappa;
            *known = *rate;
        }
        for (memory, tangent) in memories(&system.tree).zip(&self.matrix.memories) {
            memory.answer(kappa, &[0.0; 6], &mut self.recalled);
            tangent.push(memory, &self.recalled, -kappa, &mut self.force);
        }
    }
}
