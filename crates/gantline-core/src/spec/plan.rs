//! Drives and the plan.

use serde::Deserialize;

use super::TrainsSpec;
use super::rope::LayersSpec;

/// A drive: the prescribed motion of one joint.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DriveSpec {
    /// Unique name.
    pub name: String,
    /// Ramps that are known in advance, in order of time.
    #[serde(default)]
    pub ramps: Vec<RampSpec>,
    /// What waves add to that at the origin [m or rad].
    #[serde(default)]
    pub waves: Option<TrainsSpec>,
}

/// From `at` on, within `duration`, the velocity goes to `velocity`.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RampSpec {
    /// Start [s].
    pub at: f64,
    /// Duration [s].
    pub duration: f64,
    /// Velocity at the end [m/s or rad/s].
    pub velocity: f64,
    /// How the velocity gets there.
    #[serde(default)]
    pub shape: RampShape,
}

/// Course of the velocity in a ramp.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum RampShape {
    /// Constant acceleration.
    #[default]
    Linear,
    /// Acceleration rises from zero and falls back to zero (cubic velocity).
    Smooth,
}

/// A step of the plan.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StepSpec {
    /// Name, shown in events.
    pub name: String,
    /// Drives that move; none holds.
    #[serde(default)]
    pub moves: Vec<MoveSpec>,
    /// Earliest time [s].
    #[serde(default)]
    pub start_at: Option<f64>,
    /// Begins as the step before begins, not as it ends.
    #[serde(default)]
    pub with_previous: bool,
    /// What ends the step.
    pub until: UntilSpec,
    /// Names of ropes that are cut as it begins.
    #[serde(default)]
    pub cuts: Vec<String>,
    /// Names of ropes that are taken off as it begins, slack or not.
    #[serde(default)]
    pub detaches: Vec<String>,
    /// Names of ropes that are put on as it begins. One that has not been taken off before is not on until then.
    #[serde(default)]
    pub attaches: Vec<String>,
    /// Names of supports that are taken away as it begins.
    #[serde(default)]
    pub removes: Vec<String>,
    /// Names of bodies whose pins are pulled as it begins.
    #[serde(default)]
    pub pulls: Vec<String>,
    /// Names of bodies whose pins are put in as it begins.
    #[serde(default)]
    pub pins: Vec<String>,
    /// What compensates heave while it goes on.
    #[serde(default)]
    pub compensates: Vec<CompensationSpec>,
}

/// What compensates heave in a step.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CompensationSpec {
    /// Name of the compensator.
    pub compensator: String,
    /// The body against whose deck, its own x and y axes; none is the ground.
    #[serde(default)]
    pub against: Option<String>,
}

/// A hoist that can compensate heave.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CompensatorSpec {
    /// Unique name.
    pub name: String,
    /// Name of the drive of the hoist.
    pub drive: String,
    /// Name of the body whose motion it senses.
    pub vessel: String,
    /// From where its falls hang.
    pub head: PlaceSpec,
    /// The most that it adds to the speed of the hook [m/s].
    pub velocity: f64,
    /// And to its acceleration [m/s²].
    pub acceleration: f64,
    /// How far it moves the hook, half of that up and half down [m]; none is without end.
    #[serde(default)]
    pub stroke: Option<f64>,
    /// Time of the high-pass filter [s].
    pub filter: f64,
    /// Of a drive that counts the rope on the first layer of its drum.
    #[serde(default)]
    pub reel: Option<ReelSpec>,
}

/// One drive in a step.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MoveSpec {
    /// Name of the drive.
    pub drive: String,
    /// Signed velocity [m/s or rad/s].
    pub velocity: f64,
    /// Acceleration limit [m/s² or rad/s²].
    pub acceleration: f64,
    /// Course of the ramps.
    #[serde(default)]
    pub shape: RampShape,
    /// Least and largest position [kg; m of one that follows]: at the first that a drive of the step reaches all stop, whatever it waits for.
    #[serde(default)]
    pub range: Option<[f64; 2]>,
    /// A step that ends by an emergency stop.
    #[serde(default)]
    pub emergency: Option<EmergencySpec>,
    /// Of a drive that counts the rope on the first layer of its drum: what distances and positions of the step are of.
    #[serde(default)]
    pub reel: Option<ReelSpec>,
}

/// A drum with layers, of which a drive counts the rope on the first one.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ReelSpec {
    /// Rope of the first layer that is wound up per unit of the drive.
    pub rate: f64,
    /// Its layers.
    pub layers: LayersSpec,
}

/// An emergency stop of a drive.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EmergencySpec {
    /// Acceleration with which it is asked to stop [m/s² or rad/s²].
    pub acceleration: f64,
    /// What the brake holds from then on, until the drive moves again [N]; none is the motor's capacity.
    #[serde(default)]
    pub brake: Option<f64>,
}

/// What ends a step; moving drives then brake to rest.
#[derive(Debug, Clone, PartialEq, Deserialize, serde::Serialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum UntilSpec {
    /// Brakes from this time [s] on.
    BrakeFrom {
        /// Time [s].
        time: f64,
    },
    /// At rest after this signed distance [m or rad].
    Distance {
        /// Distance [m or rad].
        distance: f64,
    },
    /// At rest after so much, each drive in the direction of its velocity.
    Along {
        /// How much [kg].
        distance: f64,
    },
    /// At rest where each drive, in the order of the moves, has this position [m or rad].
    Position {
        /// Positions [m or rad].
        positions: Vec<f64>,
    },
    /// Brakes after this time [s] in the step.
    Duration {
        /// Duration [s].
        duration: f64,
    },
    /// The contacts of a group have lost this share of the weight.
    LoadTransferred {
        /// Contact group.
        group: String,
        /// Weight [N].
        weight: f64,
        /// Share, 0 to 1.
        at_least: f64,
    },
    /// They bear again what leaves no more than this share transferred.
    LoadReturned {
        /// Contact group.
        group: String,
        /// Weight [N].
        weight: f64,
        /// Share, 0 to 1.
        at_most: f64,
    },
    /// The tensions of some segments of rope together have reached a bound.
    TensionAbove {
        /// Rope and number of the segment along it.
        segments: Vec<(String, usize)>,
        /// Bound [N].
        bound: f64,
    },
    /// They have come down to a bound.
    TensionBelow {
        /// Rope and number of the segment along it.
        segments: Vec<(String, usize)>,
        /// Bound [N].
        bound: f64,
    },
    /// All falls hang within an angle of plumb.
    Plumb {
        /// Bodies and points in their frames [m], where each hangs from and what hangs there.
        falls: Vec<[PlaceSpec; 2]>,
        /// The angle [rad].
        at_most: f64,
    },
    /// In every group of ropes (max - min)/mean of their tensions is no more than a share, and all carry.
    Spread {
        /// Names of ropes.
        groups: Vec<Vec<String>>,
        /// Share.
        at_most: f64,
    },
    /// A contact of the group carries.
    Touched {
        /// Contact group.
        group: String,
    },
    /// No contact of the group carries any more.
    Clear {
        /// Contact group.
        group: String,
    },
    /// A body that moves freely is heeled, trimmed or tilted less, or more, than a bound.
    Attitude {
        /// The body.
        body: String,
        /// Which angle.
        angle: AttitudeSpec,
        /// True for more.
        above: bool,
        /// Bound [rad].
        bound: f64,
    },
    /// Its drives, which move alike, go along with hooks so that their falls stay plumb, until all that begins with the
    /// step has ended; velocity and acceleration of its moves are limits.
    Follow {
        /// How the first of them takes its hooks along.
        way: WaySpec,
        /// Time between looks [s].
        every: f64,
        /// How many glances a look is the mean of: what swings faster than it looks takes it no way then.
        glances: u32,
        /// Hooks that the drive moves.
        own: Vec<LeadSpec>,
        /// The other hooks of the load.
        others: Vec<LeadSpec>,
    },
    /// Its drives go a way together, and are at rest at its end; velocity and acceleration of its moves mean nothing.
    Leading {
        /// Highest rate of the share of the way that they have gone [1/s].
        rate: f64,
        /// Its acceleration [1/s²].
        acceleration: f64,
        /// What each drive does over that share, in the order of the moves: coefficients of Chebyshev polynomials from the
        /// beginning, -1, to the end, 1 [m or rad].
        series: Vec<Vec<f64>>,
    },
    /// Lasts until the run ends.
    EndOfRun {},
}

/// A body, and a point in its frame [m].
pub type PlaceSpec = (String, [f64; 3]);

/// How a drive takes hooks along.
#[derive(Debug, Clone, PartialEq, Deserialize, serde::Serialize)]
#[serde(deny_unknown_fields)]
pub struct WaySpec {
    /// Where they hang from what it moves, in the middle of them.
    pub carried: PlaceSpec,
    /// Of a body that hangs in tackles, whose drum the drive turns.
    pub tackles: Option<TacklesSpec>,
}

/// Tackles that turn a body about its hinge.
#[derive(Debug, Clone, PartialEq, Deserialize, serde::Serialize)]
#[serde(deny_unknown_fields)]
pub struct TacklesSpec {
    /// The body.
    pub turns: String,
    /// From where they pull; the drive counts by how much they get shorter.
    pub top: PlaceSpec,
    /// Where they pull at the body.
    pub head: PlaceSpec,
}

/// A hook, with what hangs under it.
#[derive(Debug, Clone, PartialEq, Deserialize, serde::Serialize)]
#[serde(deny_unknown_fields)]
pub struct LeadSpec {
    /// From where its falls hang, or itself where nothing lets it go aside.
    pub tip: PlaceSpec,
    /// The hook.
    pub hook: PlaceSpec,
    /// Slings under it; then those under what they hold, down to the load.
    pub levels: Vec<Vec<StrandSpec>>,
}

/// A sling as it pulls what hangs below it.
#[derive(Debug, Clone, PartialEq, Deserialize, serde::Serialize)]
#[serde(deny_unknown_fields)]
pub struct StrandSpec {
    /// Name of the rope.
    pub rope: String,
    /// Upper end.
    pub upper: PlaceSpec,
    /// Lower ends: one, or two where it runs over a sheave.
    pub lower: Vec<PlaceSpec>,
}

/// An angle of a body that moves freely.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum AttitudeSpec {
    /// How far its y axis points upwards: to starboard positive.
    Heel,
    /// How far its x axis points upwards: by the stern positive.
    Trim,
    /// Between its z axis and plumb, 0 to π.
    Tilt,
}

/// An emergency stop of everything that the plan drives; no step begins or goes on after it.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EmergencyStopSpec {
    /// When.
    pub at: StopAtSpec,
    /// How each drive is stopped.
    pub drives: Vec<DriveStopSpec>,
}

/// When all drives are stopped.
#[derive(Debug, Clone, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum StopAtSpec {
    /// At a time.
    Time {
        /// Time [s].
        time: f64,
    },
    /// After a step has begun.
    InStep {
        /// Number of the step, from 0.
        step: usize,
        /// How long after that [s].
        after: f64,
    },
}

/// A drive and its emergency stop.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DriveStopSpec {
    /// Name of the drive.
    pub drive: String,
    /// How it is stopped.
    pub stop: EmergencySpec,
    /// Number of the step, from 0, from whose beginning on it is stopped so: what comes last counts.
    #[serde(default)]
    pub step: usize,
}

/// What a program asks for while a run stands still.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CommandSpec {
    /// What moves, in the words of the plan.
    pub name: String,
    /// How, in the words of the plan.
    pub motion: String,
    /// Signed speed, in the words of the plan [m/s or rad/s].
    pub speed: f64,
    /// Acceleration limit, likewise [m/s² or rad/s²].
    pub acceleration: f64,
    /// What that is for each drive.
    pub orders: Vec<OrderSpec>,
}

/// What it is for one drive.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OrderSpec {
    /// Name of the drive.
    pub drive: String,
    /// Signed velocity [m/s or rad/s].
    pub velocity: f64,
    /// Acceleration limit [m/s² or rad/s²].
    pub acceleration: f64,
    /// Acceleration with which it stops at an end of its range [m/s² or rad/s²].
    pub braking: f64,
    /// Least and largest position [m or rad]; none without limit.
    pub range: [Option<f64>; 2],
    /// How it stops in an emergency.
    pub emergency: EmergencySpec,
}
