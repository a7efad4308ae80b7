/** The result of a function, and the GPU objects that it created and does not delete. */
export interface Leftovers<T> {
  readonly made: T;
  /** Deletes the objects. */
  free(): void;
}

/**
 * Runs `make` and records the textures and framebuffers that it creates. The renderer of three.js creates four empty textures and three
 * framebuffers and does not delete them in `dispose`, so they would accumulate in a context that outlives its players.
 */
export function catchLeftovers<T>(gl: WebGL2RenderingContext, make: () => T): Leftovers<T> {
  const textures: WebGLTexture[] = [];
  const framebuffers: WebGLFramebuffer[] = [];
  const stopTextures = intercept(gl, 'createTexture', textures);
  const stopFramebuffers = intercept(gl, 'createFramebuffer', framebuffers);
  try {
    const made = make();
    return {
      made,
      free: () => {
        for (const texture of textures) gl.deleteTexture(texture);
        for (const framebuffer of framebuffers) gl.deleteFramebuffer(framebuffer);
      },
    };
  } finally {
    stopTextures();
    stopFramebuffers();
  }
}

/** Wraps a method of the context: each object that it creates is added to `into`, until the returned function is called. */
function intercept(gl: WebGL2RenderingContext, method: 'createTexture' | 'createFramebuffer', into: object[]): () => void {
  const before = Object.getOwnPropertyDescriptor(gl, method);
  const original = gl[method].bind(gl);
  Object.defineProperty(gl, method, {
    configurable: true,
    value: () => {
      const object = original();
      into.push(object);
      return object;
    },
  });
  return () => {
    if (before) Object.defineProperty(gl, method, before);
    else Reflect.deleteProperty(gl, method);
  };
}
