// The pieces of a run that is looked at again: each where it was, built or not as it was then.
import type { Replay, Sensed } from "../preview/replay";
import type { ComponentRecord, Scene } from "../wire";
import { COLOUR } from "./looks";
import { Pieces } from "./pieces";
import type { Shapes } from "./shapes";
import type { Team } from "./team";

/** All that is bodily there is a piece; targets are drawn as what shall be until something is in their place. */
export class Then {
  readonly pieces: Pieces;
  private sensed: Sensed | null = null;
  private isWished: (component: ComponentRecord) => boolean = () => true;
  private lit: ReadonlyMap<string, string> = new Map();

  constructor(
    private readonly replay: Replay,
    scene: Scene,
    shapes: Shapes,
  ) {
    this.pieces = new Pieces(scene.components.map((component) => asThen(component, replay)), shapes);
  }

  show(time_s: number, team: Team): void {
    this.sensed = this.replay.pose(time_s, team, this.pieces);
    this.refresh();
  }

  setShown(isWished: (component: ComponentRecord) => boolean): void {
    this.isWished = isWished;
    this.refresh();
  }

  setLit(lit: ReadonlyMap<string, string>): void {
    this.lit = lit;
    this.refresh();
  }

  private refresh(): void {
    const { sensed } = this;
    if (sensed === null) return;
    this.pieces.setShown((component) => this.isWished(component) && wasThere(component, sensed));
    const built = [...sensed.placed.values()].map((piece) => [piece, COLOUR.built] as const);
    const held = [...sensed.robots.values()].flatMap((robot) => (robot.gripped === null ? [] : [[robot.gripped, COLOUR.underWay] as const]));
    const chosen = [...this.lit].map(([id, colour]) => [sensed.placed.get(id) ?? id, colour] as const);
    this.pieces.setLit(new Map([...built, ...held, ...chosen]));
  }
}

function wasThere(component: ComponentRecord, sensed: Sensed): boolean {
  if (component.layer === "material") return sensed.pieces.has(component.id);
  return component.layer !== "target" || !sensed.placed.has(component.id);
}

/** Returns a component as it is drawn when nothing is known of it but what was sensed. */
function asThen(component: ComponentRecord, { record }: Replay): ComponentRecord {
  if (component.layer === "material") {
    const seen = record.start.pieces[component.id] ?? record.moments.find((moment) => component.id in moment.pieces)?.pieces[component.id];
    return { ...component, status: "stock", accessible: false, world_T: seen ?? component.world_T };
  }
  const isBuiltInRun = component.layer === "as_built" && component.made_of !== null;
  return isBuiltInRun || component.layer === "target" ? { ...component, layer: "target", status: "waiting" } : component;
}
