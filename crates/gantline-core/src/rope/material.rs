//! What a rope answers to stretch.

/// Material of a rope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// EA [N]; infinite for an inextensible rope.
    pub axial_stiffness: f64,
    /// Stiffness-proportional damping time τ [s].
    pub damping_time: f64,
}

impl Material {
    /// T = max(0, k (e + τ ė)), k = EA/L.
    pub fn elastic(axial_stiffness: f64, damping_time: f64) -> Self {
        Self { axial_stiffness, damping_time }
    }

    /// e ≤ 0, T ≥ 0, e T = 0.
    pub const INEXTENSIBLE: Self = Self { axial_stiffness: f64::INFINITY, damping_time: 0.0 };

    /// ε = L/(EA) of a length [m/N].
    pub fn compliance(&self, length: f64) -> f64 {
        length / self.axial_stiffness
    }

    /// True where there is no stretch at all.
    pub fn is_inextensible(&self) -> bool {
        self.axial_stiffness == f64::INFINITY
    }
}
