import { editor, type IPosition, type IRange, KeyCode, KeyMod } from 'monaco-editor/editor';
import { createElement } from 'react';
import { createRoot, type Root } from 'react-dom/client';
import {
  type ColourLiteral,
  coloursOf,
  type NumberLiteral,
  numberAt,
  printColour,
  printLiteral,
  rangeOfSlider,
  stepOf,
} from '../../export/glsl/language/literals.ts';
import { touches } from '../../export/glsl/language/source-text.ts';
import { SWATCH_CLASS } from './colour-marks.ts';
import { ColourTuner, NumberTuner } from './literal-tuner.tsx';
import { documentOf, rangeOf, type ShaderTexts } from './shader-models.ts';

export interface TuningOptions {
  readonly texts: ShaderTexts;
  /** The text changes by the tuner until `onEnd`: what it is then is to be seen at once. */
  readonly onStart: () => void;
  readonly onEnd: () => void;
}

export interface Tuning {
  dispose(): void;
}

const PX_PER_STEP = 3;
const CLICK_PX = 3;

/**
 * Numbers and colours of the text by hand: a number is dragged with Alt, and a click on it or on the square before a colour, or
 * Alt+Enter, opens sliders beside it. What one drag changes is one step.
 */
export function createTuning(view: editor.IStandaloneCodeEditor, { texts, onStart, onEnd }: TuningOptions): Tuning {
  let open: {
    readonly widget: editor.IContentWidget;
    readonly root: Root;
    readonly node: HTMLElement;
    readonly observer: MutationObserver;
    readonly isOurs: () => boolean;
  } | null = null;

  /** Puts text in the place of a literal, again and again. */
  function createTarget(start: IRange) {
    let range = start;
    let writing = false;
    let started = false;
    return {
      isWriting: () => writing,
      write: (text: string) => {
        const model = view.getModel();
        if (!model || model.getValueInRange(range) === text) return;
        if (!started) {
          onStart();
          model.pushStackElement();
        }
        started = true;
        writing = true;
        model.pushEditOperations([], [{ range, text }], () => null);
        range = { ...range, endLineNumber: range.startLineNumber, endColumn: range.startColumn + text.length };
        writing = false;
      },
      end: () => {
        if (!started) return;
        started = false;
        view.getModel()?.pushStackElement();
        onEnd();
      },
    };
  }

  function close(): void {
    if (!open) return;
    const { widget, root, observer } = open;
    open = null;
    observer.disconnect();
    view.removeContentWidget(widget);
    // React may be in the middle of telling that it was closed.
    queueMicrotask(() => root.unmount());
  }

  function closeAndReturn(): void {
    close();
    view.focus();
  }

  function show(range: IRange, render: (target: ReturnType<typeof createTarget>) => React.ReactElement, focus: boolean): void {
    close();
    const target = createTarget(range);
    const node = document.createElement('div');
    node.className = 'tuner-place';
    const root = createRoot(node);
    let wantsFocus = focus;
    // React puts its elements in place in its own time, and Monaco shows the widget in its own: whichever is later gives the focus.
    const takeFocus = () => {
      const field = node.querySelector<HTMLElement>('input[type="range"]');
      if (!wantsFocus || !field) return;
      field.focus();
      wantsFocus = document.activeElement !== field;
    };
    const observer = new MutationObserver(takeFocus);
    observer.observe(node, { childList: true, subtree: true });
    const widget: editor.IContentWidget = {
      afterRender: takeFocus,
      allowEditorOverflow: true,
      suppressMouseDown: false,
      getId: () => 'scrim.tuner',
      getDomNode: () => node,
      getPosition: () => ({
        position: { lineNumber: range.startLineNumber, column: range.startColumn },
        preference: [editor.ContentWidgetPositionPreference.BELOW, editor.ContentWidgetPositionPreference.ABOVE],
      }),
    };
    root.render(render(target));
    view.addContentWidget(widget);
    open = { widget, root, node, observer, isOurs: target.isWriting };
  }

  function showNumber(literal: NumberLiteral, focus: boolean): void {
    const step = stepOf(literal);
    const { min, max } = rangeOfSlider(literal);
    const print = (value: number) => printLiteral(literal, value, step);
    show(
      rangeOf(literal.range),
      ({ write, end }) =>
        createElement(NumberTuner, {
          ...{ start: literal.value, min, max, step, print },
          onEdit: (value: number) => write(print(value)),
          onEnd: end,
          onClose: closeAndReturn,
        }),
      focus,
    );
  }

  function showColour(literal: ColourLiteral, focus: boolean): void {
    show(
      rangeOf(literal.range),
      ({ write, end }) =>
        createElement(ColourTuner, {
          start: literal.colour,
          hasAlpha: literal.hasAlpha,
          onEdit: (colour) => write(printColour(literal, colour)),
          onEnd: end,
          onClose: closeAndReturn,
        }),
      focus,
    );
  }

  function numberNear({ lineNumber, column }: IPosition): NumberLiteral | null {
    const model = view.getModel();
    if (!model || isReadOnly()) return null;
    return numberAt(model.getValue(), { line: lineNumber, column }, documentOf(model, texts).outline);
  }

  function colourNear({ lineNumber, column }: IPosition): ColourLiteral | null {
    const model = view.getModel();
    if (!model || isReadOnly()) return null;
    const colours = coloursOf(model.getValue(), documentOf(model, texts).outline);
    return colours.find(({ range }) => touches(range, { line: lineNumber, column })) ?? null;
  }

  function isReadOnly(): boolean {
    return view.getOption(editor.EditorOption.readOnly);
  }

  /** With Alt, a number follows the pointer sideways. */
  function onPointerDown(event: PointerEvent): void {
    if (!event.altKey || event.button !== 0 || event.shiftKey) return;
    const position = view.getTargetAtClientPoint(event.clientX, event.clientY)?.position;
    const literal = position ? numberNear(position) : null;
    if (!literal) return;
    event.preventDefault();
    event.stopPropagation();
    close();
    dragNumber(literal, event);
  }

  function dragNumber(literal: NumberLiteral, { clientX, pointerId }: PointerEvent): void {
    const target = createTarget(rangeOf(literal.range));
    const step = stepOf(literal);
    // What was pressed is made anew with each change of its line.
    dom.setPointerCapture(pointerId);
    const onMove = (event: PointerEvent) => {
      const steps = Math.round((event.clientX - clientX) / PX_PER_STEP) * (event.shiftKey ? 10 : 1);
      target.write(printLiteral(literal, literal.value + steps * step, step));
    };
    const onUp = () => {
      dom.removeEventListener('pointermove', onMove);
      dom.removeEventListener('lostpointercapture', onUp);
      target.end();
    };
    dom.addEventListener('pointermove', onMove);
    dom.addEventListener('lostpointercapture', onUp);
  }

  /** Monaco begins a selection by columns with this. */
  function onMouseDownFirst(event: MouseEvent): void {
    if (!event.altKey || event.button !== 0 || event.shiftKey) return;
    const position = view.getTargetAtClientPoint(event.clientX, event.clientY)?.position;
    if (!position || !numberNear(position)) return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** Anywhere else on the page, a press means that the person is done with it. */
  function onPressAnywhere({ target }: PointerEvent): void {
    if (open && target instanceof Node && !open.node.contains(target) && !dom.contains(target)) close();
  }

  let pressed: { readonly x: number; readonly y: number; readonly swatch: boolean } | null = null;
  const dom = view.getContainerDomNode();
  dom.addEventListener('pointerdown', onPointerDown, true);
  window.addEventListener('pointerdown', onPressAnywhere, true);
  dom.addEventListener('mousedown', onMouseDownFirst, true);
  const parts = [
    view.onMouseDown(({ event, target }) => {
      const swatch = target.element?.classList.contains(SWATCH_CLASS) ?? false;
      pressed =
        event.leftButton && !event.altKey && !event.ctrlKey && !event.metaKey && !event.shiftKey
          ? { x: event.posx, y: event.posy, swatch }
          : null;
    }),
    view.onMouseUp(({ event, target }) => {
      const from = pressed;
      pressed = null;
      if (!from || !target.position || Math.hypot(event.posx - from.x, event.posy - from.y) > CLICK_PX || event.detail > 1) return;
      const colour = from.swatch ? colourNear(target.position) : null;
      if (colour) {
        showColour(colour, true);
        return;
      }
      const number = target.type === editor.MouseTargetType.CONTENT_TEXT ? numberNear(target.position) : null;
      if (number) showNumber(number, false);
    }),
    view.onDidChangeModelContent(() => {
      if (open && !open.isOurs()) close();
    }),
    view.onDidChangeCursorPosition(({ source }) => {
      if (source === 'keyboard' || source === 'mouse') close();
    }),
    view.onDidChangeModel(close),
    view.onKeyDown((event) => {
      if (event.keyCode !== KeyCode.Escape || !open) return;
      event.preventDefault();
      event.stopPropagation();
      close();
    }),
    view.addAction({
      id: 'scrim.tune',
      label: 'Tune the number or colour',
      keybindings: [KeyMod.Alt | KeyCode.Enter],
      contextMenuGroupId: '1_modification',
      run: () => {
        const position = view.getPosition();
        if (!position) return;
        const number = numberNear(position);
        const colour = colourNear(position);
        if (number && !(colour && touchesStart(colour, position))) showNumber(number, true);
        else if (colour) showColour(colour, true);
      },
    }),
  ];
  return {
    dispose: () => {
      close();
      dom.removeEventListener('pointerdown', onPointerDown, true);
      window.removeEventListener('pointerdown', onPressAnywhere, true);
      dom.removeEventListener('mousedown', onMouseDownFirst, true);
      for (const part of parts) part.dispose();
    },
  };
}

/** The caret is at the `vec3`, or at the bracket of a list, rather than at one of its numbers. */
function touchesStart({ range, form }: ColourLiteral, { lineNumber, column }: IPosition): boolean {
  return lineNumber === range.start.line && column <= range.start.column + (form === 'call' ? 4 : 0);
}
