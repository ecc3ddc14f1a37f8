//! L D U of a sparse matrix with symmetric structure and unsymmetric numbers, without pivoting, on the same
//! static pattern as [`super::ldl`]: sliding friction, gyroscopic terms and exact rotational tangents.

use super::symbolic::{PIVOT_FLOOR, Symbolic, ZeroPivot};

/// Symbolic and numeric factorisation. Unknowns keep their own numbering outside.
///
/// Numbers of both triangles that take the same steps lie side by side.
#[derive(Debug, Clone)]
pub struct Ldu {
    pattern: Symbolic,
    /// L by columns, and Uᵀ.
    factors: Vec<Factor>,
    inverse_diagonal: Vec<f64>,
    work: Vec<[f64; 2]>,
    right: Vec<f64>,
}

/// An entry of L and its mirror image in U.
#[derive(Debug, Clone, Copy)]
struct Factor {
    row: u32,
    l: f64,
    u: f64,
}

impl Ldu {
    /// Room for the numbers of a pattern.
    pub fn new(pattern: Symbolic) -> Self {
        let size = pattern.size();
        Self {
            factors: pattern.l_rows.iter().map(|&row| Factor { row: row as u32, l: 0.0, u: 0.0 }).collect(),
            inverse_diagonal: vec![0.0; size],
            work: vec![[0.0; 2]; size],
            right: vec![0.0; size],
            pattern,
        }
    }

    /// Where the entry (row, column) is kept in the numbers, if the pattern has it.
    pub fn entry(&self, row: usize, column: usize) -> Option<usize> {
        let (slot, upper) = self.pattern.slot(row, column)?;
        Some(if upper { slot } else { self.pattern.rows.len() + slot })
    }

    /// How many numbers the matrix has: the upper triangle by the pattern's columns, diagonal included, then the
    /// lower one, transposed.
    pub fn entries(&self) -> usize {
        2 * self.pattern.rows.len()
    }

    /// Factorises the matrix whose numbers are `values`, by [`Ldu::entry`]; more of them are not looked at.
    ///
    /// # Errors
    /// [`ZeroPivot`] names the unknown where the matrix is singular in this order.
    pub fn factorise(&mut self, values: &[f64]) -> Result<(), ZeroPivot> {
        let pattern = &self.pattern;
        let (upper, lower) = values.split_at(pattern.rows.len());
        for k in 0..pattern.size() {
            let diagonal = pattern.start[k + 1] - 1;
            for slot in pattern.start[k]..diagonal {
                self.work[pattern.rows[slot]] = [upper[slot], lower[slot]];
            }
            let mut pivot = upper[diagonal];
            let mut magnitude = pivot.abs();
            for entry in pattern.r_start[k]..pattern.r_start[k + 1] {
                let (column, place) = (pattern.r_columns[entry], pattern.r_places[entry]);
                let [y, w] = std::mem::take(&mut self.work[column]);
                // Rows that do not act have nothing but zeros.
                if y == 0.0 && w == 0.0 {
                    let factor = &mut self.factors[place];
                    (factor.l, factor.u) = (0.0, 0.0);
                    continue;
                }
                for &Factor { row, l, u } in &self.factors[pattern.l_start[column]..place] {
                    let work = &mut self.work[row as usize];
                    *work = [work[0] - l * y, work[1] - u * w];
                }
                let inverse = self.inverse_diagonal[column];
                let l = w * inverse;
                pivot -= l * y;
                magnitude += (l * y).abs();
                let factor = &mut self.factors[place];
                (factor.l, factor.u) = (l, y * inverse);
            }
            if pivot.is_nan() || pivot.abs() <= PIVOT_FLOOR * magnitude {
                self.work.fill([0.0; 2]);
                return Err(ZeroPivot { unknown: pattern.order[k] });
            }
            self.inverse_diagonal[k] = 1.0 / pivot;
        }
        Ok(())
    }

    /// Solves A x = b; `b` becomes x, by unknown.
    pub fn solve(&mut self, b: &mut [f64]) {
        let pattern = &self.pattern;
        for (right, &unknown) in self.right.iter_mut().zip(&pattern.order) {
            *right = b[unknown];
        }
        for (column, bounds) in pattern.l_start.windows(2).enumerate() {
            let value = self.right[column];
            for &Factor { row, l, .. } in &self.factors[bounds[0]..bounds[1]] {
                self.right[row as usize] -= l * value;
            }
        }
        for (column, bounds) in pattern.l_start.windows(2).enumerate().rev() {
            let mut value = self.right[column] * self.inverse_diagonal[column];
            for &Factor { row, u, .. } in &self.factors[bounds[0]..bounds[1]] {
                value -= u * self.right[row as usize];
            }
            self.right[column] = value;
        }
        for (right, &unknown) in self.right.iter().zip(&pattern.order) {
            b[unknown] = *right;
        }
    }
}
