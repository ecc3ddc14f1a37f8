import { readFileSync } from "node:fs";
import { join } from "node:path";
import validator from "gltf-validator";
import { AnimationMixer, Quaternion, Vector3 } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { expect, it } from "vitest";
import { expected } from "./chromium";

const file = readFileSync(join(process.env.GANTLINE_PAGES!, "lift.glb"));

it("is right by the validator of the Khronos Group", async () => {
  const { issues, info } = await validator.validateBytes(new Uint8Array(file));
  expect(issues.messages.filter((message) => message.severity < 2)).toEqual([]);
  expect(info.animationCount).toBe(1);
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
