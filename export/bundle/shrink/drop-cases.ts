/**
 * Removes cases of `switch` statements from a script that Biome has formatted, with the statements of cases that no other label leads to.
 *
 * @param isDropped Whether no value of the page equals the text of a label. Labels that are no texts stay.
 *
 * @example
 * dropCases("switch (kind) {\n  case 'a':\n    return 1;\n  case 'b':\n    return 2;\n}", (label) => label === 'a');
 * // "switch (kind) {\n  case 'b':\n    return 2;\n}"
 */
export function dropCases(script: string, isDropped: (label: string) => boolean): string {
  const lines = script.split('\n');
  const kept: string[] = [];
  for (let at = 0; at < lines.length; ) {
    const [, indent = '', label = '', rest = ''] = /^( +)case '([^']+)':(.*)$/.exec(lines[at] ?? '') ?? [];
    if (label === '' || !isDropped(label)) {
      kept.push(lines[at++] ?? '');
      continue;
    }
    const isLabel = (line: string | undefined): boolean => line !== undefined && new RegExp(`^${indent}(case .*|default):`).test(line);
    at++;
    if (rest === '' && isLabel(lines[at])) continue;
    // Another label leads to these statements.
    if (isLabel(kept.at(-1)) && kept.at(-1)?.endsWith(':')) {
      if (rest !== '') kept.push(`${indent} ${rest}`);
      continue;
    }
    while (at < lines.length && !isLabel(lines[at]) && !isShallower(lines[at] ?? '', indent.length)) at++;
    // The end of a case with a block is as deep as its label.
    if (lines[at] === `${indent}}`) at++;
  }
  return kept.join('\n');
}

/** Removes members with these names, methods and properties, from the objects and types of a script that Biome has formatted. */
export function dropMembers(script: string, names: readonly string[]): string {
  const lines = script.split('\n');
  const kept: string[] = [];
  const member = new RegExp(`^( +)(?:get )?'?(?:${names.join('|')})'?[:(,]`);
  for (let at = 0; at < lines.length; ) {
    const indent = member.exec(lines[at] ?? '')?.[1];
    if (indent === undefined) {
      kept.push(lines[at++] ?? '');
      continue;
    }
    at++;
    while (at < lines.length && (lines[at] ?? '').startsWith(`${indent} `)) at++;
    // The line that closes what the member opened.
    if (new RegExp(`^${indent}[)}\\]]`).test(lines[at] ?? '')) at++;
  }
  return kept.join('\n');
}

/** Whether a line closes the block around lines of this indentation. Lines of shaders are not indented as code is, but never close one. */
function isShallower(line: string, indent: number): boolean {
  const found = /^ */.exec(line)?.[0].length ?? 0;
  return found < indent && /^ *[}\])]/.test(line);
}
