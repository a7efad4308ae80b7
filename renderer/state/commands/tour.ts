import type { Editor } from '../editor/editor.ts';

export interface TourStep {
  readonly title: string;
  readonly text: string;
  /** What of the window it is about, as a CSS selector. */
  readonly about: string;
}

export const TOUR: readonly TourStep[] = [
  {
    title: 'The graph',
    text: 'Pictures, models and lights flow along wires from left to right, to the Output. Pull a wire out of a port and let it go over the empty canvas: you are offered what fits.',
    about: '.canvas',
  },
  {
    title: 'Adding nodes',
    text: 'This button, Tab or a double-click on the canvas finds nodes by what they do: “blur”, “cartoon”, “shadow”. Or drop a model, a picture or a shader from your files.',
    about: '[data-tour="add"]',
  },
  {
    title: 'The preview',
    text: 'The page as its visitors will see it, over a recorded room. Below it, hold the time, step through it, or walk in an emulated room.',
    about: '.stage',
  },
  {
    title: 'The inspector',
    text: 'All values of the node that you select. Drag a number sideways, type a sum, or let it follow an expression. The picture follows while you change it.',
    about: '.inspector',
  },
  {
    title: 'The page',
    text: 'Export makes a folder that any web server can host: phones and headsets play it in augmented reality, laptops show it to look around in.',
    about: '[data-tour="export"]',
  },
];

export function startTour({ ui }: Editor): void {
  ui.setState({ tour: 0, dialog: null });
}

export function endTour({ ui }: Editor): void {
  ui.setState({ tour: null });
}

/** Ends it after the last step; there is nothing before the first. */
export function goOnTour({ ui }: Editor, by: 1 | -1): void {
  ui.setState(({ tour }) => {
    if (tour === null) return {};
    const next = tour + by;
    return { tour: next >= TOUR.length ? null : Math.max(next, 0) };
  });
}
