//! A point of a body against a plane of the world or of another body: one normal row and two tangential rows
//! ([`super::facing`]).
//!
//! Normal: e = depth, T = N = max(0, k (e + τ ė)), the law of ropes. Tangential: a spring of the same
//! stiffness between the point and an anchor on the plane (Cundall and Strack 1979), e = s, the distance
//! along the tangent from the anchor, whose coordinate the state remembers. While |T| ≤ μN it sticks: no creep, and corners that are
//! redundant share by their stiffness. Where the bound is reached the anchor slides along so that it holds.

use glam::DVec3;

use super::facing::Facing;
use super::{Constraint, Law, Line, Moving, Placed};
use crate::contact::spot::Spot;
use crate::tree::bias::Wrench;
use crate::tree::kinematics::{Kinematics, Twist};

/// A point that may touch a plane.
#[derive(Debug, Clone)]
pub struct Contact {
    /// Unique name.
    pub name: String,
    /// Index of the group whose forces are added up.
    pub group: usize,
    /// The body with the point, and that with the plane.
    pub facing: Facing,
    /// Point and plane in the frames of their bodies, which no step changes.
    pub spot: Spot,
    /// 1/k [m/N].
    pub compliance: f64,
    /// τ [s].
    pub damping_time: f64,
    /// μ.
    pub friction: f64,
}

impl Contact {
    /// Tangents of the plane where its body is, world axes.
    pub fn tangents(&self, kinematics: &Kinematics) -> [DVec3; 2] {
        let turn = kinematics.pose_of(self.facing.bodies[1]).rotation;
        self.spot.plane.tangents.map(|tangent| turn * tangent)
    }
}

impl Constraint for Contact {
    fn name(&self) -> &str {
        &self.name
    }

    fn row_dofs(&self) -> Vec<Vec<usize>> {
        vec![self.facing.dofs.clone(); 3]
    }

    fn laws(&self, first_row: usize) -> Vec<Law> {
        Law::of_contact(self.compliance, self.damping_time, self.friction, first_row)
    }

    /// One for each row, with the direction in which it pushes the body with the point.
    fn lines(&self) -> usize {
        3
    }

    fn locate(&self, at: &Moving, value: &mut [f64], rate: &mut [f64], lines: &mut [Line]) {
        self.facing.locate(at, &self.spot, value, rate, lines);
    }

    fn rates(&self, twists: &[Twist], _v: &[f64], lines: &[Line], rate: &mut [f64]) {
        self.facing.rates(twists, lines, rate);
    }

    fn apply(&self, tension: &[f64], lines: &[Line], wrenches: &mut [Wrench]) {
        self.facing.apply(tension, lines, wrenches);
    }

    fn evaluate(&self, at: &Placed, value: &mut [f64], gradient: &mut [f64]) {
        self.facing.evaluate(at, &self.spot, value, gradient);
    }

    fn curvature_groups(&self) -> Vec<(usize, Vec<usize>)> {
        (0..3).map(|row| (row, self.facing.dofs.clone())).collect()
    }

    fn curvature(&self, at: &Placed, _value: f64, group: usize, columns: &mut [DVec3], block: &mut [f64]) {
        self.facing.curvature(at, &self.spot, group, columns, block);
    }
}
