// The 3D picture: one renderer that draws when something changed, and never otherwise.
import {

  Box3,
  DirectionalLight,
  HemisphereLight,
  NoToneMapping,
  Object3D,
  PCFShadowMap,
  Raycaster,
  Scene as World,
  Vector2,
  Vector3,
  WebGLRenderer,
  type Intersection,
} from "three";
import { Camera } from "./camera";

Object3D.DEFAULT_UP.set(0, 0, 1);

export interface FrameCost {
  js_ms: number;
  calls: number;
}

/** Owns canvas, lights, camera and the moment of drawing. */
export class Stage {
  readonly world = new World();
  readonly camera: Camera;
  readonly cost: FrameCost = { js_ms: 0, calls: 0 };
  onDrawn: () => void = () => undefined;
  onTap: (hits: Intersection[]) => void = () => undefined;
  private readonly renderer: WebGLRenderer;
  private readonly sun = new DirectionalLight(0xfffaf2, 2.0);
  private readonly resizer: ResizeObserver;
  private asked = 0;
  private pressed: { x: number; y: number } | null = null;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly frame: HTMLElement,
    pixelRatio: number,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: false });
    this.renderer.setPixelRatio(pixelRatio);
    this.renderer.toneMapping = NoToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.camera = new Camera(canvas, () => this.ask());
    this.world.add(new HemisphereLight(0xffffff, 0xd3d2cc, 1.95), this.sun, this.sun.target);
    this.resizer = new ResizeObserver(() => this.resize());
    this.resizer.observe(frame);
    canvas.addEventListener("pointerdown", this.press);
    canvas.addEventListener("pointerup", this.lift);
    canvas.addEventListener("webglcontextrestored", () => this.ask());
    this.resize();
  }

  /** Sets what is looked at, and the light that falls on it. */
  setBounds(bounds: Box3): void {
    this.camera.setBounds(bounds);
    const middle = bounds.getCenter(new Vector3());
    const radius = bounds.getSize(new Vector3()).length() / 2;
    this.sun.position.copy(middle).add(new Vector3(-0.55, -0.75, 1.3).multiplyScalar(radius * 1.6));
    this.sun.target.position.copy(middle);
    this.sun.target.updateMatrixWorld();
    this.sun.castShadow = true;
    const shadow = this.sun.shadow;
    shadow.mapSize.set(1536, 1536);
    Object.assign(shadow.camera, { left: -radius, right: radius, top: radius, bottom: -radius, near: 0.1, far: radius * 4 });
    shadow.camera.updateProjectionMatrix();
    shadow.bias = -0.0006;
    shadow.normalBias = 0.02;
    shadow.intensity = 0.45;
    this.ask();
  }

  /** Asks for a picture; many requests make one. */
  ask(): void {
    if (this.asked !== 0) return;
    this.asked = requestAnimationFrame(() => {
      this.asked = 0;
      this.draw();
    });
  }

  /** Draws now. */
  draw(): void {
    const before = performance.now();
    this.renderer.render(this.world, this.camera.eye);
    this.cost.js_ms = performance.now() - before;
    this.cost.calls = this.renderer.info.render.calls;
    this.onDrawn();
  }

  /** Returns the picture as a data address; drawn and read in one go, for tests. */
  pixels(): string {
    this.draw();
    return this.canvas.toDataURL();
  }

  /** Returns where a point of the site is on the page; null if it is behind the eye. */
  project(point: Vector3): { x: number; y: number } | null {
    this.camera.eye.updateMatrixWorld();
    const seen = point.clone().project(this.camera.eye);
    if (seen.z > 1) return null;
    const box = this.canvas.getBoundingClientRect();
    return { x: ((seen.x + 1) / 2) * box.width, y: ((1 - seen.y) / 2) * box.height };
  }

  dispose(): void {
    cancelAnimationFrame(this.asked);
    this.resizer.disconnect();
    this.camera.dispose();
    this.renderer.dispose();
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.frame;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    this.camera.resize(width, height);
    this.ask();
  }

  private readonly press = (event: PointerEvent): void => {
    this.pressed = { x: event.clientX, y: event.clientY };
  };

  private readonly lift = (event: PointerEvent): void => {
    const start = this.pressed;
    this.pressed = null;
    if (start === null || Math.hypot(event.clientX - start.x, event.clientY - start.y) > 6) return;
    const box = this.canvas.getBoundingClientRect();
    const place = new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
    const ray = new Raycaster();
    ray.setFromCamera(place, this.camera.eye);
    this.onTap(ray.intersectObjects(this.world.children, true));
  };
}

