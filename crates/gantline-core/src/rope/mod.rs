//! Geometry and material of ropes. Knows no catalogue.

pub mod coil;
pub mod curve;
pub mod guide;
pub mod light;
pub mod material;
pub mod part;
pub mod route;
pub mod seat;
pub mod tangency;
