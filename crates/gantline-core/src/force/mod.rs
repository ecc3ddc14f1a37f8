//! Forces on single bodies that depend on where the body is and how it moves, and on time: what water does to it, around it
//! and in it, and what wind and mooring lines do.
//!
//! A force is a wrench about the origin of its body. It says how the wrench changes with place, velocity and
//! acceleration *as seen from the body*: what turns along with the body does not change then. So matrices that are
//! given in the body's axes have no derivative over its orientation, and the tree adds the rest
//! ([`crate::tree::applied`]).
//!
//! To add a kind: one file that implements [`Force`], one variant of [`AnyForce`], one of [`crate::spec::ForceSpec`].

pub mod added_mass;
pub mod axes;
pub mod buoyancy;
mod cell;
pub mod damping;
pub mod drag;
pub mod lattice;
pub mod level_mass;
pub mod mean_drift;
pub mod memory;
pub mod mooring;
pub mod orbital;
pub mod profile;
pub mod slow;
pub mod square;
pub mod submerged;
pub mod tank;
pub mod trains;
pub mod wave;

use std::sync::Arc;

use glam::DVec3;

use crate::tree::Tree;
use crate::tree::bias::{NewtonEuler, Wrench};
use crate::tree::kinematics::{Kinematics, Twist};
use crate::tree::pose::Pose;
use added_mass::AddedMass;
use buoyancy::Buoyancy;
use damping::Damping;
use drag::Drag;
use level_mass::LevelMass;
use mean_drift::MeanDrift;
use memory::{Memory, memories};
use mooring::Mooring;
use square::{Square, skew};
use submerged::Submerged;
use tank::Tank;
use wave::WaveForce;

/// Where a body is and how it moves, world axes.
#[derive(Debug, Clone, Copy)]
pub struct At<'a> {
    /// Its pose.
    pub pose: &'a Pose,
    /// Its velocity.
    pub twist: Twist,
    /// Its acceleration.
    pub rate: Twist,
    /// Acceleration of gravity [m/s²].
    pub gravity: DVec3,
    /// Time [s].
    pub time: f64,
    /// Configuration of the tree.
    pub q: &'a [f64],
    /// Its velocity coordinates.
    pub v: &'a [f64],
    /// What forces remember of the motion so far, see [`memory`] and [`slow`].
    pub past: &'a [f64],
}

/// Derivatives of a wrench, seen from the body: force and moment over linear and angular motion, world axes.
#[derive(Debug, Clone, Copy)]
pub struct Tangent {
    /// Over a displacement [m] and a turn [rad] of the body.
    pub place: Square,
    /// Over its velocity.
    pub velocity: Square,
    /// Over its acceleration.
    pub acceleration: Square,
}

impl Tangent {
    /// No change with anything.
    pub const NONE: Self = Self { place: Square::ZERO, velocity: Square::ZERO, acceleration: Square::ZERO };

    /// Of a force and moment that act at `arm` [m] from the body's origin and do not turn along: seen from the body a turn
    /// δθ changes them by F × δθ.
    fn of_what_stays(force: DVec3, moment: DVec3, arm: DVec3) -> Self {
        let cross = skew(force);
        let angular = skew(moment) + skew(arm) * cross;
        Self { place: Square { cross, angular, ..Square::ZERO }, ..Self::NONE }
    }
}

/// Derivatives of a force that depends on a flow and acts on it. Pairs are over place and over velocity.
#[derive(Debug, Clone, Copy)]
pub struct Feeding {
    /// Of the wrench on the body over the flow.
    pub wrench: [Wrench; 2],
    /// Of the force on the flow over displacement and turn of the body, as seen from there.
    pub body: [Wrench; 2],
    /// Of the force on the flow over the flow.
    pub flow: [f64; 2],
}

/// What a kind of force has to say.
pub trait Force {
    /// Name, for messages.
    fn name(&self) -> &str;

    /// Index of the body that it acts on.
    fn body(&self) -> usize;

    /// The wrench on the body about its origin.
    fn wrench(&self, at: &At) -> Wrench;

    /// Its derivatives.
    fn tangent(&self, at: &At) -> Tangent;

    /// Energy that it holds at the configuration `q` [J].
    fn energy(&self, _pose: &Pose, _gravity: DVec3, _q: &[f64]) -> f64 {
        0.0
    }

    /// Rate of that energy under the velocity of `at` [W].
    fn energy_rate(&self, _at: &At) -> f64 {
        0.0
    }

    /// Derivative of the wrench over time alone; none where it does not know time.
    fn over_time(&self, _at: &At) -> Option<Wrench> {
        None
    }

    /// Power that is lost in it [W].
    fn loss(&self, _at: &At) -> f64 {
        0.0
    }

    /// Power that a fluid which streams, or waves, put in [W].
    fn work(&self, _at: &At) -> f64 {
        0.0
    }

    /// Both, for one whose looks at the water are dear.
    fn powers(&self, at: &At) -> [f64; 2] {
        [self.loss(at), self.work(at)]
    }

    /// Degree of freedom of a flow that it depends on as well and acts on: line that a winch has paid out [m], or what
    /// has been pumped into a tank [kg]. The flow hangs on the body.
    fn flow(&self) -> Option<usize> {
        None
    }

    /// Force on that flow [N, of a tank J/kg].
    fn feed(&self, _at: &At) -> f64 {
        0.0
    }

    /// Wrench and force on the flow, for one to which both are one.
    fn push(&self, at: &At) -> (Wrench, f64) {
        (self.wrench(at), self.feed(at))
    }

    /// Derivatives that the flow adds.
    fn feeding(&self, _at: &At) -> Option<Feeding> {
        None
    }

    /// Inertia that moves along with the body, about its origin, where `kinematics` is.
    fn inertia(&self, _kinematics: &Kinematics) -> Option<Square> {
        None
    }
}

/// Any force on a body.
#[derive(Debug, Clone)]
pub enum AnyForce {
    /// Pressure of still water on a hull.
    Buoyancy(Box<Buoyancy>),
    /// Water that is accelerated along.
    AddedMass(AddedMass),
    /// The same of a body that waves push.
    LevelMass(LevelMass),
    /// Resistance of water or air.
    Drag(Drag),
    /// The same of water by a matrix, of a body that waves push.
    Damping(Damping),
    /// Waves that the body has made.
    Memory(Memory),
    /// A liquid in a tank.
    Tank(Box<Tank>),
    /// A mooring line.
    Mooring(Box<Mooring>),
    /// Waves.
    Wave(WaveForce),
    /// What these push with on the whole.
    MeanDrift(MeanDrift),
    /// Water around a load.
    Submerged(Box<Submerged>),
}

impl std::ops::Deref for AnyForce {
    type Target = dyn Force + Send + Sync;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Buoyancy(buoyancy) => &**buoyancy,
            Self::AddedMass(added) => added,
            Self::LevelMass(added) => added,
            Self::Drag(drag) => drag,
            Self::Damping(damping) => damping,
            Self::Memory(memory) => memory,
            Self::Tank(tank) => &**tank,
            Self::Mooring(mooring) => &**mooring,
            Self::Wave(wave) => wave,
            Self::MeanDrift(drift) => drift,
            Self::Submerged(load) => &**load,
        }
    }
}

/// Energy that water and lines hold [J].
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Energies {
    /// What pressed the water away, and what is in tanks.
    pub fluid: f64,
    /// Mooring lines.
    pub lines: f64,
}

/// Energy that all forces hold [J].
pub fn energy(tree: &Tree, kinematics: &Kinematics) -> Energies {
    let mut held = Energies::default();
    for force in &tree.forces {
        let energy = force.energy(&kinematics.pose[force.body()], tree.gravity, &kinematics.q);
        let kind = if matches!(force, AnyForce::Mooring(_)) { &mut held.lines } else { &mut held.fluid };
        *kind += energy;
    }
    held
}

/// Velocity of a body under the velocity coordinates `v`.
pub fn twist_of(tree: &Tree, kinematics: &Kinematics, body: usize, v: &[f64]) -> Twist {
    let mut twist = Twist::default();
    for &dof in &tree.support[body] {
        twist.linear += kinematics.point_column(tree, dof, kinematics.pose[body].position) * v[dof];
        twist.angular += kinematics.columns[dof].angular * v[dof];
    }
    twist
}

/// Where the body of a force is, and how it moves under the velocity coordinates `v`; not accelerated.
pub fn under<'a>(tree: &Tree, kinematics: &'a Kinematics, body: usize, v: &'a [f64]) -> At<'a> {
    let (twist, rate) = (twist_of(tree, kinematics, body, v), Twist::default());
    let Kinematics { pose, q, time, past, .. } = kinematics;
    At { pose: &pose[body], twist, rate, gravity: tree.gravity, time: *time, q, v, past }
}

/// How many numbers forces remember.
pub fn states(tree: &Tree) -> usize {
    let slow: usize = waves(tree).map(|wave| wave.slow.states().len()).sum();
    memory::states(tree) + slow
}

/// Forgets all that was: sets `past` to that of bodies that have always moved as they do with the velocity coordinates `v`
/// where `kinematics` is, in water that knows nothing of it yet.
pub fn begin(tree: &Tree, kinematics: &Kinematics, (v, time): (&[f64], f64), past: &mut [f64]) {
    past.fill(0.0);
    for wave in waves(tree) {
        let twist = twist_of(tree, kinematics, wave.body, v);
        wave.slow.start((&kinematics.pose[wave.body], &twist), time, past);
    }
}

/// Takes slow places and headings on to the end of a step at `time` [s], where `kinematics` is, with the velocity
/// coordinates `v` there.
pub fn follow(tree: &Tree, kinematics: &mut Kinematics, (v, time): (&[f64], f64), past: &mut [f64]) {
    for wave in waves(tree) {
        let twist = twist_of(tree, kinematics, wave.body, v);
        wave.slow.follow((&kinematics.pose[wave.body], &twist), time, past);
    }
    kinematics.past.copy_from_slice(past);
}

/// Lets loads be in still water, as statics has it at any time.
pub fn calm(tree: &mut Tree) {
    for force in &mut tree.forces {
        if let AnyForce::Submerged(load) = force {
            load.sea = Arc::default();
        }
    }
}

/// True where wind, current or, on the whole, waves push a body that has not moved yet.
pub fn has_stream(tree: &Tree) -> bool {
    drags(tree).any(|drag| drag.stream != DVec3::ZERO)
        || submerged(tree).any(|load| load.stream != DVec3::ZERO)
        || tree.forces.iter().any(|force| matches!(force, AnyForce::MeanDrift(drift) if drift.settled))
}

/// True where waves do something to a body.
pub fn has_waves(tree: &Tree) -> bool {
    waves(tree).next().is_some()
}

/// True where a force changes by itself as time goes on.
pub fn knows_time(tree: &Tree) -> bool {
    has_waves(tree)
        || drags(tree).any(|drag| drag.gusts.is_some())
        || submerged(tree).any(|load| !load.sea.components.is_empty())
}

/// Power that fluids which stream put into all bodies under the velocity coordinates `v` [W].
pub fn stream_work(tree: &Tree, kinematics: &Kinematics, v: &[f64]) -> f64 {
    drags(tree).map(|drag| drag.work(&under(tree, kinematics, drag.body, v))).sum()
}

/// The same of added mass along axes that turn by themselves, see [`level_mass`], and of what becomes more as it gets wet.
pub fn turning_work(tree: &Tree, kinematics: &Kinematics, v: &[f64]) -> f64 {
    let levels = tree.forces.iter().filter(|force| matches!(force, AnyForce::LevelMass(_)));
    let turned: f64 = levels.map(|level| level.work(&under(tree, kinematics, level.body(), v))).sum();
    turned + submerged(tree).map(|load| load.gathered(&under(tree, kinematics, load.body, v))).sum::<f64>()
}

/// What waves and current put into loads in the water, beside [`turning_work`] [W].
pub fn submerged_work(tree: &Tree, kinematics: &Kinematics, v: &[f64]) -> f64 {
    submerged(tree).map(|load| load.pushed(&under(tree, kinematics, load.body, v))).sum()
}

/// The same of waves, whose forces are those under the velocity coordinates `felt`.
pub fn wave_work(tree: &Tree, kinematics: &Kinematics, [felt, v]: [&[f64]; 2]) -> f64 {
    let power = |pushed: &AnyForce| {
        let wrench = pushed.wrench(&under(tree, kinematics, pushed.body(), felt));
        wrench.power(&twist_of(tree, kinematics, pushed.body(), v))
    };
    of_waves(tree).map(power).sum()
}

/// Sets `out` to what fluids resist the velocity coordinates `v` with, along every degree of freedom; at rest that is the
/// opposite of what wind, current and waves push with, and waves that bodies have made.
pub fn resistance(tree: &Tree, kinematics: &Kinematics, v: &[f64], out: &mut [f64]) {
    out.fill(0.0);
    for drag in drags(tree) {
        take(tree, kinematics, drag.body, drag.wrench(&under(tree, kinematics, drag.body, v)), out);
    }
    for damping in dampings(tree) {
        let body = damping.body();
        take(tree, kinematics, body, damping.wrench(&under(tree, kinematics, body, v)), out);
    }
    for force in of_waves(tree) {
        let body = force.body();
        take(tree, kinematics, body, force.wrench(&under(tree, kinematics, body, v)), out);
    }
    for load in submerged(tree) {
        take(tree, kinematics, load.body, load.resisting(&under(tree, kinematics, load.body, v)), out);
    }
    for memory in memories(tree) {
        take(tree, kinematics, memory.body, memory.wrench(&under(tree, kinematics, memory.body, v)), out);
    }
}

/// Sets `out` to the derivative over time alone of what the motion needs along every degree of freedom: the opposite of
/// how the push of waves and gusts changes, in the motion of the last update of `dynamics`.
pub fn over_time(tree: &Tree, kinematics: &Kinematics, dynamics: &NewtonEuler, out: &mut [f64]) {
    out.fill(0.0);
    for force in &tree.forces {
        let body = force.body();
        if let Some(wrench) = force.over_time(&dynamics.at(tree, kinematics, body)) {
            take(tree, kinematics, body, wrench, out);
        }
    }
}

/// Sets `out` to what the dampers of mooring lines resist with.
pub fn line_damping(tree: &Tree, kinematics: &Kinematics, v: &[f64], out: &mut [f64]) {
    out.fill(0.0);
    for mooring in moorings(tree) {
        let body = mooring.body();
        let (wrench, feed) = mooring.damping(&under(tree, kinematics, body, v));
        take(tree, kinematics, body, wrench, out);
        if let Some(dof) = mooring.flow() {
            out[dof] -= feed;
        }
    }
}

/// Takes a wrench on a body from what is along every degree of freedom.
fn take(tree: &Tree, kinematics: &Kinematics, body: usize, wrench: Wrench, out: &mut [f64]) {
    for &dof in &tree.support[body] {
        let linear = kinematics.point_column(tree, dof, kinematics.pose[body].position);
        out[dof] -= linear.dot(wrench.force) + kinematics.columns[dof].angular.dot(wrench.moment);
    }
}

fn drags(tree: &Tree) -> impl Iterator<Item = &Drag> {
    tree.forces.iter().filter_map(|force| if let AnyForce::Drag(drag) = force { Some(drag) } else { None })
}

fn dampings(tree: &Tree) -> impl Iterator<Item = &Damping> {
    tree.forces
        .iter()
        .filter_map(|force| if let AnyForce::Damping(damping) = force { Some(damping) } else { None })
}

/// Loads in water among the forces.
pub fn submerged(tree: &Tree) -> impl Iterator<Item = &Submerged> {
    tree.forces
        .iter()
        .filter_map(|force| if let AnyForce::Submerged(load) = force { Some(&**load) } else { None })
}

/// What waves push with, as they come by and on the whole.
fn of_waves(tree: &Tree) -> impl Iterator<Item = &AnyForce> {
    tree.forces.iter().filter(|force| matches!(force, AnyForce::Wave(_) | AnyForce::MeanDrift(_)))
}

fn waves(tree: &Tree) -> impl Iterator<Item = &WaveForce> {
    tree.forces.iter().filter_map(|force| if let AnyForce::Wave(wave) = force { Some(wave) } else { None })
}

/// Mooring lines among the forces.
pub fn moorings(tree: &Tree) -> impl Iterator<Item = &Mooring> {
    tree.forces.iter().filter_map(|force| match force {
        AnyForce::Mooring(mooring) => Some(&**mooring),
        _ => None,
    })
}
