//! L D Lᵀ of a symmetric, indefinite sparse matrix without pivoting, up-looking, on a static pattern.

use super::symbolic::{PIVOT_FLOOR, Symbolic, ZeroPivot};

/// Symbolic and numeric factorisation. Unknowns keep their own numbering outside.
#[derive(Debug, Clone)]
pub struct Ldl {
    pattern: Symbolic,
    values: Vec<f64>,
    /// L by columns.
    factors: Vec<Factor>,
    inverse_diagonal: Vec<f64>,
    work: Vec<f64>,
    residual: Vec<f64>,
}

/// An entry of L.
#[derive(Debug, Clone, Copy)]
struct Factor {
    row: u32,
    value: f64,
}

impl Ldl {
    /// Room for the numbers of a pattern.
    pub fn new(pattern: Symbolic) -> Self {
        let size = pattern.size();
        Self {
            values: vec![0.0; pattern.rows.len()],
            factors: pattern.l_rows.iter().map(|&row| Factor { row: row as u32, value: 0.0 }).collect(),
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
        let Self { pattern, values, factors, inverse_diagonal, work, .. } = self;
        for k in 0..pattern.size() {
            let diagonal = pattern.start[k + 1] - 1;
            let above = pattern.start[k]..diagonal;
            for (&row, &value) in pattern.rows[above.clone()].iter().zip(&values[above]) {
                work[row] = value;
            }
            let mut pivot = values[diagonal];
            let mut magnitude = pivot.abs();
            let entries = pattern.r_start[k]..pattern.r_start[k + 1];
            for (&column, &place) in pattern.r_columns[entries.clone()].iter().zip(&pattern.r_places[entries])
            {
                let y = std::mem::take(&mut work[column]);
                // Rows that do not act have nothing but zeros.
                if y == 0.0 {
                    factors[place].value = 0.0;
                    continue;
                }
                for &Factor { row, value } in &factors[pattern.l_start[column]..place] {
                    work[row as usize] -= value * y;
                }
                let l = y * inverse_diagonal[column];
                pivot -= l * y;
                magnitude += (l * y).abs();
                factors[place].value = l;
            }
            if pivot.is_nan() || pivot.abs() <= PIVOT_FLOOR * magnitude {
                work.fill(0.0);
                return Err(ZeroPivot { unknown: pattern.order[k] });
            }
            inverse_diagonal[k] = 1.0 / pivot;
        }
        Ok(())
    }

    /// How many pivots are negative: by Sylvester's law of inertia, how many eigenvalues of the matrix are.
    pub fn negative_pivots(&self) -> usize {
        self.inverse_diagonal.iter().filter(|inverse| **inverse < 0.0).count()
    }

    /// Solves A x = b with one step of refinement; `b` stays, `x` is written, both by unknown.
    pub fn solve(&mut self, b: &[f64], x: &mut [f64]) {
        self.solve_roughly(b, x);
        for (place, &unknown) in self.pattern.order.iter().enumerate() {
            self.work[place] = x[unknown];
            self.residual[place] = b[unknown];
        }
        for (column, bounds) in self.pattern.start.windows(2).enumerate() {
            let above = bounds[0]..bounds[1] - 1;
            let x = self.work[column];
            let mut left = self.residual[column];
            for (&row, &value) in self.pattern.rows[above.clone()].iter().zip(&self.values[above]) {
                self.residual[row] -= value * x;
                left -= value * self.work[row];
            }
            self.residual[column] = left - self.values[bounds[1] - 1] * x;
        }
        std::mem::swap(&mut self.work, &mut self.residual);
        self.substitute();
        for (place, &unknown) in self.pattern.order.iter().enumerate() {
            x[unknown] += self.work[place];
            self.work[place] = 0.0;
        }
    }

    /// The same without refinement, for steps that are refined by those that follow.
    pub fn solve_roughly(&mut self, b: &[f64], x: &mut [f64]) {
        for (place, &unknown) in self.pattern.order.iter().enumerate() {
            self.work[place] = b[unknown];
        }
        self.substitute();
        for (place, &unknown) in self.pattern.order.iter().enumerate() {
            x[unknown] = self.work[place];
            self.work[place] = 0.0;
        }
    }

    /// work = (L D Lᵀ)⁻¹ work.
    fn substitute(&mut self) {
        let Self { pattern, factors, inverse_diagonal, work, .. } = self;
        for (column, bounds) in pattern.l_start.windows(2).enumerate() {
            let known = work[column];
            if known == 0.0 {
                continue;
            }
            for &Factor { row, value } in &factors[bounds[0]..bounds[1]] {
                work[row as usize] -= value * known;
            }
        }
        for (column, bounds) in pattern.l_start.windows(2).enumerate().rev() {
            let mut unknown = work[column] * inverse_diagonal[column];
            for &Factor { row, value } in &factors[bounds[0]..bounds[1]] {
                unknown -= value * work[row as usize];
            }
            work[column] = unknown;
        }
    }
}
