//! What programs ask of drives while a run stands still, in place of the plan.

use serde::{Deserialize, Serialize};

use super::{SetupError, Simulation};
use crate::build::plan::build_emergency;
use crate::plan::Order;
use crate::spec::CommandSpec;
use crate::system::DriveJoint;

/// What a program has asked for, in place of the plan.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Command {
    /// When [s].
    pub time: f64,
    /// What moves, and how, in the words of the plan.
    pub name: String,
    /// See `name`.
    pub motion: String,
    /// Signed speed [m/s or rad/s].
    pub speed: f64,
    /// Acceleration limit [m/s² or rad/s²].
    pub acceleration: f64,
}

impl Simulation {
    /// From now on drives do what a program asks for, and no more what the plan says.
    ///
    /// # Errors
    /// [`SetupError`] says what is wrong; nothing has changed then.
    pub fn command(&mut self, document: &str) -> Result<(), SetupError> {
        let spec: CommandSpec = serde_json::from_str(document)?;
        let CommandSpec { name, motion, speed, acceleration, orders: given } = spec;
        let refused = |problem: &str| Err(SetupError::Command(format!("`{name}` {problem}")));
        if self.reached(f64::INFINITY) {
            return refused("cannot be commanded any more: the run has ended");
        }
        if self.state.plan.is_stopped() {
            return refused("cannot be commanded any more: an emergency stop has stopped everything");
        }
        let mut orders = Vec::with_capacity(given.len());
        for order in given {
            let Some(drive) = self.system.drives.iter().position(|drive| drive.name == order.drive) else {
                return refused(&format!("has no drive `{}`", order.drive));
            };
            if !(order.acceleration > 0.0 && order.braking >= order.acceleration) {
                return refused("needs an acceleration above zero and within its limit");
            }
            let [least, most] = order.range;
            let range = [least.unwrap_or(f64::NEG_INFINITY), most.unwrap_or(f64::INFINITY)];
            let emergency = build_emergency(&name, &order.emergency, &self.system.drives[drive])?;
            let (velocity, acceleration, braking) = (order.velocity, order.acceleration, order.braking);
            orders.push((drive, Order { velocity, acceleration, braking, range, emergency }));
        }
        let time = self.state.time;
        for (drive, order) in orders {
            let DriveJoint { body, is_limited, .. } = self.system.drives[drive];
            let timeline = &mut self.state.plan.timelines[drive];
            if is_limited {
                // The end of its range is one of where its drum is, which may have slipped.
                let position = self.system.tree.bodies[body].first_position;
                timeline.put_right(self.state.q[position] - timeline.motion(time).position);
            }
            timeline.command(time, &order);
        }
        self.commands.push(Command { time, name, motion, speed, acceleration });
        self.method.forget();
        Ok(())
    }

    /// What programs have asked for so far.
    pub fn commands(&self) -> &[Command] {
        &self.commands
    }

    /// Position and velocity of what a drive moves now [m or rad, and per s]; none of an unknown drive.
    pub fn drive(&self, name: &str) -> Option<(f64, f64)> {
        let drive = self.system.drives.iter().find(|drive| drive.name == name)?;
        let position = self.system.tree.bodies[drive.body].first_position;
        Some((self.state.q[position], self.state.v[drive.dof]))
    }
}
