//! Bodies, their joints and the state that they start in.

use glam::{DMat3, DQuat, DVec3};

use super::{BuildError, at_least_zero, error, finite, unit};
use crate::spec::{AxisJointSpec, BodySpec, JointSpec, SystemSpec};
use crate::tree::ball::Ball;
use crate::tree::fixed::Fixed;
use crate::tree::flow::Flow;
use crate::tree::free::Free;
use crate::tree::hinge::Hinge;
use crate::tree::joint::Joint;
use crate::tree::point::Point;
use crate::tree::pose::Pose;
use crate::tree::slider::Slider;
use crate::tree::{Body, Tree};

fn unit_quaternion(element: &str, given: [f64; 4]) -> Result<DQuat, BuildError> {
    let quaternion = DQuat::from_xyzw(given[1], given[2], given[3], given[0]);
    if (quaternion.length() - 1.0).abs() < 1e-6 {
        return Ok(quaternion.normalize());
    }
    error(element, format!("orientation {given:?} is no unit quaternion"))
}

pub(super) fn build_tree(spec: &SystemSpec) -> Result<Tree, BuildError> {
    finite("gravity", "the acceleration", &spec.gravity)?;
    let mut bodies: Vec<Body> = Vec::with_capacity(spec.bodies.len());
    for given in &spec.bodies {
        let parent = match &given.parent {
            None => None,
            Some(name) => match bodies.iter().position(|body| &body.name == name) {
                Some(parent) => Some(parent),
                None => return error(&given.name, format!("no body `{name}` stands before it to hang on")),
            },
        };
        bodies.push(build_body(given, parent)?);
    }
    let mut tree = Tree::new(bodies, DVec3::from_array(spec.gravity));
    for (index, given) in spec.bodies.iter().enumerate() {
        let dof = tree.bodies[index].first_velocity;
        if let Some(joint) = given.joint.axis() {
            at_least_zero(&given.name, "the joint's damping", joint.damping)?;
            tree.damping[dof] = joint.damping;
        }
        if let JointSpec::Flow { inertia, damping, .. } = &given.joint {
            at_least_zero(&given.name, "its damping", *damping)?;
            at_least_zero(&given.name, "its inertia", *inertia)?;
            (tree.damping[dof], tree.armature[dof]) = (*damping, *inertia);
        }
    }
    Ok(tree)
}

fn build_body(given: &BodySpec, parent: Option<usize>) -> Result<Body, BuildError> {
    let name = &given.name;
    at_least_zero(name, "its mass", given.mass)?;
    finite(name, "its inertia", &given.inertia)?;
    finite(name, "its centre of gravity", &given.centre_of_gravity)?;
    finite(name, "its place", &given.placement.position)?;
    let [xx, yy, zz, xy, xz, yz] = given.inertia;
    let inertia = DMat3::from_cols_array(&[xx, xy, xz, xy, yy, yz, xz, yz, zz]);
    let minor = xx * yy - xy * xy;
    let slack = -1e-9 * (xx + yy + zz).abs().powi(3);
    if xx < 0.0 || yy < 0.0 || zz < 0.0 || minor < -1e-9 * (xx + yy).powi(2) || inertia.determinant() < slack
    {
        return error(name, "its inertia is no inertia of a body: the matrix must not be negative");
    }
    let orientation = unit_quaternion(name, given.placement.orientation)?;
    Ok(Body {
        name: name.clone(),
        parent,
        placement: Pose::new(orientation, DVec3::from_array(given.placement.position)),
        is_turned: orientation != DQuat::IDENTITY,
        joint: build_joint(name, &given.joint)?,
        mass: given.mass,
        centre_of_gravity: DVec3::from_array(given.centre_of_gravity),
        inertia,
        first_position: 0,
        first_velocity: 0,
        velocities: 0,
    })
}

fn build_joint(name: &str, given: &JointSpec) -> Result<Joint, BuildError> {
    Ok(match given {
        JointSpec::Fixed {} => Joint::Fixed(Fixed),
        JointSpec::Hinge(joint) => {
            finite(name, "its start", &[joint.position, joint.velocity])?;
            Joint::Hinge(Hinge { axis: unit(name, "the hinge axis", joint.axis)? })
        }
        JointSpec::Slider(joint) => {
            finite(name, "its start", &[joint.position, joint.velocity])?;
            Joint::Slider(Slider { axis: unit(name, "the slider axis", joint.axis)? })
        }
        JointSpec::Flow { velocity, .. } => {
            finite(name, "its start", &[*velocity])?;
            Joint::Flow(Flow)
        }
        JointSpec::Content { .. } => Joint::Flow(Flow),
        JointSpec::Ball { orientation, angular_velocity } => {
            unit_quaternion(name, *orientation)?;
            finite(name, "its angular velocity", angular_velocity)?;
            Joint::Ball(Ball)
        }
        JointSpec::Point { position, velocity } => {
            finite(name, "its start", &[*position, *velocity].concat())?;
            Joint::Point(Point)
        }
        JointSpec::Free { position, orientation, velocity, angular_velocity } => {
            unit_quaternion(name, *orientation)?;
            finite(name, "its start", &[*position, *velocity, *angular_velocity].concat())?;
            Joint::Free(Free)
        }
    })
}

pub(super) fn start_of_joint(given: &JointSpec, q: &mut [f64], v: &mut [f64]) {
    match given {
        JointSpec::Fixed {} | JointSpec::Content { .. } => {}
        JointSpec::Hinge(AxisJointSpec { position, velocity, .. })
        | JointSpec::Slider(AxisJointSpec { position, velocity, .. }) => {
            (q[0], v[0]) = (*position, *velocity)
        }
        JointSpec::Flow { velocity, .. } => (q[0], v[0]) = (0.0, *velocity),
        JointSpec::Ball { orientation, angular_velocity } => {
            q[..4].copy_from_slice(orientation);
            v[..3].copy_from_slice(angular_velocity);
        }
        JointSpec::Point { position, velocity } => {
            q[..3].copy_from_slice(position);
            v[..3].copy_from_slice(velocity);
        }
        JointSpec::Free { position, orientation, velocity, angular_velocity } => {
            q[..3].copy_from_slice(position);
            q[3..7].copy_from_slice(orientation);
            v[..3].copy_from_slice(velocity);
            v[3..6].copy_from_slice(angular_velocity);
        }
    }
}
