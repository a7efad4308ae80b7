import { Matrix4, Vector3, Vector4 } from 'three';
import type { BodyShape } from '../../../nodes/kit/physics.ts';
import type { ViewFrame } from '../../../nodes/kit/session.ts';
import type { ViewBox } from '../gizmo/tool.ts';

/** Draws lines and dots of world space on a canvas over the preview, which screenshots and videos do not contain. */
export interface Pencil {
  readonly canvas: HTMLCanvasElement;
  /** Clears the canvas for a frame. */
  begin(view: Pick<ViewFrame, 'clipFromView' | 'worldFromView'>, box: ViewBox): void;
  /** The edges of a polyhedron, or three circles of a sphere. */
  shape(worldFromBody: ArrayLike<number>, shape: BodyShape, color: string): void;
  arrow(worldFromBody: ArrayLike<number>, velocity: ArrayLike<number>, seconds: number, color: string): void;
  /** A square that is as wide as a length at its place, and at least some pixels. */
  dot(pointWorld: ArrayLike<number>, widthM: number, leastPx: number, color: string): void;
  /** A text to the right of a point. */
  label(pointWorld: ArrayLike<number>, text: string, color: string): void;
  hide(): void;
}

/** What is nearer is not drawn, meters. */
const NEAR_M = 0.05;
const CIRCLE_STEPS = 24;
/** From a point to its label. */
const LABEL_PX = 8;
/** The most triangles of a body that are drawn. */
const MOST_TRIANGLES = 3000;

// Each is valid within one call.
const scratchMatrix = new Matrix4();
const scratchPoint = new Vector3();
const scratchClip = new Vector4();

interface Place {
  readonly x: number;
  readonly y: number;
  /** Pixels of a meter there. */
  readonly perM: number;
}

export function createPencil(parent: HTMLElement): Pencil {
  const canvas = parent.ownerDocument.createElement('canvas');
  canvas.id = 'physics';
  parent.append(canvas);
  const made = canvas.getContext('2d');
  if (!made) throw new Error('The browser has no 2D canvas.');
  const context = made;
  const clipFromWorld = new Matrix4();
  let box: ViewBox = { left: 0, top: 0, width: 1, height: 1 };
  let focal = 1;

  function placeOf(p: Vector3): Place | null {
    const { x, y, w } = scratchClip.set(p.x, p.y, p.z, 1).applyMatrix4(clipFromWorld);
    if (w < NEAR_M) return null;
    const left = box.left + (0.5 + (0.5 * x) / w) * box.width;
    const top = box.top + (0.5 - (0.5 * y) / w) * box.height;
    return { x: left, y: top, perM: (0.5 * focal * box.height) / w };
  }
  function line(points: readonly (Place | null)[], color: string): void {
    context.strokeStyle = color;
    context.beginPath();
    let isDown = false;
    for (const place of points) {
      if (place && isDown) context.lineTo(place.x, place.y);
      else if (place) context.moveTo(place.x, place.y);
      isDown = place !== null;
    }
    context.stroke();
  }
  function loop(points: readonly Vector3[], color: string): void {
    const places = points.map(placeOf);
    line([...places, places[0] ?? null], color);
  }
  const point = (worldFromBody: Matrix4, x: number, y: number, z: number) => new Vector3(x, y, z).applyMatrix4(worldFromBody);

  return {
    canvas,
    begin: ({ clipFromView, worldFromView }, at) => {
      canvas.hidden = false;
      const { innerWidth, innerHeight, devicePixelRatio } = window;
      const [width, height] = [Math.round(innerWidth * devicePixelRatio), Math.round(innerHeight * devicePixelRatio)];
      // A new size clears, too.
      if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
      context.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
      context.clearRect(0, 0, innerWidth, innerHeight);
      context.lineWidth = 1.5;
      box = at;
      focal = clipFromView[5] ?? 1;
      clipFromWorld.fromArray(clipFromView).multiply(scratchMatrix.fromArray(worldFromView).invert());
    },
    shape: (worldFromBody, shape, color) => {
      const world = new Matrix4().fromArray([...(worldFromBody as Float64Array)]);
      if (shape.kind === 'hull') {
        const corners = shape.verticesM.map((vertex) => point(world, ...vertex));
        for (const face of shape.faces)
          loop(
            face.flatMap((i) => corners[i] ?? []),
            color,
          );
      }
      if (shape.kind === 'mesh') {
        const { positionsM: m, indices } = shape;
        const corner = (i: number) => point(world, m[3 * i] ?? 0, m[3 * i + 1] ?? 0, m[3 * i + 2] ?? 0);
        const end = Math.min(indices.length, 3 * MOST_TRIANGLES);
        for (let i = 0; i + 2 < end; i += 3)
          loop([corner(indices[i] ?? 0), corner(indices[i + 1] ?? 0), corner(indices[i + 2] ?? 0)], color);
      }
      if (shape.kind !== 'sphere') return;
      const [cx, cy, cz] = shape.centerM;
      for (let axis = 0; axis < 3; axis++) {
        const circle = Array.from({ length: CIRCLE_STEPS }, (_, i) => {
          const angle = (2 * Math.PI * i) / CIRCLE_STEPS;
          const [u, v] = [shape.radiusM * Math.cos(angle), shape.radiusM * Math.sin(angle)];
          if (axis === 0) return point(world, cx, cy + u, cz + v);
          return axis === 1 ? point(world, cx + u, cy, cz + v) : point(world, cx + u, cy + v, cz);
        });
        loop(circle, color);
      }
    },
    arrow: (worldFromBody, velocity, seconds, color) => {
      const at = (i: number) => worldFromBody[12 + i] ?? 0;
      const to = (i: number) => at(i) + seconds * (velocity[i] ?? 0);
      const from = placeOf(scratchPoint.set(at(0), at(1), at(2)));
      line([from, placeOf(scratchPoint.set(to(0), to(1), to(2)))], color);
    },
    dot: (pointWorld, widthM, leastPx, color) => {
      const place = placeOf(scratchPoint.set(pointWorld[0] ?? 0, pointWorld[1] ?? 0, pointWorld[2] ?? 0));
      if (!place) return;
      const size = Math.max(leastPx, widthM * place.perM);
      context.fillStyle = color;
      context.fillRect(place.x - size / 2, place.y - size / 2, size, size);
    },
    label: (pointWorld, text, color) => {
      const place = placeOf(scratchPoint.set(pointWorld[0] ?? 0, pointWorld[1] ?? 0, pointWorld[2] ?? 0));
      if (!place) return;
      context.font = '12px system-ui, sans-serif';
      context.lineWidth = 3;
      context.strokeStyle = 'rgb(0 0 0 / 70%)';
      context.strokeText(text, place.x + LABEL_PX, place.y + LABEL_PX / 2);
      context.lineWidth = 1.5;
      context.fillStyle = color;
      context.fillText(text, place.x + LABEL_PX, place.y + LABEL_PX / 2);
    },
    hide: () => {
      if (canvas.hidden) return;
      canvas.hidden = true;
      canvas.dataset.bodies = '0';
      canvas.dataset.voxels = '0';
    },
  };
}
