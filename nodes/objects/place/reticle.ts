import { DoubleSide, Group, Matrix4, Mesh, MeshBasicMaterial, Quaternion, RingGeometry, Vector3 } from 'three';
import type { ObjectItem } from '../../kit/scene-lists.ts';
import type { SessionFrame } from '../../kit/session.ts';

/**
 * The reticle: shows where a tap would place, as a ring on the surface, or as four arcs in front of the viewer while no surface is found.
 */
export interface Reticle {
  /** The items of the reticle for the output list; always the same. They are hidden while they are not shown. */
  readonly items: readonly ObjectItem[];
  /**
   * Updates the items. Call it once per frame.
   *
   * @param worldFromHit Column-major 4×4, rigid, y along the normal; null while no surface is found.
   * @param timeS The time that rotates the arcs, seconds.
   */
  update(shown: boolean, worldFromHit: ArrayLike<number> | null, frame: SessionFrame, timeS: number): void;
  dispose(): void;
}

const RADIUS_M = 0.08;
const WIDTH_M = 0.012;
/** Width of the dark rim, which makes the ring visible on bright floors. */
const RIM_M = 0.004;
/** Height of the ring above the surface, so that detected planes and the noise of depth do not hide it. */
const LIFT_M = 0.006;
/** Distance up to which the ring has its normal size; farther away it grows, so that it stays visible. */
const REFERENCE_M = 1.5;
const MAX_SCALE = 3;
const SEARCH_AHEAD_M = 1;
const TURNS_PER_S = 0.25;

// Filled and read within one call.
const scratchPoint = new Vector3();
const scratchEye = new Vector3();
const scratchScale = new Vector3();
const scratchRotation = new Quaternion();
const scratchTurn = new Quaternion();
const AHEAD = new Vector3(0, 0, 1);

export function createReticle(): Reticle {
  const white = new MeshBasicMaterial({ color: 0xffffff, side: DoubleSide });
  const dark = new MeshBasicMaterial({ color: 0x101418, side: DoubleSide });
  const geometries: RingGeometry[] = [];
  const ring = (inner: number, outer: number, startRad = 0, lengthRad = 2 * Math.PI): RingGeometry => {
    const made = new RingGeometry(inner, outer, 48, 1, startRad, lengthRad);
    geometries.push(made);
    return made;
  };
  const found = new Group();
  const lies = -Math.PI / 2;
  found.add(new Mesh(ring(RADIUS_M - WIDTH_M, RADIUS_M).rotateX(lies), white), new Mesh(ring(0, WIDTH_M / 2).rotateX(lies), white));
  found.add(new Mesh(ring(RADIUS_M, RADIUS_M + RIM_M).rotateX(lies), dark));
  const searching = new Group();
  for (let i = 0; i < 4; i++) {
    const startRad = (i * Math.PI) / 2;
    searching.add(new Mesh(ring(RADIUS_M - WIDTH_M, RADIUS_M, startRad, 0.9), white));
    searching.add(new Mesh(ring(RADIUS_M, RADIUS_M + RIM_M, startRad, 0.9), dark));
  }
  const itemOf = (key: string, root: Group): ObjectItem => {
    root.updateMatrixWorld(true);
    const worldFromObject = new Matrix4();
    return { key, root, worldFromObject, role: 'virtual', castsShadow: false, receivesShadow: false, hidden: true, pickable: false };
  };
  const foundItem = itemOf('reticle', found);
  const searchingItem = itemOf('reticle-searching', searching);

  function lay(worldFromHit: ArrayLike<number>, eyeM: Vector3): void {
    const { worldFromObject } = foundItem;
    worldFromObject.fromArray(worldFromHit as number[]);
    scratchPoint.setFromMatrixPosition(worldFromObject);
    const scale = Math.min(Math.max(scratchPoint.distanceTo(eyeM) / REFERENCE_M, 1), MAX_SCALE);
    scratchPoint.addScaledVector(scratchScale.setFromMatrixColumn(worldFromObject, 1), LIFT_M * scale);
    worldFromObject.scale(scratchScale.setScalar(scale)).setPosition(scratchPoint);
  }
  function hang(worldFromView: ArrayLike<number>, timeS: number): void {
    const { worldFromObject } = searchingItem;
    worldFromObject.fromArray(worldFromView as number[]);
    scratchRotation.setFromRotationMatrix(worldFromObject);
    scratchPoint.set(0, 0, -SEARCH_AHEAD_M).applyMatrix4(worldFromObject);
    scratchRotation.multiply(scratchTurn.setFromAxisAngle(AHEAD, -2 * Math.PI * TURNS_PER_S * timeS));
    worldFromObject.compose(scratchPoint, scratchRotation, scratchScale.setScalar(1));
  }

  const items = [foundItem, searchingItem];
  return {
    items,
    update: (shown, worldFromHit, { views, viewCount }, timeS) => {
      const view = viewCount > 0 ? views[0] : undefined;
      foundItem.hidden = !(shown && view && worldFromHit);
      searchingItem.hidden = !(shown && view && !worldFromHit);
      for (let i = 0; i < items.length; i++) items[i]?.worldFromObject.identity();
      if (!view) return;
      if (!foundItem.hidden && worldFromHit) lay(worldFromHit, scratchEye.fromArray(view.worldFromView, 12));
      if (!searchingItem.hidden) hang(view.worldFromView, timeS);
    },
    dispose: () => {
      for (const geometry of geometries) geometry.dispose();
      white.dispose();
      dark.dispose();
    },
  };
}
