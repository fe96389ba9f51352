// A refused moment in the picture: robots as ghosts where it was tried, and the two that came too near, lit.
import { Box3, Group, Matrix4, Mesh, Vector3, type Material, type Object3D } from "three";
import type { Posture, Scene } from "../wire";
import { bodyMaterial, COLOUR, veil } from "./looks";
import type { Pieces } from "./pieces";
import { matrixOf } from "./poses";
import type { Shapes } from "./shapes";
import type { Team, TeamLook } from "./team";

/** What is looked at: two bodies by name, and where they were if that is known. */
export interface Refused {
  pair: readonly string[];
  posture: Posture | null;
}

const LIT = bodyMaterial(COLOUR.blocker);
const LIT_PIECE = veil(COLOUR.blocker, 0.72);
const REFUSED = veil(COLOUR.underWay, 0.42);
const LOOK: TeamLook = { arm: () => REFUSED, tool: REFUSED };
const FADED = veil(COLOUR.stale, 0.14);
const CARRIED = veil(COLOUR.underWay, 0.55);
const LEAST_M = 0.7;

export interface Cell {
  scene: Scene;
  shapes: Shapes;
  ghosts: Team;
  live: Team;
  pieces: Pieces;
  still: Object3D;
}

/** Poses ghosts, lights the pair and says where it is; what it adds of its own hangs on `root`. */
export class Clash {
  readonly root = new Group();
  /** Pieces that are lit where they lie. */
  readonly lit = new Set<string>();
  /** The bodies of the pair that are lit. */
  readonly names: string[] = [];
  private readonly placed = new Set<string>();
  private readonly found: Box3[] = [];
  private readonly before = new Map<Mesh, Material | Material[]>();

  constructor(
    private readonly cell: Cell,
    { pair, posture }: Refused,
  ) {
    const { ghosts, live } = cell;
    ghosts.setLook(LOOK);
    ghosts.setAsDocumented();
    const moved = posture?.q_rad ?? {};
    for (const body of posture?.bodies ?? []) ghosts.attach(body.body, body.on, body.pose);
    for (const [robot, joints] of Object.entries(moved)) {
      ghosts.setPosture(robot, joints);
      const tool = live.tools.get(live.endEffectorOn(robot)?.id ?? "");
      for (const mesh of [...(live.arms.get(robot)?.meshes ?? []), ...(tool?.meshes ?? [])]) this.paint(mesh, FADED);
    }
    ghosts.setShown((robot) => robot in moved);
    ghosts.root.visible = posture !== null;
    ghosts.root.updateMatrixWorld(true);
    this.placeBodies(posture, new Set(pair));
    for (const name of pair) this.light(name, moved);
  }

  /** Postures of the ghosts, by robot. */
  get postures(): Record<string, number[]> {
    const { ghosts } = this.cell;
    return Object.fromEntries([...ghosts.arms].filter(([, arm]) => arm.root.visible && ghosts.root.visible).map(([id, arm]) => [id, arm.joints]));
  }

  /** The box to look at; null if none of the two is in the scene. */
  get box(): Box3 | null {
    return boxAround(this.found);
  }

  /** Gives back what was lit, and takes away what was added. */
  putAway(): void {
    this.root.removeFromParent();
    for (const [mesh, material] of this.before) mesh.material = material;
  }

  private paint(mesh: Mesh, material: Material): void {
    if (!this.before.has(mesh)) this.before.set(mesh, mesh.material);
    mesh.material = material;
  }

  private placeBodies(posture: Posture | null, pair: ReadonlySet<string>): void {
    for (const { body, on, pose } of posture?.bodies ?? []) {
      const geometry = this.cell.scene.components.find((c) => c.id === body)?.geometry;
      if (geometry == null) continue;
      const world = on === null ? matrixOf(pose) : this.cell.ghosts.tipOf(on).multiply(matrixOf(pose));
      const mesh = new Mesh(this.cell.shapes.solid(geometry), pair.has(body) ? LIT_PIECE : CARRIED);
      mesh.applyMatrix4(world);
      mesh.raycast = () => undefined;
      this.root.add(mesh);
      this.placed.add(body);
      if (pair.has(body)) this.found.push(new Box3().setFromObject(mesh));
    }
  }

  private light(name: string, moved: Readonly<Record<string, unknown>>): void {
    const [own = "", link] = name.split("/");
    const boxes = [...this.lightMeshes(own, link, moved), ...this.lightPiece(own)];
    this.found.push(...boxes);
    if (boxes.length > 0 || this.placed.has(own)) this.names.push(name);
  }

  /** Lights links of a robot, a tool, a fixture or a zone. */
  private lightMeshes(own: string, link: string | undefined, moved: Readonly<Record<string, unknown>>): Box3[] {
    const { ghosts, live, still } = this.cell;
    const arm = (own in moved ? ghosts : live).arms.get(own);
    const isTried = Object.keys(moved).some((robot) => ghosts.endEffectorOn(robot)?.id === own);
    const tool = (isTried ? ghosts : live).tools.get(own);
    const links = (arm ?? tool)?.meshes.filter((mesh) => arm === undefined || link === undefined || mesh.name === link) ?? [];
    const bodies = (still.getObjectByName(own)?.children ?? []).filter((child) => child instanceof Mesh);
    for (const mesh of links) this.paint(mesh, LIT);
    for (const mesh of bodies) this.paint(mesh, LIT_PIECE);
    return [...links, ...bodies].map((mesh) => new Box3().setFromObject(mesh));
  }

  /** Lights a piece where it lies, unless it was somewhere else when it was tried. */
  private lightPiece(own: string): Box3[] {
    const { scene, shapes, pieces } = this.cell;
    const pose = pieces.poseOf(own);
    const geometry = scene.components.find((c) => c.id === own)?.geometry;
    if (this.placed.has(own) || pose === undefined || geometry == null) return [];
    this.lit.add(own);
    return [boxOf(shapes, geometry, pose)];
  }
}

function boxOf(shapes: Shapes, geometry: string, pose: Matrix4): Box3 {
  const solid = shapes.solid(geometry);
  solid.computeBoundingBox();
  return (solid.boundingBox ?? new Box3()).clone().applyMatrix4(pose);
}

/** Returns the smallest of some boxes with what of the others is near it: a floor is not looked at as a whole. */
function boxAround(boxes: readonly Box3[]): Box3 | null {
  const [smallest] = [...boxes].sort((a, b) => a.getSize(new Vector3()).length() - b.getSize(new Vector3()).length());
  if (smallest === undefined) return null;
  const near = smallest.clone().expandByScalar(LEAST_M);
  const found = smallest.clone();
  for (const box of boxes) if (box.intersectsBox(near)) found.union(box.clone().intersect(near));
  return found.expandByScalar(LEAST_M / 2);
}
