//! L D U of a sparse matrix with symmetric structure and unsymmetric numbers, without pivoting, on the same
//! static pattern as [`super::ldl`]: sliding friction, gyroscopic terms and exact rotational tangents.

use super::symbolic::{PIVOT_FLOOR, Symbolic, ZeroPivot};

/// Symbolic and numeric factorisation. Unknowns keep their own numbering outside.
#[derive(Debug, Clone)]
pub struct Ldu {
    pattern: Symbolic,
    /// The upper triangle by the pattern's columns, diagonal included; then the lower one, transposed.
    values: Vec<f64>,
    l_values: Vec<f64>,
    u_values: Vec<f64>,
    inverse_diagonal: Vec<f64>,
    work: Vec<f64>,
    row: Vec<f64>,
}

impl Ldu {
    /// Room for the numbers of a pattern.
    pub fn new(pattern: Symbolic) -> Self {
        let (entries, fill, size) = (pattern.rows.len(), pattern.l_rows.len(), pattern.size());
        Self {
            values: vec![0.0; 2 * entries],
            l_values: vec![0.0; fill],
            u_values: vec![0.0; fill],
            inverse_diagonal: vec![0.0; size],
            work: vec![0.0; size],
            row: vec![0.0; size],
            pattern,
        }
    }

    /// Where the entry (row, column) is kept in the numbers, if the pattern has it.
    pub fn entry(&self, row: usize, column: usize) -> Option<usize> {
        let (slot, upper) = self.pattern.slot(row, column)?;
        Some(if upper { slot } else { self.pattern.rows.len() + slot })
    }

    /// The numbers, to be filled by [`Ldu::entry`].
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    /// Factorises the numbers.
    ///
    /// # Errors
    /// [`ZeroPivot`] names the unknown where the matrix is singular in this order.
    pub fn factorise(&mut self) -> Result<(), ZeroPivot> {
        let pattern = &self.pattern;
        let (upper, lower) = self.values.split_at(pattern.rows.len());
        for k in 0..pattern.size() {
            let diagonal = pattern.start[k + 1] - 1;
            for slot in pattern.start[k]..diagonal {
                self.work[pattern.rows[slot]] = upper[slot];
                self.row[pattern.rows[slot]] = lower[slot];
            }
            let mut pivot = upper[diagonal];
            let mut magnitude = pivot.abs();
            for entry in pattern.r_start[k]..pattern.r_start[k + 1] {
                let (column, place) = (pattern.r_columns[entry], pattern.r_places[entry]);
                let y = std::mem::take(&mut self.work[column]);
                let w = std::mem::take(&mut self.row[column]);
                let range = pattern.l_start[column]..place;
                let above = pattern.l_rows[range.clone()].iter();
                for (&at, (l, u)) in above.zip(self.l_values[range.clone()].iter().zip(&self.u_values[range]))
                {
                    self.work[at] -= l * y;
                    self.row[at] -= u * w;
                }
                let inverse = self.inverse_diagonal[column];
                let l = w * inverse;
                pivot -= l * y;
                magnitude += (l * y).abs();
                self.l_values[place] = l;
                self.u_values[place] = y * inverse;
            }
            if pivot.is_nan() || pivot.abs() <= PIVOT_FLOOR * magnitude {
                self.work.fill(0.0);
                self.row.fill(0.0);
                return Err(ZeroPivot { unknown: pattern.order[k] });
            }
            self.inverse_diagonal[k] = 1.0 / pivot;
        }
        Ok(())
    }

    /// Solves A x = b; `b` becomes x, by unknown.
    pub fn solve(&mut self, b: &mut [f64]) {
        let pattern = &self.pattern;
        for (work, &unknown) in self.work.iter_mut().zip(&pattern.order) {
            *work = b[unknown];
        }
        for column in 0..pattern.size() {
            let value = self.work[column];
            let range = pattern.l_start[column]..pattern.l_start[column + 1];
            for (&row, l) in pattern.l_rows[range.clone()].iter().zip(&self.l_values[range]) {
                self.work[row] -= l * value;
            }
        }
        for (value, inverse) in self.work.iter_mut().zip(&self.inverse_diagonal) {
            *value *= inverse;
        }
        for column in (0..pattern.size()).rev() {
            let range = pattern.l_start[column]..pattern.l_start[column + 1];
            let rows = pattern.l_rows[range.clone()].iter();
            let known: f64 = rows.zip(&self.u_values[range]).map(|(&row, u)| u * self.work[row]).sum();
            self.work[column] -= known;
        }
        for (work, &unknown) in self.work.iter_mut().zip(&pattern.order) {
            b[unknown] = std::mem::take(work);
        }
    }
}
