import type { Editor } from '../editor/editor.ts';

export interface TourStep {
  readonly title: string;
  readonly text: string;
  /** CSS selector of the element that the step explains. */
  readonly about: string;
}

export const TOUR: readonly TourStep[] = [
  {
    title: 'The graph',
    text: 'Images, models and lights flow along wires from left to right, to the Output. Drag a wire from a port onto the empty canvas to see the nodes that fit.',
    about: '.canvas',
  },
  {
    title: 'Adding nodes',
    text: 'Press this button or Tab, or double-click the canvas, to search nodes by what they do: “blur”, “cartoon”, “shadow”. You can also drop models, images and shaders from your computer.',
    about: '[data-tour="add"]',
  },
  {
    title: 'The preview',
    text: 'The page as visitors see it, in a recorded room. With the controls below, pause it, step through its frames, or choose an emulated room to walk in.',
    about: '.stage',
  },
  {
    title: 'The inspector',
    text: 'All parameters of the selected node. Drag a number sideways, type arithmetic, or bind it to an expression. The preview updates while you edit.',
    about: '.inspector',
  },
  {
    title: 'The page',
    text: 'Export writes a folder for any web server. Phones and headsets show the page in augmented reality; on laptops, visitors look around with the pointer.',
    about: '[data-tour="export"]',
  },
];

export function startTour({ ui }: Editor): void {
  ui.setState({ tour: 0, dialog: null });
}

export function endTour({ ui }: Editor): void {
  ui.setState({ tour: null });
}

/** Goes to the next or previous step. After the last step, the tour ends. */
export function stepTour({ ui }: Editor, by: 1 | -1): void {
  ui.setState(({ tour }) => {
    if (tour === null) return {};
    const next = tour + by;
    return { tour: next >= TOUR.length ? null : Math.max(next, 0) };
  });
}
