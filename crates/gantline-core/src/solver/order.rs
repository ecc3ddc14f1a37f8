//! Elimination order from the rig.
//!
//! Nodes are joints (with their degrees of freedom) and rows. Rules:
//! - a joint goes after the joints that hang on it, which keeps the mass matrix free of fill;
//! - a row without compliance goes after all of its joints, but for flows that wait for it: its pivot is −G M⁻¹ Gᵀ
//!   over the joints that are gone, and near where a rope's line meets the axis of a joint the part of that joint
//!   goes through zero; that of a brake or a pin goes after what it holds;
//! - among those allowed the one with the fewest unknowns around it goes first; a row of which no joint has gone
//!   counts double, since eliminating it divides by its compliance; so does that of an inextensible rope.
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
        /// For the flow of a light sheave, whose pivot is zero before, the row that has to go first: that of the span before it.
        /// Were it any row beside it, two flows might count on one span: where both slip, rope between them gives way.
        after: Option<usize>,
    },
    /// A row.
    Row {
        /// True where ε > 0.
        compliant: bool,
        /// The one joint that the row holds, where it is coupled to others by its bound only.
        holds: Option<usize>,
    },
}

/// Order of the nodes; `edges` are pairs of nodes that the matrix couples.
pub fn elimination_order(nodes: &[Node], edges: &[(usize, usize)]) -> Vec<usize> {
    let mut elimination = Elimination::new(nodes, edges);
    let mut order = Vec::with_capacity(nodes.len());
    while order.len() < nodes.len() {
        // Without joints around, an inextensible row is singular in any order: taken last, found by its pivot.
        let next = elimination.queue.first().map(|&(_, node)| node);
        let Some(node) = next.or_else(|| elimination.gone.iter().position(|gone| !gone)) else { break };
        elimination.take(node);
        order.push(node);
    }
    order
}

/// The graph of what is left.
struct Elimination<'a> {
    nodes: &'a [Node],
    around: Vec<BTreeSet<usize>>,
    /// Unknowns of the nodes around.
    near: Vec<usize>,
    /// Rows without compliance that each joint is coupled to.
    rigid: Vec<Vec<usize>>,
    /// Joints that each of those rows is coupled to and that are left.
    waiting: Vec<usize>,
    /// Joints that hang on each joint and are left.
    hanging: Vec<usize>,
    gone: Vec<bool>,
    /// True for nodes around a joint that is gone.
    met: Vec<bool>,
    /// Nodes that are allowed, by cost.
    queue: BTreeSet<(usize, usize)>,
}

impl<'a> Elimination<'a> {
    fn new(nodes: &'a [Node], edges: &[(usize, usize)]) -> Self {
        let mut graph = Self {
            nodes,
            around: vec![BTreeSet::new(); nodes.len()],
            near: vec![0; nodes.len()],
            rigid: vec![Vec::new(); nodes.len()],
            waiting: vec![0; nodes.len()],
            hanging: vec![0; nodes.len()],
            gone: vec![false; nodes.len()],
            met: vec![false; nodes.len()],
            queue: BTreeSet::new(),
        };
        for &(a, b) in edges {
            graph.couple(a, b);
            graph.couple(b, a);
        }
        for (index, node) in nodes.iter().enumerate() {
            match node.kind {
                NodeKind::Joint { above: Some(above), .. } => graph.hanging[above] += 1,
                NodeKind::Joint { above: None, .. } | NodeKind::Row { compliant: true, .. } => {}
                NodeKind::Row { holds: Some(joint), .. } => {
                    graph.rigid[joint].push(index);
                    graph.waiting[index] = 1;
                }
                NodeKind::Row { holds: None, .. } => {
                    let goes_before = |near: &&usize| match nodes[**near].kind {
                        NodeKind::Joint { after, .. } => after != Some(index),
                        NodeKind::Row { .. } => false,
                    };
                    for &joint in graph.around[index].iter().filter(goes_before) {
                        graph.rigid[joint].push(index);
                        graph.waiting[index] += 1;
                    }
                }
            }
        }
        for (index, node) in nodes.iter().enumerate() {
            let allowed = match node.kind {
                NodeKind::Joint { after, .. } => graph.hanging[index] == 0 && after.is_none(),
                NodeKind::Row { compliant, .. } => compliant,
            };
            if allowed {
                graph.queue.insert(graph.key(index));
            }
        }
        graph
    }

    fn key(&self, node: usize) -> (usize, usize) {
        let double = match self.nodes[node].kind {
            NodeKind::Joint { .. } => false,
            NodeKind::Row { compliant, holds } => !(self.met[node] && (compliant || holds.is_some())),
        };
        (if double { 2 * self.near[node] } else { self.near[node] }, node)
    }

    /// Puts `b` among the nodes around `a`.
    fn couple(&mut self, a: usize, b: usize) {
        if a != b && self.around[a].insert(b) {
            self.near[a] += self.nodes[b].size;
        }
    }

    /// Eliminates a node: those around it now couple to each other.
    fn take(&mut self, node: usize) {
        self.gone[node] = true;
        self.queue.remove(&self.key(node));
        let around = std::mem::take(&mut self.around[node]);
        let is_joint = matches!(self.nodes[node].kind, NodeKind::Joint { .. });
        for &a in &around {
            let queued = self.queue.remove(&self.key(a));
            self.around[a].remove(&node);
            self.near[a] -= self.nodes[node].size;
            self.met[a] |= is_joint;
            let freed = matches!(self.nodes[a].kind, NodeKind::Joint { after: Some(row), .. } if row == node);
            for &b in &around {
                self.couple(a, b);
            }
            if queued || freed {
                self.queue.insert(self.key(a));
            }
        }
        if let NodeKind::Joint { above: Some(above), .. } = self.nodes[node].kind {
            self.hanging[above] -= 1;
            if self.hanging[above] == 0 {
                self.queue.insert(self.key(above));
            }
        }
        let rigid = std::mem::take(&mut self.rigid[node]);
        for &row in &rigid {
            self.waiting[row] -= 1;
            if !self.gone[row] && self.waiting[row] == 0 {
                self.queue.insert(self.key(row));
            }
        }
    }
}
