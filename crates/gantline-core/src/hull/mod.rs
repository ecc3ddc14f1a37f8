//! Hulls: closed meshes cut by a plane, and integrals over what lies below it. Geometry only.

pub mod immersion;
pub mod mesh;
pub mod panel;
pub mod surface;

pub use immersion::{Hull, Immersion};
pub use mesh::{Closure, Mesh};
pub use panel::Plane;
pub use surface::Surface;
