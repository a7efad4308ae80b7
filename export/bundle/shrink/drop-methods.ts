import { endOfBlock } from './scan-script.ts';

/** Removes methods from the classes of a script that is formatted as three.js is: methods begin after one tab. */
export function dropMethods(script: string, names: readonly string[]): string {
  let result = '';
  let at = 0;
  for (const { index } of script.matchAll(new RegExp(`^\\t(static )?(${names.join('|')})\\(.*\\{$`, 'gm'))) {
    if (index < at) continue;
    result += script.slice(at, index);
    at = endOfBlock(script, script.indexOf('{', index));
  }
  return result + script.slice(at);
}
