import { decode } from 'fast-png';
import { addDepthNoise, type DepthNoise } from '../../export/emulator/depth/depth-noise.ts';
import { ROOM_DEPTH_TEXT } from '../../nodes/kit/room-depth-glsl.ts';
import type { CameraImage, RoomDepth } from '../../nodes/kit/session.ts';
import { definition } from '../../nodes/world/depth/definition.ts';
import { createDepthDrawing } from '../../nodes/world/depth/drawing.ts';
import { create } from '../../nodes/world/depth/runtime.ts';
import { frame, view } from '../browser/runtime-kit.ts';
import { createGl, room } from '../browser/scenes-kit.ts';
import { fakeContext } from '../support/node-context.ts';

const WIDTH = 640;
const HEIGHT = 480;
/** What a phone gives. */
const COLUMNS = 160;
const ROWS = 120;
/** A sheet across the view at each of these distances cuts the room of the recording. */
const SHEETS_M = [1.25, 1.5, 1.75, 2, 2.25];
/** On either side of the true border. */
const REACH_PX = 3;
const UPRIGHT = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

/** How far the camera image is from where it belongs, as a fraction of its width; null without one. */
const WAYS = {
  nearest: { filter: 'nearest', offset: null },
  linear: { filter: 'linear', offset: null },
  'by sensor': { filter: 'by-sensor', offset: null },
  'edge-aware without camera': { filter: 'edge-aware', offset: null },
  'edge-aware, camera shifted': { filter: 'edge-aware', offset: 0.06 },
  'edge-aware': { filter: 'edge-aware', offset: 0 },
} as const;

export type Way = keyof typeof WAYS;

/** Pixels of the band: shown rightly, shown rightly or wrongly, and the same of those that are hidden. */
export interface Counts {
  shown: number;
  shownEver: number;
  hidden: number;
  hiddenEver: number;
  /** Pixels that are shown or hidden wrongly, in the band and outside. */
  near: number;
  far: number;
}

/** One frame, bottom row first; without a color image, only the ways that need none. */
export async function compare(depthUrl: string, colorUrl: string | null, noise: DepthNoise): Promise<Partial<Record<Way, Counts>>> {
  const gl = createGl(WIDTH, HEIGHT);
  const truth = await readMeters(depthUrl);
  const sensed = sense(truth, noise);
  const image = colorUrl === null ? null : await readImage(gl, colorUrl);
  const result: [string, Counts][] = [];
  for (const [way, { filter, offset }] of Object.entries(WAYS)) {
    if (offset !== null && !image) continue;
    const { ctx } = fakeContext(definition, { params: { filter }, services: { gl } });
    ctx.outputs.depth.views.push(null);
    const node = create(ctx);
    const depth = room(gl, COLUMNS, ROWS, sensed);
    node.update(frame(0, [view(0, 0, WIDTH, HEIGHT, { depth, cameraImage: offset === null || !image ? null : shifted(image, offset) })]));
    const [refined] = ctx.outputs.depth.views;
    if (!refined) throw new Error('There is no depth.');
    const found = readByPixel(gl, refined);
    const counts: Counts = { shown: 0, shownEver: 0, hidden: 0, hiddenEver: 0, near: 0, far: 0 };
    for (const sheetM of SHEETS_M) count(counts, truth, found, sheetM);
    result.push([way, counts]);
    node.dispose();
  }
  if (gl.getError() !== 0) throw new Error('GL has an error.');
  return Object.fromEntries(result);
}

export interface Panel {
  /** Shares of the pixels without depth, as windows are, whose panel at a distance is hidden: as measured, and with holes filled. */
  readonly unfilled: number;
  readonly filled: number;
  readonly holes: number;
  /** What a visitor sees with holes filled, at half the size: RGBA, bottom row first. */
  readonly seen: readonly number[];
}

const PANEL = [255, 150, 30] as const;

/** A panel across the whole view, at a distance. */
export async function hiddenPanel(depthUrl: string, colorUrl: string, panelM: number): Promise<Panel> {
  const gl = createGl(WIDTH, HEIGHT);
  const truth = await readMeters(depthUrl);
  const holes = truth.reduce((count, m) => (m === 0 ? count + 1 : count), 0);
  const find = (fillHoles: boolean): Float32Array => {
    const { ctx } = fakeContext(definition, { params: { fillHoles }, services: { gl } });
    ctx.outputs.depth.views.push(null);
    const node = create(ctx);
    node.update(
      frame(0, [view(0, 0, WIDTH, HEIGHT, { depth: room(gl, COLUMNS, ROWS, sense(truth, { sigmaM: 0.01, sigmaPerM: 0.005, seed: 1 })) })]),
    );
    const [refined] = ctx.outputs.depth.views;
    if (!refined) throw new Error('There is no depth.');
    const found = readByPixel(gl, refined);
    node.dispose();
    return found;
  };
  const isHidden = (m: number): boolean => m > 0 && m < panelM;
  const share = (found: Float32Array): number => found.filter((m, i) => truth[i] === 0 && isHidden(m)).length / holes;
  const filled = find(true);
  const color = await readPixels(colorUrl);
  const seen: number[] = [];
  for (let y = 0; y < HEIGHT; y += 2) {
    for (let x = 0; x < WIDTH; x += 2) {
      const i = y * WIDTH + x;
      seen.push(...(isHidden(filled[i] ?? 0) ? color.subarray(i * 4, i * 4 + 3) : PANEL), 255);
    }
  }
  return { unfilled: share(find(false)), filled: share(filled), holes, seen };
}

/** RGBA, bottom row first. */
async function readPixels(url: string): Promise<Uint8ClampedArray> {
  const bitmap = await createImageBitmap(await (await fetch(url)).blob(), { imageOrientation: 'flipY', colorSpaceConversion: 'none' });
  const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
  context?.drawImage(bitmap, 0, 0);
  return context?.getImageData(0, 0, bitmap.width, bitmap.height).data ?? new Uint8ClampedArray();
}

async function readMeters(url: string): Promise<Float32Array> {
  const { width, height, data } = decode(await (await fetch(url)).arrayBuffer());
  if (width !== WIDTH || height !== HEIGHT) throw new Error(`The depth picture has ${width} × ${height} pixels.`);
  return Float32Array.from({ length: WIDTH * HEIGHT }, (_, i) => {
    const row = HEIGHT - 1 - Math.floor(i / WIDTH);
    return (data[row * WIDTH + (i % WIDTH)] ?? 0) * 0.001;
  });
}

async function readImage(gl: WebGL2RenderingContext, url: string): Promise<CameraImage> {
  const blob = await (await fetch(url)).blob();
  const bitmap = await createImageBitmap(blob, { imageOrientation: 'flipY', colorSpaceConversion: 'none' });
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, bitmap);
  return { texture, widthPx: bitmap.width, heightPx: bitmap.height, uvFromViewUv: UPRIGHT };
}

function shifted(image: CameraImage, offset: number): CameraImage {
  return { ...image, uvFromViewUv: Float32Array.of(1, 0, 0, 0, 1, 0, offset, 0, 1) };
}

/** Every so many-th pixel, with the noise of the emulator's sensors. */
function sense(truth: Float32Array, noise: DepthNoise): number[] {
  const sensed = Float32Array.from({ length: COLUMNS * ROWS }, (_, i) => {
    const x = Math.floor((((i % COLUMNS) + 0.5) * WIDTH) / COLUMNS);
    const y = Math.floor(((Math.floor(i / COLUMNS) + 0.5) * HEIGHT) / ROWS);
    return truth[y * WIDTH + x] ?? 0;
  });
  addDepthNoise(sensed, noise, 'frame');
  return [...sensed];
}

/** What occlusions read at the middle of each pixel. */
function readByPixel(gl: WebGL2RenderingContext, depth: RoomDepth): Float32Array {
  const drawing = createDepthDrawing(gl);
  if (!drawing) throw new Error('The GPU draws no floats.');
  const text = `
uniform sampler2D room;
uniform mat3 roomFromView;
uniform bool interpolate;
${ROOM_DEPTH_TEXT}
float meters() { return scrim_roomM(room, interpolate, place(roomFromView, uv)); }`;
  const pass = drawing.link(text, ['room']);
  const target = drawing.createImage(WIDTH, HEIGHT);
  drawing.begin(target, pass);
  drawing.texture(0, depth.texture, 'nearest');
  gl.uniformMatrix3fv(pass.uniform('roomFromView'), false, depth.uvFromViewUv);
  gl.uniform1i(pass.uniform('interpolate'), depth.interpolate ? 1 : 0);
  drawing.draw();
  const rgba = new Float32Array(WIDTH * HEIGHT * 4);
  gl.readPixels(0, 0, WIDTH, HEIGHT, gl.RGBA, gl.FLOAT, rgba);
  drawing.dispose();
  return Float32Array.from({ length: WIDTH * HEIGHT }, (_, i) => rgba[i * 4] ?? 0);
}

function count(counts: Counts, truth: Float32Array, found: Float32Array, sheetM: number): void {
  const band = bandOf(truth, sheetM);
  for (let i = 0; i < band.length; i++) {
    if (truth[i] === 0) continue;
    const isShown = sheetM <= (truth[i] ?? 0);
    const looksShown = found[i] === 0 || sheetM <= (found[i] ?? 0);
    if (isShown !== looksShown) counts[band[i] ? 'near' : 'far']++;
    if (!band[i]) continue;
    if (isShown && looksShown) counts.shown++;
    if (isShown || looksShown) counts.shownEver++;
    if (!isShown && !looksShown) counts.hidden++;
    if (!isShown || !looksShown) counts.hiddenEver++;
  }
}

/** Pixels within reach of one whose neighbor is on the other side of the sheet. */
function bandOf(truth: Float32Array, sheetM: number): Uint8Array {
  const band = new Uint8Array(WIDTH * HEIGHT);
  const isBehind = (i: number): boolean => (truth[i] ?? 0) > sheetM;
  for (let y = 0; y < HEIGHT - 1; y++) {
    for (let x = 0; x < WIDTH - 1; x++) {
      const i = y * WIDTH + x;
      if (isBehind(i) === isBehind(i + 1) && isBehind(i) === isBehind(i + WIDTH)) continue;
      for (let dy = -REACH_PX; dy <= REACH_PX; dy++) {
        for (let dx = -REACH_PX; dx <= REACH_PX; dx++) {
          const [bx, by] = [x + dx, y + dy];
          const isInside = bx >= 0 && by >= 0 && bx < WIDTH && by < HEIGHT && dx * dx + dy * dy <= REACH_PX * REACH_PX;
          if (isInside) band[by * WIDTH + bx] = 1;
        }
      }
    }
  }
  return band;
}
