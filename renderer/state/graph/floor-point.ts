import type { PreviewStatus } from '../../preview-protocol.ts';

/** A point on the floor, at height 0 in world space. */
export type FloorPoint = readonly [x: number, z: number];

/** In front of a visitor at the origin, before the preview shows anything. */
const USUAL: FloorPoint = [0, -1.5];
/** The floor farther away is too far for an object to be seen well. */
const FARTHEST_M = 5;
/** Greatest distance of what is not under the pointer. */
const VISIBLE_M = 3;
/** Parts of the height of the picture, from its middle down to where the floor is near. */
const LOOKED_AT = [0.5, 0.6, 0.7, 0.8, 0.9] as const;

type View = Pick<PreviewStatus, 'worldFromView' | 'tangents'>;

/**
 * The point of the floor that the picture shows at `x`, `y`: fractions of the first view from its top left. Where it shows none that is near
 * enough, one in the same direction, 5 m away.
 */
export function floorUnder(view: View | null, x: number, y: number): FloorPoint {
  return onFloor(view, x, y, FARTHEST_M)?.point ?? USUAL;
}

/** A point of the floor in the middle of the picture, at most 3 m away if the picture shows one. */
export function floorInView(view: View | null): FloorPoint {
  const points = LOOKED_AT.map((y) => onFloor(view, 0.5, y, FARTHEST_M));
  return (points.find((found) => found && found.distanceM <= VISIBLE_M) ?? points.at(-1))?.point ?? USUAL;
}

/** Unit vector in x and z that points to the right of the picture. */
export function rightOnFloor(view: Pick<PreviewStatus, 'worldFromView'> | null): readonly [x: number, z: number] {
  const [x = 1, , z = 0] = view?.worldFromView ?? [];
  const length = Math.hypot(x, z);
  return length === 0 ? [1, 0] : [x / length, z / length];
}

function onFloor(
  view: View | null,
  x: number,
  y: number,
  mostM: number,
): { readonly point: FloorPoint; readonly distanceM: number } | null {
  const { worldFromView: world, tangents } = view ?? {};
  if (!world || !tangents) return null;
  const [right, up] = [tangents.left + x * (tangents.right - tangents.left), tangents.top - y * (tangents.top - tangents.bottom)];
  const along = (axis: number) => (world[axis] ?? 0) * right + (world[4 + axis] ?? 0) * up - (world[8 + axis] ?? 0);
  const [dx, dy, dz] = [along(0), along(1), along(2)];
  const flat = Math.hypot(dx, dz);
  const [eyeX = 0, eyeY = 0, eyeZ = 0] = world.slice(12);
  const hitM = dy < 0 && eyeY > 0 ? (flat * eyeY) / -dy : Number.POSITIVE_INFINITY;
  const distanceM = Math.min(hitM, mostM);
  const part = flat === 0 ? 0 : distanceM / flat;
  return { point: [eyeX + dx * part, eyeZ + dz * part], distanceM };
}
