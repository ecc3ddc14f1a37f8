//! Supports, shapes of bodies, which of them touch, and which distances are recorded.

use serde::Deserialize;

/// A part of a shape, in the frame of its body.
#[derive(Debug, Clone, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum PartSpec {
    /// A box.
    Box {
        /// Its three sides [m].
        size: [f64; 3],
        /// Its middle [m].
        #[serde(default)]
        centre: [f64; 3],
        /// How its axes are turned, unit quaternion, w first.
        #[serde(default = "straight")]
        orientation: [f64; 4],
    },
    /// The convex hull of points.
    Convex {
        /// Points [m].
        vertices: Vec<[f64; 3]>,
    },
    /// A skin of triangles.
    Mesh {
        /// Points [m].
        vertices: Vec<[f64; 3]>,
        /// Numbers of the three corners of each triangle.
        triangles: Vec<[u32; 3]>,
    },
}

/// A shape on a body or the world.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ShapeSpec {
    /// Unique name.
    pub name: String,
    /// Name of the body; none is the world.
    pub body: Option<String>,
    /// Its parts.
    pub parts: Vec<PartSpec>,
}

/// A support: a flat top of the world under the flat underside of a body.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SupportSpec {
    /// Unique name, in one set with contacts.
    pub name: String,
    /// Group of contacts that carry one load together.
    pub group: String,
    /// The body that may lie on it.
    pub body: String,
    /// Middle of the top [m], world axes.
    pub at: [f64; 3],
    /// Half of the two sides of the top [m].
    pub half: [f64; 2],
    /// Direction of the first side, world axes; the top is level.
    pub along: [f64; 3],
    /// Sides of the body that may lie on it, the corners of each in order [m], body frame: convex, in one plane and
    /// anticlockwise as seen from outside; sides of one convex body.
    pub sides: Vec<Vec<[f64; 3]>>,
    /// Normal and tangential stiffness [N/m].
    pub stiffness: f64,
    /// Damping over stiffness [s].
    pub damping_time: f64,
    /// Coefficient of Coulomb friction.
    pub friction: f64,
    /// Time [s] at which it is taken away.
    #[serde(default)]
    pub removed_at: Option<f64>,
}

/// A rim of a round body that may touch a plane of the world.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RimSpec {
    /// Unique name, in one set with contacts.
    pub name: String,
    /// Group of contacts that carry one load together.
    pub group: String,
    /// The body.
    pub body: String,
    /// Middle of the circle [m], body frame.
    pub at: [f64; 3],
    /// Normal of the circle, body frame; normalised when built.
    pub axis: [f64; 3],
    /// Its radius [m].
    pub radius: f64,
    /// A point of the plane [m].
    pub plane_point: [f64; 3],
    /// Normal of the plane towards the free side; normalised when built.
    pub plane_normal: [f64; 3],
    /// Normal and tangential stiffness [N/m].
    pub stiffness: f64,
    /// Damping over stiffness [s].
    pub damping_time: f64,
    /// Coefficient of Coulomb friction.
    pub friction: f64,
}

/// Two shapes that may touch.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PairSpec {
    /// Unique name, in one set with contacts: its places are called `<name>/1`, `<name>/2`, …
    pub name: String,
    /// Group of contacts that carry one load together.
    pub group: String,
    /// Names of the shapes.
    pub shapes: [String; 2],
    /// Normal and tangential stiffness of each place [N/m].
    pub stiffness: f64,
    /// Damping over stiffness [s].
    pub damping_time: f64,
    /// Coefficient of Coulomb friction.
    pub friction: f64,
    /// How many places at most touch at a time.
    #[serde(default = "places")]
    pub places: usize,
}

/// A round post on a body or the world.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PostSpec {
    /// Name of the body; none is the world.
    pub body: Option<String>,
    /// Where its axis begins [m], body frame.
    pub base: [f64; 3],
    /// Direction of its axis, towards its tip.
    pub axis: [f64; 3],
    /// Its radius [m].
    pub radius: f64,
    /// From the base to where its cone begins [m].
    pub height: f64,
    /// Length of the cone along the axis [m]; 0 without one.
    #[serde(default)]
    pub cone: f64,
    /// Radius of the tip of the cone [m].
    #[serde(default)]
    pub tip_radius: f64,
}

/// A wall on a body or the world that a post runs along.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WallSpec {
    /// Name of the body; none is the world.
    pub body: Option<String>,
    /// Middle of the edge from which on it leans away [m], body frame.
    pub knee: [f64; 3],
    /// Direction out of its upright face, towards the post.
    pub normal: [f64; 3],
    /// Direction in that face, across the knee and away from the flare.
    pub up: [f64; 3],
    /// Length of the upright face [m].
    pub height: f64,
    /// Its breadth along the knee [m].
    pub breadth: f64,
    /// Length of the flare [m]; 0 without one.
    #[serde(default)]
    pub flare: f64,
    /// By how much the flare leans away [rad].
    #[serde(default)]
    pub angle: f64,
}

/// A landing guide: a post and a wall that guide each other.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LandingSpec {
    /// Unique name, in one set with contacts: its places are called `<name>/1` and `<name>/2`.
    pub name: String,
    /// Group of contacts that carry together.
    pub group: String,
    /// The post.
    pub post: PostSpec,
    /// The wall.
    pub wall: WallSpec,
    /// Normal and tangential stiffness of each place [N/m].
    pub stiffness: f64,
    /// Damping over stiffness [s].
    pub damping_time: f64,
    /// Coefficient of Coulomb friction.
    pub friction: f64,
}

/// A distance that is recorded: the smallest between any of the first and any of the second.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WatchSpec {
    /// Unique name.
    pub name: String,
    /// Between what.
    pub between: [WatchedSpec; 2],
}

/// Shapes and ropes from which a distance is measured.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WatchedSpec {
    /// Names of shapes.
    #[serde(default)]
    pub shapes: Vec<String>,
    /// Ropes.
    #[serde(default)]
    pub ropes: Vec<WatchedRopeSpec>,
}

/// A rope from which a distance is measured, by its straight parts.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WatchedRopeSpec {
    /// Its name.
    pub rope: String,
    /// Half its diameter [m].
    #[serde(default)]
    pub radius: f64,
    /// What of it is left out at its two ends [m].
    #[serde(default)]
    pub without: [f64; 2],
}

fn straight() -> [f64; 4] {
    [1.0, 0.0, 0.0, 0.0]
}

fn places() -> usize {
    8
}
