import type { Gl } from './display/app-gl.ts';

/**
 * Contexts that are not XR compatible: created without `xrCompatible` and without a later `makeXRCompatible`. Browsers reject layers with
 * them.
 */
const plain = new WeakSet<object>();

export function isXrCompatible(context: Gl): boolean {
  return !plain.has(context);
}

/** Replaces `makeXRCompatible` of the contexts' prototypes: WebXR Device API §11.6. */
export async function makeXrCompatible(this: Gl): Promise<void> {
  if (this.isContextLost()) throw new DOMException('The WebGL context is lost.', 'InvalidStateError');
  plain.delete(this);
}

/**
 * Records whether new contexts request `xrCompatible`, and reports that in `getContextAttributes`, because a browser without a device
 * always reports false. Returns a function that stops recording.
 */
export function watchContexts(): () => void {
  const undos = [...watchMaking(), ...answerAttributes()];
  return () => {
    for (const undo of undos) undo();
  };
}

function watchMaking(): (() => void)[] {
  return [HTMLCanvasElement.prototype, OffscreenCanvas.prototype].map((prototype) => {
    const former = prototype.getContext as (this: object, kind: string, attributes?: { xrCompatible?: boolean }) => object | null;
    const getContext: typeof former = function (kind, attributes) {
      const context = former.call(this, kind, attributes);
      if (isGl(context) && attributes?.xrCompatible !== true) {
        if (!seen.has(context)) plain.add(context);
      }
      if (context) seen.add(context);
      return context;
    };
    return replace(prototype, 'getContext', getContext);
  });
}

function answerAttributes(): (() => void)[] {
  return [WebGLRenderingContext.prototype, WebGL2RenderingContext.prototype].map((prototype) => {
    const former = prototype.getContextAttributes;
    const getContextAttributes = function (this: Gl): object | null {
      const attributes = former.call(this);
      return attributes && { ...attributes, xrCompatible: isXrCompatible(this) };
    };
    return replace(prototype, 'getContextAttributes', getContextAttributes);
  });
}

function replace(prototype: object, name: string, value: unknown): () => void {
  const former = Object.getOwnPropertyDescriptor(prototype, name) ?? {};
  Object.defineProperty(prototype, name, { ...former, value });
  return () => Object.defineProperty(prototype, name, former);
}

function isGl(context: object | null): context is Gl {
  return context instanceof WebGL2RenderingContext || context instanceof WebGLRenderingContext;
}

/** Contexts that `getContext` returned before: a second call returns the same one regardless of its options. */
const seen = new WeakSet<object>();
