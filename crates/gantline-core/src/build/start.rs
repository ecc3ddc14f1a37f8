//! The state in which a system starts.

use super::trains::build_trains;
use super::{BuildError, error};
use crate::audit::{Ledger, Stored, elastic_energy, gravity_energy};
use crate::constraint::Law;
use crate::contact::spot::Spot;
use crate::force;
use crate::plan::PlanState;
use crate::plan::drive::Timeline;
use crate::rope::coil::Coil;
use crate::rope::seat::Seat;
use crate::solver::complementarity::Mode;
use crate::solver::symbolic::PIVOT_FLOOR;
use crate::spec::SystemSpec;
use crate::state::State;
use crate::stepper::STANDSTILL;
use crate::stepper::frame::Frame;
use crate::system::System;
use crate::tree::Body;
use crate::tree::mass::MassMatrix;

/// Degrees of freedom of a joint, at most.
const MOST_MOTIONS: usize = 6;

/// The state at t = 0: forces by their laws, ledger opened, inertia scales set.
pub(super) fn first_state(
    spec: &SystemSpec,
    system: &mut System,
    (q, v): (Vec<f64>, Vec<f64>),
    (seats, spots): (Vec<Seat>, Vec<Spot>),
) -> Result<State, BuildError> {
    let mut state = without_forces(spec, system, (q, v), (seats, spots))?;
    let mut frame = Frame::new(system);
    frame.update(system, &state);
    force::begin(&system.tree, &frame.kinematics, (&state.v, state.time), &mut state.past);
    // Contacts start with their anchors below them: without deflection.
    for (row, law) in system.rows.laws.iter().enumerate() {
        if matches!(law, Law::Friction { .. }) {
            state.memory[row] = frame.value[row];
        }
    }
    frame.update(system, &state);
    set_inertia_scales(system, &frame)?;
    for sling in system.slings.iter().filter(|sling| !sling.starts_on) {
        state.modes[system.rows.first[sling.constraint]] = Mode::Off;
    }
    for row in 0..system.rows.count() {
        start_row(system, &frame, row, &mut state)?;
    }
    for pinning in system.pins.iter().filter(|pinning| pinning.starts_on) {
        state.modes[system.rows.first[pinning.constraint]] = Mode::Acting;
    }
    if !system.coils.is_empty() {
        frame.update(system, &state);
    }
    for ((coil, place), passing) in state.coils.iter_mut().zip(&system.coils).zip(&frame.passing) {
        coil.laid = place.laid_under.map_or(passing.outside, |tension| tension / place.stiffness);
        coil.is_stretched = frame.value[place.row] > 0.0;
    }
    let held = force::energy(&system.tree, &frame.kinematics);
    let stored = Stored {
        kinetic: 0.5 * frame.mass.quadratic(&state.v),
        gravity: gravity_energy(system, &frame.kinematics),
        elastic: elastic_energy(system, &frame.value, &state.modes) + held.lines,
        fluid: held.fluid,
    };
    state.ledger = Ledger::open(system, stored);
    Ok(state)
}

/// Places and velocities as given, every row slack.
fn without_forces(
    spec: &SystemSpec,
    system: &System,
    (q, v): (Vec<f64>, Vec<f64>),
    (seats, spots): (Vec<Seat>, Vec<Spot>),
) -> Result<State, BuildError> {
    let rows = system.rows.count();
    let timelines = system.drives.iter().zip(&spec.drives).map(|(drive, given)| {
        let start = q[system.tree.bodies[drive.body].first_position];
        let mut timeline = Timeline::new(start, given.ramps.len() + 2 * spec.plan.len() + 1);
        for ramp in &given.ramps {
            timeline.ramp(ramp.at, ramp.duration, ramp.velocity, ramp.shape);
        }
        if given.waves.is_some() {
            timeline.follow_waves(build_trains(&given.name, given.waves.as_ref())?);
        }
        Ok(timeline)
    });
    let timelines = timelines.collect::<Result<Vec<_>, BuildError>>()?;
    let plan = PlanState::new(&system.plan, timelines);
    Ok(State {
        time: 0.0,
        steps: 0,
        acceleration: vec![0.0; v.len()],
        bias: vec![0.0; v.len()],
        q,
        v,
        tension: vec![0.0; rows],
        trial: vec![0.0; rows],
        modes: vec![Mode::Slack; rows],
        memory: vec![0.0; rows],
        seats,
        spots,
        coils: vec![Coil::new(0.0); system.coils.len()],
        past: vec![0.0; force::states(&system.tree)],
        next_step: 0.0,
        restart: true,
        engaged: false,
        engaged_step: f64::MAX,
        plan,
        ledger: Ledger::default(),
    })
}

/// Sets the scale of inertia of each degree of freedom; one that has none is refused.
fn set_inertia_scales(system: &mut System, frame: &Frame) -> Result<(), BuildError> {
    for dof in 0..system.tree.velocities {
        let inertia = frame.mass.diagonal(dof);
        if inertia <= 0.0 && system.driven[dof].is_none() && !system.is_light[dof] {
            return no_inertia(&system.tree.bodies[system.tree.owner[dof]]);
        }
        system.tree.inertia_scale[dof] = if inertia > 0.0 { inertia } else { 1.0 };
    }
    match system.tree.bodies.iter().find(|body| body.velocities > 1 && !moves_all_ways(body, &frame.mass)) {
        Some(body) => no_inertia(body),
        None => Ok(()),
    }
}

fn no_inertia(body: &Body) -> Result<(), BuildError> {
    error(
        &body.name,
        "it has no inertia in a direction that it can move: give it mass or inertia; mass on an axis has none about it",
    )
}

/// True where no mixture of the motions of its joint goes without inertia, as a turn about the line from a ball joint to a
/// centre of gravity that has all mass would, askew to the axes: elimination leaves pivots.
fn moves_all_ways(body: &Body, mass: &MassMatrix) -> bool {
    let (first, size) = (body.first_velocity, body.velocities);
    let mut left: [[f64; MOST_MOTIONS]; MOST_MOTIONS] = std::array::from_fn(|row| {
        let entry = |column: usize| mass.values[mass.slot(first + row, first + column)];
        std::array::from_fn(|column| if column <= row && row < size { entry(column) } else { 0.0 })
    });
    (0..size).all(|k| {
        let pivot = left[k][k];
        for row in k + 1..size {
            let share = left[row][k] / pivot;
            for column in k + 1..=row {
                left[row][column] -= share * left[column][k];
            }
        }
        pivot > PIVOT_FLOOR * mass.diagonal(first + k)
    })
}

/// Sets how a row starts: its force by its law, and on which side it is.
fn start_row(system: &System, frame: &Frame, row: usize, state: &mut State) -> Result<(), BuildError> {
    if state.modes[row].is_absent() {
        return Ok(());
    }
    let (compliance, damping_time) = match system.rows.laws[row] {
        Law::Unilateral { compliance, damping_time } | Law::Spring { compliance, damping_time } => {
            (compliance, damping_time)
        }
        Law::Friction { normal, .. } => {
            state.modes[row] = state.modes[normal];
            return Ok(());
        }
        Law::Pin => return Ok(()),
        Law::Brake { .. } => {
            let speed = system.rows.rate(&frame.gradient, row, &state.v);
            state.modes[row] = if speed == 0.0 { Mode::Acting } else { Mode::Slipping };
            state.memory[row] = speed.signum();
            return Ok(());
        }
    };
    let is_spring = matches!(system.rows.laws[row], Law::Spring { .. });
    let e = frame.value[row];
    let rate = system.rows.rate(&frame.gradient, row, &state.v);
    if compliance > 0.0 {
        state.trial[row] = (e + damping_time * rate) / compliance;
        state.tension[row] = if is_spring { state.trial[row] } else { state.trial[row].max(0.0) };
    } else if e > 1e-9 * (1.0 + e.abs()) {
        let name = system.constraint_of_row(row).name();
        return error(name, format!("it is inextensible and {e} m shorter than its route at the start"));
    }
    // A row at its bound starts as acting, so that a lift that starts taut logs no event for it. An inextensible
    // rope whose ends do not keep their distance is about to go slack, or is hit: steps find which.
    let keeps = compliance == 0.0 && e >= -1e-9 && rate.abs() <= STANDSTILL;
    if is_spring || state.trial[row] > 0.0 || keeps {
        state.modes[row] = Mode::Acting;
    }
    Ok(())
}
