//! Geometry of contact: planes now, meshes later.

pub mod plane;
