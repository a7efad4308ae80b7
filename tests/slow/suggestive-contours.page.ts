import { Matrix4, Mesh, MeshLambertMaterial, TorusGeometry, Vector3 } from 'three';
import { createLayer, drawView, lights, lookingAt, objects, sun, viewOf } from '../browser/scenes-kit.ts';
import { drawnWith, loadImages, stand, technique } from '../browser/techniques-kit.ts';

/** Suggestive contours of a torus against its formula: rays meet the exact surface, and derivatives are differences on it. */

const WIDTH = 480;
const HEIGHT = 360;
const [MAJOR, MINOR] = [0.7, 0.28];
/** Radius of the bounding sphere, in which the technique measures. */
const RADIUS = MAJOR + MINOR;
/** Inputs of the technique at which lines have no waves, ends or weights, and the smallest derivative. */
const PLAIN = { suggestive: 1, loosePx: 0, taper: 0, grain: 0, depthWeight: 0, lightWeight: 0, ownColor: 0, shade: 0, rate: 0 };
const COLORS = { inkColor: [0, 0, 0, 1], washColor: [1, 1, 1, 1] };
const FAINTEST = 2;

/** Distance from the torus around the z axis. */
const distance = ({ x, y, z }: Vector3): number => Math.hypot(Math.hypot(x, y) - MAJOR, z) - MINOR;

function normalAt(point: Vector3): Vector3 {
  const outward = new Vector3(point.x, point.y, 0).setLength(MAJOR);
  return point.clone().sub(outward).normalize();
}

function hitBy(eye: Vector3, ray: Vector3): Vector3 | null {
  const point = eye.clone();
  for (let step = 0; step < 200 && point.length() < 9; step++) {
    const away = distance(point);
    if (away < 1e-6) return point;
    point.addScaledVector(ray, away);
  }
  return null;
}

/** The radial curvature at a point of the torus, by its principal curvatures, and the direction in which it is measured. */
function radialAt(point: Vector3, eye: Vector3): { curvature: number; along: Vector3; sine: number; cosine: number } {
  const normal = normalAt(point);
  const view = eye.clone().sub(point).normalize();
  const cosine = view.dot(normal);
  const along = view.clone().addScaledVector(normal, -cosine);
  const sine = along.length();
  along.normalize();
  const around = Math.hypot(point.x, point.y);
  const ring = new Vector3(-point.y, point.x, 0).divideScalar(around);
  const share = along.dot(ring) ** 2;
  return { curvature: share * ((around - MAJOR) / MINOR / around) + (1 - share) / MINOR, along, sine, cosine };
}

export interface Contours {
  /** Pixels of the contours by the formula whose derivative is well above the threshold, and those with ink within 2 pixels. */
  readonly wanted: number;
  readonly found: number;
  /** Pixels of ink away from silhouettes, and those that are within 2 pixels of a contour by the formula. */
  readonly ink: number;
  readonly right: number;
}

/** Contours of a torus that is turned about x, with so many segments around its tube and twice as many along it. */
export async function contours(turnRad: number, eyeM: readonly [number, number, number], segments: number): Promise<Contours> {
  await loadImages();
  const { backend, gl } = stand;
  const layer = createLayer(gl, WIDTH, HEIGHT);
  const at = new Matrix4().makeRotationX(turnRad);
  const camera = lookingAt(eyeM, [0, 0, 0], WIDTH / HEIGHT);
  const root = new Mesh(new TorusGeometry(MAJOR, MINOR, segments, 2 * segments), new MeshLambertMaterial());
  const scene = backend.serviceFor({ shadowMaps: null, occlusion: null }).createScene({ kind: 'shaded', ambient: { value: 1 } });
  scene.update([objects(drawnWith(root, technique('loose-lines', { ...PLAIN, ...COLORS }), at))], [lights(sun([0, 0, 1]))]);
  layer.clear();
  scene.draw(drawView(viewOf(camera, { x: 0, y: 0, widthPx: WIDTH, heightPx: HEIGHT }), layer.framebuffer));
  const pixels = layer.pixels();
  scene.dispose();

  const local = at.clone().invert();
  const eye = new Vector3(...eyeM).applyMatrix4(local);
  const signs = new Int8Array(WIDTH * HEIGHT);
  const strengths = new Float32Array(WIDTH * HEIGHT);
  const isFacing = new Uint8Array(WIDTH * HEIGHT);
  for (let i = 0; i < signs.length; i++) {
    const [x, y] = [((i % WIDTH) + 0.5) / WIDTH, (Math.floor(i / WIDTH) + 0.5) / HEIGHT];
    const through = new Vector3(x * 2 - 1, y * 2 - 1, 0.5).unproject(camera).applyMatrix4(local);
    const point = hitBy(eye, through.sub(eye).normalize());
    if (!point) continue;
    const { curvature, along, sine, cosine } = radialAt(point, eye);
    signs[i] = curvature < 0 ? -1 : 1;
    isFacing[i] = cosine > 0.2 ? 1 : 0;
    const step = 1e-4;
    const ahead = point.clone().addScaledVector(along, step);
    ahead.addScaledVector(normalAt(ahead), -distance(ahead));
    // Only near a contour, where the curvature is 0, is the derivative that of the paper.
    strengths[i] = ((radialAt(ahead, eye).curvature - curvature) / step) * (sine / cosine) * RADIUS * RADIUS;
  }
  const isInk = new Uint8Array(signs.length);
  const isContour = new Uint8Array(signs.length);
  const isStrong = new Uint8Array(signs.length);
  for (let i = WIDTH; i < signs.length - WIDTH; i++) {
    isInk[i] = isFacing[i] && (pixels[i * 4 + 3] ?? 0) > 200 && (pixels[i * 4] ?? 255) < 128 ? 1 : 0;
    if (![1, -1, WIDTH, -WIDTH].some((to) => (signs[i] ?? 0) * (signs[i + to] ?? 0) < 0) || !isFacing[i]) continue;
    isContour[i] = (strengths[i] ?? 0) > FAINTEST * 0.8 ? 1 : 0;
    isStrong[i] = (strengths[i] ?? 0) > FAINTEST * 3 ? 1 : 0;
  }
  const counts = { wanted: 0, found: 0, ink: 0, right: 0 };
  for (let i = 0; i < signs.length; i++) {
    if (isStrong[i]) {
      counts.wanted++;
      if (near(isInk, i)) counts.found++;
    }
    if (isInk[i]) {
      counts.ink++;
      if (near(isContour, i)) counts.right++;
    }
  }
  return counts;
}

function near(marks: Uint8Array, at: number): boolean {
  for (let dy = -2; dy <= 2; dy++) for (let dx = -2; dx <= 2; dx++) if (dx * dx + dy * dy <= 5 && marks[at + dy * WIDTH + dx]) return true;
  return false;
}
