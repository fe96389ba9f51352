// Components as instances: one mesh and one set of edges per shape and look, whatever their number.
import { Color, Group, InstancedMesh, LineSegments, Matrix4, type Intersection } from "three";
import type { ComponentRecord } from "../wire";
import { colourOf, edgeMaterial, lookOf, pieceMaterial, type PieceLook } from "./looks";
import { matrixOf } from "./poses";
import type { Shapes } from "./shapes";

interface Batch {
  mesh: InstancedMesh;
  members: ComponentRecord[];
}

interface Slot {
  batch: Batch;
  index: number;
}

const NOWHERE = new Matrix4().makeScale(0, 0, 0);

/** All components with a shape; hidden ones have no size. */
export class Pieces {
  readonly root = new Group();
  private readonly slots = new Map<string, Slot>();
  private readonly poses = new Map<string, Matrix4>();
  private readonly hidden = new Set<string>();
  private readonly lit = new Map<string, string>();

  constructor(components: readonly ComponentRecord[], shapes: Shapes) {
    const groups = new Map<string, ComponentRecord[]>();
    for (const component of components) {
      if (component.geometry === null || component.world_T === null) continue;
      const name = `${lookOf(component)}/${component.geometry}`;
      groups.set(name, [...(groups.get(name) ?? []), component]);
    }
    for (const members of groups.values()) this.addBatch(members, shapes);
  }

  has(id: string): boolean {
    return this.slots.has(id);
  }

  poseOf(id: string): Matrix4 | undefined {
    return this.poses.get(id);
  }

  /** Returns the pose of a component that is shown. */
  seenPoseOf(id: string): Matrix4 | undefined {
    return this.hidden.has(id) ? undefined : this.poses.get(id);
  }

  setPose(id: string, world_T: Matrix4): void {
    this.poses.set(id, world_T.clone());
    this.place(id);
  }

  /** Shows only what `isShown` says. */
  setShown(isShown: (component: ComponentRecord) => boolean): void {
    for (const [id, slot] of this.slots) {
      const member = slot.batch.members[slot.index];
      if (member === undefined) continue;
      if (isShown(member)) this.hidden.delete(id);
      else this.hidden.add(id);
      this.place(id);
    }
  }

  /** Lights components in a colour: the selected one, blockers. */
  setLit(colourById: ReadonlyMap<string, string>): void {
    const changed = new Set([...this.lit.keys(), ...colourById.keys()]);
    this.lit.clear();
    for (const [id, colour] of colourById) this.lit.set(id, colour);
    for (const id of changed) this.paint(id);
  }

  /** Returns the component that a ray hit. */
  componentAt(hit: Intersection): ComponentRecord | undefined {
    const batch = [...this.slots.values()].find((slot) => slot.batch.mesh === hit.object)?.batch;
    return hit.instanceId === undefined ? undefined : batch?.members[hit.instanceId];
  }

  get meshes(): InstancedMesh[] {
    return [...new Set([...this.slots.values()].map((slot) => slot.batch.mesh))];
  }

  dispose(): void {
    for (const mesh of this.meshes) mesh.dispose();
  }

  private addBatch(members: ComponentRecord[], shapes: Shapes): void {
    const first = members[0];
    if (first?.geometry == null) return;
    const look = lookOf(first);
    const mesh = new InstancedMesh(shapes.solid(first.geometry), pieceMaterial(look), members.length);
    mesh.castShadow = mesh.receiveShadow = look === "solid";
    mesh.renderOrder = look === "solid" ? 0 : 1;
    mesh.frustumCulled = false; // instances move; their common sphere would be stale
    const batch = { mesh, members };
    members.forEach((member, index) => {
      this.slots.set(member.id, { batch, index });
      if (member.world_T !== null) this.poses.set(member.id, matrixOf(member.world_T));
      this.place(member.id);
      this.paint(member.id);
    });
    this.root.add(mesh, edgesOf(mesh, first, look, shapes));
  }

  private place(id: string): void {
    const slot = this.slots.get(id);
    const pose = this.poses.get(id);
    if (slot === undefined || pose === undefined) return;
    slot.batch.mesh.setMatrixAt(slot.index, this.hidden.has(id) ? NOWHERE : pose);
    slot.batch.mesh.instanceMatrix.needsUpdate = true;
    slot.batch.mesh.boundingSphere = null; // or rays miss what has moved
  }

  private paint(id: string): void {
    const slot = this.slots.get(id);
    const member = slot?.batch.members[slot.index];
    if (slot === undefined || member === undefined) return;
    slot.batch.mesh.setColorAt(slot.index, new Color(this.lit.get(id) ?? colourOf(member)));
    if (slot.batch.mesh.instanceColor !== null) slot.batch.mesh.instanceColor.needsUpdate = true;
  }
}

/** Returns edges that share the instances' matrices: the renderer draws any object that says it is instanced. */
function edgesOf(mesh: InstancedMesh, first: ComponentRecord, look: PieceLook, shapes: Shapes): LineSegments {
  if (first.geometry === null) throw new Error(`${first.id} has no shape`);
  const lines = new LineSegments(shapes.edge(first.geometry), edgeMaterial(look));
  Object.assign(lines, {
    isInstancedMesh: true,
    instanceMatrix: mesh.instanceMatrix,
    instanceColor: null,
    morphTexture: null,
    count: mesh.count,
  });
  lines.frustumCulled = false;
  lines.raycast = () => undefined;
  lines.renderOrder = 2;
  return lines;
}
