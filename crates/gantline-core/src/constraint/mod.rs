//! Rows g(q) over the coordinates of several bodies, with the law of the force that each row carries.
//!
//! The force of a row on the system is −Gᵀ T, G = ∂g/∂q, so T = −λ of paper eq. (15). Each kind is one
//! file that implements [`Constraint`]; [`AnyConstraint`] is the closed set.

pub mod brake;
pub mod contact;
pub mod facing;
pub mod pin;
pub mod rope;
pub mod stop;
pub mod touch;

use glam::DVec3;

use crate::contact::spot::Spot;
use crate::rope::seat::Seat;
use crate::tree::Tree;
use crate::tree::bias::Wrench;
use crate::tree::kinematics::{Kinematics, Twist};
use brake::Brake;
use contact::Contact;
use pin::Pin;
use rope::Rope;
use stop::Stop;
use touch::Touch;

/// How a row answers its value e = g.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Law {
    /// T = max(0, (e + τ ė)/ε); ε = 0: e ≤ 0 ⟂ T ≥ 0.
    Unilateral {
        /// ε [m/N].
        compliance: f64,
        /// τ [s].
        damping_time: f64,
    },
    /// T = (e + τ ė)/ε either way.
    Spring {
        /// ε [m/N or rad/(N m)].
        compliance: f64,
        /// τ [s].
        damping_time: f64,
    },
    /// One of two tangential directions of a contact: T = (s + τ ṡ)/ε while |T| ≤ μ N, then slip.
    Friction {
        /// ε [m/N].
        compliance: f64,
        /// τ [s].
        damping_time: f64,
        /// μ.
        coefficient: f64,
        /// Row of the normal force; the two tangential rows follow it.
        normal: usize,
    },
    /// A flow or joint that is held by a bounded force, and slips against that.
    Brake {
        /// Rows of the spans whose tensions the bound depends on.
        rows: [Option<usize>; 2],
        /// What a velocity does to the forces that act on it [N s/m or N m s/rad].
        impedance: f64,
    },
    /// A joint that is held where it is, while the row acts.
    Pin,
}

/// Damping time of a tangential spring [s], at least: with none at all the anchor of a sliding point would have to
/// follow at once.
const LEAST_DAMPING: f64 = 1e-5;

impl Law {
    /// The three laws of a place that touches: across, and two along, whose bound follows the first row's force.
    pub fn of_contact(compliance: f64, damping_time: f64, coefficient: f64, first_row: usize) -> Vec<Self> {
        let along = damping_time.max(LEAST_DAMPING);
        let friction = Self::Friction { compliance, damping_time: along, coefficient, normal: first_row };
        vec![Self::Unilateral { compliance, damping_time }, friction, friction]
    }

    /// ε [m/N].
    pub fn compliance(&self) -> f64 {
        match self {
            Self::Unilateral { compliance, .. }
            | Self::Spring { compliance, .. }
            | Self::Friction { compliance, .. } => *compliance,
            Self::Brake { .. } | Self::Pin => 0.0,
        }
    }

    /// Rows whose forces the bound of this one depends on.
    pub fn bounded_by(&self) -> impl Iterator<Item = usize> + use<> {
        let (first, second) = match *self {
            Self::Unilateral { .. } | Self::Spring { .. } | Self::Pin => (None, None),
            Self::Friction { normal, .. } => (Some(normal), None),
            Self::Brake { rows: [one, other], .. } => (one, other),
        };
        first.into_iter().chain(second)
    }

    /// τ [s].
    pub fn damping_time(&self) -> f64 {
        match self {
            Self::Unilateral { damping_time, .. }
            | Self::Spring { damping_time, .. }
            | Self::Friction { damping_time, .. } => *damping_time,
            Self::Brake { .. } | Self::Pin => 0.0,
        }
    }

    /// What of its value e stretches its spring [m or rad]: one that only pulls or pushes is slack below zero.
    pub fn stretch(&self, e: f64) -> f64 {
        if matches!(self, Self::Unilateral { .. }) { e.max(0.0) } else { e }
    }
}

/// A line along which two bodies, or a body and the world, act on each other.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Line {
    /// From the origin of the first body to its point [m], world axes.
    pub from: DVec3,
    /// From the origin of the second body to its point [m].
    pub to: DVec3,
    /// Along which the two points pull on each other: the unit vector from the first to the second, for parts of a
    /// rope on sheaves e of [`crate::rope::tangency`]; not used where the direction is known.
    pub direction: DVec3,
    /// Couples on the two bodies per unit of force [m]; zero but for parts of a rope on sheaves.
    pub couple: [DVec3; 2],
    /// ∂g/∂L of the span of a rope that starts with this line, where rope is fed into it; of a row on a joint whose gradient
    /// changes ∂g/∂q, which [`Constraint::rates`] and [`Constraint::feed`] have from nowhere else; else 0.
    pub supply: f64,
}

/// Where everything is.
#[derive(Clone, Copy)]
pub struct Placed<'a> {
    /// The tree.
    pub tree: &'a Tree,
    /// Its poses.
    pub kinematics: &'a Kinematics,
    /// Its configuration.
    pub q: &'a [f64],
    /// How ropes lie on their sheaves.
    pub seats: &'a [Seat],
    /// Where bodies may touch.
    pub spots: &'a [Spot],
    /// Unstretched rope that coils on drums let go per velocity of their flows; not used for values and gradients.
    pub feeding: &'a [f64],
}

/// Where everything is and how it moves.
#[derive(Clone, Copy)]
pub struct Moving<'a> {
    /// Poses of the bodies.
    pub kinematics: &'a Kinematics,
    /// Their velocities.
    pub twists: &'a [Twist],
    /// Configuration.
    pub q: &'a [f64],
    /// Velocity coordinates.
    pub v: &'a [f64],
    /// How ropes lie on their sheaves.
    pub seats: &'a [Seat],
    /// Where bodies may touch.
    pub spots: &'a [Spot],
}

/// What a kind of constraint has to say.
pub trait Constraint {
    /// Name, for messages and recordings.
    fn name(&self) -> &str;

    /// Degrees of freedom of every row.
    fn row_dofs(&self) -> Vec<Vec<usize>>;

    /// Law of every row; `first_row` is the index of the first.
    fn laws(&self, first_row: usize) -> Vec<Law>;

    /// How many lines of force it has.
    fn lines(&self) -> usize;

    /// Values g and rates ġ of all rows under the velocities of the bodies, and where their forces act: without
    /// gradients. The forces at a point of a step need no more, however deep the tree is. `value` as in
    /// [`Constraint::evaluate`].
    fn locate(&self, at: &Moving, value: &mut [f64], rate: &mut [f64], lines: &mut [Line]);

    /// Rates ġ under other velocities of the bodies and increments `v` of the coordinates per time, with the lines as
    /// they were located.
    fn rates(&self, twists: &[Twist], v: &[f64], lines: &[Line], rate: &mut [f64]);

    /// Takes the forces T of the rows from what the joints of the bodies have to transmit (about their origins).
    fn apply(&self, tension: &[f64], lines: &[Line], wrenches: &mut [Wrench]);

    /// Adds to `force` what the forces T of the rows do to degrees of freedom by themselves, not through bodies:
    /// Σ T ∂g/∂s.
    fn feed(&self, _tension: &[f64], _lines: &[Line], _force: &mut [f64]) {}

    /// Values g and gradients ∂g/∂q of all rows, in the order of [`Constraint::row_dofs`]. `value` comes in
    /// with what the state remembers of the row (where the anchor of a sticking contact is).
    fn evaluate(&self, at: &Placed, value: &mut [f64], gradient: &mut [f64]);

    /// Groups of degrees of freedom whose motion turns the gradient, each with the row (0 is the first of
    /// this constraint) that it belongs to.
    fn curvature_groups(&self) -> Vec<(usize, Vec<usize>)>;

    /// Derivative of the gradient within one group, ∂G_j/∂q_k at `block[j · size + k]`, for increments as
    /// in [`Tree::advance`]. Its product with T is the exact geometric stiffness, with v the part of ∂ė/∂q.
    /// `value` is g of the group's row, `columns` work space for one vector per degree of freedom.
    fn curvature(&self, at: &Placed, value: f64, group: usize, columns: &mut [DVec3], block: &mut [f64]);
}

/// Any constraint.
#[derive(Debug, Clone)]
pub enum AnyConstraint {
    /// A rope.
    Rope(Rope),
    /// A point that may touch a plane.
    Contact(Contact),
    /// A place at which two bodies may touch.
    Touch(Touch),
    /// An end of the stroke of a joint.
    Stop(Stop),
    /// A locking pin of a joint.
    Pin(Pin),
    /// Friction on a flow.
    Brake(Brake),
}

impl std::ops::Deref for AnyConstraint {
    type Target = dyn Constraint + Send + Sync;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Rope(rope) => rope,
            Self::Contact(contact) => contact,
            Self::Touch(touch) => touch,
            Self::Stop(stop) => stop,
            Self::Pin(pin) => pin,
            Self::Brake(brake) => brake,
        }
    }
}
