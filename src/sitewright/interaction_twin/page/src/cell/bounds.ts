// What the eye is put to: the building, or where robots stand and pieces lie.
import { Box3, Vector3 } from "three";
import type { ComponentRecord, Scene } from "../wire";

/** Returns what is to be built and what is built, all of it as bodies. */
export function asBuilding(scene: Scene): ComponentRecord[] {
  return scene.components.filter((c) => c.layer === "target" || c.layer === "as_built").map((c) => ({ ...c, layer: "as_built" }));
}

export function boundsOf(scene: Scene): Box3 {
  const bounds = new Box3();
  for (const robot of scene.robots) bounds.expandByPoint(new Vector3(...robot.world_T_base.p_m));
  for (const { world_T } of scene.components) if (world_T !== null) bounds.expandByPoint(new Vector3(...world_T.p_m));
  return bounds;
}

export function boxOf(components: readonly ComponentRecord[]): Box3 {
  const box = new Box3();
  for (const { world_T } of components) if (world_T !== null) box.expandByPoint(new Vector3(...world_T.p_m));
  return box.isEmpty() ? new Box3(new Vector3(-1, -1, 0), new Vector3(1, 1, 1)) : box.expandByScalar(1.0);
}

/** Returns the box that the eye is put to: where robots stand and pieces lie, with room for arms. */
export function lookedAt(scene: Scene, bounds: Box3): Box3 {
  const box = bounds.clone();
  for (const robot of scene.robots) {
    const base = new Vector3(...robot.world_T_base.p_m);
    box.expandByPoint(base.clone().add(new Vector3(0, 0, 2.1)));
  }
  return box.expandByVector(new Vector3(0.35, 0.25, 0));
}
