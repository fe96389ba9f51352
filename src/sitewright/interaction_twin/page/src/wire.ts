// What goes over the wire, as docs/page-api.md says; metres, radians, seconds, Unix milliseconds.

export type Vec3 = [number, number, number];

export interface Pose {
  p_m: Vec3;
  q_wxyz: [number, number, number, number];
}

export interface Geometry {
  corners_m: Vec3[];
  triangles: Vec3[];
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
}

export interface Description {
  root: string;
  tip: string;
  links: { name: string; geometry: string | null }[];
  joints: JointRecord[];
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

export interface BodyRecord {
  id: string;
  name: string;
  geometry: string | null;
  world_T: Pose;
  by?: string;
}

export interface PlaceRecord {
  id: string;
  name: string;
  kind?: string;
  robot?: string | null;
  world_T: Pose | null;
}

export type Layer = "target" | "material" | "as_built" | "as_designed" | "virtual_collision";

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
  operations: { id: string; name: string; process: string; done: boolean }[];
  made_of: string | null;
  stack: string | null;
  deviation: { mm: number; deg: number; words: string } | null;
  note: string;
}

export interface Scene {
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
  joints: { of: string; joint: string }[];
  components: ComponentRecord[];
  zones: BodyRecord[];
  fixtures: BodyRecord[];
  stations: PlaceRecord[];
  stock_places: PlaceRecord[];
}

export interface Edit {
  body: string;
  on: string | null;
  pose: Pose;
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

export type StepStatus = "open" | "running" | "done" | "not done" | "superseded";

/** What hangs on a robot's tip. */
export interface Held {
  piece: string;
}

/** What one plan says and the one before it did not. */
export interface Difference {
  kind: "target" | "removed" | "added" | "motion";
  words: string;
  step?: number;
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
  closest_distance_m: number | null;
  closest_pair: string[];
  closest_names: string[];
  flags: string[];
  holds_before: Held | null;
  holds_after: Held | null;
  motions: MotionRecord[];
}

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
  duration_s: number;
  closest_distance_m: number | null;
  summary: string[];
  decided: { who: string; verb: string; at_ms: number } | null;
  previous_code: string;
  differences: Difference[];
  steps: StepRecord[];
}

export type NoProposal = { open: null; fingerprint?: undefined; phase: Phase; reason: string };

export type Phase =
  | "idle"
  | "planning"
  | "waiting"
  | "running"
  | "holding"
  | "held"
  | "question"
  | "needs-help"
  | "finished"
  | "broken";

export interface Option {
  id: string;
  words: string;
  verb: string;
  zone?: { remove: string };
  call?: Call;
  step?: number;
  price_s?: number | null;
}

/** A change that was planned through on a copy of the site. */
export interface Tried {
  words: string;
  steps: number;
  duration_s: number;
}

/** Where robots were when two bodies came too near, and what they carried. */
export interface Posture {
  q_rad: Record<string, number[]>;
  bodies: Edit[];
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
  counter_proposals: Tried[];
  rejected: string[];
  options: Option[];
  posture: Posture | null;
}

export interface Question {
  question_id: string;
  step: number;
  target: string;
  text: string;
  answers: string[];
}

export interface RunState {
  type: "state";
  phase: Phase;
  words: string;
  run: string;
  n: number;
  scene_epoch: number;
  open: { fingerprint: string; code: string; target: string; next_step: number; steps: number; is_single: boolean } | null;
  running: { step: number; robot: string; words: string; started_at_ms: number; duration_s: number; fingerprint: string } | null;
  question: Question | null;
  held: { reason: string; exit_code: number } | null;
  trouble: Trouble[];
  cell: "live" | "absent";
  progress: { installed: number; targets: number };
  is_over: boolean;
}

export interface RunEvent {
  type: "event";
  run: string;
  n: number;
  at_ms: number;
  kind: string;
  words: string;
  body: unknown;
}

export interface Call {
  skill: string;
  robot: string;
  arguments: string[];
}

export interface OtherWay extends Call {
  words: string;
  duration_s: number;
  price_s: number | null;
  note: string;
}

export interface OtherWays {
  fingerprint: string;
  step: number;
  feasible: OtherWay[];
  infeasible: (Call & { words: string; why_not: string })[];
}

export interface Session {
  who: string;
  role: string;
  can: string[];
  is_simulation?: boolean;
  languages?: string[];
  /** Each decision carries the name and the PIN of who makes it. */
  asks_pin?: boolean;
  people?: string[];
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

export interface SensedRobot {
  q_rad: number[];
  mounted: string | null;
  aperture_m: number;
  gripped: string | null;
}

/** What was sensed otherwise than before. */
export interface SensedChange {
  robots: Record<string, SensedRobot>;
  pieces: Record<string, Pose>;
  gone: string[];
}

export interface ReplaySkill {
  robot: string;
  step: number;
  fingerprint: string;
  starts_s: number;
  duration_s: number;
}

/** A whole run; times are seconds of the cell since its first skill. */
export interface ReplayRecord {
  run: string;
  duration_s: number;
  start: SensedChange;
  docks: Record<string, Pose>;
  placed: Record<string, string>;
  events: { n: number; at_s: number }[];
  moments: (SensedChange & { n: number; at_s: number })[];
  placings: { n: number; at_s: number; target: string; piece: string | null }[];
  skills: ReplaySkill[];
}

/** Body of every answer that is no success. */
export interface Refusal {
  error: string;
  message: string;
  open?: { fingerprint: string; code: string } | null;
  changed?: Difference[];
  why?: string;
  who?: string;
  verb?: string;
  at_ms?: number;
  needs?: string;
}
