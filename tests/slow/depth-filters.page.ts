import { decode } from 'fast-png';
import { ROOM_DEPTH_TEXT } from '../../export/program/room-depth.ts';
import { createRandom } from '../../export/runtime/random.ts';
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
const ROWS = 90;
/** A sheet across the view at each of these distances cuts the room of the recording. */
const SHEETS_M = [1.25, 1.5, 1.75, 2, 2.25];
/** On either side of the true border. */
const REACH_PX = 3;
const UPRIGHT = Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1);

const WAYS = {
  nearest: { filter: 'nearest', guided: false },
  linear: { filter: 'linear', guided: false },
  'edge-aware without camera': { filter: 'edge-aware', guided: false },
  'edge-aware': { filter: 'edge-aware', guided: true },
} as const;

export type Way = keyof typeof WAYS;

/** Pixels of the band: shown rightly, shown rightly or wrongly, and the same of those that are hidden. */
export interface Counts {
  shown: number;
  shownEver: number;
  hidden: number;
  hiddenEver: number;
}

/** One frame of the recording, bottom row first. */
export async function compare(depthUrl: string, colorUrl: string, seed: number): Promise<Record<Way, Counts>> {
  const gl = createGl(WIDTH, HEIGHT);
  const truth = await readMeters(depthUrl);
  const sensed = sense(truth, seed);
  const image = await readImage(gl, colorUrl);
  const result: [string, Counts][] = [];
  for (const [way, { filter, guided }] of Object.entries(WAYS)) {
    const { ctx } = fakeContext(definition, { params: { filter }, services: { gl } });
    ctx.outputs.depth.views.push(null);
    const node = create(ctx);
    const depth = room(gl, COLUMNS, ROWS, sensed);
    node.update(frame(0, [view(0, 0, WIDTH, HEIGHT, { depth, cameraImage: guided ? image : null })]));
    const [refined] = ctx.outputs.depth.views;
    if (!refined) throw new Error('There is no depth.');
    const found = readByPixel(gl, refined);
    const counts: Counts = { shown: 0, shownEver: 0, hidden: 0, hiddenEver: 0 };
    for (const sheetM of SHEETS_M) count(counts, truth, found, sheetM);
    result.push([way, counts]);
    node.dispose();
  }
  if (gl.getError() !== 0) throw new Error('GL has an error.');
  return Object.fromEntries(result) as Record<Way, Counts>;
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

/** Every so many-th pixel, off by 1 cm and 0.5 % of the distance (normally distributed, by Box and Muller). */
function sense(truth: Float32Array, seed: number): number[] {
  const { next } = createRandom(seed, 'sensor');
  return Array.from({ length: COLUMNS * ROWS }, (_, i) => {
    const x = Math.floor((((i % COLUMNS) + 0.5) * WIDTH) / COLUMNS);
    const y = Math.floor(((Math.floor(i / COLUMNS) + 0.5) * HEIGHT) / ROWS);
    const m = truth[y * WIDTH + x] ?? 0;
    const off = Math.sqrt(-2 * Math.log(1 - next())) * Math.cos(2 * Math.PI * next());
    return m > 0 ? m + off * (0.01 + 0.005 * m) : 0;
  });
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
  const target = drawing.createPicture(WIDTH, HEIGHT);
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
    if (!band[i] || truth[i] === 0) continue;
    const isShown = sheetM <= (truth[i] ?? 0);
    const looksShown = found[i] === 0 || sheetM <= (found[i] ?? 0);
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
