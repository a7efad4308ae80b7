import { clearRectangle } from '../gl/clear.ts';
import { COPY_SAMPLER, COPY_SCENE_SHADER, COPY_UV } from '../gl/copy-shader.ts';
import type { Inspected } from '../inspected.ts';
import { findImage } from '../readback.ts';

const CLEAR = new Float32Array(4);

/**
 * Draws a layer over a part of a view, between `from` and `to` as fractions of its width. Images of another aspect ratio are centered and
 * fully visible. Returns false, and draws nothing, if the layer is not viewed or was not drawn.
 */
export function showLayer({ engine, resources, layer }: Inspected, viewIndex: number, from: number, to: number): boolean {
  const { state, objects, drawer } = engine;
  const { gl } = objects;
  if (layer === null) return false;
  const view = state.frame.views[viewIndex];
  const image = findImage(state, resources, layer.color, viewIndex);
  const copy = image?.encoding === 'scene' ? engine.tool(COPY_SCENE_SHADER) : engine.copy;
  const location = copy.state === 'linked' ? copy.uniform(COPY_SAMPLER) : null;
  if (!view || !image || !location) return false;
  const { x, y, widthPx, heightPx } = view.viewport;
  const leftPx = Math.round(widthPx * from);
  const partPx = Math.round(widthPx * to) - leftPx;
  if (partPx < 1 || heightPx < 1) return true;
  clearRectangle(gl, state.frame.framebuffer, x + leftPx, y, partPx, heightPx, CLEAR);
  const scale = Math.min(widthPx / image.widthPx, heightPx / image.heightPx);
  const width = Math.round(image.widthPx * scale);
  const height = Math.round(image.heightPx * scale);
  const left = x + Math.round((widthPx - width) / 2);
  const bottom = y + Math.round((heightPx - height) / 2);
  drawer.begin(state.frame.framebuffer, left, bottom, width, height, 'replace');
  gl.enable(gl.SCISSOR_TEST);
  gl.scissor(x + leftPx, y, partPx, heightPx);
  drawer.use(copy);
  drawer.texture(0, location, image.texture, 'linear');
  gl.uniformMatrix3fv(copy.uniform(COPY_UV), false, image.uvFromViewUv);
  drawer.draw();
  drawer.end();
  gl.disable(gl.SCISSOR_TEST);
  return true;
}
