import { AnimationMixer, type Matrix4, Mesh, MeshLambertMaterial, type Object3D, Raycaster, TorusGeometry, Vector2, Vector3 } from 'three';
import { createLayer, drawView, lights, loadUrl, lookingAt, normalizing, objects, sun, viewOf } from '../browser/scenes-kit.ts';
import { drawnWith, loadImages, stand, technique, type Values } from '../browser/techniques-kit.ts';

/** Models of 1 m radius in the styles of the library, and what can be measured in such pictures. */

export interface Shot {
  readonly widthPx: number;
  readonly heightPx: number;
  readonly eye: readonly [number, number, number];
  readonly target: readonly [number, number, number];
  /** Seconds in the first clip of the model. */
  readonly timeS?: number;
}

const layers = new Map<string, ReturnType<typeof createLayer>>();
const models = new Map<string, { readonly root: Object3D; readonly at: Matrix4; readonly mixer: AnimationMixer | null }>();

async function modelOf(name: string): Promise<{ root: Object3D; at: Matrix4; mixer: AnimationMixer | null }> {
  const known = models.get(name);
  if (known) return known;
  if (name === 'torus') {
    const root = new Mesh(new TorusGeometry(0.7, 0.28, 48, 96), new MeshLambertMaterial());
    root.rotation.x = -0.9;
    const made = { root, at: normalizing(root), mixer: null };
    models.set(name, made);
    return made;
  }
  const model = await loadUrl(stand.backend, `/models/${name}`);
  const root = model.instantiate();
  const [clip] = model.clips;
  const mixer = clip ? new AnimationMixer(root) : null;
  if (clip) mixer?.clipAction(clip).play();
  const made = { root, at: normalizing(root), mixer };
  models.set(name, made);
  return made;
}

function layerOf(widthPx: number, heightPx: number): ReturnType<typeof createLayer> {
  const key = `${widthPx}x${heightPx}`;
  const layer = layers.get(key) ?? createLayer(stand.gl, widthPx, heightPx);
  layers.set(key, layer);
  return layer;
}

async function draw(name: string, style: string | null, values: Values, shot: Shot): Promise<Uint8Array> {
  await loadImages();
  const { root, at, mixer } = await modelOf(name);
  if (shot.timeS !== undefined) {
    mixer?.setTime(shot.timeS);
    root.updateMatrixWorld(true);
  }
  const { widthPx, heightPx } = shot;
  const { backend, gl } = stand;
  const layer = layerOf(widthPx, heightPx);
  const camera = lookingAt(shot.eye, shot.target, widthPx / heightPx);
  const list = objects(drawnWith(root, style === null ? null : technique(style, values), at));
  const scene = backend.serviceFor({ shadowMaps: null, occlusion: null }).createScene({ kind: 'shaded', ambient: { value: 0.25 } });
  scene.update([list], [lights(sun([0.6, 0.8, 0.9]))]);
  layer.clear();
  scene.draw(drawView(viewOf(camera, { x: 0, y: 0, widthPx, heightPx }), layer.framebuffer));
  const pixels = layer.pixels();
  const error = gl.getError();
  if (error !== 0) throw new Error(`GL error ${error}`);
  scene.dispose();
  return pixels;
}

/** A model of `/models`, or `torus`, as a technique draws it: RGBA8 in base64, bottom row first. */
export async function picture(name: string, style: string, values: Values, shot: Shot): Promise<string> {
  const pixels = await draw(name, style, values, shot);
  let text = '';
  for (let from = 0; from < pixels.length; from += 32768) text += String.fromCharCode(...pixels.subarray(from, from + 32768));
  return btoa(text);
}

/** How light a square of a picture is, as strokes and as a shaded model: linear luminance from 0 to 1. */
export interface Tone {
  readonly drawn: number;
  readonly shaded: number;
}

/** The tones of each square of `sidePx` that is all on the model, in a style and without one. */
export async function tones(name: string, style: string, values: Values, shot: Shot, sidePx: number): Promise<Tone[]> {
  const [drawn, shaded] = [await draw(name, style, values, shot), await draw(name, null, {}, shot)];
  const found: Tone[] = [];
  for (let y = 0; y + sidePx <= shot.heightPx; y += sidePx) {
    for (let x = 0; x + sidePx <= shot.widthPx; x += sidePx) {
      const at = Array.from({ length: sidePx ** 2 }, (_, i) => ((y + Math.floor(i / sidePx)) * shot.widthPx + x + (i % sidePx)) * 4);
      if (at.some((i) => (shaded[i + 3] ?? 0) < 255)) continue;
      const mean = (pixels: Uint8Array): number => at.reduce((sum, i) => sum + linear(pixels[i + 1] ?? 0) / at.length, 0);
      found.push({ drawn: mean(drawn), shaded: mean(shaded) });
    }
  }
  return found;
}

/** Linear light of an sRGB step (IEC 61966-2-1). */
function linear(step: number): number {
  const value = step / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}

/** The strokes in a square of a picture. */
export interface Square {
  readonly x: number;
  readonly y: number;
  /** Angle of the strokes in radians, counterclockwise from the right. */
  readonly angle: number;
  /** From 0 (strokes in all directions) to 1 (in one). */
  readonly coherence: number;
  readonly ink: number;
}

const SQUARE_PX = 24;

/** The directions of strokes by the structure tensor of each square that is all on the model. */
export async function strokes(name: string, style: string, values: Values, shot: Shot): Promise<Square[]> {
  const pixels = await draw(name, style, values, shot);
  const { widthPx, heightPx } = shot;
  const at = (x: number, y: number): number => pixels[(y * widthPx + x) * 4 + 1] ?? 0;
  const squares: Square[] = [];
  for (let y0 = 1; y0 + SQUARE_PX < heightPx; y0 += SQUARE_PX) {
    for (let x0 = 1; x0 + SQUARE_PX < widthPx; x0 += SQUARE_PX) {
      let [xx, xy, yy, ink, isInside] = [0, 0, 0, 0, true];
      for (let y = y0; y < y0 + SQUARE_PX; y++) {
        for (let x = x0; x < x0 + SQUARE_PX; x++) {
          if ((pixels[(y * widthPx + x) * 4 + 3] ?? 0) < 255) isInside = false;
          const [dx, dy] = [at(x + 1, y) - at(x - 1, y), at(x, y + 1) - at(x, y - 1)];
          xx += dx * dx;
          xy += dx * dy;
          yy += dy * dy;
          ink += 1 - at(x, y) / 255;
        }
      }
      if (!isInside) continue;
      // Strokes run across the gradient.
      const angle = Math.atan2(2 * xy, xx - yy) / 2 + Math.PI / 2;
      const coherence = Math.hypot(xx - yy, 2 * xy) / Math.max(xx + yy, 1);
      squares.push({ x: x0 + SQUARE_PX / 2, y: y0 + SQUARE_PX / 2, angle, coherence, ink: ink / SQUARE_PX ** 2 });
    }
  }
  return squares;
}

/** The angle in the picture of the tube's circle at points of the torus, by its formula; null beside the torus. */
export async function tubeAngles(points: readonly (readonly [number, number])[], shot: Shot): Promise<(number | null)[]> {
  const { root, at } = await modelOf('torus');
  const camera = lookingAt(shot.eye, shot.target, shot.widthPx / shot.heightPx);
  const placed = new Mesh((root as Mesh).geometry, new MeshLambertMaterial());
  placed.applyMatrix4(at.clone().multiply(root.matrix));
  placed.updateMatrixWorld(true);
  const rays = new Raycaster();
  const inPicture = (point: Vector3): Vector2 => {
    const { x, y } = point.applyMatrix4(placed.matrixWorld).project(camera);
    return new Vector2(x * shot.widthPx, y * shot.heightPx);
  };
  return points.map(([x, y]) => {
    rays.setFromCamera(new Vector2((x / shot.widthPx) * 2 - 1, (y / shot.heightPx) * 2 - 1), camera);
    const [hit] = rays.intersectObject(placed);
    if (!hit) return null;
    const here = placed.worldToLocal(hit.point.clone());
    const outward = new Vector3(here.x, here.y, 0).normalize();
    const fromTube = here.clone().addScaledVector(outward, -0.7).normalize();
    const along = new Vector3().crossVectors(fromTube, new Vector3(-outward.y, outward.x, 0));
    const from = inPicture(here.clone());
    return inPicture(here.clone().addScaledVector(along, 1e-3)).sub(from).angle();
  });
}
