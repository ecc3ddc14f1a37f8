/** Arrows of forces: supports push up at contacts, slings pull at their lower ends. */

import { Color, InstancedMesh, Matrix4, MeshBasicMaterial, Quaternion, Vector3 } from "three";
import type { Lift } from "../data/lift";
import { type Palette, rampInto } from "../theme";
import { arrowGeometry } from "./solids";

const LENGTH = 0.2; // of the size of the scene, for the largest force
const Z = new Vector3(0, 0, 1);

export class Arrows {
  readonly mesh: InstancedMesh;
  private readonly slings: number[];
  private readonly rgb = new Float32Array(3);

  constructor(
    private readonly lift: Lift,
    private readonly origin: readonly [number, number, number],
    private readonly size: number,
  ) {
    const { ropes, contacts, lugs } = lift.header;
    const held = new Set(lugs.map((lug) => lug.rope));
    this.slings = ropes.map((_, index) => index).filter((index) => held.has(ropes[index]!.name));
    const count = Math.max(1, contacts.length + this.slings.length);
    this.mesh = new InstancedMesh(arrowGeometry(), new MeshBasicMaterial(), count);
    this.mesh.frustumCulled = false;
    this.mesh.count = 0;
  }

  /** Largest force of a sling so far [N]: of a lift that runs it grows. */
  get largest(): number {
    const { ropes } = this.lift.header;
    return this.slings.reduce((most, index) => Math.max(most, ropes[index]!.peak), 1);
  }

  update(palette: Palette, tensionScale: number): void {
    this.mesh.count = 0;
    COLOUR.set(palette.contact);
    this.lift.contactForces.forEach((force, index) => {
      this.goTo(index);
      WAY.copy(Z);
      // It ends where it pushes.
      this.add(force, true, LENGTH * this.size);
    });
    for (const index of this.slings) {
      const tension = this.lift.tensions[index]!;
      if (tension <= 0) continue;
      const path = this.lift.drawnPath(index);
      const last = path.length - 3;
      FROM.set(path[last]!, path[last + 1]!, path[last + 2]!);
      WAY.set(path[last - 3]! - FROM.x, path[last - 2]! - FROM.y, path[last - 1]! - FROM.z).normalize();
      rampInto(palette, tension / tensionScale, this.rgb, 0);
      COLOUR.setRGB(this.rgb[0]!, this.rgb[1]!, this.rgb[2]!);
      // It stays within its sling.
      const reach = Math.hypot(
        path[last]! - path[0]!,
        path[last + 1]! - path[1]!,
        path[last + 2]! - path[2]!,
      );
      this.add(tension, false, Math.min(LENGTH * this.size, 0.45 * reach));
    }
    this.mesh.instanceMatrix.needsUpdate = true;
    if (this.mesh.instanceColor) this.mesh.instanceColor.needsUpdate = true;
  }

  /** Where arrows of pushes begin at present, x y z after each other, about the middle of the scene. */
  tails(): number[] {
    const [x, y, z] = this.origin;
    return [...this.lift.contactForces].flatMap((force, index) => {
      const length = this.lengthOf(force, LENGTH * this.size);
      if (length === 0) return [];
      this.goTo(index);
      return [FROM.x - x, FROM.y - y, FROM.z - z - length];
    });
  }

  /** `FROM` goes to where a contact pushes. */
  private goTo(index: number): void {
    const { header, poses } = this.lift;
    const contact = header.contacts[index]!;
    const { cog } = header.bodies[contact.body]!;
    const at = 7 * contact.body;
    FROM.set(contact.at[0] - cog[0], contact.at[1] - cog[1], contact.at[2] - cog[2]);
    FROM.applyQuaternion(TURN.set(poses[at + 4]!, poses[at + 5]!, poses[at + 6]!, poses[at + 3]!));
    FROM.set(FROM.x + poses[at]!, FROM.y + poses[at + 1]!, FROM.z + poses[at + 2]!);
  }

  /** How long the arrow of a force is; 0 of one that has none. The largest force has the longest. */
  private lengthOf(force: number, longest: number): number {
    return force > 0.005 * this.largest ? longest * Math.min(1.2, force / this.largest) : 0;
  }

  /** An arrow of a force along `WAY`, which begins (or ends) at `FROM`. */
  private add(force: number, endsThere: boolean, longest: number): void {
    const length = this.lengthOf(force, longest);
    if (length === 0) return;
    if (endsThere) FROM.addScaledVector(WAY, -length);
    FROM.set(FROM.x - this.origin[0], FROM.y - this.origin[1], FROM.z - this.origin[2]);
    const thickness = Math.min(0.16 * this.size, 0.9 * length);
    PLACED.compose(FROM, TURN.setFromUnitVectors(Z, WAY), SCALE.set(thickness, thickness, length));
    this.mesh.setMatrixAt(this.mesh.count, PLACED);
    this.mesh.setColorAt(this.mesh.count, COLOUR);
    this.mesh.count += 1;
  }
}

const FROM = new Vector3();
const WAY = new Vector3();
const SCALE = new Vector3();
const TURN = new Quaternion();
const COLOUR = new Color();
const PLACED = new Matrix4();
