//! Factorisation against dense elimination; elimination order of a real rig.

use super::rigs::cases;
use gantline_core::solver::ldl::Ldl;
use gantline_core::solver::ldu::Ldu;
use gantline_core::solver::order::{Node, NodeKind, elimination_order};
use gantline_core::solver::symbolic::Symbolic;
use proptest::prelude::*;

/// Dense solution by Gauss with partial pivoting.
fn dense(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs())).unwrap();
        a.swap(k, pivot);
        b.swap(k, pivot);
        for i in k + 1..n {
            let factor = a[i][k] / a[k][k];
            let (above, below) = a.split_at_mut(i);
            for (value, pivot) in below[0][k..].iter_mut().zip(&above[k][k..]) {
                *value -= factor * pivot;
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    b
}

/// One row that does not act: an identity row in a pattern that has a place for more.
fn idle(matrix: &mut [Vec<f64>], row: usize) {
    for other in (0..matrix.len()).filter(|&other| other != row) {
        (matrix[row][other], matrix[other][row]) = (0.0, 0.0);
    }
    matrix[row][row] = -1.0;
}

proptest! {
    #![proptest_config(cases(300))]

    /// Random quasidefinite matrices [A Gᵀ; G −S], the form of a step's matrix.
    #[test]
    fn factors_solve_random_quasidefinite_systems(
        n in 2_usize..14, m in 1_usize..8, numbers in prop::collection::vec(-1.0..1.0_f64, 600), order in Just(()).prop_perturb(|(), mut rng| rng.random::<u64>())
    ) {
        let size = n + m;
        let mut matrix = vec![vec![0.0; size]; size];
        for i in 0..n {
            for j in 0..i {
                // About half of the entries are there.
                if numbers[(i * 31 + j * 7) % 600] > 0.0 {
                    matrix[i][j] = numbers[(i * 17 + j) % 600];
                    matrix[j][i] = matrix[i][j];
                }
            }
            matrix[i][i] = size as f64;
        }
        for r in 0..m {
            for j in 0..n {
                if numbers[(r * 13 + j * 5) % 600] > 0.2 {
                    matrix[n + r][j] = numbers[(r * 3 + j) % 600];
                    matrix[j][n + r] = matrix[n + r][j];
                }
            }
            matrix[n + r][n + r] = -0.1;
        }
        let mut places: Vec<usize> = (0..size).collect();
        for k in (1..size).rev() {
            places.swap(k, (order.rotate_left(k as u32 * 5) % (k as u64 + 1)) as usize);
        }
        let entries: Vec<(usize, usize)> =
            (0..size).flat_map(|i| (0..=i).map(move |j| (i, j))).filter(|&(i, j)| matrix[i][j] != 0.0).collect();
        idle(&mut matrix, n);
        let mut ldl = Ldl::new(Symbolic::new(places, entries.clone()));
        for &(i, j) in &entries {
            let slot = ldl.pattern().slot(i, j).unwrap().0;
            ldl.values_mut()[slot] = matrix[i][j];
        }
        ldl.factorise().unwrap();
        let b: Vec<f64> = numbers[..size].to_vec();
        let mut x = vec![0.0; size];
        ldl.solve(&b, &mut x);
        let exact = dense(matrix, b);
        for (found, wanted) in x.iter().zip(&exact) {
            // Quasidefinite with condition below about 1e3; one refinement gives nearly full precision.
            prop_assert!((found - wanted).abs() < 1e-12 * (1.0 + wanted.abs()));
        }
    }
}

proptest! {
    #![proptest_config(cases(300))]

    /// Random matrices of symmetric structure and unsymmetric numbers. Blocks of neighbours that couple to the same
    /// others give columns that are taken together.
    #[test]
    fn unsymmetric_factors_solve_random_systems(
        blocks in prop::collection::vec(1_usize..5, 2..7), numbers in prop::collection::vec(-1.0..1.0_f64, 600)
    ) {
        let size: usize = blocks.iter().sum();
        let block_of: Vec<usize> =
            blocks.iter().enumerate().flat_map(|(block, &count)| vec![block; count]).collect();
        let mut matrix = vec![vec![0.0; size]; size];
        for i in 0..size {
            for j in 0..size {
                let (a, b) = (block_of[i].min(block_of[j]), block_of[i].max(block_of[j]));
                if a == b || numbers[(a * 31 + b * 7) % 600] > 0.0 {
                    matrix[i][j] = numbers[(i * 29 + j) % 600];
                }
            }
            matrix[i][i] = 2.0 * size as f64;
        }
        let coupled = |&(i, j): &(usize, usize)| matrix[i][j] != 0.0 || matrix[j][i] != 0.0;
        let entries: Vec<(usize, usize)> =
            (0..size).flat_map(|i| (0..=i).map(move |j| (i, j))).filter(coupled).collect();
        idle(&mut matrix, size / 2);
        let mut ldu = Ldu::new(Symbolic::new((0..size).collect(), entries.clone()));
        let mut values = vec![0.0; ldu.entries()];
        for (i, j) in entries {
            values[ldu.entry(j, i).unwrap()] = matrix[j][i];
            values[ldu.entry(i, j).unwrap()] = matrix[i][j];
        }
        ldu.factorise(&values).unwrap();
        let b: Vec<f64> = numbers[..size].to_vec();
        let mut x = b.clone();
        ldu.solve(&mut x);
        for (found, wanted) in x.iter().zip(&dense(matrix, b)) {
            prop_assert!((found - wanted).abs() < 1e-13 * (1.0 + wanted.abs()));
        }
    }
}

#[test]
fn a_singular_matrix_names_the_unknown() {
    let mut ldl = Ldl::new(Symbolic::new(vec![0, 1, 2], [(0, 1), (1, 2)]));
    let numbers = [((0, 0), 1.0), ((1, 0), 2.0), ((1, 1), 4.0), ((2, 1), 0.0), ((2, 2), 1.0)];
    for ((i, j), value) in numbers {
        let slot = ldl.pattern().slot(i, j).unwrap().0;
        ldl.values_mut()[slot] = value;
    }
    assert_eq!(ldl.factorise().unwrap_err().unknown, 1);
    // The work arrays are clean again: the same pattern with other numbers factorises.
    let slot = ldl.pattern().slot(1, 1).unwrap().0;
    ldl.values_mut()[slot] = 5.0;
    ldl.factorise().unwrap();
    let mut x = vec![0.0; 3];
    ldl.solve(&[1.0, 2.0, 3.0], &mut x);
    assert_eq!(x, [1.0, 0.0, 3.0]);
}

/// An equalizer of n sheaves: load (0), frame (1), sheaves, slings, equalizing rope.
fn equalizer(n: usize) -> (Vec<Node>, Vec<(usize, usize)>) {
    let joint = |size, above| Node { size, kind: NodeKind::Joint { above, after: None } };
    let row = || Node { size: 1, kind: NodeKind::Row { compliant: true, holds: None } };
    let mut nodes = vec![joint(6, None), joint(1, None)];
    nodes.extend((0..n).map(|_| joint(1, Some(1))));
    nodes.extend((0..=n).map(|_| row()));
    let mut edges = Vec::new();
    for i in 0..n {
        let (sheave, sling, equalizing) = (2 + i, 2 + n + i, 2 + 2 * n);
        edges.extend([
            (sheave, 1),
            (sheave, equalizing),
            (sling, sheave),
            (sling, 0),
            (sling, 1),
            (sheave, 0),
        ]);
    }
    (nodes, edges)
}

#[test]
fn the_order_of_an_equalizer_costs_a_constant_per_sheave() {
    let fill = |n: usize| {
        let (nodes, edges) = equalizer(n);
        let order = elimination_order(&nodes, &edges);
        let unknowns: Vec<Vec<usize>> = nodes
            .iter()
            .scan(0, |start, node| {
                let own = (*start..*start + node.size).collect();
                *start += node.size;
                Some(own)
            })
            .collect();
        let entries = edges.iter().flat_map(|&(a, b)| {
            unknowns[a].iter().flat_map(|&i| unknowns[b].iter().map(move |&j| (i, j))).collect::<Vec<_>>()
        });
        let places = order.iter().flat_map(|&node| unknowns[node].clone()).collect();
        Symbolic::new(places, entries).l_rows.len()
    };
    let (small, large) = (fill(50), fill(100));
    assert_eq!(large - small, fill(150) - large, "linear growth");
    // Sheave: load 6, frame, sling, equalizing rope; sling: load 6, frame, equalizing rope.
    assert_eq!((large - small) / 50, 9 + 8);
}

/// A rope without stretch between a hinge, on which nothing hangs, and a body that waits for another. Over the hinge alone
/// its pivot would be zero where its line meets the axis.
#[test]
fn children_go_before_parents_and_rigid_rows_after_all_their_joints() {
    let joint = |size, above| Node { size, kind: NodeKind::Joint { above, after: None } };
    let nodes = vec![
        joint(6, None),
        joint(1, Some(0)),
        joint(1, Some(1)),
        joint(1, None),
        Node { size: 1, kind: NodeKind::Row { compliant: false, holds: None } },
    ];
    let order = elimination_order(&nodes, &[(0, 1), (1, 2), (0, 2), (4, 1), (4, 3)]);
    let place = |node| order.iter().position(|&other| other == node).unwrap();
    assert!(place(2) < place(1) && place(1) < place(0));
    assert_eq!(place(3), 0, "the hinge is the cheapest");
    assert!(place(4) > place(1));
}

/// Two flows without inertia between three spans, the outer ones beside bodies of six unknowns: that in the middle
/// goes first, and must not count for both flows. With rope slipping over one of them it gives way to the other: the pivot
/// S²c − S²c of that would be zero.
#[test]
fn a_light_flow_goes_after_the_span_before_it() {
    let body = || Node { size: 6, kind: NodeKind::Joint { above: None, after: None } };
    let span = || Node { size: 1, kind: NodeKind::Row { compliant: true, holds: None } };
    let flow = |row| Node { size: 1, kind: NodeKind::Joint { above: None, after: Some(row) } };
    let nodes = [body(), body(), flow(4), flow(5), span(), span(), span()];
    let edges = [(0, 1), (4, 0), (4, 2), (5, 2), (5, 3), (6, 3), (6, 1)];
    let order = elimination_order(&nodes, &edges);
    let place = |node| order.iter().position(|&other| other == node).unwrap();
    assert_eq!(place(5), 0, "the span in the middle is the cheapest");
    assert!(place(4) < place(2) && place(5) < place(3));
}

/// The same of spans without stretch, which wait for bodies: not for the flow that waits for them, or neither would go.
#[test]
fn a_rigid_span_does_not_wait_for_the_flow_after_it() {
    let body = || Node { size: 6, kind: NodeKind::Joint { above: None, after: None } };
    let span = || Node { size: 1, kind: NodeKind::Row { compliant: false, holds: None } };
    let flow = |row| Node { size: 1, kind: NodeKind::Joint { above: None, after: Some(row) } };
    let nodes = [flow(3), body(), body(), span(), span()];
    let order = elimination_order(&nodes, &[(3, 1), (3, 0), (4, 0), (4, 2), (1, 2)]);
    let place = |node| order.iter().position(|&other| other == node).unwrap();
    assert!(place(1) < place(3) && place(3) < place(0));
    assert!(place(0) < place(4) && place(2) < place(4));
}
