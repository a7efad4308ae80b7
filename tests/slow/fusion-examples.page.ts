import { diagnostics, type OpenRender, open, playAndRead, type RenderJob } from '../../app/cli/render/render.page.ts';
import { readScreen } from '../../export/runtime/readback.ts';
import { hasErrors } from '../../nodes/kit/diagnostics.ts';
import { type Difference, difference } from '../browser/fusion-difference.ts';

/** Plays both renders from frame `first` to frame `last`, and compares the last images. */
export async function compare(before: RenderJob, after: RenderJob, first: number, last: number): Promise<Difference> {
  const [one, other] = [await drawn(before, first, last), await drawn(after, first, last)];
  if (one.length !== other.length) throw new Error('The images have different sizes.');
  return difference(one, other);
}

async function drawn(job: RenderJob, first: number, last: number): Promise<Uint8Array> {
  const opened = await open(job);
  const renders: OpenRender[] = [];
  let pixels: Uint8Array | null = null;
  for (let index = first; index <= last; index++) {
    await playAndRead(index, (render) => {
      renders[0] = render;
      if (index === last) pixels = readScreen(render.gl).pixels;
    });
  }
  const all = [...opened.diagnostics, ...diagnostics()];
  for (const { gl, player } of renders) {
    player.dispose();
    gl.getExtension('WEBGL_lose_context')?.loseContext();
  }
  if (pixels === null || opened.shaderErrors.length > 0 || hasErrors(all)) throw new Error(JSON.stringify([opened.shaderErrors, all]));
  return pixels;
}
