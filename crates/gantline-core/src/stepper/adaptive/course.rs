//! Motion as increments from the start of a step, and the course of a step in time.

use super::tableau::H;
use crate::force;
use crate::state::State;
use crate::system::System;

/// Increments of coordinates, velocities, accelerations, tensions of inextensible ropes, and anchors.
#[derive(Debug, Clone)]
pub struct Increment {
    /// φ.
    pub phi: Vec<f64>,
    /// Of v.
    pub v: Vec<f64>,
    /// Of a.
    pub a: Vec<f64>,
    /// Of T, by [`System::rigid`].
    pub rigid: Vec<f64>,
    /// α, by [`System::friction`].
    pub anchor: Vec<f64>,
    /// z of all forces that remember.
    pub past: Vec<f64>,
}

impl Increment {
    /// Zero, for `system`.
    pub fn zero(system: &System) -> Self {
        let size = system.tree.velocities;
        let (rigid, anchor) = (vec![0.0; system.rigid.len()], vec![0.0; system.friction.len()]);
        Self {
            phi: vec![0.0; system.tree.increments()],
            v: vec![0.0; size],
            a: vec![0.0; size],
            rigid,
            anchor,
            past: vec![0.0; force::states(&system.tree)],
        }
    }

    /// Takes over another one.
    fn copy_from(&mut self, other: &Self) {
        self.phi.copy_from_slice(&other.phi);
        self.v.copy_from_slice(&other.v);
        self.a.copy_from_slice(&other.a);
        self.rigid.copy_from_slice(&other.rigid);
        self.anchor.copy_from_slice(&other.anchor);
        self.past.copy_from_slice(&other.past);
    }

    /// Adds another one, times `weight`.
    fn add(&mut self, weight: f64, term: &Self) {
        add(&mut self.phi, weight, &term.phi);
        add(&mut self.v, weight, &term.v);
        add(&mut self.a, weight, &term.a);
        add(&mut self.rigid, weight, &term.rigid);
        add(&mut self.anchor, weight, &term.anchor);
        add(&mut self.past, weight, &term.past);
    }

    /// `base` + Σ weightⱼ termⱼ.
    pub(super) fn set(&mut self, weights: &[f64], terms: &[Self], base: &Self) {
        self.copy_from(base);
        for (&weight, term) in weights.iter().zip(terms) {
            if weight != 0.0 {
                self.add(weight, term);
            }
        }
    }
}

/// `out` += `weight` · `values`.
pub(super) fn add(out: &mut [f64], weight: f64, values: &[f64]) {
    for (out, value) in out.iter_mut().zip(values) {
        *out += weight * value;
    }
}

/// A step that has been computed and not yet made: a course in time from `start` on, in the share θ of the step
///
/// ```text
/// y(θ) = (1−θ) y + θ y₊ + θ(1−θ) z₁ + θ²(1−θ) z₂ + θ³(1−θ) z₃        z = Σ hⱼ kⱼ (see `tableau`)
/// ```
#[derive(Debug, Clone)]
pub struct Course {
    /// Length [s].
    pub h: f64,
    /// v, a, T and z at the start; φ and α are 0.
    pub(super) start: Increment,
    /// Motion at the end: φ, v, a.
    pub end: Increment,
    /// Error estimate.
    pub error: Increment,
    /// z₁, z₂, z₃ of the dense output.
    dense: [Increment; 3],
    none: Increment,
}

impl Course {
    /// Room for `system`.
    pub(super) fn new(system: &System) -> Self {
        let zero = || Increment::zero(system);
        let dense = [zero(), zero(), zero()];
        Self { h: 0.0, start: zero(), end: zero(), error: zero(), dense, none: zero() }
    }

    /// Starts it where `state` is.
    pub(super) fn begin(&mut self, system: &System, state: &State) {
        self.start.v.copy_from_slice(&state.v);
        self.start.a.copy_from_slice(&state.acceleration);
        self.start.past.copy_from_slice(&state.past);
        for (tension, &row) in self.start.rigid.iter_mut().zip(&system.rigid) {
            *tension = state.tension[row];
        }
    }

    /// Ends it, of length `h` [s]: y₊ is the place of the last stage and its increment, which is the error estimate too.
    pub(super) fn finish(&mut self, h: f64, last_place: &Increment, stages: &[Increment]) {
        self.h = h;
        if let Some(last) = stages.last() {
            self.end.copy_from(last_place);
            self.end.add(1.0, last);
            self.error.copy_from(last);
        }
        for (term, weights) in self.dense.iter_mut().zip(&H) {
            term.set(weights, stages, &self.none);
        }
    }

    /// Motion at the share `theta` of the step.
    pub fn at(&self, theta: f64, out: &mut Increment) {
        let rest = 1.0 - theta;
        let [first, second, third] = [theta * rest, theta * theta * rest, theta * theta * theta * rest];
        let mix = |k: usize, start: f64, end: &[f64], z: [&[f64]; 3]| {
            rest * start + theta * end[k] + first * z[0][k] + second * z[1][k] + third * z[2][k]
        };
        let [z1, z2, z3] = &self.dense;
        for k in 0..out.phi.len() {
            out.phi[k] = mix(k, 0.0, &self.end.phi, [&z1.phi, &z2.phi, &z3.phi]);
        }
        for k in 0..out.v.len() {
            out.v[k] = mix(k, self.start.v[k], &self.end.v, [&z1.v, &z2.v, &z3.v]);
            out.a[k] = mix(k, self.start.a[k], &self.end.a, [&z1.a, &z2.a, &z3.a]);
        }
        for k in 0..out.rigid.len() {
            let terms: [&[f64]; 3] = [&z1.rigid, &z2.rigid, &z3.rigid];
            out.rigid[k] = mix(k, self.start.rigid[k], &self.end.rigid, terms);
        }
        for k in 0..out.anchor.len() {
            out.anchor[k] = mix(k, 0.0, &self.end.anchor, [&z1.anchor, &z2.anchor, &z3.anchor]);
        }
        for k in 0..out.past.len() {
            out.past[k] = mix(k, self.start.past[k], &self.end.past, [&z1.past, &z2.past, &z3.past]);
        }
    }

    /// Derivative over time of φ, v and α at the share `theta`, in `out.phi`, `out.v` and `out.anchor`.
    pub fn rate_at(&self, theta: f64, out: &mut Increment) {
        // d/dθ of (1−θ) y + θ y₊ + (θ − θ²) z₁ + (θ² − θ³) z₂ + (θ³ − θ⁴) z₃.
        let slopes = [1.0 - 2.0 * theta, theta * (2.0 - 3.0 * theta), theta * theta * (3.0 - 4.0 * theta)];
        let [z1, z2, z3] = &self.dense;
        for k in 0..out.phi.len() {
            let phi = self.end.phi[k] + slopes[0] * z1.phi[k] + slopes[1] * z2.phi[k] + slopes[2] * z3.phi[k];
            out.phi[k] = phi / self.h;
        }
        for k in 0..out.v.len() {
            let v = self.end.v[k] - self.start.v[k]
                + slopes[0] * z1.v[k]
                + slopes[1] * z2.v[k]
                + slopes[2] * z3.v[k];
            out.v[k] = v / self.h;
        }
        for k in 0..out.anchor.len() {
            let terms = slopes[0] * z1.anchor[k] + slopes[1] * z2.anchor[k] + slopes[2] * z3.anchor[k];
            out.anchor[k] = (self.end.anchor[k] + terms) / self.h;
        }
    }

    /// The course of the flows of light sheaves, as far as it is recorded: straight to where `end` has them.
    pub fn straighten(&mut self, system: &System, share: f64, end: &Increment) {
        for &dof in system.light.iter().flat_map(|light| &light.dofs) {
            for term in &mut self.dense {
                (term.phi[dof], term.v[dof], term.a[dof]) = (0.0, 0.0, 0.0);
            }
            self.end.phi[dof] = end.phi[dof] / share;
            self.end.v[dof] = self.start.v[dof] + (end.v[dof] - self.start.v[dof]) / share;
            (self.start.a[dof], self.end.a[dof]) = (0.0, 0.0);
        }
    }
}
