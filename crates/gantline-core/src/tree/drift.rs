//! How kinetic energy changes with the configuration alone.
//!
//! Bodies drift with the twists (Ω, u) while the joints' velocities are held. With W = ω − ω_p turning with the body,
//! S = ȯ − ȯ_p − ω_p × r fixed in the parent, r = o − o_p and l from o to the centre of gravity,
//!
//! ```text
//! δω = δω_p + Ω × W        δȯ = δȯ_p + δω_p × r + ω_p × (u − u_p) + Ω_p × S
//! δċ = δȯ + δω × l + ω × (Ω × l)        δE = Σ m ċ·δċ + H·(δω + ω × Ω),   H = I ω
//! ```
//!
//! The last term is the inertia's that turns along: ½ ω·(δI ω) = ω·(Ω × H).

use glam::DVec3;

use super::Tree;
use super::kinematics::{Kinematics, Twist};

/// Rate of ½ vᵀ M v [W] as bodies that move with `twists` drift with `drift`, v held. `changes` is work space for
/// every body.
pub fn power(
    tree: &Tree,
    kinematics: &Kinematics,
    (twists, drift): (&[Twist], &[Twist]),
    changes: &mut [Twist],
) -> f64 {
    let mut power = 0.0;
    for &index in &tree.moving {
        let body = &tree.bodies[index];
        let (twist, own) = (twists[index], drift[index]);
        let still = || (Twist::default(), Twist::default(), Twist::default(), DVec3::ZERO);
        let (above, carried, change, arm) = body.parent.map_or_else(still, |parent| {
            (twists[parent], drift[parent], changes[parent], kinematics.arm[index])
        });
        let turn = twist.angular - above.angular;
        let shift = twist.linear - above.linear - above.angular.cross(arm);
        let angular = change.angular + own.angular.cross(turn);
        let linear = change.linear
            + change.angular.cross(arm)
            + above.angular.cross(own.linear - carried.linear)
            + carried.angular.cross(shift);
        changes[index] = Twist { angular, linear };
        let lever = kinematics.lever[index];
        let centre = linear + angular.cross(lever) + twist.angular.cross(own.angular.cross(lever));
        let rotation = kinematics.pose[index].rotation;
        let momentum = rotation * (body.inertia * (rotation.transpose() * twist.angular));
        power += body.mass * twist.at(lever).dot(centre)
            + momentum.dot(angular + twist.angular.cross(own.angular));
    }
    power
}
