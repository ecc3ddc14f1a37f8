//! A stretch of rope of one tension: the whole rope, or what lies between two places that feed it.
//!
//! The unstretched length L changes where sheaves with losses or inertia, or drums, feed rope: L = L₀ + Σ r s over
//! their flows s. The row's value is
//!
//! ```text
//! g = (ℓ − L) √(L₀/L)        ∂g/∂ℓ = w        ∂g/∂L = −w (1 + ε/2)        w = √(L₀/L), ε = (ℓ − L)/L
//! ```
//!
//! With the constant compliance L₀/EA its energy g² EA/2L₀ is that of the rope, EA (ℓ − L)²/2L, so its forces are those
//! of the rope, whatever L does: along ℓ the tension T = w λ, λ the force of the row, and along L the tension and the
//! stretch that goes with the rope, T (1 + ε/2). Without feeds w = 1 and g = ℓ − L, but for a rope with a
//! [`Curve`], which has its own w.

use std::ops::Range;
use std::sync::Arc;

use crate::rope::curve::Curve;

/// A sheave that turns on once its rope has parted uses up what lies beside it. Such a span has the gradient and the w of
/// one of which this share of its length is left; they multiply no force.
const LEFT: f64 = 1e-6;

/// A degree of freedom that feeds rope into a span.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Feed {
    /// Degree of freedom, one of a flow.
    pub dof: usize,
    /// Its coordinate in q: of a flow, or of a drum's supply, the unstretched rope that it has let go.
    pub position: usize,
    /// Where its increments stand among those of the coordinates.
    pub increment: usize,
    /// Number of the coil on a drum that feeds; none of a sheave.
    pub coil: Option<usize>,
    /// Its entry in the gradients of the rope's rows.
    pub entry: usize,
    /// ∂L/∂s: 1 into the span, −1 out of it; of a drum's supply 1.
    pub rate: f64,
}

impl Feed {
    /// ∂L̇/∂v of its degree of freedom; `feeding` is that of all coils.
    pub fn speed_rate(&self, feeding: &[f64]) -> f64 {
        self.coil.map_or(self.rate, |coil| feeding[coil])
    }
}

/// A stretch of one tension.
#[derive(Debug, Clone)]
pub struct Span {
    /// Its straight parts.
    pub parts: Range<usize>,
    /// Arcs of half turns [m], half of those at its ends.
    pub arcs: f64,
    /// L₀ [m].
    pub length: f64,
    /// What feeds it.
    pub feeds: Vec<Feed>,
    /// Its tension by its strain, where that is no one line; nothing feeds it then, and it has one straight part.
    pub curve: Option<Arc<Curve>>,
}

/// How the row of a span answers.
#[derive(Debug, Clone, Copy)]
pub struct Stretch {
    /// L [m].
    pub unstretched: f64,
    /// g [m].
    pub value: f64,
    /// w = ∂g/∂ℓ.
    pub scale: f64,
    /// ∂g/∂L.
    pub supply: f64,
}

impl Span {
    /// L at the configuration `q` [m].
    pub fn unstretched(&self, q: &[f64]) -> f64 {
        self.length + self.feeds.iter().map(|feed| feed.rate * q[feed.position]).sum::<f64>()
    }

    /// The row at the configuration `q`, where the span is `length` [m] long. It has no value where nothing is left of it.
    #[inline]
    pub fn stretch(&self, q: &[f64], length: f64) -> Stretch {
        if self.feeds.is_empty() {
            let unstretched = self.length;
            if let Some(curve) = &self.curve {
                let bent = curve.at(length / unstretched - 1.0);
                let (value, scale) = (unstretched * bent.value, bent.scale);
                return Stretch { unstretched, value, scale, supply: -scale };
            }
            return Stretch { unstretched, value: length - unstretched, scale: 1.0, supply: -1.0 };
        }
        let unstretched = self.unstretched(q);
        let left = unstretched.max(LEFT * self.length);
        let scale = (self.length / left).sqrt();
        let excess = length - unstretched;
        let supply = -scale * (1.0 + 0.5 * excess / left);
        let value = if unstretched > 0.0 { excess * scale } else { f64::NAN };
        Stretch { unstretched, value, scale, supply }
    }

    /// Value and rate of the row from the length of a fed span and the rate of that, with w, −∂g/∂L and L known.
    #[inline]
    pub fn answer(
        &self,
        [scale, supply, unstretched]: [f64; 3],
        [length, rate]: [f64; 2],
        v: &[f64],
    ) -> [f64; 2] {
        [(length - unstretched) * scale, scale * rate - supply * self.speed(v)]
    }

    /// True where the row's force is not the tension.
    pub fn is_scaled(&self) -> bool {
        !self.feeds.is_empty() || self.curve.is_some()
    }

    /// w at the configuration `q` but for that of a curve: tension over the force of the row.
    pub fn scale(&self, q: &[f64]) -> f64 {
        if self.feeds.is_empty() {
            return 1.0;
        }
        (self.length / self.unstretched(q).max(LEFT * self.length)).sqrt()
    }

    /// What changes of the row's force λ and of L do to the tension w λ: w (dλ − λ dL/2L).
    pub fn tension_change(&self, q: &[f64], force: f64, change: f64, supply: f64) -> f64 {
        if let Some(curve) = &self.curve {
            return curve.under(force).growth * change;
        }
        self.scale(q) * (change - 0.5 * force * supply / self.unstretched(q))
    }

    /// What a change of the row's force by velocities alone does to the tension: w dλ.
    pub fn tension_rate(&self, q: &[f64], force: f64, change: f64) -> f64 {
        self.curve.as_ref().map_or_else(|| self.scale(q), |curve| curve.under(force).scale) * change
    }

    /// True where nearly nothing is left of it beside its arcs: 1 % and less.
    pub fn is_used_up(&self, q: &[f64]) -> bool {
        self.unstretched(q) - self.arcs <= 0.01 * self.length
    }

    /// True where nothing is left beside its arcs.
    pub fn has_run_out(&self, q: &[f64]) -> bool {
        !self.feeds.is_empty() && self.unstretched(q) <= self.arcs
    }

    /// L̇ under the velocities `v` [m/s], but for what drums feed.
    #[inline]
    pub fn speed(&self, v: &[f64]) -> f64 {
        self.feeds.iter().filter(|feed| feed.coil.is_none()).map(|feed| feed.rate * v[feed.dof]).sum()
    }

    /// What increments of the coordinates do to L.
    pub fn supply_of(&self, increments: &[f64]) -> f64 {
        self.feeds.iter().map(|feed| feed.rate * increments[feed.increment]).sum()
    }
}
