import type { Control } from '../program/program.ts';
import type { ControlValues } from './control-values.ts';
import { element } from './dom.ts';
import { PHONE } from './start-card.ts';

/** The elements of the page by which visitors set controls. */
export interface Controls {
  readonly element: HTMLElement;
  /** Shows or hides the controls; they are hidden until the first frame is drawn. */
  setShown(shown: boolean): void;
  /** Says whether a session was entered. On phones, controls are folded before, because card and controls would cover the image. */
  setEntered(entered: boolean): void;
}

/** Number of controls that are open at first where they do not fit beside the image. A button opens more. */
const FEW = 2;
/** Width from which the controls fit beside the image, CSS pixels. */
const WIDE_PX = 900;

/** Creates native inputs with labels, which support keys, screen readers and touch. Returns null if there are no controls. */
export function createControls(document: Document, values: ControlValues): Controls | null {
  const { controls } = values;
  if (controls.length === 0) return null;
  const parts = controls.map((control, i) => {
    const set = (value: number) => values.set(i, value);
    return createControl(document, `control-${i}`, control, { get: () => values.get(i), set });
  });
  // The values also change on the panel in the room.
  values.listen((index) => parts[index]?.show(values.get(index)));
  const body = element(document, 'div', { id: 'controls-body', className: 'controls-body' }, ...parts.map((part) => part.element));
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
  const page = document.defaultView;
  const isPhone = () => page?.matchMedia(PHONE).matches ?? false;
  const areFew = controls.length <= FEW;
  setOpen((page?.innerWidth ?? 0) >= WIDE_PX || (areFew && !isPhone()));
  const made = element(document, 'section', { className: 'controls', hidden: true, attributes: { 'aria-label': 'Controls' } }, fold, body);
  return {
    element: made,
    setShown: (shown) => {
      made.hidden = !shown;
    },
    setEntered: (entered) => setOpen(entered ? isOpen || areFew : isOpen && !isPhone()),
  };
}

/** One control: its element, and a function that displays a value. */
interface Part {
  readonly element: HTMLElement;
  show(value: number): void;
}

interface Value {
  get(): number;
  set(value: number): void;
}

function createControl(document: Document, id: string, control: Control, value: Value): Part {
  switch (control.kind) {
    case 'slider':
      return createSlider(document, id, control, value);
    case 'toggle':
      return createToggle(document, control, value);
    case 'choice':
      return createChoice(document, id, control, value);
    case 'button': {
      const press = () => value.set(value.get() + 1);
      const made = element(document, 'button', { className: 'press', attributes: { type: 'button' }, onClick: press }, control.label);
      return { element: made, show: () => {} };
    }
  }
}

function createSlider(document: Document, id: string, control: Extract<Control, { kind: 'slider' }>, { get, set }: Value): Part {
  const { label, min, max, step } = control;
  const shown = element(document, 'output', { attributes: { for: id } }, sliderText(control, get()));
  const input = element(document, 'input', {
    id,
    attributes: { type: 'range', min: String(min), max: String(max), step: step > 0 ? String(step) : 'any', value: String(get()) },
  });
  input.addEventListener('input', () => set(input.valueAsNumber));
  const head = element(
    document,
    'div',
    { className: 'control-head' },
    element(document, 'label', { attributes: { for: id } }, label),
    shown,
  );
  return {
    element: element(document, 'div', { className: 'control' }, head, input),
    show: (value) => {
      if (input.valueAsNumber !== value) input.valueAsNumber = value;
      shown.textContent = sliderText(control, value);
    },
  };
}

/** Formats a slider's value with as many digits as its step needs; without a step, a hundredth of the range. Angles are in whole degrees. */
export function sliderText({ min, max, step, unit }: { min: number; max: number; step: number; unit?: 'rad' }, value: number): string {
  if (unit === 'rad') return `${Math.round((value * 180) / Math.PI)}°`;
  const finest = step > 0 ? step : (max - min) / 100;
  const digits = finest > 0 ? Math.min(6, Math.max(0, Math.ceil(-Math.log10(finest) - 1e-9))) : 0;
  return value.toFixed(digits);
}

function createToggle(document: Document, { label }: Control, { get, set }: Value): Part {
  const input = element(document, 'input', { attributes: { type: 'checkbox', role: 'switch' } });
  const show = (value: number) => {
    input.checked = value !== 0;
  };
  show(get());
  input.addEventListener('change', () => set(input.checked ? 1 : 0));
  return { element: element(document, 'label', { className: 'control toggle' }, element(document, 'span', {}, label), input), show };
}

/** Creates a choice as radio buttons. Browsers show the list of a `select` outside the page, which AR hides. */
function createChoice(document: Document, id: string, control: Extract<Control, { kind: 'choice' }>, { get, set }: Value): Part {
  const inputs = control.options.map((_, i) => {
    const input = element(document, 'input', { attributes: { type: 'radio', name: id } });
    input.addEventListener('change', () => {
      if (input.checked) set(i);
    });
    return input;
  });
  const show = (value: number) => {
    for (const [i, input] of inputs.entries()) input.checked = i === value;
  };
  show(get());
  const labels = inputs.map((input, i) => element(document, 'label', {}, input, element(document, 'span', {}, control.options[i] ?? '')));
  const group = element(document, 'div', { className: 'choices' }, ...labels);
  return { element: element(document, 'fieldset', { className: 'control' }, element(document, 'legend', {}, control.label), group), show };
}
