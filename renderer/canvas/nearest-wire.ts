import { type Box, type Curve, type Distance, distanceToCurve, isNearer } from './curve-distance.ts';

/** Greatest distance from a wire at which something dropped goes onto it, in client pixels. */
const REACH_PX = 24;
/** Error of a distance, in client pixels. */
const TOLERANCE_PX = 1;

/** What is drawn by each path, by its path data. */
const drawn = new WeakMap<SVGPathElement, { readonly data: string; readonly curve: Curve }>();

/**
 * Id of the accepted wire nearest to a rectangle in client pixels, by the distance to the drawn line; null if none is within 24 px. Of wires
 * that cross the rectangle, the one nearest to its center.
 */
export function nearestWire(client: Box, accepts: (id: string) => boolean): string | null {
  const paths = document.querySelectorAll<SVGPathElement>('.react-flow__edge-path');
  // All wires have the transform of the canvas. Distances are measured in its units, in which curves do not change when it moves.
  const toClient = paths[0]?.getScreenCTM();
  if (!toClient) return null;
  const { a: zoom, e: left, f: top } = toClient;
  const box = { x: (client.x - left) / zoom, y: (client.y - top) / zoom, width: client.width / zoom, height: client.height / zoom };
  let nearest: string | null = null;
  let least: Distance = { toBox: REACH_PX / zoom, toCenter: Number.POSITIVE_INFINITY };
  for (const path of paths) {
    const distance = distanceToCurve(curveOf(path), box, least, TOLERANCE_PX / zoom);
    if (!isNearer(distance, least)) continue;
    const id = path.closest('.react-flow__edge')?.getAttribute('data-id');
    if (id === null || id === undefined || !accepts(id)) continue;
    nearest = id;
    least = distance;
  }
  return nearest;
}

/** The curve that `stretchPath` wrote. */
function curveOf(path: SVGPathElement): Curve {
  const data = path.getAttribute('d') ?? '';
  const known = drawn.get(path);
  if (known?.data === data) return known.curve;
  const curve = (data.match(/-?\d[\d.]*(?:e-?\d+)?/g) ?? []).map(Number) as readonly number[] as Curve;
  drawn.set(path, { data, curve });
  return curve;
}
