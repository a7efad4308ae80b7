import type { XrPage } from './xr-page.ts';

/** Script of a page: records the matrices that it gives to a shader last. Of a page with one object these are the object's. */
export const WATCH_MATRICES = `
  const names = new WeakMap();
  const { getUniformLocation, uniformMatrix4fv } = WebGL2RenderingContext.prototype;
  Object.assign(WebGL2RenderingContext.prototype, {
    getUniformLocation(program, name) {
      const location = getUniformLocation.call(this, program, name);
      if (location) names.set(location, name);
      return location;
    },
    uniformMatrix4fv(location, transpose, value, ...rest) {
      const name = names.get(location);
      if (['modelViewMatrix', 'viewMatrix', 'projectionMatrix'].includes(name)) (this.drawn ??= {})[name] = Array.from(value);
      uniformMatrix4fv.call(this, location, transpose, value, ...rest);
    },
  });
`;

/** Column-major 4×4. */
export interface DrawnMatrices {
  readonly modelViewMatrix: readonly number[];
  readonly viewMatrix: readonly number[];
  readonly projectionMatrix: readonly number[];
}

/** Null while no object is drawn. */
export function drawnMatrices({ page }: XrPage): Promise<DrawnMatrices | null> {
  return page.evaluate(() => {
    const gl = document.querySelector('canvas')?.getContext('webgl2') as { drawn?: DrawnMatrices } | null | undefined;
    // The quads that filter the environment have no view matrix.
    return gl?.drawn && 'viewMatrix' in gl.drawn ? gl.drawn : null;
  });
}

/** Forgets what was recorded, such as the draw that compiles the materials of hidden objects. */
export function forgetDrawn({ page }: XrPage): Promise<void> {
  return page.evaluate(() => {
    const gl = document.querySelector('canvas')?.getContext('webgl2') as { drawn?: DrawnMatrices } | null | undefined;
    if (gl) delete gl.drawn;
  });
}
