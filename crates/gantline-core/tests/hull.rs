//! Volumes below a plane against closed forms, and each integral against the derivative of another.

use std::f64::consts::PI;

use super::rigs::cases;
use super::rigs::hulls::{cuboid, prism, sphere};
use gantline_core::hull::{Hull, Immersion, Mesh, Plane, Surface};
use glam::{DMat3, DQuat, DVec3};
use proptest::prelude::*;

const SIZE: [f64; 3] = [100.0, 30.0, 8.0];

/// The water at `level` [m] of a hull turned by `turn`, in the hull's axes.
fn water(turn: DQuat, level: f64) -> Plane {
    Plane { normal: turn.inverse() * DVec3::Z, height: -level }
}

fn close(found: f64, wanted: f64, scale: f64) {
    assert!((found - wanted).abs() <= 1e-12 * scale, "{found} instead of {wanted}");
}

#[test]
fn a_box_upright_has_the_figures_of_every_textbook() {
    let [l, b, d] = SIZE;
    for draft in [0.5, 4.0, 7.9] {
        let below = Hull::new(&cuboid(SIZE)).below(&water(DQuat::IDENTITY, draft));
        let volume = l * b * draft;
        close(below.volume, volume, volume);
        assert!((below.moment - DVec3::Z * volume * draft / 2.0).length() < 1e-12 * volume * l);
        close(below.depth_moment, volume * draft / 2.0, volume * draft);
        close(below.area, l * b, l * b);
        let second = DVec3::new(b * l.powi(3) / 12.0, l * b.powi(3) / 12.0, l * b * draft * draft);
        assert!((below.area_second - DMat3::from_diagonal(second)).col(0).length() < 1e-12 * second.x);
        close(below.area_second.y_axis.y, second.y, second.x);
        close(below.area_second.z_axis.z, second.z, second.x);
    }
    let Immersion { volume, area, .. } = Hull::new(&cuboid(SIZE)).below(&water(DQuat::IDENTITY, -1.0));
    assert_eq!((volume, area), (0.0, 0.0));
    let sunk = Hull::new(&cuboid(SIZE)).below(&water(DQuat::IDENTITY, 20.0));
    close(sunk.volume, l * b * d, l * b * d);
    assert_eq!(sunk.area, 0.0);
}

#[test]
fn second_moments_of_what_lies_below() {
    let [l, b, d] = SIZE;
    let hull = Hull::new(&cuboid(SIZE));
    for draft in [0.5, 4.0, d] {
        let volume = l * b * draft;
        let wanted = DVec3::new(l * l / 12.0, b * b / 12.0, draft * draft / 3.0) * volume;
        let found = hull.second_below(&water(DQuat::IDENTITY, draft));
        let error = found - DMat3::from_diagonal(wanted);
        assert!(error.to_cols_array().iter().all(|entry| entry.abs() < 1e-12 * wanted.x), "{error}");
    }
    // At any slope it grows with the level by ∫ x xᵀ dA of the section.
    let (hull, step) = (Hull::new(&sphere(2.0, 6)), 1e-5);
    let tilted = |level: f64| Plane { normal: DVec3::new(0.3, -0.4, 0.87).normalize(), height: -level };
    for level in [-1.3, 0.1, 1.7] {
        let more = hull.second_below(&tilted(level + step)) - hull.second_below(&tilted(level - step));
        let error = more * (0.5 / step) - hull.below(&tilted(level)).area_second;
        // Central differences: rounding of 40 m⁵ over the step, and its square.
        assert!(error.to_cols_array().iter().all(|entry| entry.abs() < 1e-8), "{level}: {error}");
    }
}

/// Area, and ∫ y dA, ∫ z dA of what lies below h = 0 of a convex section, by cutting the polygon.
fn section_below(section: &[[f64; 2]], h: impl Fn([f64; 2]) -> f64) -> [f64; 3] {
    let mut below = Vec::new();
    for (index, &from) in section.iter().enumerate() {
        let to = section[(index + 1) % section.len()];
        let (a, b) = (h(from), h(to));
        if a < 0.0 {
            below.push(from);
        }
        if (a < 0.0) != (b < 0.0) {
            below.push([0, 1].map(|k| from[k] + a / (a - b) * (to[k] - from[k])));
        }
    }
    let mut sums = [0.0; 3];
    for (index, &[y, z]) in below.iter().enumerate() {
        let [v, w] = below[(index + 1) % below.len()];
        let double = y * w - v * z;
        sums = [sums[0] + double / 2.0, sums[1] + double / 6.0 * (y + v), sums[2] + double / 6.0 * (z + w)];
    }
    sums
}

/// A prism heeled and trimmed by nothing else: its section tells all. Deck immersed, bilge out of the water, capsized.
#[test]
fn prisms_at_any_heel_are_their_section() {
    let rectangle = vec![[-15.0, 0.0], [15.0, 0.0], [15.0, 8.0], [-15.0, 8.0]];
    let wedge = vec![[0.0, 0.0], [7.0, 9.0], [-6.0, 8.0]];
    for section in [rectangle, wedge] {
        let mesh = prism(&section, -20.0, 30.0);
        assert!(mesh.closure().is_closed() && mesh.closure().volume > 0.0);
        let hull = Hull::new(&mesh);
        for degrees in [-170.0_f64, -90.0, -31.0, 3.0, 20.0, 45.0, 100.0, 180.0] {
            for level in [-3.0, 0.4, 2.0, 5.0] {
                let plane = water(DQuat::from_rotation_x(degrees.to_radians()), level);
                let height = |[y, z]: [f64; 2]| plane.above(DVec3::new(0.0, y, z));
                let [area, y, z] = section_below(&section, height);
                let below = hull.below(&plane);
                close(below.volume, 50.0 * area, 1e4);
                let moment = DVec3::new(50.0 * area * 5.0, 50.0 * y, 50.0 * z);
                assert!((below.moment - moment).length() < 1e-12 * 1e5, "{degrees}° {level}");
            }
        }
    }
}

/// A box heeled by φ with dry deck and wet bottom: V = LBT, B moves by (B² tan φ/12T, B² tan² φ/24T), the section has
/// the area LB/cos φ.
#[test]
fn the_wall_sided_formula_holds_for_a_box() {
    let ([l, b, _], t) = (SIZE, 4.0);
    for degrees in [1.0_f64, 5.0, 14.0] {
        for about in [DVec3::X, DVec3::Y] {
            let breadth = if about == DVec3::X { b } else { l };
            let angle = if about == DVec3::X { degrees } else { 0.3 * degrees }.to_radians();
            let turn = DQuat::from_axis_angle(about, angle);
            let across = DVec3::Z.cross(about);
            let below = Hull::new(&cuboid(SIZE)).below(&water(turn, t * angle.cos()));
            let volume = l * b * t;
            close(below.volume, volume, volume);
            let tan = angle.tan();
            let moved = across * (-breadth * breadth * tan / (12.0 * t))
                + DVec3::Z * (t / 2.0 + breadth * breadth * tan * tan / (24.0 * t));
            assert!((below.moment / below.volume - moved).length() < 1e-12 * l, "{degrees}");
            close(below.area, l * b / angle.cos(), l * b);
        }
    }
}

/// Caps of a sphere, extrapolated from four meshes: planes through rings of their points cut bodies whose integrals
/// are even in 1/rings. V = πH²(3R−H)/3, depth of its centre below the plane and section as in any table.
#[test]
fn caps_of_a_sphere_are_what_meshes_tend_to() {
    let radius = 5.0;
    for (parts, of) in [(1, 3), (1, 2), (2, 3)] {
        let angle = PI * parts as f64 / of as f64;
        let level = -radius * angle.cos();
        let figures = |rings: usize| {
            let below = Hull::new(&sphere(radius, rings)).below(&Plane { normal: DVec3::Z, height: -level });
            [below.volume, below.depth_moment, below.area, below.area_second.x_axis.x]
        };
        // Richardson's scheme in 1/rings² over meshes of rings, 2 rings, 4 rings …
        let mut rows: Vec<[f64; 4]> = (0..5).map(|k| figures(24 << k)).collect();
        for order in 1..5 {
            let weight = 4.0_f64.powi(order);
            rows = rows
                .windows(2)
                .map(|w| [0, 1, 2, 3].map(|i| (weight * w[1][i] - w[0][i]) / (weight - 1.0)))
                .collect();
        }
        let h = radius + level;
        let volume = PI * h * h * (3.0 * radius - h) / 3.0;
        let centre = -3.0 * (2.0 * radius - h).powi(2) / (4.0 * (3.0 * radius - h));
        let across = radius * radius - level * level;
        let wanted = [volume, volume * (level - centre), PI * across, PI * across * across / 4.0];
        for (found, wanted) in rows[0].iter().zip(wanted) {
            assert!((found / wanted - 1.0).abs() < 1e-9, "{found} {wanted}");
        }
    }
}

/// The box with its deck taken off, its side opened, one panel turned round, and in two pieces with seams.
#[test]
fn gaps_are_found_and_told() {
    let whole = cuboid(SIZE);
    let deck_off = Mesh {
        triangles: (0..whole.triangles.len())
            .filter(|&index| whole.corners(index).iter().any(|corner| corner.z < 8.0))
            .map(|index| whole.triangles[index])
            .collect(),
        ..whole.clone()
    };
    let closure = deck_off.closure();
    assert_eq!((closure.boundary_edges, closure.turned_edges), (4, 0));
    assert_eq!(closure.boundary_length, 260.0);
    assert_eq!(closure.lowest_boundary, 8.0);
    // What is missing is 3000 m² upwards.
    assert!((closure.unbalanced_area - DVec3::new(0.0, 0.0, -3000.0)).length() < 1e-9);
    let plane = water(DQuat::from_rotation_x(0.1), 4.0);
    let (closed, open) = (Hull::new(&whole).below(&plane), Hull::new(&deck_off).below(&plane));
    assert!((closed.volume - open.volume).abs() < 1e-12 * closed.volume);
    assert!((closed.moment - open.moment).length() < 1e-12 * closed.moment.length());

    let mut turned = whole.clone();
    turned.triangles[3].swap(0, 1);
    assert_eq!(turned.closure().turned_edges, 3);

    let mut side_open = whole.clone();
    side_open.triangles.remove(2);
    let lost = Surface::of(&side_open, &water(DQuat::IDENTITY, 4.0)).thrust;
    let kept = Surface::of(&whole, &water(DQuat::IDENTITY, 4.0)).thrust;
    assert!(kept.truncate().length() < 1e-9 && lost.truncate().length() > 10.0, "{kept} {lost}");

    let soup = Mesh {
        vertices: (0..whole.triangles.len()).flat_map(|index| whole.corners(index)).collect(),
        triangles: (0..whole.triangles.len()).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect(),
    };
    assert_eq!(soup.closure().boundary_edges, 36);
    assert!(soup.welded(1e-6).closure().is_closed());
    assert_eq!(soup.welded(1e-6).vertices.len(), 8);
}

#[test]
fn the_skin_below_is_wetted() {
    let surface = Surface::of(&cuboid(SIZE), &water(DQuat::IDENTITY, 4.0));
    close(surface.wetted_area, 3000.0 + 4.0 * 260.0, 4040.0);
    close(surface.waterline_length, 260.0, 260.0);
    assert!((surface.waterline_high - surface.waterline_low - DVec3::new(100.0, 30.0, 0.0)).length() < 1e-9);
    assert!((surface.thrust - DVec3::Z * 12000.0).length() < 1e-8);
}

fn lump(seeds: &[f64]) -> Mesh {
    // A sphere with dents: not convex, of no symmetry, away from its origin.
    let mut mesh = sphere(3.0, 9);
    for (vertex, seed) in mesh.vertices.iter_mut().zip(seeds.iter().cycle()) {
        *vertex = *vertex * (1.0 + 0.25 * seed) + DVec3::new(4.0, -7.0, 2.0);
    }
    mesh
}

proptest! {
    #![proptest_config(cases(64))]

    /// Groups and columns against tetrahedra from one point of the plane, panel by panel; the pressure on the skin
    /// against both, with its moment.
    #[test]
    fn integrals_agree_with_another_way_to_them(
        seeds in prop::collection::vec(-1.0..1.0_f64, 83), n in prop::array::uniform3(-1.0..1.0_f64), d in -2.5..2.5_f64
    ) {
        let normal = DVec3::from_array(n).try_normalize().unwrap_or(DVec3::Z);
        let mesh = lump(&seeds);
        let plane = Plane { normal, height: d - normal.dot(DVec3::new(4.0, -7.0, 2.0)) };
        let apex = normal * -plane.height;
        let (mut volume, mut moment) = (0.0, DVec3::ZERO);
        for index in 0..mesh.triangles.len() {
            let corners = mesh.corners(index);
            let heights = corners.map(|corner| plane.above(corner));
            let area = (corners[1] - corners[0]).cross(corners[2] - corners[0]) / 2.0;
            let below = gantline_core::hull::panel::Panel { corners, heights, area }.below();
            for part in &below.parts[..below.count] {
                let [a, b, c] = part.corners.map(|corner| corner - apex);
                let six = a.dot(b.cross(c));
                volume += six / 6.0;
                moment += (part.corners.iter().sum::<DVec3>() + apex) * (six / 24.0);
            }
        }
        let found = Hull::new(&mesh).below(&plane);
        prop_assert!((found.volume - volume).abs() < 1e-11 * 100.0);
        prop_assert!((found.moment - moment).length() < 1e-11 * 1000.0);
        let depth = -(normal.dot(moment) + plane.height * volume);
        prop_assert!((found.depth_moment - depth).abs() < 1e-10 * 100.0);
        let surface = Surface::of(&mesh, &plane);
        prop_assert!((surface.thrust - normal * volume).length() < 1e-11 * 100.0);
        prop_assert!((surface.thrust_moment - moment.cross(normal)).length() < 1e-10 * 1000.0);
        prop_assert!(surface.waterline_gap.length() < 1e-12);
    }

    /// The section is the derivative of the volume over the level, and its moments those of the moment.
    #[test]
    fn sections_are_derivatives(
        seeds in prop::collection::vec(-1.0..1.0_f64, 83), n in prop::array::uniform3(-1.0..1.0_f64), d in -2.0..2.0_f64
    ) {
        let normal = DVec3::from_array(n).try_normalize().unwrap_or(DVec3::Z);
        let hull = Hull::new(&lump(&seeds));
        let height = d - normal.dot(DVec3::new(4.0, -7.0, 2.0));
        let at = |step: f64| hull.below(&Plane { normal, height: height + step });
        let (here, step) = (at(0.0), 1e-5);
        let (up, down) = (at(step), at(-step));
        // Volumes are cubic in the level between corners, and have a jump of their third derivative at them.
        let slope = (up.volume - down.volume) / (2.0 * step);
        prop_assert!((slope + here.area).abs() < 1e-6 * 30.0, "{slope} {}", here.area);
        let slope = (up.moment - down.moment) / (2.0 * step);
        prop_assert!((slope + here.area_moment).length() < 1e-6 * 300.0);
        let slope = (up.depth_moment - down.depth_moment) / (2.0 * step);
        prop_assert!((slope + here.volume).abs() < 1e-6 * 100.0);
        // Turning the plane about an axis through the origin: dV = −∫ (a × n)·x dA.
        let turned = |angle: f64| {
            let turn = DQuat::from_axis_angle(DVec3::Y, angle);
            hull.below(&Plane { normal: turn * normal, height })
        };
        let (left, right) = (turned(step), turned(-step));
        let change = DVec3::Y.cross(normal);
        let slope = (left.volume - right.volume) / (2.0 * step);
        prop_assert!((slope + change.dot(here.area_moment)).abs() < 1e-6 * 300.0);
        let slope = (left.moment - right.moment) / (2.0 * step);
        prop_assert!((slope + here.area_second * change).length() < 1e-6 * 3000.0);
    }
}
