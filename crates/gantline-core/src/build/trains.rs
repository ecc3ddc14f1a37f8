//! Waves and gusts that come by, and what waves do to bodies.

use std::f64::consts::TAU;
use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::{BuildError, error, finite, positive};
use crate::force::mean_drift::MeanDrift;
use crate::force::slow::Slow;
use crate::force::trains::{Component, Trains};
use crate::force::wave::{Phasor, WaveForce};
use crate::spec::{DriftSpec, MeanDriftSpec, PhasorSpec, TERMS, TrainsSpec};

/// Cubics of every wave from every direction to the next.
type Around<'a, T> = &'a [Vec<[T; TERMS]>];

/// Of the slowest wave, what the slow place of a body follows: 0.7 % of its motion in that wave are left there.
const CUT_OFF: f64 = 0.2;

/// The sea or the gusts of a document; nothing where it has none.
pub(super) fn build_trains(name: &str, given: Option<&TrainsSpec>) -> Result<Arc<Trains>, BuildError> {
    let Some(given) = given else { return Ok(Arc::default()) };
    positive(name, "the time in which its waves grow", given.rise_time)?;
    let mut components = Vec::with_capacity(given.components.len());
    for wave in &given.components {
        positive(name, "the frequency of a wave", wave.frequency)?;
        let [x, y] = wave.wave_number;
        finite(name, "a wave number, amplitude or phase", &[x, y, wave.amplitude, wave.phase])?;
        let (wave_number, frequency) = (DVec2::new(x, y), wave.frequency);
        let (number, amplitude, phase) = (wave_number.length(), wave.amplitude, wave.phase);
        components.push(Component { frequency, wave_number, number, amplitude, phase });
    }
    if let Some(depth) = given.depth {
        positive(name, "the depth of its water", depth)?;
    }
    Ok(Arc::new(Trains { components, rise_time: given.rise_time, depth: given.depth }))
}

/// What waves do to a body: X, and D if there are any, of every component of the sea in some directions, about a point of the
/// body [m], and the point whose way counts.
pub(super) fn build_wave(
    name: &str,
    body: usize,
    [at, origin]: [&[f64; 3]; 2],
    directions: &[f64],
    (phasors, drifts): (Around<PhasorSpec>, Around<DriftSpec>),
    sea: &Arc<Trains>,
) -> Result<WaveForce, BuildError> {
    finite(name, "a point of its", &[*at, *origin].concat())?;
    finite(name, "a direction of its waves", directions)?;
    let (Some(first), Some(last)) = (directions.first(), directions.last()) else {
        return error(name, "it has forces of waves in no direction");
    };
    if !directions.is_sorted_by(|one, other| one < other) || last - first >= TAU {
        return error(name, "the directions of its waves do not rise within a turn");
    }
    if sea.components.is_empty() {
        return error(name, "there is no sea that its waves are of");
    }
    let scaled: Vec<[Phasor; TERMS]> =
        around((name, "forces"), phasors, directions.len(), sea, |amplitude, terms| {
            terms.map(|both: PhasorSpec| [0, 1].map(|part| both.map(|x| amplitude * x[part])))
        })?;
    finite(name, "a force of its waves", scaled.as_flattened().as_flattened().as_flattened())?;
    let drifting = if drifts.is_empty() {
        Vec::new()
    } else {
        around((name, "drift forces"), drifts, directions.len(), sea, |amplitude, terms| {
            terms.map(|drift| drift.map(|x| amplitude * x))
        })?
    };
    finite(name, "a drift force of its waves", drifting.as_flattened().as_flattened())?;
    let towards = sea.components.iter().map(|wave| wave.wave_number.y.atan2(wave.wave_number.x));
    let slowest = sea.components.iter().map(|wave| wave.frequency).fold(f64::INFINITY, f64::min);
    Ok(WaveForce {
        name: name.to_owned(),
        body,
        at: DVec3::from_array(*at),
        directions: directions.to_vec(),
        phasors: scaled,
        drifts: drifting,
        towards: towards.collect(),
        sea: Arc::clone(sea),
        slow: Slow { point: DVec3::from_array(*origin), cut_off: CUT_OFF * slowest, first: 0 },
    })
}

/// What waves do to a body on the whole; the filter behind it is that of their force.
pub(super) fn build_mean_drift(
    name: &str,
    body: usize,
    at: [f64; 3],
    (around, settled): (&[[MeanDriftSpec; TERMS]], bool),
    sea: &Arc<Trains>,
) -> Result<MeanDrift, BuildError> {
    finite(name, "the point at which it acts", &at)?;
    if around.is_empty() {
        return error(name, "it has a mean drift force at no heading");
    }
    finite(name, "a mean drift force of its waves", around.as_flattened().as_flattened().as_flattened())?;
    let slow = Slow { point: DVec3::ZERO, cut_off: 0.0, first: 0 };
    let (at, around, sea) = (DVec3::from_array(at), around.to_vec(), Arc::clone(sea));
    Ok(MeanDrift { name: name.to_owned(), body, at, around, settled, sea, slow })
}

/// What is given of every wave of the sea in every direction, one after the other, made of it with the amplitude of the wave
/// [m].
fn around<T: Copy, U>(
    (name, what): (&str, &str),
    given: &[Vec<T>],
    directions: usize,
    sea: &Trains,
    make: impl Fn(f64, T) -> U,
) -> Result<Vec<U>, BuildError> {
    let (found, waves) = (given.len(), sea.components.len());
    if found != waves {
        return error(name, format!("it has {what} of {found} waves; the sea has {waves}"));
    }
    let mut made = Vec::with_capacity(waves * directions);
    for (wave, each) in sea.components.iter().zip(given) {
        let found = each.len();
        if found != directions {
            return error(
                name,
                format!("it has {what} in {found} directions of a wave, and {directions} directions"),
            );
        }
        made.extend(each.iter().map(|terms| make(wave.amplitude, *terms)));
    }
    Ok(made)
}
