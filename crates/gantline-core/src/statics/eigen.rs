//! Eigenvalues and eigenvectors of dense symmetric matrices, and of K x = ω² M x: to tridiagonal form by Householder's
//! reflections, from there by the QL algorithm with implicit shifts (Golub and Van Loan, Matrix Computations, sections
//! 8.3 and 8.7; Dubrulle, Martin, Wilkinson 1968).

/// Rotations that one eigenvalue may take.
const SWEEPS: usize = 60;

/// A square matrix, row-major.
#[derive(Debug, Clone, PartialEq)]
pub struct Square {
    /// Rows and columns.
    pub size: usize,
    /// Entries.
    pub values: Vec<f64>,
}

impl Square {
    /// With the given entries.
    pub fn new(size: usize, values: Vec<f64>) -> Self {
        Self { size, values }
    }

    fn at(&self, row: usize, column: usize) -> f64 {
        self.values[row * self.size + column]
    }

    fn at_mut(&mut self, row: usize, column: usize) -> &mut f64 {
        &mut self.values[row * self.size + column]
    }
}

/// Eigenvalues in ascending order and their vectors, one per row. Only symmetric matrices.
pub fn eigen(mut a: Square) -> (Vec<f64>, Square) {
    let size = a.size;
    let (mut diagonal, mut beside) = (vec![0.0; size], vec![0.0; size]);
    tridiagonal(&mut a, &mut diagonal, &mut beside);
    // Rows of `a` are now those of Qᵀ: rotations combine them.
    implicit_ql(&mut diagonal, &mut beside, &mut a);
    let mut order: Vec<usize> = (0..size).collect();
    order.sort_by(|&x, &y| diagonal[x].total_cmp(&diagonal[y]));
    let rows = order.iter().flat_map(|&row| a.values[row * size..(row + 1) * size].iter().copied()).collect();
    (order.iter().map(|&index| diagonal[index]).collect(), Square::new(size, rows))
}

/// Q A Qᵀ tridiagonal, Qᵀ's rows into `a` so that row i is the basis vector of index i.
fn tridiagonal(a: &mut Square, diagonal: &mut [f64], beside: &mut [f64]) {
    let size = a.size;
    let mut basis = Square::new(size, vec![0.0; size * size]);
    for index in 0..size {
        *basis.at_mut(index, index) = 1.0;
    }
    let (mut vector, mut product) = (vec![0.0; size], vec![0.0; size]);
    for k in 0..size.saturating_sub(2) {
        // Reflects column k below the diagonal onto its first entry.
        let norm = (k + 1..size).map(|row| a.at(row, k).powi(2)).sum::<f64>().sqrt();
        let first = a.at(k + 1, k);
        if norm == 0.0 || (k + 2..size).all(|row| a.at(row, k) == 0.0) {
            continue;
        }
        vector.fill(0.0);
        for (row, entry) in vector.iter_mut().enumerate().skip(k + 1) {
            *entry = a.at(row, k);
        }
        vector[k + 1] = first + norm.copysign(first);
        let half = 2.0 / vector[k + 1..].iter().map(|entry| entry * entry).sum::<f64>();
        for (row, entry) in product.iter_mut().enumerate() {
            *entry = half * (k + 1..size).map(|column| a.at(row, column) * vector[column]).sum::<f64>();
        }
        let along = 0.5 * half * (k + 1..size).map(|row| vector[row] * product[row]).sum::<f64>();
        for (entry, part) in product.iter_mut().zip(&vector) {
            *entry -= along * part;
        }
        for row in 0..size {
            for column in 0..size {
                *a.at_mut(row, column) -= vector[row] * product[column] + product[row] * vector[column];
            }
        }
        for column in 0..size {
            let dot = half * (k + 1..size).map(|row| vector[row] * basis.at(row, column)).sum::<f64>();
            for row in k + 1..size {
                *basis.at_mut(row, column) -= dot * vector[row];
            }
        }
    }
    for index in 0..size {
        diagonal[index] = a.at(index, index);
        beside[index] = if index + 1 < size { a.at(index + 1, index) } else { 0.0 };
    }
    *a = basis;
}

/// Diagonalises a tridiagonal matrix; the rows of `basis` follow.
fn implicit_ql(diagonal: &mut [f64], beside: &mut [f64], basis: &mut Square) {
    let size = diagonal.len();
    for l in 0..size {
        for _ in 0..SWEEPS {
            let small =
                |m: &usize| beside[*m].abs() <= f64::EPSILON * (diagonal[*m].abs() + diagonal[*m + 1].abs());
            let m = (l..size - 1).find(small).unwrap_or(size - 1);
            if m == l {
                break;
            }
            let g = (diagonal[l + 1] - diagonal[l]) / (2.0 * beside[l]);
            let mut g = diagonal[m] - diagonal[l] + beside[l] / (g + g.hypot(1.0).copysign(g));
            let (mut sine, mut cosine, mut p) = (1.0, 1.0, 0.0);
            let mut split = false;
            for i in (l..m).rev() {
                let (f, b) = (sine * beside[i], cosine * beside[i]);
                let r = f.hypot(g);
                beside[i + 1] = r;
                if r == 0.0 {
                    diagonal[i + 1] -= p;
                    beside[m] = 0.0;
                    split = true;
                    break;
                }
                (sine, cosine) = (f / r, g / r);
                g = diagonal[i + 1] - p;
                let r = (diagonal[i] - g) * sine + 2.0 * cosine * b;
                p = sine * r;
                diagonal[i + 1] = g + p;
                g = cosine * r - b;
                for column in 0..size {
                    let (upper, lower) = (basis.at(i, column), basis.at(i + 1, column));
                    *basis.at_mut(i + 1, column) = sine * upper + cosine * lower;
                    *basis.at_mut(i, column) = cosine * upper - sine * lower;
                }
            }
            if !split {
                diagonal[l] -= p;
                beside[l] = g;
                beside[m] = 0.0;
            }
        }
    }
}

/// Solutions of K x = ω² M x with xᵀ M x = 1, ascending, one vector per row; only motions with `held` · x = 0 for
/// every row of `held`. None where M is not positive definite.
pub fn vibrations(mass: &Square, stiffness: &Square, held: &[Vec<f64>]) -> Option<(Vec<f64>, Vec<Vec<f64>>)> {
    let size = mass.size;
    let lower = cholesky(mass)?;
    // C = L⁻¹ K L⁻ᵀ, y = Lᵀ x.
    let mut columns = stiffness.clone();
    for column in 0..size {
        forward(&lower, |row| column + row * size, &mut columns.values);
    }
    for row in 0..size {
        forward(&lower, |column| row * size + column, &mut columns.values);
    }
    let mut c = columns;
    for row in 0..size {
        for column in 0..row {
            let mean = 0.5 * (c.at(row, column) + c.at(column, row));
            (*c.at_mut(row, column), *c.at_mut(column, row)) = (mean, mean);
        }
    }
    let basis = held_basis(&lower, held);
    let far = 4.0 * c.values.iter().fold(1.0_f64, |most, value| most.max(value.abs())) * size as f64;
    project(&mut c, &basis, far);
    let (values, vectors) = eigen(c);
    let free = size - basis.len();
    let shapes = (0..free).map(|index| {
        let mut x = vectors.values[index * size..(index + 1) * size].to_vec();
        for row in (0..size).rev() {
            let known: f64 = (row + 1..size).map(|below| lower.at(below, row) * x[below]).sum();
            x[row] = (x[row] - known) / lower.at(row, row);
        }
        x
    });
    Some((values[..free].to_vec(), shapes.collect()))
}

/// L of M = L Lᵀ.
fn cholesky(mass: &Square) -> Option<Square> {
    let size = mass.size;
    let mut lower = Square::new(size, vec![0.0; size * size]);
    for row in 0..size {
        for column in 0..=row {
            let known: f64 = (0..column).map(|k| lower.at(row, k) * lower.at(column, k)).sum();
            let value = mass.at(row, column) - known;
            if row == column && (value.is_nan() || value <= 0.0) {
                return None;
            }
            *lower.at_mut(row, column) =
                if row == column { value.sqrt() } else { value / lower.at(column, column) };
        }
    }
    Some(lower)
}

/// x = L⁻¹ x of the numbers that `place` says.
fn forward(lower: &Square, place: impl Fn(usize) -> usize, x: &mut [f64]) {
    for row in 0..lower.size {
        let known: f64 = (0..row).map(|k| lower.at(row, k) * x[place(k)]).sum();
        x[place(row)] = (x[place(row)] - known) / lower.at(row, row);
    }
}

/// Orthonormal basis of L⁻¹ of the held directions, by Gram and Schmidt, twice; what repeats another is left out.
fn held_basis(lower: &Square, held: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for row in held {
        let mut y = row.clone();
        forward(lower, |k| k, &mut y);
        let before = norm(&y);
        for _ in 0..2 {
            for other in &basis {
                let along: f64 = y.iter().zip(other).map(|(a, b)| a * b).sum();
                y.iter_mut().zip(other).for_each(|(a, b)| *a -= along * b);
            }
        }
        let left = norm(&y);
        if left > 1e-9 * before {
            y.iter_mut().for_each(|entry| *entry /= left);
            basis.push(y);
        }
    }
    basis
}

fn norm(x: &[f64]) -> f64 {
    x.iter().map(|entry| entry * entry).sum::<f64>().sqrt()
}

/// P C P + far (1 − P), P the projection away from `basis`: held directions go to the end of the spectrum.
fn project(c: &mut Square, basis: &[Vec<f64>], far: f64) {
    let size = c.size;
    for vector in basis {
        let product: Vec<f64> =
            (0..size).map(|row| (0..size).map(|k| c.at(row, k) * vector[k]).sum()).collect();
        let along: f64 = vector.iter().zip(&product).map(|(a, b)| a * b).sum();
        for row in 0..size {
            for column in 0..size {
                *c.at_mut(row, column) += (along + far) * vector[row] * vector[column]
                    - vector[row] * product[column]
                    - product[row] * vector[column];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn random(size: usize, seed: u64) -> Square {
        let mut state = seed;
        let mut number = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / (1u64 << 31) as f64 * 2.0 - 1.0
        };
        let raw: Vec<f64> = (0..size * size).map(|_| number()).collect();
        let values =
            (0..size * size).map(|place| raw[place] + raw[place % size * size + place / size]).collect();
        Square::new(size, values)
    }

    #[test]
    fn vectors_solve_their_equation() {
        for size in [1, 2, 3, 7, 40] {
            let a = random(size, size as u64);
            let (values, vectors) = eigen(a.clone());
            for (index, value) in values.iter().enumerate() {
                let x = &vectors.values[index * size..(index + 1) * size];
                assert!((norm(x) - 1.0).abs() < 1e-13);
                for row in 0..size {
                    let product: f64 = (0..size).map(|k| a.at(row, k) * x[k]).sum();
                    // Rounding of n² rotations of numbers of size n.
                    assert!((product - value * x[row]).abs() < 1e-12 * size as f64, "{size} {index} {row}");
                }
            }
            assert!(values.windows(2).all(|pair| pair[0] <= pair[1]));
        }
    }

    #[test]
    fn equal_eigenvalues_have_their_own_vectors() {
        let (values, vectors) = eigen(Square::new(3, vec![2.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 2.0]));
        assert_eq!(values, [2.0; 3]);
        assert_eq!(vectors.values, [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
    }

    #[test]
    fn what_is_held_does_not_move() {
        // Masses 1, 2, 3 on springs to the ground 4, 5, 6; x0 = x1 held together: ω² = 9/3 and 6/3.
        let mass = Square::new(3, vec![1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 3.0]);
        let stiffness = Square::new(3, vec![4.0, 0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 6.0]);
        let (values, shapes) = vibrations(&mass, &stiffness, &[vec![1.0, -1.0, 0.0]]).unwrap();
        assert!((values[0] - 2.0).abs() < 1e-14 && (values[1] - 3.0).abs() < 1e-14);
        assert!((shapes[1][0].abs() - 1.0 / 3.0_f64.sqrt()).abs() < 1e-14);
        assert!((shapes[1][0] - shapes[1][1]).abs() < 1e-14);
    }
}
