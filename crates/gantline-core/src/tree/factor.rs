//! M = LᵀDL along the branches of the tree (Featherstone 2008, section 6.5): entries exist only where M has them, and
//! the cost grows with the depth of the tree, not with its size squared. Driven degrees of freedom have no place.

use super::mass::MassMatrix;

/// The factors, by the slots of the mass matrix.
#[derive(Debug, Clone)]
pub struct MassFactor {
    /// L below its unit diagonal, and D on it.
    values: Vec<f64>,
    /// Degrees of freedom that are unknown.
    free: Vec<bool>,
}

/// The mass matrix is not positive at this degree of freedom.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NoInertia {
    /// Degree of freedom.
    pub dof: usize,
}

impl MassFactor {
    /// Room for the factors of `mass` over the degrees of freedom that are `free`.
    pub fn new(mass: &MassMatrix, free: Vec<bool>) -> Self {
        Self { values: vec![0.0; mass.values.len()], free }
    }

    /// Entries of the factors, a measure of cost.
    pub fn fill(&self) -> usize {
        self.values.len()
    }

    /// Factorises, from the tips of the tree to its root.
    ///
    /// # Errors
    /// [`NoInertia`] where M is not positive definite, or not finite.
    pub fn factorise(&mut self, mass: &MassMatrix) -> Result<(), NoInertia> {
        self.values.copy_from_slice(&mass.values);
        for k in (0..self.free.len()).rev().filter(|&k| self.free[k]) {
            let (first, diagonal) = (mass.row_start[k], mass.row_start[k + 1] - 1);
            let pivot = self.values[diagonal];
            if pivot.is_nan() || pivot <= 0.0 {
                return Err(NoInertia { dof: k });
            }
            for slot in (first..diagonal).rev() {
                let i = mass.columns[slot];
                if !self.free[i] {
                    continue;
                }
                let l = self.values[slot] / pivot;
                // The joints above i are those above k up to it: the two rows begin alike.
                let own = mass.row_start[i];
                for step in 0..=slot - first {
                    self.values[own + step] -= l * self.values[first + step];
                }
                self.values[slot] = l;
            }
        }
        Ok(())
    }

    /// x = M⁻¹ x over the free degrees of freedom; the others stay.
    pub fn solve(&self, mass: &MassMatrix, x: &mut [f64]) {
        for k in (0..x.len()).rev().filter(|&k| self.free[k]) {
            let value = x[k];
            self.above(mass, k, |i, l| x[i] -= l * value);
        }
        for k in (0..x.len()).filter(|&k| self.free[k]) {
            let mut value = x[k] / self.values[mass.row_start[k + 1] - 1];
            self.above(mass, k, |i, l| value -= l * x[i]);
            x[k] = value;
        }
    }

    /// Free degrees of freedom above `k`, each with its entry of L.
    fn above(&self, mass: &MassMatrix, k: usize, mut visit: impl FnMut(usize, f64)) {
        for slot in mass.row_start[k]..mass.row_start[k + 1] - 1 {
            let i = mass.columns[slot];
            if self.free[i] {
                visit(i, self.values[slot]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DVec3};

    use super::*;
    use crate::tree::hinge::Hinge;
    use crate::tree::joint::Joint;
    use crate::tree::kinematics::Kinematics;
    use crate::tree::pose::Pose;
    use crate::tree::{Body, Tree};

    /// A tree that forks: 0 – 1 – {2 – 3, 4}, hinges about different axes.
    fn forked() -> (Tree, MassMatrix) {
        let parents = [None, Some(0), Some(1), Some(2), Some(1)];
        let axes = [DVec3::Z, DVec3::Y, DVec3::X, DVec3::Y, DVec3::Z];
        let bodies = parents.iter().zip(axes).enumerate().map(|(index, (parent, axis))| Body {
            name: index.to_string(),
            parent: *parent,
            placement: Pose::IDENTITY.shifted(DVec3::new(0.3, 0.2, -1.0)),
            is_turned: false,
            joint: Joint::Hinge(Hinge { axis }),
            mass: 1.0 + index as f64,
            centre_of_gravity: DVec3::new(0.1, -0.2, 0.4),
            inertia: DMat3::from_diagonal(DVec3::new(0.5, 0.6, 0.7)),
            first_position: 0,
            first_velocity: 0,
            velocities: 0,
        });
        let tree = Tree::new(bodies.collect(), DVec3::ZERO);
        let mut kinematics = Kinematics::new(&tree);
        kinematics.update(&tree, &[0.3, -0.8, 0.5, 1.1, -0.4], 0.0);
        let mut mass = MassMatrix::new(&tree);
        mass.update(&tree, &kinematics);
        (tree, mass)
    }

    #[test]
    fn solves_what_the_matrix_multiplies() {
        let (tree, mass) = forked();
        for driven in [None, Some(1), Some(3)] {
            let free: Vec<bool> = (0..tree.velocities).map(|dof| Some(dof) != driven).collect();
            let mut factor = MassFactor::new(&mass, free.clone());
            factor.factorise(&mass).unwrap();
            let wanted: Vec<f64> =
                free.iter().enumerate().map(|(k, &free)| if free { 1.0 + k as f64 } else { 0.0 }).collect();
            let mut x = vec![0.0; wanted.len()];
            mass.multiply(&wanted, &mut x);
            factor.solve(&mass, &mut x);
            for (k, (found, wanted)) in x.iter().zip(&wanted).enumerate() {
                assert!(!free[k] || (found - wanted).abs() < 1e-12, "{k}: {found}, {wanted}");
            }
        }
    }

    #[test]
    fn names_what_has_no_inertia() {
        let (_, mut mass) = forked();
        mass.values.fill(0.0);
        let mut factor = MassFactor::new(&mass, vec![true; 5]);
        assert_eq!(factor.factorise(&mass), Err(NoInertia { dof: 4 }));
    }
}
