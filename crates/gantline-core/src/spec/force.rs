//! Forces on bodies: of water and wind, and of lines that moor them.

use serde::Deserialize;

/// A force on a body. Matrices and vectors of six: surge, sway, heave, roll, pitch, yaw along the body's axes.
#[derive(Debug, Clone, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum ForceSpec {
    /// Pressure of still water on a hull.
    Buoyancy {
        /// Unique name.
        name: String,
        /// Body that has the hull.
        body: String,
        /// Points of the hull's mesh [m], body frame.
        vertices: Vec<[f64; 3]>,
        /// Triangles between them, counter-clockwise from outside.
        triangles: Vec<[usize; 3]>,
        /// Density of the water [kg/m³].
        density: f64,
        /// Height of the water's surface [m].
        level: f64,
    },
    /// Water that is accelerated along.
    AddedMass {
        /// Unique name.
        name: String,
        /// Body that it moves with.
        body: String,
        /// Point that the matrix is about [m], body frame.
        at: [f64; 3],
        /// Added mass [kg, kg m, kg m²], symmetric.
        matrix: [[f64; 6]; 6],
    },
    /// Resistance of water or air.
    Drag {
        /// Unique name.
        name: String,
        /// Body that it acts on.
        body: String,
        /// Point that both are about [m], body frame.
        at: [f64; 3],
        /// Linear damping [N s/m, N s, N m s].
        damping: [[f64; 6]; 6],
        /// Force over speed squared [N s²/m², N m s²]: along an axis over its share of the speed times the whole; each
        /// rotation by itself.
        quadratic: [f64; 6],
        /// Velocity of the fluid [m/s], world axes; of wind with gusts the mean.
        #[serde(default)]
        stream: [f64; 3],
        /// How it grows with height, if it does.
        #[serde(default)]
        profile: Option<ProfileSpec>,
        /// Whether the gusts of the system come on top, along the stream.
        #[serde(default)]
        gusty: bool,
    },
    /// Waves that the body has made: −∫ K(s) ν(t − s) ds with K(s) = Re Σ R exp(ps).
    Memory {
        /// Unique name.
        name: String,
        /// Body that it acts on.
        body: String,
        /// Point that K is about [m], body frame.
        at: [f64; 3],
        /// Terms of K.
        terms: Vec<TermSpec>,
    },
    /// A liquid in a tank. Its mass is the body's, at the centre that the liquid has with the body upright, unless it
    /// is pumped.
    Tank {
        /// Unique name.
        name: String,
        /// Body that has the tank.
        body: String,
        /// Points of the inside of the tank [m], body frame.
        vertices: Vec<[f64; 3]>,
        /// Triangles between them, counter-clockwise from outside of the liquid.
        triangles: Vec<[usize; 3]>,
        /// Density of the liquid [kg/m³].
        density: f64,
        /// Volume of the liquid at the start [m³].
        volume: f64,
        /// What pumps it; then all of its mass is the tank's, nothing the body's.
        #[serde(default)]
        pumped: Option<PumpedSpec>,
    },
    /// A mooring line, an elastic catenary.
    Mooring(Box<MooringSpec>),
    /// What the waves of the sea do to it.
    Wave {
        /// Unique name.
        name: String,
        /// Body that it acts on.
        body: String,
        /// Point that forces act at and moments are about [m], body frame.
        at: [f64; 3],
        /// Point whose way through the waves counts [m], body frame.
        origin: [f64; 3],
        /// Directions that waves run in, from body x towards y [rad], rising within a turn.
        directions: Vec<f64>,
        /// Of every component of the sea, from every direction to the next: terms of 1, s, s² and s³, s the share of the
        /// way.
        phasors: Vec<Vec<[PhasorSpec; TERMS]>>,
        /// Drift forces D likewise, of which each two waves have a slow one; empty where there are none.
        #[serde(default)]
        drifts: Vec<Vec<[DriftSpec; TERMS]>>,
    },
    /// Water around a load, in the waves of the sea.
    Submerged {
        /// Unique name.
        name: String,
        /// Body that is lowered into it.
        body: String,
        /// What it is made of.
        lattices: Vec<LatticeSpec>,
        /// Density of the water [kg/m³].
        density: f64,
        /// Height of the still surface [m].
        level: f64,
        /// Velocity of the current [m/s], world axes.
        #[serde(default)]
        stream: [f64; 3],
    },
    /// What the waves that push a body do to it on the whole: a push, with what a current adds to it, and what they take of its
    /// way.
    MeanDrift {
        /// Unique name.
        name: String,
        /// Body that it acts on, which has a force of waves too.
        body: String,
        /// Point whose way it resists, and at which it acts [m], body frame.
        at: [f64; 3],
        /// From each of some even headings to the next, the first along world x: terms of 1, s, s² and s³, s the share of
        /// the way.
        around: Vec<[MeanDriftSpec; TERMS]>,
        /// True where the push is there from the start, and in statics; else it grows with the waves.
        #[serde(default)]
        settled: bool,
    },
}

/// How the speed of a stream grows with height; it is what it is said to be at one height.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ProfileSpec {
    /// z from which heights count [m].
    pub level: f64,
    /// Height at which the stream is what it is said to be [m].
    pub height: f64,
    /// Below this height it is as there [m].
    pub lowest: f64,
    /// How it grows.
    pub growth: GrowthSpec,
}

/// By what the speed of a stream grows with height.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum GrowthSpec {
    /// The logarithm of the height over this roughness [m].
    Logarithm(f64),
    /// This power of the height.
    Power(f64),
}

/// Cells of a load in water, all alike, in layers of four: at ± `half` along x and y of the body.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LatticeSpec {
    /// Middle of the lowest layer [m], body frame.
    pub at: [f64; 3],
    /// See there [m].
    pub half: [f64; 2],
    /// From layer to layer along z of the body, and half of the depth over which a cell gets wet [m].
    pub height: f64,
    /// How many layers.
    pub layers: usize,
    /// Of one cell: volume of water that it displaces [m³].
    pub volume: f64,
    /// Added mass along the axes of the body [kg].
    pub added_mass: [f64; 3],
    /// Force over speed squared along each [N s²/m²].
    pub quadratic: [f64; 3],
}

/// Real and imaginary part of X in Re(X a exp(i(k·x + ε − ωt))), x the origin: force x, y, z [N/m], moment x, y, z [N], axes
/// of a body that is level.
pub type PhasorSpec = [[f64; 2]; 6];

/// Mean surge, sway and yaw of one wave alone over the square of its amplitude [N/m², N/m], axes of a body that is level.
pub type DriftSpec = [f64; 3];

/// Surge, sway and yaw, axes of a body that is level: what is lost over speed in each of the three, then the push [N s/m, N s, N;
/// of yaw N s, N m s, N m].
pub type MeanDriftSpec = [[f64; 4]; 3];

/// Of a cubic.
pub const TERMS: usize = 4;

/// A decaying term R exp(ps).
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TermSpec {
    /// p [1/s], real and imaginary part.
    pub pole: [f64; 2],
    /// Real part of R [N/m, N, N m], symmetric.
    pub real: [[f64; 6]; 6],
    /// Imaginary part of R, symmetric.
    pub imaginary: [[f64; 6]; 6],
}

/// Waves or gusts: what they are made of.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TrainsSpec {
    /// Regular waves a cos(k·x − ωt + ε) whose sum they are.
    pub components: Vec<ComponentSpec>,
    /// Time in which they grow from nothing [s].
    pub rise_time: f64,
    /// Depth of the water that waves run over [m]; none is deep.
    #[serde(default)]
    pub depth: Option<f64>,
}

/// A regular wave.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ComponentSpec {
    /// ω [rad/s].
    pub frequency: f64,
    /// k [rad/m], world x and y.
    pub wave_number: [f64; 2],
    /// a [m, of gusts m/s].
    pub amplitude: f64,
    /// ε [rad].
    pub phase: f64,
}

/// A mooring line: one of `length` and `pretension`.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MooringSpec {
    /// Unique name, of ropes too.
    pub name: String,
    /// Body that it holds.
    pub body: String,
    /// Its upper end [m], body frame.
    pub at: [f64; 3],
    /// Its lower end [m], in the world.
    pub to: [f64; 3],
    /// Weight of unstretched line [N/m].
    pub weight: f64,
    /// EA [N].
    pub axial_stiffness: f64,
    /// Damping time τ [s].
    #[serde(default)]
    pub damping_time: f64,
    /// Unstretched length [m].
    #[serde(default)]
    pub length: Option<f64>,
    /// Tension at its upper end at the start [N], from which the length follows.
    #[serde(default)]
    pub pretension: Option<f64>,
    /// Height of the level bed that it may rest on [m], where its lower end lies; none is no bed.
    #[serde(default)]
    pub sea_bed: Option<f64>,
    /// The flow of its winch, a body whose parent is `body`.
    #[serde(default)]
    pub winch: Option<String>,
    /// Tension [N] at which it breaks; none never does.
    #[serde(default)]
    pub breaking_force: Option<f64>,
    /// Time [s] at which it is cut.
    #[serde(default)]
    pub cut_at: Option<f64>,
}

/// How the liquid of a tank is pumped.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PumpedSpec {
    /// Body below that of the tank whose joint is its content.
    pub content: String,
    /// Height of the surface from which liquid outside is pumped, or of that over holes [m].
    pub level: f64,
    /// Density of the water outside [kg/m³]; 0 of air.
    #[serde(default)]
    pub outside: f64,
    /// Through which it runs by itself.
    #[serde(default)]
    pub holes: Vec<HoleSpec>,
}

/// A hole of a tank.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HoleSpec {
    /// Its middle [m], in the frame of the body.
    pub at: [f64; 3],
    /// Its area [m²].
    pub area: f64,
    /// Share of the ideal flow that passes it.
    pub discharge: f64,
    /// Whether it is closed at the start.
    #[serde(default)]
    pub closed: bool,
    /// Steps of the plan that open or close it as they begin, in their order, and whether it is open from then on.
    #[serde(default)]
    pub turns: Vec<(usize, bool)>,
}

impl ForceSpec {
    /// Its name.
    pub fn name(&self) -> &str {
        match self {
            Self::Buoyancy { name, .. }
            | Self::AddedMass { name, .. }
            | Self::Drag { name, .. }
            | Self::Memory { name, .. }
            | Self::Tank { name, .. }
            | Self::Wave { name, .. }
            | Self::MeanDrift { name, .. }
            | Self::Submerged { name, .. } => name,
            Self::Mooring(line) => &line.name,
        }
    }
}
