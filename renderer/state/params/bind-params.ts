import { parseBinding } from '../../../export/graph/expression/param-expression.ts';
import { bindingMisfit } from '../../../export/graph/library/binding-misfit.ts';
import { outOfRange } from '../../../export/graph/library/param-value.ts';
import type { Binding } from '../../../export/graph/project.ts';
import type { ParamDefinition, ParamValue } from '../../../nodes/kit/definition.ts';
import type { Editor } from '../editor/editor.ts';
import { addToast } from '../editor/ui.ts';
import { bind, findParam } from './bound-param.ts';
import { boundValue } from './value-text.ts';

/** Binds a param to an expression. If the expression is invalid, shows why and returns false. */
export function bindExpression(editor: Editor, node: string, param: string, expression: string): boolean {
  const found = findParam(editor, node, param);
  if (!found) return false;
  const { definition } = found;
  const read = parseBinding(definition, expression);
  if (read.ok) return bind(editor, `Bind ${definition.label}`, node, param, { expression });
  addToast(editor.ui, { tone: 'error', text: `The expression of “${definition.label}” is invalid: ${read.message}.`, detail: expression });
  return false;
}

/** Binds a param to an expression with its current value. */
export function startExpression(editor: Editor, node: string, param: string): boolean {
  const found = findParam(editor, node, param);
  return found !== null && bindExpression(editor, node, param, expressionOf(boundValue(found.definition, found.binding)));
}

/** Replaces an expression or track by the default value. */
export function unbind(editor: Editor, node: string, param: string): boolean {
  const found = findParam(editor, node, param);
  return found !== null && bind(editor, `Unbind ${found.definition.label}`, node, param, { value: found.definition.default });
}

/** Clipboard text of a param: JSON, or `=` and an expression. */
export function paramText(param: ParamDefinition, binding: Binding | undefined): string {
  if (binding !== undefined && 'expression' in binding) return `=${binding.expression}`;
  if (binding !== undefined && 'track' in binding) return JSON.stringify({ track: binding.track });
  return JSON.stringify(boundValue(param, binding));
}

export async function copyParam(editor: Editor, node: string, param: string): Promise<void> {
  const found = findParam(editor, node, param);
  if (found) await editor.clipboard.write(paramText(found.definition, found.binding));
}

/** Pastes the text of `copyParam`, or a number. */
export async function pasteParam(editor: Editor, node: string, param: string): Promise<boolean> {
  const text = await editor.clipboard.read().catch(() => '');
  const found = findParam(editor, node, param);
  if (!found) return false;
  const { definition } = found;
  const binding = bindingOfText(text.trim());
  const readable = binding !== null && (!('expression' in binding) || parseBinding(definition, binding.expression).ok);
  if (readable && bindingMisfit(definition, binding) === null && !isOutOfRange(definition, binding)) {
    return bind(editor, `Paste ${definition.label}`, node, param, atPort(binding, found.binding));
  }
  addToast(editor.ui, { tone: 'info', text: `The value on the clipboard does not fit “${definition.label}”.` });
  return false;
}

function bindingOfText(text: string): Binding | null {
  if (text.startsWith('=')) return { expression: text.slice(1).trim() };
  try {
    const value = JSON.parse(text) as ParamValue | Extract<Binding, { track: unknown }>;
    if (typeof value === 'object' && value !== null && 'track' in value) return Array.isArray(value.track?.keys) ? value : null;
    return { value };
  } catch {
    return null;
  }
}

function isOutOfRange(definition: ParamDefinition, binding: Binding): boolean {
  return 'value' in binding && outOfRange(definition, binding.value) !== null;
}

/** A value pasted to a param that is shown as a port keeps the port. */
function atPort(next: Binding, before: Binding | undefined): Binding {
  return 'value' in next && before !== undefined && 'port' in before ? { port: next.value } : next;
}

function expressionOf(value: ParamValue): string {
  if (typeof value === 'boolean') return value ? '1' : '0';
  return typeof value === 'object' ? `[${value.join(', ')}]` : String(value);
}
