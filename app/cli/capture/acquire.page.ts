import type { ShaderError } from '../../../export/runtime/gl/program-cache.ts';
import { createPhotographer, type Photographer } from '../../../export/runtime/photographer.ts';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
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

let photographer: Photographer | null = null;
let problems: readonly Diagnostic[] = [];

/** Opens an acquisition. */
export async function open(job: AcquireJob): Promise<OpenedAcquisition> {
  const { gl, player } = createRenderPlayer(job, (diagnostics) => {
    problems = diagnostics;
  });
  const { shaderErrors } = await player.ready;
  photographer = createPhotographer(gl, player, job.tap);
  return { shaderErrors, diagnostics: problems };
}

/** Draws the scene for a camera at time 0, when all of its assets have loaded, and sends color and depth. */
export async function photograph({ worldFromCamera, tangents }: PhotographCamera): Promise<PhotographHead> {
  if (!photographer) throw new Error('Nothing is open.');
  const { color, depth } = await photographer.take(worldFromCamera, tangents);
  await fetch('picture', { method: 'POST', body: new Blob([color.pixels, depth.meters]) });
  return { color: [color.widthPx, color.heightPx], depth: [depth.widthPx, depth.heightPx] };
}

/** All diagnostics so far. */
export function diagnostics(): readonly Diagnostic[] {
  return problems;
}
