//! All tests of the core through what it shows to others: a module of the library where that is tested, see its
//! `lib.rs`.

mod allocation;
mod coils;
mod exactly_touching;
mod hull;
mod level_mass;
mod light;
mod lying_on_a_line;
mod mechanics;
mod memory;
mod parallel_boxes;
mod parting;
mod rigs;
mod routes;
mod slinging;
mod solver;
mod statics;
mod tangency;
mod torture;
mod torture_found;
mod touching;
mod water;
mod wave_motion;
