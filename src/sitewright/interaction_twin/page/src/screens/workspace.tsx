// The cell: picture, schedule, and beside them the plan, the components or the journal.
import { Card } from "../parts/card";
import { Gantt } from "../parts/gantt";
import { PictureView } from "../parts/picture-view";
import { PlanPanel } from "../parts/plan";
import { Tree } from "../parts/tree";
import { events, panel, screen } from "../state/store";
import { atTime, say } from "../words/words";
import { BuildingPanel } from "./building";
import { RunsPanel } from "./runs";

const PANELS = ["plan", "tree", "journal"] as const;
const NAMES = { plan: "plan.title", tree: "tree.title", journal: "journal.title" } as const;

export function Workspace() {
  const name = screen.value;
  return (
    <div class={`workspace ${name}`}>
      <div class="scene">
        <PictureView />
        <Card />
        {name !== "building" && <Gantt />}
      </div>
      <aside class="side" aria-label={name === "cell" ? say(NAMES[panel.value]) : say(`nav.${name}`)}>
        {name === "cell" && <CellPanel />}
        {name === "building" && <BuildingPanel />}
        {name === "runs" && <RunsPanel />}
      </aside>
    </div>
  );
}

function CellPanel() {
  return (
    <>
      <div class="segmented tabs" role="group">
        {PANELS.map((name) => (
          <button type="button" key={name} aria-pressed={panel.value === name} onClick={() => (panel.value = name)}>
            {say(NAMES[name])}
          </button>
        ))}
      </div>
      <div class="scroll" tabIndex={0} role="region" aria-label={say(NAMES[panel.value])}>
        {panel.value === "plan" && <PlanPanel />}
        {panel.value === "tree" && <Tree />}
        {panel.value === "journal" && <Journal />}
      </div>
    </>
  );
}

function Journal() {
  const shown = events.value.filter((event) => event.words !== "").reverse();
  if (shown.length === 0) return <p class="empty">{say("journal.none")}</p>;
  return (
    <ol class="journal">
      {shown.map((event) => (
        <li key={`${event.run} ${event.n}`}>
          <time>{atTime(event.at_ms)}</time>
          {event.words}
        </li>
      ))}
    </ol>
  );
}
