//! What a rope answers to stretch.

/// Material of one rope of given unstretched length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// ε = L/(EA) [m/N]; zero for an inextensible rope.
    pub compliance: f64,
    /// Stiffness-proportional damping time τ [s].
    pub damping_time: f64,
}

impl Material {
    /// T = max(0, k (e + τ ė)), k = EA/L.
    pub fn elastic(axial_stiffness: f64, length: f64, damping_time: f64) -> Self {
        Self { compliance: length / axial_stiffness, damping_time }
    }

    /// e ≤ 0, T ≥ 0, e T = 0.
    pub const INEXTENSIBLE: Self = Self { compliance: 0.0, damping_time: 0.0 };
}
