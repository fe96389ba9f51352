// A robot or an end effector that moves as its joints say: forward kinematics by a tree of nodes.
import { Group, Matrix4, Mesh, Object3D, Quaternion, Vector3, type Material } from "three";
import type { Description, JointRecord } from "../wire";
import { matrixOf } from "./poses";
import type { Shapes } from "./shapes";

interface Axis {
  record: JointRecord;
  node: Object3D;
  rest: Matrix4;
  axis: Vector3;
}

/** Links as meshes; the joints that move are set in the order of the description. */
export class Mechanism {
  readonly root = new Group();
  readonly tip: Object3D;
  readonly meshes: Mesh[] = [];
  private readonly axes: Axis[] = [];
  private readonly turn = new Quaternion();
  private readonly move = new Matrix4();

  constructor(description: Description, shapes: Shapes, material: Material) {
    const nodes = new Map<string, Object3D>([[description.root, this.root]]);
    for (const record of description.joints) {
      const parent = nodes.get(record.parent);
      if (parent === undefined) throw new Error(`joint ${record.name} comes before its parent ${record.parent}`);
      const node = new Group();
      node.matrixAutoUpdate = false;
      matrixOf(record.parent_T_joint, node.matrix);
      parent.add(node);
      nodes.set(record.child, node);
      if (record.kind !== "fixed") {
        this.axes.push({ record, node, rest: node.matrix.clone(), axis: new Vector3(...record.axis) });
      }
    }
    for (const link of description.links) {
      if (link.geometry === null) continue;
      const mesh = new Mesh(shapes.solid(link.geometry), material);
      mesh.name = link.name;
      mesh.castShadow = mesh.receiveShadow = true;
      nodes.get(link.name)?.add(mesh);
      this.meshes.push(mesh);
    }
    this.root.matrixAutoUpdate = false;
    this.tip = nodes.get(description.tip) ?? this.root;
  }

  get jointCount(): number {
    return this.axes.length;
  }

  /** Where the mechanism stands: before its first turning joint, so that a base on a rail is found. */
  get foot(): Object3D {
    return this.axes.find((axis) => axis.record.kind === "revolute")?.node.parent ?? this.root;
  }

  /** Sets joint values (radians, metres if prismatic) and returns the names of those out of their limits. */
  setJoints(values: ArrayLike<number>): string[] {
    const out: string[] = [];
    this.axes.forEach((axis, index) => {
      const value = values[index] ?? 0;
      if (axis.record.kind === "revolute") {
        this.move.makeRotationFromQuaternion(this.turn.setFromAxisAngle(axis.axis, value));
      } else {
        this.move.makeTranslation(axis.axis.x * value, axis.axis.y * value, axis.axis.z * value);
      }
      axis.node.matrix.multiplyMatrices(axis.rest, this.move);
      axis.node.matrixWorldNeedsUpdate = true;
      if (value < axis.record.lower_rad - 1e-4 || value > axis.record.upper_rad + 1e-4) out.push(axis.record.name);
    });
    return out;
  }

  setMaterial(material: Material): void {
    for (const mesh of this.meshes) mesh.material = material;
  }
}
