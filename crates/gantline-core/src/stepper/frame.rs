//! Everything that follows from a configuration: poses, mass matrix, rows and their gradients.

use super::coils::Passing;
use crate::clock::Stage;
use crate::constraint::Placed;
use crate::contact::spot::Spot;
use crate::force;
use crate::rope::coil::Coil;
use crate::rope::seat::Seat;
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::system::System;
use crate::tree::kinematics::Kinematics;
use crate::tree::mass::MassMatrix;

/// What a state remembers beside its motion, as far as rows depend on it.
#[derive(Clone, Copy)]
pub struct Remembered<'a> {
    /// What rows remember.
    pub memory: &'a [f64],
    /// How ropes lie on their sheaves.
    pub seats: &'a [Seat],
    /// Where bodies may touch.
    pub spots: &'a [Spot],
    /// What drums have wound.
    pub coils: &'a [Coil],
    /// How rows take part.
    pub modes: &'a [Mode],
}

impl<'a> Remembered<'a> {
    /// That of a state.
    pub fn of(state: &'a State) -> Self {
        let State { memory, seats, spots, coils, modes, .. } = state;
        Self { memory, seats, spots, coils, modes }
    }
}

/// The system at one configuration. Reused from step to step.
#[derive(Debug, Clone)]
pub struct Frame {
    /// Poses and columns.
    pub kinematics: Kinematics,
    /// M(q).
    pub mass: MassMatrix,
    /// g of every row.
    pub value: Vec<f64>,
    /// ∂g/∂q, by [`crate::system::Rows`].
    pub gradient: Vec<f64>,
    /// What passes the drums, by [`System::coils`].
    pub passing: Vec<Passing>,
    /// Unstretched rope that drums let go per velocity of their flows.
    pub feeding: Vec<f64>,
}

impl Frame {
    /// Room for `system`.
    pub fn new(system: &System) -> Self {
        Self {
            kinematics: Kinematics::new(&system.tree),
            mass: MassMatrix::new(&system.tree),
            value: vec![0.0; system.rows.count()],
            gradient: vec![0.0; system.rows.dofs.len()],
            passing: vec![Passing::default(); system.coils.len()],
            feeding: vec![0.0; system.coils.len()],
        }
    }

    /// Evaluates everything at the configuration of `state`.
    pub fn update(&mut self, system: &System, state: &State) {
        self.update_rows(system, state);
        system.clock.time(Stage::Assembly, || self.mass.update(&system.tree, &self.kinematics));
    }

    /// Takes over the poses and rows of another frame of the same system, and the mass matrix that belongs to them.
    pub fn follow(&mut self, system: &System, other: &Self) {
        self.kinematics.copy_from(&other.kinematics);
        self.value.copy_from_slice(&other.value);
        self.gradient.copy_from_slice(&other.gradient);
        self.passing.copy_from_slice(&other.passing);
        self.feeding.copy_from_slice(&other.feeding);
        system.clock.time(Stage::Assembly, || self.mass.update(&system.tree, &self.kinematics));
    }

    /// Takes slow places and headings on to the end of a step, where `state` and the frame are, and the mass matrix of what
    /// turns with them; what that adds to the kinetic energy comes from the waves.
    pub fn follow_slowly(&mut self, system: &System, state: &mut State) {
        if !force::has_waves(&system.tree) {
            return;
        }
        let held = self.mass.quadratic(&state.v);
        force::follow(&system.tree, &mut self.kinematics, (&state.v, state.time), &mut state.past);
        system.clock.time(Stage::Assembly, || self.mass.update(&system.tree, &self.kinematics));
        let gained = 0.5 * (self.mass.quadratic(&state.v) - held);
        state.ledger.flows.fluid_work += gained;
        state.ledger.kinetic += gained;
    }

    /// Evaluates poses and rows, not the mass matrix.
    fn update_rows(&mut self, system: &System, state: &State) {
        let q = &state.q;
        self.kinematics.past.copy_from_slice(&state.past);
        system.clock.time(Stage::Kinematics, || self.kinematics.update(&system.tree, q, state.time));
        system.clock.time(Stage::Assembly, || self.rows(system, q, &Remembered::of(state)));
    }

    /// Evaluates rows at the poses, which belong to the configuration `q`.
    pub fn rows(&mut self, system: &System, q: &[f64], by: &Remembered) {
        let Remembered { memory, seats, spots, .. } = *by;
        self.value.copy_from_slice(memory);
        let rows = &system.rows;
        let at = Placed { tree: &system.tree, kinematics: &self.kinematics, q, seats, spots, feeding: &[] };
        for (constraint, first) in system.constraints.iter().zip(rows.first.windows(2)) {
            let entries = rows.start[first[0]]..rows.start[first[1]];
            constraint.evaluate(&at, &mut self.value[first[0]..first[1]], &mut self.gradient[entries]);
        }
        for &row in system.adjusters.iter().flat_map(|adjuster| &adjuster.rows) {
            self.value[row] -= memory[row];
        }
        self.pass(system, q, by);
        self.add_feeding(system);
    }
}
