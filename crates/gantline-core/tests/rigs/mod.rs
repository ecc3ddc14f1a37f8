//! Random rigs for property-based tests: trees of all joint types, ropes over them, contacts.

pub mod hulls;
pub mod runs;
pub mod wet;

use gantline_core::build::build;
use gantline_core::spec::{
    AxisJointSpec, BodySpec, ContactSpec, DrumSpec, GuideSpec, JointSpec, MaterialSpec, PlacementSpec,
    RopeSpec, SystemSpec,
};
use gantline_core::state::State;
use gantline_core::stepper::frame::Frame;
use gantline_core::system::System;
use proptest::prelude::*;
use proptest::test_runner::FileFailurePersistence::WithSource;

/// Numbers that a rig is made of, each in −1…1.
pub type Seeds = Vec<f64>;

/// So many random cases; seeds of those that failed are kept beside the file of the test.
pub fn cases(cases: u32) -> ProptestConfig {
    let beside = WithSource("proptest-regressions");
    ProptestConfig { failure_persistence: Some(Box::new(beside)), ..ProptestConfig::with_cases(cases) }
}

/// Enough numbers for a rig.
pub fn seeds() -> impl Strategy<Value = Seeds> {
    prop::collection::vec(-1.0..1.0_f64, 400)
}

/// Hands out the numbers one after another.
pub struct Draw {
    seeds: Seeds,
    next: usize,
}

impl Draw {
    pub fn new(seeds: &[f64]) -> Self {
        Self { seeds: seeds.to_vec(), next: 0 }
    }

    pub fn number(&mut self) -> f64 {
        self.next += 1;
        self.seeds[(self.next - 1) % self.seeds.len()]
    }

    /// Whole number below `bound`.
    pub fn choice(&mut self, bound: usize) -> usize {
        (((self.number() + 1.0) / 2.0 * bound as f64) as usize).min(bound - 1)
    }

    pub fn vector(&mut self) -> [f64; 3] {
        [self.number(), self.number(), self.number()]
    }

    pub fn scaled(&mut self, scale: f64) -> [f64; 3] {
        self.vector().map(|x| scale * x)
    }

    /// A direction; never close to zero length.
    pub fn direction(&mut self) -> [f64; 3] {
        let [x, y, z] = self.vector();
        [x + 1.5_f64.copysign(x), y, z]
    }

    pub fn orientation(&mut self) -> [f64; 4] {
        let raw = [1.5 + self.number(), self.number(), self.number(), self.number()];
        let length = raw.iter().map(|x| x * x).sum::<f64>().sqrt();
        raw.map(|x| x / length)
    }
}

/// How many kinds of joints [`joint`] draws.
const JOINTS: usize = 6;
/// Bodies of a rig: one with each kind of joint, and one more.
pub const BODIES: usize = JOINTS + 1;

fn joint(draw: &mut Draw, kind: usize) -> JointSpec {
    let axis = |draw: &mut Draw| AxisJointSpec {
        axis: draw.direction(),
        position: draw.number(),
        velocity: draw.number(),
        damping: 0.0,
        friction: 0.0,
        drive: None,
        stops: None,
        pin: None,
    };
    match kind {
        0 => JointSpec::Fixed {},
        1 => JointSpec::Hinge(axis(draw)),
        2 => JointSpec::Slider(axis(draw)),
        3 => JointSpec::Ball { orientation: draw.orientation(), angular_velocity: draw.vector() },
        4 => JointSpec::Point { position: draw.vector(), velocity: draw.vector() },
        _ => JointSpec::Free {
            position: draw.scaled(3.0),
            orientation: draw.orientation(),
            velocity: draw.vector(),
            angular_velocity: draw.vector(),
        },
    }
}

fn flow(name: &str, inertia: f64, velocity: f64) -> BodySpec {
    BodySpec {
        name: name.into(),
        parent: None,
        placement: PlacementSpec { position: [0.0; 3], orientation: [1.0, 0.0, 0.0, 0.0] },
        joint: JointSpec::Flow {
            inertia,
            velocity,
            damping: 0.0,
            brake: 0.0,
            capacity: None,
            keeps_pull: false,
            power: None,
            drive: None,
        },
        mass: 0.0,
        centre_of_gravity: [0.0; 3],
        inertia: [0.0; 6],
    }
}

/// A rig with every joint type in its tree, three ropes (one over a sheave that turns and from a drum, one with a curve),
/// one contact.
pub fn rig(seeds: &[f64]) -> SystemSpec {
    let mut draw = Draw::new(seeds);
    let mut bodies: Vec<BodySpec> = Vec::new();
    for index in 0..BODIES {
        let parent = draw.choice(index + 1).checked_sub(1).map(|parent| bodies[parent].name.clone());
        let kind = if index < JOINTS { (index + 1) % JOINTS } else { draw.choice(JOINTS) };
        let mass = 10.0_f64.powf(1.0 + draw.number());
        let size = 0.2 + draw.number().abs();
        let diagonal = [1.0 + 0.3 * draw.number(), 1.2, 0.9].map(|x| x * mass * size);
        bodies.push(BodySpec {
            name: format!("b{index}"),
            parent,
            placement: PlacementSpec { position: draw.vector(), orientation: draw.orientation() },
            joint: joint(&mut draw, kind),
            mass,
            centre_of_gravity: draw.scaled(0.5),
            inertia: [diagonal[0], diagonal[1], diagonal[2], 0.1 * mass * size * draw.number(), 0.0, 0.0],
        });
    }
    bodies.extend(["sheave", "drum"].map(|name| flow(name, 30.0 + 20.0 * draw.number(), draw.number())));
    let ropes = (0..3).map(|index| rope(&mut draw, index)).collect();
    let contact = ContactSpec {
        name: "c0".into(),
        group: "g".into(),
        body: "b4".into(),
        at: draw.vector(),
        plane_point: draw.vector(),
        plane_normal: draw.direction(),
        plane_body: [None, Some("b1"), Some("b6")][draw.choice(3)].map(String::from),
        stiffness: 1e5,
        damping_time: 0.01,
        friction: 0.5,
    };
    SystemSpec { ropes, contacts: vec![contact], ..system_of(bodies) }
}

/// Bodies under gravity, and nothing else.
pub fn system_of(bodies: Vec<BodySpec>) -> SystemSpec {
    SystemSpec {
        gravity: [0.0, 0.0, -9.81],
        bodies,
        ropes: Vec::new(),
        contacts: Vec::new(),
        supports: Vec::new(),
        shapes: Vec::new(),
        rims: Vec::new(),
        pairs: Vec::new(),
        landings: Vec::new(),
        vessels: Vec::new(),
        watches: Vec::new(),
        pulls: Vec::new(),
        forces: Vec::new(),
        sea: None,
        gusts: None,
        adjusters: Vec::new(),
        drives: Vec::new(),
        compensators: Vec::new(),
        plan: Vec::new(),
        emergency_stop: None,
    }
}

fn body(draw: &mut Draw) -> Option<String> {
    draw.choice(BODIES + 1).checked_sub(1).map(|index| format!("b{index}"))
}

/// A rope that nothing cuts or breaks; without a length it is just taut.
pub fn rope_of(
    name: impl Into<String>,
    length: Option<f64>,
    material: MaterialSpec,
    route: Vec<GuideSpec>,
) -> RopeSpec {
    RopeSpec {
        name: name.into(),
        length,
        is_stretched: false,
        material,
        route,
        breaking_force: None,
        cut_at: None,
    }
}

fn rope(draw: &mut Draw, index: usize) -> RopeSpec {
    let sheave_body = body(draw);
    let middle = GuideSpec::HalfTurn {
        body: sheave_body,
        enter: draw.vector(),
        leave: draw.scaled(2.0),
        bulge: [0.0, 0.0, 1.0],
        flow: Some("sheave".into()),
        ratio: 1.0,
        groove: None,
    };
    let mut route = vec![GuideSpec::End { body: body(draw), at: draw.scaled(4.0), drum: None }];
    if index == 0 {
        route.push(middle);
    }
    let drum = (index == 0).then(|| DrumSpec {
        flow: "drum".into(),
        rate: 0.4,
        laid_under: Some(5e3), // a strain of 5 %
        layers: None,
    });
    route.push(GuideSpec::End { body: body(draw), at: draw.scaled(4.0), drum });
    let damping_time = 0.002;
    let material = if index == 2 {
        // Many times as long as it is unstretched, as the others: its lines are, too.
        let points = vec![[2.0, 1e5], [5.0, 5e5], [9.0, 7e5]];
        MaterialSpec::Curved { points, damping_time }
    } else {
        MaterialSpec::Elastic { axial_stiffness: 1e5, damping_time }
    };
    rope_of(format!("r{index}"), Some(1.0), material, route)
}

/// The rig, its state and everything evaluated there.
pub fn built(seeds: &[f64]) -> (System, State, Frame) {
    let (system, state) = build(&rig(seeds)).expect("the generator makes valid rigs");
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    (system, state, frame)
}

/// The rig after every coordinate has moved by `scale` · `direction`.
pub fn moved(system: &System, state: &State, direction: &[f64], scale: f64) -> (State, Frame) {
    let mut state = state.clone();
    let mut increment: Vec<f64> = direction.iter().map(|x| scale * x).collect();
    let mut frame = Frame::new(system);
    frame.update(system, &state);
    // What drums let go moves along with them.
    increment.extend(
        system.coils.iter().zip(&frame.feeding).map(|(coil, feeding)| scale * feeding * direction[coil.dof]),
    );
    system.tree.advance(&mut state.q, &increment);
    frame.update(system, &state);
    (state, frame)
}

/// A rig to torture the methods with: 2 to 6 bodies on random joints, masses over six decades, ropes from slack to
/// taut over four decades of stiffness, some inextensible, points over rough ground.
pub fn torture(seeds: &[f64]) -> SystemSpec {
    let mut draw = Draw::new(seeds);
    let count = 2 + draw.choice(5);
    let mut bodies: Vec<BodySpec> = Vec::new();
    for index in 0..count {
        let parent = if draw.number() > 0.3 && index > 0 {
            Some(bodies[draw.choice(index)].name.clone())
        } else {
            None
        };
        let mass = 10.0_f64.powf(2.0 + 3.0 * draw.number());
        let size = 0.3 + draw.number().abs();
        let kind = if parent.is_none() { [1, 3, 4, 5, 5][draw.choice(5)] } else { 1 + draw.choice(4) };
        bodies.push(BodySpec {
            name: format!("b{index}"),
            parent,
            placement: PlacementSpec { position: draw.scaled(2.0), orientation: draw.orientation() },
            joint: joint(&mut draw, kind),
            mass,
            centre_of_gravity: if kind == 5 { [0.0; 3] } else { draw.scaled(0.5) },
            inertia: [mass * size, mass * size * 1.3, mass * size * 0.9, 0.0, 0.0, 0.0],
        });
    }
    let contacts = (0..2 * count).map(|index| ContactSpec {
        name: format!("c{index}"),
        group: format!("b{}", index % count),
        body: format!("b{}", index % count),
        at: draw.scaled(0.7),
        plane_body: None,
        plane_point: [0.0, 0.0, -6.0],
        plane_normal: [0.2 * draw.number(), 0.0, 1.0],
        stiffness: 10.0_f64.powf(6.0 + draw.number()),
        damping_time: 0.005 * (1.0 + draw.number()),
        friction: 0.4 * (1.0 + draw.number()),
    });
    let contacts = contacts.collect();
    let mut spec = SystemSpec { contacts, ..system_of(bodies) };
    let (system, state) = build(&spec).expect("bodies are valid");
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    for index in 0..1 + draw.choice(6) {
        let to = draw.choice(count);
        let from = draw.choice(count + 1).checked_sub(1).filter(|&from| from != to);
        let ends =
            [(from, draw.scaled(if from.is_none() { 4.0 } else { 0.8 })), (Some(to), draw.scaled(0.8))];
        let [a, b] = ends.map(|(body, at)| frame.kinematics.point(body, glam::DVec3::from_array(at)));
        let slack = 1.05 + 0.1 * draw.number();
        let rigid = draw.number() > 0.7;
        let material = if rigid {
            MaterialSpec::Inextensible {}
        } else {
            let axial_stiffness = 10.0_f64.powf(6.5 + 2.0 * draw.number());
            let damping_time = 0.003 * (1.0 + draw.number());
            if index < 4 {
                MaterialSpec::Elastic { axial_stiffness, damping_time }
            } else {
                // Soft, stiff, and soft again.
                let points = [[0.003, 0.3], [0.01, 3.0], [0.02, 4.0]];
                let points =
                    points.map(|[strain, share]| [strain, 2.5e-3 * share * axial_stiffness]).to_vec();
                MaterialSpec::Curved { points, damping_time }
            }
        };
        let route = ends.map(|(body, at)| GuideSpec::End {
            body: body.map(|body| format!("b{body}")),
            at,
            drum: None,
        });
        let length = (b - a).length().max(0.5) * if rigid { slack.max(1.001) } else { slack };
        spec.ropes.push(rope_of(format!("r{index}"), Some(length), material, route.to_vec()));
    }
    spec
}

/// How the rope of [`sheave_rig`] passes its first sheaves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Passage {
    /// In their grooves, wherever that leads.
    Seated,
    /// Straight past those that it does not touch.
    LiftsOff,
    /// The first with a flow, at which two spans meet.
    Feeds,
}

/// A rope over two real sheaves on random bodies and through an eye, from an end to a drum; none where some part has no
/// tangent. Where it may lift off it lies on none of the sheaves that it does not touch.
pub fn sheave_rig(seeds: &[f64], passage: Passage) -> Option<(System, State, Frame)> {
    let mut spec = rig(seeds);
    let mut draw = Draw::new(&seeds[200..]);
    let sheave = |draw: &mut Draw, shift: f64| GuideSpec::Sheave {
        body: body(draw),
        at: {
            let [x, y, z] = draw.vector();
            [x + shift, y, z]
        },
        axis: draw.direction(),
        radius: 0.3 + 0.2 * draw.number(),
        may_lift_off: passage == Passage::LiftsOff,
        flow: None,
        ratio: 1.0,
        groove: None,
    };
    let start = GuideSpec::End { body: body(&mut draw), at: draw.scaled(3.0), drum: None };
    let mut first = sheave(&mut draw, 8.0);
    if let (GuideSpec::Sheave { flow, .. }, Passage::Feeds) = (&mut first, passage) {
        *flow = Some("sheave".into());
    }
    let route = vec![
        start,
        first,
        sheave(&mut draw, -8.0),
        GuideSpec::Eye { body: body(&mut draw), at: draw.scaled(3.0) },
        GuideSpec::End {
            body: body(&mut draw),
            at: draw.scaled(3.0),
            drum: Some(DrumSpec { flow: "drum".into(), rate: 0.4, laid_under: None, layers: None }),
        },
    ];
    let material = MaterialSpec::Elastic { axial_stiffness: 1e5, damping_time: 0.002 };
    spec.ropes = vec![rope_of("r", None, material, route)];
    // Without rope over it this flow of the rig would be refused.
    spec.bodies.retain(|body| passage == Passage::Feeds || body.name != "sheave");
    let built = build(&spec);
    if let Err(refused) = &built {
        assert!(refused.problem.contains("at the start"), "{refused}");
    }
    let (system, state) = built.ok()?;
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    Some((system, state, frame))
}
