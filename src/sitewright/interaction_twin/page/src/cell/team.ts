// All robots and end effectors together, in one posture: as sensed, or as a preview says.
import { Group, Matrix4, type Material } from "three";
import type { Description, EndEffectorRecord, Pose, Scene } from "../wire";
import { Arm } from "./arm";
import { Mechanism } from "./mechanism";
import { matrixOf } from "./poses";
import type { Shapes } from "./shapes";

const movable = (description: Description): number => description.joints.filter((joint) => joint.kind !== "fixed").length;

/** Materials by robot (index) and for tools. */
export interface TeamLook {
  arm(index: number): Material;
  tool: Material;
}

/** Robots by id, end effectors on a flange or docked. */
export class Team {
  readonly root = new Group();
  readonly arms = new Map<string, Arm>();
  readonly tools = new Map<string, Mechanism>();

  constructor(
    private readonly scene: Scene,
    shapes: Shapes,
    look: TeamLook,
  ) {
    scene.robots.forEach((record, index) => {
      const arm = new Arm(record, shapes, look.arm(index));
      this.arms.set(record.id, arm);
      this.root.add(arm.root);
    });
    for (const record of scene.end_effectors) this.tools.set(record.id, new Mechanism(record.description, shapes, look.tool));
    this.setAsDocumented();
  }

  setLook(look: TeamLook): void {
    this.scene.robots.forEach((record, index) => this.arms.get(record.id)?.body.setMaterial(look.arm(index)));
    for (const tool of this.tools.values()) tool.setMaterial(look.tool);
  }

  /** Shows all robots, or only some of them with what they carry. */
  setShown(isShown: (robot: string) => boolean): void {
    for (const [id, arm] of this.arms) arm.root.visible = isShown(id);
    const tips = new Set([...this.arms.values()].map((arm) => arm.tip));
    for (const tool of this.tools.values()) {
      tool.root.visible = (tool.root.parent !== null && tips.has(tool.root.parent)) || this.scene.robots.every((r) => isShown(r.id));
    }
  }

  /** Puts everything as the scene document has it. */
  setAsDocumented(): void {
    for (const record of this.scene.end_effectors) this.attach(record.id, record.on, record.world_T_mount);
    for (const record of this.scene.robots) this.arms.get(record.id)?.setPosture(record.q_rad);
    for (const record of this.scene.end_effectors) this.setTool(record.id, record.q);
  }

  /** Puts an end effector on a robot's flange, or at a pose of the site; with neither it is not shown. */
  attach(endEffector: string, robot: string | null, pose: Pose | null): void {
    const tool = this.tools.get(endEffector);
    if (tool === undefined) return;
    const tip = robot === null ? undefined : this.arms.get(robot)?.tip;
    tool.root.removeFromParent();
    if (tip !== undefined) {
      tool.root.matrix.identity();
      tip.add(tool.root);
    } else if (pose !== null) {
      matrixOf(pose, tool.root.matrix);
      this.root.add(tool.root);
    }
    tool.root.matrixWorldNeedsUpdate = true;
  }

  setPosture(robot: string, joints: ArrayLike<number>): void {
    this.arms.get(robot)?.setPosture(joints);
  }

  setTool(endEffector: string, joints: ArrayLike<number>): void {
    this.tools.get(endEffector)?.setJoints(joints);
  }

  /** Sets all joints in the order of `scene.joints`. */
  setJoints(values: ArrayLike<number>): void {
    let at = 0;
    for (const record of [...this.scene.robots, ...this.scene.end_effectors]) {
      const own = Array.from({ length: movable(record.description) }, (_, k) => values[at + k] ?? 0);
      at += own.length;
      if (this.arms.has(record.id)) this.setPosture(record.id, own);
      else this.setTool(record.id, own);
    }
  }

  /** Returns the pose of a robot's tip in the site. */
  tipOf(robot: string): Matrix4 {
    const arm = this.arms.get(robot);
    if (arm === undefined) throw new Error(`the scene has no robot ${robot}`);
    arm.root.updateMatrixWorld(true);
    return arm.tip.matrixWorld.clone();
  }

  /** Returns where a robot works: the tcp of its end effector, else its tip. */
  tcpOf(robot: string): Matrix4 {
    const tip = this.arms.get(robot)?.tip;
    for (const tool of this.tools.values()) {
      if (tip !== undefined && tool.root.parent === tip) {
        tip.updateWorldMatrix(true, true);
        return tool.tip.matrixWorld.clone();
      }
    }
    return this.tipOf(robot);
  }

  endEffectorOn(robot: string): EndEffectorRecord | undefined {
    const tip = this.arms.get(robot)?.tip;
    return this.scene.end_effectors.find((e) => this.tools.get(e.id)?.root.parent === tip);
  }
}
