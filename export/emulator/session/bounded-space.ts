import { P_REF_SPACE, type XRRigidTransform, type XRSpace } from 'iwer';
import { Matrix4, Vector3 } from 'three';
import type { Room } from '../rooms/room.ts';
import { EmulatedReferenceSpace } from './emulated-reference-space.ts';

type SpaceType = Exclude<EmulatedReferenceSpace[typeof P_REF_SPACE]['type'], null>;

/** `XRBoundedReferenceSpace` of WebXR Device API §9.3: the floor area that the user has cleared. */
export class EmulatedBoundedReferenceSpace extends EmulatedReferenceSpace {
  /** Corners on the floor, in this space, clockwise as seen from above. */
  readonly boundsGeometry: readonly DOMPointReadOnly[];

  constructor(type: SpaceType, parent: XRSpace, corners: readonly DOMPointReadOnly[], offset?: Float32Array) {
    super(type, parent, offset);
    this.boundsGeometry = Object.freeze([...corners]);
  }

  override getOffsetReferenceSpace(originOffset: object): EmulatedBoundedReferenceSpace {
    const { matrix } = originOffset as XRRigidTransform;
    const offsetFromSpace = new Matrix4().fromArray(Array.from(matrix)).invert();
    const corners = this.boundsGeometry.map(({ x, y, z }) => toPoint(new Vector3(x, y, z).applyMatrix4(offsetFromSpace)));
    return new EmulatedBoundedReferenceSpace(this[P_REF_SPACE].type as SpaceType, this, corners, new Float32Array(matrix));
  }
}

/** The room's floor, or a square of 3 m without a room. */
export function boundsOf(room: Room | null): DOMPointReadOnly[] {
  const floor = room?.planes.find(({ label }) => label === 'floor');
  if (!floor) return CLEARED.map(([x, z]) => new DOMPointReadOnly(x, 0, z, 1));
  const worldFromPlane = new Matrix4().fromArray([...floor.worldFromPlane]);
  const corners = floor.polygonXZ.map(([x, z]) => {
    const corner = new Vector3(x, 0, z).applyMatrix4(worldFromPlane);
    return toPoint(new Vector3(toStep(corner.x), 0, toStep(corner.z)));
  });
  return isClockwise(corners) ? corners : corners.reverse();
}

const CLEARED = [
  [-1.5, -1.5],
  [1.5, -1.5],
  [1.5, 1.5],
  [-1.5, 1.5],
] as const;

/** Rounds to 5 cm, so that the size does not identify the room. */
function toStep(m: number): number {
  return Math.round(m * 20) / 20 + 0;
}

function toPoint({ x, y, z }: Vector3): DOMPointReadOnly {
  return new DOMPointReadOnly(x, y, z, 1);
}

/** Whether corners are in clockwise order, seen from above with x to the right and z down. */
function isClockwise(corners: readonly DOMPointReadOnly[]): boolean {
  const doubleArea = corners.reduce((sum, { x, z }, i) => {
    const next = corners[(i + 1) % corners.length];
    return sum + (next ? x * next.z - next.x * z : 0);
  }, 0);
  return doubleArea > 0;
}
