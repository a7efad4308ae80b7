import { BackSide, Box3, type BufferGeometry, DoubleSide, type Side, Vector3 } from 'three';

/** Volumes that surfaces enclose, by geometry, as parts of their bounding boxes. */
const enclosed = new WeakMap<BufferGeometry, number>();

/** The least part of its bounding box that a surface encloses from inside, to count as a room; a bent sheet encloses less. */
const ROOM = 0.3;

// Valid within one call.
const scratchBox = new Box3();
const scratchCenter = new Vector3();
const scratchA = new Vector3();
const scratchB = new Vector3();
const scratchC = new Vector3();

/**
 * Whether a surface shows its faces only to its inside, as the walls of a room do. Such a surface has no outside that a hull could surround:
 * its hull would cover it, and from outside hide what is in the room.
 *
 * @param side The side of its faces that is visible.
 */
export function isSeenFromInside(geometry: BufferGeometry, side: Side): boolean {
  if (side === DoubleSide) return false;
  const part = enclosed.get(geometry) ?? enclosedPart(geometry);
  enclosed.set(geometry, part);
  return (side === BackSide ? part : -part) > ROOM;
}

/** The volume that the counterclockwise sides of triangles enclose from outside, relative to their bounding box; negative from inside. */
function enclosedPart({ index, attributes }: BufferGeometry): number {
  const { position } = attributes;
  if (!position) return 0;
  scratchBox.makeEmpty();
  for (let i = 0; i < position.count; i++) scratchBox.expandByPoint(scratchA.fromBufferAttribute(position, i));
  // Surfaces with openings have a volume only relative to a point.
  scratchBox.getCenter(scratchCenter);
  const corner = (i: number, into: Vector3): Vector3 => into.fromBufferAttribute(position, index?.getX(i) ?? i).sub(scratchCenter);
  let volume = 0;
  for (let i = 0; i + 2 < (index?.count ?? position.count); i += 3)
    volume += corner(i, scratchA).dot(corner(i + 1, scratchB).cross(corner(i + 2, scratchC))) / 6;
  const { x, y, z } = scratchBox.getSize(scratchA);
  return x * y * z > 0 ? volume / (x * y * z) : 0;
}
