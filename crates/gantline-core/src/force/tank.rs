//! A liquid in a slack tank: its surface stays level while the tank turns.
//!
//! Mass and inertia of the liquid are the body's, as if it were frozen where it lies when the body is upright. What is
//! added here is how its weight moves. With v its volume, b = ∫ r dV over it, r from the origin of the body, c where
//! its centre is frozen,
//!
//! ```text
//! U = ρ g ẑ·b′        M = −ρ g b′ × ẑ        b′ = b − v c
//! ```
//!
//! The level follows from v. A turn moves points of the surface S by w = δθ·(r × ẑ) upwards and the level by their
//! mean w̄, so that v stays:
//!
//! ```text
//! δb′ = δθ × b′ − ∫_S r (w − w̄) dA
//! ```
//!
//! To small angles that is the free-surface correction, ρ g i δθ with i the second moment of S about its own axis. The
//! liquid follows at once: there is no sloshing.

use glam::{DMat3, DVec3};

use super::square::{Square, skew};
use super::{At, Force, Tangent};
use crate::hull::{Hull, Immersion, Plane};
use crate::tree::bias::Wrench;
use crate::tree::pose::Pose;

/// Volume that the level may be wrong by, relative to the tank.
const LEVEL: f64 = 1e-14;
/// Share of the tank that is air or liquid at least where there is a surface.
const FREE: f64 = 1e-9;
/// Steps to the level, at most: halving alone would need fewer.
const STEPS: usize = 100;

/// A tank with liquid in it.
#[derive(Debug, Clone)]
pub struct Tank {
    /// Name.
    pub name: String,
    /// Index of the body.
    pub body: usize,
    /// Inside of the tank, in the body's frame.
    pub hull: Hull,
    /// Density of the liquid [kg/m³].
    pub density: f64,
    /// Its volume [m³].
    pub volume: f64,
    /// How much the tank holds [m³].
    pub capacity: f64,
    /// c: centre of the liquid with the body upright [m], body frame.
    pub frozen: DVec3,
}

/// The liquid in world axes about the body's origin.
struct Contents {
    up: DVec3,
    /// ρ g [N/m³].
    weight: f64,
    /// b′ [m⁴].
    shift: DVec3,
    /// ∫ (r − r̄)(r − r̄)ᵀ dA of the surface [m⁴].
    spread: DMat3,
}

impl Tank {
    /// A tank of which `volume` [m³] is full.
    pub fn new(name: String, body: usize, hull: Hull, capacity: f64, density: f64, volume: f64) -> Self {
        let mut tank = Self { name, body, hull, density, volume, capacity, frozen: DVec3::ZERO };
        if volume > 0.0 {
            tank.frozen = tank.contents(DVec3::Z).moment / volume;
        }
        tank
    }

    /// What lies below the level of the liquid where `up`, in the body's frame, points upwards.
    fn contents(&self, up: DVec3) -> Immersion {
        let (lowest, highest) = self.hull.span(up);
        // h = up·x + d is negative all over the tank for d = −highest.
        let (mut full, mut empty) = (-highest, -lowest);
        let mut height = full + (1.0 - self.volume / self.capacity) * (empty - full);
        let mut below = self.hull.below(&Plane { normal: up, height });
        for _ in 0..STEPS {
            let excess = below.volume - self.volume;
            if excess.abs() <= LEVEL * self.capacity {
                break;
            }
            *(if excess > 0.0 { &mut full } else { &mut empty }) = height;
            let newton = height + excess / below.area;
            let next = if newton > full && newton < empty { newton } else { 0.5 * (full + empty) };
            if next == height {
                break;
            }
            height = next;
            below = self.hull.below(&Plane { normal: up, height });
        }
        below
    }

    fn at(&self, pose: &Pose, gravity: DVec3) -> Contents {
        let (turn, up) = (pose.rotation, -gravity / gravity.length());
        let weight = self.density * gravity.length();
        let free = FREE * self.capacity;
        if self.volume <= free || self.capacity - self.volume <= free {
            return Contents { up, weight, shift: DVec3::ZERO, spread: DMat3::ZERO };
        }
        let below = self.contents(turn.transpose() * up);
        let outer = |a: DVec3| DMat3::from_cols(a * a.x, a * a.y, a * a.z);
        let central = if below.area > 0.0 {
            below.area_second - outer(below.area_moment) * (1.0 / below.area)
        } else {
            DMat3::ZERO
        };
        Contents {
            up,
            weight,
            shift: turn * (below.moment - self.frozen * self.volume),
            spread: turn * central * turn.transpose(),
        }
    }
}

impl Force for Tank {
    fn name(&self) -> &str {
        &self.name
    }

    fn body(&self) -> usize {
        self.body
    }

    fn wrench(&self, at: &At) -> Wrench {
        let Contents { up, weight, shift, .. } = self.at(at.pose, at.gravity);
        Wrench { force: DVec3::ZERO, moment: up.cross(shift) * weight }
    }

    fn tangent(&self, at: &At) -> Tangent {
        let Contents { up, weight, shift, spread } = self.at(at.pose, at.gravity);
        let lift = skew(up);
        let turn = -skew(shift) - spread * lift;
        let moment = up.cross(shift) * weight;
        let angular = lift * turn * weight + skew(moment);
        Tangent { place: Square { angular, ..Square::ZERO }, ..Tangent::NONE }
    }

    fn energy(&self, pose: &Pose, gravity: DVec3) -> f64 {
        let Contents { up, weight, shift, .. } = self.at(pose, gravity);
        weight * up.dot(shift)
    }

    fn energy_rate(&self, at: &At) -> f64 {
        -self.wrench(at).moment.dot(at.twist.angular)
    }
}
