import type { Program } from '../../export/program/program.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import type { ViewFrame } from '../../nodes/kit/session.ts';
import type { Twins } from '../support/fusion-kit.ts';
import { createGl, frame, stand, view } from './runtime-kit.ts';
import { room } from './scenes-kit.ts';

export interface CompareOptions {
  /** The file of every asset. */
  readonly file?: Uint8Array<ArrayBuffer>;
  readonly isStereo?: boolean;
  /** Whether the second program draws to a screen with several samples per pixel. */
  readonly onSamples?: boolean;
  /** A param that is set before the second frame: node, name and value. */
  readonly param?: readonly [string, string, number] | undefined;
  /** Compares the first program with itself without the changed param. */
  readonly onlySeparate?: boolean;
}

export interface Compared {
  /** Channels that differ, and by how many of 255 steps at most. */
  readonly differing: number;
  readonly most: number;
  readonly channels: number;
  /** Pixels that the objects color. */
  readonly drawn: number;
  /** The fraction of channels whose difference is more than a step. */
  readonly far: number;
  /** Channels that differ in the left half. */
  readonly left: number;
}

const [W, H] = [320, 180];
const BACKGROUND = [51, 115, 77];

/** A room whose left half is nearer than some of the objects. */
const ROOM_M = [0.95, 5];
const UPRIGHT = [1, 0, 0, 0, 1, 0, 0, 0, 1];

/** Two eyes side by side, half a canvas each, 6 cm apart. */
function eyes(): ViewFrame[] {
  return [-0.03, 0.03].map((x, i) => {
    const worldFromView = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1]);
    const viewFromWorld = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -x, 0, 0, 1]);
    return view((i * W) / 2, 0, W / 2, H, { eye: i === 0 ? 'left' : 'right', worldFromView, viewFromWorld });
  });
}

async function draw(program: Program, { isStereo = false, onSamples = false, param, file }: CompareOptions): Promise<Uint8Array> {
  const gl = createGl({ antialias: onSamples });
  Object.assign(gl.canvas, { width: W, height: H });
  const { player, diagnostics } = await stand(program, {
    gl,
    modules: RUNTIMES,
    seed: 1,
    createScenes,
    ...(file && { assets: { load: () => Promise.resolve(file.buffer.slice(0)) } }),
  });
  player.setSession({ world: 'none', blend: 'opaque' });
  const depth = room(gl, 2, 1, ROOM_M, UPRIGHT);
  const views = (isStereo ? eyes() : [view(0, 0, W, H)]).map((eye) => ({ ...eye, depth }));
  // The second frame has what the first one has prepared.
  for (let i = 0; i < 2; i++) {
    if (i > 0 && param) player.setParam(...param);
    player.draw(frame(i, views, { framebufferWidthPx: W, framebufferHeightPx: H }));
  }
  const errors = diagnostics().filter(({ severity }) => severity === 'error');
  if (errors.length > 0) throw new Error(JSON.stringify(errors));
  if (gl.getError() !== gl.NO_ERROR) throw new Error('WebGL reports an error.');
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  const pixels = new Uint8Array(W * H * 4);
  gl.readPixels(0, 0, W, H, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  player.dispose();
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return pixels;
}

/** Draws both programs of each pair and compares their images. */
export async function compare(pairs: readonly Pick<Twins, 'separate' | 'fused'>[], options: CompareOptions = {}): Promise<Compared[]> {
  const found: Compared[] = [];
  for (const { separate, fused } of pairs) {
    const other = options.onlySeparate ? await draw(separate, { ...options, param: undefined }) : await draw(fused, options);
    found.push(compared(await draw(separate, { ...options, onSamples: false }), other));
  }
  return found;
}

function compared(a: Uint8Array, b: Uint8Array): Compared {
  let differing = 0;
  let most = 0;
  let far = 0;
  let drawn = 0;
  let left = 0;
  for (let i = 0; i < a.length; i++) {
    const apart = Math.abs((a[i] ?? 0) - (b[i] ?? 0));
    if (apart > 0) differing++;
    if (apart > 0 && (i / 4) % W < W / 2) left++;
    if (apart > 1) far++;
    if (apart > most) most = apart;
    if (i % 4 === 0 && BACKGROUND.some((value, k) => Math.abs((a[i + k] ?? 0) - value) > 1)) drawn++;
  }
  return { differing, most, channels: a.length, drawn, far: far / a.length, left };
}
