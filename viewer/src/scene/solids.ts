/** Geometry of what has a body: boxes, meshes, convex hulls, sheaves, hooks, arrows. */

import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  ExtrudeGeometry,
  Shape as Outline,
  Path,
  TorusGeometry,
  Vector3,
} from "three";
import { ConvexGeometry } from "three/examples/jsm/geometries/ConvexGeometry.js";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { Box, Shape } from "../data/format";
import type { Lift } from "../data/lift";

/** Height of the sign for a hook without a size, and of its top over where it bears, of the size of the scene. */
export const SIGN = 0.055;
export const SIGN_HIGH = 1.05 * SIGN;
/** Half its width. */
export const SIGN_WIDE = 0.21 * SIGN;

/** Radius of the mark of a hinge, of the size of the scene. */
export const PIN = 0.013;

/** Geometry of a shape in the frame of its body. */
export function geometryOf(shape: Shape, lift: Lift): BufferGeometry {
  if (shape.type === "box") return boxGeometry(shape);
  if (shape.type === "boxes") return merged(shape.boxes.map(boxGeometry));
  const vertices = lift.array(`${shape.arrays}.vertices`) as Float32Array;
  if (shape.type === "convex") {
    const points: Vector3[] = [];
    for (let at = 0; at < vertices.length; at += 3) points.push(new Vector3().fromArray(vertices, at));
    return new ConvexGeometry(points);
  }
  const indexed = new BufferGeometry();
  indexed.setAttribute("position", new BufferAttribute(Float32Array.from(vertices), 3));
  indexed.setIndex(
    new BufferAttribute(Uint32Array.from(lift.array(`${shape.arrays}.faces`) as Uint32Array), 1),
  );
  const flat = indexed.toNonIndexed();
  flat.computeVertexNormals();
  return flat;
}

/** Corners of the box around a shape, in the frame of its body, x y z after each other [m]. */
export function cornersOf(shape: Shape, lift: Lift): number[] {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  const hold = (axis: number, from: number, to: number) => {
    low[axis] = Math.min(low[axis]!, from);
    high[axis] = Math.max(high[axis]!, to);
  };
  if (shape.type === "box" || shape.type === "boxes") {
    for (const { size, centre } of shape.type === "box" ? [shape] : shape.boxes)
      for (let axis = 0; axis < 3; axis++)
        hold(axis, centre[axis]! - size[axis]! / 2, centre[axis]! + size[axis]! / 2);
  } else {
    const vertices = lift.array(`${shape.arrays}.vertices`) as Float32Array;
    vertices.forEach((part, place) => {
      hold(place % 3, part, part);
    });
  }
  const corners: number[] = [];
  for (const x of [low[0]!, high[0]!])
    for (const y of [low[1]!, high[1]!]) for (const z of [low[2]!, high[2]!]) corners.push(x, y, z);
  return corners;
}

function boxGeometry(box: Box): BufferGeometry {
  return new BoxGeometry(...box.size).translate(...box.centre);
}

/** The mark of a hinge: a pin along y, and a ring about it whose radius is 1. */
export function hingeGeometry(): BufferGeometry {
  const ring = new TorusGeometry(0.8, 0.2, 10, 28).toNonIndexed();
  const pin = new CylinderGeometry(0.3, 0.3, 2.6, 16).toNonIndexed();
  return merged([ring.rotateX(Math.PI / 2), pin]);
}

/** A sheave of radius 1 about z, with five holes that show how it turns. */
export function sheaveGeometry(): BufferGeometry {
  const rim = new Outline().absarc(0, 0, 0.98, 0, 2 * Math.PI, false);
  for (let hole = 0; hole < 5; hole++) {
    const angle = (2 * Math.PI * hole) / 5;
    const opening = new Path();
    opening.absarc(0.57 * Math.cos(angle), 0.57 * Math.sin(angle), 0.21, 0, 2 * Math.PI, true);
    rim.holes.push(opening);
  }
  const disc = new ExtrudeGeometry(rim, { depth: SHEAVE_DEPTH, bevelEnabled: false, curveSegments: 20 });
  disc.translate(0, 0, -SHEAVE_DEPTH / 2);
  const pin = new CylinderGeometry(0.14, 0.14, 0.5, 16).rotateX(Math.PI / 2);
  return merged([disc, pin]);
}

/** The same of few triangles: a rim that is cut square shows how it turns. */
export function plainSheaveGeometry(): BufferGeometry {
  const rim = new Outline();
  for (let corner = 0; corner < 12; corner++) {
    const radius = corner % 4 === 0 ? 0.8 : 0.98;
    const angle = (2 * Math.PI * corner) / 12;
    rim.lineTo(radius * Math.cos(angle), radius * Math.sin(angle));
  }
  const disc = new ExtrudeGeometry(rim, { depth: SHEAVE_DEPTH, bevelEnabled: false });
  return disc.translate(0, 0, -SHEAVE_DEPTH / 2);
}

const SHEAVE_DEPTH = 0.22; // of the radius

/** The convex hull of a geometry; the geometry itself where it is flat. */
export function hullOf(geometry: BufferGeometry): BufferGeometry {
  const places = geometry.attributes.position!;
  const known = new Map<string, Vector3>();
  for (let at = 0; at < places.count; at++)
    known.set(
      `${places.getX(at)},${places.getY(at)},${places.getZ(at)}`,
      new Vector3().fromBufferAttribute(places, at),
    );
  const hull = new ConvexGeometry([...known.values()]);
  return hull.attributes.position!.count > 0 ? hull : geometry;
}

/** A hook block of height 1 whose hook bears at the origin. */
export function hookGeometry(): BufferGeometry {
  const cheeks = new BoxGeometry(0.42, 0.3, 0.6).translate(0, 0, 0.75);
  const shank = new CylinderGeometry(0.07, 0.07, 0.3, 12).rotateX(Math.PI / 2).translate(0, 0, 0.35);
  const bend = new Outline();
  bend.absarc(0, 0.02, 0.2, (75 * Math.PI) / 180, (395 * Math.PI) / 180, false);
  bend.absarc(0, 0.02, 0.1, (395 * Math.PI) / 180, (75 * Math.PI) / 180, true);
  const hook = new ExtrudeGeometry(bend, { depth: 0.1, bevelEnabled: false, curveSegments: 16 });
  hook.translate(0, 0, -0.05).rotateX(Math.PI / 2);
  return merged([cheeks, shank, hook]);
}

/** An arrow of length 1 along z from the origin, thin. */
export function arrowGeometry(): BufferGeometry {
  const shaft = new CylinderGeometry(0.022, 0.022, 0.75, 10).rotateX(Math.PI / 2).translate(0, 0, 0.375);
  const head = new ConeGeometry(0.065, 0.25, 14).rotateX(Math.PI / 2).translate(0, 0, 0.875);
  return merged([shaft, head]);
}

function merged(parts: BufferGeometry[]): BufferGeometry {
  return mergeGeometries(parts.map((part) => (part.index ? part.toNonIndexed() : part)));
}
