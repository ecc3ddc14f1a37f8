//! Statics: where a system rests, whether it rests there for good, and how it moves about that.
//!
//! [`Statics::settle`] finds the equilibrium that lies downhill of a configuration, with drives where they are at a
//! time of their timelines: [`search`] is the way down on the [`potential`], by the [`matrix`] of the exact tangent.
//!
//! Friction: contacts are taken without and sheaves as ideal, or as holding what they can, or as slipping all one way,
//! which bounds what they may hold ([`losses::Losses`]). What holds a joint or a drum by itself (a brake,
//! a locking pin, dry friction in newtons) holds it where the state has it, with no more than its own force.

pub mod bearing;
mod edges;
pub mod eigen;
mod friction;
pub mod guard;
pub mod lift;
pub mod linear;
pub mod losses;
mod lowest;
pub mod matrix;
pub mod modes;
pub mod potential;
pub mod search;
pub mod sensitivity;
pub mod standing;
mod stepping_off;
mod stream;
mod winding;

use thiserror::Error;

use crate::audit::Ledger;
use crate::constraint::{AnyConstraint, Law};
use crate::event::afloat::Vessel;
use crate::force::{self, AnyForce};
use crate::solver::complementarity::Mode;
use crate::solver::symbolic::ZeroPivot;
use crate::state::State;
use crate::stepper::flows;
use crate::system::System;
use crate::tree::pose::Pose;
use bearing::{Bearing, Part, bearings};
use friction::WELL_WITHIN;
use losses::{Contacts, Losses};
use potential::Potential;
use search::{Effort, Search, Stuck};

/// What is left of the length of an inextensible rope [m].
const LENGTH_LEFT: f64 = 1e-11;
/// What is left in the end of the error of what motors and brakes of drums hold, relative to that.
const DRUMS_LEFT: f64 = 1e-10;
/// What is left of the force of a sheave that slips, relative to it.
const LOSS_LEFT: f64 = 1e-12;
/// Moves of multipliers on end, at most.
const ROUNDS: usize = 40;
/// Moves of what friction holds, at most.
const FRICTION_ROUNDS: usize = 200;
/// What friction does that has no such end.
const NO_BALANCE: &str = "its friction and what that holds find no balance";
/// What a drum does that comes to no end.
const NO_HOLD: &str = "its motor or brake and what pulls at the drum find no balance";
/// What a search does that ends without balance, and where it ends so on supports.
const NO_STEP: &str = "no step brings its forces closer to balance";
const SLIDES: &str = "it slides over what it stands on, which without friction does not hold it, \
    to where no step brings its forces closer to balance";
/// What a hull does that bears less than its weight.
const SINKS: &str = "it sinks: no hull bears that weight";
/// Wider shifts, as multiples, where one leaves nothing but rounding of a light node between stiff parts. The widest
/// takes motions of more than three minutes for neutral.
const WIDER: [f64; 5] = [1.0, 3.0, 10.0, 100.0, 1000.0];
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
    pace: friction::Pace,
    /// Where the drives were at the time of the equilibrium found last.
    asked: Vec<f64>,
    /// Where they are, which is not the same of motors that were too weak.
    places: Vec<f64>,
    /// Whether what was looked for last is there.
    is_found: bool,
    /// How much unstretched rope is in doubt that drums have wound since the equilibrium before [m].
    pub doubt: f64,
    /// Whether contacts that hold may slide where their friction finds no balance, see [`Statics::let_slide`].
    pub may_slide: bool,
    /// Groups of contacts that do so in this search.
    sliding: Vec<usize>,
    /// Groups of contacts that have done so since this was emptied, on the way to the equilibrium found last.
    pub slid: Vec<usize>,
}

impl Statics {
    /// Room for `system`.
    pub fn new(system: &System) -> Self {
        Self {
            search: Search::new(system),
            bearings: Vec::new(),
            pace: friction::Pace::default(),
            asked: Vec::new(),
            places: Vec::new(),
            is_found: false,
            doubt: 0.0,
            may_slide: true,
            sliding: Vec::new(),
            slid: Vec::new(),
        }
    }

    /// Moves `state` to the equilibrium downhill of it, with drives where their timelines say at its time. What lies on
    /// drums was wound before that, under the tension found, or under what was given.
    ///
    /// # Errors
    /// [`NoEquilibrium`] where something falls without end, or no step leads on.
    pub fn settle(
        &mut self,
        system: &System,
        state: &mut State,
        losses: Losses,
    ) -> Result<Rest, NoEquilibrium> {
        self.begin(system, state);
        self.bearings.clear();
        flows::set_driven_calm(system, state);
        self.balance(system, state, losses)?;
        winding::lay(system, state, &self.search.here.frame);
        self.rest(system, state)
    }

    /// What the equilibrium found last is like.
    fn rest(&mut self, system: &System, state: &State) -> Result<Rest, NoEquilibrium> {
        let counted =
            self.inertia(system, state).and_then(|counted| self.held_on_edges(system, state, counted));
        let (unstable, neutral) = counted.map_err(|pivot| NoEquilibrium {
            element: self.search.matrix.layout.element(system, pivot.unknown).to_owned(),
            cause: "whether it is stable there cannot be told".to_owned(),
        })?;
        Ok(Rest {
            residual: self.search.here.residual(system),
            neutral,
            unstable,
            effort: self.search.effort,
            factorisations: self.search.matrix.factorisations,
        })
    }

    /// Counts anew, with drives where they are at the time of `state`.
    fn begin(&mut self, system: &System, state: &State) {
        self.search.effort = Effort::default();
        self.search.matrix.factorisations = 0;
        self.slid.clear();
        self.asked = winding::asked(system, state);
        self.places.clone_from(&self.asked);
    }

    /// Moves `state` to the equilibrium downhill of it, with drives where it has them.
    fn balance(&mut self, system: &System, state: &mut State, losses: Losses) -> Result<(), NoEquilibrium> {
        self.is_found = false;
        self.sliding.clear();
        let before = std::mem::replace(&mut self.bearings, bearings(system, state, losses));
        for (bearing, before) in self.bearings.iter_mut().zip(&before) {
            bearing.go_on_from(before);
        }
        self.hold_as(system, &before);
        self.hold_motors(system, state);
        self.pace.begin(system.friction.len());
        self.note_aloft(system, state);
        let (mut unsettled, mut last) = (0, FRICTION_ROUNDS);
        let start = if system.friction.is_empty() { Vec::new() } else { state.q.clone() };
        for round in 1.. {
            let steps = self.search.effort.steps;
            let descended = self.search.descend(system, state, &mut self.bearings);
            let stays = self.search.effort.steps == steps;
            let (row, length) = self.move_multipliers(system);
            let has_lengths = length <= LENGTH_LEFT;
            // Friction that is set anew moves what has found its length.
            unsettled = if has_lengths { 0 } else { unsettled + 1 };
            let (drum, drums) = self.follow_drums(system, state);
            if let Err(stuck) = descended
                && !(drums > DRUMS_LEFT && self.is_at_a_joint(system, state, stuck))
            {
                return Err(self.explain(system, stuck, losses));
            }
            if has_lengths && drums <= DRUMS_LEFT && self.follow_friction(system, state, losses, stays) {
                break;
            }
            let (element, cause) = if unsettled == ROUNDS {
                // Friction is a share of other forces: it contracts, lengths may not.
                (row, "lengths that cannot change contradict one another")
            } else if round == last {
                let rubbing = system.friction.get(self.pace.worst()).copied().unwrap_or(0);
                if losses.contacts == Contacts::Held && self.let_slide(system, rubbing) {
                    last += FRICTION_ROUNDS;
                    // Not from wherever the search has got to.
                    state.q.copy_from_slice(&start);
                    continue;
                }
                // Of drums that do not settle friction has not been asked.
                if drums > DRUMS_LEFT { (drum, NO_HOLD) } else { (rubbing, NO_BALANCE) }
            } else {
                continue;
            };
            let element = system.constraint_of_row(element).name().to_owned();
            return Err(NoEquilibrium { element, cause: cause.to_owned() });
        }
        let pose = &self.search.here.frame.kinematics.pose;
        let has_capsized = |vessel: &&Vessel| vessel.beyond(&pose[vessel.body], system.tree.gravity) > 0.0;
        if let Some(vessel) = system.vessels.iter().find(has_capsized) {
            let cause = "it capsizes before it comes to rest".to_owned();
            return Err(NoEquilibrium { element: vessel.name.clone(), cause });
        }
        if let Some(vessel) = self.sunk(system) {
            return Err(NoEquilibrium { element: vessel.name.clone(), cause: SINKS.to_owned() });
        }
        self.store(system, state);
        self.stand(system, losses);
        self.sliding.retain(|group| !self.slid.contains(group));
        self.slid.append(&mut self.sliding);
        self.is_found = true;
        Ok(())
    }

    /// What friction holds where a lift stands sticks, at its bound too: which of these is past that is rounding. Sheaves
    /// do, and where `losses` say that friction holds contacts, along and across what they have moved to where they stick,
    /// and joints, but for motors: what one can just hold drags it along.
    fn stand(&mut self, system: &System, losses: Losses) {
        let is_held = losses.contacts == Contacts::Held;
        let Potential { follows, tension, .. } = &mut self.search.here;
        for (row, bearing) in self.bearings.iter().enumerate() {
            let AnyConstraint::Brake(brake) = system.constraint_of_row(row) else { continue };
            let Part::Hold(bound) = bearing.part else { continue };
            let is_motor = system.motors.iter().any(|&(motor, _)| motor == row);
            if bound > 0.0 && (!brake.grip.is_none() || is_held && !is_motor) {
                follows[row] = true;
            } else if is_motor && tension[row].abs() >= WELL_WITHIN * bound {
                follows[row] = false;
            }
        }
        for rows in system.friction.chunks_exact(2) {
            if matches!(self.bearings[rows[0]].part, Part::Stick(bound) if bound > 0.0) {
                follows[rows[0]] = true;
                self.bearings[rows[1]].compliance = self.bearings[rows[0]].compliance;
            }
        }
    }

    /// T̂ = T of rows without compliance, unless all their lengths are right: forces are those that balance then. The row
    /// whose length is the farthest wrong, and by how much [m].
    fn move_multipliers(&mut self, system: &System) -> (usize, f64) {
        let here = &self.search.here;
        let is_rigid = |bearing: &Bearing| bearing.is_rigid && bearing.part != Part::Off;
        let rows = self.bearings.iter().zip(&here.tension).enumerate();
        let rigid = rows.filter(|(_, (bearing, _))| is_rigid(bearing));
        let wrong = rigid
            .map(|(row, (bearing, tension))| (row, (tension - bearing.offset).abs() * bearing.compliance));
        let worst = wrong.fold((0, 0.0), |most: (usize, f64), one| if one.1 > most.1 { one } else { most });
        if worst.1 > LENGTH_LEFT {
            let stiffness = here.stiffness_beside(system, &self.bearings);
            for (row, bearing) in self.bearings.iter_mut().enumerate().filter(|(_, one)| is_rigid(one)) {
                bearing.offset = here.tension[row];
                let dofs = system.rows.entries(&here.frame.gradient, row).map(|(dof, _)| stiffness[dof]);
                bearing.stiffen(if bearing.held.is_some() { dofs.fold(0.0, f64::max) } else { 0.0 });
            }
        }
        worst
    }

    /// How many motions have ω² below and about zero, by the signs of pivots at two shifts.
    ///
    /// # Errors
    /// [`ZeroPivot`] where no shift near them tells.
    fn inertia(&mut self, system: &System, state: &State) -> Result<(usize, usize), ZeroPivot> {
        let Self { search, bearings, .. } = self;
        search.linearise(system, state);
        search.matrix.extra.fill(0.0);
        let follows = &search.here.follows;
        let compliance = |row: usize| follows[row].then_some(bearings[row].compliance);
        let mut below = |shift: f64| {
            let mut made = Ok(());
            for wider in WIDER {
                made = search.matrix.factorise(system, wider * shift, compliance);
                if made.is_ok() {
                    break;
                }
            }
            made.map(|()| search.matrix.below(system))
        };
        let unstable = below(NEUTRAL)?;
        Ok((unstable, below(-NEUTRAL)?.saturating_sub(unstable)))
    }

    /// Forces and modes into the state, which is at rest.
    fn store(&mut self, system: &System, state: &mut State) {
        state.v.fill(0.0);
        state.acceleration.fill(0.0);
        state.bias.fill(0.0);
        state.tension.copy_from_slice(&self.search.here.tension);
        state.trial.copy_from_slice(&self.search.here.tension);
        for (row, law) in system.rows.laws.iter().enumerate() {
            if state.modes[row].is_absent() {
                continue;
            }
            if let Law::Friction { compliance, .. } = law {
                // Anchors lie where their springs hold what they hold; below their points, where that is nothing.
                state.memory[row] += self.search.here.frame.value[row] - compliance * state.tension[row];
            }
            state.modes[row] = match *law {
                Law::Unilateral { .. } if self.search.here.follows[row] => Mode::Acting,
                Law::Unilateral { .. } => Mode::Slack,
                Law::Spring { .. } => Mode::Acting,
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
        if !(system.friction.is_empty() && system.coils.is_empty()) {
            // Where anchors lie and whether ropes pull on drums has changed: the rows see it.
            self.search.evaluate(system, state, &self.bearings);
        }
        let frame = &self.search.here.frame;
        force::begin(&system.tree, &frame.kinematics, (&state.v, state.time), &mut state.past);
        state.ledger = Ledger::open(system, flows::stored(system, state, frame));
        state.restart = true;
    }

    fn explain(&self, system: &System, stuck: Stuck, losses: Losses) -> NoEquilibrium {
        let body = |index: usize| system.tree.bodies[index].name.clone();
        // A hull that moorings and ropes cannot hold goes down without end, or until steps are too small.
        if let (Stuck::NoStep(_), Some(vessel)) = (&stuck, self.sunk(system)) {
            return NoEquilibrium { element: vessel.name.clone(), cause: SINKS.to_owned() };
        }
        let (element, cause) = match stuck {
            Stuck::Falls(_) | Stuck::NoStep(_) if !self.sliding.is_empty() => {
                // Without friction nothing holds it either.
                let group = &system.groups[self.sliding[self.sliding.len() - 1]];
                (system.constraints[group.contacts[0]].name().to_owned(), NO_BALANCE)
            }
            Stuck::Falls(index) if floats(system, index) => (body(index), SINKS),
            Stuck::Falls(index) => (body(index), "nothing holds it, it falls without end"),
            Stuck::UsedUp(rope) => {
                let name = system.constraints[rope].name().to_owned();
                let cause = "the rope is hauled in until two of the places that it passes have come together";
                (name, cause)
            }
            Stuck::NoStep(dof) if self.drifts(system, losses) => {
                let cause =
                    "wind, current or waves drive it over its supports, which without friction hold nothing";
                (body(system.tree.owner[dof]), cause)
            }
            Stuck::NoStep(dof) => {
                let stuck = system.tree.owner[dof];
                (body(stuck), if self.slides_freely(system, losses, stuck) { SLIDES } else { NO_STEP })
            }
        };
        NoEquilibrium { element, cause: cause.to_owned() }
    }

    /// A vessel that has gone down where the search is.
    fn sunk<'system>(&self, system: &'system System) -> Option<&'system Vessel> {
        let pose = &self.search.here.frame.kinematics.pose;
        system.vessels.iter().find(|vessel| is_under_water(system, vessel, pose))
    }

    /// Whether this body stands on something whose friction does not hold it.
    fn slides_freely(&self, system: &System, losses: Losses, body: usize) -> bool {
        let carries = |&&row: &&usize| match system.rows.laws[row] {
            Law::Friction { normal, coefficient, .. } => {
                coefficient > 0.0 && self.search.here.tension[normal] > 0.0
            }
            _ => false,
        };
        let stands = |&row: &usize| match system.constraint_of_row(row) {
            AnyConstraint::Contact(contact) => contact.facing.bodies.contains(&Some(body)),
            AnyConstraint::Touch(touch) => touch.facing.bodies.contains(&Some(body)),
            _ => false,
        };
        losses.contacts == Contacts::Free && system.friction.iter().filter(carries).any(stands)
    }

    /// Whether a stream pushes while contacts carry that friction does not hold.
    fn drifts(&self, system: &System, losses: Losses) -> bool {
        let here = &self.search.here;
        let mut normals = system.friction.iter().filter_map(|&row| match system.rows.laws[row] {
            Law::Friction { normal, .. } => Some(normal),
            _ => None,
        });
        losses.contacts == Contacts::Free
            && here.pushed.iter().any(|push| *push != 0.0)
            && normals.any(|normal| here.tension[normal] > 0.0)
    }
}

/// Whether a hull of a vessel has gone down with no part of it above the water: it hangs from ropes, or stands on the ground.
fn is_under_water(system: &System, vessel: &Vessel, pose: &[Pose]) -> bool {
    system.tree.forces.iter().any(|force| match force {
        AnyForce::Buoyancy(hull) if hull.body == vessel.body => {
            let afloat = hull.afloat(&pose[hull.body], system.tree.gravity);
            afloat.volume > 0.0 && afloat.area == 0.0
        }
        _ => false,
    })
}

/// Whether a hull moves a body along.
fn floats(system: &System, body: usize) -> bool {
    let moves = |force: &AnyForce| matches!(force, AnyForce::Buoyancy(hull) if system.tree.subtree[hull.body].contains(&body));
    system.tree.forces.iter().any(moves)
}
