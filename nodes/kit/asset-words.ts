import type { AssetKind } from './definition.ts';

/**
 * The word for an asset of each kind, as users read it.
 *
 * @example
 * `The ${ASSET_WORDS.environment} cannot be decoded.` // 'The panorama cannot be decoded.'
 */
export const ASSET_WORDS: Readonly<Record<AssetKind, string>> = {
  image: 'image',
  model: 'model',
  video: 'video',
  audio: 'sound',
  environment: 'panorama',
  capture: 'capture',
  splats: 'file of splats',
};

/**
 * The word for an asset of a kind with its indefinite article.
 *
 * @returns Such as `an image`.
 *
 * @example
 * `Import ${oneAsset('image')}`; // 'Import an image'
 */
export function oneAsset(kind: AssetKind): string {
  return `${kind === 'image' ? 'an' : 'a'} ${ASSET_WORDS[kind]}`;
}
