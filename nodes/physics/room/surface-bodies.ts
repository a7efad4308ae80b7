import { ShapeUtils, Vector2 } from 'three';
import { type BodyDescription, type BodyList, type BodyShape, createPhysicsBody, type PhysicsBody } from '../../kit/physics.ts';
import type { DetectedMesh, DetectedPlane, DetectedSurface, DetectedSurfaces } from '../../kit/session.ts';

/** A surface that has moved less than this, in any element of its matrix, stays: otherwise tracking would keep bodies on it awake. */
const STILL = 1e-3;

/** Static bodies in the shape of the surfaces that the session detects. */
export interface SurfaceBodies {
  /** Adds and removes bodies, moves those whose surfaces have moved, and replaces changed shapes. Call it once per frame. */
  update(surfaces: DetectedSurfaces | null): void;
}

interface Entry {
  readonly surface: DetectedSurface;
  readonly version: number;
  /** Null for a surface without area. */
  readonly body: PhysicsBody | null;
  seen: number;
}

/**
 * Creates the bodies.
 *
 * @param list Receives the bodies.
 * @param description What the bodies are, but for their shapes.
 */
export function createSurfaceBodies(
  node: string,
  list: BodyList,
  description: Omit<BodyDescription, 'shapes'>,
  wants: { readonly planes: boolean; readonly meshes: boolean },
): SurfaceBodies {
  const entries = new Map<DetectedSurface, Entry>();
  let round = 0;

  function remove({ surface, body }: Entry): void {
    entries.delete(surface);
    if (!body) return;
    list.bodies.splice(list.bodies.indexOf(body), 1);
    list.version++;
  }
  function add(surface: DetectedSurface, key: string, shape: BodyShape | null): Entry {
    const body = shape && createPhysicsBody(`${node}/${key}`, { ...description, shapes: [shape] });
    if (body) {
      body.worldFromTarget.set(surface.worldFromSurface);
      list.bodies.push(body);
      list.version++;
    }
    const entry = { surface, version: surface.version, body, seen: round };
    entries.set(surface, entry);
    return entry;
  }
  /** The entry of a surface in its present shape; undefined if its body has to be made. */
  function current(surface: DetectedSurface): Entry | undefined {
    const known = entries.get(surface);
    if (known?.version === surface.version) return known;
    if (known) remove(known);
    return undefined;
  }
  function see(entry: Entry): void {
    entry.seen = round;
    const { surface, body } = entry;
    if (body && hasMoved(body, surface)) body.worldFromTarget.set(surface.worldFromSurface);
  }
  const removeUnseen = (entry: Entry): void => {
    if (entry.seen !== round) remove(entry);
  };

  return {
    update: (surfaces) => {
      round++;
      for (let i = 0; wants.planes && i < (surfaces?.planes.length ?? 0); i++) {
        const plane = surfaces?.planes[i];
        if (plane) see(current(plane) ?? add(plane, `plane ${plane.id}`, shapeOfPlane(plane)));
      }
      for (let i = 0; wants.meshes && i < (surfaces?.meshes.length ?? 0); i++) {
        const mesh = surfaces?.meshes[i];
        if (mesh) see(current(mesh) ?? add(mesh, `mesh ${mesh.id}`, shapeOfMesh(mesh)));
      }
      entries.forEach(removeUnseen);
    },
  };
}

function hasMoved({ worldFromTarget }: PhysicsBody, { worldFromSurface }: DetectedSurface): boolean {
  for (let i = 0; i < 16; i++) if (Math.abs((worldFromTarget[i] ?? 0) - (worldFromSurface[i] ?? Number.NaN)) > STILL) return true;
  return false;
}

function shapeOfPlane({ outlineXZ }: DetectedPlane): BodyShape | null {
  const corners: Vector2[] = [];
  for (let i = 0; i + 1 < outlineXZ.length; i += 2) corners.push(new Vector2(outlineXZ[i], outlineXZ[i + 1]));
  if (corners.length < 3) return null;
  const indices = Uint32Array.from(ShapeUtils.triangulateShape(corners, []).flat());
  return indices.length > 0 ? { kind: 'mesh', positionsM: Float32Array.from(corners.flatMap(({ x, y }) => [x, 0, y])), indices } : null;
}

function shapeOfMesh({ positions, indices }: DetectedMesh): BodyShape | null {
  // Copies, because a session may write the next mesh to the same memory.
  return indices.length >= 3 ? { kind: 'mesh', positionsM: positions.slice(), indices: indices.slice() } : null;
}
