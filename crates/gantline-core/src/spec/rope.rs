//! Ropes: what they are made of and what they pass.

use serde::Deserialize;

/// A rope: route, unstretched length, material.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RopeSpec {
    /// Unique name.
    pub name: String,
    /// Unstretched length [m], arcs included; none is just taut at the start.
    pub length: Option<f64>,
    /// Whether it may be much longer at the start, as a spring may.
    #[serde(default)]
    pub is_stretched: bool,
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
    /// T = G(ε), ε = e/L, and a damper, of a rope that runs straight from end to end.
    Curved {
        /// Strain and tension [N], both rising from nothing; straight lines between them.
        points: Vec<[f64; 2]>,
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

/// Ropes that pull at one thing together, such as those at a hook, or pins that hold one thing, each square to the others,
/// such as those of a hinge.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PullSpec {
    /// Unique name.
    pub name: String,
    /// Names of its ropes.
    #[serde(default)]
    pub ropes: Vec<String>,
    /// Joints of its pins, where it is of pins.
    #[serde(default)]
    pub pins: Vec<String>,
}

fn one() -> f64 {
    1.0
}
