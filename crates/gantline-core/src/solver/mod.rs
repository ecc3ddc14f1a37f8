//! Sparse factorisation in the rig's order, and the complementarity problem of a step.

pub mod complementarity;
pub mod kkt;
pub mod ldl;
pub mod order;
pub mod stiffness;
