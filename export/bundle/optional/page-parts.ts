import { absent, type OptionalPart } from './part.ts';

/** Parts of the page around the image. */
export const PAGE_PARTS: readonly OptionalPart[] = [
  {
    file: 'export/page/control-elements.ts',
    isNeeded: ({ controls }) => controls,
    otherwise: `export const createControls = () => null;\n${absent('sliderText')}`,
  },
  {
    file: 'export/page/credits-list.ts',
    isNeeded: ({ credits }) => credits,
    otherwise: 'export const createCredits = () => [];',
  },
  {
    file: 'export/page/embedded-files.ts',
    isNeeded: ({ singleFile }) => singleFile,
    otherwise: `export const hasEmbeddedFiles = () => false;\n${absent('createEmbeddedAssetSource')}`,
  },
];
