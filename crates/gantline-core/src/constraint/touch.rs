//! A place at which two bodies may touch: one normal row and two tangential rows ([`super::facing`]), as of a point against a
//! plane ([`super::contact`]). Where it is on the two bodies the state remembers.

use glam::DVec3;

use super::facing::Facing;
use super::{Constraint, Law, Line, Moving, Placed};
use crate::contact::spot::Spot;
use crate::tree::bias::Wrench;
use crate::tree::kinematics::Twist;

/// Value of the depth of a spot that is not near [m].
const FAR: f64 = -1.0;

/// A place at which two bodies may touch.
#[derive(Debug, Clone)]
pub struct Touch {
    /// Unique name.
    pub name: String,
    /// Index of this constraint.
    pub index: usize,
    /// Index of the group whose forces are added up.
    pub group: usize,
    /// True for the top of a support.
    pub is_support: bool,
    /// The two bodies.
    pub facing: Facing,
    /// Number of its spot in the state.
    pub spot: usize,
    /// 1/k [m/N].
    pub compliance: f64,
    /// τ [s].
    pub damping_time: f64,
    /// μ.
    pub friction: f64,
}

impl Touch {
    /// Its spot, where something is near.
    fn near<'a>(&self, spots: &'a [Spot]) -> Option<&'a Spot> {
        Some(&spots[self.spot]).filter(|spot| spot.is_near)
    }
}

impl Constraint for Touch {
    fn name(&self) -> &str {
        &self.name
    }

    fn row_dofs(&self) -> Vec<Vec<usize>> {
        vec![self.facing.dofs.clone(); 3]
    }

    fn laws(&self, first_row: usize) -> Vec<Law> {
        Law::of_contact(self.compliance, self.damping_time, self.friction, first_row)
    }

    /// One for each row, with the direction in which it pushes the first body against the second.
    fn lines(&self) -> usize {
        3
    }

    fn locate(&self, at: &Moving, value: &mut [f64], rate: &mut [f64], lines: &mut [Line]) {
        let Some(spot) = self.near(at.spots) else {
            value.copy_from_slice(&[FAR, 0.0, 0.0]);
            rate.fill(0.0);
            lines.fill(Line::default());
            return;
        };
        self.facing.locate(at, spot, value, rate, lines);
    }

    fn rates(&self, twists: &[Twist], _v: &[f64], lines: &[Line], rate: &mut [f64]) {
        self.facing.rates(twists, lines, rate);
    }

    fn apply(&self, tension: &[f64], lines: &[Line], wrenches: &mut [Wrench]) {
        self.facing.apply(tension, lines, wrenches);
    }

    fn evaluate(&self, at: &Placed, value: &mut [f64], gradient: &mut [f64]) {
        let Some(spot) = self.near(at.spots) else {
            value.copy_from_slice(&[FAR, 0.0, 0.0]);
            gradient.fill(0.0);
            return;
        };
        self.facing.evaluate(at, spot, value, gradient);
    }

    fn curvature_groups(&self) -> Vec<(usize, Vec<usize>)> {
        (0..3).map(|row| (row, self.facing.dofs.clone())).collect()
    }

    fn curvature(&self, at: &Placed, _value: f64, group: usize, columns: &mut [DVec3], block: &mut [f64]) {
        match self.near(at.spots) {
            Some(spot) => self.facing.curvature(at, spot, group, columns, block),
            None => block.fill(0.0),
        }
    }
}
