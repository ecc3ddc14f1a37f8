//! Operations as data: drives that follow ramps, steps that start and end on times and conditions.

pub mod condition;
pub mod course;
pub mod cut;
pub mod drive;
pub mod follow;
pub mod heave;
pub mod holes;
pub mod operation;
pub mod removal;
pub mod series;
pub mod step;
pub mod switching;

pub use condition::{Condition, Falls, Seen};
pub use course::soon;
pub use cut::{Cut, Due};
pub use drive::Order;
pub use follow::{Follow, Lead, Strand, Way};
pub use heave::Compensator;
pub use holes::{Hole, Holed};
pub use operation::PlanState;
pub use removal::Removal;
pub use series::Series;
pub use step::{DriveStop, Emergency, EmergencyStop, Leading, Move, Plan, Reel, Step, StopAt, Until};
pub use switching::Switching;
