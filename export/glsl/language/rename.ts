import { isBuiltinFunction } from '../check/builtin-functions.ts';
import type { Place } from '../syntax/token.ts';
import { usesOf } from './look-up.ts';
import { type DocumentOptions, findName, headerUsesOf, isFromHeader, readShaderDocument, type ShaderDocument } from './shader-document.ts';
import { isFreeWord, type Outline, type ShaderName } from './shader-name.ts';
import { applyEdits, rangeOf, type TextEdit, type TextRange } from './source-text.ts';
import { ISF_FUNCTIONS } from './vocabulary.ts';

export type RenameStart =
  | { readonly ok: true; readonly range: TextRange; readonly name: ShaderName; readonly isInput: boolean }
  | { readonly ok: false; readonly reason: string };

export type Rename = { readonly ok: true; readonly edits: readonly TextEdit[] } | { readonly ok: false; readonly reason: string };

/** Whether the name at a position can be renamed. */
export function renameStart(document: ShaderDocument, place: Place): RenameStart {
  const found = findName(document, place);
  if (found === null) return { ok: false, reason: 'Only what this file or its header declares can be renamed.' };
  const { name, range } = found;
  if (name.file?.endsWith('.fs'))
    return { ok: false, reason: `“${name.name}” is declared in the header of ${name.file}. Rename it there.` };
  if (name.file !== null) return { ok: false, reason: `“${name.name}” is declared in ${name.file}, which other techniques use as well.` };
  if (name.declarations.length === 0) return { ok: false, reason: `“${name.name}” is predefined and cannot be renamed.` };
  if (name.kind === 'member') return { ok: false, reason: `“${name.name}” is a member of a struct. Rename it by hand.` };
  if (['main', 'vertex', 'surface'].includes(name.name) && name.kind === 'function')
    return { ok: false, reason: `“${name.name}” is called by the host, so its name is fixed.` };
  return { ok: true, range, name, isInput: isFromHeader(name) };
}

/**
 * The edits that rename the name at a position, also in the header. Refused if the meaning of the text would change: the new name is in
 * use, hides another, or is hidden.
 */
export function renameAt(document: ShaderDocument, place: Place, to: string, options: DocumentOptions): Rename {
  const start = renameStart(document, place);
  if (!start.ok) return start;
  const { name } = start;
  if (to === name.name) return { ok: true, edits: [] };
  if (!isFreeWord(to)) return { ok: false, reason: `“${to}” is not a valid name. Use letters, digits and “_”, and no GLSL keyword.` };
  if (isBuiltinFunction(to) || ISF_FUNCTIONS.has(to)) return { ok: false, reason: `“${to}” is already a function of GLSL or ISF.` };
  if (name.scope === null && document.names.some((other) => other.name === to && other.scope === null)) {
    return { ok: false, reason: `“${to}” is already declared.` };
  }
  const ranges = [...headerUsesOf(document, name).map(({ range }) => range), ...usesOf(document, name).map(rangeOf)];
  const edits = ranges.map((range) => ({ ...range, text: to }));
  const { before: _, ...texts } = options;
  const after = readShaderDocument(applyEdits(document.source, edits), document.file, texts);
  return meansTheSame(document.outline, after.outline)
    ? { ok: true, edits }
    : { ok: false, reason: `“${to}” conflicts with another name where “${name.name}” is used.` };
}

/**
 * The edits of the same renaming in the related file: a vertex shader and its fragment shader share varyings and inputs. Empty for other
 * names. `options` are those of `beside`.
 */
export function renameBeside(document: ShaderDocument, place: Place, to: string, beside: ShaderDocument, options: DocumentOptions): Rename {
  const name = findName(document, place)?.name;
  if (name === undefined || !(isFromHeader(name) || isVarying(document, name))) return { ok: true, edits: [] };
  const same = beside.names.find((other) => other.name === name.name && (other.file === document.file || isVarying(beside, other)));
  const ranges = same === undefined ? [] : usesOf(beside, same).map(rangeOf);
  if (beside.names.some((other) => other.name === to && other.scope === null))
    return { ok: false, reason: `“${to}” is already declared in ${beside.file}.` };
  const edits = ranges.map((range) => ({ ...range, text: to }));
  const header = isFromHeader(name)
    ? { fragment: { file: document.file, source: renamedSource(document, place, to, { chunkOf: options.chunkOf }) } }
    : {};
  const after = readShaderDocument(applyEdits(beside.source, edits), beside.file, { ...options, ...header });
  return meansTheSame(beside.outline, after.outline)
    ? { ok: true, edits }
    : { ok: false, reason: `“${to}” conflicts with another name in ${beside.file}.` };
}

function renamedSource(document: ShaderDocument, place: Place, to: string, options: DocumentOptions): string {
  const rename = renameAt(document, place, to, options);
  return rename.ok ? applyEdits(document.source, rename.edits) : document.source;
}

/** Whether a name is a varying: declared as in `varying vec2 left;`, or with `out` in one file and `in` in the other. */
function isVarying({ outline }: ShaderDocument, { kind, scope, declarations, file }: ShaderName): boolean {
  if (kind !== 'variable' || scope !== null || file !== null) return false;
  return declarations.some((token) => {
    for (let at = outline.tokens.indexOf(token) - 1; at >= 0; at -= 1) {
      const text = outline.tokens[at]?.text ?? ';';
      if (['varying', 'in', 'out'].includes(text)) return true;
      if ([';', '}', ')'].includes(text)) return false;
    }
    return false;
  });
}

/**
 * Whether a renaming keeps the meaning of a text: tokens that referred to the same name before must do so after, and tokens of different
 * names must stay different.
 */
function meansTheSame(before: Outline, after: Outline): boolean {
  if (before.tokens.length !== after.tokens.length) return false;
  const groups = new Map<unknown, unknown>();
  const taken = new Set<unknown>();
  return before.tokens.every((token, i) => {
    const other = after.tokens[i];
    const was = before.nameAt(token);
    const is = other ? after.nameAt(other) : null;
    if (was === null || is === null) return was === is;
    if (!groups.has(was)) {
      if (taken.has(is)) return false;
      groups.set(was, is);
      taken.add(is);
    }
    return groups.get(was) === is;
  });
}
