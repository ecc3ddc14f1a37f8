//! How a rope lies on a sheave: its wrap angle by continuity, whether it has lifted off, its fleet angles.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Middle of the branch in which a wrap angle is taken at the start of a run [rad]: from −90° to 270°, from a rope that
/// has all but lifted off to one that turns back past half a turn.
pub const FIRST_WRAP: f64 = FRAC_PI_2;

/// What the state remembers of a sheave with true tangents.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Seat {
    /// What was wound at the end of the last step: of all angles that differ by whole turns the next is the closest.
    pub wound: Winding,
    /// True where the wrap has gone below zero: the rope is off the sheave.
    pub is_off: bool,
}

impl Default for Seat {
    fn default() -> Self {
        Self { wound: Winding { wrap: FIRST_WRAP, arrived: 0.5 * FIRST_WRAP }, is_off: false }
    }
}

/// How far a rope is wound on a sheave.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Winding {
    /// Wrap angle [rad].
    pub wrap: f64,
    /// The part of it before the sheave's mark, where two spans meet [rad]; half of it on a sheave without.
    pub arrived: f64,
}

/// Angle on a sheave from where the rope arrives to where it leaves [rad], about its axis; within half a turn of
/// `near`.
pub fn wrap_angle(axis: DVec3, arrival: DVec3, departure: DVec3, near: f64) -> f64 {
    let angle = axis.dot(arrival.cross(departure)).atan2(arrival.dot(departure));
    angle + TAU * ((near - angle) / TAU).round()
}

/// Angle between a straight part and the plane of a sheave [rad], positive where the rope lies on the side to which
/// the axis points; `outwards` is the direction of the part away from the sheave.
pub fn fleet_angle(axis: DVec3, outwards: DVec3) -> f64 {
    // By the tangent: an arcsine would lose half of the digits near a right angle.
    let along = axis.dot(outwards);
    along.atan2(axis.cross(outwards).length())
}
