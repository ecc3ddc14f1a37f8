//! Friction on flows and joints in a step of `del`: brakes, motors of limited force, losses of sheaves.
//!
//! With the forces at the end of the step, T of the brake and T₁, T₂ of the spans that press on it,
//!
//! ```text
//! G v₊ = w, |T| ≤ B    or    T = ±B, ±(G v₊ − w) ≥ 0          B = B₀ + Σ wₖ max(0, Tₖ)
//! ```
//!
//! w being what the drive of a motor asks for in the mean of the step. While it slips the second is a row like others, of an
//! unsymmetric matrix, since what presses on the brake is not pressed by it; no force is taken from the step before.

use crate::constraint::brake::{At, Brake};
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::stepper::frame::Frame;
use crate::system::System;

/// Rounding of a bound, relative to it.
const ROUNDING: f64 = 1e-12;

/// One brake in one step.
#[derive(Debug, Clone, Copy, Default)]
pub struct Holding {
    /// Its row.
    pub row: usize,
    /// Degree of freedom of its flow or joint.
    pub dof: usize,
    /// True where that alone is held: not against the spin of a sheave.
    is_alone: bool,
    /// w [m/s or rad/s].
    pub asked: f64,
    /// Direction of its force while it slips, 1 or −1.
    pub way: f64,
    /// B₀ against motion one way and the other, at the velocity of the last step [N or N m].
    capacity: [f64; 2],
    /// How those answer to the speed at which a motor drives.
    slope: [f64; 2],
    /// v [m/s or rad/s].
    speed: f64,
    /// Rows of the spans that press on it, and wₖ; weights of none are zero.
    pub pressed: [(usize, f64); 2],
}

impl Holding {
    /// The brake in the row `row` in the step of `h` [s] from `state`, to which `frame` belongs.
    fn new(system: &System, (state, frame): (&State, &Frame), (row, brake): (usize, &Brake), h: f64) -> Self {
        let at = At { q: &state.q, kinematics: &frame.kinematics, seats: &state.seats };
        let motor = system.motors.iter().find(|(other, _)| *other == row);
        let timeline = motor.map(|&(_, drive)| &state.plan.timelines[drive]);
        let asked = timeline.map_or(0.0, |timeline| {
            (timeline.motion(state.time + h).position - timeline.motion(state.time).position) / h
        });
        let speed = state.v[brake.dof];
        let (dof, is_alone) = (brake.dof, brake.spin.is_none());
        let mut holding =
            Self { row, dof, is_alone, asked, speed, way: state.memory[row], ..Self::default() };
        if let Some(held) = timeline.and_then(|timeline| timeline.braked(state.time)) {
            holding.capacity = [held; 2];
            return holding;
        }
        holding.capacity = [speed, -speed].map(|driven| brake.motor(driven));
        holding.slope = [speed, -speed].map(|driven| brake.slope(driven));
        for (pressed, (span, _)) in holding.pressed.iter_mut().zip(&brake.spans) {
            *pressed = (*span, brake.weight(at, *span));
        }
        holding
    }

    /// True where it holds its flow or joint at rest: exactly, since rounding that adds up would decide which rope a drum
    /// pays out first as it lets go.
    pub fn rests(&self, modes: &[Mode]) -> bool {
        self.is_alone && self.asked == 0.0 && modes[self.row] == Mode::Acting
    }

    fn side(&self) -> usize {
        usize::from(self.way > 0.0)
    }

    /// Its force while it slips with nothing pressing, at v = 0 [N or N m].
    pub fn force_at_rest(&self) -> f64 {
        self.way * self.capacity[self.side()] + self.slope() * self.speed
    }

    /// What a velocity takes from that: of a motor that has no more power, less than nothing.
    pub fn slope(&self) -> f64 {
        self.slope[self.side()]
    }

    /// B against a force of the sign of `way` [N or N m].
    fn bound(&self, way: f64, tension: &[f64], v: &[f64]) -> f64 {
        let side = Self { way, ..*self };
        let pressed = self.pressed.iter().map(|&(row, weight)| weight * tension[row].max(0.0));
        way * (side.force_at_rest() - side.slope() * v[self.dof]) + pressed.sum::<f64>()
    }

    /// True where it cannot hold, or slips the wrong way: by the forces of all rows and their rounding, velocities, and what
    /// its row moves by.
    pub fn is_wrong(&self, mode: Mode, (tension, noise): (&[f64], &[f64]), v: &[f64], rate: f64) -> bool {
        let force = tension[self.row];
        if mode == Mode::Acting {
            let bound = self.bound(force.signum(), tension, v);
            // A sheave holds the difference of what pulls on both sides.
            let beside = self.pressed.iter().filter(|(_, weight)| *weight > 0.0);
            let known: f64 = beside.map(|&(row, _)| noise[row]).sum();
            return force.abs() > bound + ROUNDING * (bound + force.abs()) + known;
        }
        let speed = rate.abs().max(self.asked.abs()).max(self.speed.abs());
        (rate - self.asked) * self.way < -ROUNDING * speed
    }
}

/// All brakes in a step of `h` [s].
pub fn holdings(system: &System, state: &State, frame: &Frame, h: f64, out: &mut Vec<Holding>) {
    out.clear();
    out.extend(system.brakes().map(|brake| Holding::new(system, (state, frame), brake, h)));
}
