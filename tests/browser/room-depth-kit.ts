import type { AssetService } from '../../nodes/kit/assets.ts';
import type { LayerOutput, NodeRuntime } from '../../nodes/kit/runtime.ts';
import type { RoomDepth, ViewFrame } from '../../nodes/kit/session.ts';
import { definition } from '../../nodes/world/depth/definition.ts';
import { create } from '../../nodes/world/depth/runtime.ts';
import { type FakeContextOptions, fakeContext } from '../support/node-context.ts';
import { frame, upset, view } from './runtime-kit.ts';
import { createGl, room } from './scenes-kit.ts';

export const [W, H] = [32, 18];
export const VIEW_W = 128;
export const VIEW_H = 72;
export const UPRIGHT = [1, 0, 0, 0, 1, 0, 0, 0, 1];

export type Params = NonNullable<FakeContextOptions<typeof definition>['params']>;

export interface Stand {
  readonly gl: WebGL2RenderingContext;
  readonly node: NodeRuntime;
  readonly confidence: LayerOutput['views'];
  /** One more frame, a thirtieth of a second later. */
  step(views: readonly ViewFrame[]): (RoomDepth | null)[];
}

export function stand(params: Params, services: { gl?: WebGL2RenderingContext; assets?: AssetService } = {}): Stand {
  const gl = services.gl ?? createGl();
  const { ctx } = fakeContext(definition, {
    params: { filter: 'linear', ...params },
    services: { gl, ...(services.assets && { assets: services.assets }) },
  });
  ctx.outputs.depth.views.push(null, null);
  const confidence = [0, 1].map(() => ({ texture: null, widthPx: 0, heightPx: 0, uvFromViewUv: new Float32Array(9), version: -1 }));
  Object.assign(ctx.outputs, { confidence: { views: confidence } });
  const node = create(ctx);
  let index = 0;
  return {
    gl,
    node,
    confidence,
    step: (views) => {
      upset(gl);
      node.update(frame(index++, views));
      return ctx.outputs.depth.views;
    },
  };
}

export function seen(depth: RoomDepth | null, more: Partial<ViewFrame> = {}): ViewFrame {
  return view(0, 0, VIEW_W, VIEW_H, { depth, ...more });
}

/** Row by row from the bottom. */
export function metersOf(gl: WebGL2RenderingContext, depth: RoomDepth | null | undefined): number[] {
  if (!depth) return [];
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, depth.texture, 0);
  const rgba = new Float32Array(depth.widthPx * depth.heightPx * 4);
  gl.pixelStorei(gl.PACK_ALIGNMENT, 1);
  gl.readPixels(0, 0, depth.widthPx, depth.heightPx, gl.RGBA, gl.FLOAT, rgba);
  gl.deleteFramebuffer(framebuffer);
  return Array.from({ length: rgba.length / 4 }, (_, i) => rgba[i * 4] ?? 0);
}

export function samples(metersAt: (x: number, y: number) => number): number[] {
  return Array.from({ length: W * H }, (_, i) => metersAt(i % W, Math.floor(i / W)));
}

/** A sensor whose depth is uploaded to the same texture in each frame, as sessions do. */
export function createSensor(gl: WebGL2RenderingContext, uvFromViewUv = UPRIGHT) {
  const depth = room(
    gl,
    W,
    H,
    samples(() => 0),
    uvFromViewUv,
  );
  return (meters: readonly number[]): RoomDepth => {
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, false);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
    gl.pixelStorei(gl.UNPACK_ROW_LENGTH, 0);
    gl.pixelStorei(gl.UNPACK_SKIP_PIXELS, 0);
    gl.bindTexture(gl.TEXTURE_2D, depth.texture);
    gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, W, H, gl.RED, gl.FLOAT, Float32Array.from(meters));
    return depth;
  };
}
