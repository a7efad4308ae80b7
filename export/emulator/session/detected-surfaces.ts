import type { XRFrame } from 'iwer';
import { type GlobalSpace, NativeMesh, NativePlane, P_FRAME, XRMesh, XRPlane, XRRigidTransform, XRSpace } from 'iwer';
import type { Room } from '../rooms/room.ts';

/** Detected planes and meshes of a session: created in the first frame with a known room and never changed. */
export interface Surfaces {
  addPlanes(frame: XRFrame): void;
  addMeshes(frame: XRFrame): void;
  /** Makes the room known: later frames contain its planes and meshes. */
  scan(): void;
}

export function createSurfaces(room: () => Room | null, world: GlobalSpace, isScanned: boolean): Surfaces {
  let scanned = isScanned;
  let planes: XRPlane[] | null = null;
  let meshes: XRMesh[] | null = null;
  return {
    scan: () => {
      scanned = true;
    },
    addPlanes: (frame) => {
      if (!scanned) return;
      planes ??= (room()?.planes ?? []).map((plane) => new EmulatedPlane(plane, world, frame.predictedDisplayTime));
      for (const plane of planes) frame[P_FRAME].detectedPlanes.add(plane);
    },
    addMeshes: (frame) => {
      if (!scanned) return;
      meshes ??= (room()?.meshes ?? []).map((mesh) => new EmulatedMesh(mesh, world, frame.predictedDisplayTime));
      for (const mesh of meshes) frame[P_FRAME].detectedMeshes.add(mesh);
    },
  };
}

type Label = ConstructorParameters<typeof NativePlane>[2];

/**
 * A plane with the room's own orientation, unchanged since its first frame. iwer would derive the orientation from the label and report a
 * change in every frame.
 */
class EmulatedPlane extends XRPlane {
  readonly #orientation: 'horizontal' | 'vertical';
  readonly #seenMs: number;

  constructor({ label, worldFromPlane, polygonXZ, orientation }: Room['planes'][number], world: GlobalSpace, seenMs: number) {
    const polygon = polygonXZ.map(([x, z]) => new DOMPointReadOnly(x, 0, z));
    const native = new NativePlane(new XRRigidTransform(), polygon, label as Label);
    super(native, new XRSpace(world, new Float32Array(worldFromPlane)), polygon, label as Label);
    this.#orientation = orientation;
    this.#seenMs = seenMs;
  }

  override get orientation(): never {
    return this.#orientation as never;
  }

  override get lastChangedTime(): number {
    return this.#seenMs;
  }
}

class EmulatedMesh extends XRMesh {
  readonly #seenMs: number;

  constructor({ label, worldFromMesh, vertices, indices }: Room['meshes'][number], world: GlobalSpace, seenMs: number) {
    const native = new NativeMesh(new XRRigidTransform(), vertices, indices, label as Label);
    super(native, new XRSpace(world, new Float32Array(worldFromMesh)), vertices, indices, label as Label);
    this.#seenMs = seenMs;
  }

  override get lastChangedTime(): number {
    return this.#seenMs;
  }
}
