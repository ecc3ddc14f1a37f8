//! Ends of ropes on drums.

use super::{BuildError, at_least_zero, error, positive};
use crate::constraint::AnyConstraint;
use crate::rope::coil::{Layers, MOST_LAYERS};
use crate::spec::{DrumSpec, GuideSpec, LayersSpec, SystemSpec};
use crate::system::{CoilPlace, Rows};
use crate::tree::Tree;

/// Whether what is said of a drum can be.
pub(super) fn check_drum(name: &str, drum: &DrumSpec) -> Result<(), BuildError> {
    at_least_zero(name, "the tension of the rope on its drum", drum.laid_under.unwrap_or(0.0))?;
    drum.layers.as_ref().map_or(Ok(()), |given| build_layers(name, given).map(|_| ()))
}

/// Layers on a drum, of which an element speaks.
pub(super) fn build_layers(name: &str, given: &LayersSpec) -> Result<Layers, BuildError> {
    let LayersSpec { radius, step, turns, start } = *given;
    positive(name, "the radius of its drum", radius)?;
    at_least_zero(name, "the step of the radius of its drum", step)?;
    at_least_zero(name, "the number of turns on its drum", start)?;
    if !(turns.is_finite() && turns >= 1.0) {
        return error(name, format!("a layer on its drum has {turns} turns; it must have one or more"));
    }
    if start > MOST_LAYERS as f64 * turns {
        let most = format!("{MOST_LAYERS} layers of {turns} turns are the most");
        return error(name, format!("its drum has {start} turns at the start; {most}"));
    }
    Ok(layers(given))
}

/// The ends of ropes on drums, in the order of ropes and routes: that of the numbers that the feeds have.
pub(super) fn places_of_coils(
    spec: &SystemSpec,
    tree: &Tree,
    constraints: &[AnyConstraint],
    rows: &Rows,
) -> Vec<CoilPlace> {
    let guides = spec.ropes.iter().flat_map(|rope| &rope.route);
    let drums = guides.filter_map(|guide| match guide {
        GuideSpec::End { drum, .. } => drum.as_ref(),
        _ => None,
    });
    let drums: Vec<&DrumSpec> = drums.collect();
    let mut places = Vec::with_capacity(drums.len());
    for (index, constraint) in constraints.iter().enumerate() {
        let AnyConstraint::Rope(rope) = constraint else { continue };
        for (number, span) in rope.spans.iter().enumerate() {
            for (feed, coil) in span.feeds.iter().filter_map(|feed| Some((feed, feed.coil?))) {
                let drum = drums[coil];
                places.push(CoilPlace {
                    rope: index,
                    span: number,
                    row: rows.first[index] + number,
                    dof: feed.dof,
                    position: tree.bodies[tree.owner[feed.dof]].first_position,
                    supply: feed.position,
                    entry: rows.start[rows.first[index]] + feed.entry,
                    rate: drum.rate,
                    stiffness: rope.material.axial_stiffness,
                    laid_under: drum.laid_under,
                    layers: drum.layers.as_ref().map(layers),
                });
            }
        }
    }
    places
}

fn layers(given: &LayersSpec) -> Layers {
    let LayersSpec { radius, step, turns, start } = *given;
    Layers { radius, growth: step / radius, turns, start }
}
