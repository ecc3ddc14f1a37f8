//! Forces on single bodies that depend on where the body is and how it moves: what water does to it, around it and in it,
//! and what wind does.
//!
//! A force is a wrench about the origin of its body. It says how the wrench changes with place, velocity and
//! acceleration *as seen from the body*: what turns along with the body does not change then. So matrices that are
//! given in the body's axes have no derivative over its orientation, and the tree adds the rest
//! ([`crate::tree::applied`]).
//!
//! To add a kind: one file that implements [`Force`], one variant of [`AnyForce`], one of [`crate::spec::ForceSpec`].

pub mod added_mass;
pub mod buoyancy;
pub mod drag;
pub mod square;
pub mod tank;

use glam::DVec3;

use crate::tree::Tree;
use crate::tree::bias::Wrench;
use crate::tree::kinematics::{Kinematics, Twist};
use crate::tree::pose::Pose;
use added_mass::AddedMass;
use buoyancy::Buoyancy;
use drag::Drag;
use square::Square;
use tank::Tank;

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
    /// What has been pumped into the force's tank since the start [kg]; 0 of all other forces.
    pub pumped: f64,
}

/// Where the content of a tank that is pumped stands among the coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Content {
    /// In q: what has been pumped in since the start [kg].
    pub position: usize,
    /// In v.
    pub dof: usize,
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

    /// Energy that it holds [J]; `pumped` as in [`At`].
    fn energy(&self, _pose: &Pose, _gravity: DVec3, _pumped: f64) -> f64 {
        0.0
    }

    /// Rate of that energy under the velocity of `at` [W].
    fn energy_rate(&self, _at: &At) -> f64 {
        0.0
    }

    /// Power that is lost in it [W].
    fn loss(&self, _at: &At) -> f64 {
        0.0
    }

    /// Power that a fluid which streams puts in [W].
    fn work(&self, _at: &At) -> f64 {
        0.0
    }

    /// Inertia that moves along with the body, about its origin; `pumped` as in [`At`].
    fn inertia(&self, _pose: &Pose, _pumped: f64) -> Option<Square> {
        None
    }

    /// The coordinate of its content, of a tank that is pumped.
    fn content(&self) -> Option<Content> {
        None
    }

    /// What a pump has to give to a kilogram that it adds to the content [J/kg].
    fn head(&self, _at: &At) -> f64 {
        0.0
    }

    /// What a kilogram that is added to the content does to the wrench.
    fn wrench_per_content(&self, _at: &At) -> Wrench {
        Wrench::default()
    }
}

/// Any force on a body.
#[derive(Debug, Clone)]
pub enum AnyForce {
    /// Pressure of still water on a hull.
    Buoyancy(Box<Buoyancy>),
    /// Water that is accelerated along.
    AddedMass(AddedMass),
    /// Resistance of water or air.
    Drag(Drag),
    /// A liquid in a tank.
    Tank(Box<Tank>),
}

impl std::ops::Deref for AnyForce {
    type Target = dyn Force + Send + Sync;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Buoyancy(buoyancy) => &**buoyancy,
            Self::AddedMass(added) => added,
            Self::Drag(drag) => drag,
            Self::Tank(tank) => &**tank,
        }
    }
}

/// Energy that all forces hold [J].
pub fn energy(tree: &Tree, kinematics: &Kinematics) -> f64 {
    let forces = tree.forces.iter().zip(&kinematics.pumped);
    forces.map(|(force, pumped)| force.energy(&kinematics.pose[force.body()], tree.gravity, *pumped)).sum()
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

/// True where wind or current blows on a body.
pub fn has_stream(tree: &Tree) -> bool {
    tree.forces.iter().any(|force| matches!(force, AnyForce::Drag(drag) if drag.stream != DVec3::ZERO))
}

/// Power that fluids which stream put into all bodies under the velocity coordinates `v` [W].
pub fn work(tree: &Tree, kinematics: &Kinematics, v: &[f64]) -> f64 {
    let at = |force: &AnyForce| {
        let (body, gravity) = (force.body(), tree.gravity);
        let twist = twist_of(tree, kinematics, body, v);
        force.work(&At { pose: &kinematics.pose[body], twist, rate: Twist::default(), gravity, pumped: 0.0 })
    };
    tree.forces.iter().map(at).sum()
}

/// Sets `out` to what fluids resist the velocity coordinates `v` with, along every degree of freedom; at rest that is the
/// opposite of what wind and current push with.
pub fn resistance(tree: &Tree, kinematics: &Kinematics, v: &[f64], out: &mut [f64]) {
    out.fill(0.0);
    for force in &tree.forces {
        let AnyForce::Drag(drag) = force else { continue };
        let (body, gravity) = (drag.body(), tree.gravity);
        let twist = twist_of(tree, kinematics, body, v);
        let still = Twist::default();
        let wrench =
            drag.wrench(&At { pose: &kinematics.pose[body], twist, rate: still, gravity, pumped: 0.0 });
        for &dof in &tree.support[body] {
            let linear = kinematics.point_column(tree, dof, kinematics.pose[body].position);
            out[dof] -= linear.dot(wrench.force) + kinematics.columns[dof].angular.dot(wrench.moment);
        }
    }
}
