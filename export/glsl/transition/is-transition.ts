import { lex } from '../syntax/lexer.ts';
import { GlslError } from '../syntax/token.ts';

/** Whether a `.glsl` file is a transition instead of a technique: it has a function `vec4 transition(…)`. */
export function isTransition(source: string, file: string): boolean {
  if (!file.endsWith('.glsl') || !source.includes('transition')) return false;
  try {
    const tokens = lex(source);
    return tokens.some(({ text }, i) => text === 'transition' && tokens[i - 1]?.text === 'vec4' && tokens[i + 1]?.text === '(');
  } catch (error) {
    if (error instanceof GlslError) return false;
    throw error;
  }
}
