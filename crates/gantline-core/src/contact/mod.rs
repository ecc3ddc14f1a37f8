//! Geometry of contact: planes, tops of supports, shapes of bodies and what of them is near each other.

pub mod pad;
pub mod plane;
pub mod shape;
pub mod spot;
