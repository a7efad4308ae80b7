import { homedir } from 'node:os';
import { isAbsolute, join } from 'node:path';
import { refusal } from './file-errors.ts';

/**
 * Resolves a typed path; `~/` is the home folder. Rejects relative paths, because a window has no working folder.
 *
 * @throws HostError with this `code` if the path is relative
 */
export function fullPath(path: string, code: 'SCR004' | 'SCR060'): string {
  const typed = path.trim();
  const whole = typed === '~' || /^~[/\\]/.test(typed) ? join(homedir(), typed.slice(1)) : typed;
  if (isAbsolute(whole)) return whole;
  throw refusal(code, `${path} is not a full path.`, `Enter a full path, such as ${join(homedir(), path)}.`);
}
