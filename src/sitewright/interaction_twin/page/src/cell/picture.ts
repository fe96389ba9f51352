// The cell as a picture: robots as sensed or as rehearsed, components, zones, the way of a step.
import { BoxGeometry, CatmullRomCurve3, Group, Matrix4, Mesh, TubeGeometry, Vector3, type Intersection, type Object3D } from "three";
import type { Rehearsal } from "../preview/rehearsal";
import type { Replay } from "../preview/replay";
import type { ComponentRecord, Scene, StepRecord, Vec3 } from "../wire";
import type { View } from "./camera";
import { Clash, type Refused } from "./clash";
import { asBuilding, boundsOf, boxOf, lookedAt } from "./bounds";
import { bodyColour, bodyMaterial, COLOUR, veil } from "./looks";
import { Pieces } from "./pieces";
import { matrixOf } from "./poses";
import { Shapes } from "./shapes";
import { Stage } from "./stage";
import { ground, lightUp, surroundings } from "./surroundings";
import { Then } from "./then";
import { Team, type TeamLook } from "./team";

export type Mode = "now" | "preview" | "replay" | "target" | "as-built";

export interface Tag {
  id: string;
  number: number;
  x: number;
  y: number;
}

const TOOL = bodyMaterial(COLOUR.tool);
const SOLID: TeamLook = { arm: (index) => ARM[index % ARM.length] ?? TOOL, tool: TOOL };
const ARM = Array.from({ length: 6 }, (_, index) => bodyMaterial(bodyColour(index)));
const GREY = bodyMaterial(COLOUR.stale);
const STALE: TeamLook = { arm: () => GREY, tool: GREY };
const VEIL = veil(COLOUR.path, 0.32);
const GHOST: TeamLook = { arm: () => VEIL, tool: VEIL };
const PATH = bodyMaterial(COLOUR.path);
const LIT = bodyMaterial(COLOUR.blocker);
const NOTHING: ReadonlySet<string> = new Set();

/** Holds the parts of the picture and puts them as it is told. */
export class CellPicture {
  readonly stage: Stage;
  onPick: (component: string | null) => void = () => undefined;
  onGround: (x: number, y: number) => void = () => undefined;
  private scene: Scene | null = null;
  private parts = new Group();
  private zones: Object3D[] = [];
  private shapes = new Shapes({});
  private live: Team | null = null;
  private rehearsed: Team | null = null;
  private pieces: Pieces | null = null;
  private building: Pieces | null = null;
  private rehearsal: Rehearsal | null = null;
  private then: Then | null = null;
  private still = new Group();
  private refused: Refused | null = null;
  private clash: Clash | null = null;
  private comeBack: (() => void) | null = null;
  private lit: ReadonlyMap<string, string> = new Map();
  private litThings = NOTHING;
  private readonly path = new Mesh(undefined, PATH);
  private readonly draft = new Mesh(new BoxGeometry(1, 1, 1), veil(COLOUR.keepOut, 0.35));
  private mode: Mode = "now";
  private time_s = 0;
  private step: StepRecord | null = null;
  private isStale = false;
  private followed: string | null = null;
  private isShown: (component: ComponentRecord) => boolean = () => true;
  private readonly sensed = new Map<string, Matrix4>();

  constructor(canvas: HTMLCanvasElement, frame: HTMLElement, pixelRatio: number) {
    this.stage = new Stage(canvas, frame, pixelRatio);
    this.stage.onTap = (hits) => this.pick(hits);
    this.path.raycast = () => undefined;
    this.path.visible = false;
    this.draft.raycast = () => undefined;
    this.draft.visible = false;
    this.stage.world.add(this.path, this.draft);
  }

  /** Builds the picture of a scene document anew; the eye stays where it is after the first. */
  setScene(scene: Scene): void {
    const isFirst = this.scene === null;
    this.clear();
    this.scene = scene;
    this.shapes = new Shapes(scene.geometries);
    this.live = new Team(scene, this.shapes, SOLID);
    this.rehearsed = new Team(scene, this.shapes, GHOST);
    this.rehearsed.root.traverse((node) => {
      node.raycast = () => undefined;
    });
    this.pieces = new Pieces(scene.components, this.shapes);
    this.building = new Pieces(asBuilding(scene), this.shapes);
    this.still = surroundings(scene, this.shapes);
    this.zones = this.still.children.filter((child) => child.userData["isZone"] === true);
    this.parts = new Group().add(this.still, this.live.root, this.rehearsed.root, this.pieces.root, this.building.root);
    this.stage.world.add(this.parts);
    const bounds = boundsOf(scene);
    this.parts.add(ground(scene.ground_z_m));
    this.stage.setBounds(lookedAt(scene, bounds));
    if (isFirst) this.stage.camera.look("whole");
    this.refresh();
  }

  get team(): Team | null {
    return this.rehearsed;
  }

  get sensedPoses(): ReadonlyMap<string, Matrix4> {
    const documented = this.scene?.components.flatMap((c) => (c.world_T === null ? [] : [[c.id, matrixOf(c.world_T)] as const])) ?? [];
    return new Map([...documented, ...this.sensed]);
  }

  setJoints(values: ArrayLike<number>): void {
    this.live?.setJoints(values);
    if (this.followed !== null && this.live !== null && this.mode === "now") {
      this.stage.camera.follow(new Vector3().setFromMatrixPosition(this.live.tcpOf(this.followed)));
    }
    this.stage.ask();
  }

  /** Takes the poses of all pieces that are not where the document has them. */
  setSensedPoses(poses: ReadonlyMap<string, Matrix4>): void {
    const gone = [...this.sensed.keys()].filter((id) => !poses.has(id));
    this.sensed.clear();
    for (const [id, pose] of poses) this.sensed.set(id, pose);
    if (this.mode === "preview" || this.mode === "replay") return;
    const documented = new Map(this.scene?.components.map((c) => [c.id, c]));
    for (const id of gone) {
      const record = documented.get(id);
      if (record?.world_T != null) this.pieces?.setPose(id, matrixOf(record.world_T));
    }
    for (const [id, pose] of poses) this.pieces?.setPose(id, pose);
    this.stage.ask();
  }

  setStale(isStale: boolean): void {
    if (isStale === this.isStale) return;
    this.isStale = isStale;
    this.refresh();
  }

  setMode(mode: Mode): void {
    this.mode = mode;
    this.refresh();
  }

  setFilter(isShown: (component: ComponentRecord) => boolean): void {
    this.isShown = isShown;
    this.refresh();
  }

  setLit(colourById: ReadonlyMap<string, string>): void {
    this.lit = colourById;
    this.pieces?.setLit(colourById);
    this.building?.setLit(colourById);
    this.then?.setLit(colourById);
    this.stage.ask();
  }

  setRehearsal(rehearsal: Rehearsal | null): void {
    this.rehearsal = rehearsal;
    this.refresh();
  }

  /** Shows a run as it was in mode `replay`; null puts it away. */
  setReplay(replay: Replay | null): void {
    if (this.then !== null) {
      this.parts.remove(this.then.pieces.root);
      this.then.pieces.dispose();
    }
    this.then = replay === null || this.scene === null ? null : new Then(replay, this.scene, this.shapes);
    if (this.then !== null) this.parts.add(this.then.pieces.root);
    this.then?.setLit(this.lit);
    this.refresh();
  }

  setStep(step: StepRecord | null): void {
    this.step = step;
    this.drawPath();
    this.refresh();
  }

  setTime(time_s: number): void {
    this.time_s = time_s;
    if (this.mode === "preview" || this.mode === "replay") this.poseRehearsal();
    this.stage.ask();
  }

  /** Shows a refused moment and looks at it; null puts it away and brings the eye back. */
  setRefused(refused: Refused | null): void {
    this.refused = refused;
    this.comeBack?.();
    this.comeBack = null;
    this.refresh();
    const box = this.clash === null || this.mode !== "now" ? null : this.clash.box;
    if (box !== null) this.comeBack = this.stage.camera.frame(box);
  }

  get shownRefused(): Clash | null {
    return this.clash;
  }

  /** Lights robots, fixtures and zones in the colour of what is in the way. */
  setLitThings(ids: ReadonlySet<string>): void {
    this.litThings = ids;
    this.refresh();
  }

  /** Returns the posture of every robot that is shown as sensed, in the order of the scene. */
  postures(): number[][] {
    return this.scene?.robots.map((robot) => this.live?.arms.get(robot.id)?.joints ?? []) ?? [];
  }

  /** Shows the keep-out zone that is being drawn. */
  setDraft(box: { centre: Vec3; size: Vec3 } | null): void {
    this.draft.visible = box !== null;
    if (box !== null) {
      this.draft.position.set(...box.centre);
      this.draft.scale.set(...box.size);
    }
    this.stage.ask();
  }

  look(view: View): void {
    this.followed = null;
    this.stage.camera.look(view);
  }

  /** Looks at the building alone, or at the whole cell again. */
  lookAtBuilding(isWished: boolean): void {
    if (this.scene === null) return;
    const box = isWished ? boxOf(asBuilding(this.scene)) : lookedAt(this.scene, boundsOf(this.scene));
    this.stage.camera.setBounds(box);
    this.look("whole");
  }

  lookFromRobot(robot: string): void {
    this.followed = null;
    const record = this.scene?.robots.find((r) => r.id === robot);
    if (record !== undefined) this.stage.camera.lookFrom(new Vector3(...record.world_T_base.p_m));
  }

  follow(robot: string | null): void {
    this.followed = robot;
  }

  /** Returns where a component is in the site, in the pieces that are shown; null if it is not. */
  placeOf(component: string): Vec3 | null {
    const pose = this.shownPieces?.seenPoseOf(component);
    return pose === undefined ? null : new Vector3().setFromMatrixPosition(pose).toArray();
  }

  private get shownPieces(): Pieces | null {
    return this.mode === "replay" ? (this.then?.pieces ?? null) : this.pieces;
  }

  /** Returns where on the picture a component's middle is. */
  project(component: string): { x: number; y: number } | null {
    const pose = this.shownPieces?.poseOf(component);
    return pose === undefined ? null : this.stage.project(new Vector3().setFromMatrixPosition(pose));
  }

  /** Returns where the robots' number plates belong. */
  tags(): Tag[] {
    if (this.mode === "target" || this.mode === "as-built") return [];
    const team = this.mode === "preview" || this.mode === "replay" ? this.rehearsed : this.live;
    return (this.scene?.robots ?? []).flatMap((robot) => {
      if (team === null) return [];
      const foot = team.arms.get(robot.id)?.body.foot;
      if (foot === undefined) return [];
      const place = this.stage.project(new Vector3().setFromMatrixPosition(foot.matrixWorld).add(new Vector3(0, 0, 0.12)));
      return place === null ? [] : [{ id: robot.id, number: robot.number, ...place }];
    });
  }

  dispose(): void {
    this.clear();
    this.stage.dispose();
  }

  private refresh(): void {
    const { live, rehearsed, pieces } = this;
    if (live === null || rehearsed === null || pieces === null) return;
    const isReplay = this.mode === "replay" && this.then !== null;
    const isPreview = this.mode === "preview" || isReplay;
    const isModel = this.mode === "target" || this.mode === "as-built";
    this.putClashAway();
    live.root.visible = !isPreview && !isModel;
    live.setLook(this.isStale ? STALE : SOLID);
    const lit = this.refused === null ? this.litThings : NOTHING;
    lightUp(this.still, lit);
    if (!this.isStale) for (const id of lit) live.arms.get(id)?.body.setMaterial(LIT);
    rehearsed.setLook(isPreview ? SOLID : GHOST);
    rehearsed.root.traverse((node) => {
      node.castShadow = isPreview;
    });
    pieces.root.visible = this.mode !== "target" && !isReplay;
    if (this.then !== null) {
      this.then.pieces.root.visible = isReplay;
      this.then.setShown(this.isShown);
    }
    pieces.setShown((component) => this.isShown(component) && isOfMode(component, this.mode));
    this.building?.setShown(this.isShown);
    for (const zone of this.zones) zone.visible = this.mode !== "target";
    if (this.building !== null) this.building.root.visible = this.mode === "target";
    for (const [id, pose] of this.sensedPoses) pieces.setPose(id, pose);
    this.path.visible = this.step !== null && this.path.geometry.attributes["position"] !== undefined && !isModel && !isReplay;
    this.poseRehearsal();
    this.stage.ask();
  }

  private poseRehearsal(): void {
    const { rehearsed, rehearsal, step } = this;
    if (rehearsed === null) return;
    if (this.mode === "replay" && this.then !== null) {
      rehearsed.root.visible = true;
      this.then.show(this.time_s, rehearsed);
      rehearsed.setShown(() => true);
      return;
    }
    if (this.mode === "preview" && rehearsal !== null) {
      rehearsed.root.visible = true;
      rehearsal.pose(this.time_s, rehearsed, this.pieces);
      rehearsed.setShown(() => true);
      return;
    }
    if (this.mode === "now" && this.refused !== null) {
      this.drawClash(this.refused);
      return;
    }
    const isGhost = this.mode === "now" && rehearsal !== null && step !== null && step.motions.length > 0;
    rehearsed.root.visible = isGhost || this.mode === "preview";
    if (isGhost) {
      rehearsal.pose(step.starts_s + step.duration_s, rehearsed, null);
      rehearsed.setShown((robot) => robot === step.robot);
    }
  }

  private putClashAway(): void {
    if (this.clash === null) return;
    this.clash.putAway();
    this.clash = null;
    this.pieces?.setLit(this.lit);
  }

  private drawClash(refused: Refused): void {
    const { scene, shapes, rehearsed: ghosts, live, pieces, still } = this;
    if (scene === null || ghosts === null || live === null || pieces === null) return;
    this.clash = new Clash({ scene, shapes, ghosts, live, pieces, still }, refused);
    this.parts.add(this.clash.root);
    pieces.setLit(new Map([...this.clash.lit].map((id) => [id, COLOUR.blocker])));
  }

  private drawPath(): void {
    this.path.geometry.dispose();
    this.path.visible = false;
    if (this.step === null || this.rehearsal === null || this.rehearsed === null) return;
    const points = this.rehearsal.pathOf(this.step, this.rehearsed).map((m) => new Vector3().setFromMatrixPosition(m));
    const apart = points.filter((p, k) => k === 0 || p.distanceTo(points[k - 1] ?? p) > 1e-4);
    if (apart.length < 2) return;
    this.path.geometry = new TubeGeometry(new CatmullRomCurve3(apart), apart.length * 2, 0.009, 6);
    this.path.visible = true;
  }

  private pick(hits: Intersection[]): void {
    const place = hits[0]?.point;
    if (place !== undefined) this.onGround(place.x, place.y);
    for (const hit of hits) {
      if (!isSeen(hit.object)) continue;
      const component = this.then?.pieces.componentAt(hit) ?? this.pieces?.componentAt(hit) ?? this.building?.componentAt(hit);
      if (component !== undefined) {
        this.onPick(component.id);
        return;
      }
    }
    this.onPick(null);
  }

  private clear(): void {
    this.stage.world.remove(this.parts);
    this.pieces?.dispose();
    this.building?.dispose();
    this.then?.pieces.dispose();
    this.then = null;
    this.shapes.dispose();
    this.shapes = new Shapes({});
    this.sensed.clear();
  }
}

function isSeen(object: Object3D | null): boolean {
  return object === null || (object.visible && isSeen(object.parent));
}

function isOfMode(component: ComponentRecord, mode: Mode): boolean {
  if (mode === "as-built") return component.layer === "as_built" || component.layer === "virtual_collision";
  return true;
}
