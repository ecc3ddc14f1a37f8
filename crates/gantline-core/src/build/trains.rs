//! Waves and gusts that come by, and what waves do to bodies.

use std::sync::Arc;

use glam::{DVec2, DVec3};

use super::{BuildError, error, finite, positive};
use crate::force::trains::{Component, Trains};
use crate::force::wave::{Phasor, WaveForce};
use crate::spec::TrainsSpec;
use crate::tree::bias::Wrench;

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
        components.push(Component { frequency, wave_number, amplitude: wave.amplitude, phase: wave.phase });
    }
    Ok(Arc::new(Trains { components, rise_time: given.rise_time }))
}

/// What waves do to a body: X of every component of the sea, about a point of the body [m].
pub(super) fn build_wave(
    name: &str,
    body: usize,
    at: [f64; 3],
    phasors: &[[[f64; 2]; 6]],
    sea: &Arc<Trains>,
) -> Result<WaveForce, BuildError> {
    finite(name, "its point", &at)?;
    finite(name, "a force of its", phasors.as_flattened().as_flattened())?;
    let (given, waves) = (phasors.len(), sea.components.len());
    if given != waves {
        return error(name, format!("it has forces of {given} waves; the sea has {waves}"));
    }
    let wrench = |phasor: &[[f64; 2]; 6], part: usize| {
        let [x, y, z, roll, pitch, yaw] = phasor.map(|both| both[part]);
        Wrench { force: DVec3::new(x, y, z), moment: DVec3::new(roll, pitch, yaw) }
    };
    let phasors = phasors.iter().map(|both| Phasor { real: wrench(both, 0), imaginary: wrench(both, 1) });
    let (name, at, phasors) = (name.to_owned(), DVec3::from_array(at), phasors.collect());
    Ok(WaveForce { name, body, at, phasors, sea: Arc::clone(sea) })
}
