//! Where the numbers of the matrix of [`super::tangent`] go. Found once.

use super::evaluation::first_rotation;
use crate::solver::layout::{Group, Layout, NONE};
use crate::solver::ldu::Ldu;
use crate::system::System;
use crate::tree::mass::MassMatrix;

/// Places in one array: the matrix as [`Ldu`] has it, one place for what belongs nowhere (rows of driven degrees
/// of freedom), and the columns of driven degrees of freedom, which go to the right side.
#[derive(Debug, Clone)]
pub struct Places {
    /// How many there are.
    pub count: usize,
    /// Numbers in the lower triangle of the mass matrix's pattern.
    pub lower: Vec<u32>,
    /// Those in the upper triangle; the same on the diagonal.
    pub upper: Vec<u32>,
    /// Entries of the rows.
    pub in_row: Vec<u32>,
    /// Entries of the rows in the transpose.
    pub in_column: Vec<u32>,
    /// Diagonal of every row.
    pub diagonal: Vec<u32>,
    /// Rows of friction by the rows that their bounds depend on, and the places of these couplings; ascending.
    pub friction: Vec<(usize, usize, u32)>,
    /// Groups whose motion turns gradients.
    pub blocks: Vec<Block>,
    /// Of every light sheave, in the order of [`System::light`].
    pub light: Vec<LightPlaces>,
    /// Bodies whose joints have rotations in body axes.
    pub joints: Vec<usize>,
    /// Columns of their rotations in the rows of degrees of freedom.
    pub triples: Vec<Triple>,
    /// Columns of their rotations in rows: the first of three entries, and which joint.
    pub row_triples: Vec<(usize, usize)>,
    /// Where the driven columns start.
    pub first_driven: usize,
    /// Unknown and driven degree of freedom of every number there.
    pub driven: Vec<(usize, usize)>,
}

/// A group of [`Layout::groups`].
#[derive(Debug, Clone)]
pub struct Block {
    /// The group.
    pub group: Group,
    /// Place of (j, k) at j · size + k.
    pub places: Vec<u32>,
    /// Index in the rows' entries of every degree of freedom.
    pub entries: Vec<u32>,
}

/// Places of the row of a light sheave's flow.
#[derive(Debug, Clone, Default)]
pub struct LightPlaces {
    /// All of them.
    pub all: Vec<u32>,
    /// Its diagonal.
    pub diagonal: u32,
    /// The forces of the spans before and after it.
    pub sides: [u32; 2],
    /// The flows before and after it on the rope.
    pub beside: [Option<u32>; 2],
}

/// Places of three neighbouring columns, those of the rotations of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Triple {
    /// Which of [`Places::joints`].
    pub joint: usize,
    /// The places.
    pub places: [u32; 3],
}

struct Finder<'a> {
    layout: &'a Layout,
    ldu: &'a Ldu,
    driven: Vec<(usize, usize)>,
}

impl Finder<'_> {
    /// Place of a number in the row of an unknown and the column of a degree of freedom.
    fn of_dof(&mut self, row: usize, dof: usize) -> u32 {
        let column = self.layout.unknown[dof];
        if row != NONE && column == NONE {
            self.driven.push((row, dof));
            return (self.ldu.entries() + self.driven.len()) as u32;
        }
        self.of(row, column)
    }

    /// Place of a number in the row and the column of two unknowns.
    fn of(&self, row: usize, column: usize) -> u32 {
        let entry = if row == NONE || column == NONE { None } else { self.ldu.entry(row, column) };
        entry.unwrap_or(self.ldu.entries()) as u32
    }
}

impl Places {
    /// Places of `system`.
    pub fn new(system: &System, layout: &Layout, ldu: &Ldu) -> Self {
        let mut finder = Finder { layout, ldu, driven: Vec::new() };
        let joints: Vec<usize> = (0..system.tree.bodies.len())
            .filter(|&body| first_rotation(&system.tree.bodies[body]).is_some())
            .collect();
        let mass = MassMatrix::new(&system.tree);
        let unknown = &layout.unknown;
        let (mut lower, mut upper, mut pairs) = (Vec::new(), Vec::new(), Vec::new());
        for dof in 0..system.tree.velocities {
            for &other in &mass.columns[mass.row_start[dof]..mass.row_start[dof + 1]] {
                lower.push(finder.of_dof(unknown[dof], other));
                upper.push(if other == dof {
                    lower[lower.len() - 1]
                } else {
                    finder.of_dof(unknown[other], dof)
                });
                pairs.extend([(dof, other), (other, dof)]);
            }
        }
        let (mut in_row, mut in_column) = (Vec::new(), Vec::new());
        let mut row_triples = Vec::new();
        for row in 0..system.rows.count() {
            for entry in system.rows.start[row]..system.rows.start[row + 1] {
                let dof = system.rows.dofs[entry];
                in_row.push(finder.of_dof(layout.row(row), dof));
                in_column.push(finder.of(unknown[dof], layout.row(row)));
                row_triples.extend(rotating(system, &joints, dof).map(|joint| (entry, joint)));
            }
        }
        let blocks = places_of_blocks(system, &mut finder, &mut pairs);
        let light = places_of_light(system, &mut finder, &blocks);
        let mut friction = Vec::new();
        for (row, law) in system.rows.laws.iter().enumerate() {
            friction.extend(law.bounded_by().map(|to| (row, to, finder.of(layout.row(row), layout.row(to)))));
        }
        Self {
            friction,
            diagonal: (0..system.rows.count())
                .map(|row| finder.of(layout.row(row), layout.row(row)))
                .collect(),
            triples: triples(system, &finder, &joints, pairs),
            first_driven: ldu.entries() + 1,
            count: ldu.entries() + 1 + finder.driven.len(),
            driven: finder.driven,
            joints,
            lower,
            upper,
            in_row,
            in_column,
            light,
            blocks,
            row_triples,
        }
    }
}

/// Places of what curvature adds, a group of degrees of freedom each; `pairs` grows by all pairs of them.
fn places_of_blocks(system: &System, finder: &mut Finder, pairs: &mut Vec<(usize, usize)>) -> Vec<Block> {
    let layout = finder.layout;
    let mut blocks = Vec::with_capacity(layout.groups.len());
    for group in &layout.groups {
        let entries = system.rows.start[group.row]..system.rows.start[group.row + 1];
        let dofs = &system.rows.dofs[entries.clone()];
        let entry = |dof: &usize| (entries.start + dofs.partition_point(|other| other < dof)) as u32;
        let mut places = Vec::with_capacity(group.dofs.len() * group.dofs.len());
        for &j in &group.dofs {
            places.extend(group.dofs.iter().map(|&k| finder.of_dof(layout.unknown[j], k)));
            pairs.extend(group.dofs.iter().map(|&k| (j, k)));
        }
        blocks.push(Block { places, entries: group.dofs.iter().map(entry).collect(), group: group.clone() });
    }
    blocks
}

/// Places of the rows of light sheaves' flows.
fn places_of_light(system: &System, finder: &mut Finder, blocks: &[Block]) -> Vec<LightPlaces> {
    let mut light = Vec::new();
    for sheaves in &system.light {
        for (sheave, &dof) in sheaves.dofs.iter().enumerate() {
            let own = finder.layout.unknown[dof];
            let mut all = Vec::new();
            for Block { group, places, .. } in blocks {
                let rows = group.dofs.iter().enumerate().filter(|(_, other)| **other == dof);
                let size = group.dofs.len();
                all.extend(rows.flat_map(|(j, _)| &places[j * size..(j + 1) * size]));
            }
            let sides = [0, 1].map(|side| {
                let row = finder.layout.row(sheaves.rows.start + sheave + side);
                finder.of(own, row)
            });
            all.extend(sides);
            let near = [sheave.checked_sub(1), Some(sheave + 1)];
            let flow = |near: Option<usize>| near.and_then(|near| sheaves.dofs.get(near));
            let beside = near.map(|near| flow(near).map(|&dof| finder.of(own, finder.layout.unknown[dof])));
            light.push(LightPlaces { all, diagonal: finder.of(own, own), sides, beside });
        }
    }
    light
}

/// The joint, among `joints`, whose first rotation `dof` is.
fn rotating(system: &System, joints: &[usize], dof: usize) -> Option<usize> {
    let owner = system.tree.owner[dof];
    (dof == first_rotation(&system.tree.bodies[owner])?).then(|| joints.binary_search(&owner).ok())?
}

/// Triples of all rows of degrees of freedom; `pairs` are (row, column) of the entries.
fn triples(system: &System, finder: &Finder, joints: &[usize], pairs: Vec<(usize, usize)>) -> Vec<Triple> {
    let unknown = &finder.layout.unknown;
    let triple = |(row, dof): (usize, usize)| {
        let joint = rotating(system, joints, dof)?;
        let places = [0, 1, 2].map(|k| finder.of(unknown[row], unknown[dof + k]));
        (unknown[row] != NONE).then_some(Triple { joint, places })
    };
    let mut triples: Vec<Triple> = pairs.into_iter().filter_map(triple).collect();
    triples.sort_unstable();
    triples.dedup();
    triples
}
