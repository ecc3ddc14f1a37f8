//! Operations as data: drives that follow ramps, steps that start and end on times and conditions.

pub mod condition;
pub mod cut;
pub mod drive;
pub mod operation;
pub mod removal;
pub mod switching;

pub use condition::{Condition, Falls, Seen};
pub use cut::{Cut, Due};
pub use drive::Order;
pub use operation::{Emergency, EmergencyStop, Move, Plan, PlanState, Step, StopAt, Until};
pub use removal::Removal;
pub use switching::Switching;
