//! L D Lᵀ of a symmetric, indefinite sparse matrix without pivoting, up-looking, on a static pattern.

use super::symbolic::{PIVOT_FLOOR, Symbolic, ZeroPivot};

/// Symbolic and numeric factorisation. Unknowns keep their own numbering outside.
#[derive(Debug, Clone)]
pub struct Ldl {
    pattern: Symbolic,
    values: Vec<f64>,
    l_values: Vec<f64>,
    inverse_diagonal: Vec<f64>,
    work: Vec<f64>,
    residual: Vec<f64>,
}

impl Ldl {
    /// Room for the numbers of a pattern.
    pub fn new(pattern: Symbolic) -> Self {
        let size = pattern.size();
        Self {
            values: vec![0.0; pattern.rows.len()],
            l_values: vec![0.0; pattern.l_rows.len()],
            inverse_diagonal: vec![0.0; size],
            work: vec![0.0; size],
            residual: vec![0.0; size],
            pattern,
        }
    }

    /// The pattern.
    pub fn pattern(&self) -> &Symbolic {
        &self.pattern
    }

    /// The numbers, to be filled by slot.
    pub fn values_mut(&mut self) -> &mut [f64] {
        &mut self.values
    }

    /// Factorises the numbers.
    ///
    /// # Errors
    /// [`ZeroPivot`] names the unknown where the matrix is singular in this order.
    pub fn factorise(&mut self) -> Result<(), ZeroPivot> {
        for k in 0..self.pattern.size() {
            let range = self.pattern.start[k]..self.pattern.start[k + 1] - 1;
            for slot in range {
                self.work[self.pattern.rows[slot]] = self.values[slot];
            }
            let mut pivot = self.values[self.pattern.start[k + 1] - 1];
            let mut magnitude = pivot.abs();
            for entry in self.pattern.r_start[k]..self.pattern.r_start[k + 1] {
                let (column, place) = (self.pattern.r_columns[entry], self.pattern.r_places[entry]);
                let y = std::mem::take(&mut self.work[column]);
                for above in self.pattern.l_start[column]..place {
                    self.work[self.pattern.l_rows[above]] -= self.l_values[above] * y;
                }
                let l = y * self.inverse_diagonal[column];
                pivot -= l * y;
                magnitude += (l * y).abs();
                self.l_values[place] = l;
            }
            if pivot.is_nan() || pivot.abs() <= PIVOT_FLOOR * magnitude {
                self.work.fill(0.0);
                return Err(ZeroPivot { unknown: self.pattern.order[k] });
            }
            self.inverse_diagonal[k] = 1.0 / pivot;
        }
        Ok(())
    }

    /// How many pivots are negative: by Sylvester's law of inertia, how many eigenvalues of the matrix are.
    pub fn negative_pivots(&self) -> usize {
        self.inverse_diagonal.iter().filter(|inverse| **inverse < 0.0).count()
    }

    /// Solves A x = b with one step of refinement; `b` stays, `x` is written, both by unknown.
    pub fn solve(&mut self, b: &[f64], x: &mut [f64]) {
        for (place, &unknown) in self.pattern.order.iter().enumerate() {
            self.work[place] = b[unknown];
        }
        self.substitute();
        for (place, &unknown) in self.pattern.order.iter().enumerate() {
            x[unknown] = self.work[place];
            self.residual[place] = b[unknown];
        }
        for column in 0..self.pattern.size() {
            let diagonal = self.pattern.start[column + 1] - 1;
            for slot in self.pattern.start[column]..diagonal {
                let row = self.pattern.rows[slot];
                self.residual[row] -= self.values[slot] * self.work[column];
                self.residual[column] -= self.values[slot] * self.work[row];
            }
            self.residual[column] -= self.values[diagonal] * self.work[column];
        }
        std::mem::swap(&mut self.work, &mut self.residual);
        self.substitute();
        for (place, &unknown) in self.pattern.order.iter().enumerate() {
            x[unknown] += self.work[place];
            self.work[place] = 0.0;
        }
    }

    /// work = (L D Lᵀ)⁻¹ work.
    fn substitute(&mut self) {
        for column in 0..self.pattern.size() {
            let value = self.work[column];
            for entry in self.pattern.l_start[column]..self.pattern.l_start[column + 1] {
                self.work[self.pattern.l_rows[entry]] -= self.l_values[entry] * value;
            }
        }
        for (value, inverse) in self.work.iter_mut().zip(&self.inverse_diagonal) {
            *value *= inverse;
        }
        for column in (0..self.pattern.size()).rev() {
            let mut value = self.work[column];
            for entry in self.pattern.l_start[column]..self.pattern.l_start[column + 1] {
                value -= self.l_values[entry] * self.work[self.pattern.l_rows[entry]];
            }
            self.work[column] = value;
        }
    }
}
