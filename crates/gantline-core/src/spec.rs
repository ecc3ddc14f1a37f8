//! The document: what a system is, in words of mechanics, as it crosses the border.
//!
//! SI units, radians, z up. Bodies stand after their parents. Everything is checked by
//! [`crate::build`]; a document is private to gantline and never kept by users.

use serde::Deserialize;

/// A system of bodies, ropes, contacts, and the plan of its drives.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SystemSpec {
    /// Acceleration of gravity [m/s²], world axes.
    pub gravity: [f64; 3],
    /// Bodies, each after its parent.
    pub bodies: Vec<BodySpec>,
    /// Ropes.
    #[serde(default)]
    pub ropes: Vec<RopeSpec>,
    /// Points of bodies that may touch a plane.
    #[serde(default)]
    pub contacts: Vec<ContactSpec>,
    /// Groups of ropes whose lengths are adjusted to one tension.
    #[serde(default)]
    pub adjusters: Vec<AdjusterSpec>,
    /// Drives that prescribe joint motions.
    #[serde(default)]
    pub drives: Vec<DriveSpec>,
    /// Operations, one after another.
    #[serde(default)]
    pub plan: Vec<StepSpec>,
}

/// Position [m] and unit quaternion (w, x, y, z) of a frame in another.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlacementSpec {
    /// Origin [m].
    pub position: [f64; 3],
    /// Unit quaternion, w first.
    pub orientation: [f64; 4],
}

/// A rigid body and the joint by which it hangs on its parent.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BodySpec {
    /// Unique name.
    pub name: String,
    /// Name of the parent body; none is the world.
    pub parent: Option<String>,
    /// Where the joint sits in the parent's body frame.
    pub placement: PlacementSpec,
    /// The joint.
    pub joint: JointSpec,
    /// Mass [kg]; 0 is allowed where something heavy hangs on the body.
    pub mass: f64,
    /// Centre of gravity [m] in the body frame.
    pub centre_of_gravity: [f64; 3],
    /// Inertia [kg m²] about the centre of gravity in body axes: xx, yy, zz, xy, xz, yz.
    pub inertia: [f64; 6],
}

/// Joint types and the state they start in.
#[derive(Debug, Clone, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum JointSpec {
    /// No motion.
    Fixed {},
    /// Rotation about an axis.
    Hinge(AxisJointSpec),
    /// Translation along an axis.
    Slider(AxisJointSpec),
    /// Free rotation about a point.
    Ball {
        /// Unit quaternion, w first.
        orientation: [f64; 4],
        /// Angular velocity [rad/s], body axes.
        angular_velocity: [f64; 3],
    },
    /// Three translations, no rotation.
    Point {
        /// Position [m] in the joint frame.
        position: [f64; 3],
        /// Velocity [m/s] in the joint frame.
        velocity: [f64; 3],
    },
    /// Six degrees of freedom.
    Free {
        /// Position [m] in the joint frame.
        position: [f64; 3],
        /// Unit quaternion, w first.
        orientation: [f64; 4],
        /// Velocity [m/s] in the joint frame.
        velocity: [f64; 3],
        /// Angular velocity [rad/s], body axes.
        angular_velocity: [f64; 3],
    },
    /// Rope that passes a sheave or leaves a drum [m]; no body has this motion.
    Flow {
        /// Inertia of what turns over its radius squared [kg].
        inertia: f64,
        /// Start velocity [m/s]; what has passed counts from the start.
        #[serde(default)]
        velocity: f64,
        /// Viscous damping [N s/m].
        #[serde(default)]
        damping: f64,
        /// What a brake or dry friction holds [N].
        #[serde(default)]
        brake: f64,
        /// Largest force of the drive [N]; none prescribes the motion whatever it takes.
        #[serde(default)]
        capacity: Option<f64>,
        /// Largest power of the drive [W], with its capacity.
        #[serde(default)]
        power: Option<f64>,
        /// Name of the drive that prescribes this motion, or asks for it where it has a capacity.
        #[serde(default)]
        drive: Option<String>,
    },
}

impl JointSpec {
    /// Name of the drive that prescribes its motion, where it has one.
    pub fn drive(&self) -> Option<&String> {
        match self {
            Self::Hinge(AxisJointSpec { drive, .. })
            | Self::Slider(AxisJointSpec { drive, .. })
            | Self::Flow { drive, .. } => drive.as_ref(),
            _ => None,
        }
    }
}

/// A hinge or a slider.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AxisJointSpec {
    /// Axis in the joint frame; normalised when built.
    pub axis: [f64; 3],
    /// Start position [rad or m].
    #[serde(default)]
    pub position: f64,
    /// Start velocity [rad/s or m/s].
    #[serde(default)]
    pub velocity: f64,
    /// Viscous damping [N m s/rad or N s/m].
    #[serde(default)]
    pub damping: f64,
    /// Dry friction that holds it [N m or N].
    #[serde(default)]
    pub friction: f64,
    /// Name of the drive that prescribes this joint's motion.
    #[serde(default)]
    pub drive: Option<String>,
    /// Where its motion ends; without them nowhere.
    #[serde(default)]
    pub stops: Option<StopsSpec>,
    /// Whether its locking pin is in at the start; none has no pin.
    #[serde(default)]
    pub pin: Option<bool>,
}

/// Stops of a hinge or slider.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StopsSpec {
    /// Lowest position [rad or m].
    #[serde(default)]
    pub lower: Option<f64>,
    /// Highest position [rad or m].
    #[serde(default)]
    pub upper: Option<f64>,
    /// Stiffness of each stop [N m/rad or N/m].
    pub stiffness: f64,
    /// Damping over stiffness [s].
    #[serde(default)]
    pub damping_time: f64,
}

/// A rope: route, unstretched length, material.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RopeSpec {
    /// Unique name.
    pub name: String,
    /// Unstretched length [m], arcs included; none is just taut at the start.
    pub length: Option<f64>,
    /// What it is made of.
    pub material: MaterialSpec,
    /// Guides in order, from end to end.
    pub route: Vec<GuideSpec>,
    /// Tension [N] at which it breaks; none never does.
    #[serde(default)]
    pub breaking_force: Option<f64>,
    /// Time [s] at which it is cut.
    #[serde(default)]
    pub cut_at: Option<f64>,
}

/// Rope material.
#[derive(Debug, Clone, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum MaterialSpec {
    /// T = max(0, EA/L (e + τ ė)).
    Elastic {
        /// Axial stiffness EA [N].
        axial_stiffness: f64,
        /// Damping time τ [s].
        #[serde(default)]
        damping_time: f64,
    },
    /// No stretch at all; said in so many words.
    Inextensible {},
}

/// What a rope passes on its route.
#[derive(Debug, Clone, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum GuideSpec {
    /// A fixed end.
    End {
        /// Body that holds the end; none is the world.
        body: Option<String>,
        /// Point [m] in the body frame.
        at: [f64; 3],
        /// What pays rope out here.
        #[serde(default)]
        drum: Option<DrumSpec>,
    },
    /// A sheave as in the paper: two attachment points that stay fixed in the body, and half a turn of
    /// rope between them.
    HalfTurn {
        /// Body that carries the sheave; none is the world.
        body: Option<String>,
        /// Where the rope arrives [m], body frame.
        enter: [f64; 3],
        /// Where the rope goes on [m], body frame.
        leave: [f64; 3],
        /// Unit vector, body frame, to the side on which the rope lies on the sheave.
        bulge: [f64; 3],
        /// Name of the flow of rope over the sheave, towards the end of the route; none passes tension on as it is.
        #[serde(default)]
        flow: Option<String>,
        /// Largest ratio of the tensions on both sides that its bearing holds, 1 without losses; only with a flow.
        #[serde(default = "one")]
        ratio: f64,
        /// What its groove holds; none is all.
        #[serde(default)]
        groove: Option<GrooveSpec>,
    },
    /// A sheave with true tangents and the wrap that results.
    Sheave {
        /// Body that carries the sheave; none is the world.
        body: Option<String>,
        /// Its centre [m], body frame.
        at: [f64; 3],
        /// Its axis, body frame; the rope runs about it, right-handed. Normalised when built.
        axis: [f64; 3],
        /// Radius of the rope's centre line [m].
        radius: f64,
        /// True where the rope may leave it and run straight past; else leaving it is an event and no more.
        #[serde(default)]
        may_lift_off: bool,
        /// Name of the flow of rope over the sheave, as of half a turn.
        #[serde(default)]
        flow: Option<String>,
        /// Largest ratio of the tensions on both sides that its bearing holds, as of half a turn.
        #[serde(default = "one")]
        ratio: f64,
        /// What its groove holds; none is all.
        #[serde(default)]
        groove: Option<GrooveSpec>,
    },
    /// An eye or a shackle: a point that the rope slides through without friction.
    Eye {
        /// Body that it belongs to; none is the world.
        body: Option<String>,
        /// Point [m] in the body frame.
        at: [f64; 3],
    },
}

/// A groove in which the rope slips.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GrooveSpec {
    /// Coefficient of friction between rope and sheave.
    pub friction: f64,
    /// Name of the flow that stands for the spin of the sheave, radius times angle; none is a sheave that does not
    /// turn.
    #[serde(default)]
    pub spin: Option<String>,
}

/// A drum, or whatever pays out rope at an end.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DrumSpec {
    /// Name of its flow.
    pub flow: String,
    /// Rope paid out per unit of that flow in the first layer, negative where it winds up.
    pub rate: f64,
    /// Tension with which the rope on it was wound before the start [N]; none is the tension at the start.
    #[serde(default)]
    pub laid_under: Option<f64>,
    /// Layers; none is one layer without end.
    #[serde(default)]
    pub layers: Option<LayersSpec>,
}

/// Layers of rope on a drum.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LayersSpec {
    /// Pitch radius of the first [m].
    pub radius: f64,
    /// By how much every further radius is larger [m].
    pub step: f64,
    /// Turns in a full layer.
    pub turns: f64,
    /// Turns on the drum at the start.
    pub start: f64,
}

/// After every step the ropes of a group take over length from each other: see [`crate::stepper::adjust`].
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct AdjusterSpec {
    /// Unique name.
    pub name: String,
    /// Names of its ropes, at least two, each in one group only.
    pub ropes: Vec<String>,
    /// Share of a tension's distance from the mean that one step lets go.
    pub factor: f64,
}

/// A point of a body that may touch a plane of the world.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ContactSpec {
    /// Unique name.
    pub name: String,
    /// Contacts of one group carry one load together.
    pub group: String,
    /// Body with the point.
    pub body: String,
    /// Point [m] in the body frame.
    pub at: [f64; 3],
    /// A point of the plane [m], world axes.
    pub plane_point: [f64; 3],
    /// Normal of the plane, towards the free side; normalised when built.
    pub plane_normal: [f64; 3],
    /// Normal and tangential stiffness [N/m].
    pub stiffness: f64,
    /// Damping over stiffness [s].
    pub damping_time: f64,
    /// Coefficient of Coulomb friction.
    pub friction: f64,
}

/// A drive: the prescribed motion of one joint.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DriveSpec {
    /// Unique name.
    pub name: String,
    /// Ramps that are known in advance, in order of time.
    #[serde(default)]
    pub ramps: Vec<RampSpec>,
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
    /// What ends the step.
    pub until: UntilSpec,
    /// Names of ropes that are cut as it begins.
    #[serde(default)]
    pub cuts: Vec<String>,
    /// Names of bodies whose pins are pulled as it begins.
    #[serde(default)]
    pub pulls: Vec<String>,
    /// Names of bodies whose pins are put in as it begins.
    #[serde(default)]
    pub pins: Vec<String>,
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
    /// A step that ends by an emergency stop.
    #[serde(default)]
    pub emergency: Option<EmergencySpec>,
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
    /// No contact of the group carries any more.
    Clear {
        /// Contact group.
        group: String,
    },
    /// Lasts until the run ends.
    EndOfRun {},
}

/// How a system is run.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SettingsSpec {
    /// The method.
    pub integrator: IntegratorSpec,
    /// Simulated time [s].
    pub duration: f64,
    /// Time between samples of the recording [s].
    pub sample_interval: f64,
    /// Where it starts from.
    #[serde(default)]
    pub start: StartSpec,
}

/// Where a run starts from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StartSpec {
    /// The positions and velocities of the document.
    #[default]
    AsGiven,
    /// The equilibrium downhill of its positions.
    Rest,
}

/// Integrators.
#[derive(Debug, Clone, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum IntegratorSpec {
    /// Error-controlled steps of high order.
    Adaptive {
        /// Error of rope tensions allowed in a step [N]; none is a share of the weight per rope.
        #[serde(default)]
        tension_tolerance: Option<f64>,
        /// Error of positions allowed in a step [m]; none is the default.
        #[serde(default)]
        position_tolerance: Option<f64>,
    },
    /// Discrete Euler–Lagrange, fixed step.
    Del {
        /// Step h [s].
        step: f64,
        /// Bare eq. (15): no geometric stiffness.
        #[serde(default)]
        paper: bool,
        /// Geometric stiffness of taut ropes in the tangent.
        #[serde(default = "yes")]
        geometric_stiffness: bool,
    },
    /// Semi-implicit Euler, fixed step: a baseline.
    Explicit {
        /// Step h [s].
        step: f64,
    },
}

fn one() -> f64 {
    1.0
}

fn yes() -> bool {
    true
}
