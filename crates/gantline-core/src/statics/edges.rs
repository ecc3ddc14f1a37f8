//! Ropes that are just taut and contacts that just touch, bearing nothing, where a lift would be unstable without them.
//!
//! Of two guys of a plumb mast neither pulls, and yet the mast stands: whichever way it leans, one of them does. With the
//! rows of force 0 = e/ε and the gradient G, the energy of a small motion d is
//!
//! ```text
//! ½ dᵀ K d + ½ Σ max(0, G d)²/ε
//! ```
//!
//! Of the motions that lead away without such rows, all ways to go along them together are looked at; where the rows that
//! each brings in hold every motion, nothing leads away, and the rows of the first are those about which it swings.

use super::bearing::Part;
use super::{NEUTRAL, Statics};
use crate::solver::symbolic::ZeroPivot;
use crate::state::State;
use crate::system::System;

/// What is slack or open by less is on the edge of bearing: the sign of so small a gap is rounding [m or rad].
const EDGE: f64 = 1e-9;
/// So many motions that lead away are looked at, which may go together in 2ⁿ ways.
const MOST: usize = 3;
/// Each next of them goes that much less far, so that what lies across one of two motions is not on the edge again.
const LESS: f64 = 0.6;

/// What a row stretches by less than this share of what its parts do lies across it, but for rounding.
const ACROSS: f64 = 1e-9;

impl Statics {
    /// How many motions lead away and how many nothing holds, once rows on the edge bear where those that lead away, so
    /// many as `counted` says first, bring them in. Where they hold the lift they take part from now on.
    ///
    /// # Errors
    /// As [`Statics::inertia`].
    pub(super) fn held_on_edges(
        &mut self,
        system: &System,
        state: &State,
        counted: (usize, usize),
    ) -> Result<(usize, usize), ZeroPivot> {
        let here = &self.search.here;
        let is_on_edge = |row: &usize| {
            self.bearings[*row].part == Part::Pull
                && !here.follows[*row]
                && here.frame.value[*row].abs() <= EDGE
        };
        let edges: Vec<usize> = (0..self.bearings.len()).filter(is_on_edge).collect();
        if edges.is_empty() || !(1..=MOST).contains(&counted.0) {
            return Ok(counted);
        }
        let away: Vec<_> = self.modes(system, state, Some(counted.0));
        if away.iter().any(|mode| mode.square >= -NEUTRAL) {
            return Ok(counted);
        }
        let without = self.search.here.follows.clone();
        let mut first = None;
        for way in 0..1_usize << away.len() {
            let mut along = vec![0.0; system.tree.velocities];
            for (place, mode) in away.iter().enumerate() {
                let share = LESS.powi(place as i32) * if way >> place & 1 == 0 { 1.0 } else { -1.0 };
                along.iter_mut().zip(&mode.shape).for_each(|(sum, entry)| *sum += share * entry);
            }
            let here = &mut self.search.here;
            here.follows.clone_from(&without);
            for &row in &edges {
                let shares =
                    || system.rows.entries(&here.frame.gradient, row).map(|(dof, entry)| entry * along[dof]);
                let (rate, whole) = (shares().sum::<f64>(), shares().map(f64::abs).sum::<f64>());
                here.follows[row] = rate > ACROSS * whole;
            }
            let held = self.inertia(system, state)?;
            if held.0 > 0 {
                self.search.here.follows = without;
                return Ok(counted);
            }
            first.get_or_insert((self.search.here.follows.clone(), held));
        }
        Ok(first.map_or(counted, |(follows, held)| {
            self.search.here.follows = follows;
            held
        }))
    }
}
