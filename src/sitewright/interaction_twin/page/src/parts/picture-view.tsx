// The 3D picture in the page, with its views, its modes and the plates of the robots.
import { effect, signal } from "@preact/signals";
import { useEffect, useRef, useState } from "preact/hooks";
import { CellPicture, type Mode, type Tag } from "../cell/picture";
import { COLOUR, robotColour } from "../cell/looks";
import { followPlan, playClock } from "../state/playing";
import { arrived, followReplay } from "../state/replaying";
import { posesIn } from "../state/link";
import {
  age_s,
  blockers,
  hiddenIds,
  isPlaying,
  joints,
  link,
  lockedIds,
  mode,
  piecePoses,
  refused,
  replay,
  rehearsal,
  run,
  scene,
  screen,
  selectedComponent,
  shownTrouble,
  standing,
  step,
  time_s,
} from "../state/store";
import { inNumbers, say } from "../words/words";
import { isFrozen, mark, measured, pixelRatio } from "../marks";
import { standingIds } from "../state/building";
import { isDrawingZone, zoneCentre, zoneSize } from "./zone-dialog";
import type { RobotRecord } from "../wire";
import { Transport } from "./transport";

const MODES = ["now", "preview", "target", "as-built"] as const satisfies readonly Mode[];
const tags = signal<readonly Tag[]>([]);
const trouble = signal("");
const followed = signal<string | null>(null);
let picture: CellPicture | null = null;

export const shownPicture = (): CellPicture | null => picture;

export function PictureView() {
  const frame = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    if (frame.current === null || canvas.current === null) return undefined;
    try {
      return attach(canvas.current, frame.current);
    } catch (error) {
      trouble.value = error instanceof Error ? error.message : String(error);
      return undefined;
    }
  }, []);
  return (
    <section class={`picture ${mode.value}`}>
      <div class="frame" ref={frame}>
        <canvas ref={canvas} role="img" aria-label={say("picture.label")} />
        {trouble.value === "" && tags.value.map((tag) => (
          <span key={tag.id} class="plate" aria-hidden="true" style={{ transform: `translate(${tag.x}px, ${tag.y}px)`, background: isOld() ? COLOUR.stale : robotColour(tag.number - 1) }}>
            {tag.number}
          </span>
        ))}
        {trouble.value !== "" && <p class="fault">{say("picture.failed", { reason: trouble.value })}</p>}
        <Notice />
      </div>
      <Modes />
      <Views />
      {isRehearsed() && <Transport />}
    </section>
  );
}

const isRehearsed = (): boolean => (mode.value === "preview" || mode.value === "replay") && screen.value !== "building";

const isOld = (): boolean => mode.value === "now" && link.value !== "live" && !isFrozen;

function Notice() {
  if (refused.value !== null && mode.value === "now" && screen.value === "cell") {
    return (
      <p class="over tried-then">
        {say(refused.value.posture === null ? "picture.blockers" : "picture.refused")}
        <button type="button" onClick={() => (shownTrouble.value = null)}>
          {say("picture.back")}
        </button>
      </p>
    );
  }
  if (isRehearsed()) return <p class="over">{say(mode.value === "replay" ? "picture.replay" : "picture.preview")}</p>;
  if (screen.value === "building" || !isOld() || link.value === "lost" || link.value === "connecting") return null;
  return <p class="over old">◷ {say("picture.stale", { seconds: inNumbers(age_s.value, 1) })}</p>;
}

function Modes() {
  if (screen.value !== "cell") return null;
  return (
    <div class="modes segmented" role="group" aria-label={say("mode.label")}>
      {MODES.map((name) => (
        <button type="button" key={name} aria-pressed={mode.value === name} onClick={() => choose(name)}>
          {say(`mode.${name}`)}
        </button>
      ))}
    </div>
  );
}

function choose(name: Mode): void {
  isPlaying.value = false;
  mode.value = name;
}

function Views() {
  const robots = scene.value?.robots ?? [];
  const [isOpen, setOpen] = useState(false);
  return (
    <div class="views">
      <button type="button" class="opener" aria-expanded={isOpen} onClick={() => setOpen(!isOpen)}>
        {say("view.open")} <span aria-hidden="true">▾</span>
      </button>
      {isOpen && <ViewMenu robots={robots} onChosen={() => setOpen(false)} />}
    </div>
  );
}

function ViewMenu({ robots, onChosen }: { robots: readonly RobotRecord[]; onChosen: () => void }) {
  const look = (act: () => void): void => {
    act();
    onChosen();
  };
  return (
    <div class="menu" role="group" aria-label={say("view.label")}>
      {(["whole", "top", "front", "side"] as const).map((name) => (
        <button type="button" key={name} onClick={() => look(() => picture?.look(name))}>
          {say(`view.${name}`)}
        </button>
      ))}
      {robots.map((robot) => (
        <button type="button" key={robot.id} onClick={() => look(() => picture?.lookFromRobot(robot.id))}>
          {say("view.robot", { number: robot.number })}
        </button>
      ))}
      {robots.map((robot) => (
        <button type="button" key={robot.id} aria-pressed={followed.value === robot.id} onClick={() => look(() => follow(robot.id))}>
          {say("view.follow", { number: robot.number })}
        </button>
      ))}
    </div>
  );
}

function follow(robot: string): void {
  followed.value = followed.value === robot ? null : robot;
  picture?.follow(followed.value);
}

/** Ties the picture to what the page knows; every effect does one thing. */
function attach(canvas: HTMLCanvasElement, frame: HTMLElement): () => void {
  const made = new CellPicture(canvas, frame, pixelRatio);
  picture = made;
  made.onPick = (id) => {
    if (id !== null && lockedIds.peek().has(id)) return;
    selectedComponent.value = id;
  };
  made.onGround = (x, y) => {
    if (isDrawingZone.peek()) zoneCentre.value = [x, y, zoneSize.peek()[2] / 2];
  };
  made.stage.onDrawn = () => {
    tags.value = made.tags();
    measured(made.stage.cost);
    if (scene.peek() !== null) mark("first");
  };
  const ends = [
    effect(() => {
      if (scene.value !== null) made.setScene(scene.value);
    }),
    effect(() => {
      if (joints.value !== null && !isFrozen) made.setJoints(joints.value);
    }),
    effect(() => placePieces(made)),
    effect(() => made.setStale(isOld())),
    effect(() => made.setMode(screen.value === "building" ? "target" : mode.value)),
    followScreen(made),
    effect(() => filter(made)),
    effect(() => made.setLit(lit())),
    effect(() => made.setLitThings(new Set(blockers.value))),
    effect(() => {
      void scene.value;
      made.setRefused(refused.value);
    }),
    effect(() => made.setRehearsal(rehearsal.value)),
    effect(() => made.setReplay(replay.value)),
    effect(() => {
      void rehearsal.value;
      void scene.value;
      made.setStep(run.value?.phase === "running" && mode.value === "now" ? null : step.value);
    }),
    effect(() => {
      void arrived.value;
      made.setTime(time_s.value);
    }),
    effect(() => made.setDraft(isDrawingZone.value ? { centre: zoneCentre.value, size: zoneSize.value } : null)),
    followPlan(made),
    followReplay(),
    playClock(),
  ];
  return () => {
    for (const end of ends) end();
    made.dispose();
    picture = null;
  };
}

function followScreen(made: CellPicture): () => void {
  let wasBuilding = false;
  return effect(() => {
    const isBuilding = screen.value === "building";
    if (scene.value !== null && isBuilding !== wasBuilding) {
      wasBuilding = isBuilding;
      made.lookAtBuilding(isBuilding);
    }
  });
}

function placePieces(made: CellPicture): void {
  const frame = piecePoses.value;
  const components = scene.value?.components ?? [];
  if (frame === null || isFrozen) return;
  const poses = new Map([...posesIn(frame)].flatMap(([index, pose]) => (components[index] === undefined ? [] : [[components[index].id, pose] as const])));
  made.setSensedPoses(poses);
}

function filter(made: CellPicture): void {
  const hidden = hiddenIds.value;
  const all = scene.value?.components ?? [];
  const placed = mode.value === "replay" ? new Set() : new Set(all.filter((c) => c.layer === "as_built").map((c) => c.made_of));
  const standingNow = screen.value === "building" && standing.value !== null ? standingIds(all, standing.value) : null;
  made.setFilter((c) => !hidden.has(c.id) && !placed.has(c.id) && (standingNow === null || c.layer === "virtual_collision" || standingNow.has(c.id)));
}

function lit(): Map<string, string> {
  const found = new Map(blockers.value.map((id) => [id, COLOUR.blocker] as [string, string]));
  const chosen = step.value;
  const touched = chosen === null || mode.value === "replay" || run.value?.phase === "finished" ? [] : [...chosen.arguments, chosen.holds_before?.piece, chosen.holds_after?.piece];
  for (const id of touched) if (id !== undefined && !found.has(id)) found.set(id, COLOUR.selected);
  if (selectedComponent.value !== null) found.set(selectedComponent.value, COLOUR.selected);
  return found;
}
