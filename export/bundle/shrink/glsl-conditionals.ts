/** True or false; null where it is known only when the shader is compiled. */
type Known = boolean | null;

/** A line of text that no directive governs, or a group from `#if` to `#endif`. */
type Part = string | readonly Branch[];

interface Branch {
  /** The line of the directive. */
  readonly line: string;
  readonly known: Known;
  readonly parts: readonly Part[];
}

const DIRECTIVE = /^\s*#\s*(ifdef|ifndef|if|elif|else|endif)\b(.*)$/;

/**
 * Returns GLSL without the text that is compiled only if one of these macros is defined, or greater than 0. Conditions that other macros
 * decide stay as they are. Throws if `#if` and `#endif` do not match.
 */
export function dropBranches(text: string, undefinedMacros: ReadonlySet<string>): string {
  const lines = text.split('\n');
  let at = 0;

  function parts(isNested: boolean): Part[] {
    const found: Part[] = [];
    for (; at < lines.length; at++) {
      const line = lines[at] ?? '';
      const word = DIRECTIVE.exec(line)?.[1];
      if (word === undefined) found.push(line);
      else if (word.startsWith('if')) found.push(group());
      else if (isNested) return found;
      else throw new Error(`GLSL has ${line.trim()} without #if.`);
    }
    if (isNested) throw new Error('GLSL has #if without #endif.');
    return found;
  }

  function group(): Branch[] {
    const branches: Branch[] = [];
    for (;;) {
      const line = lines[at++] ?? '';
      const [, word = '', condition = ''] = DIRECTIVE.exec(line) ?? [];
      if (word === 'endif') {
        at--;
        return branches;
      }
      branches.push({ line, known: knownValue(word, condition, undefinedMacros), parts: parts(true) });
    }
  }

  return print(parts(false)).join('\n');
}

function knownValue(word: string, condition: string, never: ReadonlySet<string>): Known {
  if (word === 'else') return true;
  if (word === 'ifdef') return never.has(condition.trim()) ? false : null;
  if (word === 'ifndef') return never.has(condition.trim()) ? true : null;
  return readCondition(condition, never);
}

function print(parts: readonly Part[]): string[] {
  return parts.flatMap((part) => (typeof part === 'string' ? [part] : printGroup(part)));
}

function printGroup(branches: readonly Branch[]): string[] {
  const possible = branches.filter(({ known }) => known !== false);
  const certain = possible.findIndex(({ known }) => known === true);
  const kept = certain < 0 ? possible : possible.slice(0, certain + 1);
  const [first, ...others] = kept;
  if (!first) return [];
  if (first.known === true) return print(first.parts);
  const start = first.line.replace('elif', 'if');
  const rest = others.flatMap(({ line, known, parts }) => [known === true ? '#else' : line, ...print(parts)]);
  return [start, ...print(first.parts), ...rest, '#endif'];
}

/** Value of the condition of `#if`, as far as `never` decides it. */
function readCondition(condition: string, never: ReadonlySet<string>): Known {
  const tokens = condition.match(/\w+|&&|\|\||[()!]|[^\s\w()!&|]+/g) ?? [];
  let at = 0;

  function or(): Known {
    let value = and();
    while (tokens[at] === '||') {
      at++;
      const right = and();
      value = value === true || right === true ? true : value === false && right === false ? false : null;
    }
    return value;
  }

  function and(): Known {
    let value = operand();
    while (tokens[at] === '&&') {
      at++;
      const right = operand();
      value = value === false || right === false ? false : value === true && right === true ? true : null;
    }
    return value;
  }

  function operand(): Known {
    if (tokens[at] === '!') {
      at++;
      const value = operand();
      return value === null ? null : !value;
    }
    const start = at;
    let value: Known = null;
    if (tokens[at] === 'defined') {
      const hasParentheses = tokens[at + 1] === '(';
      if (never.has(tokens[at + (hasParentheses ? 2 : 1)] ?? '')) value = false;
      at += hasParentheses ? 4 : 2;
    } else if (tokens[at] === '(') {
      at++;
      value = or();
      at++;
    }
    const compared = at;
    while (at < tokens.length && !['&&', '||', ')'].includes(tokens[at] ?? '')) {
      if (tokens[at] === '(') skipParentheses();
      else at++;
    }
    if (at === compared) return value;
    const [name = '', ...rest] = tokens.slice(start, at);
    return never.has(name) && rest.join(' ') === '> 0' ? false : null;
  }

  function skipParentheses(): void {
    let depth = 0;
    do {
      if (tokens[at] === '(') depth++;
      if (tokens[at] === ')') depth--;
      at++;
    } while (depth > 0 && at < tokens.length);
  }

  return or();
}
