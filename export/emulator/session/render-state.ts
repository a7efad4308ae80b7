import type { XRLayer } from 'iwer';
import { XRRenderState } from 'iwer';

export interface RenderStateWishes {
  readonly depthNear?: number;
  readonly depthFar?: number;
  readonly inlineVerticalFieldOfView?: number;
  readonly baseLayer?: object | null;
  readonly layers?: readonly XRLayer[] | null;
}

type Init = NonNullable<ConstructorParameters<typeof XRRenderState>[0]>;

/** `XRRenderState` with `layers` of WebXR Layers §2. It has either those or a base layer. */
export class EmulatedRenderState extends XRRenderState {
  readonly layers: readonly XRLayer[];

  constructor(init: RenderStateWishes) {
    super({ ...init, baseLayer: init.baseLayer ?? undefined } as unknown as Init);
    this.layers = Object.freeze([...(init.layers ?? [])]);
  }
}

/** Render state of a new session. */
export function initialRenderState(mode: string): EmulatedRenderState {
  return new EmulatedRenderState(mode === 'inline' ? { inlineVerticalFieldOfView: Math.PI / 2 } : {});
}

/** Returns a copy of `former` with the changes that the page requested. */
export function changeRenderState(former: EmulatedRenderState, wishes: RenderStateWishes): EmulatedRenderState {
  const fovRad = wishes.inlineVerticalFieldOfView ?? former.inlineVerticalFieldOfView;
  const layers = wishes.layers ?? null;
  return new EmulatedRenderState({
    depthNear: wishes.depthNear ?? former.depthNear,
    depthFar: wishes.depthFar ?? former.depthFar,
    ...(fovRad === null ? {} : { inlineVerticalFieldOfView: Math.min(Math.max(fovRad, FOV_LIMITS_RAD.min), FOV_LIMITS_RAD.max) }),
    baseLayer: layers ? null : wishes.baseLayer === undefined ? former.baseLayer : wishes.baseLayer,
    layers: layers ?? (wishes.baseLayer === undefined ? former.layers : []),
  });
}

/** Limits for inline sessions, in radians. */
const FOV_LIMITS_RAD = { min: 0.01, max: Math.PI - 0.01 };

/**
 * Checks the changes that a page passes to `updateRenderState` (WebXR Device API §4.3, Layers §2.2).
 *
 * @param isOwn Whether a layer was created for the session.
 * @throws TypeError or DOMException as specified.
 */
export function checkRenderState(
  wishes: RenderStateWishes,
  mode: string,
  features: readonly string[],
  isOwn: (layer: object) => boolean,
): void {
  const { baseLayer, layers } = wishes;
  if (wishes.inlineVerticalFieldOfView != null && mode !== 'inline') {
    throw new DOMException('inlineVerticalFieldOfView applies to inline sessions only.', 'InvalidStateError');
  }
  if (baseLayer && layers) throw new DOMException('Either baseLayer or layers can be set, not both.', 'NotSupportedError');
  for (const layer of baseLayer ? [baseLayer] : (layers ?? [])) {
    if (!isOwn(layer)) throw new DOMException('The layer was made for another session.', 'InvalidStateError');
  }
  if (!layers) return;
  if (new Set(layers).size !== layers.length) throw new TypeError('A layer is in the list twice.');
  if (layers.length > 1 && !features.includes('layers')) {
    throw new DOMException('The session was not granted "layers", so it has at most one layer.', 'NotSupportedError');
  }
}
