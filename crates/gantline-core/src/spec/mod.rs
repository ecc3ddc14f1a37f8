//! The document: what a system is, in words of mechanics, as it crosses the border.
//!
//! SI units, radians, z up. Bodies stand after their parents. Everything is checked by
//! [`crate::build`]; a document is private to gantline and never kept by users.

mod contact;
mod force;
mod plan;
mod rope;
mod settings;
mod vessel;

use serde::Deserialize;

pub use contact::*;
pub use force::*;
pub use plan::*;
pub use rope::*;
pub use settings::*;
pub use vessel::*;

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
    /// Supports under bodies.
    #[serde(default)]
    pub supports: Vec<SupportSpec>,
    /// Rims of round bodies over planes of the world.
    #[serde(default)]
    pub rims: Vec<RimSpec>,
    /// Shapes of bodies and of the world.
    #[serde(default)]
    pub shapes: Vec<ShapeSpec>,
    /// Pairs of shapes that may touch.
    #[serde(default)]
    pub pairs: Vec<PairSpec>,
    /// Landing guides: posts and walls that guide what lands.
    #[serde(default)]
    pub landings: Vec<LandingSpec>,
    /// Distances that are recorded.
    #[serde(default)]
    pub watches: Vec<WatchSpec>,
    /// Groups of ropes, or of pins, of which it is recorded when they bear most together.
    #[serde(default)]
    pub pulls: Vec<PullSpec>,
    /// Forces of the water on bodies.
    #[serde(default)]
    pub forces: Vec<ForceSpec>,
    /// Waves on the water, which forces of waves come from.
    #[serde(default)]
    pub sea: Option<TrainsSpec>,
    /// Gusts of the wind, on top of its mean speed.
    #[serde(default)]
    pub gusts: Option<TrainsSpec>,
    /// Vessels, for what may happen to them.
    #[serde(default)]
    pub vessels: Vec<VesselSpec>,
    /// Groups of ropes whose lengths are adjusted to one tension.
    #[serde(default)]
    pub adjusters: Vec<AdjusterSpec>,
    /// Drives that prescribe joint motions.
    #[serde(default)]
    pub drives: Vec<DriveSpec>,
    /// Hoists that can compensate heave.
    #[serde(default)]
    pub compensators: Vec<CompensatorSpec>,
    /// Operations, one after another.
    #[serde(default)]
    pub plan: Vec<StepSpec>,
    /// An emergency stop of what the plan drives.
    #[serde(default)]
    pub emergency_stop: Option<EmergencyStopSpec>,
}

impl SystemSpec {
    /// Mooring lines among the forces.
    pub fn moorings(&self) -> impl Iterator<Item = &MooringSpec> {
        self.forces.iter().filter_map(|force| match force {
            ForceSpec::Mooring(line) => Some(&**line),
            _ => None,
        })
    }
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
        /// True of a motor with a capacity that hauls as long as its rope pulls less: at rest the rope pulls as much.
        #[serde(default)]
        keeps_pull: bool,
        /// Name of the drive that prescribes this motion, or asks for it where it has a capacity.
        #[serde(default)]
        drive: Option<String>,
    },
    /// What has been pumped into a tank of the parent since the start [kg]; no body has this motion.
    Content {
        /// Name of the drive that pumps.
        drive: String,
    },
}

impl JointSpec {
    /// What it says of its axis, where it has one by which a drive, stops, a pin and friction hold a body.
    pub fn axis(&self) -> Option<&AxisJointSpec> {
        match self {
            Self::Hinge(joint) | Self::Slider(joint) => Some(joint),
            Self::Fixed {}
            | Self::Ball { .. }
            | Self::Point { .. }
            | Self::Free { .. }
            | Self::Flow { .. }
            | Self::Content { .. } => None,
        }
    }

    /// Name of the drive that prescribes its motion, where it has one.
    pub fn drive(&self) -> Option<&String> {
        match self {
            Self::Flow { drive, .. } => drive.as_ref(),
            Self::Content { drive } => Some(drive),
            _ => self.axis()?.drive.as_ref(),
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
    /// Whether the joint may start beyond a stop, which pushes from then on: a spring.
    #[serde(default)]
    pub loaded: bool,
}

/// A point of a body that may touch a plane of the world or of another body.
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
    /// Body with the plane; none is the world.
    #[serde(default)]
    pub plane_body: Option<String>,
    /// A point of the plane [m], in the axes of its body.
    pub plane_point: [f64; 3],
    /// Normal of the plane there, towards the free side; normalised when built.
    pub plane_normal: [f64; 3],
    /// Normal and tangential stiffness [N/m].
    pub stiffness: f64,
    /// Damping over stiffness [s].
    pub damping_time: f64,
    /// Coefficient of Coulomb friction.
    pub friction: f64,
}
