/** GPU objects that somebody made and will not free. */
export interface Leftovers<T> {
  readonly made: T;
  /** Deletes them. */
  free(): void;
}

/**
 * Runs `make` and keeps the textures and framebuffers created meanwhile.
 *
 * three's renderer makes four empty textures and three framebuffers when it starts and deletes none of them in `dispose`, so a
 * context that outlives its players would gather them.
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

/** Puts every object that the method returns into `into`, until the returned function is called. */
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
