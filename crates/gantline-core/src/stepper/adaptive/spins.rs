//! Joints with rotations in body axes: φ is a rotation vector there, φ̇ = ω + φ×ω/2 + … and not ω.

use glam::{DMat3, DVec3};

use super::evaluation::first_rotation;
use crate::system::System;

/// P = (1 + κ[ω]/2)⁻¹ of every such joint: with x the rate of φ in a stage, κ P x is its increment.
#[derive(Debug, Clone)]
pub struct Spins {
    /// First of the three degrees of freedom, and P.
    joints: Vec<(usize, DMat3)>,
}

impl Spins {
    /// Room for the joints of `bodies`.
    pub fn new(system: &System, bodies: &[usize]) -> Self {
        let joints = bodies.iter().filter_map(|&index| first_rotation(&system.tree.bodies[index]));
        Self { joints: joints.map(|first| (first, DMat3::IDENTITY)).collect() }
    }

    /// Sets P at the velocities `v` for κ = `kappa` [s]:
    /// (1 + [u])⁻¹ = (1 − [u] + u uᵀ)/(1 + u²), u = κω/2.
    pub fn update(&mut self, v: &[f64], kappa: f64) {
        for (first, p) in &mut self.joints {
            let u = DVec3::from_slice(&v[*first..*first + 3]) * (0.5 * kappa);
            let cross = DMat3::from_cols(
                DVec3::new(0.0, u.z, -u.y),
                DVec3::new(-u.z, 0.0, u.x),
                DVec3::new(u.y, -u.x, 0.0),
            );
            let outer = DMat3::from_cols(u * u.x, u * u.y, u * u.z);
            *p = (DMat3::IDENTITY - cross + outer) * (1.0 / (1.0 + u.length_squared()));
        }
    }

    /// Three numbers of a row times P of a joint.
    pub fn turn(&self, joint: usize, row: [f64; 3]) -> [f64; 3] {
        self.joints[joint].1.transpose().mul_vec3(DVec3::from_array(row)).to_array()
    }

    /// `out` = κ P x.
    pub fn increments(&self, kappa: f64, x: &[f64], out: &mut [f64]) {
        for (out, x) in out.iter_mut().zip(x) {
            *out = kappa * x;
        }
        for (first, p) in &self.joints {
            let triple = *first..*first + 3;
            let turned = *p * DVec3::from_slice(&x[triple.clone()]) * kappa;
            out[triple].copy_from_slice(&turned.to_array());
        }
    }
}
