/** Contexts made without `xrCompatible` that have not asked for it since. Real browsers refuse to make a layer with them. */
const plain = new WeakSet<object>();

export function isXrCompatible(context: WebGL2RenderingContext): boolean {
  return !plain.has(context);
}

/** What stands for `makeXRCompatible` on the contexts' prototypes. */
export async function makeXrCompatible(this: object): Promise<void> {
  plain.delete(this);
}

/**
 * Notes how contexts are made from now on: a browser without a device answers `xrCompatible: false` whatever was asked. Returns
 * what ends it.
 */
export function watchContexts(): () => void {
  const restore = [HTMLCanvasElement.prototype, OffscreenCanvas.prototype].map((prototype) => {
    const former = prototype.getContext as (this: object, kind: string, attributes?: { xrCompatible?: boolean }) => object | null;
    const getContext: typeof former = function (kind, attributes) {
      const context = former.call(this, kind, attributes);
      if (context instanceof WebGL2RenderingContext && attributes?.xrCompatible !== true) {
        if (!seen.has(context)) plain.add(context);
      }
      if (context) seen.add(context);
      return context;
    };
    Object.defineProperty(prototype, 'getContext', { configurable: true, writable: true, value: getContext });
    return () => Object.defineProperty(prototype, 'getContext', { configurable: true, writable: true, value: former });
  });
  return () => {
    for (const undo of restore) undo();
  };
}

/** A second call returns the first one's context, whatever it asks for. */
const seen = new WeakSet<object>();
