//! A locking pin: holds a hinge or a slider where it is, whatever that takes, until it is pulled.
//!
//! q̇ = 0 while it is in, exactly: the joint does not creep. Its force T is an unknown of either sign, as that of a
//! joint's other directions would be. Pulled, it carries nothing, and no energy leaves with it: a rigid pin stores none.

use glam::DVec3;

use super::{Constraint, Law, Line, Moving, Placed};
use crate::tree::bias::Wrench;
use crate::tree::kinematics::Twist;

/// A locking pin.
#[derive(Debug, Clone)]
pub struct Pin {
    /// Name of the body whose joint it holds.
    pub name: String,
    /// Degree of freedom of the joint.
    pub dof: usize,
}

impl Constraint for Pin {
    fn name(&self) -> &str {
        &self.name
    }

    fn row_dofs(&self) -> Vec<Vec<usize>> {
        vec![vec![self.dof]]
    }

    fn laws(&self, _first_row: usize) -> Vec<Law> {
        vec![Law::Pin]
    }

    fn lines(&self) -> usize {
        0
    }

    fn locate(&self, at: &Moving, value: &mut [f64], rate: &mut [f64], _lines: &mut [Line]) {
        value[0] = 0.0;
        rate[0] = at.v[self.dof];
    }

    fn rates(&self, _twists: &[Twist], v: &[f64], _lines: &[Line], rate: &mut [f64]) {
        rate[0] = v[self.dof];
    }

    fn apply(&self, _tension: &[f64], _lines: &[Line], _wrenches: &mut [Wrench]) {}

    fn feed(&self, tension: &[f64], _lines: &[Line], force: &mut [f64]) {
        force[self.dof] += tension[0];
    }

    fn evaluate(&self, _at: &Placed, value: &mut [f64], gradient: &mut [f64]) {
        value[0] = 0.0;
        gradient[0] = 1.0;
    }

    fn curvature_groups(&self) -> Vec<(usize, Vec<usize>)> {
        Vec::new()
    }

    fn curvature(&self, _: &Placed, _: f64, _: usize, _: &mut [DVec3], _: &mut [f64]) {}
}
