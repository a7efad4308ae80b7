import { readTemplate } from './scan-script.ts';

const MARK = '/* glsl */';

/**
 * Changes the GLSL in the template literals of a script that the comment `glsl` marks. `change` receives each text between substitutions,
 * as it is written in the script.
 */
export function changeTemplates(script: string, change: (glsl: string) => string): string {
  let result = '';
  let at = 0;
  for (;;) {
    const mark = script.indexOf(MARK, at);
    if (mark < 0) return result + script.slice(at);
    let open = mark + MARK.length;
    while (/\s/.test(script[open] ?? '')) open++;
    result += script.slice(at, open);
    at = open;
    if (script[open] !== '`') continue;
    const { pieces, end } = readTemplate(script, open);
    result += pieces.map(({ text, isText }) => (isText ? change(text) : changeTemplates(text, change))).join('');
    at = end;
  }
}

/**
 * Removes comments, indentation and empty lines from GLSL. Spaces within lines stay, because patches of three.js' shaders look for texts
 * of a line. A comment that contains a substitution stays too.
 */
export function stripGlsl(glsl: string): string {
  const code = glsl.replace(/\/\/[^\n]*(?=\n)|\/\*[\s\S]*?\*\//g, (comment) => (comment.startsWith('/*') ? ' ' : ''));
  return code.replace(/[ \t]*\n\s*/g, '\n');
}
