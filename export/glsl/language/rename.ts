import { isBuiltinFunction } from '../check/builtin-functions.ts';
import type { Place } from '../syntax/token.ts';
import { usesOf } from './look-up.ts';
import { isFreeWord, type Outline, type ShaderName } from './names.ts';
import { type DocumentOptions, findName, headerUsesOf, isFromHeader, readShaderDocument, type ShaderDocument } from './shader-document.ts';
import { applyEdits, rangeOf, type TextEdit, type TextRange } from './source-text.ts';
import { ISF_FUNCTIONS } from './vocabulary.ts';

export type RenameStart =
  | { readonly ok: true; readonly range: TextRange; readonly name: ShaderName; readonly isInput: boolean }
  | { readonly ok: false; readonly reason: string };

export type Rename = { readonly ok: true; readonly edits: readonly TextEdit[] } | { readonly ok: false; readonly reason: string };

/** Whether what stands at a place can have another name. */
export function renameStart(document: ShaderDocument, place: Place): RenameStart {
  const found = findName(document, place);
  if (found === null) return { ok: false, reason: 'Only what this file or its header declares can be renamed.' };
  const { name, range } = found;
  if (name.file !== null) return { ok: false, reason: `“${name.name}” is declared in ${name.file}, which other techniques use as well.` };
  if (name.declarations.length === 0) return { ok: false, reason: `“${name.name}” belongs to the host: its name is fixed.` };
  if (name.kind === 'member') return { ok: false, reason: `“${name.name}” is a member of a struct: rename it by hand.` };
  if (['main', 'vertex', 'surface'].includes(name.name) && name.kind === 'function')
    return { ok: false, reason: `“${name.name}” is what the host calls: its name is fixed.` };
  return { ok: true, range, name, isInput: isFromHeader(name) };
}

/**
 * Every edit that gives the name at a place another one, in the header too. Refused where the text would mean something else
 * afterwards: the new name is taken, hides another, or is hidden.
 */
export function renameAt(document: ShaderDocument, place: Place, to: string, options: DocumentOptions): Rename {
  const start = renameStart(document, place);
  if (!start.ok) return start;
  const { name } = start;
  if (to === name.name) return { ok: true, edits: [] };
  if (!isFreeWord(to))
    return { ok: false, reason: `“${to}” cannot be a name: it is a word of GLSL itself, or holds more than letters, digits and “_”.` };
  if (isBuiltinFunction(to) || ISF_FUNCTIONS.has(to)) return { ok: false, reason: `“${to}” is a function of GLSL or ISF already.` };
  if (name.scope === null && document.names.some((other) => other.name === to && other.scope === null)) {
    return { ok: false, reason: `There is something called “${to}” already.` };
  }
  const ranges = [...headerUsesOf(document, name).map(({ range }) => range), ...usesOf(document, name).map(rangeOf)];
  const edits = ranges.map((range) => ({ ...range, text: to }));
  const after = readShaderDocument(applyEdits(document.source, edits), document.file, { chunkOf: options.chunkOf });
  return meansTheSame(document.outline, after.outline)
    ? { ok: true, edits }
    : { ok: false, reason: `“${to}” is used where “${name.name}” is: the shader would mean something else.` };
}

/** A new name changes no token's place in the row, so every one has to belong together with the same ones as before. */
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
