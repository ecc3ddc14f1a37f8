//! Holes of tanks: liquid runs out of them, or water in, by the difference of heads.
//!
//! With a the height of the surface in the tank over the hole and b that of the water outside, both 0 below it, ρ and ρ_w
//! their densities and c the share of the ideal flow that passes the edges of the hole, area A (Torricelli):
//!
//! ```text
//! H = (ρ a⁺ − ρ_w b⁺)/ρ_f        ṁ = −ρ c A √(2 g (|H| − d)⁺) sgn H        ρ_f: of what flows
//! ```
//!
//! The head d lets nothing flow, so that equal levels come to rest, and do so in a finite time.
//!
//! The content is a coordinate that a drive moves. At every glance it is worked out how it goes on until the next one: its own
//! equation, with a growing by ṁ/(ρ S) over the surface S and both heights going on as the body moves them, in parts of h by
//! the exponential Rosenbrock–Euler step (Hochbruck and Ostermann, *Acta Numerica* 19 (2010) 209–286)
//!
//! ```text
//! m₊ = m + h φ₁(h J) ṁ(m, t + h/2)        J = ∂ṁ/∂m ≤ 0        φ₁(z) = (eᶻ − 1)/z
//! ```
//!
//! of second order, and at rest where J is large. The rate goes from u to the rate v at the next glance as a ramp, with what
//! the ramps have missed made good by it: of T (u + v)/2 = Δ the difference is added to v once. Where the content only
//! decays, by x = T |J|, content and rate go on with roots of λ² = k (λ + 1), k = e⁻ˣ (1 − x/2)/2: 1 and −1/2 where it hardly
//! does, 0 where it is stiff, so that it comes to rest however large the hole. What begins from rest is T/6 late: the first
//! ramps bring 3/4, 9/8, 15/16 … of what runs in T.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::course::Motion;
use crate::force::tank::Tank;
use crate::tree::kinematics::Kinematics;

/// Time between glances [s].
pub const EVERY: f64 = 0.2;
/// Parts in which the content is worked out until the next one.
const PARTS: usize = 8;
/// d: head that lets nothing flow [m].
const STILL: f64 = 1e-4;
/// Share of what the tank holds that counts as nothing in the time between glances.
const NOTHING: f64 = 1e-12;

/// A hole.
#[derive(Debug, Clone, PartialEq)]
pub struct Hole {
    /// Its middle in the frame of the body [m].
    pub at: DVec3,
    /// c A [m²].
    pub passes: f64,
    /// Whether it is open at the start.
    pub is_open: bool,
    /// Steps of the plan that open or close it as they begin, in their order, and whether it is open from then on.
    pub turns: Vec<(usize, bool)>,
}

impl Hole {
    /// Whether it is open once so many steps have begun.
    fn is_open_after(&self, begun: usize) -> bool {
        self.turns.iter().rev().find(|turn| turn.0 < begun).map_or(self.is_open, |turn| turn.1)
    }
}

/// A tank with holes.
#[derive(Debug, Clone)]
pub struct Holed {
    /// What is in it, of which the content is a coordinate.
    pub tank: Box<Tank>,
    /// The drive of that.
    pub drive: usize,
    /// Its holes.
    pub holes: Vec<Hole>,
    /// Density of the water outside [kg/m³]; 0 of air.
    pub outside: f64,
    /// z_w: level of the water outside [m], along the vertical.
    pub level: f64,
    /// Gravity [m/s²].
    pub gravity: DVec3,
}

/// Heights over a hole, and how fast they grow as the body moves.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
struct Heights {
    /// a: of the surface inside [m].
    inside: f64,
    /// b: of the water outside [m].
    outside: f64,
    /// Of both, with so much in the tank [m/s].
    rates: [f64; 2],
}

/// What is known of a tank with holes between glances.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Running {
    /// Time of the next glance [s].
    pub next: f64,
    /// When it was last seen [s], and what had run in since the start [kg].
    seen: Option<(f64, f64)>,
    heights: Vec<Heights>,
}

impl Running {
    /// From the start on.
    pub fn new(of: &Holed) -> Self {
        Self { next: 0.0, seen: None, heights: vec![Heights::default(); of.holes.len()] }
    }

    /// Takes over what `other` knows of the same tank.
    pub fn copy_from(&mut self, other: &Self) {
        (self.next, self.seen) = (other.next, other.seen);
        self.heights.copy_from_slice(&other.heights);
    }

    /// Glances; the rate to which the content goes until the next glance [kg/s]. `now` is how it runs in, and so many
    /// steps have begun.
    pub fn glance(&mut self, of: &Holed, now: Motion, kinematics: &Kinematics, begun: usize) -> f64 {
        let at = self.next;
        self.next += EVERY;
        let pose = &kinematics.pose[of.tank.body];
        let (level, area) = of.tank.lies(pose, of.gravity, &kinematics.q);
        let (up, content) = (-of.gravity.normalize(), of.tank.content(&kinematics.q));
        // A kilogram more lets the surface rise by so much.
        let rise = if area > 0.0 { 1.0 / (of.tank.density * area) } else { 0.0 };
        for (hole, heights) in of.holes.iter().zip(&mut self.heights) {
            let place = up.dot(pose.point(hole.at));
            let (inside, outside) = (level - place, of.level - place);
            if let Some((time, before)) = self.seen
                && kinematics.time > time
            {
                let share = 1.0 / (kinematics.time - time);
                let moved = inside - heights.inside - (content - before) * rise;
                heights.rates = [moved * share, (outside - heights.outside) * share];
            }
            (heights.inside, heights.outside) = (inside, outside);
        }
        self.seen = Some((kinematics.time, content));
        // Steps of fixed length do not end where it glances.
        let late = at - kinematics.time;
        let rate = |content_then: f64, later: f64| {
            of.flow((&self.heights, begun), (content_then - content) * rise, late + later, rise)
        };
        let [least, most] = of.room();
        let (mut then, part) = (now.position, EVERY / PARTS as f64);
        for k in 0..PARTS {
            let (flow, slope) = rate(then, (k as f64 + 0.5) * part);
            let z = part * slope;
            let share = if z == 0.0 { 1.0 } else { z.exp_m1() / z };
            then = (then + part * share * flow).clamp(least, most);
        }
        let (last, _) = rate(then, EVERY);
        let missed = (then - now.position) / EVERY - 0.5 * (now.velocity + last);
        // Neither empty nor full may be passed by a ramp to rest after this one.
        let bound = |end: f64| (end - now.position) / EVERY - 0.5 * now.velocity;
        let velocity = (last + missed).max(bound(least)).min(bound(most));
        if velocity.abs() * EVERY <= NOTHING * (most - least) { 0.0 } else { velocity }
    }
}

impl Holed {
    /// What may have run in since the start, least and most [kg].
    fn room(&self) -> [f64; 2] {
        let Tank { density, volume, capacity, .. } = *self.tank;
        [-density * volume, density * (capacity - volume)]
    }

    /// ṁ and its derivative by the content, where the surface has risen by `risen` [m] and both heights have gone on for
    /// `later` [s], once so many steps have begun.
    fn flow(&self, (heights, begun): (&[Heights], usize), risen: f64, later: f64, rise: f64) -> (f64, f64) {
        let (g, density) = (self.gravity.length(), self.tank.density);
        let (mut flow, mut slope) = (0.0, 0.0);
        let every = self.holes.iter().zip(heights);
        for (hole, over) in every.filter(|(hole, _)| hole.is_open_after(begun)) {
            let inside = (over.inside + risen + over.rates[0] * later).max(0.0);
            let outside = (over.outside + over.rates[1] * later).max(0.0);
            let pressed = density * inside - self.outside * outside;
            let flowing = if pressed > 0.0 { density } else { self.outside };
            let head = pressed.abs() / flowing - STILL;
            if flowing == 0.0 || head <= 0.0 {
                continue;
            }
            let passed = density * hole.passes * (2.0 * g * head).sqrt();
            flow -= passed * pressed.signum();
            if inside > 0.0 {
                slope -= 0.5 * passed / head * density / flowing * rise;
            }
        }
        (flow, slope)
    }
}

#[cfg(test)]
mod tests {
    use glam::DMat3;

    use super::*;
    use crate::force::tank::Pumped;
    use crate::hull::{Hull, Mesh};
    use crate::plan::drive::Timeline;
    use crate::tree::Tree;
    use crate::tree::pose::Pose;

    const G: f64 = 9.81;
    const DENSITY: f64 = 1025.0;
    /// Sides of the tank [m], bottom in the middle of the body.
    const BOX: [f64; 3] = [4.0, 3.0, 2.0];

    fn holed(volume: f64, holes: Vec<Hole>, outside: f64, level: f64) -> Holed {
        let [x, y, z] = BOX;
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let at = |[a, b]: [f64; 2], c: f64| DVec3::new(x * (a - 0.5), y * (b - 0.5), z * c);
        let vertices =
            corners.iter().map(|&one| at(one, 0.0)).chain(corners.iter().map(|&one| at(one, 1.0))).collect();
        let mut triangles = vec![[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7]];
        for k in 0..4 {
            let next = (k + 1) % 4;
            triangles.extend([[k, next, next + 4], [k, next + 4, k + 4]]);
        }
        let hull = Hull::new(&Mesh { vertices, triangles });
        let mut tank = Tank::new(String::new(), 0, hull, x * y * z, DENSITY, volume);
        tank.pumped = Some(Pumped { position: 0, dof: 0, level });
        let gravity = -G * DVec3::Z;
        Holed { tank: Box::new(tank), drive: 0, holes, outside, level, gravity }
    }

    /// What has run in over time, at the glances, as the body heaves.
    fn run(of: &Holed, heave: impl Fn(f64) -> f64, lasts: f64) -> Vec<(f64, f64)> {
        let mut kinematics = Kinematics::new(&Tree::new(Vec::new(), DVec3::ZERO));
        let (mut timeline, mut running) = (Timeline::new(0.0, 0), Running::new(of));
        let mut found = Vec::new();
        while running.next < lasts {
            let now = running.next;
            let motion = timeline.added(now);
            let position = DVec3::Z * heave(now);
            kinematics.pose = vec![Pose { position, rotation: DMat3::IDENTITY }];
            (kinematics.time, kinematics.q) = (now, vec![motion.position]);
            found.push((now, motion.position));
            let velocity = running.glance(of, motion, &kinematics, 0);
            timeline.add(now, (now, EVERY), velocity);
        }
        found
    }

    fn hole(z: f64, passes: f64) -> Hole {
        Hole { at: DVec3::new(1.0, -1.0, z), passes, is_open: true, turns: Vec::new() }
    }

    /// √h falls evenly: √h = √h₀ − c A √(2g) t/2S, h over the hole and the head that lets nothing flow, from T/6 on. How far it is
    /// off, as a share of what was in it, while half runs out.
    fn off_torricelli(passes: f64) -> f64 {
        let volume = 18.0;
        let of = holed(volume, vec![hole(0.0, passes)], 0.0, 0.0);
        let (area, depth) = (BOX[0] * BOX[1], volume / (BOX[0] * BOX[1]) - STILL);
        let fall = 0.5 * passes * (2.0 * G).sqrt() / area;
        let mut worst: f64 = 0.0;
        for (time, content) in run(&of, |_| 0.0, 0.3 * depth.sqrt() / fall).split_off(40) {
            let root = depth.sqrt() - fall * (time - EVERY / 6.0);
            let left = DENSITY * area * (root * root + STILL);
            worst = worst.max((DENSITY * volume + content - left).abs() / (DENSITY * volume));
        }
        worst
    }

    /// Of second order: glances that are twice as far apart, in the time that it takes to drain, are four times as far off.
    #[test]
    fn it_drains_as_torricelli_says() {
        let found = [0.008, 0.016, 0.032].map(off_torricelli);
        assert!(found[2] < 1e-5, "{found:?}");
        for pair in found.windows(2) {
            assert!((3.5..4.5).contains(&(pair[1] / pair[0])), "{found:?}");
        }
    }

    /// Above both levels nothing passes; what is above the hole stays.
    #[test]
    fn what_is_below_a_hole_stays() {
        let of = holed(18.0, vec![hole(0.5, 0.05)], 0.0, 0.0);
        let (_, content) = run(&of, |_| 0.0, 600.0)[2999];
        let kept = DENSITY * BOX[0] * BOX[1] * (0.5 + STILL);
        assert!((DENSITY * 18.0 + content - kept).abs() < 1e-6 * kept, "{content}");
        let of = holed(3.0, vec![hole(0.5, 0.05)], 0.0, 0.0);
        assert!(run(&of, |_| 0.0, 20.0).iter().all(|&(_, content)| content == 0.0));
    }

    /// Up to holes of half the bottom: the level comes to that of the sea, and to rest to the last digit. Where it fills within a
    /// few glances it goes past that first, by no more than 1 % of the head at the start.
    #[test]
    fn equal_levels_come_to_rest_however_large_the_hole() {
        for passes in [0.01, 0.1, 1.0, 7.0] {
            let of = holed(3.0, vec![hole(0.0, passes)], DENSITY, 1.5);
            let found = run(&of, |_| 0.0, 1500.0);
            let level = |content: f64| 0.25 + content / (DENSITY * BOX[0] * BOX[1]);
            let highest = found.iter().map(|&(_, content)| level(content)).fold(0.0, f64::max);
            assert!(highest < 1.5 + 0.01 * 1.25, "{passes} {highest}");
            let last = found[found.len() - 100..].iter();
            assert!(last.clone().all(|&(_, content)| (level(content) - 1.5).abs() < 2.0 * STILL), "{passes}");
            assert!(last.map(|one| one.1).all(|content| content == found[found.len() - 1].1), "{passes}");
        }
    }

    /// Never less than nothing in it, nor more than it holds, however it heaves.
    #[test]
    fn neither_empty_nor_full_is_passed() {
        for passes in [0.05, 1.0, 7.0] {
            let of = holed(12.0, vec![hole(0.0, passes), hole(1.9, passes)], DENSITY, 1.0);
            let [least, most] = of.room();
            for (time, content) in run(&of, |time| 2.5 * (0.8 * time).sin(), 200.0) {
                assert!(content >= least - 1e-6 && content <= most + 1e-6, "{passes} {time} {content}");
            }
        }
    }
}
