//! Runs that are put aside and taken up again.

use serde::{Deserialize, Serialize};

use super::method::Method;
use super::{Command, Counters, SetupError, Simulation};
use crate::event::EventLog;
use crate::record::Samples;
use crate::state::State;

/// Everything that goes into a checkpoint.
#[derive(Serialize, Deserialize)]
struct Checkpoint {
    fingerprint: u64,
    /// That of the document alone.
    document: u64,
    state: State,
    samples: Samples,
    events: EventLog,
    commands: Vec<Command>,
    counters: Counters,
}

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

/// What [`Simulation::save`] gave, which a digest of all that stands before ends: numbers that have changed or are missing
/// would be met somewhere in a step.
fn checkpoint_of(bytes: &[u8]) -> Result<Checkpoint, SetupError> {
    let (text, end) = bytes.split_at(bytes.len().saturating_sub(DIGEST));
    if digest(text).as_bytes() != end {
        return Err(SetupError::State("it is no state of a run, or is damaged or cut off".to_owned()));
    }
    serde_json::from_slice(text).map_err(|error| SetupError::State(error.to_string()))
}

/// The state in what [`Simulation::save`] gave of the document with a fingerprint, whatever the settings.
///
/// # Errors
/// [`SetupError::State`] where it is not that.
pub(crate) fn saved_state(document: u64, bytes: &[u8]) -> Result<State, SetupError> {
    let checkpoint = checkpoint_of(bytes)?;
    if checkpoint.document != document {
        return Err(SetupError::State("it was saved from another lift".to_owned()));
    }
    Ok(checkpoint.state)
}

impl Simulation {
    /// All that is needed to go on with the same bytes.
    pub fn save(&self) -> Result<Vec<u8>, SetupError> {
        let checkpoint = Checkpoint {
            fingerprint: self.fingerprint,
            document: self.document,
            state: self.state.clone(),
            samples: self.samples.clone(),
            events: self.events.clone(),
            commands: self.commands.clone(),
            counters: self.counters,
        };
        let mut bytes = serde_json::to_vec(&checkpoint)?;
        let end = digest(&bytes);
        bytes.extend_from_slice(end.as_bytes());
        Ok(bytes)
    }

    /// Takes up a saved run of the same document and settings.
    ///
    /// # Errors
    /// [`SetupError::State`] where it is not that.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), SetupError> {
        let checkpoint = checkpoint_of(bytes)?;
        if checkpoint.fingerprint != self.fingerprint {
            let problem = "it was saved from another lift, or with other settings";
            return Err(SetupError::State(problem.to_owned()));
        }
        self.state = checkpoint.state;
        self.samples = checkpoint.samples;
        self.events = checkpoint.events;
        self.commands = checkpoint.commands;
        self.counters = checkpoint.counters;
        self.asked = (self.counters.steps, self.state.time);
        self.before.copy_from(&self.state);
        self.frame.update(&self.system, &self.state);
        if let Method::Adaptive(adaptive) = &mut self.method {
            adaptive.forget();
        }
        Ok(())
    }
}
