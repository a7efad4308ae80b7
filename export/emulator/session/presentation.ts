import { P_SESSION, P_SPACE, type XRLayer, type XRSpace } from 'iwer';
import { Matrix4 } from 'three';
import type { Eye } from '../display/eye.ts';
import {
  EmulatedCompositionLayer,
  EmulatedCylinderLayer,
  EmulatedProjectionLayer,
  EmulatedQuadLayer,
  P_LAYER,
} from '../layers/composition-layer.ts';
import type { LayerImage, LayerShape } from '../layers/layer-compositor.ts';
import { partForEye } from '../layers/sub-image.ts';
import { P_EMULATED } from '../private.ts';
import { framebufferSizePx } from '../world.ts';
import { EmulatedLayer } from './emulated-layer.ts';
import type { EmulatedSession } from './emulated-session.ts';
import type { EmulatedRenderState } from './render-state.ts';
import { stretchViewport } from './viewport-scale.ts';

/** What the page presents: its base layer or its list of layers. */
export interface Presentation {
  readonly widthPx: number;
  readonly heightPx: number;
  /** Clears the layers at the start of a frame. */
  clear(): void;
  /** The page's premultiplied pixels, rows from the bottom; the same array as long as the size stays. */
  read(): Uint8Array;
}

/** Returns what a session presents in this frame; null if it has no layer. Resizes the base layer to the device's screen. */
export function presentationOf(session: EmulatedSession): Presentation | null {
  const { baseLayer, layers } = session[P_SESSION].renderState as EmulatedRenderState;
  if (layers.length > 0) return presentList(session, layers);
  const layer: unknown = baseLayer;
  if (!(layer instanceof EmulatedLayer)) return null;
  // Without `sizePx`, the layer keeps the window's size from its creation.
  if (session[P_EMULATED].world.settings.sizePx) layer.fit();
  const { widthPx, heightPx } = layer.target;
  return { widthPx, heightPx, clear: () => layer.target.clear(), read: () => readWebGlLayer(session, layer) };
}

function readWebGlLayer(session: EmulatedSession, { target }: EmulatedLayer): Uint8Array {
  const pixels = pixelsFor(target.widthPx * target.heightPx * 4);
  target.read(pixels);
  const { eyes, viewportScales } = session[P_EMULATED];
  eyes.forEach(({ viewport }, index) => {
    const scale = viewportScales[index];
    if (scale) stretchViewport(pixels, target.widthPx, viewport, scale);
  });
  return pixels;
}

// Valid within one frame only.
let layerPixels = new Uint8Array(0);

function pixelsFor(bytes: number): Uint8Array {
  if (layerPixels.length !== bytes) layerPixels = new Uint8Array(bytes);
  return layerPixels;
}

function presentList(session: EmulatedSession, layers: readonly XRLayer[]): Presentation {
  const [widthPx, heightPx] = framebufferSizePx(session[P_EMULATED].world, 1);
  return {
    widthPx,
    heightPx,
    // Composition layers are cleared when the page accesses their images.
    clear: () => {
      for (const layer of layers) if (layer instanceof EmulatedLayer) layer.target.clear();
    },
    read: () => {
      const images = layers.map((layer) => imagesOf(session, layer));
      const out = pixelsFor(widthPx * heightPx * 4);
      const { eyes, roomServices } = session[P_EMULATED];
      roomServices.compositor().compose(widthPx, heightPx, eyes, (eye) => images.flatMap((picture) => picture(eye)), out);
      return out;
    },
  };
}

/** The images of a layer per eye, read back once for all eyes. */
function imagesOf(session: EmulatedSession, layer: XRLayer): (eye: Eye) => LayerImage[] {
  if (layer instanceof EmulatedLayer) {
    const { widthPx, heightPx } = layer.target;
    const rgba = readWebGlLayer(session, layer).slice();
    return ({ viewport }) => [
      { rgba, widthPx, heightPx, part: scaleTo(viewport, widthPx, session), opacity: 1, useAlpha: true, shape: { kind: 'screen' } },
    ];
  }
  if (!(layer instanceof EmulatedCompositionLayer) || layer[P_LAYER].destroyed) return () => [];
  const { images } = layer[P_LAYER];
  const { widthPx, heightPx } = images;
  const read = new Map<number, Uint8Array>();
  return (eye) => {
    const { viewport, index } = partForEye(layer.layout, images, layer.forceMonoPresentation && eye.name === 'right' ? 'left' : eye.name);
    let rgba = read.get(index);
    if (!rgba) {
      rgba = new Uint8Array(widthPx * heightPx * 4);
      images.read(index, rgba);
      read.set(index, rgba);
    }
    const part = layer instanceof EmulatedProjectionLayer ? drawnPart(session, viewport, eye) : viewport;
    return [{ rgba, widthPx, heightPx, part, opacity: layer.opacity, useAlpha: layer.blendTextureSourceAlpha, shape: shapeOf(layer) }];
  };
}

function scaleTo({ x, y, widthPx, heightPx }: Eye['viewport'], layerWidthPx: number, session: EmulatedSession): Eye['viewport'] {
  const factor = layerWidthPx / framebufferSizePx(session[P_EMULATED].world, 1)[0];
  return { x: x * factor, y: y * factor, widthPx: widthPx * factor, heightPx: heightPx * factor };
}

/** The viewport of a projection layer's view, smaller if the page scaled it. */
function drawnPart(session: EmulatedSession, viewport: Eye['viewport'], eye: Eye): Eye['viewport'] {
  const { eyes, viewportScales } = session[P_EMULATED];
  const current = viewportScales[eyes.indexOf(eye)]?.current ?? 1;
  return { ...viewport, widthPx: viewport.widthPx * current, heightPx: viewport.heightPx * current };
}

function shapeOf(layer: EmulatedCompositionLayer): LayerShape {
  if (layer instanceof EmulatedQuadLayer) {
    return { kind: 'quad', worldFromLayer: worldFromLayer(layer), widthM: layer.width, heightM: layer.height };
  }
  if (layer instanceof EmulatedCylinderLayer) {
    const { radius, centralAngle, aspectRatio } = layer;
    const heightM = (radius * centralAngle) / aspectRatio;
    return { kind: 'cylinder', worldFromLayer: worldFromLayer(layer), radiusM: radius, angleRad: centralAngle, heightM };
  }
  return { kind: 'screen' };
}

/** The layer's pose in this frame; its space may follow the head or a hand. */
function worldFromLayer({ space, transform }: EmulatedQuadLayer | EmulatedCylinderLayer): Matrix4 {
  const matrix = new Matrix4().fromArray(Array.from(transform.matrix));
  for (let at: XRSpace | undefined = space; at; at = at[P_SPACE].parentSpace) {
    matrix.premultiply(new Matrix4().fromArray(Array.from(at[P_SPACE].offsetMatrix)));
  }
  return matrix;
}
