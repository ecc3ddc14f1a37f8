import { readFileSync } from "node:fs";
import { join } from "node:path";
import validator from "gltf-validator";
import { AnimationMixer, Box3, Quaternion, Vector3 } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { expect, it } from "vitest";
import { expected } from "./chromium";

const read = (name: string) => readFileSync(join(process.env.GANTLINE_PAGES!, name));
const file = read("lift.glb");

it.each(["lift.glb", "watched.glb"])("is right by the validator of the Khronos Group: %s", async (name) => {
  const { issues, info } = await validator.validateBytes(new Uint8Array(read(name)));
  expect(issues.messages.filter((message) => message.severity < 2)).toEqual([]);
  expect(info.animationCount).toBe(1);
});

it("has supports until they are taken away, and the water at its level", async () => {
  const watched = read("watched.glb");
  const bytes = watched.buffer.slice(watched.byteOffset, watched.byteOffset + watched.byteLength);
  const { scene, animations } = await new GLTFLoader().parseAsync(bytes as ArrayBuffer, "");
  const mixer = new AnimationMixer(scene);
  mixer.clipAction(animations[0]!).play();
  const support = scene.getObjectByName("supportkeel11")!;
  mixer.setTime(7.5);
  expect(support.scale.x).toBe(1);
  mixer.setTime(8.5);
  expect(support.scale.x).toBe(0);
  scene.updateMatrixWorld();
  // The y of glTF is the z of the recording.
  const water = new Box3().setFromObject(scene.getObjectByName("water")!);
  expect([water.min.y, water.max.y]).toEqual([expect.closeTo(-1, 6), expect.closeTo(-1, 6)]);
  const wall = new Box3().setFromObject(scene.getObjectByName("wall")!);
  expect(wall.min.x).toBeCloseTo(4.5, 6);
  expect(wall.max.y).toBeCloseTo(6, 6);
});

it("plays in three.js with the poses of the recording", async () => {
  const bytes = file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength);
  const { scene, animations } = await new GLTFLoader().parseAsync(bytes as ArrayBuffer, "");
  const mixer = new AnimationMixer(scene);
  mixer.clipAction(animations[0]!).play();
  const { frames, bodies } = expected();
  // The last time is where the animation begins again.
  frames.slice(0, -1).forEach((time, frame) => {
    mixer.setTime(time);
    for (const [name, poses] of Object.entries(bodies)) {
      const node = scene.getObjectByName(name.replace(/[[\].:/]/g, ""))!; // three.js leaves these signs out
      const { position, orientation } = poses[frame]!;
      expect(node.position.distanceTo(new Vector3(...(position as [number, number, number])))).toBeLessThan(
        1e-5,
      );
      const [w, x, y, z] = orientation as [number, number, number, number];
      expect(node.quaternion.angleTo(new Quaternion(x, y, z, w))).toBeLessThan(2e-3);
      const off = 1 - Math.abs(node.quaternion.dot(new Quaternion(x, y, z, w)));
      expect(off).toBeLessThan(1e-10); // half the square of half the angle: 3e-5 rad
    }
  });
});
