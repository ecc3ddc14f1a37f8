//! How tension resists the turning of what it acts on.
//!
//! A force F that keeps its direction, at the arm d from where a body turns, does the work F·(R d − d) when the body
//! turns by R. With R d = d + θ × d + ½ θ × (θ × d) + … the second-order part of that is −½ θᵀ S θ,
//!
//! ```text
//! S = (F·d) 1 − ½ (F dᵀ + d Fᵀ)
//! ```
//!
//! a pendulum with F in place of its weight. Where an end of a straight part hangs on several joints, one below the other, its
//! place is the sum of the arms from each joint to the next, and each joint has its own S with its own arm. Joints that turn
//! both ends turn the force as well, and have none.

use glam::{DMat3, DVec3};

use super::Rope;
use super::levers::Lever;
use crate::rope::part::Straight;
use crate::tree::joint::Motion;
use crate::tree::kinematics::Kinematics;

impl Rope {
    /// Bodies whose joints turn one end of a group's part and not the other, and the degrees of freedom that turn each
    /// of them so.
    pub fn turned(&self, group: usize) -> Vec<(usize, Vec<usize>)> {
        let (from, to) = self.ends(self.parts[group]);
        let mut found: Vec<(usize, Vec<usize>)> = Vec::new();
        for levers in [from, to] {
            let mut dofs = Vec::new();
            for lever in levers.iter().filter(|lever| lever.motion == Motion::Turn) {
                dofs.push(lever.dof as usize);
                if !lever.opens {
                    found.pop();
                }
                found.push((lever.body as usize, dofs.clone()));
            }
        }
        found
    }

    /// S of every body of [`Rope::turned`] under the tension [N] of the group's part.
    pub(super) fn turn(
        &self,
        kinematics: &Kinematics,
        (straight, tension): (&Straight, f64),
        group: usize,
        mut turns: impl FnMut(usize, DMat3),
    ) {
        let (from, to) = self.ends(self.parts[group]);
        let pull = straight.direction * tension;
        for (levers, end, force) in [(from, straight.from, pull), (to, straight.to, -pull)] {
            let mut end = end;
            for Lever { body, .. } in levers.iter().rev().filter(|lever| lever.opens) {
                let origin = kinematics.pose[*body as usize].position;
                turns(*body as usize, resistance(force, end - origin));
                end = origin;
            }
        }
    }
}

/// S of a force [N] at an arm [m].
fn resistance(force: DVec3, arm: DVec3) -> DMat3 {
    let outer = DMat3::from_cols(force * arm.x, force * arm.y, force * arm.z);
    DMat3::from_diagonal(DVec3::splat(force.dot(arm))) - (outer + outer.transpose()) * 0.5
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec3};

    use super::resistance;

    #[test]
    fn it_is_the_second_derivative_of_the_work() {
        let (force, arm, angle) = (DVec3::new(3.0, -1.0, 2.0), DVec3::new(0.5, 0.7, -1.1), 1e-3);
        for axis in [DVec3::X, DVec3::Y, DVec3::new(0.6, 0.0, 0.8), DVec3::new(0.6, 0.48, 0.64)] {
            let work = |angle: f64| force.dot(DQuat::from_axis_angle(axis, angle) * arm - arm);
            let second = (work(angle) + work(-angle)) / (angle * angle);
            let expected = -axis.dot(resistance(force, arm) * axis);
            assert!((second - expected).abs() < 1e-6, "{second} for {expected}");
        }
    }
}
