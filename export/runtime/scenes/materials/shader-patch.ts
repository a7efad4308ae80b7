import type { Material, WebGLProgramParametersWithUniforms } from 'three';

/** A change to the shaders that three makes for a material. */
export interface ShaderPatch {
  /** Tells programs apart: three shares them between materials by key. */
  readonly key: string;
  apply(shader: WebGLProgramParametersWithUniforms): void;
}

/** Installs patches, after whatever the master's own `onBeforeCompile` does. */
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
 * Puts GLSL before `main`, at its start and at its end. All of three's shaders write `main` once, last, and in one way
 * (`src/renderers/shaders/ShaderLib`); a shader that does not is a fault here.
 */
export function wrapMain(source: string, parts: { readonly before: string; readonly start: string; readonly end: string }): string {
  const main = source.indexOf(MAIN);
  const close = source.lastIndexOf('}');
  const isOne = main >= 0 && source.indexOf(MAIN, main + 1) < 0 && close > main;
  if (!isOne) throw new Error('A shader of three.js has another main than expected.');
  const body = source.slice(main + MAIN.length, close);
  return `${source.slice(0, main)}${parts.before}\n${MAIN}\n${parts.start}\n${body}\n${parts.end}\n}\n`;
}
