/** Turns a path pattern of the table (`*`, `**`, `{a,b}`) into a test of repository paths. */
export function pathMatcher(patterns: readonly string[]): (path: string) => boolean {
  const expressions = patterns.map((pattern) => new RegExp(`^${translate(pattern)}$`));
  return (path) => expressions.some((expression) => expression.test(path));
}

const TOKENS = /\*\*\/|\*\*|\*|\{|\}|,|[^*{},]+/g;

function translate(pattern: string): string {
  return pattern.replace(TOKENS, (token) => TRANSLATIONS[token] ?? token.replace(/[.+?^$()|[\]\\]/g, '\\$&'));
}

const TRANSLATIONS: Readonly<Record<string, string>> = {
  '**/': '(?:.*/)?',
  '**': '.*',
  '*': '[^/]*',
  '{': '(?:',
  '}': ')',
  ',': '|',
};
