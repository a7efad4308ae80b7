import type { Control } from '../program/program.ts';
import { element } from './dom.ts';

/** What visitors can set, on screen. */
export interface Controls {
  readonly element: HTMLElement;
  /** Whether it can be used: not before there is a picture that it changes. */
  setShown(shown: boolean): void;
}

export type SetControl = (control: Control, value: number | boolean) => void;

/** So many leave enough of the picture on a phone; more are shown when asked for. */
const FEW = 2;
/** From here on the picture is wide enough to have controls beside it, CSS pixels. */
const WIDE_PX = 900;

/** Native inputs with labels, so that keys, screen readers and fingers all work; null where there is nothing to set. */
export function createControls(document: Document, controls: readonly Control[], set: SetControl): Controls | null {
  if (controls.length === 0) return null;
  const parts = controls.map((control, i) => createControl(document, `control-${i}`, control, (value) => set(control, value)));
  const body = element(document, 'div', { id: 'controls-body', className: 'controls-body' }, ...parts);
  let isOpen = false;
  const fold = element(
    document,
    'button',
    {
      className: 'controls-fold',
      attributes: { type: 'button', 'aria-controls': 'controls-body' },
      onClick: () => setOpen(!isOpen),
    },
    'Controls',
  );
  const setOpen = (next: boolean) => {
    isOpen = next;
    body.hidden = !next;
    fold.setAttribute('aria-expanded', String(next));
  };
  setOpen(controls.length <= FEW || (document.defaultView?.innerWidth ?? 0) >= WIDE_PX);
  const made = element(document, 'section', { className: 'controls', hidden: true, attributes: { 'aria-label': 'Controls' } }, fold, body);
  return {
    element: made,
    setShown: (shown) => {
      made.hidden = !shown;
    },
  };
}

function createControl(document: Document, id: string, control: Control, set: (value: number | boolean) => void): HTMLElement {
  switch (control.kind) {
    case 'slider':
      return createSlider(document, id, control, set);
    case 'toggle':
      return createToggle(document, control, set);
    case 'choice':
      return createChoice(document, id, control, set);
    case 'button': {
      let presses = control.value;
      const press = () => set(++presses);
      return element(document, 'button', { className: 'press', attributes: { type: 'button' }, onClick: press }, control.label);
    }
  }
}

function createSlider(
  document: Document,
  id: string,
  control: Extract<Control, { kind: 'slider' }>,
  set: (value: number) => void,
): HTMLElement {
  const { label, min, max, step, value } = control;
  const shown = element(document, 'output', { attributes: { for: id } }, sliderText(control, value));
  const input = element(document, 'input', {
    id,
    attributes: { type: 'range', min: String(min), max: String(max), step: step > 0 ? String(step) : 'any', value: String(value) },
  });
  input.addEventListener('input', () => {
    set(input.valueAsNumber);
    shown.textContent = sliderText(control, input.valueAsNumber);
  });
  const head = element(
    document,
    'div',
    { className: 'control-head' },
    element(document, 'label', { attributes: { for: id } }, label),
    shown,
  );
  return element(document, 'div', { className: 'control' }, head, input);
}

/** As many digits as tell one step from the next; without steps, a hundredth of the way. */
export function sliderText({ min, max, step }: { min: number; max: number; step: number }, value: number): string {
  const finest = step > 0 ? step : (max - min) / 100;
  const digits = finest > 0 ? Math.min(6, Math.max(0, Math.ceil(-Math.log10(finest) - 1e-9))) : 0;
  return value.toFixed(digits);
}

function createToggle(document: Document, { label, value }: Control, set: (value: boolean) => void): HTMLElement {
  const input = element(document, 'input', { attributes: { type: 'checkbox', role: 'switch' } });
  input.checked = value !== 0;
  input.addEventListener('change', () => set(input.checked));
  return element(document, 'label', { className: 'control toggle' }, element(document, 'span', {}, label), input);
}

/** Radio buttons: lists that open do so outside the page, where AR shows nothing. */
function createChoice(
  document: Document,
  id: string,
  { label, options, value }: Extract<Control, { kind: 'choice' }>,
  set: (value: number) => void,
): HTMLElement {
  const choices = options.map((text, i) => {
    const input = element(document, 'input', { attributes: { type: 'radio', name: id } });
    input.checked = i === value;
    input.addEventListener('change', () => {
      if (input.checked) set(i);
    });
    return element(document, 'label', {}, input, element(document, 'span', {}, text));
  });
  const group = element(document, 'div', { className: 'choices' }, ...choices);
  return element(document, 'fieldset', { className: 'control' }, element(document, 'legend', {}, label), group);
}
