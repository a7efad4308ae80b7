import type { Capability } from '../../../../nodes/kit/definition.ts';
import type { DetectedMesh, DetectedPlane, DetectedSurfaces } from '../../../../nodes/kit/session.ts';
import type { XrMesh, XrPlane } from './webxr-types.ts';

/** Planes and meshes that the browser detects, in world space. */
export interface SurfaceReader {
  read(frame: XRFrame, referenceSpace: XRReferenceSpace): DetectedSurfaces;
}

type Mutable<T> = { -readonly [K in keyof T]: T[K] };

/** A plane or mesh of the browser, which keeps the same object for the same surface (Plane Detection §2.1, Mesh Detection §2.1). */
interface XrSurface {
  readonly lastChangedTime: number;
}

interface Tracked<X, S> {
  readonly xr: X;
  readonly surface: Mutable<S>;
  changedMs: number;
  /** Number of the last frame that contained the surface. */
  frame: number;
}

/** Creates a reader, or null if neither planes nor meshes were granted. */
export function createSurfaceReader(capabilities: ReadonlySet<Capability>): SurfaceReader | null {
  if (!capabilities.has('planes') && !capabilities.has('meshes')) return null;
  const planes = createTracker<XrPlane, DetectedPlane>('plane', createPlane, fillPlane, (plane) => plane.planeSpace);
  const meshes = createTracker<XrMesh, DetectedMesh>('mesh', createMesh, fillMesh, (mesh) => mesh.meshSpace);
  const surfaces: DetectedSurfaces = { planes: planes.surfaces, meshes: meshes.surfaces };
  return {
    read: (frame, referenceSpace) => {
      if (capabilities.has('planes')) planes.update(frame.detectedPlanes as ReadonlySet<XrPlane> | undefined, frame, referenceSpace);
      if (capabilities.has('meshes')) meshes.update(frame.detectedMeshes as ReadonlySet<XrMesh> | undefined, frame, referenceSpace);
      return surfaces;
    },
  };
}

interface Tracker<X, S> {
  readonly surfaces: readonly S[];
  update(detected: ReadonlySet<X> | undefined, frame: XRFrame, referenceSpace: XRReferenceSpace): void;
}

function createTracker<X extends XrSurface, S extends { version: number; readonly worldFromSurface: Float32Array }>(
  name: string,
  create: (id: string, xr: X) => Mutable<S>,
  fill: (surface: Mutable<S>, xr: X) => void,
  spaceOf: (xr: X) => XRSpace,
): Tracker<X, S> {
  const surfaces: S[] = [];
  const tracked = new Map<X, Tracked<X, S>>();
  let made = 0;
  let frameCount = 0;
  let xrFrame: XRFrame | null = null;
  let worldSpace: XRReferenceSpace | null = null;

  function add(xr: X): Tracked<X, S> {
    const surface = create(`${name}-${++made}`, xr);
    fill(surface, xr);
    const entry = { xr, surface, changedMs: xr.lastChangedTime, frame: frameCount };
    tracked.set(xr, entry);
    surfaces.push(surface as S);
    return entry;
  }

  // Defined once, because the set is visited in every frame.
  function see(xr: X): void {
    const entry = tracked.get(xr) ?? add(xr);
    entry.frame = frameCount;
    if (xr.lastChangedTime !== entry.changedMs) {
      entry.changedMs = xr.lastChangedTime;
      fill(entry.surface, xr);
      entry.surface.version++;
    }
    // A surface without a pose in this frame keeps its last one.
    const pose = worldSpace && xrFrame?.getPose(spaceOf(xr), worldSpace);
    if (pose) entry.surface.worldFromSurface.set(pose.transform.matrix);
  }

  function drop(entry: Tracked<X, S>): void {
    if (entry.frame === frameCount) return;
    tracked.delete(entry.xr);
    surfaces.splice(surfaces.indexOf(entry.surface as S), 1);
  }

  return {
    surfaces,
    update: (detected, frame, referenceSpace) => {
      frameCount++;
      xrFrame = frame;
      worldSpace = referenceSpace;
      detected?.forEach(see);
      xrFrame = null;
      tracked.forEach(drop);
    },
  };
}

function createPlane(id: string): Mutable<DetectedPlane> {
  return { id, version: 0, label: '', worldFromSurface: new Float32Array(16), orientation: 'other', outlineXZ: new Float32Array(0) };
}

function fillPlane(plane: Mutable<DetectedPlane>, xr: XrPlane): void {
  plane.label = xr.semanticLabel ?? '';
  plane.orientation = xr.orientation ?? 'other';
  plane.outlineXZ = Float32Array.from(xr.polygon.flatMap(({ x, z }) => [x, z]));
}

function createMesh(id: string): Mutable<DetectedMesh> {
  return { id, version: 0, label: '', worldFromSurface: new Float32Array(16), positions: new Float32Array(0), indices: new Uint32Array(0) };
}

/** Updates a mesh. Its arrays are copied, because the browser may reuse them. */
function fillMesh(mesh: Mutable<DetectedMesh>, xr: XrMesh): void {
  mesh.label = xr.semanticLabel ?? '';
  mesh.positions = Float32Array.from(xr.vertices);
  mesh.indices = Uint32Array.from(xr.indices);
}
