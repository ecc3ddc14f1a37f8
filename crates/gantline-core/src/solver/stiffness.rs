//! Geometric stiffness of taut ropes: a rope under tension resists sideways motion of its ends. Stiffness of hulls in the
//! water: their section with it resists sinking and heeling.
//!
//! K = Σ f cᵢ·cⱼ over the straight parts, f = T/ℓ, c the relative velocity of a part's ends across it: the
//! part of Gᵀ's change that is positive semidefinite by construction. The rest is what tension does to joints that turn
//! ([`crate::constraint::rope::turning`]): the sum S of all ropes at a body is a group with what of it is positive, S₊ = L Lᵀ
//! over the turn of the body, c = Lᵀ ω, f = 1. A light sheave block at the head of a boom is a pendulum under the tension of
//! its ropes, far too quick for a step that took this from its start. A hull adds ρ g ∫ w w dA over its section, w the
//! upward velocity of the section's points, as such a group with f = ρ g: ∫ w w dA = L Lᵀ over heave and both turns,
//! c = Lᵀ (heave, turn x, turn y). So does a mooring line with all of its stiffness, which is that of a convex function.

use glam::{DMat3, DVec3};

use crate::constraint::Constraint;
use crate::force::AnyForce;
use crate::force::buoyancy::{Afloat, Buoyancy};
use crate::force::mooring::Mooring;
use crate::state::State;
use crate::stepper::frame::Frame;
use crate::system::System;
use crate::tree::kinematics::Kinematics;

/// Weight of the velocity before the step, see [`Stiffness::update`].
pub const EXPLICIT: f64 = 0.25;

/// A body that ropes turn.
#[derive(Debug, Clone)]
struct Turned {
    /// Degrees of freedom that turn it, ascending.
    dofs: Vec<usize>,
    /// S of the ropes [N m].
    resistance: DMat3,
    /// What of it is of ropes that stretch.
    stretching: DMat3,
}

/// Groups of degrees of freedom with one vector each.
#[derive(Debug, Clone)]
pub struct Stiffness {
    /// Start of every group in `dofs` and `columns`.
    pub start: Vec<usize>,
    /// Degrees of freedom.
    pub dofs: Vec<usize>,
    /// Transversal columns c.
    pub columns: Vec<DVec3>,
    /// f = T/ℓ [N/m] of every group.
    pub factor: Vec<f64>,
    /// How many of the groups are ropes' own, of straight parts and of bodies that they turn; hulls and mooring lines come
    /// after them.
    pub ropes: usize,
    /// For every group ½ where it is a straight part of a rope that stretches, else 0: the share of its K along whose curved
    /// path tension does work. A rope that does not stretch stores none.
    along: Vec<f64>,
    /// Bodies that ropes turn, each with its group.
    turned: Vec<Turned>,
    /// For every body its place among these.
    place: Vec<Option<usize>>,
    /// α, weight of the velocity after the step.
    pub implicit: Vec<f64>,
    /// Weight of the velocity before the step: [`EXPLICIT`], or 0 where K is left out.
    pub explicit: f64,
}

impl Stiffness {
    /// Groups of all constraints of `system`.
    pub fn new(system: &System) -> Self {
        let (mut start, mut dofs, mut along) = (vec![0], Vec::new(), Vec::new());
        let mut turned_by = vec![Vec::new(); system.tree.bodies.len()];
        for (index, rope) in system.ropes().enumerate() {
            for (group, (_, members)) in rope.curvature_groups().into_iter().enumerate() {
                along.push(if stretches(system, index, rope.span_of[group]) { 0.5 } else { 0.0 });
                // What is fed turns no rope.
                dofs.extend(members.into_iter().filter(|dof| !system.flows.contains(dof)));
                start.push(dofs.len());
                rope.turned(group).into_iter().for_each(|(body, own)| turned_by[body].extend(own));
            }
        }
        let (mut turned, mut place) = (Vec::new(), vec![None; turned_by.len()]);
        for (body, mut own) in turned_by.into_iter().enumerate() {
            own.sort_unstable();
            own.dedup();
            if own.iter().all(|&dof| system.driven[dof].is_some()) {
                continue;
            }
            place[body] = Some(turned.len());
            dofs.extend(&own);
            start.push(dofs.len());
            turned.push(Turned { dofs: own, resistance: DMat3::ZERO, stretching: DMat3::ZERO });
        }
        let ropes = start.len() - 1;
        for force in &system.tree.forces {
            if matches!(force, AnyForce::Buoyancy(_) | AnyForce::Mooring(_)) {
                dofs.extend(&system.tree.support[force.body()]);
                start.push(dofs.len());
            }
        }
        let (columns, zeros) = (vec![DVec3::ZERO; dofs.len()], vec![0.0; start.len() - 1]);
        let (factor, implicit) = (zeros.clone(), zeros);
        along.resize(factor.len(), 0.0);
        Self { start, dofs, columns, factor, ropes, along, turned, place, implicit, explicit: 0.0 }
    }

    /// K under the tensions of the last step, and the weights of a step of length `h` [s].
    ///
    /// With a = h²f/m, m the inertia that a part moves sideways, the step takes K (α v₊ − v/4): α = ¼ is the
    /// trapezoidal rule, undamped and stable for any a; what is added to it, ¾ a/(1+a), damps motion that
    /// the step is too long to follow and vanishes with h² for what it can follow. Without `used`, both
    /// weights are 0 and K only serves the books.
    pub fn update(&mut self, system: &System, state: &State, frame: &Frame, h: f64, used: bool) {
        self.explicit = if used { EXPLICIT } else { 0.0 };
        let mut group = 0;
        for turned in &mut self.turned {
            (turned.resistance, turned.stretching) = (DMat3::ZERO, DMat3::ZERO);
        }
        for (index, rope) in system.ropes().enumerate() {
            for part in 0..rope.groups() {
                let span = rope.span_of[part];
                let force = state.tension[system.rows.first[index] + span];
                let tension = rope.tension(span, &frame.kinematics, &state.q, force);
                let range = self.start[group]..self.start[group + 1];
                let columns = &mut self.columns[range.clone()];
                if tension == 0.0 {
                    // Where a rope has parted, its route need not be a place for rope any more.
                    columns.fill(DVec3::ZERO);
                    (self.factor[group], self.implicit[group]) = (0.0, self.explicit);
                    group += 1;
                    continue;
                }
                let (turned, place) = (&mut self.turned, &self.place);
                let does_stretch = stretches(system, index, span);
                let turns = |body: usize, resistance: DMat3| {
                    if let Some(place) = place[body] {
                        turned[place].resistance += resistance;
                        if does_stretch {
                            turned[place].stretching += resistance;
                        }
                    }
                };
                let at = (&frame.kinematics, state.seats.as_slice());
                self.factor[group] = rope.geometric_stiffness(at, tension, part, columns, turns);
                self.weigh(system, group, h, used);
                group += 1;
            }
        }
        for index in 0..self.turned.len() {
            let Turned { dofs, resistance, .. } = &self.turned[index];
            let root = positive_root(resistance);
            for (column, &dof) in self.columns[self.start[group]..].iter_mut().zip(dofs) {
                *column = root.transpose() * frame.kinematics.columns[dof].angular;
            }
            self.factor[group] = 1.0;
            self.weigh(system, group, h, used);
            group += 1;
        }
        for force in &system.tree.forces {
            let columns = match force {
                AnyForce::Buoyancy(_) | AnyForce::Mooring(_) => {
                    &mut self.columns[self.start[group]..self.start[group + 1]]
                }
                _ => continue,
            };
            self.factor[group] = match force {
                AnyForce::Buoyancy(buoyancy) => section_stiffness(system, frame, buoyancy, columns),
                AnyForce::Mooring(mooring) => line_stiffness(system, frame, mooring, columns),
                _ => 0.0,
            };
            self.weigh(system, group, h, used);
            group += 1;
        }
    }

    /// α of a group.
    fn weigh(&mut self, system: &System, group: usize, h: f64, used: bool) {
        let range = self.start[group]..self.start[group + 1];
        let mobility: f64 = self.dofs[range.clone()]
            .iter()
            .zip(&self.columns[range])
            .filter(|&(&dof, _)| system.driven[dof].is_none())
            .map(|(&dof, column)| column.length_squared() / system.tree.inertia_scale[dof])
            .sum();
        let a = h * h * self.factor[group] * mobility;
        self.implicit[group] = if used { EXPLICIT + 0.75 * a / (1.0 + a) } else { 0.0 };
    }

    /// Relative transversal velocity of the ends of a group's part [m/s].
    fn transversal(&self, group: usize, v: &[f64]) -> DVec3 {
        let range = self.start[group]..self.start[group + 1];
        self.dofs[range.clone()].iter().zip(&self.columns[range]).map(|(&dof, column)| *column * v[dof]).sum()
    }

    /// `out` += scale · K (α v₊ − v/4).
    pub fn add_force(&self, after: &[f64], before: &[f64], scale: f64, out: &mut [f64]) {
        if self.explicit == 0.0 {
            return;
        }
        for group in 0..self.factor.len() {
            let velocity = self.transversal(group, after) * self.implicit[group]
                - self.transversal(group, before) * self.explicit;
            let force = velocity * (scale * self.factor[group]);
            for entry in self.start[group]..self.start[group + 1] {
                out[self.dofs[entry]] += self.columns[entry].dot(force);
            }
        }
    }

    /// h² v₊ᵀ K (α v₊ − v/4) minus the work that tension does along the curved path [J]: ½ h² v₊ᵀ K v₊ of straight parts,
    /// ½ h² ωᵀ S ω of bodies that ropes turn, with all of S: a body that spins about its arm goes along no curve, but S₊
    /// resists it. Of ropes that do not stretch tension does none: what their rows take leaves the motion, and nothing
    /// stores it. What water and mooring lines do along it is booked with the bias.
    pub fn loss(&self, kinematics: &Kinematics, after: &[f64], before: &[f64], h: f64) -> f64 {
        let of_group = |group: usize| {
            let (new, old) = (self.transversal(group, after), self.transversal(group, before));
            let taken = new * (self.implicit[group] - self.along[group]) - old * self.explicit;
            h * h * self.factor[group] * new.dot(taken)
        };
        let of_turn = |turned: &Turned| {
            let turn: DVec3 =
                turned.dofs.iter().map(|&dof| kinematics.columns[dof].angular * after[dof]).sum();
            0.5 * h * h * turn.dot(turned.stretching * turn)
        };
        let taken: f64 = (0..self.factor.len()).map(of_group).sum();
        taken - self.turned.iter().map(of_turn).sum::<f64>()
    }
}

/// Whether a span of a rope stretches.
fn stretches(system: &System, rope: usize, span: usize) -> bool {
    system.rows.laws[system.rows.first[rope] + span].compliance() > 0.0
}

/// Columns of the stiffness of a hull's section with the water; returns ρ g.
fn section_stiffness(system: &System, frame: &Frame, buoyancy: &Buoyancy, columns: &mut [DVec3]) -> f64 {
    let (tree, kinematics) = (&system.tree, &frame.kinematics);
    let pose = &kinematics.pose[buoyancy.body];
    let Afloat { up, weight, area, area_moment, area_second, .. } = buoyancy.afloat(pose, tree.gravity);
    // w = ẑ·δx + (r × ẑ)·δθ: over heave and the turns about two axes across the vertical.
    let (across, along) = up.any_orthonormal_pair();
    let [first, second] = [across, along].map(|axis| up.cross(axis));
    let turns = |a: DVec3, b: DVec3| a.dot(area_second * b);
    let moments = DVec3::new(area, area_moment.dot(first), area_moment.dot(second));
    let whole = DMat3::from_cols(
        moments,
        DVec3::new(moments.y, turns(first, first), turns(first, second)),
        DVec3::new(moments.z, turns(first, second), turns(second, second)),
    );
    let root = cholesky(&whole);
    for (column, &dof) in columns.iter_mut().zip(&tree.support[buoyancy.body]) {
        let own = &kinematics.columns[dof];
        let linear = kinematics.point_column(tree, dof, pose.position);
        let motion = DVec3::new(up.dot(linear), across.dot(own.angular), along.dot(own.angular));
        *column = root.transpose() * motion;
    }
    weight
}

/// Columns of the stiffness with which a mooring line holds its upper end, K = L Lᵀ: c = Lᵀ (the end's velocity); returns 1.
fn line_stiffness(system: &System, frame: &Frame, mooring: &Mooring, columns: &mut [DVec3]) -> f64 {
    let (tree, kinematics) = (&system.tree, &frame.kinematics);
    let pose = &kinematics.pose[mooring.body];
    let root = cholesky(&mooring.stiffness(pose, tree.gravity, &kinematics.q));
    for (column, &dof) in columns.iter_mut().zip(&tree.support[mooring.body]) {
        *column = root.transpose() * kinematics.point_column(tree, dof, pose.point(mooring.at));
    }
    1.0
}

/// Sweeps of Jacobi's rotations; each squares what is left beside the diagonal, so that after six of three by three there is nothing.
const SWEEPS: usize = 6;

/// L with L Lᵀ the positive part of a symmetric matrix: its eigenvectors times the roots of its positive eigenvalues.
///
/// By rotations, as a pull along its arm has two eigenvalues alike: the closed form of parry's `SymmetricEigen3` is then off by
/// 6e-9, this by rounding. `statics::eigen`, for any size, allocates, which no step does.
fn positive_root(matrix: &DMat3) -> DMat3 {
    let (mut values, mut vectors) = (*matrix, DMat3::IDENTITY);
    for _ in 0..SWEEPS {
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            let (beside, [first, second]) = (values.col(j)[i], [values.col(i)[i], values.col(j)[j]]);
            if beside.abs() <= f64::EPSILON * 0.5 * (first.abs() + second.abs()) {
                continue;
            }
            let cotangent = (second - first) / (2.0 * beside);
            let tangent = 1.0_f64.copysign(cotangent) / (cotangent.abs() + cotangent.hypot(1.0));
            let cosine = 1.0 / tangent.hypot(1.0);
            let sine = tangent * cosine;
            let mut turn = DMat3::IDENTITY;
            (turn.col_mut(i)[i], turn.col_mut(j)[j]) = (cosine, cosine);
            (turn.col_mut(i)[j], turn.col_mut(j)[i]) = (-sine, sine);
            values = turn.transpose() * values * turn;
            vectors *= turn;
        }
    }
    let root = |axis: usize| vectors.col(axis) * values.col(axis)[axis].max(0.0).sqrt();
    DMat3::from_cols(root(0), root(1), root(2))
}

/// L of a positive semidefinite matrix L Lᵀ; columns without anything left are zero.
fn cholesky(matrix: &DMat3) -> DMat3 {
    let mut root = DMat3::ZERO;
    for k in 0..3 {
        let before: f64 = (0..k).map(|j| root.col(j)[k] * root.col(j)[k]).sum();
        let pivot = matrix.col(k)[k] - before;
        if pivot <= 1e-12 * matrix.col(k)[k] {
            continue;
        }
        let pivot = pivot.sqrt();
        for i in k..3 {
            let before: f64 = (0..k).map(|j| root.col(j)[i] * root.col(j)[k]).sum();
            root.col_mut(k)[i] = (matrix.col(k)[i] - before) / pivot;
        }
    }
    root
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DQuat, DVec3};

    use super::positive_root;

    #[test]
    fn the_positive_part_has_the_positive_eigenvalues() {
        let axes = DMat3::from_quat(DQuat::from_euler(glam::EulerRot::XYZ, 0.4, -1.1, 2.0));
        for (values, positive) in [
            ([3.0, 2.0, 1.0], [3.0, 2.0, 1.0]),
            ([3.0, -2.0, 1e-6], [3.0, 0.0, 1e-6]),
            ([5.0, 5.0, -5.0], [5.0, 5.0, 0.0]),
            ([-1.0, -2.0, -3.0], [0.0; 3]),
            ([0.0; 3], [0.0; 3]),
        ] {
            for turn in [DMat3::IDENTITY, axes] {
                let of = |values: [f64; 3]| {
                    turn * DMat3::from_diagonal(DVec3::from_array(values)) * turn.transpose()
                };
                let root = positive_root(&of(values));
                let difference = root * root.transpose() - of(positive);
                assert!(difference.to_cols_array().iter().all(|entry| entry.abs() < 1e-14), "{difference}");
            }
        }
    }
}
