//! A liquid in a tank: its surface stays level while the tank turns.
//!
//! Mass and inertia of the liquid are the body's, as if it were frozen where it lies when the body is upright, unless it
//! is pumped. What is added here is how its weight moves. With v its volume, b = ∫ r dV over it, r from the origin of the body, c where
//! its centre is frozen,
//!
//! ```text
//! U = ρ g ẑ·b′        M = −ρ g b′ × ẑ        b′ = b − v c
//! ```
//!
//! The level follows from v. A turn moves points of the surface S by w = δθ·(r × ẑ) upwards and the level by their
//! mean w̄, so that v stays:
//!
//! ```text
//! δb′ = δθ × b′ − ∫_S r (w − w̄) dA
//! ```
//!
//! To small angles that is the free-surface correction, ρ g i δθ with i the second moment of S about its own axis. The
//! liquid follows at once: there is no sloshing. How the level is found: (WA6).
//!
//! The content m = ρ v of a tank that is pumped is a coordinate that a drive moves. Then nothing of the liquid is the
//! body's: all of its weight acts here, at b itself, and all of its inertia, that of the liquid frozen upright, A(m) over
//! the velocity of the origin and the angular velocity ν, as [`super::added_mass`] moves it along. With z_o the height of
//! the origin, z_w the level that liquid outside has,
//!
//! ```text
//! U = g (m (z_o − z_w) + ρ ẑ·b)       E = U + ½ νᵀA(m)ν       f = −∂U/∂x − (A ν)˙ with m held
//! ∂E/∂m = g (z_S − z_w) + ½ νᵀA′ν     A′: a kilogram at S upright
//! ```
//!
//! Liquid that joins has the body's velocity, and liquid that leaves takes its own along: Ȧ stands in no equation of
//! motion. What the pump gives is then ∂E/∂m for each kilogram, its lift to the surface and its motion, and the sum
//! of all energies is kept. Between two tanks that is g Δz; the level z_w drops out.

use glam::{DMat3, DVec3};

use super::added_mass::AddedMass;
use super::square::{Square, outer, skew};
use super::{At, Feeding, Force, Tangent};
use crate::hull::{Hull, Immersion, Plane};
use crate::tree::bias::Wrench;
use crate::tree::kinematics::{Kinematics, Twist};
use crate::tree::pose::Pose;

/// Volume that the level may be wrong by, relative to the tank.
const LEVEL: f64 = 1e-14;
/// Share of the tank that is air or liquid at least where there is a surface.
const FREE: f64 = 1e-9;
/// Steps to the level, at most: halving alone would need fewer.
const STEPS: usize = 100;
/// Power of the depth with which what lies below the level grows, from which on it is taken for a power: 1 between upright
/// walls, 2 in a wedge, 3 in a corner.
const POWER: f64 = 1.5;

/// A tank with liquid in it.
#[derive(Debug, Clone)]
pub struct Tank {
    /// Name.
    pub name: String,
    /// Index of the body.
    pub body: usize,
    /// Inside of the tank, in the body's frame.
    pub hull: Hull,
    /// Density of the liquid [kg/m³].
    pub density: f64,
    /// Its volume at the start [m³].
    pub volume: f64,
    /// How much the tank holds [m³].
    pub capacity: f64,
    /// c: centre of the liquid with the body upright [m], body frame.
    pub frozen: DVec3,
    /// Where its content is a coordinate.
    pub pumped: Option<Pumped>,
    /// Its surface at the start with the body upright.
    upright: Option<Surface>,
}

/// A level surface in a tank, body frame.
#[derive(Debug, Clone, Copy)]
struct Surface {
    /// Its centre [m].
    centre: DVec3,
    /// Its area [m²].
    area: f64,
}

/// What a pump moves: a coordinate that counts what has been pumped in since the start.
#[derive(Debug, Clone, Copy)]
pub struct Pumped {
    /// Where it stands in q [kg].
    pub position: usize,
    /// In v.
    pub dof: usize,
    /// z_w: level from which liquid outside is pumped, along the vertical [m].
    pub level: f64,
}

/// The liquid in world axes about the body's origin.
struct Contents {
    up: DVec3,
    /// ρ g [N/m³].
    weight: f64,
    /// v [m³].
    volume: f64,
    /// b′, or b of a tank that is pumped [m⁴].
    shift: DVec3,
    /// ∫ (r − r̄)(r − r̄)ᵀ dA of the surface [m⁴].
    spread: DMat3,
}

impl Tank {
    /// A tank of which `volume` [m³] is full.
    pub fn new(name: String, body: usize, hull: Hull, capacity: f64, density: f64, volume: f64) -> Self {
        let mut tank = Self {
            name,
            body,
            hull,
            density,
            volume,
            capacity,
            frozen: DVec3::ZERO,
            pumped: None,
            upright: None,
        };
        if volume > 0.0 {
            let (below, _) = tank.contents(DVec3::Z, volume);
            tank.frozen = below.moment / volume;
            if Self::has_surface(volume / capacity) && below.area > 0.0 {
                tank.upright = Some(Surface { centre: below.area_moment / below.area, area: below.area });
            }
        }
        tank
    }

    /// What lies below the level of so much liquid where `up`, in the body's frame, points upwards, and the level.
    fn contents(&self, up: DVec3, volume: f64) -> (Immersion, Plane) {
        let (lowest, highest) = self.hull.span(up);
        // h = up·x + d is negative all over the tank for d = −highest.
        let (mut full, mut empty) = (-highest, -lowest);
        let ends = [full, empty];
        let mut height = self.guess(up, volume, ends);
        let mut below = self.hull.below(&Plane { normal: up, height });
        for _ in 0..STEPS {
            let excess = below.volume - volume;
            if excess.abs() <= LEVEL * self.capacity {
                break;
            }
            *(if excess > 0.0 { &mut full } else { &mut empty }) = height;
            let better = self.better(&below, volume, height, ends);
            let next = if better > full && better < empty { better } else { 0.5 * (full + empty) };
            if next == height {
                break;
            }
            height = next;
            below = self.hull.below(&Plane { normal: up, height });
        }
        (below, Plane { normal: up, height })
    }

    /// Where to look for the level first. A surface that tilts turns about its centre, exactly so between upright walls;
    /// where nothing is known of it, or that is no level in the tank, the share of the height that is full.
    fn guess(&self, up: DVec3, volume: f64, [full, empty]: [f64; 2]) -> f64 {
        let turned = self.upright.map(|Surface { centre, area }| {
            let more = (volume - self.volume) / area;
            -up.dot(centre + DVec3::Z * more)
        });
        let share = full + (1.0 - volume / self.capacity) * (empty - full);
        turned.filter(|height| *height > full && *height < empty).unwrap_or(share)
    }

    /// A better level from what lies below one: by Newton's method, and where liquid or air lie in a wedge or a corner, on
    /// the logarithms of volume and depth, of which Newton's would only halve the error.
    fn better(&self, below: &Immersion, volume: f64, height: f64, [full, empty]: [f64; 2]) -> f64 {
        let is_liquid = below.volume + volume < self.capacity;
        let (depth, part, asked) = if is_liquid {
            (empty - height, below.volume, volume)
        } else {
            (height - full, self.capacity - below.volume, self.capacity - volume)
        };
        let power = below.area * depth / part;
        if power < POWER || part <= 0.0 {
            return height + (below.volume - volume) / below.area;
        }
        let depth = depth * (asked / part).powf(1.0 / power);
        if is_liquid { empty - depth } else { full + depth }
    }

    /// What has been pumped in since the start [kg].
    pub fn content(&self, q: &[f64]) -> f64 {
        self.pumped.map_or(0.0, |pumped| q[pumped.position])
    }

    /// How much liquid there is once so much has been pumped in [m³].
    fn filled(&self, pumped: f64) -> f64 {
        (self.volume + pumped / self.density).clamp(0.0, self.capacity)
    }

    /// Share of what it holds that is in it.
    pub fn fill(&self, q: &[f64]) -> f64 {
        self.filled(self.content(q)) / self.capacity
    }

    /// Whether what is in it has a surface that is free, at such a share.
    pub fn has_surface(fill: f64) -> bool {
        fill > FREE && 1.0 - fill > FREE
    }

    /// Where the next drop goes: what lies below a surface that there always is.
    fn surface(&self, up: DVec3, pumped: f64) -> (Immersion, Plane) {
        self.contents(up, self.filled(pumped).clamp(FREE * self.capacity, (1.0 - FREE) * self.capacity))
    }

    /// How high its surface is, along the vertical [m], and the area of that [m²].
    pub fn lies(&self, pose: &Pose, gravity: DVec3, q: &[f64]) -> (f64, f64) {
        let up = -gravity.normalize();
        let (below, surface) = self.surface(pose.rotation.transpose() * up, self.content(q));
        (up.dot(pose.position) - surface.height, below.area)
    }

    fn at(&self, pose: &Pose, gravity: DVec3, pumped: f64) -> Contents {
        let (turn, up) = (pose.rotation, -gravity / gravity.length());
        let (weight, volume) = (self.density * gravity.length(), self.filled(pumped));
        // Of what is the body's only how it moves away from where it is frozen.
        let known = if self.pumped.is_some() { DVec3::ZERO } else { self.frozen * volume };
        if !Self::has_surface(volume / self.capacity) {
            let moment = if self.pumped.is_some() { self.contents(DVec3::Z, volume).0.moment } else { known };
            return Contents { up, weight, volume, shift: turn * (moment - known), spread: DMat3::ZERO };
        }
        let below = self.contents(turn.transpose() * up, volume).0;
        let central = if below.area > 0.0 {
            below.area_second - outer(below.area_moment, below.area_moment) * (1.0 / below.area)
        } else {
            DMat3::ZERO
        };
        Contents {
            up,
            weight,
            volume,
            shift: turn * (below.moment - known),
            spread: turn * central * turn.transpose(),
        }
    }

    /// Weight about the origin of the body.
    fn weight(&self, Contents { up, weight, volume, shift, .. }: &Contents) -> Wrench {
        let force = if self.pumped.is_some() { *up * -(weight * volume) } else { DVec3::ZERO };
        Wrench { force, moment: up.cross(*shift) * *weight }
    }

    /// The liquid of a tank that is pumped as what its body moves along, frozen upright.
    fn carried(&self, pumped: f64) -> AddedMass {
        let volume = self.filled(pumped);
        let (below, level) = self.contents(DVec3::Z, volume);
        let second = self.hull.second_below(&level);
        self.moved([volume, 1.0, 1.0].map(|part| part * self.density), below.moment, second)
    }

    /// What a kilogram more of it does to that.
    fn carried_more(&self, pumped: f64) -> AddedMass {
        let (below, _) = self.surface(DVec3::Z, pumped);
        let share = if below.area > 0.0 { 1.0 / below.area } else { 0.0 };
        self.moved([1.0, share, share], below.area_moment, below.area_second)
    }

    /// Inertia about the origin of a mass [kg] with a first and a second moment, each with its factor.
    fn moved(&self, [mass, on_first, on_second]: [f64; 3], first: DVec3, second: DMat3) -> AddedMass {
        let (arm, second) = (skew(first * on_first), second * on_second);
        let trace = second.x_axis.x + second.y_axis.y + second.z_axis.z;
        let matrix = Square {
            linear: DMat3::IDENTITY * mass,
            cross: -arm,
            back: arm,
            angular: DMat3::IDENTITY * trace - second,
        };
        AddedMass { name: String::new(), body: self.body, at: DVec3::ZERO, matrix }
    }
}

impl Force for Tank {
    fn name(&self) -> &str {
        &self.name
    }

    fn body(&self) -> usize {
        self.body
    }

    fn wrench(&self, at: &At) -> Wrench {
        let pumped = self.content(at.q);
        let Wrench { mut force, mut moment } = self.weight(&self.at(at.pose, at.gravity, pumped));
        if self.pumped.is_some() {
            let inertia = self.carried(pumped).wrench(at);
            force += inertia.force;
            moment += inertia.moment;
        }
        Wrench { force, moment }
    }

    fn tangent(&self, at: &At) -> Tangent {
        let pumped = self.content(at.q);
        let contents = self.at(at.pose, at.gravity, pumped);
        let Wrench { force, moment } = self.weight(&contents);
        let Contents { up, weight, shift, spread, .. } = contents;
        let lift = skew(up);
        let turn = -skew(shift) - spread * lift;
        // Seen from the body, what a turn does to the directions of force and moment does not count.
        let angular = lift * turn * weight + skew(moment);
        let carried = if self.pumped.is_some() { self.carried(pumped).tangent(at) } else { Tangent::NONE };
        Tangent { place: Square { angular, cross: skew(force), ..Square::ZERO }, ..carried }
    }

    fn energy(&self, pose: &Pose, gravity: DVec3, q: &[f64]) -> f64 {
        let Contents { up, weight, volume, shift, .. } = self.at(pose, gravity, self.content(q));
        let height = self.pumped.map_or(0.0, |pumped| up.dot(pose.position) - pumped.level);
        weight * (up.dot(shift) + volume * height)
    }

    fn energy_rate(&self, at: &At) -> f64 {
        -self.weight(&self.at(at.pose, at.gravity, self.content(at.q))).power(&at.twist)
    }

    fn inertia(&self, kinematics: &Kinematics) -> Option<Square> {
        let carried = || self.carried(self.content(&kinematics.q));
        self.pumped.map(|_| carried().inertia_at(&kinematics.pose[self.body]))
    }

    fn flow(&self) -> Option<usize> {
        self.pumped.map(|pumped| pumped.dof)
    }

    /// The opposite of what a pump has to give to a kilogram that it adds.
    fn feed(&self, at: &At) -> f64 {
        let Some(Pumped { level, .. }) = self.pumped else { return 0.0 };
        let pumped = self.content(at.q);
        let (turn, up) = (at.pose.rotation, -at.gravity / at.gravity.length());
        // The origin is so far above the surface.
        let (_, surface) = self.surface(turn.transpose() * up, pumped);
        let lift = up.dot(at.pose.position) - surface.height - level;
        let spin = turn.transpose() * at.twist.angular;
        let motion = Twist { angular: spin, linear: turn.transpose() * at.twist.linear };
        let momentum = self.carried_more(pumped).matrix.times(&motion);
        let kinetic = 0.5 * momentum.power(&motion);
        -(at.gravity.length() * lift + kinetic)
    }

    /// What a kilogram more does to the wrench. The row of the content is a drive's, no equation, so that its own
    /// derivatives are not needed.
    fn feeding(&self, at: &At) -> Option<Feeding> {
        self.pumped?;
        let (pumped, turn) = (self.content(at.q), at.pose.rotation);
        let (below, _) = self.surface(turn.transpose() * -at.gravity.normalize(), pumped);
        let mut wrench = self.carried_more(pumped).wrench(at);
        let centre = if below.area > 0.0 { below.area_moment / below.area } else { DVec3::ZERO };
        wrench.add(at.gravity, turn * centre);
        Some(Feeding { wrench: [wrench, Wrench::default()], body: [Wrench::default(); 2], flow: [0.0; 2] })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::hull::Mesh;

    /// A box with its lowest corner at the origin, `volume` [m³] of it full.
    fn tank(sides: DVec3, volume: f64) -> Tank {
        let corner = |k: usize| DVec3::new((k & 1) as f64, (k >> 1 & 1) as f64, (k >> 2) as f64) * sides;
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
        let hull = Hull::new(&Mesh { vertices: (0..8).map(corner).collect(), triangles });
        Tank::new("tank".into(), 0, hull, sides.element_product(), 1025.0, volume)
    }

    /// A level that is known is asked for again from another one: in a wedge, d = √(2 v n_x n_z/b) under an edge of length b,
    /// and in a corner, d = ∛(6 v n_x n_y n_z), liquid or air, one step leads there, to rounding of the volume of the tank.
    #[test]
    fn a_power_of_the_depth_is_found_in_one_step() {
        let sides = DVec3::new(26.0, 12.0, 8.0);
        let capacity = sides.element_product();
        for up in [DVec3::new(0.6, 0.0, 0.8), DVec3::new(0.48, 0.6, 0.64)] {
            for is_liquid in [true, false] {
                let depth = |volume: f64| {
                    if up.y == 0.0 {
                        (2.0 * volume * up.x * up.z / sides.y).sqrt()
                    } else {
                        (6.0 * volume * up.element_product()).cbrt()
                    }
                };
                let (part, asked) = (0.5, 3.0);
                let of = |part: f64| if is_liquid { part } else { capacity - part };
                let tank = tank(sides, of(asked));
                let (lowest, highest) = tank.hull.span(up);
                let height =
                    |part: f64| if is_liquid { -lowest - depth(part) } else { depth(part) - highest };
                let below = tank.hull.below(&Plane { normal: up, height: height(part) });
                assert!((below.volume - of(part)).abs() < 1e-12 * capacity);
                let found = tank.better(&below, of(asked), height(part), [-highest, -lowest]);
                assert!((found - height(asked)).abs() < 1e-11, "{found} {}", height(asked));
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(500))]

        /// Whichever way up, from drops to pressed up, and with more or less in it than at the start: the level is the one below
        /// which there is so much, to a few roundings of the volume of the tank.
        #[test]
        fn the_level_holds_what_there_is(
            sides in [0.5..30.0_f64, 0.5..30.0_f64, 0.5..10.0_f64],
            up in [-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64],
            lean in -8.0..0.0_f64,
            shares in [-7.0..7.0_f64, -7.0..7.0_f64],
        ) {
            let [start, now] = shares.map(|size| 1.0 / (1.0 + 10f64.powf(-size)));
            let up = (DVec3::Z + DVec3::from_array(up) * 10f64.powf(lean)).normalize();
            let sides = DVec3::from_array(sides);
            let capacity = sides.element_product();
            let tank = tank(sides, start * capacity);
            let (below, level) = tank.contents(up, now * capacity);
            prop_assert!((below.volume - now * capacity).abs() <= 4.0 * LEVEL * capacity, "{below:?}");
            prop_assert_eq!(below, tank.hull.below(&level));
        }
    }
}
