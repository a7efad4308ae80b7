import { XRViewport } from 'iwer';
import type { ViewportPx } from '../session/viewport-scale.ts';
import { type EmulatedCompositionLayer, type LayerLayout, P_LAYER } from './composition-layer.ts';
import type { LayerImages } from './layer-images.ts';

type EyeName = 'none' | 'left' | 'right';

/** XRWebGLSubImage of WebXR Layers §5.3: where in which texture a page draws one view of a layer. */
export class EmulatedSubImage {
  readonly viewport: XRViewport;
  readonly colorTexture: WebGLTexture;
  readonly depthStencilTexture: WebGLTexture | null;
  readonly motionVectorTexture = null;
  /** Null for plain textures. */
  readonly imageIndex: number | null;
  readonly colorTextureWidth: number;
  readonly colorTextureHeight: number;
  readonly depthStencilTextureWidth: number | null;
  readonly depthStencilTextureHeight: number | null;
  readonly motionVectorTextureWidth = null;
  readonly motionVectorTextureHeight = null;

  constructor(images: LayerImages, { x, y, widthPx, heightPx }: ViewportPx, index: number) {
    this.viewport = new XRViewport(x, y, widthPx, heightPx);
    this.colorTexture = images.color;
    this.depthStencilTexture = images.depthStencil;
    this.imageIndex = images.arrayLength > 0 ? index : null;
    this.colorTextureWidth = images.widthPx;
    this.colorTextureHeight = images.heightPx;
    this.depthStencilTextureWidth = images.depthStencil ? images.widthPx : null;
    this.depthStencilTextureHeight = images.depthStencil ? images.heightPx : null;
  }
}

/** Which part of which image of a layer an eye sees; without an eye, all of the first. */
export function partForEye(
  layout: LayerLayout,
  images: LayerImages,
  eye: EyeName,
): { readonly viewport: ViewportPx; readonly index: number } {
  const { widthPx, heightPx, arrayLength } = images;
  const whole = { x: 0, y: 0, widthPx, heightPx };
  const second = eye === 'right' ? 1 : 0;
  if (layout === 'mono') return { viewport: whole, index: 0 };
  if (arrayLength > 0) return { viewport: whole, index: second };
  if (eye === 'none') return { viewport: whole, index: 0 };
  // The left eye's half is the left or the upper one.
  if (layout === 'stereo-top-bottom') {
    const half = heightPx / 2;
    return { viewport: { ...whole, y: second === 0 ? half : 0, heightPx: half }, index: 0 };
  }
  return { viewport: { ...whole, x: (second * widthPx) / 2, widthPx: widthPx / 2 }, index: 0 };
}

/** The page asks for the images of a layer: emptied the first time in a frame, unless it wanted to keep them. */
export function accessImages(layer: EmulatedCompositionLayer, frame: object): LayerImages {
  const state = layer[P_LAYER];
  if (state.accessedIn !== frame) {
    state.accessedIn = frame;
    if (state.clearOnAccess) state.images.clear();
  }
  // Within the frame it goes on to say that it needs what is drawn now.
  queueMicrotask(() => {
    state.needsRedraw = false;
  });
  return state.images;
}
