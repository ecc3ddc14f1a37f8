//! Columns by the names that others know them by, with their shapes.

use super::Samples;
use super::columns::Columns;
use super::names::Names;

/// Name, values in row-major order, shape.
pub type Named = (&'static str, Vec<f64>, Vec<usize>);

/// All columns of `samples` of a run with `events` at these times [s].
pub fn named(samples: &Samples, columns: Columns, names: &Names, events: Vec<f64>) -> Vec<Named> {
    let count = samples.time.len();
    let (ropes, segments, points) = (names.rope.len(), names.segment.len(), names.rope_point.len());
    let (bodies, kinds) = (names.body.len(), names.energy_kind.len());
    let (event_count, peaks) = (events.len(), samples.rope_peak_tension.len());
    let contacts = samples.contact_peak_force.len();
    let adjusted = if columns.rope_lengthening.is_empty() { 0 } else { ropes };
    vec![
        ("time", samples.time.clone(), vec![count]),
        ("rope_tension", columns.rope_tension, vec![count, ropes]),
        ("rope_lengthening", columns.rope_lengthening, vec![count, adjusted]),
        ("segment_tension", columns.segment_tension, vec![count, segments]),
        ("segment_length", columns.segment_length, vec![count, segments]),
        ("rope_point", columns.rope_point, vec![count, points, 3]),
        ("wrap_angle", columns.wrap_angle, vec![count, names.wrapped_sheave.len()]),
        ("fleet_angle", columns.fleet_angle, vec![count, names.wrapped_sheave.len(), 2]),
        ("body_position", columns.body_position, vec![count, bodies, 3]),
        ("body_orientation", columns.body_orientation, vec![count, bodies, 4]),
        ("body_velocity", columns.body_velocity, vec![count, bodies, 3]),
        ("body_angular_velocity", columns.body_angular_velocity, vec![count, bodies, 3]),
        ("momentum", columns.momentum, vec![count, 3]),
        ("angular_momentum", columns.angular_momentum, vec![count, 3]),
        ("joint_position", columns.joint_position, vec![count, names.joint.len()]),
        ("joint_force", columns.joint_force, vec![count, bodies, 3]),
        ("contact_force", columns.contact_force, vec![count, names.contact.len()]),
        ("contact_lift", columns.contact_lift, vec![count, names.contact.len()]),
        ("pin_force", columns.pin_force, vec![count, names.pin.len()]),
        ("clearance", columns.clearance, vec![count, names.pair.len()]),
        ("displaced_volume", columns.displaced_volume, vec![count, names.hull.len()]),
        ("clearance_point", columns.clearance_point, vec![count, names.pair.len(), 2, 3]),
        ("energy", columns.energy, vec![count, kinds]),
        ("heave_compensation", samples.compensation.clone(), vec![count, names.compensator.len()]),
        ("residual_constraint", columns.constraint_residual, vec![count]),
        ("residual_complementarity", samples.complementarity_residual.clone(), vec![count]),
        ("rope_peak_tension", samples.rope_peak_tension.clone(), vec![peaks]),
        ("rope_peak_time", samples.rope_peak_time.clone(), vec![peaks]),
        ("contact_peak_force", samples.contact_peak_force.clone(), vec![contacts]),
        ("contact_peak_time", samples.contact_peak_time.clone(), vec![contacts]),
        ("event_time", events, vec![event_count]),
    ]
}
