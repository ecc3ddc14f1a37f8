//! How each row takes part in an equilibrium: pulling, holding, sticking, resisting or not at all, and its force and
//! energy over its value.

use super::losses::{Contacts, Losses, Sheaves};
use crate::constraint::brake::Brake;
use crate::constraint::{AnyConstraint, Law};
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::system::System;

/// Stretch of a row without compliance under the weight of everything, before its multiplier is found [m].
const SOFTNESS: f64 = 0.03;
/// What is left of it in each search that follows.
const STIFFER: f64 = 0.1;
/// And what is left of it at least, unless what it holds is as stiff.
const LEAST_SHARE: f64 = 2e-3;
/// A contact that is open by less stands on what it would touch: the sign of so small a gap is rounding [m].
const TOUCHES: f64 = 1e-9;
/// The most that εk may be of a row that holds, where 40 searches have to do: then each leaves a fifth of what it lacks.
const BESIDE: f64 = 0.25;

/// How a row takes part in statics.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Part {
    /// Not at all: friction of contacts and of sheaves, ropes that have parted.
    Off,
    /// Pulls, or pushes, and never the other way.
    Pull,
    /// Pulls and pushes.
    Spring,
    /// Holds a joint where it is, with no more force than this [N or N m].
    Hold(f64),
    /// Resists with this force whatever the value: what slips [N].
    Resist(f64),
    /// The first of the two tangential rows of a contact that holds where it stands, with no more than this [N]: along
    /// what it has moved.
    Stick(f64),
    /// The second: across that.
    Across,
}

/// What a row holds: a coordinate, or one against another where there is one.
#[derive(Debug, Clone, Copy, Default)]
pub struct Held {
    position: usize,
    against: Option<usize>,
    /// Where it is held [m or rad].
    pub place: f64,
}

impl Held {
    /// How far it is from where it is held [m or rad].
    pub fn value(&self, q: &[f64]) -> f64 {
        q[self.position] - self.against.map_or(0.0, |other| q[other]) - self.place
    }

    /// Held where `q` has it.
    fn here(position: usize, against: Option<usize>, q: &[f64]) -> Self {
        let held = Self { position, against, place: 0.0 };
        Self { place: held.value(q), ..held }
    }
}

/// A row in statics.
#[derive(Debug, Clone, Copy)]
pub struct Bearing {
    /// How it takes part.
    pub part: Part,
    /// ε [m/N].
    pub compliance: f64,
    /// ε of the first search [m/N].
    pub first_compliance: f64,
    /// True where ε is statics' own.
    pub is_rigid: bool,
    /// T̂ [N].
    pub offset: f64,
    /// What it holds, and where; none of a row whose value is its own.
    pub held: Option<Held>,
    /// Length whose difference to another e is [m].
    pub length: f64,
}

impl Bearing {
    /// Begins with the multiplier that it had at the equilibrium `before`, and as stiff as that was found.
    pub fn go_on_from(&mut self, before: &Self) {
        if self.is_rigid && self.part != Part::Off && before.part != Part::Off {
            (self.offset, self.compliance) = (before.offset, before.compliance);
        }
    }

    /// Once its multiplier is about right, a row without compliance can be stiffer: the next one is closer. One that holds
    /// against ropes of the stiffness k, `beside` [N/m], leaves εk/(1 + εk) of what it lacks: it has to be stiffer than they.
    pub fn stiffen(&mut self, beside: f64) {
        if self.compliance > LEAST_SHARE * self.first_compliance {
            self.compliance *= STIFFER;
        } else if self.compliance * beside > BESIDE {
            self.compliance = BESIDE / beside;
        }
    }

    /// T and ½ ε T² of the value e, and whether T follows e there.
    pub fn at(&self, value: f64) -> (f64, f64, bool) {
        let trial = self.offset + value / self.compliance;
        match self.part {
            Part::Off => (0.0, 0.0, false),
            Part::Resist(force) => (force, force * value, false),
            Part::Pull if trial > 0.0 => (trial, 0.5 * self.compliance * trial * trial, true),
            Part::Pull => (0.0, 0.0, false),
            Part::Spring | Part::Across => (trial, 0.5 * self.compliance * trial * trial, true),
            Part::Hold(bound) | Part::Stick(bound) if trial.abs() <= bound => {
                (trial, 0.5 * self.compliance * trial * trial, true)
            }
            Part::Hold(bound) | Part::Stick(bound) => {
                let energy = self.compliance * bound * (trial.abs() - 0.5 * bound);
                (bound.copysign(trial), energy, false)
            }
        }
    }
}

/// Unstretched length of a rope's row [m]; 0 of other rows.
fn length(system: &System, row: usize) -> f64 {
    let AnyConstraint::Rope(rope) = system.constraint_of_row(row) else { return 0.0 };
    rope.spans[row - system.rows.first[system.constraint_index(row)]].length
}

/// Bearings of all rows, with drives where their timelines say at the state's time.
pub fn bearings(system: &System, state: &State, losses: Losses) -> Vec<Bearing> {
    let compliance = SOFTNESS / weight(system);
    let row = |(row, law): (usize, &Law)| {
        let is_rigid = law.compliance() == 0.0;
        let compliance = if is_rigid { compliance } else { law.compliance() };
        let (part, held) = match law {
            _ if state.modes[row].is_absent() => (Part::Off, None),
            Law::Unilateral { .. } => (Part::Pull, None),
            Law::Spring { .. } => (Part::Spring, None),
            Law::Friction { normal, coefficient, .. } => {
                let touches = state.trial[*normal] * law.compliance() >= -TOUCHES;
                // The first search takes what holds as holding all; without friction it would begin from a place that none has.
                (contact_part(losses.contacts, row - normal, touches && *coefficient > 0.0), None)
            }
            Law::Pin | Law::Brake { .. } => held(system, state, row, losses.sheaves),
        };
        let length = length(system, row);
        let first_compliance = compliance;
        Bearing { part, compliance, first_compliance, is_rigid, offset: 0.0, held, length }
    };
    system.rows.laws.iter().enumerate().map(row).collect()
}

/// How the tangential row `number`, 1 or 2, of a contact takes part, which touches at the start with friction or not.
fn contact_part(contacts: Contacts, number: usize, grips: bool) -> Part {
    match contacts {
        Contacts::Held if grips && number == 1 => Part::Stick(f64::INFINITY),
        Contacts::Held if grips => Part::Across,
        Contacts::Slid(_) => Part::Resist(0.0),
        _ => Part::Off,
    }
}

/// What the brake or motor of this row holds at most [N, N m].
pub fn capacity(system: &System, state: &State, row: usize, brake: &Brake) -> f64 {
    let motor = system.motors.iter().find(|(other, _)| *other == row);
    let braked = motor.and_then(|&(_, drive)| state.plan.timelines[drive].braked(state.time));
    braked.unwrap_or(brake.capacity)
}

/// What is taken to hold before the tension is known, which tells what a drum's rows have of `capacity`: no less than the
/// most that may be, T (1 + ε/2) of rope that was wound without strain. What holds is not let fall.
fn first_bound(system: &System, brake: &Brake, capacity: f64) -> f64 {
    let coils = system.coils.iter().filter(|place| place.dof == brake.dof);
    let strains = coils.map(|place| capacity / (place.rate.abs() * place.stiffness));
    capacity * (1.0 + 0.5 * strains.fold(0.0, f64::max))
}

fn held(system: &System, state: &State, row: usize, sheaves: Sheaves) -> (Part, Option<Held>) {
    let position = |dof: usize| {
        let body = &system.tree.bodies[system.tree.owner[dof]];
        body.first_position + dof - body.first_velocity
    };
    match system.constraint_of_row(row) {
        AnyConstraint::Pin(pin) if state.modes[row] == Mode::Acting => {
            (Part::Hold(f64::INFINITY), Some(Held::here(position(pin.dof), None, &state.q)))
        }
        AnyConstraint::Brake(brake) => {
            let part = match (brake.grip.is_none(), sheaves) {
                (true, _) => Part::Hold(first_bound(system, brake, capacity(system, state, row, brake))),
                // The groove grips, unless it is weaker than the bearing.
                (false, _) if brake.spin.is_some() => Part::Hold(f64::INFINITY),
                (false, Sheaves::Held) => Part::Hold(f64::INFINITY),
                (false, Sheaves::Ideal) => Part::Off,
                (false, Sheaves::Slip(_)) => Part::Resist(0.0),
            };
            (part, Some(Held::here(position(brake.dof), brake.spin.map(position), &state.q)))
        }
        _ => (Part::Off, None),
    }
}

/// Weight of everything that can move [N]; 1 where nothing weighs.
pub fn weight(system: &System) -> f64 {
    let mass: f64 = system.tree.bodies.iter().map(|body| body.mass).sum();
    let weight = mass * system.tree.gravity.length();
    if weight > 0.0 { weight } else { 1.0 }
}
