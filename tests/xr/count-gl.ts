import type { Page } from 'playwright-core';

/** Counts what is made on the context of the page's canvas from now on. */
export async function watchGl(page: Page): Promise<void> {
  await page.evaluate(() => {
    const gl = document.querySelector('canvas')?.getContext('webgl2');
    if (!gl) throw new Error('The page has no canvas.');
    const alive = new Set<unknown>();
    for (const kind of ['Texture', 'Program', 'Shader', 'VertexArray', 'Framebuffer', 'Renderbuffer', 'Sampler', 'Buffer'] as const) {
      const make = gl[`create${kind}` as 'createTexture'].bind(gl);
      const remove = gl[`delete${kind}` as 'deleteTexture'].bind(gl);
      Object.assign(gl, {
        [`create${kind}`]: (type: never) => {
          const made = (make as (type: never) => WebGLTexture)(type);
          alive.add(made);
          return made;
        },
        [`delete${kind}`]: (object: WebGLTexture) => {
          alive.delete(object);
          remove(object);
        },
      });
    }
    Object.assign(window, { alive });
  });
}

/** Of frames in a row that make and delete nothing. */
const CALM_FRAMES = 8;

/** How many of those there are, once it stays so: a session that ends is cleared away, and what follows it draws, a little later. */
export async function aliveGl(page: Page): Promise<number> {
  return page.evaluate(async (calmFrames) => {
    const { alive } = window as unknown as { alive: Set<unknown> };
    let last = alive.size;
    for (let calm = 0; calm < calmFrames; ) {
      await new Promise(requestAnimationFrame);
      calm = alive.size === last ? calm + 1 : 0;
      last = alive.size;
    }
    return last;
  }, CALM_FRAMES);
}
