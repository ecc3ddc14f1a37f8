//! The symmetric matrix of a step over velocities and impulses,
//!
//! ```text
//! [ M + hD + h²αK   Gᵀ           ]
//! [ G              −ε/(h (h+τ))  ]
//! ```
//!
//! with the driven degrees of freedom moved to the right side. The pattern is found once; a row that does
//! not act is an identity row, so the pattern stays while ropes go slack and contacts open. Where there are brakes it is not
//! symmetric: the row of one that slips is its law, y = ±h B₀ ± Σ wₖ yₖ − ∂B v, while its force acts on its flow as before.
//!
//! What light sheaves lose is no unknown. With y₁, y₂ the impulses of the spans beside it and G = ∂g/∂s, the row of a flow is
//!
//! ```text
//! v = 0        or        Σ (Gₖ ± wₖ) yₖ = 0
//! ```
//!
//! where it holds or slips, and that of its loss, an identity row, is filled in afterwards.

use super::brakes::Holding;
use super::complementarity::Mode;
use super::layout::{Layout, NONE};
use super::ldl::Ldl;
use super::ldu::Ldu;
use super::slots::Slots;
use super::stiffness::Stiffness;
use super::symbolic::ZeroPivot;
use crate::system::System;
use crate::tree::mass::MassMatrix;

/// Factors, by whether the matrix is symmetric.
#[derive(Debug, Clone)]
enum Factors {
    /// Without brakes.
    Symmetric(Ldl),
    /// With brakes; the numbers as [`Ldu`] has them.
    Unsymmetric(Ldu, Vec<f64>),
}

/// The row of the flow of a light sheave.
#[derive(Debug, Clone)]
struct LightRow {
    dof: usize,
    /// The row of its loss, which is no unknown.
    row: usize,
    /// The spans before and after it.
    sides: [Side; 2],
    /// The direction of its loss while it slips, else 0.
    way: f64,
}

/// A span beside a light sheave.
#[derive(Debug, Clone, Copy)]
struct Side {
    row: usize,
    /// Where G is in the symmetric matrix, and the coupling of the flow to the span's impulse among the numbers of [`Ldu`].
    slot: usize,
    place: usize,
    /// G and w.
    gradient: f64,
    weight: f64,
}

/// The matrix, its pattern and its factors.
#[derive(Debug, Clone)]
pub struct Kkt {
    layout: Layout,
    light: Vec<LightRow>,
    /// Geometric stiffness of the step.
    pub stiffness: Stiffness,
    factors: Factors,
    slots: Slots,
    base: Vec<f64>,
    right: Vec<f64>,
    solution: Vec<f64>,
}

impl Kkt {
    /// Pattern and elimination order for `system`.
    pub fn new(system: &System) -> Self {
        let layout = Layout::of_bodies(system);
        let stiffness = Stiffness::new(system);
        let pattern = layout.symbolic.clone();
        let mut light = Vec::new();
        let factors = if system.brakes().next().is_none() {
            Factors::Symmetric(Ldl::new(pattern))
        } else {
            let ldu = Ldu::new(pattern);
            light.extend(light_rows(system, &layout, &ldu));
            let values = vec![0.0; ldu.entries()];
            Factors::Unsymmetric(ldu, values)
        };
        let blocks = stiffness.start.windows(2).map(|window| &stiffness.dofs[window[0]..window[1]]);
        let slots = Slots::new(system, &layout, blocks);
        let size = layout.symbolic.size();
        Self {
            slots,
            base: vec![0.0; layout.symbolic.rows.len()],
            right: vec![0.0; size],
            solution: vec![0.0; size],
            layout,
            light,
            stiffness,
            factors,
        }
    }

    /// Entries of L, a measure of cost.
    pub fn fill(&self) -> usize {
        self.layout.symbolic.l_rows.len()
    }

    /// Sets the matrix of a step of length `h` with all rows acting.
    pub fn assemble(&mut self, system: &System, mass: &MassMatrix, gradient: &[f64], h: f64) {
        self.base.fill(0.0);
        add(&mut self.base, &self.slots.mass, mass.values.iter().copied());
        add(&mut self.base, &self.slots.rows, gradient.iter().copied());
        let mut cursor = 0;
        for group in 0..self.stiffness.factor.len() {
            let scale = h * h * self.stiffness.implicit[group] * self.stiffness.factor[group];
            let columns =
                &self.stiffness.columns[self.stiffness.start[group]..self.stiffness.start[group + 1]];
            for (i, a) in columns.iter().enumerate() {
                for b in &columns[..=i] {
                    let slot = self.slots.blocks[cursor];
                    cursor += 1;
                    if slot != NONE {
                        self.base[slot] += scale * a.dot(*b);
                    }
                }
            }
        }
        for (index, &dof) in self.layout.free.iter().enumerate() {
            self.base[self.slots.diagonal[index]] += h * system.tree.damping[dof];
        }
        for (row, law) in system.rows.laws.iter().enumerate() {
            let diagonal = self.slots.diagonal[self.layout.row(row)];
            self.base[diagonal] = -law.compliance() / (h * (h + law.damping_time()));
        }
        for light in &self.light {
            self.base[self.slots.diagonal[self.layout.row(light.row)]] = -1.0;
        }
    }

    /// Factorises for a step of length `h` with the rows that do not act replaced by identity rows, and those of brakes that
    /// slip by their law.
    ///
    /// # Errors
    /// [`ZeroPivot`] with the unknown: see [`Kkt::element`].
    pub fn factorise(
        &mut self,
        system: &System,
        modes: &[Mode],
        brakes: &[Holding],
        h: f64,
    ) -> Result<(), ZeroPivot> {
        let idle = || (0..system.rows.count()).filter(|&row| modes[row] != Mode::Acting);
        match &mut self.factors {
            Factors::Symmetric(ldl) => {
                let values = ldl.values_mut();
                values.copy_from_slice(&self.base);
                for row in idle() {
                    take_out(system, (&self.slots, &self.layout), row, values);
                }
                ldl.factorise()
            }
            Factors::Unsymmetric(ldu, values) => {
                let (upper, lower) = values.split_at_mut(self.base.len());
                upper.copy_from_slice(&self.base);
                for row in idle() {
                    take_out(system, (&self.slots, &self.layout), row, upper);
                }
                lower.copy_from_slice(upper);
                let with_inertia = brakes.len() - self.light.len();
                for (light, brake) in self.light.iter_mut().zip(&brakes[with_inertia..]) {
                    light.follow(&self.base, modes, brake);
                    light.place(self.slots.diagonal[self.layout.unknown[light.dof]], values);
                }
                for brake in brakes[..with_inertia].iter().filter(|brake| modes[brake.row] == Mode::Slipping)
                {
                    let mut put = |(row, column): (usize, usize), value: f64| {
                        if let (true, Some(place)) = (row != NONE && column != NONE, ldu.entry(row, column)) {
                            values[place] = value;
                        }
                    };
                    let own = self.layout.row(brake.row);
                    for entry in system.rows.start[brake.row]..system.rows.start[brake.row + 1] {
                        if self.slots.rows[entry] != NONE {
                            let unknown = self.layout.unknown[system.rows.dofs[entry]];
                            put((unknown, own), self.base[self.slots.rows[entry]]);
                        }
                    }
                    put((own, self.layout.unknown[brake.dof]), -h * brake.slope());
                    for (row, weight) in brake.pressed.into_iter().filter(|(_, weight)| *weight != 0.0) {
                        put((own, self.layout.row(row)), brake.way * weight);
                    }
                }
                ldu.factorise(values)
            }
        }
    }

    /// Solves for velocities and impulses. `force` is the right side of every degree of freedom with the
    /// driven columns already moved there; `rows` that of every row. Driven entries of `v` stay.
    pub fn solve(&mut self, force: &[f64], rows: &[f64], v: &mut [f64], impulse: &mut [f64]) {
        for (index, &dof) in self.layout.free.iter().enumerate() {
            self.right[index] = force[dof];
        }
        self.right[self.layout.free.len()..].copy_from_slice(rows);
        for light in self.light.iter().filter(|light| light.way == 0.0) {
            self.right[self.layout.unknown[light.dof]] = 0.0;
        }
        match &mut self.factors {
            Factors::Symmetric(ldl) => ldl.solve(&self.right, &mut self.solution),
            Factors::Unsymmetric(ldu, _) => {
                self.solution.copy_from_slice(&self.right);
                ldu.solve(&mut self.solution);
            }
        }
        for (index, &dof) in self.layout.free.iter().enumerate() {
            v[dof] = self.solution[index];
        }
        impulse.copy_from_slice(&self.solution[self.layout.free.len()..]);
        for light in &self.light {
            impulse[light.row] = light.loss(force[light.dof], impulse);
        }
    }

    /// Name of the body or constraint that an unknown belongs to.
    pub fn element<'a>(&self, system: &'a System, unknown: usize) -> &'a str {
        self.layout.element(system, unknown)
    }
}

impl LightRow {
    /// How it takes part, with the gradients of `base`.
    fn follow(&mut self, base: &[f64], modes: &[Mode], brake: &Holding) {
        // Flows without inertia stand still while their rope is slack.
        let slips = modes[self.row] == Mode::Slipping && modes[self.sides[0].row] == Mode::Acting;
        self.way = if slips { brake.way } else { 0.0 };
        for (side, (_, weight)) in self.sides.iter_mut().zip(brake.pressed) {
            (side.gradient, side.weight) = (base[side.slot], weight);
        }
    }

    /// Puts its row into the numbers of [`Ldu`].
    fn place(&self, diagonal: usize, values: &mut [f64]) {
        if self.way == 0.0 {
            values[diagonal] = 1.0;
        }
        for Side { place, gradient, weight, .. } in self.sides {
            values[place] = if self.way == 0.0 { 0.0 } else { gradient + self.way * weight };
        }
    }

    /// The impulse of its loss, with what pushes the flow and the impulses of the spans.
    fn loss(&self, force: f64, impulse: &[f64]) -> f64 {
        let sum = |factor: fn(&Side) -> f64| -> f64 {
            self.sides.iter().map(|side| factor(side) * impulse[side.row]).sum()
        };
        if self.way == 0.0 { force - sum(|side| side.gradient) } else { self.way * sum(|side| side.weight) }
    }
}

/// Rows of all light sheaves, in the order of their losses.
fn light_rows<'a>(
    system: &'a System,
    layout: &'a Layout,
    ldu: &'a Ldu,
) -> impl Iterator<Item = LightRow> + 'a {
    system.brakes().filter(|(row, _)| *row >= system.first_light_row()).map(|(row, brake)| {
        let flow = layout.unknown[brake.dof];
        let side = |index: usize| {
            let (row, _) = brake.spans[index];
            let unknown = layout.row(row);
            let [slot, place] =
                [layout.symbolic.slot(flow, unknown).map(|(slot, _)| slot), ldu.entry(flow, unknown)]
                    .map(|place| place.unwrap_or(NONE));
            Side { row, slot, place, gradient: 0.0, weight: 0.0 }
        };
        LightRow { dof: brake.dof, row, sides: [side(0), side(1)], way: 0.0 }
    })
}

/// Makes the row of a matrix an identity row.
fn take_out(system: &System, (slots, layout): (&Slots, &Layout), row: usize, values: &mut [f64]) {
    for &slot in &slots.rows[system.rows.start[row]..system.rows.start[row + 1]] {
        if slot != NONE {
            values[slot] = 0.0;
        }
    }
    values[slots.diagonal[layout.row(row)]] = -1.0;
}

fn add(base: &mut [f64], slots: &[usize], values: impl Iterator<Item = f64>) {
    for (&slot, value) in slots.iter().zip(values) {
        if slot != NONE {
            base[slot] += value;
        }
    }
}
