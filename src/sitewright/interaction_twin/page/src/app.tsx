// The page: one frame around the screens; Hold and the connection are there on all of them.
import { render } from "preact";
import { ActionBar, HoldButton } from "./parts/actions";
import { Banners } from "./parts/banners";
import { Header } from "./parts/header";
import { shownPicture } from "./parts/picture-view";
import { ZoneDialog } from "./parts/zone-dialog";
import { mark } from "./marks";
import { AuditScreen, HealthScreen } from "./screens/records";
import { Workspace } from "./screens/workspace";
import { watchCode } from "./state/arming";
import { startPage } from "./state/start";
import { link, rehearsal, screen, session } from "./state/store";
import { say } from "./words/words";

function Page() {
  const name = screen.value;
  return (
    <div class={`page ${link.value}`}>
      <HoldButton />
      <Header />
      <Banners />
      <main>
        {session.value !== null && (name === "cell" || name === "building" || name === "runs") && <Workspace />}
        {name === "audit" && <AuditScreen />}
        {name === "health" && <HealthScreen />}
      </main>
      <ActionBar />
      <footer class="safety">{say("safety")}</footer>
      <ZoneDialog />
    </div>
  );
}

declare global {
  interface Window {
    /** For tests: where a component is on the picture, what is shown, what would be played. */
    __app: {
      project: (component: string) => { x: number; y: number } | null;
      postures: () => number[][];
      pixels: () => string;
      trajectories: () => string[];
    };
  }
}

window.__app = {
  project: (component) => shownPicture()?.project(component) ?? null,
  postures: () => shownPicture()?.postures() ?? [],
  pixels: () => shownPicture()?.stage.pixels() ?? "",
  trajectories: () => rehearsal.value?.hashes ?? [],
};

const root = document.getElementById("page");
if (root === null) throw new Error("index.html has no element with the id page");
watchCode(() => performance.now());
render(<Page />, root);
startPage().then(
  () => mark("ui"),
  () => {
    link.value = "lost";
    setTimeout(() => location.reload(), 2000);
  },
);
