//! Energy by kind, and what is left over.
//!
//! ```text
//! kinetic + gravity + elastic + fluid − (at the start) = drive work + fluid work − losses + remainder
//! ```
//!
//! Every loss is computed by its own formula, the method's dissipation too; only the remainder is a
//! difference, and it measures what the method got wrong.

use serde::{Deserialize, Serialize};

use crate::constraint::Law;
use crate::force::{self, AnyForce};
use crate::solver::complementarity::Mode;
use crate::system::{DriveJoint, System};
use crate::tree::kinematics::Kinematics;

/// Names of the energy kinds, in the order of [`Ledger::values`].
pub const KINDS: [&str; 16] = [
    "kinetic",
    "gravity",
    "elastic",
    "fluid",
    "drive_work",
    "fluid_work",
    "rope_damping",
    "joint_damping",
    "contact_damping",
    "drag",
    "friction",
    "impact",
    "parting",
    "adjusting",
    "method",
    "remainder",
];

/// Rounding of the energies of weight and water, relative to them.
const ROUNDING: f64 = 1e-12;
/// What all weight does along this share of a metre and of its height is the least energy that a remainder is held against:
/// what stands on joints and rigid ropes has no other than the rounding of its places, a ten-millionth of that.
const STILL: f64 = 1e-9;

/// Energies that flowed [J].
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Flows {
    /// Work of the drives on the system.
    pub drive_work: f64,
    /// Work of wind, current and waves on the system, through drives that waves move too, and of what runs through holes.
    #[serde(default)]
    pub fluid_work: f64,
    /// Lost in rope dampers.
    pub rope_damping: f64,
    /// Lost in joint dampers.
    pub joint_damping: f64,
    /// Lost in contact dampers.
    pub contact_damping: f64,
    /// Lost to water and air.
    #[serde(default)]
    pub drag: f64,
    /// Lost in sliding contacts.
    pub friction: f64,
    /// Lost where inextensible ropes went taut.
    pub impact: f64,
    /// Lost with ropes that parted: what they held.
    pub parting: f64,
    /// Taken from ropes whose lengths were adjusted.
    pub adjusting: f64,
    /// Lost by the method itself.
    pub method: f64,
}

impl Flows {
    /// Where the work of a drive is booked: as that of the fluid that moves it, or its own.
    pub fn work_of(&mut self, drive: &DriveJoint) -> &mut f64 {
        if drive.by_fluid { &mut self.fluid_work } else { &mut self.drive_work }
    }

    /// What drives, wind, current, waves and what runs through holes put in [J].
    pub fn put_in(&self) -> f64 {
        self.drive_work + self.fluid_work
    }
}

impl std::ops::AddAssign for Flows {
    fn add_assign(&mut self, other: Self) {
        self.drive_work += other.drive_work;
        self.fluid_work += other.fluid_work;
        self.rope_damping += other.rope_damping;
        self.joint_damping += other.joint_damping;
        self.contact_damping += other.contact_damping;
        self.drag += other.drag;
        self.friction += other.friction;
        self.impact += other.impact;
        self.parting += other.parting;
        self.adjusting += other.adjusting;
        self.method += other.method;
    }
}

impl std::ops::Sub for Flows {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self {
            drive_work: self.drive_work - other.drive_work,
            fluid_work: self.fluid_work - other.fluid_work,
            rope_damping: self.rope_damping - other.rope_damping,
            joint_damping: self.joint_damping - other.joint_damping,
            contact_damping: self.contact_damping - other.contact_damping,
            drag: self.drag - other.drag,
            friction: self.friction - other.friction,
            impact: self.impact - other.impact,
            parting: self.parting - other.parting,
            adjusting: self.adjusting - other.adjusting,
            method: self.method - other.method,
        }
    }
}

/// Stored energies [J].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Stored {
    /// ½ vᵀ M v.
    pub kinetic: f64,
    /// −Σ m g·c.
    pub gravity: f64,
    /// Σ ½ k max(e, 0)² of ropes and contacts, and what mooring lines hold.
    pub elastic: f64,
    /// What pressed the water away.
    pub fluid: f64,
}

impl Stored {
    /// All together [J].
    pub fn sum(&self) -> f64 {
        self.kinetic + self.gravity + self.elastic + self.fluid
    }
}

/// Stored energies now and flows since the start [J].
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Ledger {
    /// ½ vᵀ M v.
    pub kinetic: f64,
    /// −Σ m g·c.
    pub gravity: f64,
    /// Σ ½ k max(e, 0)² of ropes and contacts, and what mooring lines hold.
    pub elastic: f64,
    /// What pressed the water away.
    #[serde(default)]
    pub fluid: f64,
    /// What rope on drums holds more than at the start.
    #[serde(default)]
    pub wound: f64,
    /// What flowed.
    pub flows: Flows,
    /// Stored energy at the start.
    start: f64,
    /// Gravity at the start.
    gravity_start: f64,
    /// What pressed the water away at the start.
    #[serde(default)]
    fluid_start: f64,
    /// Largest of kinetic + elastic + |drive work| + |fluid work| so far, and no less than [`STILL`] says.
    scale: f64,
    /// Largest |remainder| so far.
    worst: f64,
    /// The most that the method has taken away on balance so far.
    #[serde(default)]
    most_taken: f64,
}

impl Ledger {
    /// Notes the stored energies of the start of a system.
    pub fn open(system: &System, stored: Stored) -> Self {
        let mass: f64 = system.tree.bodies.iter().map(|body| body.mass).sum();
        let Stored { kinetic, gravity, elastic, fluid } = stored;
        let least = STILL * (mass * system.tree.gravity.length() + gravity.abs());
        Self {
            kinetic,
            gravity,
            elastic,
            fluid,
            start: stored.sum(),
            gravity_start: gravity,
            fluid_start: fluid,
            scale: (kinetic + elastic).max(least),
            ..Self::default()
        }
    }

    /// Notes the stored energies after a step whose flows have been added.
    pub fn store(&mut self, Stored { kinetic, gravity, elastic, fluid }: Stored) {
        (self.kinetic, self.gravity, self.elastic, self.fluid) = (kinetic, gravity, elastic, fluid);
        let work = self.flows.drive_work.abs() + self.flows.fluid_work.abs();
        self.scale = self.scale.max(kinetic + elastic + self.wound + work);
        // Weight and water that bear each other are large beside what moves: their rounding is no gap of the books.
        let rounding = if fluid == 0.0 { 0.0 } else { ROUNDING * (gravity.abs() + fluid.abs()) };
        self.worst = self.worst.max(self.remainder().abs() - rounding);
        self.most_taken = self.most_taken.max(self.flows.method);
    }

    /// What the balance does not explain [J].
    pub fn remainder(&self) -> f64 {
        let stored = self.kinetic + self.gravity + self.elastic + self.fluid + self.wound - self.start;
        let lost = self.flows.rope_damping
            + self.flows.joint_damping
            + self.flows.contact_damping
            + self.flows.drag
            + self.flows.friction
            + self.flows.impact
            + self.flows.parting
            + self.flows.adjusting
            + self.flows.method;
        stored - self.flows.drive_work - self.flows.fluid_work + lost
    }

    /// What the balance explains less than at `before`, relative to the largest energy so far.
    pub fn gap_since(&self, before: &Self) -> f64 {
        let gap = (self.remainder() - before.remainder()).abs();
        if self.scale > 0.0 { gap / self.scale } else { 0.0 }
    }

    /// Takes flows since `before` for others, known better.
    pub fn correct(&mut self, before: &Self, (known, better): (Flows, Flows)) {
        self.flows += better - known;
        (self.scale, self.worst, self.most_taken) = (before.scale, before.worst, before.most_taken);
        let Self { kinetic, gravity, elastic, fluid, .. } = *self;
        self.store(Stored { kinetic, gravity, elastic, fluid });
    }

    /// Largest |remainder| relative to the largest of kinetic + elastic + |drive work| + |fluid work|, of a system that stands
    /// to what its weight does along some nanometres.
    pub fn relative_remainder(&self) -> f64 {
        if self.scale > 0.0 { self.worst / self.scale } else { 0.0 }
    }

    /// What the method has put in beyond what it had taken away before, relative to the same.
    pub fn share_of_method(&self) -> f64 {
        if self.scale > 0.0 { (self.most_taken - self.flows.method) / self.scale } else { 0.0 }
    }

    /// Energies in the order of [`KINDS`]; gravity relative to the start [J].
    pub fn values(&self) -> [f64; KINDS.len()] {
        [
            self.kinetic,
            self.gravity - self.gravity_start,
            self.elastic + self.wound,
            self.fluid - self.fluid_start,
            self.flows.drive_work,
            self.flows.fluid_work,
            self.flows.rope_damping,
            self.flows.joint_damping,
            self.flows.contact_damping,
            self.flows.drag,
            self.flows.friction,
            self.flows.impact,
            self.flows.parting,
            self.flows.adjusting,
            self.flows.method,
            self.remainder(),
        ]
    }
}

/// Numbers in [`KINDS`] of those that a system has: without water or air, and where nothing of it streams, theirs are left out.
pub fn kinds_of(system: &System) -> Vec<usize> {
    let has_fluid = system.tree.forces.iter().any(|force| !matches!(force, AnyForce::Mooring(_)));
    let streams = force::has_stream(&system.tree)
        || force::has_waves(&system.tree)
        || system.drives.iter().any(|drive| drive.by_fluid)
        || force::submerged(&system.tree).any(|load| !load.sea.components.is_empty());
    let is_there = |kind: &usize| match KINDS[*kind] {
        "fluid" | "drag" => has_fluid,
        "fluid_work" => streams,
        _ => true,
    };
    (0..KINDS.len()).filter(is_there).collect()
}

/// −Σ m g·c [J].
pub fn gravity_energy(system: &System, kinematics: &Kinematics) -> f64 {
    let bodies = system.tree.bodies.iter().zip(&kinematics.centre_of_gravity);
    -bodies.map(|(body, centre)| body.mass * system.tree.gravity.dot(*centre)).sum::<f64>()
}

/// Energy in the spring of a row at the value e [J].
pub fn spring_energy(law: &Law, e: f64) -> f64 {
    let compliance = law.compliance();
    let stretch = law.stretch(e);
    if compliance > 0.0 { 0.5 * stretch * stretch / compliance } else { 0.0 }
}

/// Σ spring energies of all rows at the values `value` [J]; tangential springs of open contacts and ropes that have
/// parted or are not on hold nothing.
pub fn elastic_energy(system: &System, value: &[f64], modes: &[Mode]) -> f64 {
    let laws = system.rows.laws.iter().zip(modes).zip(value);
    let held = laws.filter(|((law, mode), _)| {
        let is_open = matches!(law, Law::Friction { .. }) && **mode == Mode::Slack;
        !(mode.is_absent() || is_open)
    });
    held.map(|((law, _), value)| spring_energy(law, *value)).sum()
}
