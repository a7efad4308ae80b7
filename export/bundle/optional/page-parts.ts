import { entersSessions } from '../page-entry.ts';
import { absent, type OptionalPart } from './part.ts';

/** Parts of the page around the image. */
export const PAGE_PARTS: readonly OptionalPart[] = [
  {
    file: 'export/page/control-elements.ts',
    isNeeded: ({ controls }) => controls,
    otherwise: `export const createControls = () => null;\n${absent('sliderText')}`,
  },
  {
    file: 'export/page/control-texts.ts',
    isNeeded: ({ controls }) => controls,
    otherwise: 'export const controlTexts = () => [];',
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
  {
    file: 'export/page/session-modes.ts',
    isNeeded: entersSessions,
    otherwise: `export const NOT_LOADED = null;
export const findSessionModes = async () => ({ offers: [], fallbacks: [], noAr: null });
export const lacksOf = () => [];`,
  },
  {
    file: 'export/page/mode-elements.ts',
    isNeeded: entersSessions,
    otherwise: `export const createModeElements = () => ({ elements: [], lacks: [], show: () => {}, firstButton: () => null });`,
  },
  {
    file: 'export/page/leave-button.ts',
    isNeeded: entersSessions,
    otherwise: 'export const createLeaveButton = () => null;',
  },
  {
    file: 'export/page/session-entry.ts',
    isNeeded: entersSessions,
    otherwise: `const nothing = () => {};
export const createSessionEntry = ({ root }) => ({
  offer: () => root.panel.show({ kind: 'ready', offers: [], reason: null }),
  enter: nothing,
  onEvent: nothing,
});`,
  },
];
