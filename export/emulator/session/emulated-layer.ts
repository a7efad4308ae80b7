import { P_SESSION, P_WEBGL_LAYER, XRLayer, XRViewport } from 'iwer';
import { createLayerTarget, type LayerTarget } from '../display/layer-target.ts';
import { P_EMULATED, P_EYE } from '../private.ts';
import { isXrCompatible } from '../xr-compatible.ts';
import { EmulatedSession } from './emulated-session.ts';
import { EmulatedView } from './emulated-view.ts';

export interface LayerInit {
  readonly antialias?: boolean;
  readonly depth?: boolean;
  readonly stencil?: boolean;
  readonly alpha?: boolean;
  readonly framebufferScaleFactor?: number;
}

const SCALE_LIMITS = { min: 0.2, max: 1 };

/**
 * XRWebGLLayer with a framebuffer of its own, as on a device. iwer lends the canvas, where a page that forgets to bind the
 * layer's framebuffer still seems to work.
 */
export class EmulatedLayer extends XRLayer {
  readonly [P_WEBGL_LAYER]: { session: EmulatedSession; context: WebGL2RenderingContext; antialias: boolean };
  readonly target: LayerTarget;
  readonly #scale: number;

  constructor(session: EmulatedSession, context: WebGL2RenderingContext, init: LayerInit = {}) {
    super();
    if (session[P_SESSION].ended) throw new DOMException('The session has ended.', 'InvalidStateError');
    if (context.isContextLost()) throw new DOMException('The WebGL context is lost.', 'InvalidStateError');
    if (!(context instanceof WebGL2RenderingContext)) {
      throw new DOMException('The emulated device draws with WebGL 2 only.', 'NotSupportedError');
    }
    if (!isXrCompatible(context)) {
      throw new DOMException('The context is not XR compatible: make it with { xrCompatible: true }.', 'InvalidStateError');
    }
    const antialias = init.antialias ?? true;
    const { world, disposers } = session[P_EMULATED];
    this.#scale = Math.min(Math.max(init.framebufferScaleFactor ?? 1, SCALE_LIMITS.min), SCALE_LIMITS.max);
    this.target = createLayerTarget(context, ...this.#fitted(world.settings.sizePx ?? world.screen.sizePx()), {
      antialias,
      depth: init.depth ?? true,
      stencil: init.stencil ?? false,
      alpha: init.alpha ?? true,
    });
    disposers.push(this.target.dispose);
    this[P_WEBGL_LAYER] = { session, context, antialias };
  }

  /** As large as the device's screen is by now: true where that was another size. */
  fit(screenPx: readonly [width: number, height: number]): boolean {
    const [widthPx, heightPx] = this.#fitted(screenPx);
    if (widthPx === this.target.widthPx && heightPx === this.target.heightPx) return false;
    this.target.resize(widthPx, heightPx);
    return true;
  }

  /** Of an even width, so that two views are of one size. */
  #fitted([widthPx, heightPx]: readonly [number, number]): [number, number] {
    return [Math.max(2, Math.round((widthPx * this.#scale) / 2) * 2), Math.max(1, Math.round(heightPx * this.#scale))];
  }

  static getNativeFramebufferScaleFactor(session: EmulatedSession): number {
    if (!(session instanceof EmulatedSession)) throw new TypeError('This is no session.');
    return session[P_SESSION].ended ? 0 : 1;
  }

  get context(): WebGL2RenderingContext {
    return this[P_WEBGL_LAYER].context;
  }

  get antialias(): boolean {
    return this[P_WEBGL_LAYER].antialias;
  }

  get ignoreDepthValues(): boolean {
    return true;
  }

  /** Null, whatever is set: the device has none (WebXR Device API §11.3). */
  get fixedFoveation(): number | null {
    return null;
  }

  set fixedFoveation(_level: number | null) {}

  get framebuffer(): WebGLFramebuffer {
    return this.target.framebuffer;
  }

  get framebufferWidth(): number {
    return this.target.widthPx;
  }

  get framebufferHeight(): number {
    return this.target.heightPx;
  }

  getViewport(view: EmulatedView): XRViewport {
    if (!(view instanceof EmulatedView) || view[P_EYE].frame.session !== this[P_WEBGL_LAYER].session) {
      throw new DOMException('The view belongs to another session.', 'InvalidStateError');
    }
    view.checkFrame();
    const { x, y, widthPx, heightPx } = view[P_EYE].eye.viewport;
    return new XRViewport(x, y, widthPx, heightPx);
  }
}
