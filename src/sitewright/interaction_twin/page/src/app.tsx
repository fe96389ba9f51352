// The page: one frame around the screens; Hold and the connection are there on all of them.
import { render } from "preact";
import { ActionBar, HoldButton } from "./parts/actions";
import { Banners } from "./parts/banners";
import { Fence } from "./parts/fence";
import { Header } from "./parts/header";
import { shownPicture } from "./parts/picture-view";
import { PinDialog } from "./parts/pin-dialog";
import { ZoneDialog } from "./parts/zone-dialog";
import { mark } from "./marks";
import { AuditScreen, HealthScreen } from "./screens/records";
import { Workspace } from "./screens/workspace";
import { watchPlan } from "./state/arming";
import { startPage } from "./state/start";
import { link, rehearsal, screen, session, type Screen } from "./state/store";
import { say } from "./words/words";

function Page() {
  const name = screen.value;
  return (
    <div class={`page ${link.value}`}>
      <HoldButton />
      <Header />
      <Banners />
      <main>
        <Fence>{body(name)}</Fence>
      </main>
      <Fence>
        <ActionBar />
      </Fence>
      <footer class="safety">{say("safety")}</footer>
      <ZoneDialog />
      <PinDialog />
    </div>
  );
}

function body(name: Screen) {
  if (name === "audit") return <AuditScreen />;
  if (name === "health") return <HealthScreen />;
  return session.value === null ? null : <Workspace />;
}

declare global {
  interface Window {
    /** For tests: where a component is on the picture and in the site, what is shown, what was tried, what would be played. */
    __app: {
      project: (component: string) => { x: number; y: number } | null;
      placeOf: (component: string) => [number, number, number] | null;
      postures: () => number[][];
      pixels: () => string;
      tried: () => { lit: string[]; q_rad: Record<string, number[]> };
      trajectories: () => string[];
    };
  }
}

window.__app = {
  project: (component) => shownPicture()?.project(component) ?? null,
  placeOf: (component) => shownPicture()?.placeOf(component) ?? null,
  postures: () => shownPicture()?.postures() ?? [],
  tried: () => ({ lit: shownPicture()?.shownRefused?.names ?? [], q_rad: shownPicture()?.shownRefused?.postures ?? {} }),
  pixels: () => shownPicture()?.stage.pixels() ?? "",
  trajectories: () => rehearsal.value?.hashes ?? [],
};

const root = document.getElementById("page");
if (root === null) throw new Error("index.html has no element with the id page");
watchPlan(() => performance.now());
render(<Page />, root);
startPage().then(
  () => mark("ui"),
  () => {
    link.value = "lost";
    setTimeout(() => location.reload(), 2000);
  },
);
