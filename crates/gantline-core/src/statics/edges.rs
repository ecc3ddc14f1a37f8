//! Ropes that are just taut and contacts that just touch, bearing nothing, where a lift would be unstable without them.
//!
//! Of two guys of a plumb mast neither pulls, and yet the mast stands: whichever way it leans, one of them does. With the
//! rows of force 0 = e/ε and the gradient G, the energy of a small motion d is
//!
//! ```text
//! ½ dᵀ K d + ½ Σ max(0, G d)²/ε
//! ```
//!
//! Of the motions that lead away without such rows, all ways to go along them together are looked at, and of what leads
//! away beside the rows that one brings in, all ways again: of three guys about a mast on a ball one holds it along itself
//! and the two others to its sides. Where the rows of every way hold every motion nothing leads away, and it is about those
//! of the first that the lift swings.

use super::bearing::{Part, weight};
use super::{NEUTRAL, Statics};
use crate::solver::symbolic::ZeroPivot;
use crate::state::State;
use crate::system::System;

/// What is slack or open by less is on the edge of bearing: the sign of so small a gap is rounding [m or rad].
const EDGE: f64 = 1e-9;
/// And where it bears it bears no more than this share of the weight of everything.
const LIGHT: f64 = 1e-10;
/// So many motions that lead away are looked at, which may go together in 2ⁿ ways.
const MOST: usize = 3;
/// Each next of them goes that much less far, so that what lies across one of two motions is not on the edge again.
const LESS: f64 = 0.6;
/// What a row stretches by less than this share of what its parts do lies across it, but for rounding.
const ACROSS: f64 = 1e-9;
/// How often what leads away beside the rows that a way has brought in may bring in further ones.
const DEEP: usize = 3;

/// Which rows follow, and how many motions lead away and how many nothing holds then.
type Held = (Vec<bool>, (usize, usize));

impl Statics {
    /// How many motions lead away and how many nothing holds, in place of what was `counted` with rows on the edge as
    /// rounding has them: once these bear where motions that lead away without them bring them in. What holds the lift
    /// then takes part from now on; where a way leads away for good none of them does.
    ///
    /// # Errors
    /// As [`Statics::inertia`].
    pub(super) fn held_on_edges(
        &mut self,
        system: &System,
        state: &State,
        counted: (usize, usize),
    ) -> Result<(usize, usize), ZeroPivot> {
        let (here, light) = (&self.search.here, LIGHT * weight(system));
        let is_on_edge = |row: &usize| {
            self.bearings[*row].part == Part::Pull
                && here.tension[*row] <= light
                && here.frame.value[*row].abs() <= EDGE
        };
        let edges: Vec<usize> = (0..self.bearings.len()).filter(is_on_edge).collect();
        if edges.is_empty() {
            return Ok(counted);
        }
        let found = here.follows.clone();
        let mut without = found.clone();
        edges.iter().for_each(|&row| without[row] = false);
        self.search.here.follows.clone_from(&without);
        // Those that follow by rounding alone hold to one side.
        let bare = if without == found { counted } else { self.inertia(system, state)? };
        if bare.0 == 0 {
            self.search.here.follows = found;
            return Ok(counted);
        }
        let held = self.held_all_ways(system, state, &edges, bare, DEEP)?;
        let (follows, held) = held.unwrap_or((without, bare));
        self.search.here.follows = follows;
        Ok(held)
    }

    /// What holds the lift where the rows that follow leave motions that lead away, `counted` says how many; none where
    /// they are too many, or one of the ways along them leads away for good.
    fn held_all_ways(
        &mut self,
        system: &System,
        state: &State,
        edges: &[usize],
        counted: (usize, usize),
        deep: usize,
    ) -> Result<Option<Held>, ZeroPivot> {
        let before = self.search.here.follows.clone();
        if counted.0 == 0 {
            return Ok(Some((before, counted)));
        }
        if deep == 0 || counted.0 > MOST {
            return Ok(None);
        }
        let away = self.modes(system, state, Some(counted.0));
        if away.iter().any(|mode| mode.square >= -NEUTRAL) {
            return Ok(None);
        }
        let mut first = None;
        for way in 0..1_usize << away.len() {
            let mut along = vec![0.0; system.tree.velocities];
            for (place, mode) in away.iter().enumerate() {
                let share = LESS.powi(place as i32) * if way >> place & 1 == 0 { 1.0 } else { -1.0 };
                along.iter_mut().zip(&mode.shape).for_each(|(sum, entry)| *sum += share * entry);
            }
            let here = &mut self.search.here;
            here.follows.clone_from(&before);
            for &row in edges {
                let entries = system.rows.entries(&here.frame.gradient, row);
                let shares = entries.map(|(dof, entry)| entry * along[dof]);
                let (rate, whole) =
                    shares.fold((0.0, 0.0), |(sum, whole), one: f64| (sum + one, whole + one.abs()));
                here.follows[row] |= rate > ACROSS * whole;
            }
            if here.follows == before {
                return Ok(None);
            }
            let left = self.inertia(system, state)?;
            let Some(held) = self.held_all_ways(system, state, edges, left, deep - 1)? else {
                return Ok(None);
            };
            first.get_or_insert(held);
        }
        Ok(first)
    }
}
