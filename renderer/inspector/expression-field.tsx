import { type KeyboardEvent, useState } from 'react';
import { parseBinding } from '../../export/graph/expression/param-expression.ts';
import type { ParamDefinition } from '../../nodes/kit/definition.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { bindExpression, unbind } from '../state/params/bind-params.ts';

interface ExpressionFieldProps {
  readonly id: string;
  readonly node: string;
  readonly name: string;
  readonly param: ParamDefinition;
  readonly expression: string;
}

/** Edits the expression of a param. Mistakes are shown while typing; Enter or a loss of focus applies the text. */
export function ExpressionField({ id, node, name, param, expression }: ExpressionFieldProps) {
  const editor = useEditor();
  const [typed, setTyped] = useState<string | null>(null);
  const read = typed === null || typed.trim() === '' ? null : parseBinding(param, typed);
  const mistake = read?.ok === false ? `${read.message}, at character ${read.column}.` : null;

  const finish = () => {
    if (typed === null || mistake !== null) return;
    setTyped(null);
    if (typed.trim() === '') unbind(editor, node, name);
    else if (typed.trim() !== expression) bindExpression(editor, node, name, typed.trim());
  };
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key === 'Enter') finish();
    else if (event.key === 'Escape' && typed !== null) {
      event.stopPropagation();
      setTyped(null);
    }
  };

  return (
    <span className="expression-field">
      <input
        id={id}
        className="field"
        autoComplete="off"
        spellCheck={false}
        aria-label={`${param.label}, expression`}
        aria-invalid={mistake !== null}
        aria-describedby={mistake === null ? undefined : `${id}-mistake`}
        data-clean={typed === null ? '' : undefined}
        value={typed ?? expression}
        onChange={(event) => setTyped(event.target.value)}
        onBlur={finish}
        onKeyDown={onKeyDown}
      />
      {mistake !== null && (
        <span id={`${id}-mistake`} className="expression-mistake" role="status">
          {mistake}
        </span>
      )}
    </span>
  );
}
