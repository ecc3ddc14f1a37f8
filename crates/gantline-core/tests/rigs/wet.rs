//! The random rig in water, wind and waves, on mooring lines.

use gantline_core::build::build;
use gantline_core::force::AnyForce;
use gantline_core::spec::{
    BodySpec, ComponentSpec, DriveSpec, ForceSpec, GrowthSpec, LatticeSpec, MooringSpec, PhasorSpec,
    ProfileSpec, PumpedSpec, SystemSpec, TrainsSpec,
};
use gantline_core::state::State;
use gantline_core::stepper::frame::Frame;
use gantline_core::system::System;
use gantline_core::tree::bias::NewtonEuler;
use glam::DVec3;

use super::hulls::sphere;
use super::{BODIES, Draw, flow, rig};

/// Central differences as in the tests of mechanics; forces of water are up to some 1e4 here.
pub const STEP: f64 = 1e-5;
/// How close differences come to derivatives, in shares of what is large there.
pub const CLOSE: f64 = 1e-6;
/// When all is looked at [s]: waves still grow.
pub const NOW: f64 = 3.0;
/// Time in which they grow [s].
pub const GROWN: f64 = 5.0;

/// Symmetric without negative eigenvalues: B Bᵀ.
fn square(draw: &mut Draw, size: f64) -> [[f64; 6]; 6] {
    let root: [[f64; 6]; 6] = std::array::from_fn(|_| std::array::from_fn(|_| draw.number()));
    std::array::from_fn(|i| {
        std::array::from_fn(|j| size * (0..6).map(|k| root[i][k] * root[j][k]).sum::<f64>())
    })
}

/// A mooring line from a body far down, with a winch: taut, slack, or with a part of it on a bed.
fn mooring(spec: &mut SystemSpec, draw: &mut Draw, k: usize) -> ForceSpec {
    let up = -DVec3::from_array(spec.gravity).normalize();
    let down = DVec3::from_array(draw.scaled(10.0)) - up * 40.0;
    let body = format!("b{}", draw.choice(BODIES));
    let winch = format!("winch{k}");
    let drum = flow(&winch, 3.0, draw.number());
    spec.bodies.push(BodySpec { parent: Some(body.clone()), ..drum });
    ForceSpec::Mooring(Box::new(MooringSpec {
        name: format!("line{k}"),
        body,
        at: draw.vector(),
        to: down.to_array(),
        weight: 1.0,
        axial_stiffness: 4000.0,
        damping_time: 0.05,
        length: (k == 1).then_some(90.0),
        pretension: (k != 1).then_some(100.0 + 20.0 * draw.number()),
        sea_bed: (k == 2).then_some(down.dot(up)),
        winch: Some(winch),
        breaking_force: None,
        cut_at: None,
    }))
}

/// Everything is above its lowest height.
const GROWING: ProfileSpec =
    ProfileSpec { level: -20.0, height: 20.0, lowest: 1.0, growth: GrowthSpec::Logarithm(0.3) };

/// The random rig with dented hulls and tanks, added mass and drag on bodies somewhere in its tree.
pub fn wet(seeds: &[f64]) -> (System, State, Frame) {
    let mut spec = rig(seeds);
    let mut draw = Draw::new(&seeds[250..]);
    let mesh = sphere(2.0, 5);
    let dented = |draw: &mut Draw| {
        let place = DVec3::from_array(draw.scaled(0.5));
        mesh.vertices
            .iter()
            .map(|vertex| (*vertex * (1.0 + 0.2 * draw.number()) + place).to_array())
            .collect()
    };
    let body = |draw: &mut Draw| format!("b{}", draw.choice(7));
    let (named, at) = (|name: &str, k: usize| format!("{name}{k}"), |draw: &mut Draw| draw.vector());
    for k in 0..2 {
        let buoyancy = ForceSpec::Buoyancy {
            name: named("hull", k),
            body: body(&mut draw),
            vertices: dented(&mut draw),
            triangles: mesh.triangles.clone(),
            density: 60.0,
            level: draw.number(),
        };
        let added = ForceSpec::AddedMass {
            name: named("added", k),
            body: body(&mut draw),
            at: at(&mut draw),
            matrix: square(&mut draw, 10.0),
        };
        let drag = ForceSpec::Drag {
            name: named("drag", k),
            body: body(&mut draw),
            at: at(&mut draw),
            damping: square(&mut draw, 20.0),
            quadratic: std::array::from_fn(|_| 10.0 * draw.number().abs()),
            // One stands, the other streams, grows with height and comes in gusts.
            stream: if k == 0 { [0.0; 3] } else { draw.scaled(2.0) },
            profile: (k == 1).then_some(GROWING),
            gusty: k == 1,
        };
        let has_tank = body(&mut draw);
        // One of the two is pumped.
        let pumped = (k == 1).then(|| PumpedSpec {
            content: "content".to_owned(),
            level: draw.number(),
            outside: 0.0,
            holes: Vec::new(),
        });
        if pumped.is_some() {
            spec.bodies.push(content_of(&has_tank));
            spec.drives.push(DriveSpec { name: "pump".to_owned(), ramps: Vec::new(), waves: None });
        }
        let tank = ForceSpec::Tank {
            name: named("tank", k),
            body: has_tank,
            vertices: dented(&mut draw),
            triangles: mesh.triangles.clone(),
            density: 40.0,
            volume: 8.0 + 7.0 * draw.number(),
            pumped,
        };
        let pushed = body(&mut draw);
        let directions: Vec<f64> = (0..4).map(|k| f64::from(k) + 0.4 * draw.number()).collect();
        // One of the two drifts.
        let drifts = (0..3 * k).map(|_| level(&from_all_sides(&mut draw, &directions))).collect();
        let wave = ForceSpec::Wave {
            name: named("wave", k),
            body: pushed.clone(),
            at: at(&mut draw),
            origin: at(&mut draw),
            phasors: (0..3).map(|_| from_all_sides(&mut draw, &directions)).collect(),
            drifts,
            directions,
        };
        // From heading to heading without a bend.
        let headings: Vec<f64> = (0..5).map(|k| 0.2 * f64::from(k) * std::f64::consts::TAU).collect();
        let around = from_all_sides(&mut draw, &headings).iter().map(on_the_whole).collect();
        // One of the two is there from the start.
        let drift = ForceSpec::MeanDrift {
            name: named("drift", k),
            body: pushed.clone(),
            at: at(&mut draw),
            around,
            settled: k == 1,
        };
        // Where waves push, added mass and a matrix alone act along their axes.
        let level = ForceSpec::AddedMass {
            name: named("level", k),
            body: pushed.clone(),
            at: at(&mut draw),
            matrix: square(&mut draw, 10.0),
        };
        let viscous = ForceSpec::Drag {
            name: named("viscous", k),
            body: pushed,
            at: at(&mut draw),
            damping: square(&mut draw, 20.0),
            quadratic: [0.0; 6],
            stream: [0.0; 3],
            profile: None,
            gusty: false,
        };
        let lattice = |draw: &mut Draw, layers: usize| LatticeSpec {
            at: at(draw),
            half: [draw.number(), draw.number()],
            height: 0.8 + 0.5 * draw.number(),
            layers,
            volume: 0.3 * draw.number().abs(),
            added_mass: std::array::from_fn(|_| 3.0 * draw.number().abs()),
            quadratic: std::array::from_fn(|_| 3.0 * draw.number().abs()),
        };
        let submerged = ForceSpec::Submerged {
            name: named("submerged", k),
            body: body(&mut draw),
            lattices: vec![lattice(&mut draw, 1), lattice(&mut draw, 3)],
            density: 60.0,
            level: draw.number(),
            stream: if k == 0 { [0.0; 3] } else { draw.scaled(2.0) },
        };
        spec.forces.extend([buoyancy, added, drag, tank, wave, drift, level, viscous, submerged]);
    }
    let component = |draw: &mut Draw| ComponentSpec {
        frequency: 1.0 + 0.5 * draw.number(),
        wave_number: [draw.number(), draw.number()],
        amplitude: draw.number(),
        phase: draw.number(),
    };
    for trains in [&mut spec.sea, &mut spec.gusts] {
        let components = (0..3).map(|_| component(&mut draw)).collect();
        *trains = Some(TrainsSpec { components, rise_time: GROWN, depth: Some(3.0 + draw.number()) });
    }
    for k in 0..3 {
        let line = mooring(&mut spec, &mut draw, k);
        spec.forces.push(line);
    }
    let (system, mut state) = build(&spec).expect("the generator makes valid rigs");
    state.time = NOW;
    // Slow places and headings that are on their way, by any state of their filters a moment ago.
    for force in &system.tree.forces {
        if let AnyForce::Wave(wave) = force {
            let past = &mut state.past[wave.slow.states()];
            past.iter_mut().for_each(|number| *number = draw.number());
            past[0] = NOW - 0.5;
        }
    }
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    (system, state, frame)
}

/// Real parts of surge, sway and yaw.
fn level(forces: &[[PhasorSpec; 4]]) -> Vec<[[f64; 3]; 4]> {
    forces.iter().map(|terms| terms.map(|term| [0, 1, 5].map(|axis| term[axis][0]))).collect()
}

/// Twelve numbers as three rows, a tenth as large.
fn on_the_whole(terms: &[PhasorSpec; 4]) -> [[[f64; 4]; 3]; 4] {
    terms.map(|term| {
        let numbers = term.as_flattened();
        std::array::from_fn(|i| std::array::from_fn(|j| 0.1 * numbers[4 * i + j]))
    })
}

/// Forces of a wave that go on from direction to direction without a bend, by Hermite's cubics.
fn from_all_sides(draw: &mut Draw, directions: &[f64]) -> Vec<[PhasorSpec; 4]> {
    let count = directions.len();
    let mut drawn = || -> Vec<PhasorSpec> {
        let mut phasor = || std::array::from_fn(|_| std::array::from_fn(|_| 100.0 * draw.number()));
        (0..count).map(|_| phasor()).collect()
    };
    let (values, slopes) = (drawn(), drawn());
    let cubic = |k: usize| {
        let next = (k + 1) % count;
        let wide = directions[next] - directions[k] + if next == 0 { std::f64::consts::TAU } else { 0.0 };
        let term = |power: usize| {
            std::array::from_fn(|i| {
                std::array::from_fn(|part| {
                    let (here, there) = (values[k][i][part], values[next][i][part]);
                    let (leaves, comes) = (wide * slopes[k][i][part], wide * slopes[next][i][part]);
                    match power {
                        0 => here,
                        1 => leaves,
                        2 => 3.0 * (there - here) - 2.0 * leaves - comes,
                        _ => leaves + comes - 2.0 * (there - here),
                    }
                })
            })
        };
        [term(0), term(1), term(2), term(3)]
    };
    (0..count).map(cubic).collect()
}

/// The content of a tank on a body, as a joint.
fn content_of(body: &str) -> BodySpec {
    let given = serde_json::json!({
        "name": "content", "parent": body, "mass": 0.0, "centre_of_gravity": [0, 0, 0], "inertia": [0, 0, 0, 0, 0, 0],
        "placement": {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]},
        "joint": {"type": "content", "drive": "pump"}});
    serde_json::from_value(given).expect("it is a body")
}

/// Some accelerations.
pub fn rates(system: &System, seeds: &[f64]) -> Vec<f64> {
    (0..system.tree.velocities).map(|k| seeds[(7 * k + 3) % seeds.len()]).collect()
}

/// Inverse dynamics under velocities and accelerations.
pub fn inverse(system: &System, frame: &Frame, v: &[f64], a: &[f64]) -> (NewtonEuler, Vec<f64>) {
    let mut dynamics = NewtonEuler::new(&system.tree);
    let mut out = vec![0.0; v.len()];
    dynamics.update(&system.tree, &frame.kinematics, v, Some(a), None, &mut out);
    (dynamics, out)
}
