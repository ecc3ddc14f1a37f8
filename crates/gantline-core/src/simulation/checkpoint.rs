//! Runs that are put aside and taken up again.

use serde::{Deserialize, Serialize};

use super::{Command, Counters, Saved, SetupError, Simulation, Waypoint};
use crate::event::EventLog;
use crate::record::Samples;
use crate::state::State;

/// What goes into a saved state beside the samples.
#[derive(Serialize, Deserialize)]
struct Checkpoint {
    fingerprint: u64,
    /// That of the document alone.
    document: u64,
    state: State,
    events: EventLog,
    commands: Vec<Command>,
    counters: Counters,
    /// Steps and time [s] at which it was last asked whether the run gets on.
    asked: (u64, f64),
    /// What [`crate::record::pulls::Pulls`] writes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pulls: Vec<(f64, Vec<u8>)>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    waypoints: Vec<Waypoint>,
}

/// What a saved state begins with. The number is that of its form: it grows when what the samples are packed as changes,
/// the order of rows, or what lies beside them.
const KIND: &str = concat!("gantline ", env!("CARGO_PKG_VERSION"), " state 5\n");
/// What those of other versions begin with.
const OTHERS: [&str; 2] = ["gantline ", "{\"fingerprint\":"];

/// FNV-1a, to tell whether a checkpoint belongs to a document.
pub(crate) fn fingerprint<const COUNT: usize>(texts: [&str; COUNT]) -> u64 {
    hash(texts.iter().flat_map(|text| text.bytes().chain([0])))
}

fn hash(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// Characters of the digest that ends a saved state.
const DIGEST: usize = 16;

fn digest(bytes: &[u8]) -> String {
    format!("{:0DIGEST$x}", hash(bytes.iter().copied()))
}

/// What [`Simulation::save`] gave: its kind, the length of the checkpoint's JSON, that, and the samples. A digest of all that
/// stands before ends it: numbers that have changed or are missing would be met somewhere in a step.
fn checkpoint_of(bytes: &[u8]) -> Result<(Checkpoint, &[u8]), SetupError> {
    let refused = |problem: &str| SetupError::State(problem.to_owned());
    let damaged = || refused("it is no state of a run, or is damaged or cut off");
    let other =
        || refused("it was saved by another version of gantline, and the version that saved it reads it");
    let (text, end) = bytes.split_at(bytes.len().saturating_sub(DIGEST));
    if digest(text).as_bytes() != end {
        return Err(damaged());
    }
    let Some(rest) = text.strip_prefix(KIND.as_bytes()) else {
        let is_other = OTHERS.iter().any(|kind| text.starts_with(kind.as_bytes()));
        return Err(if is_other { other() } else { damaged() });
    };
    let (length, rest) = rest.split_first_chunk().ok_or_else(damaged)?;
    let length = usize::try_from(u64::from_le_bytes(*length)).map_err(|_| damaged())?;
    let (json, samples) = rest.split_at_checked(length).ok_or_else(damaged)?;
    let checkpoint = serde_json::from_slice(json).map_err(|_| other())?;
    Ok((checkpoint, samples))
}

fn written(checkpoint: &Checkpoint, samples: &[u8]) -> Result<Vec<u8>, SetupError> {
    let json = serde_json::to_vec(checkpoint)?;
    let length = (json.len() as u64).to_le_bytes();
    let mut bytes = [KIND.as_bytes(), &length, &json, samples].concat();
    let end = digest(&bytes);
    bytes.extend_from_slice(end.as_bytes());
    Ok(bytes)
}

/// The state in what [`Simulation::save`] gave of the document with a fingerprint, whatever the settings.
///
/// # Errors
/// [`SetupError::State`] where it is not that.
pub(crate) fn saved_state(document: u64, bytes: &[u8]) -> Result<State, SetupError> {
    let (checkpoint, _) = checkpoint_of(bytes)?;
    if checkpoint.document != document {
        return Err(SetupError::State("it was saved from another lift".to_owned()));
    }
    Ok(checkpoint.state)
}

impl Simulation {
    /// All that is needed to go on with the same bytes: what follows from the past, and the past itself, which belongs to
    /// the recording of the run that goes on.
    pub fn save(&self) -> Result<Vec<u8>, SetupError> {
        let past = Checkpoint {
            events: self.events.clone(),
            commands: self.commands.clone(),
            waypoints: self.waypoints.clone(),
            pulls: self.pulls.packed(),
            ..self.at(&self.state)
        };
        written(&past, &self.samples.packed())
    }

    /// The state alone, without what was before it, for statics that go on from it.
    ///
    /// # Errors
    /// [`SetupError`] where it cannot be written.
    pub fn save_state(&self) -> Result<Vec<u8>, SetupError> {
        written(&self.at(&self.state), &[])
    }

    /// Waypoints from the `first` on, as [`Saved`].
    ///
    /// # Errors
    /// [`SetupError`] where one cannot be written.
    pub fn save_waypoints(&self, first: usize) -> Result<Vec<Saved>, SetupError> {
        let further = self.waypoints.iter().skip(first);
        let saved = further.map(|Waypoint { step, since, state, .. }| {
            let name = step.map(|step| self.system.plan.steps[step].name.clone());
            Ok((name, *since, state.time, written(&self.at(state), &[])?))
        });
        saved.collect()
    }

    /// A state of this lift, without what was before it.
    fn at(&self, state: &State) -> Checkpoint {
        Checkpoint {
            fingerprint: self.fingerprint,
            document: self.document,
            state: state.clone(),
            events: EventLog::new(),
            commands: Vec::new(),
            counters: self.counters,
            asked: self.asked,
            pulls: Vec::new(),
            waypoints: Vec::new(),
        }
    }

    /// Takes up a saved run of the same document and settings.
    ///
    /// # Errors
    /// [`SetupError::State`] where it is not that.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), SetupError> {
        let (checkpoint, packed) = checkpoint_of(bytes)?;
        let refused = |problem: &str| SetupError::State(problem.to_owned());
        if checkpoint.fingerprint != self.fingerprint {
            return Err(refused("it was saved from another lift, or with other settings"));
        }
        let samples = Samples::unpacked(packed).filter(|samples| samples.are_of(&self.state));
        self.samples = samples.ok_or_else(|| refused("its samples cannot be read"))?;
        if !self.pulls.unpack(&checkpoint.pulls) {
            return Err(refused("its moments of most pull cannot be read"));
        }
        let own = std::mem::replace(&mut self.state, checkpoint.state);
        self.state.plan.reattach(&own.plan);
        self.events = checkpoint.events;
        self.commands = checkpoint.commands;
        self.counters = checkpoint.counters;
        self.asked = checkpoint.asked;
        self.waypoints = checkpoint.waypoints;
        self.before.copy_from(&self.state);
        self.frame.update(&self.system, &self.state);
        self.method.forget();
        Ok(())
    }
}
