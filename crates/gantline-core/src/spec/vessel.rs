//! Vessels: bodies that should stay upright, and points of them that should stay above the water.

use serde::Deserialize;

/// A vessel.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct VesselSpec {
    /// Unique name.
    pub name: String,
    /// Its body.
    pub body: String,
    /// Height of the water's surface [m].
    pub level: f64,
    /// Angle of its z axis from plumb beyond which it has capsized [rad].
    pub capsized_beyond: f64,
    /// Corners of the edge of its bottom [m], body frame.
    #[serde(default)]
    pub bottom: Vec<[f64; 3]>,
    /// What should stay above the water.
    #[serde(default)]
    pub marks: Vec<MarkSpec>,
}

/// Points of a vessel that should stay above the water.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MarkSpec {
    /// Unique name.
    pub name: String,
    /// The points [m], body frame.
    pub points: Vec<[f64; 3]>,
}
