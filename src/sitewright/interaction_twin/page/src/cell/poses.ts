// Poses of the wire as matrices of three.js.
import { Matrix4, Quaternion, Vector3 } from "three";
import type { Pose } from "../wire";

const ONE = new Vector3(1, 1, 1);

export function matrixOf(pose: Pose, into = new Matrix4()): Matrix4 {
  const [w, x, y, z] = pose.q_wxyz;
  return into.compose(new Vector3(...pose.p_m), new Quaternion(x, y, z, w), ONE);
}
