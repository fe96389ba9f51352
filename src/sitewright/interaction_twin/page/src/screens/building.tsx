// The building as it grows, and what rests on what; both select the same component.
import { useLayoutEffect } from "preact/hooks";
import { Drawing } from "../parts/drawing";
import { buildingOrder } from "../state/building";
import { inLanguage } from "../state/server";
import { scene, selectedComponent, standing } from "../state/store";
import { say, sayWord } from "../words/words";

export function BuildingPanel() {
  const all = scene.value?.components ?? [];
  const ordered = buildingOrder(all);
  const built = ordered.filter((c) => c.layer === "as_built").length;
  useLayoutEffect(() => {
    standing.value = null;
    return () => {
      standing.value = null;
    };
  }, []);
  const count = standing.value ?? ordered.length;
  return (
    <div class="scroll" tabIndex={0} role="region" aria-label={say("nav.building")}>
      <section class="block">
        <h2>{say("building.order")}</h2>
        <input type="range" min={0} max={ordered.length} value={count} aria-label={say("building.slider")} onInput={(event) => (standing.value = event.currentTarget.valueAsNumber)} />
        <p class="soft">{say("building.shown", { count, total: ordered.length })}</p>
        <ol class="order">
          {ordered.map((c, index) => (
            <li key={c.id} class={index < count ? "" : "later"}>
              <button type="button" aria-pressed={selectedComponent.value === c.id} onClick={() => (selectedComponent.value = c.id)}>
                <span class="number">{index + 1}</span>
                {c.name}
                <small>{index < built ? sayWord("state", "installed") : sayWord("state", c.status)}</small>
              </button>
            </li>
          ))}
        </ol>
      </section>
      <section class="block">
        <h2>{say("building.graph")}</h2>
        <Graph />
      </section>
    </div>
  );
}

function Graph() {
  const selected = selectedComponent.value;
  return (
    <Drawing
      kind="graph"
      label={say("building.graph.label")}
      path={inLanguage("/api/graph.svg")}
      revision={scene.value?.epoch ?? 0}
      items={(picture) => [...picture.querySelectorAll<SVGElement>("[data-component]")]}
      isSelected={(node) => node.dataset["component"] === selected}
      onPick={(node) => (selectedComponent.value = node.dataset["component"] ?? null)}
    />
  );
}
