//! L D Lᵀ of a symmetric, indefinite sparse matrix without pivoting, up-looking, on a static pattern.
//!
//! The pattern of L is found once. Row k of L solves a triangular system with the rows above it; all
//! positions are known beforehand, so factorising moves numbers only.

/// Symbolic and numeric factorisation. Unknowns keep their own numbering outside.
#[derive(Debug, Clone)]
pub struct Ldl {
    /// Unknown at every place of the elimination order.
    order: Vec<usize>,
    /// Place of every unknown.
    place: Vec<usize>,
    /// Upper triangle by columns in elimination order: start of column k, rows, diagonal last.
    start: Vec<usize>,
    rows: Vec<usize>,
    values: Vec<f64>,
    /// L by columns: start of column j and row indices, ascending.
    l_start: Vec<usize>,
    l_rows: Vec<usize>,
    l_values: Vec<f64>,
    /// For every row k of L its columns j, ascending, and the place of (k, j) in column j.
    r_start: Vec<usize>,
    r_columns: Vec<usize>,
    r_places: Vec<usize>,
    inverse_diagonal: Vec<f64>,
    work: Vec<f64>,
    residual: Vec<f64>,
}

/// A pivot that is zero within rounding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ZeroPivot {
    /// The unknown whose pivot it is.
    pub unknown: usize,
}

/// A pivot smaller than this share of the numbers it is the difference of carries no digit.
const PIVOT_FLOOR: f64 = 1e-13;

impl Ldl {
    /// The pattern with the given entries (pairs of unknowns, any triangle) in the given order.
    pub fn new(order: Vec<usize>, entries: impl IntoIterator<Item = (usize, usize)>) -> Self {
        let size = order.len();
        let mut place = vec![0; size];
        for (at, &unknown) in order.iter().enumerate() {
            place[unknown] = at;
        }
        let mut above: Vec<Vec<usize>> = (0..size).map(|k| vec![k]).collect();
        for (a, b) in entries {
            let (row, column) = (place[a].min(place[b]), place[a].max(place[b]));
            above[column].push(row);
        }
        let (mut start, mut rows) = (vec![0], Vec::new());
        for column in &mut above {
            column.sort_unstable();
            column.dedup();
            rows.extend_from_slice(column);
            start.push(rows.len());
        }
        let (row_columns, l_columns) = symbolic(&above);
        let mut l_start = vec![0];
        for column in &l_columns {
            l_start.push(l_start[l_start.len() - 1] + column.len());
        }
        let l_rows: Vec<usize> = l_columns.concat();
        let (mut r_start, mut r_columns, mut r_places) = (vec![0], Vec::new(), Vec::new());
        for (row, columns) in row_columns.iter().enumerate() {
            for &column in columns {
                let inside = l_columns[column].partition_point(|&other| other < row);
                r_columns.push(column);
                r_places.push(l_start[column] + inside);
            }
            r_start.push(r_columns.len());
        }
        Self {
            values: vec![0.0; rows.len()],
            l_values: vec![0.0; l_rows.len()],
            inverse_diagonal: vec![0.0; size],
            work: vec![0.0; size],
            residual: vec![0.0; size],
            order,
            place,
            start,
            rows,
            l_start,
            l_rows,
            r_start,
            r_columns,
            r_places,
        }
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.order.len()
    }

    /// Number of entries of L.
    pub fn fill(&self) -> usize {
        self.l_rows.len()
    }

    /// Where the entry of two unknowns is kept, if the pattern has it.
    pub fn slot(&self, a: usize, b: usize) -> Option<usize> {
        let (a, b) = (self.place[a], self.place[b]);
        let (row, column) = (a.min(b), a.max(b));
        let range = self.start[column]..self.start[column + 1];
        self.rows[range.clone()].binary_search(&row).ok().map(|inside| range.start + inside)
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
        for k in 0..self.size() {
            let range = self.start[k]..self.start[k + 1] - 1;
            for slot in range {
                self.work[self.rows[slot]] = self.values[slot];
            }
            let mut pivot = self.values[self.start[k + 1] - 1];
            let mut magnitude = pivot.abs();
            for entry in self.r_start[k]..self.r_start[k + 1] {
                let (column, place) = (self.r_columns[entry], self.r_places[entry]);
                let y = std::mem::take(&mut self.work[column]);
                for above in self.l_start[column]..place {
                    self.work[self.l_rows[above]] -= self.l_values[above] * y;
                }
                let l = y * self.inverse_diagonal[column];
                pivot -= l * y;
                magnitude += (l * y).abs();
                self.l_values[place] = l;
            }
            if pivot.is_nan() || pivot.abs() <= PIVOT_FLOOR * magnitude {
                self.work.fill(0.0);
                return Err(ZeroPivot { unknown: self.order[k] });
            }
            self.inverse_diagonal[k] = 1.0 / pivot;
        }
        Ok(())
    }

    /// Solves A x = b with one step of refinement; `b` stays, `x` is written, both by unknown.
    pub fn solve(&mut self, b: &[f64], x: &mut [f64]) {
        for (place, &unknown) in self.order.iter().enumerate() {
            self.work[place] = b[unknown];
        }
        self.substitute();
        for (place, &unknown) in self.order.iter().enumerate() {
            x[unknown] = self.work[place];
            self.residual[place] = b[unknown];
        }
        for column in 0..self.size() {
            let diagonal = self.start[column + 1] - 1;
            for slot in self.start[column]..diagonal {
                let row = self.rows[slot];
                self.residual[row] -= self.values[slot] * self.work[column];
                self.residual[column] -= self.values[slot] * self.work[row];
            }
            self.residual[column] -= self.values[diagonal] * self.work[column];
        }
        std::mem::swap(&mut self.work, &mut self.residual);
        self.substitute();
        for (place, &unknown) in self.order.iter().enumerate() {
            x[unknown] += self.work[place];
            self.work[place] = 0.0;
        }
    }

    /// work = (L D Lᵀ)⁻¹ work.
    fn substitute(&mut self) {
        for column in 0..self.size() {
            let value = self.work[column];
            for entry in self.l_start[column]..self.l_start[column + 1] {
                self.work[self.l_rows[entry]] -= self.l_values[entry] * value;
            }
        }
        for (value, inverse) in self.work.iter_mut().zip(&self.inverse_diagonal) {
            *value *= inverse;
        }
        for column in (0..self.size()).rev() {
            let mut value = self.work[column];
            for entry in self.l_start[column]..self.l_start[column + 1] {
                value -= self.l_values[entry] * self.work[self.l_rows[entry]];
            }
            self.work[column] = value;
        }
    }
}

/// Columns of every row and rows of every column of L, from the upper triangle by columns (diagonal
/// included): row k is the union of the paths up the elimination tree from the entries of column k.
fn symbolic(above: &[Vec<usize>]) -> (Vec<Vec<usize>>, Vec<Vec<usize>>) {
    let size = above.len();
    let mut parent = vec![usize::MAX; size];
    let mut mark = vec![usize::MAX; size];
    let mut row_columns = vec![Vec::new(); size];
    let mut l_columns = vec![Vec::new(); size];
    for k in 0..size {
        mark[k] = k;
        for &entry in &above[k] {
            let mut node = entry;
            while mark[node] != k {
                mark[node] = k;
                if parent[node] == usize::MAX {
                    parent[node] = k;
                }
                row_columns[k].push(node);
                l_columns[node].push(k);
                node = parent[node];
            }
        }
        row_columns[k].sort_unstable();
    }
    (row_columns, l_columns)
}
