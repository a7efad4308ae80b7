import { P_SESSION, P_WEBGL_LAYER, XRLayer, XRViewport } from 'iwer';
import { type Gl, isWebGl2 } from '../display/app-gl.ts';
import { createLayerTarget } from '../display/create-layer-target.ts';
import { canvasTarget, type LayerTarget } from '../display/layer-target.ts';
import { P_EMULATED, P_EYE } from '../private.ts';
import { framebufferSizePx } from '../world.ts';
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
 * `XRWebGLLayer` with its own framebuffer, as on a device. iwer uses the canvas, where a page that forgets to bind the framebuffer still
 * seems to work.
 */
export class EmulatedLayer extends XRLayer {
  readonly [P_WEBGL_LAYER]: { session: EmulatedSession; context: Gl; antialias: boolean };
  readonly target: LayerTarget;
  readonly #scale: number;
  /** The viewport object of each view, which every call of `getViewport` returns. */
  readonly #viewports = new WeakMap<EmulatedView, XRViewport>();

  constructor(session: EmulatedSession, context: Gl, init: LayerInit = {}) {
    super();
    if (session[P_SESSION].ended) throw new DOMException('The session has ended.', 'InvalidStateError');
    if (context.isContextLost()) throw new DOMException('The WebGL context is lost.', 'InvalidStateError');
    const { world, disposers } = session[P_EMULATED];
    if (session[P_SESSION].mode === 'inline') {
      this.#scale = 1;
      this.target = canvasTarget(context);
      this[P_WEBGL_LAYER] = { session, context, antialias: context.getContextAttributes()?.antialias ?? false };
      return;
    }
    if (!isXrCompatible(context)) {
      throw new DOMException('The context is not XR compatible. Create it with { xrCompatible: true }.', 'InvalidStateError');
    }
    const antialias = (init.antialias ?? true) && isWebGl2(context);
    this.#scale = Math.min(Math.max(init.framebufferScaleFactor ?? 1, SCALE_LIMITS.min), SCALE_LIMITS.max);
    this.target = createLayerTarget(context, ...framebufferSizePx(world, this.#scale), {
      antialias,
      depth: init.depth ?? true,
      stencil: init.stencil ?? false,
      alpha: init.alpha ?? true,
    });
    disposers.push(this.target.dispose);
    this[P_WEBGL_LAYER] = { session, context, antialias };
  }

  /** Resizes to the current size of the device's screen. */
  fit(): void {
    const [widthPx, heightPx] = framebufferSizePx(this[P_WEBGL_LAYER].session[P_EMULATED].world, this.#scale);
    if (widthPx !== this.target.widthPx || heightPx !== this.target.heightPx) this.target.resize(widthPx, heightPx);
  }

  static getNativeFramebufferScaleFactor(session: EmulatedSession): number {
    if (!(session instanceof EmulatedSession)) throw new TypeError('The session is not an XRSession of this device.');
    return session[P_SESSION].ended ? 0 : 1;
  }

  get antialias(): boolean {
    return this[P_WEBGL_LAYER].antialias;
  }

  get ignoreDepthValues(): boolean {
    return true;
  }

  /** Always null: the device does not support foveation (WebXR Device API §11.3). */
  get fixedFoveation(): number | null {
    return null;
  }

  set fixedFoveation(_level: number | null) {}

  /** Null in inline sessions, which draw to the canvas. */
  get framebuffer(): WebGLFramebuffer | null {
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
    const known = this.#viewports.get(view);
    if (known) return known;
    const { x, y, widthPx, heightPx } = view.viewportIn(view[P_EYE].eye.viewport);
    const viewport = new XRViewport(x, y, widthPx, heightPx);
    this.#viewports.set(view, viewport);
    return viewport;
  }
}
