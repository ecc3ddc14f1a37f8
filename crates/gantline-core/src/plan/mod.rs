//! Operations as data: drives that follow ramps, steps that start and end on times and conditions.

pub mod condition;
pub mod cut;
pub mod drive;
pub mod operation;
pub mod pinning;
pub mod removal;

pub use condition::{Condition, Falls, Seen};
pub use cut::{Cut, Due};
pub use drive::Order;
pub use operation::{Emergency, EmergencyStop, Move, Plan, PlanState, Step, StopAt, Until};
pub use pinning::Pinning;
pub use removal::Removal;
