//! Sparse factorisation in the rig's order, and the complementarity problem of a step.

pub mod balance;
pub mod brakes;
pub mod complementarity;
pub mod kkt;
pub mod layout;
pub mod ldl;
pub mod ldu;
pub mod order;
pub mod slots;
pub mod stiffness;
pub mod symbolic;
