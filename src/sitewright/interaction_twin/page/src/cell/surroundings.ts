// What stands still: floor, fixtures, hatched zones, marks of stations and stock places.
import {
  CanvasTexture,
  Color,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  RepeatWrapping,
  RingGeometry,
  ShaderMaterial,
  type Material,
} from "three";
import type { Scene, StationRecord, StockPlaceRecord } from "../wire";
import { bodyMaterial, COLOUR, veil } from "./looks";
import { matrixOf } from "./poses";
import type { Shapes } from "./shapes";

const LIT = veil(COLOUR.blocker, 0.6);
const MARK_COLOUR: Readonly<Record<string, string>> = { tool: "#7d5ba6", buffer: "#5b8c4a", preparation: "#6f7f8b", stock: "#a67c3d" };

/** Builds everything that does not move. */
export function surroundings(scene: Scene, shapes: Shapes): Group {
  const root = new Group();
  const body = bodyMaterial(COLOUR.fixture);
  const floor = bodyMaterial(COLOUR.floor);
  const line = new LineBasicMaterial({ color: "#8d938f", transparent: true, opacity: 0.5 });
  for (const fixture of scene.fixtures) {
    if (fixture.geometry === null) continue;
    const mesh = new Mesh(shapes.solid(fixture.geometry), isFloor(fixture.id) ? floor : body);
    mesh.receiveShadow = true;
    mesh.castShadow = !isFloor(fixture.id);
    const edges = new LineSegments(shapes.edge(fixture.geometry), line);
    const group = new Group().add(mesh, edges);
    group.applyMatrix4(matrixOf(fixture.world_T));
    group.name = fixture.id;
    root.add(group);
  }
  const hatch = hatched(COLOUR.keepOut, scene.ground_z_m);
  const rim = new LineBasicMaterial({ color: COLOUR.keepOut, transparent: true, opacity: 0.35 });
  for (const zone of scene.zones) {
    if (zone.geometry === null) continue;
    const mesh = new Mesh(shapes.solid(zone.geometry), hatch);
    mesh.renderOrder = 3;
    const group = new Group().add(mesh, new LineSegments(shapes.edge(zone.geometry), rim));
    group.applyMatrix4(matrixOf(zone.world_T));
    group.name = zone.id;
    group.userData["isZone"] = true;
    root.add(group);
  }
  const places = [...scene.stations, ...scene.stock_places.map((p) => ({ ...p, kind: "stock" }))];
  for (const place of places) {
    const mark = markOf(place);
    if (mark !== null) root.add(mark);
  }
  return root;
}

/** Lights fixtures and zones by id, and gives the others their own look again. */
export function lightUp(root: Group, ids: ReadonlySet<string>): void {
  for (const thing of root.children) {
    for (const mesh of thing.children) {
      if (!(mesh instanceof Mesh)) continue;
      mesh.userData["own"] ??= mesh.material;
      mesh.material = ids.has(thing.name) ? LIT : (mesh.userData["own"] as Material);
    }
  }
}

const isFloor = (id: string): boolean => id === "floor" || id === "ground";

/** Returns a material with diagonal stripes in the site's own metres, strong at the floor, so that nothing hides behind a zone. */
function hatched(colour: string, foot_m: number): Material {
  return new ShaderMaterial({
    uniforms: { colour: { value: new Color(colour) }, foot: { value: foot_m } },
    vertexShader:
      "varying vec3 p; void main(){ vec4 w = modelMatrix * vec4(position,1.0); p = w.xyz; gl_Position = projectionMatrix * viewMatrix * w; }",
    fragmentShader:
      "varying vec3 p; uniform vec3 colour; uniform float foot; void main(){ float s = fract((p.x + p.y + p.z) * 2.5); " +
      "float low = 1.0 - smoothstep(0.0, 0.9, p.z - foot); " +
      "gl_FragColor = vec4(colour, (s < 0.3 ? 0.30 : 0.05) * (0.16 + 0.84 * low)); }",
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
  });
}

function markOf(place: StationRecord | StockPlaceRecord): Mesh | null {
  const kind = "kind" in place ? place.kind : "";
  if (kind === "preparation") return null;
  const material = new MeshBasicMaterial({ color: MARK_COLOUR[kind] ?? "#6f7f8b", transparent: true, opacity: 0.75, side: DoubleSide, depthWrite: false });
  const ring = new Mesh(new RingGeometry(0.09, 0.12, 40), material);
  ring.applyMatrix4(matrixOf(place.world_T));
  ring.translateZ(0.004);
  ring.renderOrder = 2;
  return ring;
}

/** Returns a large ground that fades out, so that the cell does not hang in the air. */
export function ground(z_m: number): Mesh {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 256;
  const pen = canvas.getContext("2d");
  if (pen !== null) {
    const fade = pen.createRadialGradient(128, 128, 20, 128, 128, 128);
    fade.addColorStop(0, "rgba(214,214,206,1)");
    fade.addColorStop(1, "rgba(214,214,206,0)");
    pen.fillStyle = fade;
    pen.fillRect(0, 0, 256, 256);
  }
  const texture = new CanvasTexture(canvas);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  const mesh = new Mesh(new PlaneGeometry(26, 26), new MeshBasicMaterial({ map: texture, transparent: true, depthWrite: false }));
  mesh.position.z = z_m - 0.002;
  mesh.renderOrder = -1;
  return mesh;
}
