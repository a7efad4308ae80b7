import type { Material, WebGLProgramParametersWithUniforms } from 'three';

/** A change to the shaders of a three.js material. */
export interface ShaderPatch {
  /** Cache key, because three.js shares programs between materials. */
  readonly key: string;
  apply(shader: WebGLProgramParametersWithUniforms): void;
}

/** Applies patches after the master's own `onBeforeCompile`. */
export function patchMaterial(material: Material, master: Material | null, patches: readonly ShaderPatch[]): void {
  const key = patches.map((patch) => patch.key).join();
  material.onBeforeCompile = (shader, renderer) => {
    master?.onBeforeCompile(shader, renderer);
    for (const patch of patches) patch.apply(shader);
  };
  material.customProgramCacheKey = () => `${master?.customProgramCacheKey() ?? ''}|${key}`;
}

const MAIN = 'void main() {';

/**
 * Inserts GLSL before `main`, at its start and at its end. All shaders of three.js define `main` once, last, and in the same form
 * (`src/renderers/shaders/ShaderLib`); another form is a programming error.
 */
export function wrapMain(source: string, parts: { readonly before: string; readonly start: string; readonly end: string }): string {
  const main = source.indexOf(MAIN);
  const close = source.lastIndexOf('}');
  const isOne = main >= 0 && source.indexOf(MAIN, main + 1) < 0 && close > main;
  if (!isOne) throw new Error('A shader of three.js has another main than expected.');
  const body = source.slice(main + MAIN.length, close);
  return `${source.slice(0, main)}${parts.before}\n${MAIN}\n${parts.start}\n${body}\n${parts.end}\n}\n`;
}
