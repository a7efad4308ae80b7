import { lex } from '../syntax/lexer.ts';
import { GlslError, type Place, type Token } from '../syntax/token.ts';

/**
 * Reads the initial value of a uniform from the comment on its line, as in `uniform float a; // = 0.5`. `vec3(1.0)` means three equal
 * numbers. Returns null if there is none.
 */
export function readDefault(source: string, { line, column }: Place, size: number): readonly number[] | null {
  const rest = (source.split(/\r\n|\r|\n/)[line - 1] ?? '').slice(column - 1);
  const comment = /\/[/*]\s*=\s*([^;*]+)/.exec(rest)?.[1];
  if (comment === undefined) return null;
  const numbers = readNumbers(comment);
  if (numbers === null) return null;
  const [first] = numbers;
  if (numbers.length === 1 && first !== undefined) return new Array<number>(size).fill(first);
  return numbers.length >= Math.min(size, 3) ? numbers.slice(0, size) : null;
}

/** Parses `0.5`, `-1`, `true` or `vec2(1.0, -0.5)`; further text is ignored. */
function readNumbers(text: string): number[] | null {
  const tokens = tokensOf(text);
  const numbers: number[] = [];
  let depth = 0;
  let sign = 1;
  for (const { kind, text: word } of tokens) {
    if (word === '(') depth += 1;
    else if (word === ')') depth -= 1;
    else if (word === '-') sign = -sign;
    else if (kind === 'int' || kind === 'float') {
      numbers.push(sign * Number(word.replace(/[fF]$/, '')));
      sign = 1;
    } else if (word === 'true' || word === 'false') numbers.push(word === 'true' ? 1 : 0);
    else if (word !== ',' && word !== '+' && !(kind === 'word' && depth === 0 && numbers.length === 0)) break;
    if (depth === 0 && numbers.length > 0) break;
  }
  return numbers.length > 0 && numbers.every(Number.isFinite) ? numbers : null;
}

function tokensOf(text: string): readonly Token[] {
  try {
    return lex(text);
  } catch (error) {
    if (error instanceof GlslError) return [];
    throw error;
  }
}
