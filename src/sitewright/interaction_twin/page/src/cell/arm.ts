// A robot at its place; what is on its flange hangs on its tip.
import { Group, type Material, type Mesh, type Object3D } from "three";
import type { RobotRecord } from "../wire";
import { Mechanism } from "./mechanism";
import { matrixOf } from "./poses";
import type { Shapes } from "./shapes";

/** One arm, in any posture and in one of several materials. */
export class Arm {
  readonly root = new Group();
  readonly body: Mechanism;
  isOffLimits = false;
  joints: number[] = [];

  constructor(
    readonly record: RobotRecord,
    shapes: Shapes,
    material: Material,
  ) {
    this.body = new Mechanism(record.description, shapes, material);
    matrixOf(record.world_T_base, this.root.matrix);
    this.root.matrixAutoUpdate = false;
    this.root.add(this.body.root);
  }

  get tip(): Object3D {
    return this.body.tip;
  }

  get meshes(): Mesh[] {
    return this.body.meshes;
  }

  /** Sets the posture; joints out of their limits are a fault that is shown. */
  setPosture(joints: ArrayLike<number>): void {
    this.joints = Array.from(joints);
    this.isOffLimits = this.body.setJoints(joints).length > 0;
    this.root.updateMatrixWorld(true);
  }
}
