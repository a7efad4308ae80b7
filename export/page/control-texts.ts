import { element } from './dom.ts';

/** What the page says about its controls in headsets, which have no DOM overlay. A page without controls says nothing. */
export function controlTexts(document: Document): readonly HTMLElement[] {
  return [element(document, 'p', {}, CONTROLS_IN_ROOM)];
}

const CONTROLS_IN_ROOM =
  'In a headset the controls are on a panel in front of you, below your eyes. Point at it and press. Values that you set here are kept.';
