//! Hulls at the border: a mesh in, what lies below planes out.

use gantline_core::hull::{Mesh, Plane, Surface};
use glam::DVec3;
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::{array, value_error};

/// A hull that can be cut by planes.
#[pyclass(module = "gantline._core", frozen)]
pub struct Hull {
    mesh: Mesh,
    inner: gantline_core::hull::Hull,
}

fn vector<'py>(py: Python<'py>, value: DVec3) -> PyResult<Bound<'py, PyAny>> {
    Ok(array(py, value.to_array().to_vec(), &[3])?.into_any())
}

#[pymethods]
impl Hull {
    /// A hull of vertices (n, 3) [m] and triangles (m, 3); vertices closer than `weld` [m] are made one.
    #[new]
    fn new(
        py: Python<'_>,
        vertices: PyReadonlyArray2<f64>,
        triangles: PyReadonlyArray2<i64>,
        weld: f64,
    ) -> PyResult<Self> {
        let (points, corners) = (vertices.as_array(), triangles.as_array());
        if points.ncols() != 3 || corners.ncols() != 3 {
            return Err(value_error("vertices have three coordinates, triangles three vertices"));
        }
        if points.iter().any(|value| !value.is_finite()) {
            return Err(value_error("a coordinate of the hull is not finite"));
        }
        if corners.iter().any(|&index| index < 0 || index as usize >= points.nrows()) {
            return Err(value_error("a triangle of the hull names a vertex that does not exist"));
        }
        let vertices = points.rows().into_iter().map(|row| DVec3::new(row[0], row[1], row[2])).collect();
        let row_of = |row: numpy::ndarray::ArrayView1<i64>| [0, 1, 2].map(|k| row[k] as usize);
        let mesh = Mesh { vertices, triangles: corners.rows().into_iter().map(row_of).collect() };
        let mesh = if weld > 0.0 { py.detach(|| mesh.welded(weld)) } else { mesh };
        let inner = py.detach(|| gantline_core::hull::Hull::new(&mesh));
        Ok(Self { mesh, inner })
    }

    /// Vertices (n, 3) [m] and triangles (m, 3) after welding.
    fn mesh<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyAny>)> {
        let points: Vec<f64> = self.mesh.vertices.iter().flat_map(|vertex| vertex.to_array()).collect();
        let corners: Vec<f64> = self.mesh.triangles.iter().flatten().map(|&index| index as f64).collect();
        let vertices = array(py, points, &[self.mesh.vertices.len(), 3])?;
        Ok((vertices.into_any(), array(py, corners, &[self.mesh.triangles.len(), 3])?.into_any()))
    }

    /// How far it is closed.
    fn closure<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let closure = self.mesh.closure();
        let out = PyDict::new(py);
        out.set_item("boundary_edges", closure.boundary_edges)?;
        out.set_item("boundary_length", closure.boundary_length)?;
        out.set_item("lowest_boundary", closure.lowest_boundary)?;
        out.set_item("turned_edges", closure.turned_edges)?;
        out.set_item("crowded_edges", closure.crowded_edges)?;
        out.set_item("unbalanced_area", vector(py, closure.unbalanced_area)?)?;
        out.set_item("volume", closure.volume)?;
        Ok(out)
    }

    /// What lies below h(x) = normal·x + height = 0.
    fn below<'py>(&self, py: Python<'py>, normal: [f64; 3], height: f64) -> PyResult<Bound<'py, PyDict>> {
        let below = self.inner.below(&Plane { normal: DVec3::from_array(normal), height });
        let out = PyDict::new(py);
        out.set_item("volume", below.volume)?;
        out.set_item("moment", vector(py, below.moment)?)?;
        out.set_item("depth_moment", below.depth_moment)?;
        out.set_item("area", below.area)?;
        out.set_item("area_moment", vector(py, below.area_moment)?)?;
        out.set_item("area_second", array(py, below.area_second.to_cols_array().to_vec(), &[3, 3])?)?;
        Ok(out)
    }

    /// The skin below that plane.
    fn surface<'py>(&self, py: Python<'py>, normal: [f64; 3], height: f64) -> PyResult<Bound<'py, PyDict>> {
        let surface = Surface::of(&self.mesh, &Plane { normal: DVec3::from_array(normal), height });
        let out = PyDict::new(py);
        out.set_item("wetted_area", surface.wetted_area)?;
        out.set_item("thrust", vector(py, surface.thrust)?)?;
        out.set_item("thrust_moment", vector(py, surface.thrust_moment)?)?;
        out.set_item("waterline_gap", vector(py, surface.waterline_gap)?)?;
        out.set_item("waterline_length", surface.waterline_length)?;
        out.set_item("waterline_low", vector(py, surface.waterline_low)?)?;
        out.set_item("waterline_high", vector(py, surface.waterline_high)?)?;
        Ok(out)
    }
}
