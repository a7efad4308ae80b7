import { CAPTURE_LIMITS, CaptureError, type CaptureMesh, checkMesh } from '../../nodes/kit/capture.ts';

/** Collects the vertices and polygons of a mesh. */
export interface MeshBuilder {
  vertex(x: number, y: number, z: number): void;
  /** Splits a polygon into triangles around its first corner. */
  polygon(corners: readonly number[]): void;
  /** @throws CaptureError if the mesh is empty, too large or refers to missing vertices. */
  build(): CaptureMesh;
}

export function createMeshBuilder(): MeshBuilder {
  let positions = new Float32Array(3 * 1024);
  let indices = new Uint32Array(3 * 1024);
  let vertices = 0;
  let triangles = 0;
  return {
    vertex: (x, y, z) => {
      if (vertices >= CAPTURE_LIMITS.vertices) throw tooLarge();
      if (3 * vertices === positions.length) {
        const larger = new Float32Array(2 * positions.length);
        larger.set(positions);
        positions = larger;
      }
      positions.set([x, y, z], 3 * vertices++);
    },
    polygon: (corners) => {
      for (let i = 2; i < corners.length; i++) {
        if (triangles >= CAPTURE_LIMITS.triangles) throw tooLarge();
        if (3 * triangles === indices.length) {
          const larger = new Uint32Array(2 * indices.length);
          larger.set(indices);
          indices = larger;
        }
        indices.set([corners[0] ?? 0, corners[i - 1] ?? 0, corners[i] ?? 0], 3 * triangles++);
      }
    },
    build: () => {
      if (triangles === 0) throw new CaptureError('the mesh has no triangles, only points. Make a mesh of them, as with COLMAP’s meshers');
      const mesh = { positions: positions.slice(0, 3 * vertices), indices: indices.slice(0, 3 * triangles) };
      checkMesh(mesh);
      return mesh;
    },
  };
}

/** The refusal of a mesh with too many vertices or triangles. */
export function tooLarge(): CaptureError {
  return new CaptureError(`the mesh has more than ${CAPTURE_LIMITS.triangles} triangles. Simplify it, as with Blender’s Decimate`);
}
