//! What the skin below the plane is: wetted area, the pressure on it by direct integration, and how far it is closed.
//!
//! Pressure acts on what there is of the skin. Around a closed hull its horizontal parts cancel; what is left of them
//! says what holes below the plane do.

use glam::DVec3;

use super::mesh::Mesh;
use super::panel::{Panel, Plane};

/// The skin below a plane.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Surface {
    /// Wetted area [m²].
    pub wetted_area: f64,
    /// ∫ h N dS: the force of the pressure over ρg [m³].
    pub thrust: DVec3,
    /// ∫ x × h N dS: its moment about the origin over ρg [m⁴].
    pub thrust_moment: DVec3,
    /// How far the waterline is from closing: sum of its pieces as vectors [m].
    pub waterline_gap: DVec3,
    /// Length of the waterline [m].
    pub waterline_length: f64,
    /// Lowest and highest place of the waterline along each axis [m]; low above high where there is none.
    pub waterline_low: DVec3,
    /// See `waterline_low`.
    pub waterline_high: DVec3,
}

impl Surface {
    /// The skin of `mesh` below `plane`.
    pub fn of(mesh: &Mesh, plane: &Plane) -> Self {
        let mut surface = Self {
            waterline_low: DVec3::splat(f64::INFINITY),
            waterline_high: DVec3::splat(f64::NEG_INFINITY),
            ..Self::default()
        };
        for index in 0..mesh.triangles.len() {
            let corners = mesh.corners(index);
            let [a, b, c] = corners;
            let heights = corners.map(|corner| plane.above(corner));
            let below = Panel { corners, heights, area: (b - a).cross(c - a) / 2.0 }.below();
            for part in &below.parts[..below.count] {
                surface.add(part);
            }
            if let Some([from, to]) = below.waterline {
                surface.waterline_gap += to - from;
                surface.waterline_length += (to - from).length();
                surface.waterline_low = surface.waterline_low.min(from).min(to);
                surface.waterline_high = surface.waterline_high.max(from).max(to);
            }
        }
        surface
    }

    fn add(&mut self, panel: &Panel) {
        let sum: f64 = panel.heights.iter().sum();
        let weighted: DVec3 =
            panel.corners.iter().zip(panel.heights).map(|(corner, height)| *corner * (sum + height)).sum();
        self.wetted_area += panel.area.length();
        self.thrust += panel.area * (sum / 3.0);
        self.thrust_moment += weighted.cross(panel.area) / 12.0;
    }
}
