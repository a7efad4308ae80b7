import { type MouseEvent, memo, useId, useRef, useState } from 'react';
import type { Binding, PortAddress } from '../../export/graph/project.ts';
import { type ParamDefinition, type ParamValue, paramWireType } from '../../nodes/kit/definition.ts';
import { PortMark } from '../canvas/port-mark.tsx';
import { useUndoGroup } from '../state/document/use-undo-group.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { bindExpression } from '../state/params/bind-params.ts';
import { editParam, resetParam } from '../state/params/edit-params.ts';
import { isAnimatable } from '../state/params/keyframes.ts';
import { showParamCandidate } from '../state/params/param-candidates.ts';
import { shownUnit } from '../state/params/units.ts';
import { boundValue } from '../state/params/value-text.ts';
import { IconButton } from '../ui/button.tsx';
import { AnimationPicker } from './animation-picker.tsx';
import { ExpressionField } from './expression-field.tsx';
import { KeyButton, TrackField } from './key-button.tsx';
import { ParamControl, rowClass } from './param-control.tsx';
import { ParamMenu } from './param-menu.tsx';
import { SourceLink } from './source-link.tsx';

interface ParamRowProps {
  readonly node: string;
  readonly name: string;
  readonly param: ParamDefinition;
  readonly binding: Binding | undefined;
  /** Output that is connected to the param. */
  readonly source: PortAddress | undefined;
}

/** One param: its label, the control for its binding, and its actions. */
export const ParamRow = memo(function ParamRow({ node, name, param, binding, source }: ParamRowProps) {
  const editor = useEditor();
  const id = useId();
  const row = useRef<HTMLFieldSetElement>(null);
  const [menuAt, setMenuAt] = useState<Point | null>(null);
  const type = paramWireType(param);
  // Fields of a vector are too narrow for a unit, so the label shows it.
  const isVector = param.type.startsWith('vector');
  const unit = isVector && 'unit' in param ? shownUnit(param.unit).suffix : '';
  const changed = source !== undefined || (binding !== undefined && !isDefaultPort(param, binding));
  const openMenu = (event: MouseEvent) => {
    // A focused text field keeps the context menu of the browser.
    if (event.target instanceof HTMLInputElement && event.target === document.activeElement) return;
    event.preventDefault();
    setMenuAt({ x: event.clientX, y: event.clientY });
  };
  const closeMenu = () => {
    setMenuAt(null);
    row.current?.querySelector<HTMLElement>('.param-actions button:last-of-type')?.focus();
  };
  const focusExpression = () => {
    const from = document.activeElement;
    editor.clock.nextFrame(() => {
      // Does not steal the focus if it has moved in between.
      const stayed = document.activeElement === from || document.activeElement === document.body;
      if (stayed) row.current?.querySelector<HTMLInputElement>('.expression-field input')?.focus();
    });
  };
  return (
    <fieldset
      ref={row}
      className={rowClass(param)}
      aria-label={param.label}
      data-param={name}
      data-changed={changed ? '' : undefined}
      onContextMenu={openMenu}
    >
      <label
        htmlFor={id}
        className="param-label"
        data-tip={changed ? `${param.doc}\nDouble-click to reset.` : param.doc}
        onDoubleClick={() => {
          if (changed) void resetParam(editor, node, name);
        }}
      >
        {type && <PortMark type={type} />}
        <span>
          {param.label}
          {unit !== '' && <span className="param-unit"> {unit}</span>}
        </span>
      </label>
      <div className="param-control">
        {source ? (
          <SourceLink from={source} to={{ node, port: name }} />
        ) : binding && 'expression' in binding ? (
          <ExpressionField id={id} node={node} name={name} param={param} expression={binding.expression} />
        ) : binding && 'track' in binding ? (
          <TrackField id={id} node={node} name={name} param={param} track={binding.track} />
        ) : (
          <ValueControl {...{ id, node, name, param, binding }} />
        )}
      </div>
      <span className="param-actions">
        {isAnimatable(param) && !source && !(binding && 'expression' in binding) && (
          <KeyButton node={node} name={name} label={param.label} track={binding && 'track' in binding ? binding.track : null} />
        )}
        {changed && <IconButton icon="reset" label={`Reset ${param.label}`} small onPress={() => void resetParam(editor, node, name)} />}
        <IconButton icon="more" label={`More actions for ${param.label}`} small onPress={() => setMenuAt(below(row.current))} />
      </span>
      {menuAt && (
        <ParamMenu
          node={node}
          name={name}
          param={param}
          binding={binding}
          wired={source !== undefined}
          at={menuAt}
          onClose={closeMenu}
          onFollow={focusExpression}
        />
      )}
    </fieldset>
  );
});

interface ValueControlProps extends Pick<ParamRowProps, 'node' | 'name' | 'param' | 'binding'> {
  /** Element id, which the `for` of the label refers to. */
  readonly id: string;
}

/** The control of a param that has a value. */
function ValueControl({ id, node, name, param, binding }: ValueControlProps) {
  const editor = useEditor();
  const gesture = useUndoGroup((value) => void editParam(editor, node, name, value));
  const value = boundValue(param, binding);
  const onPoint = (choice: ParamValue | null) => showParamCandidate(editor, [node], name, choice);
  const control = (
    <ParamControl {...{ id, param, value, onPoint }} {...gesture} onExpression={(text) => bindExpression(editor, node, name, text)} />
  );
  if (param.type !== 'text' || param.animation === undefined) return control;
  return (
    <AnimationPicker
      {...{ id, node, onPoint }}
      label={param.label}
      modelParam={param.animation.of}
      value={String(value)}
      onChoose={(animation) => {
        gesture.onEdit(animation);
        gesture.onEnd();
      }}
    >
      {control}
    </AnimationPicker>
  );
}

interface Point {
  readonly x: number;
  readonly y: number;
}

function below(row: HTMLElement | null): Point {
  const box = row?.getBoundingClientRect();
  return { x: box?.right ?? 0, y: box?.bottom ?? 0 };
}

/** An unconnected port with the default value counts as unchanged. */
function isDefaultPort(param: ParamDefinition, binding: Binding): boolean {
  return 'port' in binding && JSON.stringify(binding.port) === JSON.stringify(param.default);
}
