//! Mechanics of ropes, trees of bodies, constraints and their solver.
//!
//! A [`spec`] document is [`build`]-ed into a [`system::System`], which does not change, and a
//! [`state::State`], which a [`stepper`] moves on; [`record`] keeps columns of numbers over time. Start
//! reading at [`stepper::del`]: the method on one page.

#![forbid(unsafe_code)]

pub mod audit;
pub mod build;
pub mod clock;
pub mod constraint;
pub mod contact;
pub mod event;
pub mod force;
pub mod hull;
pub mod plan;
pub mod record;
pub mod rope;
pub mod simulation;
pub mod solver;
pub mod spec;
pub mod state;
pub mod statics;
pub mod stepper;
pub mod system;
pub mod tree;

pub use simulation::Simulation;

// Tests through what the core shows to others, which is `gantline_core` to them. With the tests beside the
// code they are one program, for which the core is compiled once.
#[cfg(test)]
extern crate self as gantline_core;
#[cfg(test)]
#[path = "../tests/all.rs"]
mod shown;
