import { editor, type IPosition, type IRange, KeyCode, KeyMod } from 'monaco-editor/editor';
import { createElement } from 'react';
import { createRoot, type Root } from 'react-dom/client';
import {
  type ColorLiteral,
  colorsOf,
  type NumberLiteral,
  numberAt,
  printColor,
  printLiteral,
  rangeOfSlider,
  stepOf,
} from '../../export/glsl/language/literals.ts';
import { touches } from '../../export/glsl/language/source-text.ts';
import { SWATCH_CLASS } from './color-marks.ts';
import { ColorTuner, NumberTuner } from './literal-tuner.tsx';
import { rangeOf } from './shader-models.ts';

export interface TuningOptions {
  /** Called when tuning begins. Until `onEnd`, edits take effect at once. */
  readonly onStart: () => void;
  readonly onEnd: () => void;
}

export interface Tuning {
  dispose(): void;
}

const PX_PER_STEP = 3;
const CLICK_PX = 3;

/**
 * Tunes number and color literals in the text. Alt-drag changes a number; Alt-click, a click on a swatch, or Alt+Enter opens sliders.
 * Each drag is one undo step.
 */
export function createTuning(view: editor.IStandaloneCodeEditor, { onStart, onEnd }: TuningOptions): Tuning {
  let open: {
    readonly widget: editor.IContentWidget;
    readonly root: Root;
    readonly node: HTMLElement;
    readonly observer: MutationObserver;
    readonly isOurs: () => boolean;
  } | null = null;

  /** Replaces a literal repeatedly while it is tuned. */
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
    // React may still be handling the event that closed it.
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
    // React mounts the elements and Monaco shows the widget asynchronously; the later of the two sets the focus.
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
          start: literal.value,
          min,
          max,
          step,
          print,
          onEdit: (value: number) => write(print(value)),
          onEnd: end,
          onClose: closeAndReturn,
        }),
      focus,
    );
  }

  function showColor(literal: ColorLiteral, focus: boolean): void {
    show(
      rangeOf(literal.range),
      ({ write, end }) =>
        createElement(ColorTuner, {
          start: literal.color,
          hasAlpha: literal.hasAlpha,
          onEdit: (color) => write(printColor(literal, color)),
          onEnd: end,
          onClose: closeAndReturn,
        }),
      focus,
    );
  }

  function numberNear({ lineNumber, column }: IPosition): NumberLiteral | null {
    const model = view.getModel();
    if (!model || isReadOnly()) return null;
    return numberAt(model.getValue(), { line: lineNumber, column });
  }

  function colorNear({ lineNumber, column }: IPosition): ColorLiteral | null {
    const model = view.getModel();
    if (!model || isReadOnly()) return null;
    const colors = colorsOf(model.getValue());
    return colors.find(({ range }) => touches(range, { line: lineNumber, column })) ?? null;
  }

  function isReadOnly(): boolean {
    return view.getOption(editor.EditorOption.readOnly);
  }

  /** Starts an Alt-drag, which changes a number. */
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
    // The pressed element is replaced on each edit of its line.
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

  /** Keeps Monaco from starting a column selection on Alt-drag. */
  function onMouseDownFirst(event: MouseEvent): void {
    if (!event.altKey || event.button !== 0 || event.shiftKey) return;
    const position = view.getTargetAtClientPoint(event.clientX, event.clientY)?.position;
    if (!position || !numberNear(position)) return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** A press elsewhere on the page closes the tuner. */
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
      const color = from.swatch ? colorNear(target.position) : null;
      if (color) {
        showColor(color, true);
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
      label: 'Adjust number or color',
      keybindings: [KeyMod.Alt | KeyCode.Enter],
      contextMenuGroupId: '1_modification',
      run: () => {
        const position = view.getPosition();
        if (!position) return;
        const number = numberNear(position);
        const color = colorNear(position);
        if (number && !(color && touchesStart(color, position))) showNumber(number, true);
        else if (color) showColor(color, true);
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

/** Whether the caret is at the constructor or bracket of a color and not at one of its numbers. */
function touchesStart({ range, form }: ColorLiteral, { lineNumber, column }: IPosition): boolean {
  return lineNumber === range.start.line && column <= range.start.column + (form === 'call' ? 4 : 0);
}
