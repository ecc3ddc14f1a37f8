//! Buoyancy: pressure of still water on a hull.
//!
//! The pressure ρ g times depth is a potential's: with h the height above the water and V the volume below,
//!
//! ```text
//! U = −ρ g ∫_V h dV
//! ```
//!
//! is the work that it took to push the hull in, and the force on the body is its slope. A displacement moves a point by
//! w = (δx + δθ × r)·ẑ upwards, r from the origin of the body, and the boundary of V at the surface, where h = 0, adds nothing:
//!
//! ```text
//! δU = −ρ g ∫_V w dV        F = ρ g V ẑ        M = ρ g b × ẑ,  b = ∫_V r dV
//! ```
//!
//! V loses w dA over the section S with the water, and what is in it turns along:
//!
//! ```text
//! δV = −∫_S w dA        δb = δθ × b − ∫_S r w dA
//! ```
//!
//! That is exact for any shape at any heel. Where an edge meets the water or a deck goes under, the section changes at
//! once, and with it the tangent; the force is continuous.

use glam::{DMat3, DVec3};

use super::square::{Square, outer, skew};
use super::{At, Force, Tangent};
use crate::hull::{Hull, Immersion, Plane};
use crate::tree::bias::Wrench;
use crate::tree::pose::Pose;

/// A hull in water.
#[derive(Debug, Clone)]
pub struct Buoyancy {
    /// Name.
    pub name: String,
    /// Index of the body.
    pub body: usize,
    /// The hull, in the body's frame.
    pub hull: Hull,
    /// Density of the water [kg/m³].
    pub density: f64,
    /// Height of the water's surface above the world's origin [m].
    pub level: f64,
}

/// Volume and section of a hull in the water, world axes, about the body's origin.
#[derive(Debug, Clone, Copy)]
pub struct Afloat {
    /// Upwards.
    pub up: DVec3,
    /// ρ g [N/m³].
    pub weight: f64,
    /// V [m³].
    pub volume: f64,
    /// b [m⁴].
    pub moment: DVec3,
    /// ∫ dA, ∫ r dA, ∫ r rᵀ dA of the section.
    pub area: f64,
    /// See `area` [m³].
    pub area_moment: DVec3,
    /// See `area` [m⁴].
    pub area_second: DMat3,
}

impl Buoyancy {
    /// What lies below the water, in the body's frame.
    pub fn below(&self, pose: &Pose, gravity: DVec3) -> Immersion {
        let up = -gravity / gravity.length();
        let normal = pose.rotation.transpose() * up;
        self.hull.below(&Plane { normal, height: up.dot(pose.position) - self.level })
    }

    /// The same about the body's origin in the world's axes.
    pub fn afloat(&self, pose: &Pose, gravity: DVec3) -> Afloat {
        let below = self.below(pose, gravity);
        let turn = pose.rotation;
        Afloat {
            up: -gravity / gravity.length(),
            weight: self.density * gravity.length(),
            volume: below.volume,
            moment: turn * below.moment,
            area: below.area,
            area_moment: turn * below.area_moment,
            area_second: turn * below.area_second * turn.transpose(),
        }
    }
}

impl Afloat {
    /// Force and moment about the body's origin.
    pub fn wrench(&self) -> Wrench {
        Wrench {
            force: self.up * (self.weight * self.volume),
            moment: self.moment.cross(self.up) * self.weight,
        }
    }

    /// Derivative of force and moment over displacement and turn, world axes: the stiffness with the other sign.
    pub fn derivative(&self) -> Square {
        let (up, weight) = (self.up, self.weight);
        let lift = skew(up);
        // w = ẑ·δx + (r × ẑ)·δθ, so that ∫ w dA = A ẑ·δx + (s × ẑ)·δθ and, with r (r × ẑ)ᵀ = r rᵀ [ẑ],
        // ∫ r w dA = s ẑ·δx + Q [ẑ] δθ; s and Q are the section's first and second moment.
        let turned = self.area_moment.cross(up);
        let second = self.area_second * lift;
        // δb over δx and over δθ; the moment is δb × ẑ = −[ẑ] δb.
        let shift = -outer(self.area_moment, up);
        let turn = -skew(self.moment) - second;
        Square {
            linear: -outer(up, up) * (weight * self.area),
            cross: -outer(up, turned) * weight,
            back: -lift * shift * weight,
            angular: -lift * turn * weight,
        }
    }
}

impl Force for Buoyancy {
    fn name(&self) -> &str {
        &self.name
    }

    fn body(&self) -> usize {
        self.body
    }

    fn wrench(&self, at: &At) -> Wrench {
        self.afloat(at.pose, at.gravity).wrench()
    }

    fn tangent(&self, at: &At) -> Tangent {
        let afloat = self.afloat(at.pose, at.gravity);
        let Wrench { force, moment } = afloat.wrench();
        // Seen from the body, what a turn does to the directions of force and moment does not count: δW − δθ × W.
        let mut place = afloat.derivative();
        place.cross += skew(force);
        place.angular += skew(moment);
        Tangent { place, ..Tangent::NONE }
    }

    fn energy(&self, pose: &Pose, gravity: DVec3, _q: &[f64]) -> f64 {
        self.density * gravity.length() * self.below(pose, gravity).depth_moment
    }

    fn energy_rate(&self, at: &At) -> f64 {
        -self.wrench(at).power(&at.twist)
    }
}
