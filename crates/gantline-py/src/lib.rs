//! Python binding of `gantline-core`: documents in, columns of numbers out.

mod hull;
mod statics;

use std::sync::{Mutex, MutexGuard};
use std::time::{Duration, Instant};

use gantline_core::record::named::Named;
use gantline_core::stepper::StepError;
use numpy::ndarray::{ArrayD, IxDyn};
use numpy::{IntoPyArray, PyArrayDyn};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::MutexExt;
use pyo3::types::{IntoPyDict, PyDict};

/// How often a caller hears of the progress.
const PROGRESS_INTERVAL: Duration = Duration::from_millis(100);
/// Steps between looks at the clock.
const STEPS_PER_LOOK: u32 = 64;

fn value_error(error: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// A run of one system, behind a lock: while one thread runs it, others may ask how far it has got. They wait for
/// the end of a stretch of stepping, a tenth of a second, without holding the interpreter.
#[pyclass(module = "gantline._core", frozen)]
struct Simulation(Mutex<gantline_core::Simulation>);

/// How a stretch of stepping ended.
enum Pause {
    Reached,
    Progress,
    Failed(StepError),
}

#[pymethods]
impl Simulation {
    /// Builds a system from its document and the settings of its run, both JSON texts.
    #[new]
    fn new(py: Python<'_>, document: &str, settings: &str) -> PyResult<Self> {
        let inner = py.detach(|| gantline_core::Simulation::new(document, settings)).map_err(value_error)?;
        Ok(Self(Mutex::new(inner)))
    }

    /// Runs until `until` [s], or to the end; tells `on_progress` the time, which stops the run by False. Where it is
    /// `exact`, the last step ends at `until` if the method can choose its steps.
    #[pyo3(signature = (on_progress=None, until=None, exact=false))]
    fn run<'py>(
        &self,
        py: Python<'py>,
        on_progress: Option<Bound<'py, PyAny>>,
        until: Option<f64>,
        exact: bool,
    ) -> PyResult<Bound<'py, PyDict>> {
        let until = until.unwrap_or(f64::INFINITY);
        let status = PyDict::new(py);
        loop {
            let (pause, mut time) = {
                let inner = &mut *self.inner(py)?;
                (py.detach(|| run_for_a_while(inner, until, exact)), inner.time())
            };
            // Not locked here: the callback may ask for the step under way, or for the columns so far.
            let answer = on_progress.as_ref().map(|callback| callback.call1((time,))).transpose()?;
            let goes_on = answer.filter(|said| !said.is_none()).map_or(Ok(true), |said| said.is_truthy())?;
            match pause {
                Pause::Reached => status.set_item("status", "done")?,
                Pause::Progress if goes_on => {
                    py.check_signals()?;
                    continue;
                }
                Pause::Progress => status.set_item("status", "stopped")?,
                Pause::Failed(error) => {
                    status.set_item("status", "failed")?;
                    status.set_item("message", error.to_string())?;
                    status.set_item("element", error.element)?;
                    status.set_item("cause", error.cause)?;
                    time = error.time;
                }
            }
            status.set_item("time", time)?;
            return Ok(status);
        }
    }

    /// Columns of the recording so far, by name, or of the moments at which groups of ropes pulled most.
    #[pyo3(signature = (of_pulls=false))]
    fn columns<'py>(&self, py: Python<'py>, of_pulls: bool) -> PyResult<Bound<'py, PyDict>> {
        let inner = self.inner(py)?;
        dictionary(py, py.detach(|| if of_pulls { inner.columns_of_pulls() } else { inner.named_columns() }))
    }

    /// Columns of the present alone, by name.
    fn present<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let inner = self.inner(py)?;
        dictionary(py, py.detach(|| inner.present()))
    }

    /// From now on drives do what a document asks for, and no more what the plan says.
    fn command(&self, py: Python<'_>, document: &str) -> PyResult<()> {
        self.inner(py)?.command(document).map_err(value_error)
    }

    /// Position and velocity of what a drive moves now.
    fn drive(&self, py: Python<'_>, name: &str) -> PyResult<(f64, f64)> {
        let found = self.inner(py)?.drive(name);
        found.ok_or_else(|| value_error(format!("there is no drive `{name}`")))
    }

    /// Tensions of all ropes (samples, ropes) [N], without working out the other columns.
    fn rope_tension<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let inner = self.inner(py)?;
        let tensions = gantline_core::record::columns::rope_tensions(inner.system(), inner.samples());
        array(py, tensions, &[inner.samples().time.len(), inner.system().rope_count])
    }

    /// Names that go with the columns.
    fn names<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let inner = self.inner(py)?;
        let out = inner.names().lists().into_py_dict(py)?;
        let events = inner.events();
        out.set_item("event_kind", events.iter().map(|event| event.1).collect::<Vec<_>>())?;
        out.set_item("event_name", events.iter().map(|event| event.2.as_str()).collect::<Vec<_>>())?;
        let commands = inner.commands();
        out.set_item("command_name", commands.iter().map(|one| one.name.as_str()).collect::<Vec<_>>())?;
        out.set_item("command_motion", commands.iter().map(|one| one.motion.as_str()).collect::<Vec<_>>())?;
        Ok(out)
    }

    /// What the run counted.
    fn counters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.inner(py)?.counted().into_py_dict(py)
    }

    /// What the error of a step may be, by name [N, m]; empty where steps are fixed.
    fn tolerances<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.inner(py)?.tolerances().into_py_dict(py)
    }

    /// Measures from now on where the time goes.
    fn measure(&self, py: Python<'_>) -> PyResult<()> {
        self.inner(py).map(|mut inner| inner.measure())
    }

    /// Time [s] of every stage of what has been measured, by name.
    fn stages<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.inner(py)?.stages().into_py_dict(py)
    }

    /// Simulated time [s].
    fn time(&self, py: Python<'_>) -> PyResult<f64> {
        Ok(self.inner(py)?.time())
    }

    /// True at its end, within rounding.
    fn ended(&self, py: Python<'_>) -> PyResult<bool> {
        Ok(self.inner(py)?.reached(f64::INFINITY))
    }

    /// Name of the step of the plan that is under way.
    fn current_step(&self, py: Python<'_>) -> PyResult<Option<String>> {
        Ok(self.inner(py)?.current_step().map(str::to_owned))
    }

    /// Tensions of all ropes now [N].
    fn current_tension(&self, py: Python<'_>) -> PyResult<Vec<f64>> {
        Ok(self.inner(py)?.rope_tension())
    }

    /// Largest energy remainder over the largest of kinetic + elastic + |drive work| + |fluid work|.
    fn energy_remainder(&self, py: Python<'_>) -> PyResult<f64> {
        Ok(self.inner(py)?.state().ledger.relative_remainder())
    }

    /// All that is needed to go on with the same bytes; the state `alone`, without what was before it, for statics.
    #[pyo3(signature = (alone=false))]
    fn save(&self, py: Python<'_>, alone: bool) -> PyResult<Vec<u8>> {
        let inner = self.inner(py)?;
        py.detach(|| if alone { inner.save_state() } else { inner.save() }).map_err(value_error)
    }

    /// Where steps ended and tanks passed marks, from the `first` on: step, time since it began unless it ended, time, state.
    fn waypoints(&self, py: Python<'_>, first: usize) -> PyResult<Vec<gantline_core::simulation::Saved>> {
        self.inner(py)?.save_waypoints(first).map_err(value_error)
    }

    /// Takes up a saved run of the same document and settings.
    fn restore(&self, py: Python<'_>, state: &[u8]) -> PyResult<()> {
        let inner = &mut *self.inner(py)?;
        py.detach(|| inner.restore(state)).map_err(value_error)
    }
}

impl Simulation {
    /// The run, as soon as no other thread is stepping it.
    fn inner(&self, py: Python<'_>) -> PyResult<MutexGuard<'_, gantline_core::Simulation>> {
        let broken =
            |_| PyRuntimeError::new_err("this simulation broke off in a step and cannot be used again");
        self.0.lock_py_attached(py).map_err(broken)
    }
}

fn run_for_a_while(simulation: &mut gantline_core::Simulation, until: f64, exact: bool) -> Pause {
    let start = Instant::now();
    let limit = if exact { until } else { f64::INFINITY };
    loop {
        for _ in 0..STEPS_PER_LOOK {
            if simulation.reached(until) {
                return Pause::Reached;
            }
            if let Err(error) = simulation.step_to(limit) {
                return Pause::Failed(error);
            }
        }
        if start.elapsed() >= PROGRESS_INTERVAL {
            return Pause::Progress;
        }
    }
}

/// Columns as arrays, by name.
fn dictionary(py: Python<'_>, columns: Vec<Named>) -> PyResult<Bound<'_, PyDict>> {
    let out = PyDict::new(py);
    for (name, values, shape) in columns {
        out.set_item(name, array(py, values, &shape)?)?;
    }
    Ok(out)
}

fn array<'py>(py: Python<'py>, values: Vec<f64>, shape: &[usize]) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    Ok(ArrayD::from_shape_vec(IxDyn(shape), values).map_err(value_error)?.into_pyarray(py))
}

/// The compiled heart of gantline.
#[pymodule]
mod _core {
    #[pymodule_export]
    use super::{Simulation, hull::Hull, statics::Statics};
    use numpy::{PyArray1, PyArrayMethods};
    use pyo3::prelude::*;

    /// Looks numpy's functions up, which runs Python: a Ctrl-C that waits for that is an error here, and would be a
    /// panic at the first array that the core hands out.
    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.py().import("numpy")?;
        PyArray1::<f64>::zeros(module.py(), 0, false).readonly();
        Ok(())
    }
}
