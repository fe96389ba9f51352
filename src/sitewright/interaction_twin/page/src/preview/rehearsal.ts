// A plan played without robots: where everything is at a time, from the exact trajectories alone.
import { Matrix4 } from "three";
import type { Pieces } from "../cell/pieces";
import { matrixOf } from "../cell/poses";
import type { Team } from "../cell/team";
import type { MotionRecord, Pose, Proposal, Scene, StepRecord } from "../wire";
import { positionsAt, type Trajectory } from "./trajectory";

/** From `time_s` on a piece hangs on a robot's tip (`pose` relative to it), or lies in the site. */
interface PieceKey {
  time_s: number;
  piece: string;
  robot: string | null;
  pose: Matrix4;
}

interface ToolKey {
  time_s: number;
  tool: string;
  robot: string | null;
  pose: Pose;
}

/** What is known of the site: as it is when the first `done` steps of the plan have run. */
export interface StartOfPlan {
  done: number;
  postures: ReadonlyMap<string, readonly number[]>;
  poses: ReadonlyMap<string, Matrix4>;
}

/** Knows the whole plan as keys over time; `pose` puts a team and its pieces to one moment. */
export class Rehearsal {
  private readonly motions: MotionRecord[];
  private readonly pieceKeys: PieceKey[] = [];
  private readonly toolKeys: ToolKey[] = [];
  readonly duration_s: number;

  constructor(
    readonly proposal: Proposal,
    private readonly trajectories: ReadonlyMap<string, Trajectory>,
    private readonly scene: Scene,
    private readonly start: StartOfPlan,
    team: Team,
  ) {
    this.motions = proposal.steps.flatMap((step) => step.motions);
    this.duration_s = Math.max(0, ...proposal.steps.map((step) => step.starts_s + step.duration_s));
    this.readTools();
    this.readPieces(team);
  }

  /** The trajectories that are played, by the hash of the bytes that came. */
  get hashes(): string[] {
    return this.motions.map((motion) => this.trajectories.get(motion.trajectory_sha256)?.sha256 ?? "");
  }

  /** Where it can be stopped: where steps begin, and the end. */
  get stops(): number[] {
    return [...new Set([...this.proposal.steps.map((step) => step.starts_s), this.duration_s])];
  }

  /** Returns the joints of a robot at a time. */
  postureAt(robot: string, time_s: number): readonly number[] {
    const own = this.motions.filter((motion) => motion.robot === robot);
    const begun = own.filter((motion) => motion.starts_s <= time_s + 1e-9).at(-1);
    const motion = begun ?? own[0];
    const trajectory = motion === undefined ? undefined : this.trajectories.get(motion.trajectory_sha256);
    if (motion === undefined || trajectory === undefined) return this.start.postures.get(robot) ?? [];
    return positionsAt(trajectory, begun === undefined ? 0 : time_s - motion.starts_s);
  }

  /** Puts robots, end effectors and pieces as they are at a time of the plan. */
  pose(time_s: number, team: Team, pieces: Pieces | null): void {
    for (const record of this.scene.end_effectors) team.attach(record.id, record.on, record.world_T_mount);
    for (const key of this.toolKeys) if (key.time_s <= time_s + 1e-9) team.attach(key.tool, key.robot, key.pose);
    for (const robot of this.scene.robots) team.setPosture(robot.id, this.postureAt(robot.id, time_s));
    if (pieces === null) return;
    for (const [piece, pose] of this.start.poses) pieces.setPose(piece, pose);
    for (const key of this.pieceKeys) if (key.time_s <= time_s + 1e-9) pieces.setPose(key.piece, poseOf(key, team));
  }

  /** Returns the tool's way through the site over a step's motions. */
  pathOf(step: StepRecord, team: Team, samples = 48): Matrix4[] {
    return step.motions.flatMap((motion) =>
      Array.from({ length: samples }, (_, k) => {
        this.pose(motion.starts_s + (motion.duration_s * k) / (samples - 1), team, null);
        return team.tcpOf(motion.robot);
      }),
    );
  }

  private readTools(): void {
    for (const motion of this.motions) {
      for (const edit of motion.after) {
        this.toolKeys.push({ time_s: motion.starts_s + motion.duration_s, tool: edit.body, robot: edit.on, pose: edit.pose });
      }
    }
  }

  private readPieces(team: Team): void {
    const held = new Map<string, string>();
    for (const step of this.proposal.steps) {
      const before = step.holds_before?.piece;
      if (before !== undefined && held.get(step.robot) !== before) this.hang(step.starts_s, step, before, team);
      const after = step.holds_after?.piece;
      const end_s = step.starts_s + step.duration_s;
      if (after !== undefined && after !== before) this.hang(end_s, step, after, team);
      if (after === undefined && before !== undefined) this.lay(end_s, step.robot, before, team);
      if (after === undefined) held.delete(step.robot);
      else held.set(step.robot, after);
    }
  }

  private hang(time_s: number, step: StepRecord, piece: string, team: Team): void {
    const { robot } = step;
    if (step.number <= this.start.done) {
      this.hangBackwards(time_s, step, piece, team);
      return;
    }
    this.pose(time_s, team, null);
    const tip = team.tipOf(robot);
    const pose = this.siteOf(piece, time_s, team);
    if (pose !== undefined) this.pieceKeys.push({ time_s, piece, robot, pose: tip.invert().multiply(pose) });
  }

  /** Works out a grip of a step that has run from where the piece is now: it did not slip on the way. */
  private hangBackwards(time_s: number, step: StepRecord, piece: string, team: Team): void {
    const { robot } = step;
    const now = this.start.poses.get(piece);
    if (now === undefined) return;
    const later = this.proposal.steps.filter((s) => s.robot === robot && s.number > step.number && s.number <= this.start.done);
    const end = later.find((s) => s.holds_before?.piece === piece && s.holds_after === null);
    if (end === undefined) team.setPosture(robot, this.start.postures.get(robot) ?? []);
    else this.pose(end.starts_s + end.duration_s, team, null);
    const pose = team.tipOf(robot).invert().multiply(now);
    this.pose(time_s, team, null);
    this.pieceKeys.push({ time_s: -1, piece, robot: null, pose: team.tipOf(robot).multiply(pose) });
    this.pieceKeys.push({ time_s, piece, robot, pose });
  }

  private lay(time_s: number, robot: string, piece: string, team: Team): void {
    this.pose(time_s, team, null);
    const held = this.pieceKeys.filter((key) => key.piece === piece && key.robot === robot).at(-1);
    if (held !== undefined) this.pieceKeys.push({ time_s, piece, robot: null, pose: poseOf(held, team) });
  }

  private siteOf(piece: string, time_s: number, team: Team): Matrix4 | undefined {
    const key = this.pieceKeys.filter((k) => k.piece === piece && k.time_s <= time_s).at(-1);
    return key === undefined ? this.start.poses.get(piece)?.clone() : poseOf(key, team);
  }
}

function poseOf(key: PieceKey, team: Team): Matrix4 {
  return key.robot === null ? key.pose.clone() : team.tipOf(key.robot).multiply(key.pose);
}

/** Returns the start of a plan from the scene document alone. */
export function documentedStart(scene: Scene): StartOfPlan {
  return {
    done: 0,
    postures: new Map(scene.robots.map((robot) => [robot.id, robot.q_rad])),
    poses: new Map(scene.components.flatMap((c) => (c.world_T === null ? [] : [[c.id, matrixOf(c.world_T)] as const]))),
  };
}
