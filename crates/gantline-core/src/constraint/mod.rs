//! Rows g(q) over the coordinates of several bodies, with the law of the force that each row carries.
//!
//! The force of a row on the system is −Gᵀ T, G = ∂g/∂q, so T = −λ of paper eq. (15). Each kind is one
//! file that implements [`Constraint`]; [`AnyConstraint`] is the closed set.

pub mod contact;
pub mod rope;

use glam::DVec3;

use crate::tree::Tree;
use crate::tree::kinematics::Kinematics;
use contact::Contact;
use rope::Rope;

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
}

impl Law {
    /// ε [m/N].
    pub fn compliance(&self) -> f64 {
        match self {
            Self::Unilateral { compliance, .. } | Self::Friction { compliance, .. } => *compliance,
        }
    }

    /// τ [s].
    pub fn damping_time(&self) -> f64 {
        match self {
            Self::Unilateral { damping_time, .. } | Self::Friction { damping_time, .. } => *damping_time,
        }
    }
}

/// What a kind of constraint has to say.
pub trait Constraint {
    /// Name, for messages and recordings.
    fn name(&self) -> &str;

    /// Degrees of freedom of every row.
    fn row_dofs(&self) -> Vec<Vec<usize>>;

    /// Law of every row; `first_row` is the index of the first.
    fn laws(&self, first_row: usize) -> Vec<Law>;

    /// Values g and gradients ∂g/∂q of all rows, in the order of [`Constraint::row_dofs`]. `value` comes in
    /// with what the state remembers of the row (the deflection of a sticking contact) and is left where
    /// geometry does not determine it.
    fn evaluate(&self, tree: &Tree, kinematics: &Kinematics, value: &mut [f64], gradient: &mut [f64]);

    /// Groups of degrees of freedom that geometric stiffness couples.
    fn stiffness_groups(&self) -> Vec<Vec<usize>>;

    /// Geometric stiffness of one group under the forces `tension` of the rows: fills `columns` with one
    /// vector c per degree of freedom of the group and returns the factor f of K = f Σ cᵢ·cⱼ, which is
    /// positive semidefinite by construction.
    fn geometric_stiffness(
        &self,
        tree: &Tree,
        kinematics: &Kinematics,
        tension: &[f64],
        group: usize,
        columns: &mut [DVec3],
    ) -> f64;
}

/// Any constraint.
#[derive(Debug, Clone)]
pub enum AnyConstraint {
    /// A rope.
    Rope(Rope),
    /// A point that may touch a plane.
    Contact(Contact),
}

impl std::ops::Deref for AnyConstraint {
    type Target = dyn Constraint + Send + Sync;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Rope(rope) => rope,
            Self::Contact(contact) => contact,
        }
    }
}
