// A run looked at again: what was sensed at each moment and, in between, the motions that were approved.
import { Matrix4 } from "three";
import type { Pieces } from "../cell/pieces";
import { matrixOf } from "../cell/poses";
import type { Team } from "../cell/team";
import type { Pose, Proposal, ReplayRecord, ReplaySkill, Scene, SensedRobot, StepRecord } from "../wire";
import { positionsAt, type Trajectory } from "./trajectory";

const SAME_S = 1.5e-3;

/** How everything was sensed last before a time. */
export interface Sensed {
  robots: Map<string, SensedRobot>;
  pieces: Map<string, Pose>;
  /** Piece by the target that it was put in place of. */
  placed: Map<string, string>;
}

/** Plans and trajectories of what ran, as far as they have come. */
export interface Known {
  plans: ReadonlyMap<string, Proposal>;
  trajectories: ReadonlyMap<string, Trajectory>;
}

export class Replay {
  constructor(
    readonly record: ReplayRecord,
    private readonly scene: Scene,
    private readonly known: Known,
  ) {}

  get duration_s(): number {
    return this.record.duration_s;
  }

  /** Where it can be stopped: where skills begin, and the end. */
  get stops(): number[] {
    return [...new Set([...this.record.skills.map((skill) => skill.starts_s), this.duration_s])];
  }

  sensedAt(time_s: number): Sensed {
    const { start, moments, placings, placed } = this.record;
    const robots = new Map(Object.entries(start.robots));
    const pieces = new Map(Object.entries(start.pieces));
    for (const moment of moments) {
      if (moment.at_s > time_s + SAME_S) break;
      for (const piece of moment.gone) pieces.delete(piece);
      for (const [id, robot] of Object.entries(moment.robots)) robots.set(id, robot);
      for (const [id, pose] of Object.entries(moment.pieces)) pieces.set(id, pose);
    }
    const standing = new Map(Object.entries(placed));
    for (const { at_s, target, piece } of placings) {
      if (at_s > time_s + SAME_S) break;
      if (piece === null) standing.delete(target);
      else standing.set(target, piece);
    }
    return { robots, pieces, placed: standing };
  }

  /** Returns the skills that were under way at a time. */
  skillsAt(time_s: number): ReplaySkill[] {
    return this.record.skills.filter((skill) => skill.starts_s <= time_s + SAME_S && time_s < skill.starts_s + skill.duration_s - SAME_S);
  }

  /** Puts robots, end effectors and pieces as they were; returns what was sensed last. */
  pose(time_s: number, team: Team, pieces: Pieces): Sensed {
    const sensed = this.sensedAt(time_s);
    this.putRobots(sensed, team);
    const inHand = grips(sensed, team);
    for (const skill of this.skillsAt(time_s)) this.play(skill, time_s - skill.starts_s, team);
    for (const [piece, pose] of sensed.pieces) pieces.setPose(piece, matrixOf(pose));
    for (const { robot, piece, tip_T_piece } of inHand) pieces.setPose(piece, team.tipOf(robot).multiply(tip_T_piece));
    return sensed;
  }

  private putRobots(sensed: Sensed, team: Team): void {
    for (const tool of this.scene.end_effectors) {
      const carrier = [...sensed.robots].find(([, robot]) => robot.mounted === tool.id);
      team.attach(tool.id, carrier?.[0] ?? null, this.record.docks[tool.id] ?? null);
      const fingers = tool.description.joints.filter((joint) => joint.kind !== "fixed").length;
      if (carrier !== undefined) team.setTool(tool.id, Array.from({ length: fingers }, () => carrier[1].aperture_m / fingers));
    }
    for (const [id, robot] of sensed.robots) team.setPosture(id, robot.q_rad);
  }

  private play(skill: ReplaySkill, elapsed_s: number, team: Team): void {
    const step = this.stepOf(skill);
    let from_s = 0;
    for (const motion of step?.motions ?? []) {
      const trajectory = this.known.trajectories.get(motion.trajectory_sha256);
      if (trajectory === undefined || elapsed_s < from_s) return;
      team.setPosture(motion.robot, positionsAt(trajectory, elapsed_s - from_s));
      from_s += motion.duration_s;
      if (elapsed_s >= from_s) for (const edit of motion.after) team.attach(edit.body, edit.on, edit.pose);
    }
  }

  private stepOf(skill: ReplaySkill): StepRecord | undefined {
    return this.known.plans.get(skill.fingerprint)?.steps.find((step) => step.number === skill.step);
  }
}

/** Returns how each piece that is in a gripper hangs on its robot's tip. */
function grips(sensed: Sensed, team: Team): { robot: string; piece: string; tip_T_piece: Matrix4 }[] {
  return [...sensed.robots].flatMap(([robot, { gripped }]) => {
    const pose = gripped === null ? undefined : sensed.pieces.get(gripped);
    if (gripped === null || pose === undefined) return [];
    return [{ robot, piece: gripped, tip_T_piece: team.tipOf(robot).invert().multiply(matrixOf(pose)) }];
  });
}
