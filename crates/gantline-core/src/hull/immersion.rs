//! Volume below a plane, its moments, and the plane's section, exactly.
//!
//! With h(x) = n·x + d the height over the plane, and N dS outwards, Gauss' theorem turns integrals over the volume
//! below into integrals over the panels below; the plane's own section adds nothing to them, since h = 0 there:
//!
//! ```text
//! ∫ dV = ∫ h n·N dS        ∫ h dV = ½ ∫ h² n·N dS        ∫ x dV = ∫ x h n·N dS − n ∫ h dV
//! ```
//!
//! The first is the vertical part of the pressure on the panels: columns of water between panel and plane. A hole
//! takes its own column away and nothing else, and forces stay those of a potential.
//!
//! Panels that lie near each other are a group. Over a group that is all below, the integrals are polynomials in n and d
//! with 30 coefficients, Σ ∫ x_i x_j N_k dS, Σ ∫ x_i N_k dS and Σ ∫ N_k dS; only groups that the plane may cut are
//! looked at panel by panel.
//!
//! The section follows from its boundary, the waterline: of each piece p–q the triangle with the origin's foot on the
//! plane. Its moments are the derivatives of the volume's.

use std::cmp::Ordering;

use glam::{DMat3, DVec3};

use super::mesh::Mesh;
use super::panel::{Panel, Plane};

/// Panels of a group, at most.
const GROUP: usize = 16;
/// Coefficients of a group: 18 of second order, 9 of first, 3 of zeroth; two more make it even.
const COEFFICIENTS: usize = 32;
/// Rounding of heights, relative to the size of the hull.
const ROUNDING: f64 = 1e-13;

/// What lies below a plane, in the axes of the hull and about its origin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Immersion {
    /// Volume below [m³].
    pub volume: f64,
    /// ∫ x dV [m⁴].
    pub moment: DVec3,
    /// ∫ −h dV: volume times the depth of its centre [m⁴].
    pub depth_moment: f64,
    /// Area of the section with the plane [m²].
    pub area: f64,
    /// ∫ x dA over the section [m³].
    pub area_moment: DVec3,
    /// ∫ x xᵀ dA over the section [m⁴].
    pub area_second: DMat3,
}

/// A mesh made ready for being cut; positions are kept about its middle.
#[derive(Debug, Clone)]
pub struct Hull {
    middle: DVec3,
    /// Sum of the sides of the box around it [m].
    size: f64,
    /// Coordinates of the first, second and third corners and areas of all panels: x, y, z of each in an array.
    corners: [[Vec<f64>; 3]; 3],
    areas: [Vec<f64>; 3],
    groups: Vec<Group>,
}

#[derive(Debug, Clone)]
struct Group {
    /// First panel and the one after the last.
    panels: [usize; 2],
    /// Middle and half the size of the box around it [m].
    middle: DVec3,
    half: DVec3,
    coefficients: [f64; COEFFICIENTS],
}

/// Sums over panels below the plane.
#[derive(Debug, Clone, Copy)]
struct Sums {
    /// ∫ h c, c = n·N dS.
    volume: f64,
    /// ∫ x h c.
    moment: DVec3,
    /// ∫ h² c.
    square: f64,
    /// ∫ dA, ∫ x dA and ∫ x xᵀ dA about the foot of the middle on the plane.
    area: f64,
    area_moment: DVec3,
    area_second: DMat3,
}

fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}

impl Hull {
    /// A hull of the triangles of `mesh`.
    pub fn new(mesh: &Mesh) -> Self {
        let used = || mesh.triangles.iter().flatten().map(|&vertex| mesh.vertices[vertex]);
        let (low, high) = bounds(used());
        let middle = if mesh.triangles.is_empty() { DVec3::ZERO } else { (low + high) / 2.0 };
        let mut order: Vec<usize> = (0..mesh.triangles.len()).collect();
        let centres: Vec<DVec3> =
            (0..order.len()).map(|index| mesh.corners(index).iter().sum::<DVec3>() / 3.0).collect();
        let mut starts = vec![0];
        split(&centres, &mut order, &mut starts);
        let panels: Vec<[DVec3; 3]> =
            order.iter().map(|&index| mesh.corners(index).map(|corner| corner - middle)).collect();
        let area = |[a, b, c]: &[DVec3; 3]| (b - a).cross(c - a) / 2.0;
        let axis = |corner: usize, axis: usize| panels.iter().map(|panel| panel[corner][axis]).collect();
        let groups = starts.windows(2).map(|ends| Group::new([ends[0], ends[1]], &panels)).collect();
        Self {
            middle,
            size: if mesh.triangles.is_empty() { 0.0 } else { (high - low).element_sum() },
            corners: [0, 1, 2].map(|corner| [0, 1, 2].map(|coordinate| axis(corner, coordinate))),
            areas: [0, 1, 2].map(|axis| panels.iter().map(|panel| area(panel)[axis]).collect()),
            groups,
        }
    }

    /// How many panels it has.
    pub fn panels(&self) -> usize {
        self.areas[0].len()
    }

    /// Least and largest `direction`·x that boxes around its panels have [m].
    pub fn span(&self, direction: DVec3) -> (f64, f64) {
        let size = direction.abs();
        let ends = self.groups.iter().map(|group| (direction.dot(group.middle), size.dot(group.half)));
        let none = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) =
            ends.fold(none, |(low, high), (at, half)| (low.min(at - half), high.max(at + half)));
        let shift = direction.dot(self.middle);
        (low + shift, high + shift)
    }

    /// What lies below `plane`. Allocates nothing.
    pub fn below(&self, plane: &Plane) -> Immersion {
        let shifted = Plane { height: plane.above(self.middle), ..*plane };
        let size = shifted.normal.abs();
        // Whether a corner is below must not depend on the group that asks.
        let doubt = ROUNDING * (shifted.height.abs() + self.size);
        let mut whole = [0.0; COEFFICIENTS];
        let mut sums = Sums::NONE;
        for group in &self.groups {
            let (above, half) = (shifted.above(group.middle), size.dot(group.half));
            if above + half < -doubt {
                for (sum, coefficient) in whole.iter_mut().zip(&group.coefficients) {
                    *sum += coefficient;
                }
            } else if above - half < doubt {
                (group.panels[0]..group.panels[1]).for_each(|panel| self.add(&shifted, panel, &mut sums));
            }
        }
        sums.add_whole(&shifted, &whole);
        sums.about(&shifted, self.middle)
    }

    /// ∫ x xᵀ dV of what lies below `plane`, of a closed mesh [m⁵]. Allocates nothing.
    ///
    /// Every panel spans a tetrahedron with one point of the plane, and those over the plane's own section have no
    /// volume. Of one with the corner 0, V/20 (Σ r rᵀ + Σr Σrᵀ).
    pub fn second_below(&self, plane: &Plane) -> DMat3 {
        let shifted = Plane { height: plane.above(self.middle), ..*plane };
        let foot = shifted.normal * -shifted.height;
        let (mut volume, mut first, mut second) = (0.0, DVec3::ZERO, DMat3::ZERO);
        for index in 0..self.panels() {
            let corners = [0, 1, 2].map(|corner| self.corner(index, corner));
            let heights = corners.map(|corner| shifted.above(corner));
            let area = DVec3::new(self.areas[0][index], self.areas[1][index], self.areas[2][index]);
            let below = Panel { corners, heights, area }.below();
            for part in &below.parts[..below.count] {
                let [a, b, c] = part.corners.map(|corner| corner - foot);
                let (own, sum) = (a.dot(b.cross(c)) / 6.0, a + b + c);
                volume += own;
                first += sum * (own / 4.0);
                second += (outer(a, a) + outer(b, b) + outer(c, c) + outer(sum, sum)) * (own / 20.0);
            }
        }
        let foot = foot + self.middle;
        second + outer(first, foot) + outer(foot, first) + outer(foot, foot) * volume
    }

    #[inline]
    fn corner(&self, panel: usize, corner: usize) -> DVec3 {
        let [x, y, z] = &self.corners[corner];
        DVec3::new(x[panel], y[panel], z[panel])
    }

    #[inline]
    fn add(&self, plane: &Plane, index: usize, sums: &mut Sums) {
        let corners = [0, 1, 2].map(|corner| self.corner(index, corner));
        let heights = corners.map(|corner| plane.above(corner));
        if heights.iter().all(|height| *height >= 0.0) {
            return;
        }
        let area = DVec3::new(self.areas[0][index], self.areas[1][index], self.areas[2][index]);
        let panel = Panel { corners, heights, area };
        if heights.iter().all(|height| *height < 0.0) {
            sums.add(plane.normal, &panel);
            return;
        }
        let below = panel.below();
        below.parts[..below.count].iter().for_each(|part| sums.add(plane.normal, part));
        if let Some(ends) = below.waterline {
            sums.add_waterline(plane, ends);
        }
    }
}

impl Sums {
    const NONE: Self = Self {
        volume: 0.0,
        moment: DVec3::ZERO,
        square: 0.0,
        area: 0.0,
        area_moment: DVec3::ZERO,
        area_second: DMat3::ZERO,
    };

    #[inline]
    fn add(&mut self, normal: DVec3, panel: &Panel) {
        let ([a, b, c], [ha, hb, hc]) = (panel.corners, panel.heights);
        let column = normal.dot(panel.area);
        let sum = ha + hb + hc;
        self.volume += column * sum / 3.0;
        self.moment += (a * (sum + ha) + b * (sum + hb) + c * (sum + hc)) * (column / 12.0);
        self.square += column / 12.0 * (sum * sum + ha * ha + hb * hb + hc * hc);
    }

    /// The panel's wet side is to the left of the piece; the section's is to the right.
    fn add_waterline(&mut self, plane: &Plane, [to, from]: [DVec3; 2]) {
        let foot = plane.normal * -plane.height;
        let (p, q) = (from - foot, to - foot);
        let double = plane.normal.dot(p.cross(q));
        self.area += double / 2.0;
        self.area_moment += (p + q) * (double / 6.0);
        self.area_second += (outer(p + q, p + q) + outer(p, p) + outer(q, q)) * (double / 24.0);
    }

    /// Panels of groups that are all below.
    fn add_whole(&mut self, plane: &Plane, whole: &[f64; COEFFICIENTS]) {
        let (n, d) = (plane.normal, plane.height);
        let contract = |first: usize| n.dot(DVec3::from_slice(&whole[first..first + 3]));
        let [xx, yy, zz, xy, xz, yz] = [0, 3, 6, 9, 12, 15].map(contract);
        let second = DMat3::from_cols_array(&[xx, xy, xz, xy, yy, yz, xz, yz, zz]);
        let first = DVec3::from_array([18, 21, 24].map(contract));
        let column = contract(27);
        let turned = second * n;
        self.volume += n.dot(first) + d * column;
        self.moment += turned + first * d;
        self.square += n.dot(turned) + 2.0 * d * n.dot(first) + d * d * column;
    }

    /// Everything about the origin, of which the middle is the place `middle`.
    fn about(&self, plane: &Plane, middle: DVec3) -> Immersion {
        let Self { volume, square, area, area_moment, .. } = *self;
        let foot = middle - plane.normal * plane.height;
        let moment = self.moment - plane.normal * (square / 2.0);
        Immersion {
            volume,
            moment: moment + middle * volume,
            depth_moment: -square / 2.0,
            area,
            area_moment: area_moment + foot * area,
            area_second: self.area_second
                + outer(area_moment, foot)
                + outer(foot, area_moment)
                + outer(foot, foot) * area,
        }
    }
}

impl Group {
    fn new(panels: [usize; 2], all: &[[DVec3; 3]]) -> Self {
        let own = &all[panels[0]..panels[1]];
        let (low, high) = bounds(own.iter().flatten().copied());
        let mut coefficients = [0.0; COEFFICIENTS];
        for &[a, b, c] in own {
            let area = (b - a).cross(c - a) / 2.0;
            let sum = a + b + c;
            // Mean of x xᵀ over a triangle: (Σ x xᵀ + Σx Σxᵀ)/12.
            let mean = (outer(a, a) + outer(b, b) + outer(c, c) + outer(sum, sum)) * (1.0 / 12.0);
            let pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|(i, j)| mean.col(i)[j]);
            let orders = pairs.into_iter().chain((sum / 3.0).to_array()).chain([1.0]);
            for (value, place) in orders.zip(coefficients.chunks_exact_mut(3)) {
                (0..3).for_each(|k| place[k] += value * area[k]);
            }
        }
        let (middle, half) = ((low + high) / 2.0, (high - low) / 2.0);
        Self { panels, middle, half, coefficients }
    }
}

fn bounds(points: impl Iterator<Item = DVec3>) -> (DVec3, DVec3) {
    let none = (DVec3::splat(f64::INFINITY), DVec3::splat(f64::NEG_INFINITY));
    points.fold(none, |(low, high), point| (low.min(point), high.max(point)))
}

/// Orders panels so that neighbours in space are neighbours in the list: halves across the longest side, and again.
/// `starts` gets the end of every group.
fn split(centres: &[DVec3], order: &mut [usize], starts: &mut Vec<usize>) {
    if order.is_empty() {
        return;
    }
    if order.len() <= GROUP {
        starts.push(starts[starts.len() - 1] + order.len());
        return;
    }
    let (low, high) = bounds(order.iter().map(|&index| centres[index]));
    let size = high - low;
    let axis = (0..3).max_by(|&a, &b| size[a].total_cmp(&size[b])).unwrap_or(0);
    let along = |a: &usize, b: &usize| -> Ordering {
        centres[*a][axis].total_cmp(&centres[*b][axis]).then_with(|| a.cmp(b))
    };
    // Groups are full but for the last.
    let half = (order.len() / 2).div_ceil(GROUP) * GROUP;
    order.select_nth_unstable_by(half, along);
    let (left, right) = order.split_at_mut(half);
    split(centres, left, starts);
    split(centres, right, starts);
}
