//! Loads that are lowered into water.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::{BuildError, error, finite, positive};
use crate::force::lattice::{LAYERS, Lattice};
use crate::force::submerged::Submerged;
use crate::force::trains::Trains;
use crate::spec::LatticeSpec;

/// A load as its lattices, in water with a density [kg/m³] up to a level [m] that streams [m/s].
pub(super) fn build_submerged(
    name: &str,
    body: usize,
    given: &[LatticeSpec],
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
    let mut lattices = Vec::with_capacity(given.len());
    for lattice in given {
        finite(name, "the place of its cells", &[&lattice.at[..], &lattice.half[..]].concat())?;
        positive(name, "the height of a layer", lattice.height)?;
        if !(1..=LAYERS).contains(&lattice.layers) {
            return error(name, format!("it has {} layers; from 1 to {LAYERS} are possible", lattice.layers));
        }
        let amounts = [&[lattice.volume], &lattice.added_mass[..], &lattice.quadratic[..]].concat();
        if let Some(value) = amounts.iter().find(|value| !(**value >= 0.0 && value.is_finite())) {
            return error(
                name,
                format!("a volume, added mass or resistance is {value}; it must be zero or more"),
            );
        }
        lattices.push(Lattice {
            at: DVec3::from_array(lattice.at),
            half: DVec2::from_array(lattice.half),
            height: lattice.height,
            layers: lattice.layers,
            volume: lattice.volume,
            added: DVec3::from_array(lattice.added_mass),
            drag: DVec3::from_array(lattice.quadratic),
        });
    }
    Ok(Submerged {
        name: name.to_owned(),
        body,
        lattices,
        density,
        up: -gravity.normalize(),
        weight: density * gravity.length(),
        level,
        stream: DVec3::from_array(stream),
        sea: Arc::clone(sea),
    })
}
