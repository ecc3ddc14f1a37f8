//! Loads that are lowered into water.

use std::sync::Arc;

use glam::DVec3;

use super::{BuildError, error, finite, positive};
use crate::force::submerged::{Cell, Submerged};
use crate::force::trains::Trains;
use crate::spec::CellSpec;

/// A load as its cells, in water with a density [kg/m³] up to a level [m] that streams [m/s].
pub(super) fn build_submerged(
    name: &str,
    body: usize,
    given: &[CellSpec],
    (density, level, stream): (f64, f64, [f64; 3]),
    sea: &Arc<Trains>,
    gravity: DVec3,
) -> Result<Submerged, BuildError> {
    positive(name, "the density of its water", density)?;
    finite(name, "the level of its water", &[level])?;
    finite(name, "the velocity of its water", &stream)?;
    if gravity.length() == 0.0 {
        return error(name, "there is no gravity, so water has no surface; give it gravity");
    }
    if given.is_empty() {
        return error(name, "it has no cells");
    }
    let mut cells = Vec::with_capacity(given.len());
    for cell in given {
        finite(name, "the place of a cell", &cell.at)?;
        positive(name, "the height of a cell", cell.height)?;
        let amounts = [&[cell.volume], &cell.added_mass[..], &cell.quadratic[..]].concat();
        if let Some(value) = amounts.iter().find(|value| !(**value >= 0.0 && value.is_finite())) {
            return error(
                name,
                format!("a volume, added mass or resistance is {value}; it must be zero or more"),
            );
        }
        cells.push(Cell {
            at: DVec3::from_array(cell.at),
            height: cell.height,
            volume: cell.volume,
            added: DVec3::from_array(cell.added_mass),
            drag: DVec3::from_array(cell.quadratic),
        });
    }
    Ok(Submerged {
        name: name.to_owned(),
        body,
        cells,
        density,
        up: -gravity.normalize(),
        weight: density * gravity.length(),
        level,
        stream: DVec3::from_array(stream),
        sea: Arc::clone(sea),
    })
}
