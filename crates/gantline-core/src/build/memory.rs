//! What water remembers of the motion of bodies.

use glam::DVec3;

use super::forces::check_matrix;
use super::{BuildError, error, finite};
use crate::force::memory::{Memory, Term};
use crate::force::square::Square;
use crate::spec::TermSpec;

/// At so many frequencies K has to be passive, between a tenth of that of its slowest and ten times that of its fastest term.
const FREQUENCIES: u32 = 64;

/// K of a body about a point of it [m]; where its states are is not known yet.
pub(super) fn build_memory(
    name: &str,
    body: usize,
    at: [f64; 3],
    terms: &[TermSpec],
) -> Result<Memory, BuildError> {
    finite(name, "its point", &at)?;
    let mut built = Vec::with_capacity(terms.len());
    for term in terms {
        finite(name, "a pole of its", &term.pole)?;
        if term.pole[0] >= 0.0 {
            return error(name, format!("a term of its does not decay: {} per second", term.pole[0]));
        }
        for rows in [&term.real, &term.imaginary] {
            finite(name, "a residue of its", rows.as_flattened())?;
        }
        let residue = [&term.real, &term.imaginary].map(Square::from_rows);
        built.push(Term { pole: term.pole, residue });
    }
    let memory =
        Memory { name: name.to_owned(), body, at: DVec3::from_array(at), terms: built, first: 0, slow: None };
    let speeds = memory.terms.iter().map(|term| term.pole[0].hypot(term.pole[1]));
    let [slowest, fastest] =
        speeds.fold([f64::INFINITY, 0.0], |[least, most], speed| [speed.min(least), speed.max(most)]);
    for step in 0..if memory.terms.is_empty() { 0 } else { FREQUENCIES } {
        let share = f64::from(step) / f64::from(FREQUENCIES - 1);
        let omega = 0.1 * slowest * (100.0 * fastest / slowest).powf(share);
        let [damping, _] = memory.at_frequency(omega);
        check_matrix(name, &format!("its damping at {omega:.3} rad/s"), &damping.rows())?;
    }
    Ok(memory)
}
