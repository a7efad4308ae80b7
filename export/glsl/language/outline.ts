import type { Place, Token } from '../syntax/token.ts';
import { KEYWORDS, TYPES } from '../syntax/words.ts';
import { closingOf, openingOf } from './brackets.ts';
import { commentAbove } from './comment-above.ts';
import { adopted, behind, byPlace, type Draft, draftOf, type Frame, frameOf, scopeFrom } from './drafts.ts';
import type { NameKind, Outline, ShaderName } from './shader-name.ts';
import { lexLeniently } from './source-text.ts';

/** A declaration whose list of variables may continue after a comma. */
interface Declaration {
  readonly type: string;
  readonly depth: number;
}

/**
 * Resolves the names of a text by scope and order of declaration, without types. It works on incomplete text, in both branches of `#if` and
 * in macros, which the parser does not see. `given` are names from elsewhere: the header, the host, chunks.
 */
export function readOutline(source: string, given: readonly ShaderName[] = []): Outline {
  return createReader(source, lexLeniently(source), given).read();
}

function createReader(source: string, tokens: readonly Token[], given: readonly ShaderName[]) {
  const meanings = new Map<Token, Draft>();
  const names: Draft[] = [];
  const macros = new Map<string, Draft>();
  const includes: { name: string; token: Token }[] = [];
  const unresolved: Token[] = [];
  const branches: { readonly frame: Frame; readonly depth: number }[] = [];
  const file = frameOf('file', null);
  const lines = source.split(/\r\n|\r|\n/);
  for (const name of given) file.names.set(name.name, adopted(name));
  for (const name of given) if (name.kind === 'macro') macros.set(name.name, file.names.get(name.name) as Draft);
  /** The current scope. The outermost scope of the text is inside the scope of the given names, so names of the text hide given ones. */
  let frame: Frame = frameOf('file', file);
  const outermost = frame;
  let depth = 0;
  let declaration: Declaration | null = null;
  /** A name whose initializer is being read; the name is not visible before the initializer ends. */
  let pending: Draft | null = null;
  let lastStruct: Draft | null = null;
  let functionDepth = -1;
  const forDepths: number[] = [];
  const bodies = new Set<Frame>();

  function mark(token: Token, name: Draft): void {
    meanings.set(token, name);
    name.uses.push(token);
  }

  function find(name: string): Draft | null {
    for (let at: Frame | null = frame; at !== null; at = at.parent) {
      const found = at.names.get(name);
      if (found !== undefined) return found;
    }
    return null;
  }

  function declare(kind: NameKind, token: Token, type: string, into: Frame): Draft {
    const known = into.names.get(token.text);
    const same =
      known !== undefined && (known.kind === kind || (kind === 'variable' && known.kind === 'parameter' && into.kind !== 'file'));
    const name = same ? known : draftOf(kind, token, type, commentAbove(lines, token.line));
    if (!same) {
      into.names.set(token.text, name);
      into.owned.push(name);
      names.push(name);
    }
    name.declarations.push(token);
    mark(token, name);
    return name;
  }

  function push(kind: Frame['kind'], owner: Draft | null = null): void {
    frame = frameOf(kind, frame, owner);
  }

  function pop(at: Place): void {
    if (frame.parent === null || frame === outermost) return;
    for (const name of frame.owned) if (name.scope !== null) name.scope.to = at;
    frame = frame.parent;
  }

  /** Ends the loops whose only statement was this body, unless an `else` follows. */
  function endBodies(index: number): void {
    if (tokens[index + 1]?.text === 'else') return;
    const token = tokens[index];
    while (frame.kind === 'for' && frame.headClosed && token) pop(behind(token));
  }

  function settlePending(): void {
    if (pending === null) return;
    frame.names.set(pending.name, pending);
    pending = null;
  }

  function readDirective(start: number): number {
    let end = start + 1;
    while (tokens[end]?.startsLine === false) end += 1;
    const line = tokens.slice(start + 1, end).filter((token) => token.kind !== 'end');
    const [directive, name, open] = line;
    switch (directive?.text) {
      case 'define':
        if (name?.kind === 'word') readDefine(line, name, open);
        break;
      case 'ifdef':
      case 'ifndef':
      case 'undef':
        if (name !== undefined) nameMacro(name);
        break;
      case 'if':
      case 'elif':
        for (const token of line.slice(1)) if (token.kind === 'word' && token.text !== 'defined') nameMacro(token);
        break;
      case 'include': {
        const written = /[<"]([A-Za-z0-9/_-]+)[>"]/.exec(lines[directive.line - 1] ?? '')?.[1];
        if (written !== undefined) includes.push({ name: written, token: directive });
        break;
      }
    }
    if (directive && ['if', 'ifdef', 'ifndef'].includes(directive.text)) branches.push({ frame, depth });
    if (directive && ['else', 'elif'].includes(directive.text)) {
      const before = branches.at(-1);
      if (before) ({ frame, depth } = before);
    }
    if (directive?.text === 'endif') branches.pop();
    return end;
  }

  function readDefine(line: readonly Token[], name: Token, open: Token | undefined): void {
    const macro = macros.get(name.text) ?? draftOf('macro', name, '', commentAbove(lines, name.line));
    if (!macros.has(name.text)) {
      macros.set(name.text, macro);
      names.push(macro);
    }
    macro.declarations.push(name);
    mark(name, macro);
    const hasParameters = open?.text === '(' && !open.spaced;
    const close = hasParameters ? line.findIndex((token) => token.text === ')') : 1;
    const parameters = hasParameters ? line.slice(3, close).filter((token) => token.kind === 'word') : [];
    const body = line.slice(close + 1);
    const value = (lines[name.line - 1] ?? '').slice(name.column - 1).trim();
    macro.signatures.push({ label: value.replace(/\s+/g, ' '), returns: '', parameters: parameters.map(({ text }) => text) });
    push('macro');
    for (const parameter of parameters) declare('parameter', parameter, '', frame);
    body.forEach((token, i) => {
      if (token.kind !== 'word' || body[i - 1]?.text === '.' || KEYWORDS.has(token.text)) return;
      const own = frame.names.get(token.text) ?? macros.get(token.text);
      if (own) mark(token, own);
      // Names in a macro are resolved where it is used, at best for the whole text.
      else unresolved.push(token);
    });
    const own = frame.owned;
    pop(name);
    const to = { line: (line.at(-1) ?? name).line + 1, column: 1 };
    for (const parameter of own) parameter.scope = { from: name, to };
  }

  function nameMacro(token: Token): void {
    const macro = macros.get(token.text);
    if (macro) mark(token, macro);
  }

  /** The type before a name, or null: two consecutive words are always a declaration. */
  function typeBefore(index: number): { type: string; at: Token } | null {
    let suffix = '';
    let at = index - 1;
    if (tokens[at]?.text === ']') {
      const open = openingOf(tokens, at);
      suffix = tokens
        .slice(open, at + 1)
        .map(({ text }) => text)
        .join('');
      at = open - 1;
    }
    const before = tokens[at];
    if (before?.kind !== 'word') return null;
    if (TYPES.has(before.text)) return { type: before.text + suffix, at: before };
    if (KEYWORDS.has(before.text) || tokens[at - 1]?.text === '#') return null;
    // An incomplete statement on the line above is not a type.
    const isType = find(before.text)?.kind === 'struct' || before.line === tokens[index]?.line;
    return isType ? { type: before.text + suffix, at: before } : null;
  }

  function readWord(token: Token, index: number): void {
    const before = tokens[index - 1];
    const after = tokens[index + 1];
    if (before?.text === '.') return;
    const macro = macros.get(token.text);
    if (macro !== undefined) {
      mark(token, macro);
      return;
    }
    if (token.text === 'for' && after?.text === '(') {
      push('for');
      return;
    }
    if (KEYWORDS.has(token.text)) return;
    if (before?.text === 'struct') {
      readStructName(token);
      return;
    }
    const type = typeBefore(index);
    if (type !== null) {
      readDeclared(token, index, type.type);
      return;
    }
    if (before?.text === '}' && after !== undefined && ['=', ';', '[', ','].includes(after.text) && lastStruct !== null) {
      // `struct Ray { … } ray;`
      readDeclared(token, index, lastStruct.name);
      return;
    }
    if (before?.text === ',' && declaration !== null && declaration.depth === depth && after?.kind !== 'word') {
      settlePending();
      readDeclared(token, index, declaration.type);
      return;
    }
    resolve(token, after);
  }

  function readStructName(token: Token): void {
    const struct = declare('struct', token, '', frame);
    if (frame !== outermost) struct.scope ??= scopeFrom(token);
    lastStruct = struct;
  }

  function readDeclared(token: Token, index: number, type: string): void {
    const after = tokens[index + 1];
    if (frame.kind === 'struct' && frame.owner !== null) {
      const member = draftOf('member', token, typeWithSize(type, index), commentAbove(lines, token.line));
      member.declarations.push(token);
      mark(token, member);
      frame.owner.members.set(token.text, member);
      declaration = { type, depth };
      return;
    }
    if (after?.text === '(' && frame === outermost) {
      readFunction(token, index, type);
      return;
    }
    if (frame.kind === 'function' && !frame.headClosed) {
      const parameter = declare('parameter', token, typeWithSize(type, index), frame);
      parameter.scope ??= scopeFrom(token);
      return;
    }
    declaration = { type, depth };
    const host = frame === outermost ? file.names.get(token.text) : undefined;
    if (host !== undefined && host.file === null && isHostVariable(index)) {
      mark(token, host);
      return;
    }
    const known = frame.names.get(token.text);
    const name = declare('variable', token, typeWithSize(type, index), frame);
    if (frame !== outermost) name.scope ??= scopeFrom(token);
    if (known === undefined && after?.text === '=') {
      // The initializer does not see the name.
      frame.names.delete(token.text);
      pending = name;
    }
  }

  /**
   * Whether the name at `index` is declared as in `uniform float amount;`, which is another declaration of a variable of the host, as some
   * hosts require.
   */
  function isHostVariable(index: number): boolean {
    for (let at = index - 1; at >= 0 && ![';', '}', ')'].includes(tokens[at]?.text ?? ';'); at -= 1) {
      if (['uniform', 'varying', 'in'].includes(tokens[at]?.text ?? '')) return true;
    }
    return false;
  }

  function readFunction(token: Token, index: number, returns: string): void {
    const close = closingOf(tokens, index + 1);
    const parameters = splitParameters(tokens.slice(index + 2, close));
    const name = declare('function', token, returns, frame);
    const label = `${returns} ${token.text}(${parameters.join(', ')})`;
    if (!name.signatures.some((signature) => signature.label === label)) name.signatures.push({ label, returns, parameters });
    push('function');
    functionDepth = depth;
  }

  /** Adds the array size behind a name to its type: `float weights[3]` has the type `float[3]`. */
  function typeWithSize(type: string, index: number): string {
    if (tokens[index + 1]?.text !== '[') return type;
    const close = closingOf(tokens, index + 1);
    return (
      type +
      tokens
        .slice(index + 1, close + 1)
        .map(({ text }) => text)
        .join('')
    );
  }

  function resolve(token: Token, after: Token | undefined): void {
    const found = find(token.text);
    if (found !== null && (after?.text !== '(' || found.kind === 'function' || found.kind === 'struct')) {
      mark(token, found);
      return;
    }
    const outer = outermost.names.get(token.text) ?? file.names.get(token.text) ?? null;
    if (after?.text === '(' && outer !== null && (outer.kind === 'function' || outer.kind === 'struct')) mark(token, outer);
    else unresolved.push(token);
  }

  function readBracket(token: Token, index: number): void {
    switch (token.text) {
      case '(':
        depth += 1;
        return;
      case ')':
        depth -= 1;
        settlePending();
        declaration = null;
        if (frame.kind === 'for' && !frame.headClosed && depth === forDepths.at(-1)) {
          frame.headClosed = true;
          forDepths.pop();
        }
        if (frame.kind === 'function' && !frame.headClosed && depth === functionDepth) frame.headClosed = true;
        return;
      case '{':
        if (frame.kind === 'function' && frame.headClosed && !bodies.has(frame)) bodies.add(frame);
        else if (isStructHead(tokens, index)) {
          if (lastStruct === null || tokens[index - 1]?.text === 'struct') lastStruct = draftOf('struct', token, '', '');
          push('struct', lastStruct);
        } else push('block');
        return;
      case '}':
        while (frame.kind === 'for' && frame.headClosed) pop(token);
        pop(token);
        declaration = null;
        endBodies(index);
        return;
    }
  }

  function read(): Outline {
    let index = 0;
    while (index < tokens.length) {
      const token = tokens[index] as Token;
      if (token.startsLine && token.text === '#') {
        index = readDirective(index);
        continue;
      }
      if (token.kind === 'word') {
        readWord(token, index);
        if (token.text === 'for' && frame.kind === 'for' && !frame.headClosed) forDepths.push(depth);
      } else if (['(', ')', '{', '}'].includes(token.text)) {
        readBracket(token, index);
      } else if (token.text === ';') {
        settlePending();
        declaration = null;
        // A prototype has no body.
        if (frame.kind === 'function' && frame.headClosed && !bodies.has(frame)) pop(token);
        if (frame.kind !== 'for' || frame.headClosed) endBodies(index);
      }
      index += 1;
    }
    const end = tokens.at(-1);
    while (end && frame !== outermost && frame.parent !== null) pop(behind(end));
    for (const token of unresolved) {
      const late = macros.get(token.text) ?? outermost.names.get(token.text) ?? file.names.get(token.text);
      if (late) mark(token, late);
    }
    for (const name of names) name.uses.sort(byPlace);
    for (const name of file.names.values()) name.uses.sort(byPlace);
    return { tokens, names, nameAt: (token) => meanings.get(token) ?? null, includes };
  }

  return { read };
}

/** Whether the brace at `index` opens a struct: `struct Ray {` or `struct {`. */
function isStructHead(tokens: readonly Token[], index: number): boolean {
  return tokens[index - 1]?.text === 'struct' || tokens[index - 2]?.text === 'struct';
}

function splitParameters(tokens: readonly Token[]): string[] {
  const parts: string[][] = [[]];
  for (const token of tokens) {
    if (token.text === ',') parts.push([]);
    else parts.at(-1)?.push(token.text);
  }
  const written = parts.map((part) =>
    part
      .join(' ')
      .replace(/ ?\[ ?/g, '[')
      .replace(/ \]/g, ']'),
  );
  return written.length === 1 && (written[0] === '' || written[0] === 'void') ? [] : written;
}
