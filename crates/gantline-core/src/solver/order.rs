//! Elimination order from the rig.
//!
//! Nodes are joints (with their degrees of freedom) and rows. Rules:
//! - a joint goes after the joints that hang on it, which keeps the mass matrix free of fill;
//! - a row without compliance goes after at least one of its joints, or its pivot would be zero;
//! - among those allowed the one with the fewest unknowns around it goes first; a row counts double,
//!   since eliminating it before its joints divides by its compliance.
//!
//! On an equalizer this gives: sheave slide, its sling, the next sheave, …, load, frame, equalizing rope:
//! a constant cost per sheave.

use std::collections::BTreeSet;

/// A joint or a row.
#[derive(Debug, Clone)]
pub struct Node {
    /// Number of unknowns.
    pub size: usize,
    /// What it is.
    pub kind: NodeKind,
}

/// What a node stands for.
#[derive(Debug, Clone)]
pub enum NodeKind {
    /// A joint, with the node of the nearest joint above it.
    Joint {
        /// Node above; none hangs on the world or on driven joints only.
        above: Option<usize>,
    },
    /// A row.
    Row {
        /// True where ε > 0.
        compliant: bool,
    },
}

/// Order of the nodes; `edges` are pairs of nodes that the matrix couples.
pub fn elimination_order(nodes: &[Node], edges: &[(usize, usize)]) -> Vec<usize> {
    let mut around: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); nodes.len()];
    for &(a, b) in edges {
        if a != b {
            around[a].insert(b);
            around[b].insert(a);
        }
    }
    let joints: Vec<BTreeSet<usize>> = around
        .iter()
        .map(|near| {
            near.iter().copied().filter(|&n| matches!(nodes[n].kind, NodeKind::Joint { .. })).collect()
        })
        .collect();
    let mut hanging = vec![0_usize; nodes.len()];
    for node in nodes {
        if let NodeKind::Joint { above: Some(above) } = node.kind {
            hanging[above] += 1;
        }
    }
    let mut cost: Vec<usize> = (0..nodes.len()).map(|node| node_cost(nodes, &around, node)).collect();
    let mut gone = vec![false; nodes.len()];
    let mut order = Vec::with_capacity(nodes.len());
    while order.len() < nodes.len() {
        let allowed = |node: &usize| {
            !gone[*node]
                && match nodes[*node].kind {
                    NodeKind::Joint { .. } => hanging[*node] == 0,
                    NodeKind::Row { compliant } => {
                        compliant || joints[*node].iter().any(|&joint| gone[joint])
                    }
                }
        };
        let candidates = (0..nodes.len()).filter(allowed);
        // Without joints around, an inextensible row is singular in any order: taken last, found by its pivot.
        let node = candidates
            .min_by_key(|&node| (cost[node], node))
            .or_else(|| (0..nodes.len()).find(|&node| !gone[node]));
        let Some(node) = node else { break };
        gone[node] = true;
        order.push(node);
        if let NodeKind::Joint { above: Some(above) } = nodes[node].kind {
            hanging[above] -= 1;
        }
        let neighbours: Vec<usize> = std::mem::take(&mut around[node]).into_iter().collect();
        for &a in &neighbours {
            around[a].remove(&node);
            around[a].extend(neighbours.iter().copied().filter(|&b| b != a));
        }
        for &a in &neighbours {
            cost[a] = node_cost(nodes, &around, a);
        }
    }
    order
}

fn node_cost(nodes: &[Node], around: &[BTreeSet<usize>], node: usize) -> usize {
    let near: usize = around[node].iter().map(|&other| nodes[other].size).sum();
    match nodes[node].kind {
        NodeKind::Joint { .. } => near,
        NodeKind::Row { .. } => 2 * near,
    }
}
