//! What changes during a run and is enough to go on from: a checkpoint is this, written down.

use serde::{Deserialize, Serialize};

use crate::audit::Ledger;
use crate::contact::spot::Spot;
use crate::plan::PlanState;
use crate::rope::coil::Coil;
use crate::rope::seat::Seat;
use crate::solver::complementarity::Mode;

/// State of a run at a moment.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct State {
    /// Time [s].
    pub time: f64,
    /// Steps taken.
    pub steps: u64,
    /// Configuration: joint coordinates.
    pub q: Vec<f64>,
    /// Velocity coordinates.
    pub v: Vec<f64>,
    /// v̇ over the last step.
    pub acceleration: Vec<f64>,
    /// c of the last step: velocity-dependent forces minus gravity.
    pub bias: Vec<f64>,
    /// Force of every row [N].
    pub tension: Vec<f64>,
    /// What the law asks of every row without its bound [N].
    pub trial: Vec<f64>,
    /// How every row takes part.
    pub modes: Vec<Mode>,
    /// What a row remembers: for tangential contact rows where the anchor is along the tangent [m], for brakes the
    /// direction of slip, for ropes by how much adjusting has lengthened them [m].
    pub memory: Vec<f64>,
    /// How ropes lie on sheaves with true tangents, by [`crate::system::System::sheaves`].
    pub seats: Vec<Seat>,
    /// Where bodies may touch, by [`crate::constraint::touch::Touch::spot`].
    pub spots: Vec<Spot>,
    /// What drums have wound, by [`crate::system::System::coils`].
    pub coils: Vec<Coil>,
    /// What forces remember of the motion so far, see [`crate::force::memory`] and [`crate::force::slow`].
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub past: Vec<f64>,
    /// Length that the next step of an adaptive method tries first [s]; 0 where none has been made.
    pub next_step: f64,
    /// True at the start and after a change that makes the accelerations jump.
    pub restart: bool,
    /// True after rows have started to act: the next step follows a faster motion than the last did.
    pub engaged: bool,
    /// Length of the step that followed the last time that happened [s].
    pub engaged_step: f64,
    /// Where the plan stands.
    pub plan: PlanState,
    /// Energy so far.
    pub ledger: Ledger,
}

impl State {
    /// Takes over another state of the same system; does not allocate.
    pub fn copy_from(&mut self, other: &Self) {
        // By name, so that a field that is added is not forgotten.
        let Self {
            time,
            steps,
            q,
            v,
            acceleration,
            bias,
            tension,
            trial,
            modes,
            memory,
            seats,
            spots,
            coils,
            past,
            next_step,
            restart,
            engaged,
            engaged_step,
            plan,
            ledger,
        } = other;
        (self.time, self.steps, self.ledger) = (*time, *steps, *ledger);
        (self.next_step, self.engaged_step) = (*next_step, *engaged_step);
        (self.restart, self.engaged) = (*restart, *engaged);
        self.q.copy_from_slice(q);
        self.v.copy_from_slice(v);
        self.acceleration.copy_from_slice(acceleration);
        self.bias.copy_from_slice(bias);
        self.tension.copy_from_slice(tension);
        self.trial.copy_from_slice(trial);
        self.modes.copy_from_slice(modes);
        self.memory.copy_from_slice(memory);
        self.seats.copy_from_slice(seats);
        self.spots.copy_from_slice(spots);
        self.past.copy_from_slice(past);
        for (coil, other) in self.coils.iter_mut().zip(coils) {
            coil.copy_from(other);
        }
        self.plan.copy_from(plan);
    }
}
