import { element } from '../dom.ts';

/** A button of the bar. */
export interface StepAction {
  readonly label: string;
  readonly run: () => void;
}

/** What the bar shows. The first action is the one that visitors usually need. */
export interface StepBarState {
  readonly text: string;
  /** Progress as a fraction in [0, 1]; null shows none. */
  readonly progress: number | null;
  readonly actions: readonly StepAction[];
}

/** The bar over the camera image that guides the visitor through taking a panorama. */
export interface StepBar {
  readonly element: HTMLElement;
  /** Shows a state of the step; null hides the bar. */
  show(state: StepBarState | null): void;
}

export function createStepBar(document: Document): StepBar {
  const text = element(document, 'p', { attributes: { role: 'status' } });
  const progress = element(document, 'progress', { attributes: { max: '1', 'aria-label': 'Panorama' } });
  const buttons = element(document, 'div', { className: 'step-actions' });
  const bar = element(document, 'section', { className: 'step-bar', hidden: true, attributes: { 'aria-label': 'Panorama' } });
  bar.append(text, progress, buttons);
  let actions = '';
  return {
    element: bar,
    show: (state) => {
      bar.hidden = state === null;
      if (state === null) return;
      if (text.textContent !== state.text) text.textContent = state.text;
      progress.hidden = state.progress === null;
      progress.value = state.progress ?? 0;
      // Buttons that are shown again would lose the focus.
      const labels = state.actions.map(({ label }) => label).join('\n');
      if (labels === actions) return;
      actions = labels;
      buttons.replaceChildren(
        ...state.actions.map(({ label, run }, i) =>
          element(document, 'button', { className: i === 0 ? 'step-first' : '', attributes: { type: 'button' }, onClick: run }, label),
        ),
      );
    },
  };
}
