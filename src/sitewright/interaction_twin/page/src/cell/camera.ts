// Where one looks from: a few named views and one's own fingers.
import { Box3, MathUtils, PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

export type View = "whole" | "top" | "front" | "side";

const DIRECTION: Readonly<Record<View, Vector3>> = {
  whole: new Vector3(0.62, -1, 0.62),
  top: new Vector3(0, -0.0001, 1),
  front: new Vector3(0, -1, 0.12),
  side: new Vector3(1, 0, 0.12),
};

/** A camera with controls; every change asks for a new picture. */
export class Camera {
  readonly eye = new PerspectiveCamera(30, 1, 0.05, 120);
  private readonly controls: OrbitControls;
  private bounds = new Box3(new Vector3(-2, -2, 0), new Vector3(2, 2, 2));

  constructor(canvas: HTMLCanvasElement, onChange: () => void) {
    this.eye.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.eye, canvas);
    this.controls.enableDamping = false;
    this.controls.maxPolarAngle = MathUtils.degToRad(96);
    this.controls.minDistance = 0.4;
    this.controls.maxDistance = 40;
    this.controls.addEventListener("change", onChange);
  }

  resize(width: number, height: number): void {
    this.eye.aspect = width / Math.max(height, 1);
    this.eye.updateProjectionMatrix();
  }

  setBounds(bounds: Box3): void {
    this.bounds = bounds;
  }

  /** Looks at everything from a named side. */
  look(view: View): void {
    const middle = this.bounds.getCenter(new Vector3());
    this.from(DIRECTION[view], middle, this.distance(DIRECTION[view]));
  }

  /** Looks at a box from the side that is looked from now; returns what brings the eye back. */
  frame(box: Box3): () => void {
    const eye = this.eye.position.clone();
    const target = this.controls.target.clone();
    const bounds = this.bounds;
    const direction = eye.clone().sub(target);
    this.bounds = box;
    this.from(direction, box.getCenter(new Vector3()), this.distance(direction));
    this.bounds = bounds;
    return () => {
      this.eye.position.copy(eye);
      this.controls.target.copy(target);
      this.controls.update();
    };
  }

  /** Looks over a robot's shoulder at the middle of the cell. */
  lookFrom(base: Vector3): void {
    const middle = this.bounds.getCenter(new Vector3());
    const back = base.clone().sub(middle).setZ(0);
    const direction = back.normalize().multiplyScalar(1).setZ(0.55);
    this.from(direction, middle, this.distance(direction) * 0.86);
  }

  /** Keeps a point in the middle without turning. */
  follow(point: Vector3): void {
    const move = point.clone().sub(this.controls.target).multiplyScalar(1);
    this.eye.position.add(move);
    this.controls.target.add(move);
    this.controls.update();
  }

  private from(direction: Vector3, target: Vector3, distance: number): void {
    this.controls.target.copy(target);
    this.eye.position.copy(direction).normalize().multiplyScalar(distance).add(target);
    this.controls.update();
  }

  /** Returns how far away the whole box just fits, by its corners as seen from the direction. */
  private distance(direction: Vector3): number {
    const middle = this.bounds.getCenter(new Vector3());
    const probe = new PerspectiveCamera(this.eye.fov, this.eye.aspect);
    probe.up.set(0, 0, 1);
    probe.position.copy(direction).normalize().add(middle);
    probe.lookAt(middle);
    probe.updateMatrixWorld();
    const tanV = Math.tan(MathUtils.degToRad(this.eye.fov / 2));
    const tanH = tanV * this.eye.aspect;
    const { min, max } = this.bounds;
    let best = 1;
    for (const x of [min.x, max.x])
      for (const y of [min.y, max.y])
        for (const z of [min.z, max.z]) {
          const p = new Vector3(x, y, z).applyMatrix4(probe.matrixWorldInverse);
          best = Math.max(best, p.z + 1 + Math.abs(p.x) / tanH, p.z + 1 + Math.abs(p.y) / tanV);
        }
    return best * 0.94;
  }

  dispose(): void {
    this.controls.dispose();
  }
}
