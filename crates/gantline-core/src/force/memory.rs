//! What water remembers of a body's motion: waves that it has made push it until they are gone (Cummins 1962).
//!
//! ```text
//! F(t) = −∫₀^∞ K(s) ν(t − s) ds        K(s) = Re Σ R e^{ps}        Re p < 0
//! ```
//!
//! ν holds the velocity of a point P of the body and the angular velocity, in the body's axes; forces act at P. Where
//! waves push the body, both are along the axes of their forces, level ones that turn with the slow heading
//! ([`super::slow`]): forces along axes that roll and others along axes that do not would leave a mean of the second order,
//! a part of the drift force without the rest. With one state z of six numbers for each term that is
//!
//! ```text
//! ż = p z + ν        F = −Re Σ R z
//! ```
//!
//! A step of length h with κ = γh needs (1 − κp)⁻¹ and what the force answers to ν within it, the transfer function of K
//! at 1/κ:
//!
//! ```text
//! κ Re Σ R (1 − κp)⁻¹
//! ```
//!
//! As seen from those axes F depends on z alone. What it takes from the body is never negative in the whole, where K is
//! passive: Re K(iω) without negative eigenvalues. At a moment it may give back.

use glam::DVec3;

use super::axes::Axes;
use super::slow::Slow;
use super::square::Square;
use super::{AnyForce, At, Force, Tangent, under};
use crate::tree::Tree;
use crate::tree::bias::Wrench;
use crate::tree::kinematics::{Kinematics, Twist};
use crate::tree::pose::Pose;

/// Numbers of a state z: real parts of three translations and three rotations, then imaginary parts.
const WIDTH: usize = 12;

/// A decaying part of K.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Term {
    /// p [1/s], real and imaginary part.
    pub pole: [f64; 2],
    /// R about P, real and imaginary part.
    pub residue: [Square; 2],
}

impl Term {
    /// (1 − κp)⁻¹, real and imaginary part.
    fn answer(&self, kappa: f64) -> [f64; 2] {
        let (real, imaginary) = (1.0 - kappa * self.pole[0], -kappa * self.pole[1]);
        let size = real * real + imaginary * imaginary;
        [real / size, -imaginary / size]
    }
}

/// Memory of the water around a body.
#[derive(Debug, Clone)]
pub struct Memory {
    /// Name.
    pub name: String,
    /// Index of the body.
    pub body: usize,
    /// P [m], body frame.
    pub at: DVec3,
    /// K.
    pub terms: Vec<Term>,
    /// First number of its states among those of all forces.
    pub first: usize,
    /// What its axes turn with where waves push the body.
    pub slow: Option<Slow>,
}

impl Memory {
    /// Where its states are among those of all forces.
    pub fn states(&self) -> std::ops::Range<usize> {
        self.first..self.first + WIDTH * self.terms.len()
    }

    fn axes(&self, pose: &Pose, past: &[f64], time: f64) -> Axes {
        Axes::new(pose, self.at, self.slow.as_ref().and_then(|slow| slow.at(past, time)))
    }

    /// ν of the motion of the body.
    pub fn motion(&self, at: &At) -> [f64; 6] {
        self.axes(at.pose, at.past, at.time).motion(&at.twist)
    }

    /// ∂ν/∂t, as far as the axes turn by themselves: −ψ̇ e_z × ν.
    pub fn motion_over_time(&self, at: &At) -> [f64; 6] {
        let axes = self.axes(at.pose, at.past, at.time);
        let (turning, [x, y, _, p, q, _]) = (axes.turning.unwrap_or(0.0), axes.motion(&at.twist));
        [turning * y, -turning * x, 0.0, turning * q, -turning * p, 0.0]
    }

    /// What changes of the body's motion, as seen from there, do to ν, and what a turn of the body along `over` does
    /// to it beside: the motion of `at` turns along, axes that stay do not.
    pub fn changes_of_motion(&self, at: &At, [place, velocity]: [Twist; 2], over: DVec3) -> [[f64; 6]; 2] {
        let axes = self.axes(at.pose, at.past, at.time);
        let mut changed = Twist { linear: place.at(axes.arm), angular: place.angular };
        if axes.turning.is_some() {
            changed.linear += over.cross(at.twist.at(axes.arm));
            changed.angular += over.cross(at.twist.angular);
        }
        [axes.along(&changed), axes.motion(&velocity)]
    }

    /// ν under one unit of every degree of freedom that moves the body.
    pub fn columns(&self, tree: &Tree, kinematics: &Kinematics) -> Vec<[f64; 6]> {
        let pose = &kinematics.pose[self.body];
        let axes = self.axes(pose, &kinematics.past, kinematics.time);
        let of = |&dof: &usize| {
            let linear = kinematics.point_column(tree, dof, pose.position);
            axes.motion(&Twist { angular: kinematics.columns[dof].angular, linear })
        };
        tree.support[self.body].iter().map(of).collect()
    }

    /// `out` += scale · (p z + ν), for the states `past` of all forces.
    pub fn add_rate(&self, past: &[f64], motion: &[f64; 6], scale: f64, out: &mut [f64]) {
        let states = past[self.states()].chunks_exact(WIDTH).zip(out[self.states()].chunks_exact_mut(WIDTH));
        for (term, (z, out)) in self.terms.iter().zip(states) {
            let [real, imaginary] = term.pole;
            for k in 0..6 {
                out[k] += scale * (real * z[k] - imaginary * z[6 + k] + motion[k]);
                out[6 + k] += scale * (real * z[6 + k] + imaginary * z[k]);
            }
        }
    }

    /// `states` = (1 − κp)⁻¹ (states + κν), for those of all forces.
    pub fn answer(&self, kappa: f64, motion: &[f64; 6], states: &mut [f64]) {
        for (term, z) in self.terms.iter().zip(states[self.states()].chunks_exact_mut(WIDTH)) {
            let [real, imaginary] = term.answer(kappa);
            for k in 0..6 {
                let known = [z[k] + kappa * motion[k], z[6 + k]];
                z[k] = real * known[0] - imaginary * known[1];
                z[6 + k] = real * known[1] + imaginary * known[0];
            }
        }
    }

    /// Re Σ R z at P, for the states of all forces; nothing where nothing has moved yet.
    fn held(&self, past: &[f64]) -> Wrench {
        let mut sum = Wrench::default();
        let states = past.get(self.states()).unwrap_or_default();
        for (term, z) in self.terms.iter().zip(states.chunks_exact(WIDTH)) {
            let twist = |z: &[f64]| Twist {
                linear: DVec3::from_slice(&z[..3]),
                angular: DVec3::from_slice(&z[3..6]),
            };
            let (real, imaginary) =
                (term.residue[0].times(&twist(z)), term.residue[1].times(&twist(&z[6..])));
            sum.force += real.force - imaginary.force;
            sum.moment += real.moment - imaginary.moment;
        }
        sum
    }

    /// The wrench at P, world axes, and the axes that it is along.
    fn pushing(&self, at: &At) -> (Wrench, Axes) {
        let Wrench { force, moment } = self.held(at.past);
        let axes = self.axes(at.pose, at.past, at.time);
        (Wrench { force: axes.turn * -force, moment: axes.turn * -moment }, axes)
    }

    /// The opposite of the force with the states `past` of all forces along motions ν of the body.
    pub fn along(&self, past: &[f64], motion: &[f64; 6]) -> f64 {
        let Wrench { force, moment } = self.held(past);
        force.dot(DVec3::from_slice(&motion[..3])) + moment.dot(DVec3::from_slice(&motion[3..]))
    }

    /// κ Re Σ R (1 − κp)⁻¹ [N s/m, N s, N m s], about P.
    pub fn damping(&self, kappa: f64) -> Square {
        let mut sum = Square::ZERO;
        for term in &self.terms {
            let [real, imaginary] = term.answer(kappa);
            sum.add(kappa * real, &term.residue[0]);
            sum.add(-kappa * imaginary, &term.residue[1]);
        }
        sum
    }

    /// Damping B(ω) [N s/m, N s, N m s], and added mass above that of infinite frequency, A(ω) − A(∞) [kg, kg m, kg m²],
    /// about P: ∫ K(s) e^{−iωs} ds = B + iω (A − A(∞)).
    pub fn at_frequency(&self, omega: f64) -> [Square; 2] {
        let mut found = [Square::ZERO; 2];
        for term in &self.terms {
            // ½ (R/(iω − p) + R̄/(iω − p̄)) = (iω Re R − Re (R p̄))/(iω − p)(iω − p̄)
            let [a, b] = term.pole;
            let (real, imaginary) = (a * a + b * b - omega * omega, -2.0 * a * omega);
            let size = real * real + imaginary * imaginary;
            let [whole, turned] = term.residue;
            // Re (R p̄) = a Re R + b Im R; the numerator's real part is its opposite.
            let mut known = Square::ZERO;
            known.add(-a, &whole);
            known.add(-b, &turned);
            found[0].add(real / size, &known);
            found[0].add(omega * imaginary / size, &whole);
            found[1].add(real / size, &whole);
            // −Im/ω of what is known, finite at ω = 0.
            found[1].add(2.0 * a / size, &known);
        }
        found
    }
}

impl Force for Memory {
    fn name(&self) -> &str {
        &self.name
    }

    fn body(&self) -> usize {
        self.body
    }

    fn wrench(&self, at: &At) -> Wrench {
        let (wrench, axes) = self.pushing(at);
        wrench.about(axes.arm)
    }

    fn tangent(&self, at: &At) -> Tangent {
        let (Wrench { force, moment }, axes) = self.pushing(at);
        if axes.turning.is_none() {
            return Tangent::NONE;
        }
        Tangent::of_what_stays(force, moment, axes.arm)
    }

    fn over_time(&self, at: &At) -> Option<Wrench> {
        let (Wrench { force, moment }, axes) = self.pushing(at);
        let spin = DVec3::Z * axes.turning?;
        Some(Wrench { force: spin.cross(force), moment: spin.cross(moment) }.about(axes.arm))
    }

    fn loss(&self, at: &At) -> f64 {
        self.along(at.past, &self.motion(at))
    }
}

/// Those among the forces of a tree.
pub fn memories(tree: &Tree) -> impl Iterator<Item = &Memory> {
    tree.forces
        .iter()
        .filter_map(|force| if let AnyForce::Memory(memory) = force { Some(memory) } else { None })
}

/// How many numbers the states of all forces of a tree are.
pub fn states(tree: &Tree) -> usize {
    memories(tree).map(|memory| memory.states().len()).sum()
}

/// The first half of a step of length `h` [s] by the trapezoidal rule, explicit: `past` += (p z + ν) h/2 with the velocity
/// `v` of the step and z at its start, where `kinematics` is.
pub fn set_out(tree: &Tree, kinematics: &Kinematics, (v, h): (&[f64], f64), past: &mut [f64]) {
    for memory in memories(tree) {
        let at = under(tree, kinematics, memory.body, v);
        memory.add_rate(&kinematics.past, &memory.motion(&at), 0.5 * h, past);
    }
}

/// The second half, implicit, where `kinematics` is at the end of the step: `past` = (1 − hp/2)⁻¹ (z + νh/2).
pub fn arrive(tree: &Tree, kinematics: &mut Kinematics, (v, h): (&[f64], f64), past: &mut [f64]) {
    for memory in memories(tree) {
        let at = under(tree, kinematics, memory.body, v);
        let motion = memory.motion(&at);
        memory.answer(0.5 * h, &motion, past);
    }
    kinematics.past.copy_from_slice(past);
}

/// xᵀ B(ω) x [W] for the rates `x` of all degrees of freedom.
pub fn resistance(tree: &Tree, kinematics: &Kinematics, omega: f64, x: &[f64]) -> f64 {
    let mut sum = 0.0;
    resistances(tree, kinematics, omega, |[one, other], entry| sum += entry * x[one] * x[other]);
    sum
}

/// Entries of the symmetric B(ω), by row and column.
pub fn resistances(tree: &Tree, kinematics: &Kinematics, omega: f64, mut visit: impl FnMut([usize; 2], f64)) {
    for memory in memories(tree) {
        let damping = memory.at_frequency(omega)[0].rows();
        let (columns, support) = (memory.columns(tree, kinematics), &tree.support[memory.body]);
        for (index, one) in columns.iter().enumerate() {
            for (place, other) in columns.iter().enumerate() {
                let both = form(&damping, one, other) + form(&damping, other, one);
                visit([support[index], support[place]], 0.5 * both);
            }
        }
    }
}

/// aᵀ M b.
pub fn form(matrix: &[[f64; 6]; 6], a: &[f64; 6], b: &[f64; 6]) -> f64 {
    let row = |row: &[f64; 6]| -> f64 { row.iter().zip(b).map(|(entry, b)| entry * b).sum() };
    a.iter().zip(matrix).map(|(a, entries)| a * row(entries)).sum()
}
