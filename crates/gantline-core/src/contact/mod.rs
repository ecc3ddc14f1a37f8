//! Geometry of contact: planes, tops of supports, rims of round bodies, guides for landing, shapes of bodies and what of
//! them is near each other.

pub mod landing;
pub mod pad;
mod parted;
pub mod plane;
mod polygon;
pub mod rim;
pub mod shape;
mod spare;
pub mod spot;
