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

#[cfg(test)]
mod tests {
    use glam::{DMat3, DVec3};

    use super::Spins;

    /// (1 + κ[ω]/2) y = κ x for y = κ P x, and rows times P are rows of P x.
    #[test]
    fn increments_solve_for_the_rate_of_a_rotation_vector() {
        let (omega, x, kappa) = (DVec3::new(1.3, -0.7, 2.1), DVec3::new(0.4, 0.9, -0.2), 0.8);
        let mut spins = Spins { joints: vec![(0, DMat3::IDENTITY)] };
        spins.update(&omega.to_array(), kappa);
        let mut out = [0.0; 3];
        spins.increments(kappa, &x.to_array(), &mut out);
        let y = DVec3::from_array(out);
        assert!((y + omega.cross(y) * (0.5 * kappa) - x * kappa).length() < 1e-15);
        let row = [0.7, -0.1, 0.6];
        let turned = DVec3::from_array(spins.turn(0, row));
        assert!((turned.dot(x) * kappa - DVec3::from_array(row).dot(y)).abs() < 1e-15);
    }
}
