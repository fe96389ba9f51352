// All components by layer: find, show, lock, select.
import { useState } from "preact/hooks";
import { decide } from "../state/decisions";
import { hiddenIds, isReachable, lockedIds, may, scene, selectedComponent } from "../state/store";
import type { ComponentRecord, Layer } from "../wire";
import { say, sayWord } from "../words/words";

const LAYERS: readonly Layer[] = ["target", "as_built", "material", "virtual_collision", "as_designed"];

export function Tree() {
  const [wish, setWish] = useState("");
  const all = (scene.value?.components ?? []).filter((c) => `${c.name} ${c.id} ${c.type}`.toLowerCase().includes(wish.toLowerCase()));
  return (
    <div class="tree">
      <label class="field">
        <span class="unseen">{say("tree.search")}</span>
        <input type="search" placeholder={say("tree.search")} value={wish} onInput={(event) => setWish(event.currentTarget.value)} />
      </label>
      <div aria-label={say("tree.list")} role="group">
        {LAYERS.map((layer) => (
          <LayerGroup key={layer} layer={layer} members={all.filter((c) => c.layer === layer)} />
        ))}
        <Zones />
      </div>
    </div>
  );
}

/** Zones that a person drew can be taken away again. */
function Zones() {
  const zones = scene.value?.zones ?? [];
  if (zones.length === 0) return null;
  return (
    <details class="layer" open>
      <summary>
        <span class="swatch virtual_collision" aria-hidden="true" />
        {say("tree.zones")} <span class="soft">{zones.length}</span>
      </summary>
      <ul>
        {zones.map((zone) => (
          <li key={zone.id}>
            <span class="name zone">{zone.name}</span>
            {zone.by !== "cell" && may("zone") && (
              <button type="button" disabled={!isReachable.value} onClick={() => void decide({ fingerprint: "", verb: "zone", zone: { remove: zone.id } })}>
                {say("zone.remove")}
              </button>
            )}
          </li>
        ))}
      </ul>
    </details>
  );
}

function LayerGroup({ layer, members }: { layer: Layer; members: ComponentRecord[] }) {
  if (members.length === 0) return null;
  const name = say(`layer.${layer}`);
  const isShown = members.some((c) => !hiddenIds.value.has(c.id));
  return (
    <details class="layer" open={members.length < 60}>
      <summary>
        <span class={`swatch ${layer}`} aria-hidden="true" />
        {name} <span class="soft">{members.length}</span>
      </summary>
      <Toggle words={say("tree.show", { name })} isOn={isShown} sign="eye" onToggle={() => set(hiddenIds, members, isShown)} />
      <ul>
        {members.map((c) => (
          <Row key={c.id} component={c} />
        ))}
      </ul>
    </details>
  );
}

function Row({ component }: { component: ComponentRecord }) {
  const { id, name } = component;
  return (
    <li class={selectedComponent.value === id ? "selected" : ""}>
      <button type="button" class="name" aria-pressed={selectedComponent.value === id} onClick={() => (selectedComponent.value = id)}>
        {name}
        <small>
          {sayWord("state", component.status)}
          {component.accessible && ` · ${say("card.accessible")}`}
        </small>
      </button>
      <Toggle words={say("tree.show", { name })} isOn={!hiddenIds.value.has(id)} sign="eye" onToggle={() => set(hiddenIds, [component], !hiddenIds.value.has(id))} />
      <Toggle words={say("tree.lock", { name })} isOn={lockedIds.value.has(id)} sign="lock" onToggle={() => set(lockedIds, [component], !lockedIds.value.has(id))} />
    </li>
  );
}

function Toggle({ words, isOn, sign, onToggle }: { words: string; isOn: boolean; sign: "eye" | "lock"; onToggle: () => void }) {
  return (
    <button type="button" class="toggle" aria-pressed={isOn} aria-label={words} title={words} onClick={onToggle}>
      {sign === "eye" ? <Eye isOpen={isOn} /> : <Lock isShut={isOn} />}
    </button>
  );
}

function Eye({ isOpen }: { isOpen: boolean }) {
  return (
    <svg viewBox="0 0 24 24" width="22" height="22" fill="none" stroke="currentColor" stroke-width="1.8" aria-hidden="true">
      <path d="M2.5 12S6 5.5 12 5.5 21.5 12 21.5 12 18 18.5 12 18.5 2.5 12 2.5 12Z" />
      {isOpen ? <circle cx="12" cy="12" r="2.8" /> : <path d="M4 20 20 4" />}
    </svg>
  );
}

function Lock({ isShut }: { isShut: boolean }) {
  return (
    <svg viewBox="0 0 24 24" width="22" height="22" fill="none" stroke="currentColor" stroke-width="1.8" aria-hidden="true">
      <rect x="5" y="11" width="14" height="9" rx="2" />
      <path d={isShut ? "M8 11V8a4 4 0 0 1 8 0v3" : "M8 11V7a4 4 0 0 1 7.5-2"} />
    </svg>
  );
}

function set(ids: typeof hiddenIds, members: readonly ComponentRecord[], isIn: boolean): void {
  const next = new Set(ids.value);
  for (const { id } of members) {
    if (isIn) next.add(id);
    else next.delete(id);
  }
  ids.value = next;
}
