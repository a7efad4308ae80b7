import { readdir, readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { transform } from 'esbuild';
import { EXPRESSION_PARAMS } from '../program-use.ts';
import { dropCases, dropMembers } from './drop-cases.ts';
import { TRIMS } from './trims.ts';

const ROOT = resolve(import.meta.dirname, '../../..');

const SWITCH = `function f(kind) {
  switch (kind) {
    case 'a':
    case 'b':
      return 1;
    case 'c': {
      if (kind === 'c') {
        return 2;
      }
      return 3;
    }
    case 'd':
      return \`text
case 'e':\`;
    default:
      return 4;
  }
}
`;

/** What the function of a text returns for each kind. */
const results = (text: string): unknown[] => {
  const f = new Function(`${text}return f;`)() as (kind: string) => unknown;
  return ['a', 'b', 'c', 'd', 'z'].map(f);
};

describe('cases of switches', () => {
  test.each(['a', 'b', 'c', 'd', 'ab', 'cd', 'abcd'])('of a text without %s the other cases do what they did', (dropped) => {
    const text = dropCases(SWITCH, (label) => dropped.includes(label));
    const whole = results(SWITCH);
    expect(results(text)).toEqual(whole.map((result, i) => (dropped.includes('abcd'.charAt(i) || ' ') ? 4 : result)));
    expect(text.length).toBeLessThan(SWITCH.length);
  });

  test('statements that another label leads to stay', () => {
    expect(dropCases(SWITCH, (label) => label === 'b')).toContain('return 1;');
    expect(dropCases(SWITCH, (label) => label === 'a' || label === 'b')).not.toContain('return 1;');
  });
});

test('members are removed from objects, whether they are methods, getters, properties or shorthands', () => {
  const text = `const object = {
  a: () => {
    return { a: 1 };
  },
  get b() {
    return 2;
  },
  c,
  'd-d': [
    1,
  ],
  e: 5,
};
`;
  const object = (names: readonly string[]): object =>
    new Function(`const c = 3;${dropMembers(text, names)}return object;`)() as Record<string, unknown>;
  expect(Object.keys(object(['none']))).toEqual(['a', 'b', 'c', 'd-d', 'e']);
  expect(Object.keys(object(['a', 'c', 'd-d']))).toEqual(['b', 'e']);
  expect(Object.keys(object(['b', 'e']))).toEqual(['a', 'c', 'd-d']);
});

describe.each(TRIMS)('what is cut out of $file', ({ file, cases, members = {} }) => {
  const source = readFile(join(ROOT, file), 'utf8');

  test('is in it', async () => {
    const text = await source;
    for (const label of cases?.labels ?? []) expect(dropCases(text, (one) => one === label)).not.toBe(text);
    for (const name of Object.keys(members)) expect(dropMembers(text, [name])).not.toBe(text);
  });

  test('leaves a valid script, which is shorter', async () => {
    const text = await source;
    const minified = async (script: string): Promise<string> => (await transform(script, { loader: 'ts', minify: true })).code;
    const names = Object.keys(members);
    const shorter = names.length > 0 ? dropMembers(text, names) : text;
    const trimmed = dropCases(shorter, (label) => cases?.labels.includes(label) ?? false);
    expect((await minified(trimmed)).length).toBeLessThan((await minified(text)).length);
  });
});

test('a page calls nothing that is cut out of every player', async () => {
  const { members = {} } = TRIMS.find(({ file }) => file.endsWith('/player.ts')) ?? {};
  const call = new RegExp(`player\\.(${Object.keys(members).join('|')})\\(`);
  for (const file of await readdir(join(ROOT, 'export/page'), { recursive: true })) {
    if (/(?<!test)\.ts$/.test(file)) expect(await readFile(join(ROOT, 'export/page', file), 'utf8')).not.toMatch(call);
  }
});

test('the params with expressions are known', async () => {
  const params = new Set<string>();
  for (const file of await readdir(join(ROOT, 'nodes'), { recursive: true })) {
    if (!file.endsWith('runtime.ts')) continue;
    const text = await readFile(join(ROOT, 'nodes', file), 'utf8');
    for (const [, param = ''] of text.matchAll(/playExpression\((?:\w+\.)*config\.(\w+)/g)) params.add(param);
    expect(text.split('playExpression(').length).toBe(text.split(/playExpression\((?:\w+\.)*config\.\w+/).length);
  }
  expect([...params].sort()).toEqual([...EXPRESSION_PARAMS].sort());
});
