import type { ShaderError } from '../../../export/runtime/gl/program-cache.ts';
import type { Player } from '../../../export/runtime/player.ts';
import { readColor, readDepth } from '../../../export/runtime/readback.ts';
import { setFrustum, setRigidInverse } from '../../../export/runtime/sessions/matrix.ts';
import { coverCanvas, createSessionFrame } from '../../../export/runtime/sessions/session-frame.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import type { Session } from '../../../nodes/kit/session.ts';
import { createRenderPlayer, type PlayedProgram } from '../render/render-player.page.ts';

/** What is photographed: a layer with depth, as `node.port`. */
export interface AcquireJob extends PlayedProgram {
  readonly tap: string;
}

export interface OpenedAcquisition {
  readonly shaderErrors: readonly ShaderError[];
  readonly diagnostics: readonly Diagnostic[];
}

/** A pinhole camera with its center in the middle of the photograph. */
export interface PhotographCamera {
  /** Column-major 4×4, rigid. */
  readonly worldFromCamera: readonly number[];
  /** The tangents of half the horizontal and half the vertical field of view. */
  readonly tangents: readonly [x: number, y: number];
}

/** The sizes of the two parts that were sent to the URL `picture`: premultiplied RGBA bytes, then meters as 32-bit floats, rows from the top. */
export interface PhotographHead {
  readonly color: readonly [widthPx: number, heightPx: number];
  readonly depth: readonly [widthPx: number, heightPx: number];
}

/** The cameras of an acquisition belong to no device: no image of the world, no input, no light. */
const SESSION: Session = {
  kind: 'orbit',
  capabilities: new Set(),
  world: 'none',
  blend: 'opaque',
  start: () => {},
  end: async () => {},
};

interface Opened {
  readonly gl: WebGL2RenderingContext;
  readonly player: Player;
  readonly tap: string;
}

const frame = createSessionFrame();
let opened: Opened | null = null;
let problems: readonly Diagnostic[] = [];

/** Opens an acquisition. */
export async function open(job: AcquireJob): Promise<OpenedAcquisition> {
  const { gl, player } = createRenderPlayer(job, (diagnostics) => {
    problems = diagnostics;
  });
  const { shaderErrors } = await player.ready;
  player.setSession(SESSION);
  opened = { gl, player, tap: job.tap };
  return { shaderErrors, diagnostics: problems };
}

/** Draws the scene for a camera at time 0, when all of its assets have loaded, and sends color and depth. */
export async function photograph({ worldFromCamera, tangents: [x, y] }: PhotographCamera): Promise<PhotographHead> {
  if (!opened) throw new Error('Nothing is open.');
  const { gl, player, tap } = opened;
  const view = coverCanvas(frame, gl);
  setFrustum(view.clipFromView, -x, x, -y, y, view.nearM, view.farM);
  view.worldFromView.set(worldFromCamera);
  setRigidInverse(view.viewFromWorld, view.worldFromView);
  await player.drawSettled(frame);
  frame.index++;
  const color = readColor(player.inspect(tap), 0);
  const depth = readDepth(player.inspect(tap), 0);
  if (!color || !depth) throw new Error(`Layer ${tap} was not drawn.`);
  await fetch('picture', { method: 'POST', body: new Blob([color.pixels, depth.meters]) });
  return { color: [color.widthPx, color.heightPx], depth: [depth.widthPx, depth.heightPx] };
}

/** All diagnostics so far. */
export function diagnostics(): readonly Diagnostic[] {
  return problems;
}
