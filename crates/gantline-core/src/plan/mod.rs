//! Operations as data: drives that follow ramps, steps that start and end on times and conditions.

pub mod condition;
pub mod cut;
pub mod drive;
pub mod follow;
pub mod operation;
pub mod removal;
pub mod step;
pub mod switching;

pub use condition::{Condition, Falls, Seen};
pub use cut::{Cut, Due};
pub use drive::{Order, soon};
pub use follow::{Follow, Lead, Strand, Way};
pub use operation::PlanState;
pub use removal::Removal;
pub use step::{DriveStop, Emergency, EmergencyStop, Move, Plan, Reel, Step, StopAt, Until};
pub use switching::Switching;
