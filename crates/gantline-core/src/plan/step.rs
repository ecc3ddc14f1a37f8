//! Steps of a plan as data: which drives move, and what ends them.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::condition::Condition;
use super::follow::Follow;
use super::heave::Compensator;
use super::holes::Holed;
use super::series::Series;
use crate::rope::coil::Layers;
use crate::spec::RampShape;

/// One drive in a step.
#[derive(Debug, Clone, PartialEq)]
pub struct Move {
    /// Index of the drive.
    pub drive: usize,
    /// Signed velocity [m/s or rad/s].
    pub velocity: f64,
    /// Acceleration limit [m/s² or rad/s²].
    pub acceleration: f64,
    /// Course of the ramps.
    pub shape: RampShape,
    /// Positions beyond which it does not go [kg; m or rad of one that follows].
    pub range: Option<[f64; 2]>,
    /// Acceleration with which it brakes at the end, where that is another, and what holds it from then on [N].
    pub emergency: Option<Emergency>,
    /// What goes farther than the drive counts, since its rope lies on a drum in layers.
    pub reel: Option<Reel>,
    /// Which of the positions of the system it moves, where motor or brake may have let that slip.
    pub slips: Option<usize>,
}

/// A drum with layers, of which a drive counts the rope on the first one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reel {
    /// Rope of the first layer that is wound up per unit of the drive.
    pub rate: f64,
    /// Its layers.
    pub layers: Layers,
}

impl Reel {
    /// How far what it moves has gone since the start, where the drive is at `position` [m].
    pub fn gone(&self, position: f64) -> f64 {
        self.layers.wound(self.rate * position) / self.rate
    }

    /// How fast that goes for each m/s of the drive, there.
    pub fn ratio(&self, position: f64) -> f64 {
        self.layers.ratio(self.rate * position)
    }

    /// Where the drive is when what it moves has gone so far since the start [m].
    pub fn position(&self, gone: f64) -> f64 {
        self.layers.turned_at(self.rate * gone) / self.rate
    }
}

/// How a drive is stopped in an emergency.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Emergency {
    /// With which it is asked to stop [m/s² or rad/s²].
    pub acceleration: f64,
    /// What the brake holds [N]; none is the motor's capacity.
    pub brake: Option<f64>,
}

/// What ends a step; drives then brake to rest.
#[derive(Debug, Clone, PartialEq)]
pub enum Until {
    /// Brakes from this time [s] on.
    BrakeFrom(f64),
    /// At rest after this signed distance [m or rad].
    Distance(f64),
    /// At rest after so much, each drive in the direction of its velocity [kg].
    Along(f64),
    /// At rest where each drive, in the order of the moves, has this position [m or rad].
    Positions(Vec<f64>),
    /// Brakes after this time [s] in the step.
    Duration(f64),
    /// Brakes when this first holds.
    Condition(Condition),
    /// Follows until all that begins with it has ended. Velocity and acceleration of its moves, all alike, are limits.
    Follow(Follow),
    /// At the end of a way that its drives go together.
    Leading(Leading),
    /// Never.
    EndOfRun,
}

/// A way that drives go together, each as its own function of the share σ of it that they have gone.
#[derive(Debug, Clone, PartialEq)]
pub struct Leading {
    /// Highest rate of σ [1/s].
    pub rate: f64,
    /// Acceleration of σ [1/s²].
    pub acceleration: f64,
    /// What each drive does, in the order of the moves.
    pub series: Vec<Arc<Series>>,
}

/// A step of the plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// Name, shown in events.
    pub name: String,
    /// Drives that move; none holds.
    pub moves: Vec<Move>,
    /// Earliest time [s].
    pub start_at: Option<f64>,
    /// Begins as the step before begins, not as it ends.
    pub with_previous: bool,
    /// What ends it.
    pub until: Until,
    /// Compensators that work while it goes on, and the body against whose deck; none is the ground.
    pub compensates: Vec<(usize, Option<usize>)>,
}

/// When all drives are stopped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StopAt {
    /// At this time [s].
    Time(f64),
    /// So long [s] after a step has begun.
    InStep(usize, f64),
}

/// How an emergency stop of everything stops one drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DriveStop {
    /// The drive.
    pub drive: usize,
    /// How.
    pub how: Emergency,
    /// From the beginning of this step on; the first is from the start of the run.
    pub step: usize,
}

/// An emergency stop of everything that the plan drives.
#[derive(Debug, Clone, PartialEq)]
pub struct EmergencyStop {
    /// When.
    pub at: StopAt,
    /// Drives that it stops, and how.
    pub drives: Vec<DriveStop>,
}

/// Steps in order, and what ends them all.
#[derive(Debug, Clone)]
pub struct Plan {
    /// The steps.
    pub steps: Vec<Step>,
    /// What can compensate heave.
    pub compensators: Vec<Compensator>,
    /// Tanks with holes.
    pub holed: Vec<Holed>,
    /// An emergency stop, if there is one.
    pub stop: Option<EmergencyStop>,
}
