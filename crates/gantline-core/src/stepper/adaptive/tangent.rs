//! The unsymmetric matrix of an implicit step with exact tangents,
//!
//! ```text
//! [ M + κD + κ ∂τ/∂v + κ² (∂τ/∂q + Σ T ∂G/∂q) P    Gᵀ              ]
//! [ ((G + τ Ġ) κP + τ G)/(κ + τ)                   −ε/(κ (κ + τ))  ]
//! ```
//!
//! κ = γh. The unknowns are the rate of the coordinates' increments and κ times those of the forces. P is 1 but
//! for rotation vectors, P = (1 + κ[ω]/2)⁻¹ there, since φ̇ = ω + φ×ω/2 + …; Ġ = ∂ė/∂q. A sliding contact's
//! rows say T = μ N d instead, an inextensible rope's G + κ γ_v + κ² γ_q P and 0, γ = G v̇ + Ġ v; a slack row is
//! an identity row.

use glam::{DMat3, DVec3};

use super::evaluation::{Evaluation, pull_of, rotation};
use crate::constraint::Law;
use crate::solver::complementarity::Mode;
use crate::solver::layout::{Group, Layout, NONE};
use crate::solver::ldu::Ldu;
use crate::solver::symbolic::ZeroPivot;
use crate::state::State;
use crate::system::System;
use crate::tree::mass::MassMatrix;
use crate::tree::tangent::DynamicsTangent;

/// A group with the places of its entries.
#[derive(Debug, Clone)]
struct Block {
    group: Group,
    /// Matrix entry of (j, k) at j · size + k, or a driven one's place, see [`Slot`].
    slots: Vec<Slot>,
    /// Index in the row's entries of every degree of freedom.
    row_entries: Vec<usize>,
    /// Offset of every triple of rotations within the group, and its body.
    triples: Vec<(usize, usize)>,
    curvature: Vec<f64>,
}

/// Where a number goes: into the matrix, into the columns of driven degrees of freedom, or nowhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Slot {
    Matrix(usize),
    Driven(usize),
    Nowhere,
}

/// The matrix, with what is needed to make it anew for another step length.
#[derive(Debug, Clone)]
pub struct TangentMatrix {
    /// Unknowns.
    pub layout: Layout,
    ldu: Ldu,
    dynamics: DynamicsTangent,
    /// Lower and upper slots of the mass matrix's pattern.
    lower: Vec<Slot>,
    upper: Vec<Slot>,
    /// Row entries: in the row, and in its transpose.
    in_row: Vec<Slot>,
    in_column: Vec<Slot>,
    /// (lower or upper position entries of three columns) of every row and joint with rotations.
    triples: Vec<(usize, [(usize, bool); 3])>,
    diagonal: Vec<usize>,
    friction: Vec<(usize, usize)>,
    blocks: Vec<Block>,
    /// Ġ + …: ∂ė/∂q of every row entry.
    turning: Vec<f64>,
    /// Offset of triples in row entries and their body.
    row_triples: Vec<(usize, usize)>,
    /// (unknown, driven degree of freedom) of every driven entry, and its number.
    driven_places: Vec<(usize, usize)>,
    driven: Vec<f64>,
    position: crate::tree::tangent::Paired,
    scratch: Vec<f64>,
    columns: Vec<DVec3>,
    right: Vec<f64>,
    /// γ_v and γ_q of inextensible ropes, by row entry.
    pull_velocity: Vec<f64>,
    pull_position: Vec<f64>,
    probe: Evaluation,
    direction: Vec<f64>,
}

impl TangentMatrix {
    /// Pattern for `system`.
    pub fn new(system: &System) -> Self {
        let layout = Layout::new(system);
        let ldu = Ldu::new(layout.symbolic.clone());
        let mass = MassMatrix::new(&system.tree);
        let mut driven_places = Vec::new();
        let mut slot = |row: usize, column: usize, dof: usize| {
            if row == NONE {
                return Slot::Nowhere;
            }
            if column == NONE {
                driven_places.push((row, dof));
                return Slot::Driven(driven_places.len() - 1);
            }
            ldu.entry(row, column).map_or(Slot::Nowhere, Slot::Matrix)
        };
        let unknown = |dof: usize| layout.unknown[dof];
        let (mut lower, mut upper) = (Vec::new(), Vec::new());
        for dof in 0..system.tree.velocities {
            for &other in &mass.columns[mass.row_start[dof]..mass.row_start[dof + 1]] {
                lower.push(slot(unknown(dof), unknown(other), other));
                upper.push(slot(unknown(other), unknown(dof), dof));
            }
        }
        let (mut in_row, mut in_column) = (Vec::new(), Vec::new());
        for row in 0..system.rows.count() {
            for &dof in &system.rows.dofs[system.rows.start[row]..system.rows.start[row + 1]] {
                in_row.push(slot(layout.row(row), unknown(dof), dof));
                in_column.push(slot(unknown(dof), layout.row(row), dof));
            }
        }
        let blocks = layout
            .groups
            .iter()
            .map(|group| {
                let pairs = group.dofs.iter().flat_map(|&j| group.dofs.iter().map(move |&k| (j, k)));
                let slots = pairs.map(|(j, k)| slot(unknown(j), unknown(k), k)).collect();
                let entries = system.rows.start[group.row]..system.rows.start[group.row + 1];
                let dofs = &system.rows.dofs[entries.clone()];
                let row_entries =
                    group.dofs.iter().map(|&dof| entries.start + dofs.partition_point(|&other| other < dof));
                Block {
                    slots,
                    row_entries: row_entries.collect(),
                    triples: triples_of(system, &group.dofs),
                    curvature: vec![0.0; group.dofs.len() * group.dofs.len()],
                    group: group.clone(),
                }
            })
            .collect();
        let size = layout.symbolic.size();
        let friction = |row: usize, law: &Law| match law {
            Law::Friction { normal, .. } => ldu.entry(layout.row(row), layout.row(*normal)),
            Law::Unilateral { .. } => None,
        };
        let laws = system.rows.laws.iter().enumerate();
        let mut row_triples = Vec::new();
        for row in 0..system.rows.count() {
            let entries = system.rows.start[row]..system.rows.start[row + 1];
            let found = triples_of(system, &system.rows.dofs[entries.clone()]);
            row_triples.extend(found.into_iter().map(|(offset, body)| (entries.start + offset, body)));
        }
        Self {
            friction: laws.filter_map(|(row, law)| friction(row, law).map(|entry| (row, entry))).collect(),
            diagonal: (0..size).map(|k| ldu.entry(k, k).unwrap_or(NONE)).collect(),
            dynamics: DynamicsTangent::new(&system.tree, &mass),
            position: DynamicsTangent::new(&system.tree, &mass).position,
            triples: tree_triples(system, &mass),
            turning: vec![0.0; system.rows.dofs.len()],
            driven: vec![0.0; driven_places.len()],
            scratch: vec![0.0; system.rows.dofs.len()],
            columns: vec![DVec3::ZERO; layout.groups.iter().map(|group| group.dofs.len()).max().unwrap_or(0)],
            right: vec![0.0; size],
            pull_velocity: vec![0.0; system.rows.dofs.len()],
            pull_position: vec![0.0; system.rows.dofs.len()],
            probe: Evaluation::new(system),
            direction: vec![0.0; system.tree.velocities],
            row_triples,
            lower,
            upper,
            in_row,
            in_column,
            blocks,
            driven_places,
            layout,
            ldu,
        }
    }

    /// Evaluates all derivatives at the start of a step.
    pub fn linearise(&mut self, system: &System, here: &Evaluation, mass: &MassMatrix, state: &State) {
        let (v, acts) = (&state.v, &state.modes);
        let kinematics = &here.frame.kinematics;
        self.dynamics.update(&system.tree, kinematics, mass, &here.dynamics, v);
        self.turning.fill(0.0);
        self.pull_velocity.fill(0.0);
        for block in &mut self.blocks {
            if acts[block.group.row] == Mode::Slack {
                continue;
            }
            let Group { constraint, number, dofs, .. } = &block.group;
            let constraint = &system.constraints[*constraint];
            let (columns, out) = (&mut self.columns, &mut block.curvature);
            constraint.curvature(&system.tree, kinematics, *number, columns, out);
            let size = dofs.len();
            for (j, &dof) in dofs.iter().enumerate() {
                for (k, &entry) in block.row_entries.iter().enumerate() {
                    self.turning[entry] += v[dof] * block.curvature[j * size + k];
                    self.pull_velocity[entry] +=
                        v[dof] * (block.curvature[j * size + k] + block.curvature[k * size + j]);
                }
            }
        }
        for &row in system.rigid.iter().filter(|&&row| acts[row] == Mode::Acting) {
            self.linearise_pull(system, state, row);
        }
    }

    /// ∂γ/∂q by central differences; v and v̇ stay. The third derivative of the length that it holds is the only
    /// one that has no formula here.
    fn linearise_pull(&mut self, system: &System, state: &State, row: usize) {
        const STEP: f64 = 1e-6;
        for entry in system.rows.start[row]..system.rows.start[row + 1] {
            let dof = system.rows.dofs[entry];
            let mut at = |step: f64| {
                self.direction[dof] = step;
                self.probe.q.copy_from_slice(&state.q);
                system.tree.advance(&mut self.probe.q, &self.direction);
                self.direction[dof] = 0.0;
                let Evaluation { q, frame, dynamics, imbalance, .. } = &mut self.probe;
                frame.kinematics.update(&system.tree, q);
                let a = Some(state.acceleration.as_slice());
                dynamics.update(&system.tree, &frame.kinematics, &state.v, a, None, imbalance);
                pull_of(system, frame, dynamics, row)
            };
            self.pull_position[entry] = (at(STEP) - at(-STEP)) / (2.0 * STEP);
        }
    }

    /// γ_v r of an inextensible rope, by its number in [`System::rigid`].
    pub fn pull_rate(&self, system: &System, index: usize, r: &[f64]) -> f64 {
        system.rows.rate(&self.pull_velocity, system.rigid[index], r)
    }

    /// What the rates `r` do to the force of a sliding row through its direction, times κ.
    pub fn slip_rate(&self, system: &System, here: &Evaluation, slip: &[f64], row: usize, r: &[f64]) -> f64 {
        let law = &system.rows.laws[row];
        let Law::Friction { normal, .. } = *law else { return 0.0 };
        let [own, other] = slip_weights(law, here, slip, row);
        let partner = 2 * normal + 3 - row;
        let gradient = &here.frame.gradient;
        own * system.rows.rate(gradient, row, r) + other * system.rows.rate(gradient, partner, r)
    }

    /// Solution of a row after [`TangentMatrix::solve`]: κ times the increment of its force.
    pub fn row_solution(&self, row: usize) -> f64 {
        self.right[self.layout.row(row)]
    }

    /// Makes and factorises the matrix for κ = `kappa` [s].
    ///
    /// # Errors
    /// [`ZeroPivot`] where it is singular.
    pub fn factorise(
        &mut self,
        system: &System,
        here: &Evaluation,
        mass: &MassMatrix,
        state: &State,
        kappa: f64,
    ) -> Result<(), ZeroPivot> {
        self.ldu.values_mut().fill(0.0);
        self.driven.fill(0.0);
        let spins = Spins { system, v: &state.v, kappa };
        self.put_dynamics(system, mass, &spins);
        for block in 0..self.blocks.len() {
            let row = self.blocks[block].group.row;
            if here.tension[row] != 0.0 {
                self.put_block(block, kappa * kappa * here.tension[row], &spins);
            }
        }
        self.put_rows(system, here, state, &spins);
        self.ldu.factorise()
    }

    fn put_dynamics(&mut self, system: &System, mass: &MassMatrix, spins: &Spins) {
        let kappa = spins.kappa;
        self.position.lower.copy_from_slice(&self.dynamics.position.lower);
        self.position.upper.copy_from_slice(&self.dynamics.position.upper);
        for &(body, entries) in &self.triples {
            let p = spins.p(body);
            let get = |(slot, is_lower): (usize, bool)| {
                if is_lower { self.position.lower[slot] } else { self.position.upper[slot] }
            };
            let turned = p.transpose() * DVec3::from_array(entries.map(get));
            for ((slot, is_lower), value) in entries.into_iter().zip(turned.to_array()) {
                if is_lower {
                    self.position.lower[slot] = value;
                } else {
                    self.position.upper[slot] = value;
                }
            }
        }
        for dof in 0..system.tree.velocities {
            for slot in mass.row_start[dof]..mass.row_start[dof + 1] {
                let diagonal = slot + 1 == mass.row_start[dof + 1];
                let mut value = mass.values[slot]
                    + kappa * self.dynamics.velocity.lower[slot]
                    + kappa * kappa * self.position.lower[slot];
                if diagonal {
                    value += kappa * system.tree.damping[dof];
                } else {
                    let other = mass.values[slot]
                        + kappa * self.dynamics.velocity.upper[slot]
                        + kappa * kappa * self.position.upper[slot];
                    put(self.ldu.values_mut(), &mut self.driven, self.upper[slot], other);
                }
                put(self.ldu.values_mut(), &mut self.driven, self.lower[slot], value);
            }
        }
    }

    fn put_block(&mut self, index: usize, scale: f64, spins: &Spins) {
        let block = &self.blocks[index];
        let size = block.group.dofs.len();
        for j in 0..size {
            let row = &block.curvature[j * size..(j + 1) * size];
            let slots = &block.slots[j * size..(j + 1) * size];
            let scratch = &mut self.scratch[..size];
            scratch.copy_from_slice(row);
            for &(offset, body) in &block.triples {
                turn(&mut scratch[offset..offset + 3], &spins.p(body));
            }
            for (value, &slot) in scratch.iter().zip(slots) {
                put(self.ldu.values_mut(), &mut self.driven, slot, scale * value);
            }
        }
    }

    fn put_rows(&mut self, system: &System, here: &Evaluation, state: &State, spins: &Spins) {
        let State { modes, slip, .. } = state;
        let kappa = spins.kappa;
        let gradient = &here.frame.gradient;
        for row in 0..system.rows.count() {
            let tau = system.rows.laws[row].damping_time();
            for entry in system.rows.start[row]..system.rows.start[row + 1] {
                self.scratch[entry] = gradient[entry] + tau * self.turning[entry];
            }
        }
        for &row in &system.rigid {
            let entries = system.rows.start[row]..system.rows.start[row + 1];
            self.scratch[entries.clone()].copy_from_slice(&self.pull_position[entries]);
        }
        for &(entry, body) in &self.row_triples {
            turn(&mut self.scratch[entry..entry + 3], &spins.p(body));
        }
        let base = self.layout.free.len();
        for (row, law) in system.rows.laws.iter().enumerate() {
            let diagonal = self.diagonal[base + row];
            let (tau, compliance) = (law.damping_time(), law.compliance());
            match modes[row] {
                Mode::Slack => self.ldu.values_mut()[diagonal] = -1.0,
                Mode::Slipping => {
                    self.ldu.values_mut()[diagonal] = -1.0;
                    let [first, second] = slip_weights(law, here, slip, row).map(|weight| kappa * weight);
                    let partner = partner_offset(system, law, row);
                    for entry in system.rows.start[row]..system.rows.start[row + 1] {
                        let other = entry.wrapping_add_signed(partner);
                        let value = first * gradient[entry] + second * gradient[other];
                        let values = self.ldu.values_mut();
                        put(values, &mut self.driven, self.in_row[entry], value);
                        put(values, &mut self.driven, self.in_column[entry], gradient[entry]);
                    }
                }
                Mode::Acting if compliance == 0.0 => {
                    for entry in system.rows.start[row]..system.rows.start[row + 1] {
                        let turning = kappa * self.pull_velocity[entry] + kappa * kappa * self.scratch[entry];
                        let values = self.ldu.values_mut();
                        put(values, &mut self.driven, self.in_row[entry], gradient[entry] + turning);
                        put(values, &mut self.driven, self.in_column[entry], gradient[entry]);
                    }
                    self.ldu.values_mut()[diagonal] = 0.0;
                }
                Mode::Acting => {
                    for entry in system.rows.start[row]..system.rows.start[row + 1] {
                        let value = (kappa * self.scratch[entry] + tau * gradient[entry]) / (kappa + tau);
                        let values = self.ldu.values_mut();
                        put(values, &mut self.driven, self.in_row[entry], value);
                        put(values, &mut self.driven, self.in_column[entry], gradient[entry]);
                    }
                    self.ldu.values_mut()[diagonal] = -compliance / (kappa * (kappa + tau));
                }
            }
        }
        for &(row, entry) in &self.friction {
            if let (Mode::Slipping, Law::Friction { coefficient, normal, .. }) =
                (modes[row], system.rows.laws[row])
            {
                let direction = here.slip_direction(normal, slip)[row - normal - 1];
                self.ldu.values_mut()[entry] = coefficient * direction;
            }
        }
    }

    /// Makes and factorises [M Gᵀ; G 0] with the inextensible ropes that act: for accelerations, projections and
    /// impacts.
    ///
    /// # Errors
    /// [`ZeroPivot`] where a body has no inertia in a direction that it can move, or a rope repeats another.
    pub fn factorise_inertia(
        &mut self,
        system: &System,
        mass: &MassMatrix,
        gradient: &[f64],
        modes: &[Mode],
    ) -> Result<(), ZeroPivot> {
        self.ldu.values_mut().fill(0.0);
        self.driven.fill(0.0);
        for slot in 0..mass.values.len() {
            let values = self.ldu.values_mut();
            put(values, &mut self.driven, self.lower[slot], mass.values[slot]);
            if self.upper[slot] != self.lower[slot] {
                put(values, &mut self.driven, self.upper[slot], mass.values[slot]);
            }
        }
        for row in 0..system.rows.count() {
            let acts = system.rows.laws[row].compliance() == 0.0 && modes[row] == Mode::Acting;
            self.ldu.values_mut()[self.diagonal[self.layout.row(row)]] = if acts { 0.0 } else { -1.0 };
            if acts {
                for entry in system.rows.start[row]..system.rows.start[row + 1] {
                    let values = self.ldu.values_mut();
                    put(values, &mut self.driven, self.in_row[entry], gradient[entry]);
                    put(values, &mut self.driven, self.in_column[entry], gradient[entry]);
                }
            }
        }
        self.ldu.factorise()
    }

    /// Solves for the rates `x` of all degrees of freedom. `force` is the right side of every degree of freedom,
    /// `rows` that of every row; driven entries of `x` are given.
    pub fn solve(&mut self, force: &[f64], rows: &[f64], x: &mut [f64]) {
        let free = self.layout.free.len();
        for (right, &dof) in self.right.iter_mut().zip(&self.layout.free) {
            *right = force[dof];
        }
        self.right[free..].copy_from_slice(rows);
        for (&(unknown, dof), value) in self.driven_places.iter().zip(&self.driven) {
            self.right[unknown] -= value * x[dof];
        }
        self.ldu.solve(&mut self.right);
        for (right, &dof) in self.right.iter().zip(&self.layout.free) {
            x[dof] = *right;
        }
    }

    /// `out` += scale · (D + ∂τ/∂v) x.
    pub fn add_damping(&self, system: &System, mass: &MassMatrix, x: &[f64], scale: f64, out: &mut [f64]) {
        let velocity = &self.dynamics.velocity;
        for dof in 0..x.len() {
            let diagonal = mass.row_start[dof + 1] - 1;
            for slot in mass.row_start[dof]..diagonal {
                let other = mass.columns[slot];
                out[dof] += scale * velocity.lower[slot] * x[other];
                out[other] += scale * velocity.upper[slot] * x[dof];
            }
            out[dof] += scale * (velocity.lower[diagonal] + system.tree.damping[dof]) * x[dof];
        }
    }

    /// κP of the joints with rotations applied to the rates `x`: the increments of the coordinates.
    pub fn increments(&self, system: &System, v: &[f64], kappa: f64, x: &[f64], out: &mut [f64]) {
        let spins = Spins { system, v, kappa };
        for (out, x) in out.iter_mut().zip(x) {
            *out = kappa * x;
        }
        for (index, body) in system.tree.bodies.iter().enumerate() {
            if let Some(first) = rotation(&body.joint) {
                let range = body.first_velocity + first..body.first_velocity + first + 3;
                let turned = spins.p(index) * DVec3::from_slice(&x[range.clone()]) * kappa;
                out[range].copy_from_slice(&turned.to_array());
            }
        }
    }
}

/// ∂T/∂v of a sliding row over its own and its partner's velocity: μN/|v| (1 − d dᵀ).
fn slip_weights(law: &Law, here: &Evaluation, slip: &[f64], row: usize) -> [f64; 2] {
    let Law::Friction { coefficient, normal, .. } = *law else { return [0.0; 2] };
    let direction = here.slip_direction(normal, slip);
    let (own, other) = (direction[row - normal - 1], direction[normal + 2 - row]);
    let turning = here.turning(coefficient, normal, slip);
    [turning * (1.0 - own * own), -turning * own * other]
}

/// From an entry of a tangential row to the entry of its partner for the same degree of freedom.
fn partner_offset(system: &System, law: &Law, row: usize) -> isize {
    let Law::Friction { normal, .. } = *law else { return 0 };
    let length = (system.rows.start[row + 1] - system.rows.start[row]) as isize;
    if row == normal + 1 { length } else { -length }
}

fn put(values: &mut [f64], driven: &mut [f64], slot: Slot, value: f64) {
    match slot {
        Slot::Matrix(entry) => values[entry] += value,
        Slot::Driven(entry) => driven[entry] += value,
        Slot::Nowhere => {}
    }
}

/// Row vector times P.
fn turn(row: &mut [f64], p: &DMat3) {
    let turned = p.transpose() * DVec3::from_slice(row);
    row.copy_from_slice(&turned.to_array());
}

/// P of the joints with rotations.
struct Spins<'a> {
    system: &'a System,
    v: &'a [f64],
    kappa: f64,
}

impl Spins<'_> {
    /// (1 + [u])⁻¹ = (1 − [u] + u uᵀ)/(1 + u²), u = κω/2.
    fn p(&self, body: usize) -> DMat3 {
        let joint = &self.system.tree.bodies[body];
        let first = joint.first_velocity + rotation(&joint.joint).unwrap_or(0);
        let u = DVec3::from_slice(&self.v[first..first + 3]) * (0.5 * self.kappa);
        let cross = DMat3::from_cols(
            DVec3::new(0.0, u.z, -u.y),
            DVec3::new(-u.z, 0.0, u.x),
            DVec3::new(u.y, -u.x, 0.0),
        );
        let outer = DMat3::from_cols(u * u.x, u * u.y, u * u.z);
        (DMat3::IDENTITY - cross + outer) * (1.0 / (1.0 + u.length_squared()))
    }
}

/// Offsets of the triples of rotations in an ordered list of degrees of freedom, with their bodies.
fn triples_of(system: &System, dofs: &[usize]) -> Vec<(usize, usize)> {
    let start = |(offset, &dof): (usize, &usize)| {
        let owner = system.tree.owner[dof];
        let body = &system.tree.bodies[owner];
        let first = body.first_velocity + rotation(&body.joint)?;
        (dof == first).then_some((offset, owner))
    };
    dofs.iter().enumerate().filter_map(start).collect()
}

/// For every degree of freedom and every joint with rotations that it couples to: the joint's body and the three
/// position entries (slot, whether in the lower triangle).
fn tree_triples(system: &System, mass: &MassMatrix) -> Vec<(usize, [(usize, bool); 3])> {
    let tree = &system.tree;
    let mut triples = Vec::new();
    for (index, body) in tree.bodies.iter().enumerate() {
        let Some(first) = rotation(&body.joint) else { continue };
        let first = body.first_velocity + first;
        for row in 0..tree.velocities {
            let below = tree.support[tree.owner[row]].contains(&first);
            let above = tree.support[index].contains(&row);
            if !(below || above) {
                continue;
            }
            let entry = |k: usize| {
                let column = first + k;
                if row >= column { (mass.slot(row, column), true) } else { (mass.slot(column, row), false) }
            };
            triples.push((index, [entry(0), entry(1), entry(2)]));
        }
    }
    triples
}
