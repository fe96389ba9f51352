// Drawing a keep-out zone: a box on the picture, moved by taps and numbers.
import { signal } from "@preact/signals";
import { decide } from "../state/decisions";
import { isReachable, proposal, scene } from "../state/store";
import { say } from "../words/words";
import type { WordKey } from "../words/en";
import type { Vec3 } from "../wire";
import { Dialog } from "./dialog";

export const isDrawingZone = signal(false);
export const zoneCentre = signal<Vec3>([0, 0, 1]);
export const zoneSize = signal<Vec3>([0.6, 0.6, 1.2]);

const PLACES: readonly WordKey[] = ["zone.x", "zone.y", "zone.z"];
const SIZES: readonly WordKey[] = ["zone.length", "zone.width", "zone.height"];

export function ZoneDialog() {
  if (!isDrawingZone.value) return null;
  const close = (): void => void (isDrawingZone.value = false);
  const save = async (event: Event): Promise<void> => {
    event.preventDefault();
    const zone = { center_m: zoneCentre.value, size_m: zoneSize.value, yaw_rad: 0 };
    if (await decide({ fingerprint: proposal.value?.fingerprint ?? "", verb: "zone", zone })) close();
  };
  return (
    <Dialog title={say("zone.title")} onClose={close} isBeside>
      <form onSubmit={(event) => void save(event)}>
        <p>
          {say("zone.text")} <span class="soft">{say("zone.tap")}</span>
        </p>
        <div class="numbers">
          {PLACES.map((key, axis) => (
            <NumberField key={key} words={say(key)} value={zoneCentre.value[axis] ?? 0} onChange={(value) => (zoneCentre.value = replaced(zoneCentre.value, axis, value))} />
          ))}
          {SIZES.map((key, axis) => (
            <NumberField key={key} words={say(key)} min={0.05} value={zoneSize.value[axis] ?? 0} onChange={(value) => (zoneSize.value = replaced(zoneSize.value, axis, value))} />
          ))}
        </div>
        <footer>
          <button type="button" onClick={close}>
            {say("act.cancel")}
          </button>
          <button type="submit" class="warn" disabled={!isReachable.value || scene.value === null}>
            {say("zone.save")}
          </button>
        </footer>
      </form>
    </Dialog>
  );
}

function NumberField({ words, value, onChange, min }: { words: string; value: number; onChange: (value: number) => void; min?: number }) {
  return (
    <label class="field">
      {words}
      <input type="number" step="0.05" min={min} value={Math.round(value * 1000) / 1000} onInput={(event) => onChange(event.currentTarget.valueAsNumber || 0)} />
    </label>
  );
}

function replaced(vector: Vec3, axis: number, value: number): Vec3 {
  return vector.map((old, index) => (index === axis ? value : old)) as Vec3;
}
