//! A mooring line: an elastic catenary from a point of a body to a point of the world.
//!
//! The line has no inertia: it hangs at any moment as it would at rest ([`catenary`]). With ρ the place of its upper end
//! from its lower one and L its unstretched length it holds
//!
//! ```text
//! E(ρ, L) = U(X, Z, L) − w ẑ·ρ (L − L₀) − EA ε₀² (L − L₀)/2        F = −∂E/∂ρ        Q = −∂E/∂L
//! ```
//!
//! The second part is the weight of what a winch has paid out: on the winch it is in the mass of the body. The third is what
//! the rope on the winch holds, which lies there with the strain ε₀ of the start: a winch that pays out s of stretched
//! rope gives L = L₀ + s/(1 + ε₀). So the forces are those of a potential, and the work of the winch is all of what the line gains.
//!
//! In X = √(|ρ_h|² + δ²), and on a bed in Z = (ẑ·ρ + √((ẑ·ρ)² + δ²))/2, δ = L₀/10⁶ takes away the corner above the lower
//! end and at the bed, with no trace beyond it.
//!
//! Damping is that of the line stretched as a whole. With its mean strain e(ρ, L) and its damping time τ
//!
//! ```text
//! (F, Q) = −τ EA L ė (∂e/∂ρ, ∂e/∂L)        loss τ EA L ė²
//! ```
//!
//! A line that has parted bears nothing.

pub mod catenary;
pub mod jet;

use glam::{DMat3, DVec3};

use super::square::{Square, outer, skew};
use super::{At, Feeding, Force, Tangent, under};
use crate::tree::Tree;
use crate::tree::bias::Wrench;
use crate::tree::kinematics::Kinematics;
use crate::tree::pose::Pose;
use catenary::{Catenary, Hanging};
use jet::Jet;

/// δ over the unstretched length.
const ROUND: f64 = 1e-6;

/// Chords of a drawn line.
pub const CHORDS: usize = 40;

/// The winch of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Winch {
    /// Degree of freedom of its flow.
    pub dof: usize,
    /// Coordinate of its flow in q: stretched rope paid out since the start [m].
    pub position: usize,
    /// 1/(1 + ε₀).
    pub unstretched: f64,
    /// EA ε₀²/2 [N].
    pub held: f64,
}

/// A mooring line.
#[derive(Debug, Clone)]
pub struct Mooring {
    /// Name.
    pub name: String,
    /// Index of the body that it holds.
    pub body: usize,
    /// Its upper end [m], body frame.
    pub at: DVec3,
    /// Its lower end [m], in the world.
    pub to: DVec3,
    /// How it hangs.
    pub line: Catenary,
    /// L₀ [m].
    pub length: f64,
    /// τ [s].
    pub damping_time: f64,
    /// What hauls it in and pays it out.
    pub winch: Option<Winch>,
    /// Tension at which it breaks [N].
    pub breaking_force: Option<f64>,
    /// Its energy where it hangs down from its lower end [J], from where it counts.
    pub lowest: f64,
    /// Where q says whether it has parted: 0 as long as it holds.
    pub mark: usize,
}

/// Value and first derivatives over place and length of a line.
#[derive(Debug, Clone, Copy)]
struct Slopes {
    value: f64,
    place: DVec3,
    length: f64,
}

/// Second derivatives.
#[derive(Debug, Clone, Copy)]
struct Bends {
    place_place: DMat3,
    place_length: DVec3,
    length_length: f64,
}

/// A line where it is and how it moves.
struct Reach {
    /// From the origin of the body to the upper end, world axes.
    arm: DVec3,
    /// Velocity of the upper end.
    velocity: DVec3,
    length: f64,
    energy: Slopes,
    strain: Slopes,
    /// ė.
    rate: f64,
    /// τ EA L ė.
    damper: f64,
    /// Weight that has been paid out.
    paid_out: DVec3,
}

impl Reach {
    /// Force on the upper end and on the length.
    fn force(&self) -> (DVec3, f64) {
        let Self { energy, strain, damper, .. } = self;
        (-energy.place - strain.place * *damper, -energy.length - strain.length * damper)
    }
}

/// What a line does to a body and to the flow of its winch, as both move: derivatives of F and of the force on the flow over
/// the place of the upper end and what the winch has paid out, and over the rates of both.
struct Derivatives {
    force_place: DMat3,
    force_rate: DMat3,
    /// Of F over the flow; the same of the force on the flow over the place.
    cross_place: [DVec3; 2],
    cross_rate: DVec3,
    flow_place: f64,
    flow_rate: f64,
}

impl Mooring {
    /// True as long as it has not parted.
    pub fn is_whole(&self, q: &[f64]) -> bool {
        q[self.mark] == 0.0
    }

    /// L [m].
    pub fn length_at(&self, q: &[f64]) -> f64 {
        self.winch.map_or(self.length, |winch| self.length + winch.unstretched * q[winch.position])
    }

    /// X with its slope, and Z with its first two derivatives over the height.
    fn distances(&self, place: DVec3, up: DVec3) -> (DVec3, f64, [f64; 3]) {
        let delta = ROUND * self.length;
        let height = place.dot(up);
        let aside = place - up * height;
        let reach = (aside.length_squared() + delta * delta).sqrt();
        let rise = if self.line.on_bed {
            let root = height.hypot(delta);
            [0.5 * (height + root), 0.5 * (1.0 + height / root), 0.5 * delta * delta / (root * root * root)]
        } else {
            [height, 1.0, 0.0]
        };
        (aside, reach, rise)
    }

    /// How it hangs with its upper end at `place` from its lower one, with the length `length` [m].
    fn hanging<const N: usize>(&self, place: DVec3, up: DVec3, length: f64) -> Hanging<N> {
        let (_, reach, [rise, ..]) = self.distances(place, up);
        self.line.hang(reach, rise, length)
    }

    /// A function of X, Z and L over place and length.
    fn slopes<const N: usize>(&self, place: DVec3, up: DVec3, jet: &Jet<N>) -> Slopes {
        let (aside, reach, [_, climb, _]) = self.distances(place, up);
        let [over_x, over_z, over_l] = jet.first;
        Slopes { value: jet.value, place: aside / reach * over_x + up * (over_z * climb), length: over_l }
    }

    /// The same of its derivatives.
    fn bends(&self, place: DVec3, up: DVec3, jet: &Jet) -> Bends {
        let (aside, reach, [_, climb, bend]) = self.distances(place, up);
        let out = aside / reach;
        let level = DMat3::IDENTITY - outer(up, up);
        let [over_x, over_z, _] = jet.first;
        let second = &jet.second;
        Bends {
            place_place: outer(out, out) * second[0][0]
                + (level - outer(out, out)) * (over_x / reach)
                + (outer(out, up) + outer(up, out)) * (second[0][1] * climb)
                + outer(up, up) * (second[1][1] * climb * climb + over_z * bend),
            place_length: out * second[0][2] + up * (second[1][2] * climb),
            length_length: second[2][2],
        }
    }

    /// What it holds, and its mean strain, hanging as it does.
    fn held<const N: usize>(
        &self,
        place: DVec3,
        up: DVec3,
        length: f64,
        hanging: &Hanging<N>,
    ) -> [Slopes; 2] {
        let (paid, held) = (length - self.length, self.winch.map_or(0.0, |winch| winch.held));
        let mut energy = self.slopes(place, up, &hanging.energy);
        let weight = up * self.line.weight;
        energy.value -= weight.dot(place) * paid + held * paid + self.lowest;
        energy.place -= weight * paid;
        energy.length -= weight.dot(place) + held;
        [energy, self.slopes(place, up, &hanging.strain)]
    }

    /// The same of their derivatives.
    fn held_bends(&self, place: DVec3, up: DVec3, hanging: &Hanging) -> [Bends; 2] {
        let mut energy = self.bends(place, up, &hanging.energy);
        energy.place_length -= up * self.line.weight;
        [energy, self.bends(place, up, &hanging.strain)]
    }

    /// Where it is and how it moves.
    fn reach(&self, at: &At) -> Reach {
        self.reach_hanging::<0>(at).0
    }

    /// The same and how it hangs.
    fn reach_hanging<const N: usize>(&self, at: &At) -> (Reach, Hanging<N>) {
        let up = -at.gravity / at.gravity.length();
        let arm = at.pose.rotation * self.at;
        let length = self.length_at(at.q);
        let velocity = at.twist.at(arm);
        let paying = self.winch.map_or(0.0, |winch| winch.unstretched * at.v[winch.dof]);
        let place = at.pose.position + arm - self.to;
        let hanging = self.hanging(place, up, length);
        let [energy, strain] = self.held(place, up, length, &hanging);
        let rate = strain.place.dot(velocity) + strain.length * paying;
        let damper = self.damping_time * self.line.stiffness * length * rate;
        let paid_out = up * (self.line.weight * (length - self.length));
        (Reach { arm, velocity, length, energy, strain, rate, damper, paid_out }, hanging)
    }

    /// Where it is and how it moves, and second derivatives of energy and strain.
    fn reach_with_bends(&self, at: &At) -> (Reach, [Bends; 2]) {
        let (reach, hanging) = self.reach_hanging(at);
        let up = -at.gravity / at.gravity.length();
        let bends = self.held_bends(at.pose.position + reach.arm - self.to, up, &hanging);
        (reach, bends)
    }

    /// Tension at its upper end [N].
    pub fn tension(&self, at: &At) -> f64 {
        if !self.is_whole(at.q) {
            return 0.0;
        }
        let reach = self.reach(at);
        // What is paid out is lighter for the body, not for the line.
        (reach.force().0 - reach.paid_out).length()
    }

    /// What its damper does to the body and to the flow of its winch.
    pub fn damping(&self, at: &At) -> (Wrench, f64) {
        if !self.is_whole(at.q) {
            return (Wrench::default(), 0.0);
        }
        let Reach { arm, strain, damper, .. } = self.reach(at);
        let force = strain.place * -damper;
        let unstretched = self.winch.map_or(0.0, |winch| winch.unstretched);
        (Wrench { force, moment: arm.cross(force) }, -strain.length * damper * unstretched)
    }

    /// The same under the velocity coordinates `v`.
    pub fn tension_of(&self, tree: &Tree, kinematics: &Kinematics, v: &[f64]) -> f64 {
        self.tension(&under(tree, kinematics, self.body, v))
    }

    /// How its tension at rest changes in a time under the velocity coordinates `v`, on a body that is carried along with
    /// `carried` besides: by where they bring it, and by its damper because they do [N/s, N].
    pub fn tension_rates(&self, tree: &Tree, kinematics: &Kinematics, v: &[f64], carried: DVec3) -> [f64; 2] {
        let mut at = under(tree, kinematics, self.body, v);
        at.twist.linear += carried;
        if !self.is_whole(at.q) {
            return [0.0; 2];
        }
        let (Reach { velocity, energy, strain, damper, paid_out, .. }, [bends, _]) =
            self.reach_with_bends(&at);
        let paying = self.winch.map_or(0.0, |winch| winch.unstretched * v[winch.dof]);
        let way = (energy.place + paid_out).normalize_or_zero();
        let up = -at.gravity / at.gravity.length();
        let change = bends.place_place * velocity + (bends.place_length + up * self.line.weight) * paying;
        [way.dot(change), way.dot(strain.place) * damper]
    }

    /// Its stretched length [m], and places along it from its upper end to its lower, [`CHORDS`] + 1 of them.
    pub fn draw(&self, pose: &Pose, gravity: DVec3, q: &[f64], mut place: impl FnMut(DVec3)) -> f64 {
        let top = pose.point(self.at);
        if !self.is_whole(q) {
            (0..=CHORDS).for_each(|_| place(top));
            return 0.0;
        }
        let (up, length) = (-gravity / gravity.length(), self.length_at(q));
        let from = top - self.to;
        let hanging = self.hanging::<0>(from, up, length);
        let (aside, reach, _) = self.distances(from, up);
        for chord in 0..=CHORDS {
            let share = 1.0 - chord as f64 / CHORDS as f64;
            let [out, rise] = self.line.place(&hanging, length, share);
            place(if chord == 0 { top } else { self.to + aside * (out / reach) + up * rise });
        }
        length * (1.0 + hanging.strain.value)
    }

    /// Stiffness with which it holds its upper end, world axes, symmetric [N/m].
    pub fn stiffness(&self, pose: &Pose, gravity: DVec3, q: &[f64]) -> DMat3 {
        if !self.is_whole(q) {
            return DMat3::ZERO;
        }
        let up = -gravity / gravity.length();
        let place = pose.point(self.at) - self.to;
        self.held_bends(place, up, &self.hanging(place, up, self.length_at(q)))[0].place_place
    }

    /// Takes this place of its body for the start: what lies on its winch has the strain that its upper end has here, and
    /// its energy counts from where it hangs from its lower end. Returns its tension, and its mean strain.
    pub fn start(&mut self, pose: &Pose, gravity: DVec3) -> (f64, f64) {
        let Catenary { weight, stiffness, on_bed } = self.line;
        let up = -gravity / gravity.length();
        let hanging = self.hanging::<0>(pose.point(self.at) - self.to, up, self.length);
        let tension = hanging.horizontal.hypot(hanging.vertical);
        let strain = tension / stiffness;
        if let Some(winch) = &mut self.winch {
            (winch.unstretched, winch.held) = (1.0 / (1.0 + strain), 0.5 * tension * strain);
        }
        let whole = weight * self.length;
        // −Φ(0, 0).
        self.lowest =
            if on_bed { 0.0 } else { -0.5 * whole * self.length * (1.0 + whole / (3.0 * stiffness)) };
        (tension, hanging.strain.value)
    }

    fn derivatives(&self, at: &At, reach: &Reach, [energy, mean]: &[Bends; 2]) -> Derivatives {
        let Reach { velocity, length, strain, rate, damper, .. } = reach;
        let unstretched = self.winch.map_or(0.0, |winch| winch.unstretched);
        let paying = self.winch.map_or(0.0, |winch| unstretched * at.v[winch.dof]);
        let viscosity = self.damping_time * self.line.stiffness;
        // ∂ė over place and length.
        let turned = mean.place_place * *velocity + mean.place_length * paying;
        let fed = mean.place_length.dot(*velocity) + mean.length_length * paying;
        let factor = viscosity * length;
        let by_place = turned * factor;
        let by_length = factor * fed + viscosity * rate;
        let cross = energy.place_length + mean.place_length * *damper;
        Derivatives {
            force_place: -energy.place_place - mean.place_place * *damper - outer(strain.place, by_place),
            force_rate: outer(strain.place, strain.place) * -factor,
            cross_place: [
                -(cross + strain.place * by_length) * unstretched,
                -(cross + by_place * strain.length) * unstretched,
            ],
            cross_rate: strain.place * (-factor * strain.length * unstretched),
            flow_place: -(energy.length_length + mean.length_length * damper + strain.length * by_length)
                * unstretched
                * unstretched,
            flow_rate: -factor * strain.length * strain.length * unstretched * unstretched,
        }
    }
}

impl Force for Mooring {
    fn name(&self) -> &str {
        &self.name
    }

    fn body(&self) -> usize {
        self.body
    }

    fn wrench(&self, at: &At) -> Wrench {
        self.push(at).0
    }

    fn tangent(&self, at: &At) -> Tangent {
        if !self.is_whole(at.q) {
            return Tangent::NONE;
        }
        let (reach, bends) = self.reach_with_bends(at);
        let (force, _) = reach.force();
        let derivatives = self.derivatives(at, &reach, &bends);
        let (arm, by_place, by_rate) = (skew(reach.arm), derivatives.force_place, derivatives.force_rate);
        // A turn moves the upper end, turns the velocity that it has along, and leaves the force where it was.
        let turn = -(by_place * arm) - by_rate * skew(reach.velocity) + skew(force);
        let place = Square { linear: by_place, cross: turn, back: arm * by_place, angular: arm * turn };
        let only = Square { linear: by_rate, ..Square::ZERO };
        Tangent { place, velocity: only.about(reach.arm), ..Tangent::NONE }
    }

    fn energy(&self, pose: &Pose, gravity: DVec3, q: &[f64]) -> f64 {
        if !self.is_whole(q) {
            return 0.0;
        }
        let up = -gravity / gravity.length();
        let (place, length) = (pose.point(self.at) - self.to, self.length_at(q));
        self.held(place, up, length, &self.hanging::<0>(place, up, length))[0].value
    }

    fn energy_rate(&self, at: &At) -> f64 {
        if !self.is_whole(at.q) {
            return 0.0;
        }
        let Reach { energy, velocity, .. } = self.reach(at);
        let paying = self.winch.map_or(0.0, |winch| winch.unstretched * at.v[winch.dof]);
        energy.place.dot(velocity) + energy.length * paying
    }

    fn loss(&self, at: &At) -> f64 {
        if !self.is_whole(at.q) {
            return 0.0;
        }
        let reach = self.reach(at);
        reach.damper * reach.rate
    }

    fn flow(&self) -> Option<usize> {
        self.winch.map(|winch| winch.dof)
    }

    fn feed(&self, at: &At) -> f64 {
        self.push(at).1
    }

    fn push(&self, at: &At) -> (Wrench, f64) {
        if !self.is_whole(at.q) {
            return (Wrench::default(), 0.0);
        }
        let reach = self.reach(at);
        let (force, on_length) = reach.force();
        let feed = self.winch.map_or(0.0, |winch| winch.unstretched * on_length);
        (Wrench { force, moment: reach.arm.cross(force) }, feed)
    }

    fn feeding(&self, at: &At) -> Option<Feeding> {
        if self.winch.is_none() || !self.is_whole(at.q) {
            return None;
        }
        let (reach, bends) = self.reach_with_bends(at);
        let Derivatives { cross_place: [over_flow, over_place], cross_rate, flow_place, flow_rate, .. } =
            self.derivatives(at, &reach, &bends);
        let on_body = |force: DVec3| Wrench { force, moment: reach.arm.cross(force) };
        let mut place = on_body(over_place);
        place.moment += reach.velocity.cross(cross_rate);
        Some(Feeding {
            wrench: [on_body(over_flow), on_body(cross_rate)],
            body: [place, on_body(cross_rate)],
            flow: [flow_place, flow_rate],
        })
    }
}
