import { homedir } from 'node:os';
import { isAbsolute, join } from 'node:path';
import { refusal } from './file-errors.ts';

/**
 * A path as a person typed it, whole: `~/` is their own folder. Relative ones are refused, because nobody in a window knows what
 * they would be relative to. Throws `code`.
 */
export function wholePath(path: string, code: 'SCR004' | 'SCR060'): string {
  const typed = path.trim();
  const whole = typed === '~' || /^~[/\\]/.test(typed) ? join(homedir(), typed.slice(1)) : typed;
  if (isAbsolute(whole)) return whole;
  throw refusal(code, `${path} is not a full path.`, `Enter a full path, such as ${join(homedir(), path)}.`);
}
