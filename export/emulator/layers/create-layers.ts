import { P_SESSION, XRRigidTransform, XRSpace } from 'iwer';
import type { Gl } from '../display/app-gl.ts';
import { P_EMULATED } from '../private.ts';
import type { EmulatedSession } from '../session/emulated-session.ts';
import { framebufferSizePx } from '../world.ts';
import {
  EmulatedCylinderLayer,
  EmulatedProjectionLayer,
  EmulatedQuadLayer,
  type LayerLayout,
  type Placement,
} from './composition-layer.ts';
import { createLayerImages, type LayerImages } from './layer-images.ts';

export interface ProjectionLayerInit {
  readonly textureType?: 'texture' | 'texture-array';
  readonly colorFormat?: GLenum;
  readonly depthFormat?: GLenum | null;
  readonly scaleFactor?: number;
  readonly clearOnAccess?: boolean;
}

/** `XRLayerInit` of WebXR Layers §5.1 with the members that quad and cylinder layers share. */
export interface PlacedLayerInit {
  readonly space: XRSpace;
  readonly viewPixelWidth: number;
  readonly viewPixelHeight: number;
  readonly textureType?: 'texture' | 'texture-array';
  readonly colorFormat?: GLenum;
  readonly depthFormat?: GLenum | null;
  readonly layout?: LayerLayout | 'default';
  readonly clearOnAccess?: boolean;
  readonly transform?: XRRigidTransform | null;
}

export interface QuadLayerInit extends PlacedLayerInit {
  readonly width?: number;
  readonly height?: number;
}

export interface CylinderLayerInit extends PlacedLayerInit {
  readonly radius?: number;
  readonly centralAngle?: number;
  readonly aspectRatio?: number;
}

/** Creates a projection layer, the only kind that does not need the feature `layers`. */
export function createProjectionLayer(session: EmulatedSession, gl: Gl, init: ProjectionLayerInit): EmulatedProjectionLayer {
  checkLiving(session, gl);
  if (session[P_SESSION].mode === 'inline') throw new DOMException('Inline sessions have no projection layers.', 'InvalidStateError');
  const { world } = session[P_EMULATED];
  const { views } = world.settings;
  const asArray = init.textureType === 'texture-array';
  const [widthPx, heightPx] = framebufferSizePx(world, Math.min(Math.max(init.scaleFactor ?? 1, 0.2), 1));
  const images = createLayerImages(gl, {
    widthPx: asArray ? widthPx / views : widthPx,
    heightPx,
    arrayLength: asArray ? views : 0,
    colorFormat: init.colorFormat ?? gl.RGBA,
    depthFormat: init.depthFormat === undefined ? gl.DEPTH_COMPONENT : (init.depthFormat ?? 0),
  });
  const layout = views === 1 ? 'mono' : asArray ? 'stereo' : 'stereo-left-right';
  return owned(session, new EmulatedProjectionLayer(session, images, layout, init.clearOnAccess ?? true));
}

export function createQuadLayer(session: EmulatedSession, gl: Gl, init: QuadLayerInit): EmulatedQuadLayer {
  const { width = 1, height = 1 } = init;
  checkPlaced(session, gl, init, { width, height });
  const { images, layout } = placedImages(session, gl, init);
  const layer = new EmulatedQuadLayer(session, images, layout, init.clearOnAccess ?? true, placement(init));
  return owned(session, Object.assign(layer, { width, height }));
}

export function createCylinderLayer(session: EmulatedSession, gl: Gl, init: CylinderLayerInit): EmulatedCylinderLayer {
  const { radius = 2, centralAngle = Math.PI / 4, aspectRatio = 2 } = init;
  checkPlaced(session, gl, init, { aspectRatio });
  if (!(radius >= 0)) throw new TypeError(`The radius ${radius} of a cylinder is negative.`);
  if (!(centralAngle >= 0 && centralAngle <= 2 * Math.PI)) throw new TypeError('The central angle of a cylinder must be between 0 and 2π.');
  const { images, layout } = placedImages(session, gl, init);
  const layer = new EmulatedCylinderLayer(session, images, layout, init.clearOnAccess ?? true, placement(init));
  return owned(session, Object.assign(layer, { radius, centralAngle, aspectRatio }));
}

function checkLiving(session: EmulatedSession, gl: Gl): void {
  if (session[P_SESSION].ended) throw new DOMException('The session has ended.', 'InvalidStateError');
  if (gl.isContextLost()) throw new DOMException('The WebGL context is lost.', 'InvalidStateError');
}

function checkPlaced(session: EmulatedSession, gl: Gl, init: PlacedLayerInit, positive: Readonly<Record<string, number>>): void {
  checkLiving(session, gl);
  if (!session.enabledFeatures.includes('layers')) {
    throw new DOMException('The session was not granted "layers".', 'NotSupportedError');
  }
  if (!(init?.space instanceof XRSpace)) throw new TypeError('A layer requires a space.');
  const { viewPixelWidth, viewPixelHeight } = init;
  for (const [name, value] of Object.entries({ viewPixelWidth, viewPixelHeight, ...positive })) {
    if (!(value > 0)) throw new TypeError(`The ${name} of a layer must be greater than 0, but is ${value}.`);
  }
  if (init.layout === 'default') throw new TypeError('The layout "default" is for projection layers only.');
}

function placement({ space, transform }: PlacedLayerInit): Placement {
  return { space, transform: transform ?? new XRRigidTransform() };
}

function placedImages(
  session: EmulatedSession,
  gl: Gl,
  init: PlacedLayerInit,
): { readonly images: LayerImages; readonly layout: LayerLayout } {
  const asArray = init.textureType === 'texture-array';
  const wish = (init.layout ?? 'mono') as LayerLayout;
  const layout = session[P_EMULATED].world.settings.views === 1 ? 'mono' : wish === 'stereo' && !asArray ? 'stereo-left-right' : wish;
  const images = createLayerImages(gl, {
    widthPx: init.viewPixelWidth * (layout === 'stereo-left-right' ? 2 : 1),
    heightPx: init.viewPixelHeight * (layout === 'stereo-top-bottom' ? 2 : 1),
    arrayLength: asArray ? (layout === 'stereo' ? 2 : 1) : 0,
    colorFormat: init.colorFormat ?? gl.RGBA,
    depthFormat: init.depthFormat ?? 0,
  });
  return { images, layout };
}

function owned<T extends { destroy(): void }>(session: EmulatedSession, layer: T): T {
  session[P_EMULATED].disposers.push(() => layer.destroy());
  return layer;
}
