//! A stop: the end of the stroke of a hinge or slider; or a spring, where both ends are at one place.
//!
//! e = ±(q − q_end), how far the joint is beyond it; T = max(0, k (e + τ ė)), the law of ropes and contacts, without
//! friction; of a spring T = k (e + τ ė) either way. The force acts between the two bodies of the joint along its coordinate, so ∂g/∂q is ±1 and nothing turns.

use glam::DVec3;

use super::{Constraint, Law, Line, Moving, Placed};
use crate::tree::bias::Wrench;
use crate::tree::kinematics::Twist;

/// One end of a stroke, or the middle of a spring.
#[derive(Debug, Clone)]
pub struct Stop {
    /// Name of the body whose joint it is.
    pub name: String,
    /// Degree of freedom of the joint.
    pub dof: usize,
    /// Its coordinate in q.
    pub position: usize,
    /// Where the stroke ends [rad or m].
    pub end: f64,
    /// 1 for the upper end and a spring, −1 for the lower.
    pub side: f64,
    /// 1/k [rad/(N m) or m/N].
    pub compliance: f64,
    /// τ [s].
    pub damping_time: f64,
    /// Whether it acts on both sides.
    pub is_spring: bool,
}

impl Constraint for Stop {
    fn name(&self) -> &str {
        &self.name
    }

    fn row_dofs(&self) -> Vec<Vec<usize>> {
        vec![vec![self.dof]]
    }

    fn laws(&self, _first_row: usize) -> Vec<Law> {
        let Self { compliance, damping_time, is_spring, .. } = *self;
        vec![if is_spring {
            Law::Spring { compliance, damping_time }
        } else {
            Law::Unilateral { compliance, damping_time }
        }]
    }

    fn lines(&self) -> usize {
        0
    }

    fn locate(&self, at: &Moving, value: &mut [f64], rate: &mut [f64], _lines: &mut [Line]) {
        value[0] = self.side * (at.q[self.position] - self.end);
        rate[0] = self.side * at.v[self.dof];
    }

    fn rates(&self, _twists: &[Twist], v: &[f64], _lines: &[Line], rate: &mut [f64]) {
        rate[0] = self.side * v[self.dof];
    }

    fn apply(&self, _tension: &[f64], _lines: &[Line], _wrenches: &mut [Wrench]) {}

    fn feed(&self, tension: &[f64], _lines: &[Line], force: &mut [f64]) {
        force[self.dof] += self.side * tension[0];
    }

    fn evaluate(&self, at: &Placed, value: &mut [f64], gradient: &mut [f64]) {
        value[0] = self.side * (at.q[self.position] - self.end);
        gradient[0] = self.side;
    }

    fn curvature_groups(&self) -> Vec<(usize, Vec<usize>)> {
        Vec::new()
    }

    fn curvature(&self, _: &Placed, _: f64, _: usize, _: &mut [DVec3], _: &mut [f64]) {}
}
