//! Statics: where a system rests, whether it rests there for good, and how it moves about that.
//!
//! [`Statics::settle`] finds the equilibrium that lies downhill of a configuration, with drives where they are at a
//! time of their timelines: [`search`] is the way down on the [`potential`], by the [`matrix`] of the exact tangent.
//!
//! Friction: contacts are taken without. Sheaves are taken as ideal, or as slipping all one way, which bounds what their
//! losses may hold ([`potential::Losses`]). What holds a joint or a drum by itself (a brake,
//! a locking pin, dry friction in newtons) holds it where the state has it, with no more than its own force.

pub mod eigen;
pub mod guard;
pub mod lift;
pub mod matrix;
pub mod modes;
pub mod potential;
pub mod search;
pub mod sensitivity;

use thiserror::Error;

use crate::audit::Ledger;
use crate::constraint::brake::At;
use crate::constraint::{AnyConstraint, Law};
use crate::force::AnyForce;
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::stepper::flows;
use crate::stepper::frame::Remembered;
use crate::system::System;
use potential::{Bearing, Losses, Part, bearings};
use search::{Effort, Search, Stuck};

/// What is left of the length of an inextensible rope [m].
const LENGTH_LEFT: f64 = 1e-11;
/// What is left of the force of a sheave that slips, relative to it.
const LOSS_LEFT: f64 = 1e-12;
/// Moves of multipliers, at most.
const ROUNDS: usize = 40;
/// ω² of a motion that nothing moves and nothing holds is within this of zero [1/s²]: a period of two hours.
pub const NEUTRAL: f64 = 1e-6;

/// Why there is no equilibrium.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("there is no equilibrium: {cause} ({element})")]
pub struct NoEquilibrium {
    /// Body or constraint concerned.
    pub element: String,
    /// Cause.
    pub cause: String,
}

/// An equilibrium.
#[derive(Debug, Clone, PartialEq)]
pub struct Rest {
    /// Largest imbalance of a degree of freedom relative to the forces that meet there.
    pub residual: f64,
    /// How many motions nothing holds: they stay as near to the start as they were.
    pub neutral: usize,
    /// How many motions lead away.
    pub unstable: usize,
    /// What the search took.
    pub effort: Effort,
    /// Factorisations made.
    pub factorisations: u64,
}

/// Statics of one system. Reused.
#[derive(Debug, Clone)]
pub struct Statics {
    search: Search,
    bearings: Vec<Bearing>,
}

impl Statics {
    /// Room for `system`.
    pub fn new(system: &System) -> Self {
        Self { search: Search::new(system), bearings: Vec::new() }
    }

    /// Moves `state` to the equilibrium downhill of it, with drives where their timelines say at its time.
    ///
    /// # Errors
    /// [`NoEquilibrium`] where something falls without end, or no step leads on.
    pub fn settle(
        &mut self,
        system: &System,
        state: &mut State,
        losses: Losses,
    ) -> Result<Rest, NoEquilibrium> {
        refuse_turned_drums(system, state)?;
        flows::set_driven(system, state);
        self.bearings = bearings(system, state, losses);
        self.search.effort = Effort::default();
        self.search.matrix.factorisations = 0;
        for round in 1.. {
            self.search.descend(system, state, &self.bearings).map_err(|stuck| explain(system, stuck))?;
            let lengths = self.move_multipliers();
            if lengths <= LENGTH_LEFT && self.follow_losses(system, state, losses) <= LOSS_LEFT {
                break;
            }
            if round == ROUNDS {
                // Losses are a share of tensions: they contract, lengths may not.
                let rigid = self.bearings.iter().position(|bearing| bearing.is_rigid).unwrap_or(0);
                let cause = "lengths that cannot change contradict one another".to_owned();
                let element = system.constraint_of_row(rigid).name().to_owned();
                return Err(NoEquilibrium { element, cause });
            }
        }
        let (unstable, neutral) = self.inertia(system, state);
        self.store(system, state);
        Ok(Rest {
            residual: self.search.here.residual(system),
            neutral,
            unstable,
            effort: self.search.effort,
            factorisations: self.search.matrix.factorisations,
        })
    }

    /// T̂ = T of rows without compliance; by how much the largest of their lengths was wrong [m].
    fn move_multipliers(&mut self) -> f64 {
        let mut most = 0.0_f64;
        for (bearing, &tension) in self.bearings.iter_mut().zip(&self.search.here.tension) {
            if bearing.is_rigid && bearing.part != Part::Off {
                most = most.max((tension - bearing.offset).abs() * bearing.compliance);
                bearing.offset = tension;
                bearing.stiffen();
            }
        }
        most
    }

    /// Forces of sheaves that slip after the tensions on both sides; by how much the largest share was wrong.
    fn follow_losses(&mut self, system: &System, state: &State, losses: Losses) -> f64 {
        let sign = match losses {
            Losses::None => return 0.0,
            Losses::Forward => 1.0,
            Losses::Backward => -1.0,
        };
        let mut most = 0.0_f64;
        let here = &self.search.here;
        for (bearing, row) in self.bearings.iter_mut().zip(0..) {
            let AnyConstraint::Brake(brake) = system.constraint_of_row(row) else { continue };
            if brake.grip.is_none() {
                continue;
            }
            let at = At { q: &here.q, kinematics: &here.frame.kinematics, seats: &state.seats };
            let bound = brake.bound(at, &here.tension, 0.0);
            let (Part::Resist(known) | Part::Hold(known)) = &mut bearing.part else { continue };
            let wanted = if brake.spin.is_some() { bound } else { sign * bound };
            most = most.max((wanted - *known).abs() / bound.max(f64::MIN_POSITIVE));
            *known = wanted;
        }
        most
    }

    /// How many motions have ω² below and about zero, by the signs of pivots at two shifts.
    fn inertia(&mut self, system: &System, state: &State) -> (usize, usize) {
        let Self { search, bearings } = self;
        search.here.update_mass(system);
        search.matrix.linearise(system, &search.here, &Remembered::of(state));
        search.matrix.extra.fill(0.0);
        let follows = &search.here.follows;
        let compliance = |row: usize| follows[row].then_some(bearings[row].compliance);
        let mut below = |shift: f64| {
            let made = search.matrix.factorise(system, shift, compliance);
            made.map(|()| search.matrix.below(system)).unwrap_or(0)
        };
        let unstable = below(NEUTRAL);
        (unstable, below(-NEUTRAL).saturating_sub(unstable))
    }

    /// Forces and modes into the state, which is at rest.
    fn store(&mut self, system: &System, state: &mut State) {
        state.v.fill(0.0);
        state.acceleration.fill(0.0);
        state.bias.fill(0.0);
        state.tension.copy_from_slice(&self.search.here.tension);
        state.trial.copy_from_slice(&self.search.here.tension);
        for (row, law) in system.rows.laws.iter().enumerate() {
            if state.modes[row] == Mode::Parted {
                continue;
            }
            if matches!(law, Law::Friction { .. }) {
                // Anchors lie below their points: without deflection.
                state.memory[row] += std::mem::take(&mut self.search.here.frame.value[row]);
            }
            state.modes[row] = match *law {
                Law::Unilateral { .. } if self.search.here.follows[row] => Mode::Acting,
                Law::Unilateral { .. } => Mode::Slack,
                Law::Friction { normal, .. } => state.modes[normal],
                Law::Pin => state.modes[row],
                Law::Brake { .. } => Mode::Acting,
            };
            if let Law::Unilateral { compliance, .. } = *law
                && !self.search.here.follows[row]
                && compliance > 0.0
            {
                state.trial[row] = self.search.here.value[row] / compliance;
            }
        }
        self.search.here.update(system, &self.bearings, &Remembered::of(state));
        let frame = &self.search.here.frame;
        for ((coil, place), passing) in state.coils.iter_mut().zip(&system.coils).zip(&frame.passing) {
            coil.laid = place.laid_under.map_or(passing.outside, |tension| tension / place.stiffness);
        }
        state.ledger = Ledger::open(flows::stored(system, state, frame));
        state.restart = true;
    }
}

/// What a drum lets go depends on what its rope bore while it was wound, so on the way there: it is known at the start.
fn refuse_turned_drums(system: &System, state: &State) -> Result<(), NoEquilibrium> {
    for place in &system.coils {
        let drive = system.drives.iter().position(|drive| drive.dof == place.dof);
        let asked = drive.map(|drive| state.plan.timelines[drive].motion(state.time).position);
        if asked.is_some_and(|asked| (asked - state.q[place.position]).abs() > LENGTH_LEFT) {
            let element = system.constraints[place.rope].name().to_owned();
            let cause = "its drum has turned by then, and what it has let go depends on the way: simulate it";
            return Err(NoEquilibrium { element, cause: cause.to_owned() });
        }
    }
    Ok(())
}

/// Whether a hull moves a body along.
fn floats(system: &System, body: usize) -> bool {
    let moves = |force: &AnyForce| matches!(force, AnyForce::Buoyancy(hull) if system.tree.subtree[hull.body].contains(&body));
    system.tree.forces.iter().any(moves)
}

fn explain(system: &System, stuck: Stuck) -> NoEquilibrium {
    let body = |index: usize| system.tree.bodies[index].name.clone();
    let (element, cause) = match stuck {
        Stuck::Falls(index) if floats(system, index) => (body(index), "it sinks: no hull bears that weight"),
        Stuck::Falls(index) => (body(index), "nothing holds it, it falls without end"),
        Stuck::UsedUp(rope) => {
            let name = system.constraints[rope].name().to_owned();
            (name, "it is hauled in until two of the places that it passes have come together")
        }
        Stuck::NoStep(dof) => (body(system.tree.owner[dof]), "no step brings its forces closer to balance"),
    };
    NoEquilibrium { element, cause: cause.to_owned() }
}
