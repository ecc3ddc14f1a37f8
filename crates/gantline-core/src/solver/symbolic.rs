//! The static pattern of a factorisation: elimination order, fill, and where every number goes.
//!
//! Row k of the factors solves a triangular system with the rows above it (up-looking). All positions are
//! known beforehand, so factorising moves numbers only.

/// Pattern of a matrix with symmetric structure and of its factors.
#[derive(Debug, Clone)]
pub struct Symbolic {
    /// Unknown at every place of the elimination order.
    pub order: Vec<usize>,
    /// Place of every unknown.
    pub place: Vec<usize>,
    /// Upper triangle by columns in elimination order: start of column k.
    pub start: Vec<usize>,
    /// Rows of the upper triangle; the diagonal is last in every column.
    pub rows: Vec<usize>,
    /// L by columns: start of column j.
    pub l_start: Vec<usize>,
    /// Row indices of L, ascending in every column. Uᵀ has the same pattern.
    pub l_rows: Vec<usize>,
    /// Start of every row of L in `r_columns` and `r_places`.
    pub r_start: Vec<usize>,
    /// Columns of every row of L, ascending.
    pub r_columns: Vec<usize>,
    /// Place of the entry in its column.
    pub r_places: Vec<usize>,
}

/// A pivot that is zero within rounding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ZeroPivot {
    /// The unknown whose pivot it is.
    pub unknown: usize,
}

/// A pivot smaller than this share of the numbers it is the difference of carries no digit.
pub const PIVOT_FLOOR: f64 = 1e-13;

impl Symbolic {
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
        let (row_columns, l_columns) = fill(&above);
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
        Self { order, place, start, rows, l_start, l_rows, r_start, r_columns, r_places }
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.order.len()
    }

    /// Where the entry of two unknowns is kept, if the pattern has it, and whether (a, b) lies in the upper
    /// triangle of the elimination order.
    pub fn slot(&self, a: usize, b: usize) -> Option<(usize, bool)> {
        let (a, b) = (self.place[a], self.place[b]);
        let (row, column) = (a.min(b), a.max(b));
        let range = self.start[column]..self.start[column + 1];
        let inside = self.rows[range.clone()].binary_search(&row).ok()?;
        Some((range.start + inside, a <= b))
    }
}

/// Columns of every row and rows of every column of L, from the upper triangle by columns (diagonal
/// included): row k is the union of the paths up the elimination tree from the entries of column k.
fn fill(above: &[Vec<usize>]) -> (Vec<Vec<usize>>, Vec<Vec<usize>>) {
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
