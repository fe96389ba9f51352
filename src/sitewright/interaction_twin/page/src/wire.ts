// What goes over the wire. Written by tools/write_wire.py from interaction_twin/wire.

export interface Audit {
  entries: AuditEntry[];
}

/** Who decided what, when, and the text that was on the screen. */
export interface AuditEntry {
  run: string;
  n: number;
  at_ms: number;
  who: string;
  kind: string;
  role: string;
  verb: string;
  session: string;
  second: string;
  key: string;
  language: string;
  shown: string[];
  words: string;
  detail: Record<string, unknown>;
}

export interface Bar {
  robot: string;
  words: string;
  target: string;
  starts_s: number;
  duration_s: number;
  is_done: boolean;
  skill: string;
  step: number;
  fingerprint: string;
}

export interface BodyRecord {
  id: string;
  name: string;
  geometry: string | null;
  world_T: Pose;
}

/** What a person can vouch for at a target. */
export interface ByHand {
  target: string;
  name: string;
  effects: Effect[];
}

/** Everything that was missed has come, up to this record. */
export interface CaughtUp {
  type: "caught-up";
  run: string;
  n: number;
}

export interface CellHealth {
  state: "live" | "absent";
  age_ms: number | null;
}

export interface ComponentRecord {
  id: string;
  name: string;
  layer: Layer;
  status: string;
  type: string;
  material: string;
  group: string;
  order: number | null;
  geometry: string | null;
  world_T: Pose | null;
  parents: string[];
  waits_for: string[];
  accessible: boolean;
  operations: OperationRecord[];
  made_of: string | null;
  stack: string | null;
  deviation: Deviation | null;
  note: string;
}

export interface Decided {
  who: string;
  verb: string;
  at_ms: number;
  scope?: Scope;
  reason?: string;
}

/** Links with their shapes, joints from the root outwards: what certificates are about. */
export interface Description {
  root: string;
  tip: string;
  links: LinkRecord[];
  joints: JointRecord[];
}

export interface Deviation {
  mm: number;
  deg: number;
  words: string;
}

/** What one plan says and the one before it did not. */
export interface Difference {
  kind: "target" | "removed" | "added" | "motion";
  words: string;
  step?: number;
}

/** A body hangs on a robot's tip from then on, or lies in the site (`on` is null). */
export interface Edit {
  body: string;
  on: string | null;
  pose: Pose;
}

export interface Effect {
  fact: string;
  words: string;
}

export interface EndEffectorRecord {
  id: string;
  name: string;
  kind: string;
  description: Description;
  opens_to_m: number;
  q: number[];
  on: string | null;
  world_T_mount: Pose | null;
}

export interface FrameJoint {
  of: string;
  joint: string;
}

export interface Geometry {
  corners_m: Vec3[];
  triangles: Triangle[];
}

export interface Graph {
  nodes: GraphNode[];
  comes_before: [string, string][];
}

export interface GraphNode {
  id: string;
  name: string;
  layer: Layer;
  type: string;
  parents: string[];
  order: number | null;
  made_of: string | null;
}

export interface Health {
  server: ServerHealth;
  run: ProcessHealth;
  cell: CellHealth;
  journal: JournalHealth;
  disk_free_bytes: number;
}

/** What hangs on a robot's tip. */
export interface Held {
  piece: string;
}

export interface HeldRun {
  reason: string;
  exit_code: number;
}

export interface HoldAnswer {
  ok: boolean;
  told_cell: boolean;
}

export interface JointRecord {
  name: string;
  kind: "revolute" | "prismatic" | "fixed";
  parent: string;
  child: string;
  parent_T_joint: Pose;
  axis: Vec3;
  lower_rad: number;
  upper_rad: number;
  velocity_rad_s: number;
}

export interface JournalHealth {
  run: string;
  n: number;
  is_whole: boolean;
}

export type Layer = "target" | "material" | "as_built" | "as_designed" | "virtual_collision";

export interface LinkRecord {
  name: string;
  geometry: string | null;
}

export interface Moment {
  robots: Record<string, SensedRobot>;
  pieces: Record<string, Pose>;
  gone: string[];
  n: number;
  at_s: number;
}

export interface MotionRecord {
  trajectory_sha256: string;
  robot: string;
  starts_s: number;
  duration_s: number;
  closest_distance_m: number | null;
  closest_pair: string[];
  after: Edit[];
}

/** Nothing is open, and why. */
export interface NoProposal {
  open: null;
  phase: Phase;
  reason: string;
}

export interface NoWay {
  skill: string;
  robot: string;
  arguments: string[];
  words: string;
  duration_s: number;
  why_not: string;
}

export interface OpenNow {
  fingerprint: string;
  code: string;
}

export interface OpenPlan {
  fingerprint: string;
  code: string;
  target: string;
  next_step: number;
  steps: number;
  is_single: boolean;
}

export interface OperationRecord {
  id: string;
  name: string;
  process: string;
  done: boolean;
}

/** What a person can decide about a trouble. */
export interface Option {
  id: string;
  words: string;
  verb: string;
  zone?: RemovedZone;
}

export interface OtherWay {
  skill: string;
  robot: string;
  arguments: string[];
  words: string;
  duration_s: number;
  price_s: number | null;
  note: string;
}

export interface OtherWays {
  fingerprint: string;
  step: number;
  feasible: OtherWay[];
  infeasible: NoWay[];
}

export type Phase = "idle" | "planning" | "waiting" | "running" | "holding" | "held" | "question" | "needs-help" | "finished" | "broken";

/** A piece was put in place of a target, or left it (null). */
export interface Placing {
  n: number;
  at_s: number;
  target: string;
  piece: string | null;
}

export interface Pose {
  p_m: Vec3;
  q_wxyz: [number, number, number, number];
}

/** Where robots were when two bodies came too near, and what they carried. */
export interface Posture {
  q_rad: Record<string, number[]>;
  bodies: Edit[];
}

export interface ProcessHealth {
  phase: Phase;
  pid: number | null;
  is_alive: boolean;
}

export interface Progress {
  installed: number;
  targets: number;
}

/** A plan; `decisions_allowed` says by verb true, or why not. */
export interface Proposal {
  open: boolean;
  fingerprint: string;
  code: string;
  run: string;
  target: string;
  target_name: string;
  title: string;
  is_single: boolean;
  next_step: number;
  status: "waiting" | "approved" | "running" | "done" | "rejected" | "superseded";
  why: string;
  notes: string[];
  asked_at_ms: number;
  decided: Decided | null;
  duration_s: number;
  closest_distance_m: number | null;
  closest_pair: string[];
  closest_names: string[];
  before: [number, number][];
  summary: string[];
  previous_code: string;
  differences: Difference[];
  flagged: number[];
  steps: StepRecord[];
  decisions_allowed: Record<string, true | string>;
}

export interface Question {
  question_id: string;
  step: number;
  target: string;
  text: string;
  answers: string[];
}

/** A decision was taken; `waiting_for` says that one person was not enough. */
export interface Recorded {
  ok: boolean;
  verb: string;
  who?: string;
  at_ms?: number;
  run?: string;
  n?: number;
  code?: string;
  approval_id?: string;
  repeated?: boolean;
  waiting_for?: string;
  message?: string;
}

/** Body of every answer that is no success. */
export interface Refusal {
  error: string;
  message: string;
  open?: OpenNow | null;
  changed?: Difference[];
  why?: string;
  shown?: string;
  who?: string;
  verb?: string;
  at_ms?: number | null;
  needs?: string;
  step?: number;
  next_step?: number;
  authors?: string[];
  wait_s?: number;
  possible?: string[];
  told_cell?: boolean;
  where?: Wrong[];
}

export interface RemovedZone {
  remove: string;
}

export interface ReplayEvent {
  n: number;
  at_s: number;
}

/** A whole run; times are seconds of the cell since its first skill. */
export interface ReplayRecord {
  run: string;
  duration_s: number;
  start: SensedChange;
  docks: Record<string, Pose>;
  placed: Record<string, string>;
  events: ReplayEvent[];
  moments: Moment[];
  placings: Placing[];
  skills: ReplaySkill[];
}

export interface ReplaySkill {
  robot: string;
  step: number;
  fingerprint: string;
  starts_s: number;
  duration_s: number;
}

export interface RobotRecord {
  id: string;
  name: string;
  number: number;
  world_T_base: Pose;
  description: Description;
  mounted: string | null;
  q_rad: number[];
  gripped: string | null;
}

/** A record of the journal, as the WebSocket tells it. */
export interface RunEvent {
  type: "event";
  run: string;
  n: number;
  at_ms: number;
  kind: string;
  words: string;
  body: unknown;
}

export interface RunLine {
  id: string;
  started_at_ms: number;
  ended_at_ms: number;
  ended: "complete" | "finished" | "held" | "open";
  installed: number;
  targets: number;
  continues: string;
}

export interface RunRecord {
  id: string;
  started_at_ms: number;
  ended_at_ms: number;
  ended: "complete" | "finished" | "held" | "open";
  installed: number;
  targets: number;
  continues: string;
  events: RunEvent[];
  planned: Bar[];
  actual: Bar[];
}

/** How the run stands: ``GET /api/state``, and a message of the WebSocket. */
export interface RunState {
  type: "state";
  phase: Phase;
  words: string;
  run: string;
  n: number;
  scene_epoch: number;
  open: OpenPlan | null;
  running: RunningStep | null;
  question: Question | null;
  held: HeldRun | null;
  trouble: Trouble[];
  cell: "live" | "absent";
  progress: Progress;
  is_over: boolean;
}

export interface RunningStep {
  step: number;
  robot: string;
  words: string;
  started_at_ms: number;
  duration_s: number;
  fingerprint: string;
}

export interface Runs {
  runs: RunLine[];
}

/** All that is drawn; `joints` is the order of the binary frames. */
export interface Scene {
  schema: "sitewright.page-scene/1";
  hash: string;
  epoch: number;
  project: string;
  run: string;
  is_simulation: boolean;
  ground_z_m: number;
  clearance_m: number;
  geometries: Record<string, Geometry>;
  robots: RobotRecord[];
  end_effectors: EndEffectorRecord[];
  joints: FrameJoint[];
  components: ComponentRecord[];
  zones: ZoneRecord[];
  fixtures: BodyRecord[];
  stations: StationRecord[];
  stock_places: StockPlaceRecord[];
}

export interface Schedule {
  run: string;
  planned: Bar[];
  actual: Bar[];
}

export interface Scope {
  kind: "plan" | "until" | "step";
  step: number;
}

/** What was sensed otherwise than before. */
export interface SensedChange {
  robots: Record<string, SensedRobot>;
  pieces: Record<string, Pose>;
  gone: string[];
}

export interface SensedRobot {
  q_rad: number[];
  mounted: string | null;
  aperture_m: number;
  gripped: string | null;
}

export interface ServerHealth {
  version: string;
  uptime_s: number;
  clients: number;
}

/** Who is signed in; with `asks_pin` each decision carries name and PIN of who makes it. */
export interface Session {
  asks_pin: boolean;
  people: string[];
  who: string;
  role: "viewer" | "operator" | "supervisor" | "admin";
  can: string[];
  port: number;
  is_simulation: boolean;
  languages: string[];
}

export interface SignedOut {
  ok: boolean;
}

export interface StationRecord {
  id: string;
  name: string;
  kind: string;
  robot: string | null;
  world_T: Pose;
}

export interface StepRecord {
  number: number;
  skill: string;
  robot: string;
  robot_name: string;
  arguments: string[];
  words: string;
  why: string;
  is_done: boolean;
  status: StepStatus;
  starts_s: number;
  duration_s: number;
  act_s: number;
  closest_distance_m: number | null;
  closest_pair: string[];
  closest_names: string[];
  flags: string[];
  touches: string[];
  may_touch: string[][];
  holds_before: Held | null;
  holds_after: Held | null;
  motions: MotionRecord[];
}

export type StepStatus = "open" | "running" | "done" | "not done" | "superseded";

export interface StockPlaceRecord {
  id: string;
  name: string;
  world_T: Pose;
}

export interface Ticket {
  ticket: string;
  expires_s: number;
}

export type Triangle = [number, number, number];

/** A change that was planned through on a copy of the site. */
export interface Tried {
  words: string;
  steps: number;
  duration_s: number;
}

export interface Trouble {
  target: string;
  name: string;
  reason: string;
  verdict: string;
  verdict_kind: string;
  pair: string[] | null;
  pair_names: string[];
  blockers: string[];
  blocker_names: string[];
  counter_proposals: Tried[];
  rejected: string[];
  options: Option[];
  posture: Posture | null;
}

export type Vec3 = [number, number, number];

/** Why a step is there; `document` is that of ``sitewright explain step``. */
export interface Why {
  lines: string[];
  document: Record<string, unknown>;
}

export interface Wrong {
  field: string;
  message: string;
}

/** A keep-out zone; `by` is the cell, or who drew it. */
export interface ZoneRecord {
  id: string;
  name: string;
  geometry: string | null;
  world_T: Pose;
  by: string;
}
