//! Forces on bodies: of water, wind and waves, and of mooring lines.

use std::sync::Arc;

use glam::DVec3;

use super::memory::build_memory;
use super::moorings::build_mooring;
use super::submerged::build_submerged;
use super::trains::{build_mean_drift, build_wave};
use super::{BuildError, at_least_zero, error, finite, positive};
use crate::force::AnyForce;
use crate::force::added_mass::AddedMass;
use crate::force::buoyancy::Buoyancy;
use crate::force::damping::Damping;
use crate::force::drag::Drag;
use crate::force::level_mass::LevelMass;
use crate::force::mooring::Mooring;
use crate::force::profile::{Growth, Profile};
use crate::force::slow::Slow;
use crate::force::square::Square;
use crate::force::tank::{Pumped, Tank};
use crate::force::trains::Trains;
use crate::hull::{Hull, Mesh};
use crate::spec::{ForceSpec, GrowthSpec, JointSpec, ProfileSpec, PumpedSpec, SystemSpec};
use crate::tree::Tree;

/// Difference of a matrix from its transpose, relative to its largest entry.
const SYMMETRIC: f64 = 1e-9;
/// How far below zero an eigenvalue may be, relative to the diagonal.
const ROUNDING: f64 = 1e-9;

/// Points and triangles of a surface.
type Surface<'a> = (&'a [[f64; 3]], &'a [[usize; 3]]);

/// Forces, with the sea that those of waves come from and the gusts of the wind.
pub(super) fn build_forces(
    spec: &SystemSpec,
    tree: &Tree,
    trains: [&Arc<Trains>; 2],
) -> Result<Vec<AnyForce>, BuildError> {
    let mut forces: Vec<AnyForce> =
        spec.forces.iter().map(|given| build_force(given, spec, tree, trains)).collect::<Result<_, _>>()?;
    let mut first = 0;
    for force in &mut forces {
        match force {
            AnyForce::Memory(memory) => {
                memory.first = first;
                first = memory.states().end;
            }
            AnyForce::Wave(wave) => {
                wave.slow.first = first;
                first = wave.slow.states().end;
            }
            _ => {}
        }
    }
    let waves: Vec<(usize, Slow)> = forces
        .iter()
        .filter_map(|force| match force {
            AnyForce::Wave(wave) => Some((wave.body, wave.slow.clone())),
            _ => None,
        })
        .collect();
    for force in &mut forces {
        // Of several wave forces on a body the first: its heading is that of all.
        if let Some((_, slow)) = waves.iter().find(|(body, _)| *body == force.body()) {
            follow_waves(force, slow);
        }
    }
    Ok(forces)
}

/// What water does to the motions of a body that waves push acts along the axes of their forces.
fn follow_waves(force: &mut AnyForce, slow: &Slow) {
    match force {
        AnyForce::Memory(memory) => memory.slow = Some(slow.clone()),
        AnyForce::MeanDrift(drift) => drift.slow = slow.clone(),
        AnyForce::AddedMass(added) => *force = AnyForce::LevelMass(LevelMass::of(added, slow)),
        AnyForce::Drag(drag) => {
            if let Some(damping) = Damping::of(drag, slow) {
                *force = AnyForce::Damping(damping);
            }
        }
        _ => {}
    }
}

fn build_force(
    given: &ForceSpec,
    spec: &SystemSpec,
    tree: &Tree,
    trains: [&Arc<Trains>; 2],
) -> Result<AnyForce, BuildError> {
    let name = given.name();
    let [sea, gusts] = trains;
    let find = |body: &str| match tree.bodies.iter().position(|other| other.name == body) {
        Some(index) if tree.bodies[index].joint.moves_body() => Ok(index),
        Some(_) => error(name, format!("`{body}` is rope that flows; forces act on bodies")),
        None => error(name, format!("there is no body `{body}` for it to act on")),
    };
    Ok(match given {
        ForceSpec::Mooring(line) => {
            let mooring: Mooring = build_mooring(line, find(&line.body)?, tree)?;
            AnyForce::Mooring(Box::new(mooring))
        }
        ForceSpec::Wave { body, at, origin, directions, phasors, drifts, .. } => {
            AnyForce::Wave(build_wave(name, find(body)?, [at, origin], directions, (phasors, drifts), sea)?)
        }
        ForceSpec::MeanDrift { body, at, around, settled, .. } => {
            let is_pushed =
                |force: &ForceSpec| matches!(force, ForceSpec::Wave { body: pushed, .. } if pushed == body);
            if !spec.forces.iter().any(is_pushed) {
                return error(name, format!("no waves push `{body}`"));
            }
            AnyForce::MeanDrift(build_mean_drift(name, find(body)?, *at, (around, *settled), sea)?)
        }
        ForceSpec::Memory { body, at, terms, .. } => {
            AnyForce::Memory(build_memory(name, find(body)?, *at, terms)?)
        }
        ForceSpec::Buoyancy { body, vertices, triangles, density, level, .. } => {
            let mesh = (vertices.as_slice(), triangles.as_slice());
            AnyForce::Buoyancy(Box::new(build_buoyancy(name, find(body)?, mesh, (*density, *level), tree)?))
        }
        ForceSpec::Tank { body, vertices, triangles, density, volume, pumped, .. } => {
            let mesh = (vertices.as_slice(), triangles.as_slice());
            let mut tank = build_tank(name, find(body)?, mesh, (*density, *volume), tree)?;
            if let Some(PumpedSpec { content, level, .. }) = pumped {
                finite(name, "the level of the liquid outside", &[*level])?;
                tank.pumped = Some(find_content(name, (content, *level), tank.body, spec, tree)?);
            }
            AnyForce::Tank(Box::new(tank))
        }
        ForceSpec::AddedMass { body, at, matrix, .. } => {
            AnyForce::AddedMass(build_added_mass(name, find(body)?, *at, matrix)?)
        }
        ForceSpec::Submerged { body, lattices, density, level, stream, .. } => {
            let water = (*density, *level, *stream);
            AnyForce::Submerged(Box::new(build_submerged(
                name,
                find(body)?,
                lattices,
                water,
                sea,
                tree.gravity,
            )?))
        }
        ForceSpec::Drag { body, at, damping, quadratic, stream, profile, gusty, .. } => {
            let resistances = (damping, quadratic);
            let fluid = (*stream, profile.as_ref(), gusty.then_some(gusts));
            AnyForce::Drag(build_drag(name, find(body)?, *at, resistances, fluid)?)
        }
    })
}

/// A hull as its surface, in water with a density [kg/m³] up to a level [m].
fn build_buoyancy(
    name: &str,
    body: usize,
    (vertices, triangles): Surface,
    (density, level): (f64, f64),
    tree: &Tree,
) -> Result<Buoyancy, BuildError> {
    // Without density nothing pushes: what it displaces is told all the same.
    at_least_zero(name, "the density of its water", density)?;
    finite(name, "the level of its water", &[level])?;
    if tree.gravity.length() == 0.0 {
        return error(name, "there is no gravity, so water does not press; give it gravity");
    }
    let hull = Hull::new(&build_mesh(name, vertices, triangles)?);
    Ok(Buoyancy { name: name.to_owned(), body, hull, density, level })
}

/// A tank with a volume [m³] of a liquid with a density [kg/m³] in it.
fn build_tank(
    name: &str,
    body: usize,
    (vertices, triangles): Surface,
    (density, volume): (f64, f64),
    tree: &Tree,
) -> Result<Tank, BuildError> {
    positive(name, "the density of what is in it", density)?;
    if tree.gravity.length() == 0.0 {
        return error(name, "there is no gravity, so a liquid has no level; give it gravity");
    }
    let mesh = build_mesh(name, vertices, triangles)?;
    let closure = mesh.closure();
    if !closure.is_closed() {
        return error(name, "its mesh is not closed, so a liquid would run out");
    }
    let capacity = closure.volume;
    if !(volume >= 0.0 && volume <= capacity) {
        return error(name, format!("{volume} m³ are in it; it holds from 0 to {capacity} m³"));
    }
    Ok(Tank::new(name.to_owned(), body, Hull::new(&mesh), capacity, density, volume))
}

fn build_added_mass(
    name: &str,
    body: usize,
    at: [f64; 3],
    matrix: &[[f64; 6]; 6],
) -> Result<AddedMass, BuildError> {
    finite(name, "its point", &at)?;
    check_matrix(name, "its added mass", matrix)?;
    let built = Square::from_rows(matrix);
    let (difference, size) = built.asymmetry();
    if difference > SYMMETRIC * size {
        return error(name, format!("its added mass differs from its transpose by {difference}"));
    }
    Ok(AddedMass { name: name.to_owned(), body, at: DVec3::from_array(at), matrix: built })
}

/// Resistance, linear and by the square of the velocity, in a stream [m/s], with what it has of growth and gusts.
fn build_drag(
    name: &str,
    body: usize,
    at: [f64; 3],
    (damping, quadratic): (&[[f64; 6]; 6], &[f64; 6]),
    (stream, profile, gusts): ([f64; 3], Option<&ProfileSpec>, Option<&Arc<Trains>>),
) -> Result<Drag, BuildError> {
    finite(name, "its point", &at)?;
    finite(name, "the velocity of its fluid", &stream)?;
    check_matrix(name, "its damping", damping)?;
    if let Some(value) = quadratic.iter().find(|value| !(**value >= 0.0 && value.is_finite())) {
        return error(name, format!("a quadratic resistance is {value}; it must be zero or more"));
    }
    let stream = DVec3::from_array(stream);
    if gusts.is_some() && stream == DVec3::ZERO {
        return error(name, "gusts come with wind; give it a stream");
    }
    Ok(Drag {
        name: name.to_owned(),
        body,
        at: DVec3::from_array(at),
        damping: Square::from_rows(damping),
        linear: DVec3::from_slice(&quadratic[..3]),
        angular: DVec3::from_slice(&quadratic[3..]),
        stream,
        profile: profile.map(|given| build_profile(name, given)).transpose()?,
        gusts: gusts.cloned(),
    })
}

fn build_profile(name: &str, given: &ProfileSpec) -> Result<Profile, BuildError> {
    let ProfileSpec { level, height, lowest, growth } = *given;
    finite(name, "the level that heights count from", &[level])?;
    positive(name, "the lowest height of its wind", lowest)?;
    positive(name, "the height of its wind", height)?;
    let growth = match growth {
        GrowthSpec::Logarithm(roughness) => {
            positive(name, "the roughness under its wind", roughness)?;
            if roughness >= lowest.min(height) {
                let heights = format!("{height} m and {lowest} m");
                return error(
                    name,
                    format!("the roughness of {roughness} m is no less than its heights, {heights}"),
                );
            }
            Growth::Logarithm(roughness)
        }
        GrowthSpec::Power(exponent) => {
            at_least_zero(name, "the exponent of its wind", exponent)?;
            Growth::Power(exponent)
        }
    };
    Ok(Profile { level, height, lowest, growth })
}

/// The coordinate of the content of a tank on a body, and the level from which it is pumped.
fn find_content(
    name: &str,
    (wanted, level): (&str, f64),
    body: usize,
    spec: &SystemSpec,
    tree: &Tree,
) -> Result<Pumped, BuildError> {
    let Some(index) = spec.bodies.iter().position(|other| other.name == wanted) else {
        return error(name, format!("there is no body `{wanted}` whose joint could be its content"));
    };
    let own = &tree.bodies[index];
    if !matches!(spec.bodies[index].joint, JointSpec::Content { .. }) || own.parent != Some(body) {
        return error(name, format!("the joint of `{wanted}` is no content of a tank on that body"));
    }
    Ok(Pumped { position: own.first_position, dof: own.first_velocity, level })
}

fn build_mesh(name: &str, vertices: &[[f64; 3]], triangles: &[[usize; 3]]) -> Result<Mesh, BuildError> {
    finite(name, "a point of its mesh", vertices.as_flattened())?;
    if let Some(index) = triangles.iter().flatten().find(|index| **index >= vertices.len()) {
        return error(name, format!("its mesh has no point {index}, only {}", vertices.len()));
    }
    let vertices = vertices.iter().map(|vertex| DVec3::from_array(*vertex)).collect();
    let mesh = Mesh { vertices, triangles: triangles.to_vec() };
    let volume = mesh.closure().volume;
    if volume > 0.0 {
        return Ok(mesh);
    }
    error(
        name,
        format!(
            "its mesh has a volume of {volume} m³; its triangles must run counter-clockwise seen from outside"
        ),
    )
}

/// No eigenvalue of the symmetric part may be below zero: the water would drive the body.
pub(super) fn check_matrix(name: &str, what: &str, rows: &[[f64; 6]; 6]) -> Result<(), BuildError> {
    finite(name, what, rows.as_flattened())?;
    // LDLᵀ by elimination, scaled by the diagonal.
    let scale: [f64; 6] = std::array::from_fn(|k| rows[k][k].max(0.0).sqrt());
    let scaled = |i: usize, j: usize| {
        let both = scale[i] * scale[j];
        if both > 0.0 { 0.5 * (rows[i][j] + rows[j][i]) / both } else { 0.5 * (rows[i][j] + rows[j][i]) }
    };
    let mut a: [[f64; 6]; 6] = std::array::from_fn(|i| std::array::from_fn(|j| scaled(i, j)));
    for k in 0..6 {
        let pivot = a[k][k];
        let rest = (k + 1..6).fold(0.0_f64, |most, i| most.max(a[i][k].abs()));
        if pivot < -ROUNDING || (pivot <= ROUNDING && rest > ROUNDING.sqrt()) {
            return error(name, format!("{what} is no matrix without negative eigenvalues"));
        }
        if pivot > ROUNDING {
            for i in k + 1..6 {
                let factor = a[i][k] / pivot;
                (k + 1..6).for_each(|j| a[i][j] -= factor * a[k][j]);
            }
        }
    }
    Ok(())
}
