/** What has been seen of a page's pictures, in each frame of it. */
export interface FramesSeen {
  frames: number;
  /** Frames whose picture was black in all places that were looked at. */
  black: number;
  lostContexts: number;
  /** GL objects that were made and not deleted. */
  alive: number;
}

/**
 * Page code, to run before all others: looks at what is drawn at the end of each frame, while its picture can still be read, and
 * counts GL objects. The page's `framesSeen` tells.
 */
export function watchFrames(): void {
  const seen: FramesSeen = { frames: 0, black: 0, lostContexts: 0, alive: 0 };
  const page = globalThis as unknown as { framesSeen: FramesSeen };
  page.framesSeen = seen;
  const contexts = new Set<WebGL2RenderingContext>();
  const pixel = new Uint8Array(4);

  const isBlack = (gl: WebGL2RenderingContext): boolean => {
    const framebuffer = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
    const buffer = gl.getParameter(gl.PIXEL_PACK_BUFFER_BINDING) as WebGLBuffer | null;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    let sum = 0;
    for (const x of [0.2, 0.5, 0.8]) {
      gl.readPixels(Math.floor(gl.drawingBufferWidth * x), gl.drawingBufferHeight >> 1, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      sum += (pixel[0] ?? 0) + (pixel[1] ?? 0) + (pixel[2] ?? 0);
    }
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, framebuffer);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
    return sum === 0;
  };
  const look = () => {
    for (const gl of contexts) {
      if (gl.isContextLost() || gl.drawingBufferWidth < 16) continue;
      seen.frames += 1;
      if (isBlack(gl)) seen.black += 1;
    }
  };
  const count = (gl: WebGL2RenderingContext) => {
    const functions = gl as unknown as Record<string, (...args: unknown[]) => unknown>;
    for (const kind of ['Buffer', 'Framebuffer', 'Program', 'Query', 'Renderbuffer', 'Sampler', 'Shader', 'Texture', 'VertexArray']) {
      const make = functions[`create${kind}`]?.bind(gl);
      const drop = functions[`delete${kind}`]?.bind(gl);
      if (!make || !drop) continue;
      const made = new Set<unknown>();
      functions[`create${kind}`] = (...args) => {
        const object = make(...args);
        made.add(object);
        seen.alive += 1;
        return object;
      };
      functions[`delete${kind}`] = (object) => {
        if (made.delete(object)) seen.alive -= 1;
        return drop(object);
      };
    }
  };
  const getContext = HTMLCanvasElement.prototype.getContext as (this: HTMLCanvasElement, ...args: unknown[]) => unknown;
  (HTMLCanvasElement.prototype as unknown as { getContext: unknown }).getContext = function (this: HTMLCanvasElement, ...args: unknown[]) {
    const context = getContext.apply(this, args);
    if (!(context instanceof WebGL2RenderingContext) || contexts.has(context)) return context;
    contexts.add(context);
    count(context);
    this.addEventListener('webglcontextlost', () => {
      seen.lostContexts += 1;
    });
    return context;
  };
  const nextFrame = globalThis.requestAnimationFrame.bind(globalThis);
  globalThis.requestAnimationFrame = (run) =>
    nextFrame((time) => {
      run(time);
      look();
    });
}
