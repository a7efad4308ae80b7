import type { Gltf } from './document.ts';

/**
 * The names of the animations of a model, each once, in the order of the file. One without a name is called as three.js calls it,
 * `animation_0` for the first; of several with one name, only the first can be chosen.
 */
export function animationNames({ document: { animations = [] } }: Gltf): string[] {
  return [...new Set(animations.map(({ name = '' }, index) => (name === '' ? `animation_${index}` : name)))];
}
