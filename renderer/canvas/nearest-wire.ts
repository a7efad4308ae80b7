/** Greatest distance from a wire at which something dropped goes onto it, in client pixels. */
const REACH_PX = 24;
/** Distance between samples of a wire, in client pixels. */
const STEP_PX = 4;

/** A rectangle in client pixels; one without width and height is a point. */
export interface ClientBox {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/**
 * Id of the accepted wire nearest to a rectangle, by the distance to the drawn line; null if none is within 24 px. Of wires that cross the
 * rectangle, the one nearest to its center.
 */
export function nearestWire(box: ClientBox, accepts: (id: string) => boolean): string | null {
  let nearest: string | null = null;
  let least: Distance = { toBoxPx: REACH_PX, toCenterPx: Number.POSITIVE_INFINITY };
  for (const path of document.querySelectorAll<SVGPathElement>('.react-flow__edge-path')) {
    const id = path.closest('.react-flow__edge')?.getAttribute('data-id');
    if (id === null || id === undefined || distanceBetween(path.getBoundingClientRect(), box) > REACH_PX) continue;
    const distance = distanceTo(path, box);
    if (!isNearer(distance, least) || !accepts(id)) continue;
    nearest = id;
    least = distance;
  }
  return nearest;
}

interface Distance {
  readonly toBoxPx: number;
  readonly toCenterPx: number;
}

function isNearer(a: Distance, b: Distance): boolean {
  return a.toBoxPx < b.toBoxPx || (a.toBoxPx === b.toBoxPx && a.toCenterPx < b.toCenterPx);
}

function distanceTo(path: SVGPathElement, box: ClientBox): Distance {
  const toClient = path.getScreenCTM();
  const length = path.getTotalLength();
  const steps = Math.max(1, Math.ceil((length * (toClient?.a ?? 1)) / STEP_PX));
  let least: Distance = { toBoxPx: Number.POSITIVE_INFINITY, toCenterPx: Number.POSITIVE_INFINITY };
  for (let i = 0; i <= steps; i++) {
    const { x, y } = path.getPointAtLength((length * i) / steps).matrixTransform(toClient ?? undefined);
    const distance = {
      toBoxPx: distanceBetween({ x, y, width: 0, height: 0 }, box),
      toCenterPx: Math.hypot(x - (box.x + box.width / 2), y - (box.y + box.height / 2)),
    };
    if (isNearer(distance, least)) least = distance;
  }
  return least;
}

/** Distance between two rectangles; 0 if they overlap. */
function distanceBetween(a: ClientBox, b: ClientBox): number {
  const acrossPx = Math.max(b.x - (a.x + a.width), a.x - (b.x + b.width), 0);
  const downPx = Math.max(b.y - (a.y + a.height), a.y - (b.y + b.height), 0);
  return Math.hypot(acrossPx, downPx);
}
