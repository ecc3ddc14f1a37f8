//! Triangle meshes and how far they are closed.

use std::collections::HashMap;

use glam::DVec3;

/// Triangles between points; seen from outside they run counter-clockwise.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mesh {
    /// Points [m].
    pub vertices: Vec<DVec3>,
    /// Three points of every triangle.
    pub triangles: Vec<[usize; 3]>,
}

/// How far a mesh is closed.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Closure {
    /// Edges of one triangle only: of holes and gaps.
    pub boundary_edges: usize,
    /// Length of these together [m].
    pub boundary_length: f64,
    /// Height above the mesh's own zero of the lowest of them [m]; infinite where there is none.
    pub lowest_boundary: f64,
    /// Edges that two triangles run along in the same direction: one of them is turned inside out.
    pub turned_edges: usize,
    /// Edges of more than two triangles.
    pub crowded_edges: usize,
    /// Sum of the triangles' areas as vectors [m²]; zero where all is closed.
    pub unbalanced_area: DVec3,
    /// Volume inside [m³]; negative where the triangles face inwards. Holes count as closed by triangles between their
    /// edges and the middle of all these edges: of a hull without a deck what is below the plane of its edge.
    pub volume: f64,
}

impl Closure {
    /// True where every edge has its two triangles and these agree about what is outside.
    pub fn is_closed(&self) -> bool {
        self.boundary_edges + self.turned_edges + self.crowded_edges == 0
    }
}

impl Mesh {
    /// The same mesh with points closer than `distance` [m] made one; triangles that shrink to nothing fall away.
    ///
    /// Points are compared within cells of that size and those around: files often have a point once per triangle.
    pub fn welded(&self, distance: f64) -> Self {
        let cell = |x: f64| (x / distance).floor() as i64;
        let mut cells: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
        let mut vertices: Vec<DVec3> = Vec::new();
        let mut place_of = Vec::with_capacity(self.vertices.len());
        for &vertex in &self.vertices {
            let own = vertex.to_array().map(cell);
            let near = |index: &&usize| vertices[**index].distance(vertex) <= distance;
            let found = neighbours(own).find_map(|key| cells.get(&key)?.iter().find(near).copied());
            place_of.push(found.unwrap_or_else(|| {
                cells.entry(own).or_default().push(vertices.len());
                vertices.push(vertex);
                vertices.len() - 1
            }));
        }
        let placed = self.triangles.iter().map(|triangle| triangle.map(|vertex| place_of[vertex]));
        let triangles = placed.filter(|[a, b, c]| a != b && b != c && c != a).collect();
        Self { vertices, triangles }
    }

    /// Corners of a triangle [m].
    pub fn corners(&self, triangle: usize) -> [DVec3; 3] {
        self.triangles[triangle].map(|vertex| self.vertices[vertex])
    }

    /// How far it is closed.
    pub fn closure(&self) -> Closure {
        let mut directions: HashMap<(usize, usize), [usize; 2]> = HashMap::new();
        let mut closure = Closure { lowest_boundary: f64::INFINITY, ..Closure::default() };
        for (index, &[a, b, c]) in self.triangles.iter().enumerate() {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                let edge = directions.entry((from.min(to), from.max(to))).or_default();
                edge[usize::from(from > to)] += 1;
            }
            let [a, b, c] = self.corners(index);
            closure.unbalanced_area += (b - a).cross(c - a) / 2.0;
        }
        let mut edges: Vec<_> = directions.into_iter().collect();
        // In the order of the points: sums do not depend on how a table happens to be laid out.
        edges.sort_unstable();
        let mut around = DVec3::ZERO;
        for ((a, b), [along, against]) in edges {
            match (along, against) {
                (1, 1) => {}
                (1, 0) | (0, 1) => {
                    let ends = [a, b].map(|vertex| self.vertices[vertex]);
                    let length = ends[0].distance(ends[1]);
                    closure.boundary_edges += 1;
                    closure.boundary_length += length;
                    around += length * (ends[0] + ends[1]) / 2.0;
                    closure.lowest_boundary = closure.lowest_boundary.min(ends[0].z).min(ends[1].z);
                }
                (2, 0) | (0, 2) => closure.turned_edges += 1,
                _ => closure.crowded_edges += 1,
            }
        }
        let middle =
            if closure.boundary_length > 0.0 { around / closure.boundary_length } else { DVec3::ZERO };
        for index in 0..self.triangles.len() {
            let [a, b, c] = self.corners(index).map(|corner| corner - middle);
            closure.volume += a.dot(b.cross(c)) / 6.0;
        }
        closure
    }
}

fn neighbours([x, y, z]: [i64; 3]) -> impl Iterator<Item = [i64; 3]> {
    let around = [0, -1, 1];
    around.into_iter().flat_map(move |i| around.map(|j| (i, j))).flat_map(move |(i, j)| {
        around.map(|k| [x.saturating_add(i), y.saturating_add(j), z.saturating_add(k)])
    })
}
