import type { AssetKind } from './definition.ts';

/** What designers call an asset of a kind, in the singular. */
export const ASSET_WORDS: Readonly<Record<AssetKind, string>> = {
  image: 'picture',
  model: 'model',
  video: 'video',
  audio: 'sound',
  environment: 'panorama',
};
