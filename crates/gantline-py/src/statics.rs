//! Statics at the border: a document in, equilibria, modes and sensitivities out.

use gantline_core::record::named::named;
use gantline_core::statics::lift::{GoesOn, StaticLift};
use gantline_core::statics::losses::Losses;
use gantline_core::statics::modes::Mode;
use gantline_core::statics::sensitivity::Parameter;
use gantline_core::statics::{NoEquilibrium, Rest};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

use super::{array, dictionary, value_error};

/// What was asked for, by name.
type Answer<'py> = PyResult<Bound<'py, PyDict>>;

/// A system at rest.
#[pyclass(module = "gantline._core")]
pub struct Statics {
    inner: StaticLift,
    modes: Vec<Mode>,
}

fn no_equilibrium(error: NoEquilibrium) -> PyErr {
    PyRuntimeError::new_err((error.element, error.cause))
}

fn losses_of(word: &str, slide: Option<[f64; 3]>) -> PyResult<Losses> {
    match (word, slide.and_then(Losses::slid)) {
        ("none", Some(slides)) => Ok(slides),
        _ if slide.is_some() => Err(value_error("what slides does so along a way, with ideal sheaves")),
        ("none", None) => Ok(Losses::NONE),
        ("forward", None) => Ok(Losses::FORWARD),
        ("backward", None) => Ok(Losses::BACKWARD),
        ("held", None) => Ok(Losses::HELD),
        _ => Err(value_error(format!("losses are none, forward, backward or held, not {word}"))),
    }
}

#[pymethods]
impl Statics {
    /// Builds a system from its document, JSON text.
    #[new]
    fn new(py: Python<'_>, document: &str) -> PyResult<Self> {
        let inner = py.detach(|| StaticLift::new(document)).map_err(value_error)?;
        Ok(Self { inner, modes: Vec::new() })
    }

    /// Number of degrees of freedom.
    fn degrees_of_freedom(&self) -> usize {
        self.inner.system().tree.velocities
    }

    /// Time of the equilibrium that was looked for last [s].
    fn time(&self) -> f64 {
        self.inner.state().time
    }

    /// Finds the equilibrium at a time of the plan; raises `RuntimeError` with element and cause where there is none,
    /// or where `goes_on`, which is asked before every part of the way, says no.
    #[pyo3(signature = (time=0.0, increment=None, losses="none", slide=None, goes_on=None))]
    fn settle<'py>(
        &mut self,
        py: Python<'py>,
        time: f64,
        increment: Option<Vec<f64>>,
        losses: &str,
        slide: Option<[f64; 3]>,
        goes_on: Option<Py<PyAny>>,
    ) -> Answer<'py> {
        let size = self.degrees_of_freedom();
        if let Some(given) = increment.as_ref().map(Vec::len).filter(|&given| given != size) {
            return Err(value_error(format!("{given} increments for {size} degrees of freedom")));
        }
        if !(time >= 0.0 && time.is_finite()) {
            return Err(value_error(format!("the time is {time} s; it must be zero or more")));
        }
        let (losses, start) = (losses_of(losses, slide)?, increment.as_deref());
        let rest = self.following(py, goes_on, |lift, ask| lift.settle(time, start, losses, ask))?;
        self.found(py, rest)
    }

    /// When a step of the plan begins or ends, of a lift that is followed no farther than that; none where that is not
    /// before `time` [s]. For the rest see `settle`.
    #[pyo3(signature = (step, ends, time, goes_on=None))]
    fn when(
        &mut self,
        py: Python<'_>,
        step: &str,
        ends: bool,
        time: f64,
        goes_on: Option<Py<PyAny>>,
    ) -> PyResult<Option<f64>> {
        self.following(py, goes_on, |lift, ask| lift.when(step, ends, time, ask))
    }

    /// Finds the equilibrium of where a simulation of the same document has got to, from what it has saved.
    fn settle_saved<'py>(&mut self, py: Python<'py>, saved: &[u8], losses: &str) -> Answer<'py> {
        let losses = losses_of(losses, None)?;
        self.modes.clear();
        let rest = py.detach(|| self.inner.settle_saved(saved, losses)).map_err(value_error)?;
        self.found(py, rest.map_err(no_equilibrium)?)
    }

    /// Moves from the unstable equilibrium found last to the stable one beside it; none where it is not unstable.
    #[pyo3(signature = (losses="none"))]
    fn step_off<'py>(&mut self, py: Python<'py>, losses: &str) -> PyResult<Option<Bound<'py, PyDict>>> {
        let losses = losses_of(losses, None)?;
        self.modes.clear();
        let rest = py.detach(|| self.inner.step_off(losses)).map_err(no_equilibrium)?;
        rest.map(|rest| self.found(py, rest)).transpose()
    }

    /// Loses a body at the equilibrium found last and finds that of everything else.
    fn lose<'py>(&mut self, py: Python<'py>, body: &str, losses: &str) -> Answer<'py> {
        let missing = || value_error(format!("there is no {body} to lose"));
        let (index, losses) = (self.inner.body(body).ok_or_else(missing)?, losses_of(losses, None)?);
        self.modes.clear();
        let rest = py.detach(|| self.inner.lose(index, losses)).map_err(no_equilibrium)?;
        self.found(py, rest)
    }

    /// The lift with bodies so much heavier [kg], at rest downhill of the equilibrium found last.
    fn heavier(&self, py: Python<'_>, more: Vec<(String, f64)>, losses: &str) -> PyResult<Self> {
        let (mut inner, losses) = (self.inner.clone(), losses_of(losses, None)?);
        py.detach(|| inner.weigh(&more, losses)).map_err(no_equilibrium)?;
        Ok(Self { inner, modes: Vec::new() })
    }

    /// Modes about the equilibrium found last, slowest first, so many or all, or given by ω² and x; arrays over the modes.
    #[pyo3(signature = (count=None, found=None))]
    fn modes<'py>(
        &mut self,
        py: Python<'py>,
        count: Option<usize>,
        found: Option<Vec<(f64, Vec<f64>)>>,
    ) -> Answer<'py> {
        self.modes = py.detach(|| self.inner.modes(count, found));
        let (modes, count, bodies) = (&self.modes, self.modes.len(), self.inner.names().body.len());
        let motion = modes.iter().flat_map(|mode| self.inner.body_motion(&mode.shape)).collect();
        let shapes = modes.iter().flat_map(|mode| mode.shape.iter().copied()).collect();
        let ratio = |mode: &Mode| mode.damping_ratio.unwrap_or(f64::NAN);
        let out = PyDict::new(py);
        out.set_item("square", array(py, modes.iter().map(|mode| mode.square).collect(), &[count])?)?;
        out.set_item("damping_ratio", array(py, modes.iter().map(ratio).collect(), &[count])?)?;
        out.set_item("shape", array(py, shapes, &[count, self.degrees_of_freedom()])?)?;
        out.set_item("body_motion", array(py, motion, &[count, bodies, 6])?)?;
        out.set_item("flows", self.inner.flows().collect::<Vec<_>>())?;
        Ok(out)
    }

    /// Lets the equilibrium swing in one of the modes that were found last; `columns` has one period of it.
    fn swing(&mut self, mode: usize, amplitude: f64, frames: usize) -> PyResult<()> {
        let found = self.modes.get(mode).ok_or_else(|| value_error(format!("there is no mode {mode}")))?;
        self.inner.swing(found, amplitude, frames);
        Ok(())
    }

    /// Derivatives over pairs of a kind, `length` or `centre_x`, and a name; it `stands`: friction holds what is on deck.
    #[pyo3(signature = (parameters, stands=false))]
    fn sensitivities<'py>(
        &mut self,
        py: Python<'py>,
        parameters: Vec<(String, String)>,
        stands: bool,
    ) -> Answer<'py> {
        let named = parameters.iter().map(|(kind, name)| self.inner.parameter(kind, name));
        let wanted: Vec<Parameter> = named.collect::<Result<_, _>>().map_err(value_error)?;
        let found = py.detach(|| self.inner.sensitivities(&wanted, stands.into())).map_err(no_equilibrium)?;
        let (ropes, bodies) = (self.inner.system().all_ropes(), self.inner.names().body.len());
        let answers = || found.iter().zip(&wanted);
        let values = answers().flat_map(|(one, parameter)| self.inner.tension_change(*parameter, one));
        let motion = answers().flat_map(|(one, parameter)| self.inner.body_change(*parameter, &one.motion));
        let held = found.iter().map(|one| f64::from(u8::from(one.is_held)));
        let out = PyDict::new(py);
        out.set_item("held", array(py, held.collect(), &[wanted.len()])?)?;
        out.set_item("rope_tension", array(py, values.collect(), &[wanted.len(), ropes])?)?;
        out.set_item("body_motion", array(py, motion.collect(), &[wanted.len(), bodies, 6])?)?;
        Ok(out)
    }

    /// The lift linearised about the equilibrium found last, water as at a circular frequency [rad/s] or an infinite one.
    #[pyo3(signature = (frequency=None))]
    fn linear<'py>(&mut self, py: Python<'py>, frequency: Option<f64>) -> Answer<'py> {
        let out = dictionary(py, py.detach(|| self.inner.linear(frequency)))?;
        out.set_item("coordinates", self.inner.coordinates())?;
        Ok(out)
    }

    /// When a step of the plan began and ended on the way to the equilibrium found last [s]; none where it had not.
    fn times_of(&self, step: &str) -> (Option<f64>, Option<f64>) {
        self.inner.times_of(step).into()
    }

    /// Columns of the equilibrium or swing found last, by name.
    fn columns<'py>(&self, py: Python<'py>) -> Answer<'py> {
        let (columns, events) = (py.detach(|| self.inner.columns()), vec![0.0; self.inner.events().len()]);
        dictionary(py, named(self.inner.samples(), columns, &self.inner.names(), events))
    }

    /// Names that go with the columns.
    fn names<'py>(&self, py: Python<'py>) -> Answer<'py> {
        let out = self.inner.names().lists().into_py_dict(py)?;
        let (kinds, names): (Vec<_>, Vec<_>) = self.inner.events().into_iter().unzip();
        out.set_item("event_kind", kinds)?;
        out.set_item("event_name", names)?;
        Ok(out)
    }
}

impl Statics {
    /// Follows the plan without the interpreter; before every part it is asked whether to go on.
    fn following<T: Send>(
        &mut self,
        py: Python<'_>,
        goes_on: Option<Py<PyAny>>,
        follow: impl FnOnce(&mut StaticLift, GoesOn) -> Result<T, NoEquilibrium> + Send,
    ) -> PyResult<T> {
        self.modes.clear();
        let mut answer = Ok(true);
        let found = py.detach(|| {
            let mut ask = || {
                answer = Python::attach(|py| {
                    py.check_signals()?;
                    goes_on.as_ref().map_or(Ok(true), |asked| asked.call0(py)?.is_truthy(py))
                });
                matches!(answer, Ok(true))
            };
            follow(&mut self.inner, &mut ask)
        });
        answer?;
        found.map_err(no_equilibrium)
    }

    fn found<'py>(&self, py: Python<'py>, rest: Rest) -> Answer<'py> {
        let out = PyDict::new(py);
        out.set_item("time", self.inner.state().time)?;
        out.set_item("residual", rest.residual)?;
        out.set_item("neutral", rest.neutral)?;
        out.set_item("unstable", rest.unstable)?;
        out.set_item("steps", rest.effort.steps)?;
        out.set_item("factorisations", rest.factorisations)?;
        out.set_item("lossy", self.inner.lossy_sheaves())?;
        out.set_item("slides", self.inner.slides())?;
        out.set_item("contacts", self.inner.contact_forces())?;
        Ok(out)
    }
}
