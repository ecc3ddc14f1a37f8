//! The potential energy of a system at rest, its slope, and what every row carries.
//!
//! ```text
//! V(q) = −Σ m g·c + U + Σ ½ ε T²        T = max(0, T̂ + e/ε) of ropes, contacts and stops
//!                                        T = T̂ + e/ε within ± its bound, of brakes that hold
//! ```
//!
//! U is the energy of the water that hulls displace ([`crate::force::buoyancy`]). Where a row has no compliance ε is a small one of statics' own and T̂ the multiplier, which is moved to T until
//! nothing is left of e: the augmented Lagrangian (Hestenes 1969, Powell 1969). Else T̂ = 0, and V is the energy.
//!
//! A contact that holds where it stands has both its tangential rows in one law, with s how far it has moved along its
//! plane: V = s²/2ε while s/ε is within its bound b, b (|s| − ½ ε b) beyond. Its rows are taken along s and across it:
//! along, the law is that of a brake; across, a force b that turns with s has the stiffness b/|s|.

use glam::DVec3;

use crate::audit::gravity_energy;
use crate::constraint::brake::Brake;
use crate::constraint::{AnyConstraint, Law};
use crate::force::{self, Energies};
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::stepper::frame::{Frame, Remembered};
use crate::system::System;
use crate::tree::bias::NewtonEuler;
use crate::tree::joint::Motion;

/// Stretch of a row without compliance under the weight of everything, before its multiplier is found [m].
const SOFTNESS: f64 = 0.03;
/// What is left of it in each search that follows.
const STIFFER: f64 = 0.1;
/// And what is left of it at least.
const LEAST_SHARE: f64 = 2e-3;

/// ε of what holds nothing [m/N].
const FREE: f64 = 1e6;
/// Rounding of a sum of lengths, relative to the longest.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// How a row takes part in statics.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Part {
    /// Not at all: friction of contacts and of sheaves, ropes that have parted.
    Off,
    /// Pulls, or pushes, and never the other way.
    Pull,
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

/// What friction of sheaves does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sheaves {
    /// Nothing: one tension on both sides, the middle of what they may hold.
    Ideal,
    /// All slip towards the end of their ropes' routes (1) or towards the start (−1).
    Slip(f64),
    /// They hold where the state has them, each with no more than its friction.
    Held,
}

/// What friction of contacts does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Contacts {
    /// Nothing: they slide freely.
    Free,
    /// They hold where the state has them, each with no more than its friction.
    Held,
    /// All have slid along this direction of the world, a unit vector, and friction pulls them back.
    Slid(DVec3),
}

/// What friction of sheaves and contacts does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Losses {
    /// Of sheaves.
    pub sheaves: Sheaves,
    /// Of contacts.
    pub contacts: Contacts,
}

impl Losses {
    /// Nothing.
    pub const NONE: Self = Self { sheaves: Sheaves::Ideal, contacts: Contacts::Free };
    /// All sheaves slip towards the end of their ropes' routes; contacts slide freely.
    pub const FORWARD: Self = Self { sheaves: Sheaves::Slip(1.0), ..Self::NONE };
    /// All slip towards the start.
    pub const BACKWARD: Self = Self { sheaves: Sheaves::Slip(-1.0), ..Self::NONE };
    /// Sheaves and contacts hold where the state has them.
    pub const HELD: Self = Self { sheaves: Sheaves::Held, contacts: Contacts::Held };

    /// All contacts have slid along a direction of the world, sheaves being ideal; none where that is no direction.
    pub fn slid(direction: [f64; 3]) -> Option<Self> {
        let way = DVec3::from_array(direction).try_normalize()?;
        Some(Self { contacts: Contacts::Slid(way), ..Self::NONE })
    }

    /// What it does on the way to where this is asked for: contacts hold, since what stands in the wind or in a slack
    /// sling would slide there. What has slid in the end is where everything was held.
    pub fn on_the_way(self) -> Self {
        let sheaves = if matches!(self.contacts, Contacts::Slid(_)) { Sheaves::Held } else { self.sheaves };
        Self { sheaves, contacts: Contacts::Held }
    }
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
    fn value(&self, q: &[f64]) -> f64 {
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
    /// Once its multiplier is about right, a row without compliance can be stiffer: the next one is closer.
    pub fn stiffen(&mut self) {
        if self.compliance > LEAST_SHARE * self.first_compliance {
            self.compliance *= STIFFER;
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
            Part::Across => (trial, 0.5 * self.compliance * trial * trial, true),
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
            Law::Friction { normal, .. } => {
                let touches = state.trial[*normal] >= 0.0;
                (contact_part(losses.contacts, row - normal, touches), None)
            }
            Law::Pin | Law::Brake { .. } => held(system, state, row, losses.sheaves),
        };
        let length = length(system, row);
        Bearing { part, compliance, first_compliance: compliance, is_rigid, offset: 0.0, held, length }
    };
    system.rows.laws.iter().enumerate().map(row).collect()
}

/// How the tangential row `number`, 1 or 2, of a contact takes part, which touches at the start or not.
fn contact_part(contacts: Contacts, number: usize, touches: bool) -> Part {
    match contacts {
        Contacts::Held if touches && number == 1 => Part::Stick(f64::INFINITY),
        Contacts::Held if touches => Part::Across,
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
                (true, _) => Part::Hold(capacity(system, state, row, brake)),
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

/// Weight of what a degree of freedom moves, times its radius of gyration where that turns [N, N m].
fn weight_of(system: &System, dof: usize) -> f64 {
    let tree = &system.tree;
    let inertia = tree.inertia_scale[dof];
    let below: f64 = tree.subtree[tree.owner[dof]].iter().map(|&body| tree.bodies[body].mass).sum();
    let turns = tree.motions[dof] == Motion::Turn && below > 0.0;
    tree.gravity.length() * if turns { (inertia * below).sqrt() } else { inertia }
}

/// Everything at one configuration. Reused.
#[derive(Debug, Clone)]
pub struct Potential {
    /// Configuration.
    pub q: Vec<f64>,
    /// Poses, rows, gradients, mass matrix.
    pub frame: Frame,
    /// Inverse dynamics without any motion.
    pub dynamics: NewtonEuler,
    /// ∂V/∂q of gravity and buoyancy, less what wind and current push with.
    pub gravity: Vec<f64>,
    /// The opposite of what wind and current push with, which has no V; empty where there are none.
    pub pushed: Vec<f64>,
    /// ∂V/∂q.
    pub slope: Vec<f64>,
    /// Sum of the sizes of the terms of every slope.
    pub terms: Vec<f64>,
    /// What rounding makes of every slope.
    pub noise: Vec<f64>,
    /// e of every row as statics counts it [m].
    pub value: Vec<f64>,
    /// T of every row [N].
    pub tension: Vec<f64>,
    /// True where T follows e.
    pub follows: Vec<bool>,
    /// V [J].
    pub energy: f64,
    /// Rounding of V [J].
    pub rounding: f64,
    /// Directions in which contacts that hold have moved, along their two tangents, and ε across, by contact.
    along: Vec<([f64; 2], f64)>,
    still: Vec<f64>,
    /// Weight that a degree of freedom moves, times the radius of gyration where it turns [N, N m].
    weight: Vec<f64>,
}

impl Potential {
    /// Room for `system`.
    pub fn new(system: &System) -> Self {
        let (rows, size) = (system.rows.count(), system.tree.velocities);
        Self {
            q: vec![0.0; system.tree.positions],
            frame: Frame::new(system),
            dynamics: NewtonEuler::new(&system.tree),
            gravity: vec![0.0; size],
            pushed: if force::has_stream(&system.tree) { vec![0.0; size] } else { Vec::new() },
            slope: vec![0.0; size],
            terms: vec![0.0; size],
            noise: vec![0.0; size],
            value: vec![0.0; rows],
            tension: vec![0.0; rows],
            follows: vec![false; rows],
            energy: 0.0,
            rounding: 0.0,
            along: vec![([1.0, 0.0], 0.0); system.friction.len() / 2],
            still: vec![0.0; size],
            weight: (0..size).map(|dof| weight_of(system, dof)).collect(),
        }
    }

    /// Evaluates everything at `self.q`, with ropes on their sheaves and drums as the state has them.
    pub fn update(&mut self, system: &System, bearings: &[Bearing], by: &Remembered) {
        self.place(system);
        self.evaluate(system, bearings, by);
    }

    /// Poses at `self.q`, before any wave comes.
    pub fn place(&mut self, system: &System) {
        self.frame.kinematics.update(&system.tree, &self.q, 0.0);
    }

    /// Evaluates everything else, at the poses of `self.q`.
    pub fn evaluate(&mut self, system: &System, bearings: &[Bearing], by: &Remembered) {
        let Self { q, frame, dynamics, gravity, .. } = self;
        frame.rows(system, q, by);
        dynamics.update(&system.tree, &frame.kinematics, &self.still, None, None, gravity);
        if !self.pushed.is_empty() {
            force::resistance(&system.tree, &self.frame.kinematics, &self.still, &mut self.pushed);
        }
        self.slope.copy_from_slice(&self.gravity);
        for (terms, gravity) in self.terms.iter_mut().zip(&self.gravity) {
            *terms = gravity.abs();
        }
        self.noise.fill(0.0);
        let places = self.frame.kinematics.centre_of_gravity.iter();
        let reach = places.fold(1.0_f64, |most, place| most.max(place.abs().max_element()));
        let Energies { fluid, lines } = force::energy(&system.tree, &self.frame.kinematics);
        let gravity = gravity_energy(system, &self.frame.kinematics);
        self.energy = gravity + fluid + lines;
        self.rounding = gravity.abs() + fluid.abs() + lines.abs();
        for (row, bearing) in bearings.iter().enumerate() {
            self.value[row] = bearing.held.map_or(self.frame.value[row], |held| held.value(&self.q));
            if matches!(bearing.part, Part::Stick(_) | Part::Across) {
                continue;
            }
            let (tension, energy, follows) = bearing.at(self.value[row]);
            (self.tension[row], self.follows[row]) = (tension, follows);
            self.add(system, row, energy, bearing, reach);
        }
        self.hold_contacts(system, bearings, reach);
        self.rounding *= f64::EPSILON;
    }

    /// Adds the energy of a row, and its force to the slopes.
    fn add(&mut self, system: &System, row: usize, energy: f64, bearing: &Bearing, reach: f64) {
        let tension = self.tension[row];
        self.energy += energy;
        self.rounding += energy;
        if tension != 0.0 {
            for (dof, entry) in system.rows.entries(&self.frame.gradient, row) {
                self.slope[dof] += entry * tension;
                self.terms[dof] += (entry * tension).abs();
                self.noise[dof] += entry.abs() * ROUNDING * (bearing.length + reach) / bearing.compliance;
            }
        }
    }

    /// Contacts that hold where they stand. Forces are along their tangents, values and gradients from then on
    /// along s and across it.
    fn hold_contacts(&mut self, system: &System, bearings: &[Bearing], reach: f64) {
        for (contact, rows) in system.friction.chunks_exact(2).enumerate() {
            let [one, other] = [rows[0], rows[1]];
            let bearing = Bearing { offset: 0.0, ..bearings[one] };
            let Part::Stick(bound) = bearing.part else { continue };
            let moved = [self.value[one], self.value[other]];
            let size = moved[0].hypot(moved[1]);
            let way = if size > 0.0 { moved.map(|part| part / size) } else { [1.0, 0.0] };
            let (tension, energy, follows) = bearing.at(size);
            for (row, share) in [(one, way[0]), (other, way[1])] {
                self.tension[row] = tension * share;
                self.add(system, row, energy * share * share, &bearing, reach);
            }
            (self.follows[one], self.follows[other]) = (follows, true);
            // Where it holds nothing at all ε across is without end: next to nothing holds it then.
            let across = if follows { bearing.compliance } else { size / bound.max(f64::MIN_POSITIVE) };
            self.along[contact] = (way, across.min(FREE));
            (self.value[one], self.value[other]) = (size, 0.0);
            let start = [system.rows.start[one], system.rows.start[other]];
            for entry in 0..system.rows.start[one + 1] - start[0] {
                let places = [start[0] + entry, start[1] + entry];
                let [a, b] = places.map(|place| self.frame.gradient[place]);
                self.frame.gradient[places[0]] = way[0] * a + way[1] * b;
                self.frame.gradient[places[1]] = way[0] * b - way[1] * a;
            }
        }
    }

    /// Writes into the bearings of contacts that hold how they answer across what they have moved, as it is here.
    pub fn turn_bearings(&self, system: &System, bearings: &mut [Bearing]) {
        for (rows, (_, across)) in system.friction.chunks_exact(2).zip(&self.along) {
            if matches!(bearings[rows[0]].part, Part::Stick(_)) {
                bearings[rows[1]].compliance = *across;
            }
        }
    }

    /// The mass matrix at the poses of the last update; here it measures ways, so what has no mass gets some.
    pub fn update_mass(&mut self, system: &System) {
        self.frame.mass.update(&system.tree, &self.frame.kinematics);
        for &dof in system.light.iter().flat_map(|light| &light.dofs) {
            self.frame.mass.values[self.frame.mass.row_start[dof + 1] - 1] = system.tree.inertia_scale[dof];
        }
    }

    /// Slope of a degree of freedom, beyond rounding, relative to the forces that meet there, or to its weight where
    /// they are less.
    pub fn imbalance(&self, dof: usize) -> f64 {
        let excess = (self.slope[dof].abs() - self.noise[dof]).max(0.0);
        excess / self.terms[dof].max(self.weight[dof]).max(f64::MIN_POSITIVE)
    }

    /// Largest imbalance of a free degree of freedom.
    pub fn residual(&self, system: &System) -> f64 {
        let free = (0..self.slope.len()).filter(|&dof| system.driven[dof].is_none());
        free.map(|dof| self.imbalance(dof)).fold(0.0, f64::max)
    }
}
