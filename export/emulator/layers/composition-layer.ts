import type { XRRigidTransform, XRSession, XRSpace } from 'iwer';
import { XRLayer } from 'iwer';
import type { LayerImages } from './layer-images.ts';

export type LayerLayout = 'mono' | 'stereo' | 'stereo-left-right' | 'stereo-top-bottom';

export const P_LAYER = Symbol('scrim/composition-layer');

export interface CompositionLayerState {
  readonly session: XRSession;
  readonly images: LayerImages;
  readonly clearOnAccess: boolean;
  /** The frame that accessed the images last. */
  accessedIn: object | null;
  destroyed: boolean;
  needsRedraw: boolean;
}

/** `XRCompositionLayer` of WebXR Layers §3.2: images that the device composites. */
export class EmulatedCompositionLayer extends XRLayer {
  readonly [P_LAYER]: CompositionLayerState;
  readonly layout: LayerLayout;
  readonly mipLevels = 1;
  blendTextureSourceAlpha = true;
  forceMonoPresentation = false;
  quality: 'default' | 'text-optimized' | 'graphics-optimized' = 'default';
  #opacity = 1;

  constructor(session: XRSession, images: LayerImages, layout: LayerLayout, clearOnAccess: boolean) {
    super();
    this.layout = layout;
    this[P_LAYER] = { session, images, clearOnAccess, accessedIn: null, destroyed: false, needsRedraw: true };
  }

  get opacity(): number {
    return this.#opacity;
  }

  set opacity(opacity: number) {
    this.#opacity = Math.min(Math.max(opacity, 0), 1);
  }

  get needsRedraw(): boolean {
    return this[P_LAYER].needsRedraw;
  }

  /** Removes the layer permanently. */
  destroy(): void {
    const state = this[P_LAYER];
    if (state.destroyed) return;
    state.destroyed = true;
    state.images.dispose();
  }
}

/** A layer of the view's size; the page draws each view into it. */
export class EmulatedProjectionLayer extends EmulatedCompositionLayer {
  /** Stored but ignored, as the specification permits: the device does not reproject. */
  deltaPose: XRRigidTransform | null = null;

  get textureWidth(): number {
    return this[P_LAYER].images.widthPx;
  }

  get textureHeight(): number {
    return this[P_LAYER].images.heightPx;
  }

  get textureArrayLength(): number {
    return Math.max(1, this[P_LAYER].images.arrayLength);
  }

  get ignoreDepthValues(): boolean {
    return true;
  }

  /** Always null: the device does not support foveation. */
  get fixedFoveation(): number | null {
    return null;
  }

  set fixedFoveation(_level: number | null) {}
}

/** Space and transform of a layer that is placed in the world. */
export interface Placement {
  space: XRSpace;
  transform: XRRigidTransform;
}

abstract class PlacedLayer extends EmulatedCompositionLayer {
  space: XRSpace;
  transform: XRRigidTransform;
  #onredraw: ((event: Event) => void) | null = null;

  constructor(session: XRSession, images: LayerImages, layout: LayerLayout, clearOnAccess: boolean, { space, transform }: Placement) {
    super(session, images, layout, clearOnAccess);
    this.space = space;
    this.transform = transform;
  }

  get onredraw(): ((event: Event) => void) | null {
    return this.#onredraw;
  }

  set onredraw(listener: ((event: Event) => void) | null) {
    if (this.#onredraw) this.removeEventListener('redraw', this.#onredraw);
    this.#onredraw = listener;
    if (listener) this.addEventListener('redraw', listener);
  }
}

/** A rectangle centered at the origin of its transform, facing +z. Meters. */
export class EmulatedQuadLayer extends PlacedLayer {
  width = 1;
  height = 1;
}

/** A part of a cylinder around the y axis of its transform, seen from inside, centered at −z. Meters and radians. */
export class EmulatedCylinderLayer extends PlacedLayer {
  radius = 2;
  centralAngle = Math.PI / 4;
  /** Arc length over height. */
  aspectRatio = 2;
}
