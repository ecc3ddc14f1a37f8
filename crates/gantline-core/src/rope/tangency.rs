//! The straight part between two sheaves in space, or a sheave and a point.
//!
//! A sheave is a circle: centre c, unit axis a, radius r; the rope runs about +a. With u the unit vector from the
//! centre to where the rope leaves or arrives and t = a × u its direction in the groove there, the part from
//! p₁ = c₁ + r₁ u₁ to p₂ = c₂ + r₂ u₂ has no radial component on either:
//!
//! ```text
//! u₁·D = 0    u₂·D = 0    D = p₂ − p₁ = ℓ d    d·t₁ > 0    d·t₂ > 0
//! ```
//!
//! Seen from one sheave the other end is a point, and the condition has a closed form in the sheave's plane; both
//! together are found by going back and forth and then by Newton's method. A point is a sheave of radius zero.
//!
//! **Gradient.** The rope on the sheaves counts too: leaving later by δθ₁ adds r₁ δθ₁ of arc, arriving later by
//! δθ₂ takes r₂ δθ₂. With Δ = δp₂ − δp₁ the motion of the points as if fixed in their bodies and ω the bodies'
//! rotations,
//!
//! ```text
//! δ(ℓ + arcs) = d·Δ + λ₁ δθ₁ + λ₂ δθ₂          λ₁ = r₁ (1 − d·t₁)    λ₂ = −r₂ (1 − d·t₂)
//! 0 = uₖ·Δ + ωₖ·(uₖ × D) + Σ Aₖⱼ δθⱼ           A = [ℓ d·t₁, r₂ u₁·t₂; −r₁ u₂·t₁, ℓ d·t₂]
//! ```
//!
//! In a plane d = t and λ = 0: the points may be taken as fixed. With a fleet angle d·t = cos φ < 1, and with
//! Aᵀ μ = λ
//!
//! ```text
//! δ(ℓ + arcs) = e·Δ − μ₁ ω₁·(u₁ × D) − μ₂ ω₂·(u₂ × D)          e = d − μ₁ u₁ − μ₂ u₂
//! ```
//!
//! which is the exact derivative: a force along e at the points and a couple on each sheave.

use std::f64::consts::TAU;

use glam::DVec3;
use thiserror::Error;

/// A sheave in space; a point where the radius is zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// Centre [m].
    pub centre: DVec3,
    /// Unit axis; the rope runs about it.
    pub axis: DVec3,
    /// Radius [m].
    pub radius: f64,
}

/// A straight part that touches both of its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tangent {
    /// Where it starts [m].
    pub from: DVec3,
    /// Where it ends [m].
    pub to: DVec3,
    /// Unit vectors from the centres to these points; zero for a point.
    pub radial: [DVec3; 2],
    /// Length [m].
    pub length: f64,
    /// Unit direction d.
    pub direction: DVec3,
    /// e: how the length answers to relative motion of the end points.
    pub pull: DVec3,
    /// How the length answers to rotation of the start's and the end's body about the end points [m].
    pub couple: [DVec3; 2],
}

/// Why two sheaves have no common tangent of the asked kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum NoTangent {
    /// Seen along its axis, the start's circle holds the other end: the rope could not leave it.
    #[error("the sheave where it starts holds the other end within its circle, seen along the axis")]
    InsideStart,
    /// The same for the end's circle.
    #[error("the sheave where it ends holds the other end within its circle, seen along the axis")]
    InsideEnd,
    /// The axis of the start's sheave runs through the other end.
    #[error("the axis of the sheave where it starts points at the other end; a rope runs across the axis")]
    AlongStart,
    /// The axis of the end's sheave runs through the other end.
    #[error("the axis of the sheave where it ends points at the other end; a rope runs across the axis")]
    AlongEnd,
    /// The circles touch or overlap, seen along the axis, and the rope would have to cross between them.
    #[error("its two sheaves touch or overlap, seen along the axis, and it would have to pass between them")]
    Overlapping,
    /// Start and end coincide.
    #[error("its ends coincide")]
    Coincident,
    /// The conditions of tangency are not met to rounding: the circles are all but in each other's way.
    #[error("it only grazes a sheave: there is no tangent that rounding would leave")]
    Grazing,
    /// A position is not a number.
    #[error("the position of an end is not a number")]
    NotFinite,
}

/// Rounds of going back and forth before Newton's method.
const ROUNDS: usize = 6;
/// Newton steps at the most; three are usual.
const STEPS: usize = 20;
/// Tangency residual u·d that is good enough: a few roundings.
const TOLERANCE: f64 = 1e-15;
/// Where a circle is looked at all around, and halvings between two of these places.
const ANGLES: u32 = 256;
const HALVINGS: usize = 30;
/// Residual u·D of a tangent that is returned, over the size of the part and its circles.
const CLOSE: f64 = 1e-12;
/// Cosine of the angle between axes that are about parallel.
const PARALLEL: f64 = 0.9;
/// Share of the distance of coordinates from the origin that counts as size: their rounding over [`CLOSE`].
const FAR: f64 = 1e-3;

impl Circle {
    /// A point [m].
    pub fn point(at: DVec3) -> Self {
        Self { centre: at, axis: DVec3::Z, radius: 0.0 }
    }

    /// Unit vector to where a rope to the point `other` leaves (`sense` +1), or from it arrives (−1); none where
    /// the circle holds the point, seen along the axis.
    ///
    /// In the plane of the sheave, with w the way to the point, u·w = r and (a×u)·w has the sign of `sense`.
    fn touch(&self, other: DVec3, sense: f64) -> Option<DVec3> {
        if self.radius == 0.0 {
            return Some(DVec3::ZERO);
        }
        let way = other - self.centre;
        let flat = way - self.axis * self.axis.dot(way);
        let square = flat.length_squared();
        let along = square - self.radius * self.radius;
        if along <= 0.0 {
            return None;
        }
        let across = self.axis.cross(flat);
        Some((flat * self.radius - across * (sense * along.sqrt())) / square)
    }

    /// The same as a rope passes it that runs the other way.
    fn reversed(&self) -> Self {
        Self { axis: -self.axis, ..*self }
    }

    fn at(&self, radial: DVec3) -> DVec3 {
        self.centre + radial * self.radius
    }
}

/// The straight part of a rope that leaves `start` and arrives at `end`.
///
/// # Errors
/// [`NoTangent`] names what is in the way.
pub fn common_tangent(start: &Circle, end: &Circle) -> Result<Tangent, NoTangent> {
    let found = match tangent_from(start, end, end.centre) {
        Ok(tangent) => return Ok(tangent),
        Err(found) => found,
    };
    // The start's circle may hold the end's centre, seen along its axis, and not where the rope touches the end.
    if let Some(radial) = end.touch(start.centre, -1.0)
        && let Ok(tangent) = tangent_from(start, end, end.at(radial))
    {
        return Ok(tangent);
    }
    if start.radius > 0.0 && end.radius > 0.0 && start.axis.dot(end.axis).abs() > PARALLEL {
        // Circles that overlap may hold each other's centres and still have a tangent on the outside. Only where
        // axes are about parallel is it the only one.
        let across = end.axis.any_orthonormal_vector();
        let along = end.axis.cross(across);
        let guesses = [across, along, -across, -along].map(|radial| end.at(radial));
        if let Some(tangent) = guesses.into_iter().find_map(|guess| tangent_from(start, end, guess).ok()) {
            return Ok(tangent);
        }
    }
    let refused = refusal(start, end, found);
    if may_be_missed(start, end, refused) {
        // The same rope the other way round begins at the end: where the one circle all but holds what is looked at
        // from the other, all of that is seen from there.
        let behind = || look_around(&end.reversed(), &start.reversed()).map(|[last, first]| [first, last]);
        if let Some(radial) = look_around(start, end).or_else(behind) {
            return finish(start, end, radial);
        }
    }
    Err(refused)
}

/// Whether two circles that are refused so may have a tangent all the same, to which going back and forth does not lead:
/// that passes places where the one circle holds the other's, seen along the axis, and it may end with another tangent.
/// Circles that are in each other's way may have several, of which none is the right one.
fn may_be_missed(start: &Circle, end: &Circle, refused: NoTangent) -> bool {
    let are_clear = (end.centre - start.centre).length() > start.radius + end.radius;
    match refused {
        NoTangent::Grazing => true,
        NoTangent::InsideStart | NoTangent::InsideEnd | NoTangent::Overlapping => {
            are_clear && start.radius.min(end.radius) > 0.0
        }
        _ => false,
    }
}

/// Radial vectors of the tangent of two circles, where going back and forth ended with another one, or none: hardly
/// any angle to the axis of a sheave, seen from the other. Looks all around the start's circle for where the condition
/// there changes sign, with the end's fulfilled.
fn look_around(start: &Circle, end: &Circle) -> Option<[DVec3; 2]> {
    let across = start.axis.any_orthonormal_vector();
    let along = start.axis.cross(across);
    let at = |angle: f64| {
        let leaving = across * angle.cos() + along * angle.sin();
        let arriving = end.touch(start.at(leaving), -1.0)?;
        let leans = leaving.dot(end.at(arriving) - start.at(leaving));
        Some(([leaving, arriving], leans))
    };
    (0..ANGLES).find_map(|index| {
        let [mut low, mut high] = [index, index + 1].map(|index| f64::from(index) * TAU / f64::from(ANGLES));
        let sign = at(low)?.1;
        if sign * at(high)?.1 > 0.0 {
            return None;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if at(middle)?.1 * sign > 0.0 { low = middle } else { high = middle }
        }
        let mut radial = at(low)?.0;
        polish(start, end, &mut radial);
        finish(start, end, radial).ok().map(|_| radial)
    })
}

/// The tangent that is found from a guess of where the part ends.
fn tangent_from(start: &Circle, end: &Circle, guess: DVec3) -> Result<Tangent, NoTangent> {
    let mut radial = [DVec3::ZERO; 2];
    let mut to = guess;
    for _ in 0..ROUNDS {
        radial[0] = start.touch(to, 1.0).ok_or(NoTangent::InsideStart)?;
        let from = start.at(radial[0]);
        radial[1] = end.touch(from, -1.0).ok_or(NoTangent::InsideEnd)?;
        to = end.at(radial[1]);
    }
    if start.radius > 0.0 && end.radius > 0.0 {
        polish(start, end, &mut radial);
    }
    finish(start, end, radial)
}

/// Says what is in the way where `found` was what the search ended with.
fn refusal(start: &Circle, end: &Circle, found: NoTangent) -> NoTangent {
    let way = end.centre - start.centre;
    let size = start.centre.length() + end.centre.length();
    if !(way.is_finite() && start.axis.is_finite() && end.axis.is_finite()) {
        return NoTangent::NotFinite;
    }
    if way.length() <= f64::EPSILON * size {
        return NoTangent::Coincident;
    }
    let (first, last) = ((start, end, NoTangent::AlongStart), (end, start, NoTangent::AlongEnd));
    let sides = match found {
        NoTangent::InsideStart => vec![first],
        NoTangent::InsideEnd => vec![last],
        // Circles that touch leave no length between them, or hardly any; those that are in each other's way only a
        // part that would leave backwards.
        NoTangent::Coincident | NoTangent::Grazing => vec![first, last],
        _ => return found,
    };
    for (circle, other, along) in sides.into_iter().filter(|(circle, ..)| circle.radius > 0.0) {
        let flat = (way - circle.axis * circle.axis.dot(way)).length();
        if flat <= CLOSE * way.length() {
            return along;
        }
        if other.radius > 0.0
            && flat <= (circle.radius + other.radius) * (1.0 + CLOSE)
            && flat > (circle.radius - other.radius).abs()
        {
            return NoTangent::Overlapping;
        }
    }
    found
}

/// Newton's method on the two tangency conditions, over rotations of the radial vectors about their axes.
fn polish(start: &Circle, end: &Circle, radial: &mut [DVec3; 2]) {
    for _ in 0..STEPS {
        let span = end.at(radial[1]) - start.at(radial[0]);
        let residual = [radial[0].dot(span), radial[1].dot(span)];
        let length = span.length();
        if residual.iter().all(|value| value.abs() <= TOLERANCE * length) {
            return;
        }
        let matrix = turning(start, end, radial, span);
        let Some(angles) = solve(matrix, residual.map(|value| -value)) else { return };
        for ((radial, circle), angle) in radial.iter_mut().zip([start, end]).zip(angles) {
            let (sin, cos) = angle.clamp(-0.5, 0.5).sin_cos();
            let turned = *radial * cos + circle.axis.cross(*radial) * sin;
            *radial = (turned - circle.axis * circle.axis.dot(turned)).normalize();
        }
    }
}

/// A: change of the tangency conditions when the rope leaves or arrives later.
fn turning(start: &Circle, end: &Circle, radial: &[DVec3; 2], span: DVec3) -> [[f64; 2]; 2] {
    let along = [start.axis.cross(radial[0]), end.axis.cross(radial[1])];
    [
        [span.dot(along[0]), end.radius * radial[0].dot(along[1])],
        [-start.radius * radial[1].dot(along[0]), span.dot(along[1])],
    ]
}

fn solve([[a, b], [c, d]]: [[f64; 2]; 2], [x, y]: [f64; 2]) -> Option<[f64; 2]> {
    let determinant = a * d - b * c;
    (determinant != 0.0).then(|| [(d * x - b * y) / determinant, (a * y - c * x) / determinant])
}

fn finish(start: &Circle, end: &Circle, radial: [DVec3; 2]) -> Result<Tangent, NoTangent> {
    let (from, to) = (start.at(radial[0]), end.at(radial[1]));
    let span = to - from;
    let length = span.length();
    if !length.is_finite() {
        return Err(NoTangent::NotFinite);
    }
    if length <= f64::EPSILON * (from.length() + to.length()) {
        return Err(NoTangent::Coincident);
    }
    let direction = span / length;
    let size = length + start.radius + end.radius + FAR * (start.centre.length() + end.centre.length());
    for (circle, radial) in [(start, radial[0]), (end, radial[1])] {
        let leans = radial.dot(span).abs() > CLOSE * size;
        if circle.radius > 0.0 && (leans || direction.dot(circle.axis.cross(radial)) <= 0.0) {
            return Err(NoTangent::Grazing);
        }
    }
    let mut pull = direction;
    let mut couple = [DVec3::ZERO; 2];
    let mut matrix = turning(start, end, &radial, span);
    let mut load = [0.0; 2];
    for (k, (circle, sign)) in [(start, 1.0), (end, -1.0)].into_iter().enumerate() {
        if circle.radius == 0.0 {
            // A point has no angle: a row and a column that say δθ = 0.
            matrix[k] = [0.0; 2];
            matrix[1 - k][k] = 0.0;
            matrix[k][k] = 1.0;
        } else {
            load[k] = sign * circle.radius * (1.0 - direction.dot(circle.axis.cross(radial[k])));
        }
    }
    let [[a, b], [c, d]] = matrix;
    let weights = solve([[a, c], [b, d]], load).unwrap_or([0.0; 2]);
    for k in 0..2 {
        pull -= radial[k] * weights[k];
        couple[k] = -radial[k].cross(span) * weights[k];
    }
    Ok(Tangent { from, to, radial, length, direction, pull, couple })
}
