//! Ropes over up to a hundred sheaves in space, with axes in any direction, radii over a decade, eyes between them and
//! sheaves that the rope may leave: tangency, gradients, and refusals by name, on 10,000 random routes.
//!
//! Other seeds: `GANTLINE_ROUTE_SEEDS=1-20 cargo test --release routes`.

use super::rigs::{rope_of, system_of};
use gantline_core::build::build;
use gantline_core::rope::part::Part;
use gantline_core::rope::tangency::NoTangent;
use gantline_core::spec::{BodySpec, GuideSpec, JointSpec, MaterialSpec, PlacementSpec, SystemSpec};
use gantline_core::state::State;
use gantline_core::stepper::frame::Frame;
use gantline_core::system::System;
use glam::DVec3;

/// Routes of one seed.
const ROUTES: usize = 10_000;
/// Most sheaves of a route.
const MOST: f64 = 100.0;
/// Turning of the bodies in the direction along which gradients are compared [rad], where they shift by 1 m: so both
/// move the ends of parts 10 m long alike.
const TURN: f64 = 0.1;

/// SplitMix64: the same numbers everywhere.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn vector(&mut self, most: f64) -> DVec3 {
        DVec3::from_array([0; 3].map(|_| self.between(-most, most)))
    }

    /// A direction, none preferred.
    fn direction(&mut self) -> DVec3 {
        loop {
            let vector = self.vector(1.0);
            if (0.01..1.0).contains(&vector.length_squared()) {
                return vector.normalize();
            }
        }
    }
}

fn body(name: String, position: DVec3, turn: DVec3) -> BodySpec {
    let orientation = glam::DQuat::from_scaled_axis(turn);
    BodySpec {
        name,
        parent: None,
        placement: PlacementSpec { position: [0.0; 3], orientation: [1.0, 0.0, 0.0, 0.0] },
        joint: JointSpec::Free {
            position: position.to_array(),
            orientation: [orientation.w, orientation.x, orientation.y, orientation.z],
            velocity: [0.0; 3],
            angular_velocity: [0.0; 3],
        },
        mass: 1.0,
        centre_of_gravity: [0.0; 3],
        inertia: [1.0, 1.0, 1.0, 0.0, 0.0, 0.0],
    }
}

/// A random walk of guides, each on a free body or on the world. One route in ten has a step that is far too short, so
/// that circles overlap or ends coincide.
fn random_route(random: &mut Random) -> SystemSpec {
    let count = MOST.powf(random.between(0.0, 1.0)).round() as usize;
    let cramped =
        if random.between(0.0, 1.0) < 0.1 { random.next() as usize % (count + 1) } else { usize::MAX };
    let mut spec = system_of(Vec::new());
    let mut place = random.vector(5.0);
    let mut route = Vec::with_capacity(count + 2);
    for index in 0..count + 2 {
        let (turn, at) = (random.vector(3.0), random.vector(0.5));
        let held = (random.between(0.0, 1.0) < 0.8).then(|| format!("b{index}"));
        if let Some(name) = &held {
            let arm = glam::DQuat::from_scaled_axis(turn) * at;
            spec.bodies.push(body(name.clone(), place - arm, turn));
        }
        let at = if held.is_some() { at } else { place }.to_array();
        route.push(if index == 0 || index == count + 1 {
            GuideSpec::End { body: held, at, drum: None }
        } else if random.between(0.0, 1.0) < 0.1 {
            GuideSpec::Eye { body: held, at }
        } else {
            GuideSpec::Sheave {
                body: held,
                at,
                axis: random.direction().to_array(),
                radius: 10.0_f64.powf(random.between(-1.0, 0.0)),
                may_lift_off: random.between(0.0, 1.0) < 0.3,
                flow: None,
                ratio: 1.0,
                groove: None,
            }
        });
        let step = match random.next() % 3 {
            _ if index != cramped => random.between(2.5, 20.0),
            0 => 0.0,
            _ => random.between(0.0, 1.0),
        };
        place += random.direction() * step;
    }
    let material = MaterialSpec::Elastic { axial_stiffness: 1e6, damping_time: 0.0 };
    spec.ropes.push(rope_of("r", None, material, route));
    spec
}

/// Checks tangency at both ends of a part; returns how fast a motion of 1 m/s may turn it: the least time in which its
/// tangents change by their own size [s].
fn check_part(part: &Part, frame: &Frame) -> f64 {
    let straight = part.locate(&frame.kinematics);
    let way = straight.to - straight.from;
    assert!((straight.direction * straight.length - way).length() < 1e-12 * (1.0 + way.length()));
    let rate = 2.0 + 2.0 * TURN * (way.length() + 2.0);
    let mut pace = way.length() / rate;
    let mut along = [DVec3::ZERO; 2];
    let mut radii = [0.0; 2];
    for (k, anchor) in [part.from, part.to].into_iter().enumerate() {
        let Some((axis, radius)) = anchor.sheave else { continue };
        let axis = frame.kinematics.turn(anchor.at.body, axis);
        let centre = frame.kinematics.point(anchor.at.body, anchor.at.at);
        let (radial, point) = (straight.radial[k], [straight.from, straight.to][k]);
        let size = straight.length + radius;
        assert!((point - centre - radial * radius).length() < 1e-12 * (1.0 + centre.length()));
        assert!(radial.dot(way).abs() < 1e-12 * size, "radial part {:e}", radial.dot(way) / size);
        assert!(radial.dot(axis).abs() < 1e-12 && (radial.length() - 1.0).abs() < 1e-12);
        assert!(straight.direction.dot(axis.cross(radial)) > 0.0, "it runs against the sheave's sense");
        (along[k], radii[k]) = (axis.cross(radial), radius);
        // In the sheave's plane √(|w|² − r²) is what changes fastest.
        let flat = axis.cross([straight.to, straight.from][k] - centre).length();
        pace = pace.min((flat * flat - radius * radius) / (2.0 * flat * rate));
    }
    // Where det A of `tangency` is small beside the product of the diagonal, each end turns the other, and both turn faster.
    let own = way.dot(along[0]) * way.dot(along[1]);
    let turned = straight.radial[0].dot(along[1]) * straight.radial[1].dot(along[0]);
    let det = own + radii[0] * radii[1] * turned;
    if own > 0.0 { pace * (det / own).clamp(0.0, 1.0) } else { pace }
}

/// g of the rope after every coordinate has moved by `share` of `direction`.
fn length_at(system: &System, state: &State, direction: &[f64], share: f64, frame: &mut Frame) -> f64 {
    let mut state = state.clone();
    let increment: Vec<f64> = direction.iter().map(|part| share * part).collect();
    system.tree.advance(&mut state.q, &increment);
    frame.update(system, &state);
    frame.value[0]
}

/// Central difference of order 6. With h = s/200, s the time in which tangents change by their own size, it leaves
/// h⁶ g⁽⁷⁾/140 ≈ 7! (h/s)⁶/140 = 6e-13 of what moves at 1 m/s, which leaves room for how two ends sharpen each
/// other's tangents; rounding of a rope of ℓ m in n parts adds some 1e-16 √n ℓ/h.
fn sixth_order(h: f64, at: impl FnMut(f64) -> f64) -> f64 {
    let [a, b, c, d, e, f] = [-3.0, -2.0, -1.0, 1.0, 2.0, 3.0].map(|share| share * h).map(at);
    (45.0 * (d - c) - 9.0 * (e - b) + (f - a)) / (60.0 * h)
}

enum Outcome {
    Refused(String),
    TooSharp,
    Compared,
}

fn check_route(random: &mut Random) -> Outcome {
    let (system, state) = match build(&random_route(random)) {
        Ok(built) => built,
        Err(refused) => return Outcome::Refused(refused.problem),
    };
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    let finite = frame.value.iter().chain(&frame.gradient).all(|value| value.is_finite());
    assert!(finite && state.seats.iter().all(|seat| seat.wound.wrap.is_finite()));
    let rope = system.ropes().next().unwrap();
    let guides = &rope.route.guides;
    let touched: Vec<usize> =
        (0..guides.len()).filter(|&guide| !guides[guide].is_lifted(&state.seats)).collect();
    let parts: Vec<Part> = touched.windows(2).map(|pair| rope.route.between(pair[0], pair[1])).collect();
    let pace = parts.iter().map(|part| check_part(part, &frame)).fold(f64::INFINITY, f64::min);
    let h = 0.005 * pace.min(1.0);
    // Circles that are closer than the sum of their radii may have several tangents, and a step may lead from one to
    // another.
    let is_close = |part: &&Part| {
        let [from, to] = [part.from, part.to].map(|end| frame.kinematics.point(end.at.body, end.at.at));
        let [first, second] = [part.from, part.to].map(|end| end.sheave.map_or(0.0, |sheave| sheave.1));
        first.min(second) > 0.0 && (to - from).length() < first + second
    };
    if parts.iter().any(|part| is_close(&part)) {
        return Outcome::TooSharp;
    }
    // Where rounding alone might reach the tolerance nothing can be compared.
    if 2e-15 * rope.length / h > 2e-8 {
        return Outcome::TooSharp;
    }
    let kinematics = &frame.kinematics;
    let scale = |dof: usize| if kinematics.columns[dof].angular == DVec3::ZERO { 1.0 } else { TURN };
    let size = system.tree.velocities;
    let direction: Vec<f64> = (0..size).map(|dof| scale(dof) * random.between(-1.0, 1.0)).collect();
    let exact = system.rows.rate(&frame.gradient, 0, &direction);
    let mut moved = Frame::new(&system);
    let difference = sixth_order(h, |share| length_at(&system, &state, &direction, share, &mut moved));
    assert!((difference - exact).abs() < 1e-7, "h = {h:e}: {difference} {exact}");
    Outcome::Compared
}

/// First and last seed.
fn seeds() -> (u64, u64) {
    let Ok(given) = std::env::var("GANTLINE_ROUTE_SEEDS") else { return (1, 1) };
    let number = |text: &str| text.parse().expect("GANTLINE_ROUTE_SEEDS is like 3 or 1-20");
    let (first, last) = given.split_once('-').unwrap_or((&given, &given));
    (number(first), number(last))
}

#[test]
fn routes_in_space() {
    use NoTangent::{AlongEnd, AlongStart, Coincident, Grazing, InsideEnd, InsideStart, Overlapping};
    let named = [InsideStart, InsideEnd, AlongStart, AlongEnd, Overlapping, Coincident, Grazing];
    let named = named.map(|reason| reason.to_string());
    let (first, last) = seeds();
    for seed in first..=last {
        let (mut refused, mut sharp, mut compared) = (0, 0, 0);
        for number in 0..ROUTES as u64 {
            let mut random = Random(seed.wrapping_mul(0x5851_f42d_4c95_7f2d) ^ number);
            // Only seen where a check fails.
            println!("seed {seed}, route {number}");
            match check_route(&mut random) {
                Outcome::Refused(problem) => {
                    let is_named = named.iter().any(|reason| problem.ends_with(reason.as_str()));
                    assert!(is_named && problem.starts_with("its part "), "{problem}");
                    refused += 1;
                }
                Outcome::TooSharp => sharp += 1,
                Outcome::Compared => compared += 1,
            }
        }
        println!("seed {seed}: {compared} compared, {sharp} too sharp to compare, {refused} refused");
        assert!(compared > ROUTES / 2 && refused > ROUTES / 50 && sharp < ROUTES / 20);
    }
}
