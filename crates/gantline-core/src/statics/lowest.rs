//! The slowest motions of a large lift, without those that nobody asks for.
//!
//! With A = (K + λM)⁻¹M, by the sparse factors that equilibrium has, the slowest ω² are the largest θ = 1/(ω² + λ). They
//! are found in the space of X, AX, A²X, … of a block X, orthonormal in M (Golub and Underwood 1977; Golub and Van Loan,
//! section 10.3.6): a block since one vector alone finds one motion of several that have the same period. λ is raised
//! until K + λM is positive definite. How many ω² lie below the last one found is counted by the signs of pivots; where
//! that says that one is missing, nothing is returned.

use super::eigen::{Square, eigen};
use super::{Statics, search};
use crate::system::System;

/// First λ [1/s²], and by what it grows.
const FIRST: f64 = 1e-2;
const RAISED: f64 = 8.0;
/// Largest λ [1/s²].
const MOST: f64 = 1e8;
/// Vectors beyond those wanted in a block.
const MORE: usize = 2;
/// Blocks, at most.
const BLOCKS: usize = 24;
/// What is left of θ x in A x − θ x, where it is known well enough; the error of θ goes with its square.
const LEFT: f64 = 1e-8;
/// The same where rounding lets it not become less.
const ROUGH: f64 = 1e-6;
/// A vector of which less is left beside the others is none of its own.
const NOTHING: f64 = 1e-9;
/// Compliance of rows that have none, as a share of what the search gave them.
const STIFFER: f64 = 1e-9;
/// Beyond the last ω² found by this share, others are looked for.
const BEYOND: f64 = 1e-6;

/// Numbers and the motions that go with them.
type Found = Vec<(f64, Vec<f64>)>;

/// A space of motions, orthonormal in M.
#[derive(Default)]
struct Space {
    vectors: Vec<Vec<f64>>,
    /// M times each.
    weighed: Vec<Vec<f64>>,
    /// A times each, as far as it is known.
    answers: Vec<Vec<f64>>,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn add(to: &mut [f64], factor: f64, what: &[f64]) {
    to.iter_mut().zip(what).for_each(|(to, what)| *to += factor * what);
}

fn combined(vectors: &[Vec<f64>], shares: &[f64]) -> Vec<f64> {
    let mut sum = vec![0.0; vectors[0].len()];
    vectors.iter().zip(shares).for_each(|(vector, share)| add(&mut sum, *share, vector));
    sum
}

impl Statics {
    /// The `count` slowest motions about the equilibrium that has been linearised: ω² and x over all degrees of freedom
    /// with xᵀ M x = 1, ascending; none where they are not found for certain.
    pub(super) fn lowest(&mut self, system: &System, count: usize) -> Option<Found> {
        let mut shift = FIRST;
        while !self.factorise_at(system, shift) || self.search.matrix.below(system) > 0 {
            shift *= RAISED;
            if shift > MOST {
                return None;
            }
        }
        let size = self.search.matrix.layout.free.len();
        let (mut space, mut last) = (Space::default(), f64::INFINITY);
        let mut block = self.first_block((count + MORE).min(size));
        for _ in 0..BLOCKS {
            let before = space.vectors.len();
            for vector in block.drain(..) {
                self.take_in(&mut space, vector);
            }
            for index in before..space.vectors.len() {
                let answer = self.flexed(&space.weighed[index]);
                block.push(answer.clone());
                space.answers.push(answer);
            }
            let (found, left) = self.projected(&space, count)?;
            let is_whole = space.vectors.len() == before || space.vectors.len() == size;
            let is_stuck = left <= ROUGH && left > 0.5 * last;
            if left <= LEFT || is_stuck || is_whole {
                let squares = found.into_iter().map(|(theta, x)| (1.0 / theta - shift, x));
                let squares: Vec<_> = squares.take(count).collect();
                return self.is_complete(system, &squares).then_some(squares);
            }
            last = left;
        }
        None
    }

    fn factorise_at(&mut self, system: &System, shift: f64) -> bool {
        let Self { search, bearings, .. } = self;
        search.matrix.extra.fill(0.0);
        let follows = &search.here.follows;
        let compliance = |row: usize| {
            let share = if bearings[row].is_rigid { STIFFER } else { 1.0 };
            follows[row].then_some(bearings[row].compliance * share)
        };
        search.matrix.factorise(system, shift, compliance).is_ok()
    }

    /// The same vectors always, which no motion is orthogonal to but by accident.
    fn first_block(&self, count: usize) -> Vec<Vec<f64>> {
        let mut state = 1_u64;
        let mut number = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / (1u64 << 31) as f64 * 2.0 - 1.0
        };
        let size = self.search.here.slope.len();
        let one = |_| {
            let mut vector = vec![0.0; size];
            self.search.matrix.layout.free.iter().for_each(|&dof| vector[dof] = number());
            vector
        };
        (0..count).map(one).collect()
    }

    /// Adds what is new in a vector to the space.
    fn take_in(&self, space: &mut Space, mut vector: Vec<f64>) {
        let mass = &self.search.here.frame.mass;
        let mut weighed = vec![0.0; vector.len()];
        mass.multiply(&vector, &mut weighed);
        let before = dot(&vector, &weighed).sqrt();
        for _ in 0..2 {
            for (other, weighed) in space.vectors.iter().zip(&space.weighed) {
                let along = dot(&vector, weighed);
                add(&mut vector, -along, other);
            }
        }
        mass.multiply(&vector, &mut weighed);
        let size = dot(&vector, &weighed).sqrt();
        if size > NOTHING * before {
            vector.iter_mut().chain(&mut weighed).for_each(|entry| *entry /= size);
            space.vectors.push(vector);
            space.weighed.push(weighed);
        }
    }

    /// A x from M x.
    fn flexed(&mut self, weighed: &[f64]) -> Vec<f64> {
        let rows = vec![0.0; self.bearings.len()];
        let (mut answer, mut tension) = (vec![0.0; weighed.len()], rows.clone());
        self.search.matrix.solve(weighed, &rows, &mut answer, &mut tension);
        answer
    }

    /// θ and x of the largest θ in the space, and what is left of the worst of the first `count`; none where the space
    /// is too small.
    fn projected(&self, space: &Space, count: usize) -> Option<(Found, f64)> {
        let size = space.vectors.len();
        let mut values = vec![0.0; size * size];
        for row in 0..size {
            for column in 0..=row {
                let both =
                    [(row, column), (column, row)].map(|(a, b)| dot(&space.weighed[a], &space.answers[b]));
                let mean = 0.5 * (both[0] + both[1]);
                (values[row * size + column], values[column * size + row]) = (mean, mean);
            }
        }
        let (thetas, shapes) = eigen(Square::new(size, values));
        let mut worst = 0.0_f64;
        let mut found = Vec::with_capacity(count);
        let mut weighed = vec![0.0; space.vectors[0].len()];
        for index in (0..size).rev().take(count) {
            let (theta, shares) = (thetas[index], &shapes.values[index * size..(index + 1) * size]);
            let x = combined(&space.vectors, shares);
            let mut left = combined(&space.answers, shares);
            add(&mut left, -theta, &x);
            self.search.here.frame.mass.multiply(&left, &mut weighed);
            worst = worst.max(dot(&left, &weighed).sqrt() / theta.abs());
            found.push((theta, x));
        }
        (found.len() == count).then_some((found, worst))
    }

    /// True where no other ω² lies below the last one found.
    fn is_complete(&mut self, system: &System, found: &[(f64, Vec<f64>)]) -> bool {
        let Some((last, _)) = found.last() else { return true };
        let bound = last + BEYOND * (last.abs() + search::LEAST);
        // Of a motion that is found together with others of the same period, those may be more than were asked for.
        let below = last - BEYOND * (last.abs() + search::LEAST);
        let inside = found.iter().filter(|(square, _)| *square < below).count();
        let is_there = self.factorise_at(system, -bound) && self.search.matrix.below(system) >= found.len();
        is_there && self.factorise_at(system, -below) && self.search.matrix.below(system) == inside
    }
}

#[cfg(test)]
mod tests {
    use crate::build::build;
    use crate::spec::SystemSpec;
    use crate::state::State;
    use crate::statics::Statics;
    use crate::statics::losses::Losses;
    use crate::system::System;

    /// Pendulums of a row of lengths, every one of them twice, each with a second below it.
    fn pendulums(count: usize, material: &str) -> (System, State) {
        let mut bodies = Vec::new();
        let mut ropes = Vec::new();
        for index in 0..count {
            let length = 5.0 + (index / 2) as f64 * 0.37;
            for (name, depth) in [("a", length), ("b", 2.0 * length)] {
                bodies.push(format!(
                    r#"{{"name": "{name}{index}", "parent": null, "mass": 1000, "centre_of_gravity": [0, 0, 0],
                      "placement": {{"position": [0, 0, 0], "orientation": [1, 0, 0, 0]}}, "inertia": [0, 0, 0, 0, 0, 0],
                      "joint": {{"type": "point", "position": [{index}, 0, {}], "velocity": [0, 0, 0]}}}}"#,
                    -depth
                ));
            }
            for (name, from, to) in [
                ("u", "null".to_owned(), format!("\"a{index}\"")),
                ("l", format!("\"a{index}\""), format!("\"b{index}\"")),
            ] {
                let at = if name == "u" { format!("[{index}, 0, 0]") } else { "[0, 0, 0]".to_owned() };
                ropes.push(format!(
                    r#"{{"name": "{name}{index}", "length": {length}, "material": {material},
                      "route": [{{"type": "end", "body": {from}, "at": {at}}}, {{"type": "end", "body": {to}, "at": [0, 0, 0]}}]}}"#
                ));
            }
        }
        let text = format!(
            r#"{{"gravity": [0, 0, -9.81], "bodies": [{}], "ropes": [{}]}}"#,
            bodies.join(", "),
            ropes.join(", ")
        );
        let spec: SystemSpec = serde_json::from_str(&text).expect("a document");
        build(&spec).expect("a system")
    }

    /// Against the dense matrices: every period four times, of two directions and two pendulums of one length.
    #[test]
    fn slowest_motions_are_those_of_the_dense_matrices() {
        for material in [r#"{"type": "elastic", "axial_stiffness": 1e8}"#, r#"{"type": "inextensible"}"#] {
            let (system, mut state) = pendulums(60, material);
            let mut statics = Statics::new(&system);
            statics.settle(&system, &mut state, Losses::NONE).expect("they hang");
            let all = statics.modes(&system, &state, None);
            let few = statics.modes(&system, &state, Some(9));
            assert_eq!((all.len(), few.len()), (if material.contains("elastic") { 360 } else { 240 }, 9));
            for (one, other) in few.iter().zip(&all) {
                // Rounding of a stiffness of 1e8/5/1e3 = 2e4 1/s² beside 0.1 1/s².
                let error = (one.square - other.square).abs();
                assert!(error < 1e-9 * other.square, "{} {} {error:e}", one.square, other.square);
            }
            // (MD1): x is orthonormal in M, here 1000 of every point.
            for (a, one) in few.iter().enumerate() {
                for (b, other) in few.iter().enumerate() {
                    let product = 1e3 * super::dot(&one.shape, &other.shape);
                    assert!((product - f64::from(a == b)).abs() < 1e-9, "{a} {b} {product}");
                }
            }
        }
    }
}
