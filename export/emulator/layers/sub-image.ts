import { XRViewport } from 'iwer';
import type { ViewportPx } from '../session/viewport-scale.ts';
import { type EmulatedCompositionLayer, type LayerLayout, P_LAYER } from './composition-layer.ts';
import type { LayerImages } from './layer-images.ts';

type EyeName = 'none' | 'left' | 'right';

/** `XRWebGLSubImage` of WebXR Layers §5.3: the texture and viewport for one view of a layer. */
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

/** Viewport and image index of an eye; `none` gives the whole first image. */
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
  // The left eye has the left or the upper half.
  if (layout === 'stereo-top-bottom') {
    const half = heightPx / 2;
    return { viewport: { ...whole, y: second === 0 ? half : 0, heightPx: half }, index: 0 };
  }
  return { viewport: { ...whole, x: (second * widthPx) / 2, widthPx: widthPx / 2 }, index: 0 };
}

/** Returns the images of a layer and clears them at the first access of a frame if `clearOnAccess` is set. */
export function accessImages(layer: EmulatedCompositionLayer, frame: object): LayerImages {
  const state = layer[P_LAYER];
  if (state.accessedIn !== frame) {
    state.accessedIn = frame;
    if (state.clearOnAccess) state.images.clear();
  }
  // `needsRedraw` stays true until the running callback returns.
  queueMicrotask(() => {
    state.needsRedraw = false;
  });
  return state.images;
}
