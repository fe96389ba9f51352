// The building as it grows, and what rests on what; both select the same component.
import { useEffect } from "preact/hooks";
import { buildingOrder } from "../state/building";
import { scene, selectedComponent, standing } from "../state/store";
import type { ComponentRecord } from "../wire";
import { say, sayWord } from "../words/words";
import { rowsOf } from "./graph-rows";

export function BuildingPanel() {
  const all = scene.value?.components ?? [];
  const ordered = buildingOrder(all);
  const built = ordered.filter((c) => c.layer === "as_built").length;
  useEffect(() => {
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
        <Graph components={all.filter((c) => c.layer === "target" || c.layer === "as_built")} />
      </section>
    </div>
  );
}

const BOX = { width: 150, height: 44, gapX: 14, gapY: 40 };

function Graph({ components }: { components: readonly ComponentRecord[] }) {
  const { places, columns, rows } = rowsOf(components);
  const width = Math.max(columns, 1) * (BOX.width + BOX.gapX) + BOX.gapX;
  const height = (rows + 1) * (BOX.height + BOX.gapY);
  const x = (column: number): number => BOX.gapX + column * (BOX.width + BOX.gapX);
  const y = (row: number): number => (rows - row) * (BOX.height + BOX.gapY) + 10;
  const ground = { column: (columns - 1) / 2, row: 0 };
  const placeOf = (id: string): { column: number; row: number } => places.get(id) ?? ground;
  const nodes = components.filter((c) => places.has(c.id));
  return (
    <div class="graph" role="group" aria-label={say("building.graph.label")} tabIndex={0}>
      <svg viewBox={`0 0 ${width} ${height}`} width={width} height={height}>
        {nodes.flatMap((c) => (c.parents.length === 0 ? ["jobsite"] : c.parents).map((p) => <Edge key={`${c.id} ${p}`} from={placeOf(c.id)} to={placeOf(p)} x={x} y={y} />))}
        <g>
          <rect x={x(ground.column)} y={y(0)} width={BOX.width} height={BOX.height} rx="22" class="jobsite" />
          <text x={x(ground.column) + BOX.width / 2} y={y(0) + 27} text-anchor="middle" class="on-dark">
            {say("building.jobsite")}
          </text>
        </g>
        {nodes.map((c) => {
          const place = placeOf(c.id);
          return (
            <g key={c.id} class={`node ${c.layer} ${selectedComponent.value === c.id ? "selected" : ""}`} onClick={() => (selectedComponent.value = c.id)}>
              <title>{c.name}</title>
              <rect x={x(place.column)} y={y(place.row)} width={BOX.width} height={BOX.height} rx="7" />
              <text x={x(place.column) + BOX.width / 2} y={y(place.row) + 27} text-anchor="middle">
                {c.name.length > 20 ? `${c.name.slice(0, 19)}…` : c.name}
              </text>
            </g>
          );
        })}
      </svg>
    </div>
  );
}

interface EdgeProps {
  from: { column: number; row: number };
  to: { column: number; row: number };
  x: (column: number) => number;
  y: (row: number) => number;
}

function Edge({ from, to, x, y }: EdgeProps) {
  const ax = x(from.column) + BOX.width / 2;
  const ay = y(from.row) + BOX.height;
  const bx = x(to.column) + BOX.width / 2;
  const by = y(to.row);
  const middle = (ay + by) / 2;
  return <path d={`M${ax} ${ay} C${ax} ${middle} ${bx} ${middle} ${bx} ${by}`} class="edge" />;
}
