import { readFile } from 'node:fs/promises';
import { resolve } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { dropMethods } from './drop-methods.ts';
import { dropBranches } from './glsl-conditionals.ts';
import { changeTemplates, stripGlsl } from './glsl-templates.ts';
import { THREE_PARTS, UNUSED_METHODS, undefinedMacros } from './three-parts.ts';

const THREE = resolve(import.meta.dirname, '../../../node_modules/three/src');

/** Branches of `glsl` without the macros A and B. */
const drop = (...lines: string[]): string[] => dropBranches(lines.join('\n'), new Set(['A', 'B'])).split('\n');

describe('branches of shaders', () => {
  test('text that only an undefined macro needs is dropped, with what is nested in it', () => {
    expect(drop('1', '#ifdef A', '#if X', '2', '#endif', '#endif', '3')).toEqual(['1', '3']);
    expect(drop('#ifdef A', '1', '#else', '2', '#endif')).toEqual(['2']);
    expect(drop('#ifndef A', '1', '#else', '2', '#endif')).toEqual(['1']);
  });

  test('conditions are read as a preprocessor reads them', () => {
    const isDropped = (condition: string): boolean => !drop(`#if ${condition}`, 'text', '#endif').includes('text');
    const isPlain = (condition: string): boolean => drop(`#if ${condition}`, 'text', '#endif').join() === 'text';
    expect(isDropped('defined( A ) && defined( X )')).toBe(true);
    expect(isDropped('defined(X) && ( defined(A) || defined B )')).toBe(true);
    expect(isDropped('A > 0')).toBe(true);
    expect(isDropped('defined( A ) || X > 0')).toBe(false);
    expect(isDropped('( A - X ) > 0')).toBe(false);
    expect(isDropped('A == 0')).toBe(false);
    expect(isPlain('! defined( A )')).toBe(true);
    expect(isPlain('! defined( X )')).toBe(false);
    expect(isPlain('! defined( A ) || defined( X )')).toBe(true);
  });

  test('of several branches, the possible ones stay a valid group', () => {
    expect(drop('#if defined(A)', '1', '#elif defined(X)', '2', '#else', '3', '#endif')).toEqual([
      '#if defined(X)',
      '2',
      '#else',
      '3',
      '#endif',
    ]);
    expect(drop('#if defined(X)', '1', '#elif defined(A)', '2', '#elif ! defined(A)', '3', '#else', '4', '#endif')).toEqual([
      '#if defined(X)',
      '1',
      '#else',
      '3',
      '#endif',
    ]);
  });

  test('unbalanced text is refused', () => {
    expect(() => drop('#ifdef A', '1')).toThrow('without #endif');
    expect(() => drop('1', '#endif')).toThrow('without #if');
  });
});

test('comments and indentation of marked templates are removed, and nothing else of a script', () => {
  const script = (glsl: string): string => `const a = \`// text\n  of a page\`;\nconst b = /* glsl */ \`${glsl}\`;`;
  const nested = `\${ c ? '}' : \`\${ d }\` }`;
  expect(changeTemplates(script(`\n  // Why /* not.\n  float x = ${nested};  /* how */\n\n  y( x ); // \${ e }\n`), stripGlsl)).toBe(
    script(`\nfloat x = ${nested};\ny( x ); // \${ e }\n`),
  );
});

test('methods are dropped by name, whatever their braces are in', () => {
  const script = (method: string): string => `class A {\n${method}\n\tcopy() {\n\t\treturn this.toJSON();\n\t}\n}\n`;
  const method = `\ttoJSON( x ) {\n\t\treturn \`\${ { x } }\` + "}"; // }\n\t}`;
  expect(dropMethods(script(method), ['toJSON'])).toBe(script(''));
});

describe('three.js', () => {
  test.each(THREE_PARTS)('what stands for $file exports the same names', async ({ file, otherwise }) => {
    const names = (text: string): string[] =>
      [...text.matchAll(/^export (?:(default)|(?:const|class) ([^;{]*)|\{([^}]*)\})/gm)]
        .flatMap(([, isDefault, declared, listed]) => isDefault ?? (declared?.match(/\w+(?= =)|^\w+/g) || listed?.split(',')) ?? [])
        .map((name) => name.trim())
        .sort();
    const expected = names(await readFile(resolve(THREE, file), 'utf8'));
    expect(expected.length).toBeGreaterThan(0);
    expect(names(otherwise)).toEqual(expected);
  });

  test('has every macro that pages do without', async () => {
    const { listFiles } = await import('../../../tools/lib/files.ts');
    const files = (await listFiles(resolve(THREE, 'renderers/shaders'))).filter((file) => file.endsWith('.js'));
    const text = (await Promise.all(files.map((file) => readFile(resolve(THREE, 'renderers/shaders', file), 'utf8')))).join();
    const all = undefinedMacros({ models: { extensions: new Set(), points: false, open: false }, nodeTypes: [] });
    expect([...all].filter((macro) => !new RegExp(`\\b${macro}\\b`).test(text))).toEqual([]);
  });

  test('has the methods that pages do without', async () => {
    for (const [file, methods] of [
      ['materials/Material.js', ['toJSON', 'fromJSON']],
      ['objects/Mesh.js', ['raycast']],
    ] as const) {
      const text = await readFile(resolve(THREE, file), 'utf8');
      for (const method of methods) expect([method, dropMethods(text, [method]).length < text.length - 500]).toEqual([method, true]);
      expect(methods.filter((method) => !UNUSED_METHODS.includes(method))).toEqual([]);
    }
  });

  test('a macro stays for models with its extension', () => {
    const macros = (...extensions: string[]) =>
      undefinedMacros({ models: { extensions: new Set(extensions), points: false, open: false }, nodeTypes: [] });
    expect(macros().has('USE_CLEARCOAT')).toBe(true);
    expect(macros('KHR_materials_clearcoat').has('USE_CLEARCOAT')).toBe(false);
    expect(macros('KHR_materials_clearcoat').has('USE_SHEEN')).toBe(true);
    expect(macros('KHR_materials_clearcoat').has('PHYSICAL')).toBe(false);
    expect(macros('KHR_materials_unlit').has('PHYSICAL')).toBe(true);
    expect(macros('KHR_materials_volume').has('USE_TRANSMISSION')).toBe(false);
  });
});
