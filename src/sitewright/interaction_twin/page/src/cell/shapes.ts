// Shapes of the scene as geometries that are made once each, with their edges.
import { BufferAttribute, BufferGeometry, EdgesGeometry } from "three";
import type { Geometry } from "../wire";

const CREASE_DEG = 20;

/** Makes geometries by id; equal ids share one. */
export class Shapes {
  private readonly solids = new Map<string, BufferGeometry>();
  private readonly edges = new Map<string, BufferGeometry>();

  constructor(private readonly records: Readonly<Record<string, Geometry>>) {}

  solid(id: string): BufferGeometry {
    let found = this.solids.get(id);
    if (found === undefined) {
      found = faceted(this.record(id));
      this.solids.set(id, found);
    }
    return found;
  }

  edge(id: string): BufferGeometry {
    let found = this.edges.get(id);
    if (found === undefined) {
      found = new EdgesGeometry(this.solid(id), CREASE_DEG);
      this.edges.set(id, found);
    }
    return found;
  }

  dispose(): void {
    for (const geometry of [...this.solids.values(), ...this.edges.values()]) geometry.dispose();
  }

  private record(id: string): Geometry {
    const record = this.records[id];
    if (record === undefined) throw new Error(`the scene has no geometry ${id}`);
    return record;
  }
}

/** Returns triangles with a normal of their own each: convex envelopes look as flat as they are. */
function faceted(record: Geometry): BufferGeometry {
  const positions = new Float32Array(record.triangles.length * 9);
  record.triangles.flat().forEach((corner, at) => {
    const point = record.corners_m[corner];
    if (point === undefined) throw new Error(`a triangle names corner ${corner}, which is not there`);
    positions.set(point, at * 3);
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.computeVertexNormals();
  geometry.computeBoundingSphere();
  return geometry;
}
