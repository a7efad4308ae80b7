import type { Diagnostic, Result } from '../../../nodes/kit/diagnostics.ts';
import type { IsfInput, IsfShader } from '../isf/isf-shader.ts';
import type { Declarator, VariableDeclaration } from '../syntax/ast.ts';
import { parseShader } from '../syntax/parse.ts';
import { GlslError } from '../syntax/token.ts';
import { readDefault } from './read-default.ts';

/** Ports and param of every transition, named by ISF's conventions. */
export const FROM_IMAGE = 'startImage';
export const TO_IMAGE = 'endImage';
const PROGRESS = 'progress';

/** Names that the host declares; files may declare them again. */
const GIVEN: ReadonlySet<string> = new Set([PROGRESS, 'ratio', 'from', 'to', '_fromR', '_toR']);

/** Type of the param for a uniform, by its GLSL type. */
const TYPES: Readonly<Record<string, IsfInput['type']>> = {
  float: 'float',
  int: 'long',
  bool: 'bool',
  vec2: 'point2D',
  ivec2: 'point2D',
  vec3: 'vector3',
  vec4: 'vector4',
  sampler2D: 'image',
};

/** Names of uniforms that are colors, because GLSL has no such type. */
const COLOR = /colou?r|clr/i;

const SIZES: Readonly<Partial<Record<IsfInput['type'], number>>> = {
  float: 1,
  long: 1,
  bool: 1,
  point2D: 2,
  vector3: 3,
  vector4: 4,
  color: 4,
};

/**
 * Reads a transition in the format of gl-transitions.com: `vec4 transition(vec2 uv)` with `getFromColor`, `getToColor`, `progress` and
 * `ratio`, and uniforms as params, whose initial values are in comments (`// = 0.5`). It becomes a composite of two layers with `progress`
 * from 0 to 1. The comments `Author:` and `License:` are its credit. SCR041 if the GLSL cannot be parsed.
 */
export function readTransition(source: string, file: string): Result<IsfShader> {
  try {
    const { declarations } = parseShader(source);
    const diagnostics: Diagnostic[] = [];
    const inputs = declarations.flatMap((declaration) =>
      declaration.kind === 'variables' && isUniform(declaration) ? readUniforms(declaration, source, file, diagnostics) : [],
    );
    return { output: shaderOf(source, file, inputs), diagnostics };
  } catch (error) {
    if (!(error instanceof GlslError)) throw error;
    const { code, message, place } = error;
    return { output: null, diagnostics: [{ code, severity: 'error', message, file, ...place }] };
  }
}

export function isUniform({ qualifiers }: VariableDeclaration): boolean {
  return qualifiers.some(({ text }) => text === 'uniform');
}

function shaderOf(source: string, file: string, inputs: readonly IsfInput[]): IsfShader {
  return {
    file,
    source,
    vertex: null,
    dialect: 'transition',
    version: 2,
    kind: 'operator',
    title: null,
    description: 'Changes from one layer to the other as “Progress” goes from 0 to 1.',
    credit: commentValue(source, 'author'),
    licence: commentValue(source, 'licen[sc]e'),
    categories: ['Transition'],
    inputs: [
      inputOf(FROM_IMAGE, 'image', { label: 'From', doc: 'The layer shown at progress 0.' }),
      inputOf(TO_IMAGE, 'image', { label: 'To', doc: 'The layer shown at progress 1.' }),
      inputOf(PROGRESS, 'float', {
        label: 'Progress',
        doc: 'How far the transition has gone, from 0 to 1.',
        default: [0],
        min: [0],
        max: [1],
      }),
      ...inputs,
    ],
    passes: [{ target: null, persistent: false, float: false, half: false, width: null, height: null }],
    imported: [],
    premultiplied: false,
    opaqueImages: [],
    encoding: 'display',
    readsScene: false,
    writesScene: false,
    depth: 'none',
    fit: 'cover',
    renamed: [],
  };
}

function readUniforms(declaration: VariableDeclaration, source: string, file: string, diagnostics: Diagnostic[]): IsfInput[] {
  return declaration.declarators.flatMap((declarator): IsfInput[] => {
    const { text, line, column } = declarator.name;
    if (GIVEN.has(text)) return [];
    const type = typeOf(declaration, declarator);
    if (type === null) {
      const message = `The uniform “${text}” has a type that no parameter has.`;
      const fix = `Use one of ${Object.keys(TYPES).join(', ')}.`;
      diagnostics.push({ code: 'SCR043', severity: 'warning', message, fix, file, line, column });
      return [];
    }
    const size = SIZES[type] ?? 0;
    const written = size === 0 ? null : readDefault(source, declarator.name, size);
    const start = written ?? new Array<number>(size).fill(0);
    return [{ ...inputOf(text, type, { default: type === 'color' && start.length === 3 ? [...start, 1] : start }), line, column }];
  });
}

function typeOf({ type }: VariableDeclaration, { name, dimensions }: Declarator): IsfInput['type'] | null {
  if (dimensions.length > 0 || type.dimensions.length > 0) return null;
  const known = Object.hasOwn(TYPES, type.name.text) ? TYPES[type.name.text] : undefined;
  if (known === 'vector3' || known === 'vector4') return COLOR.test(name.text) ? 'color' : known;
  return known ?? null;
}

function inputOf(name: string, type: IsfInput['type'], more: Partial<IsfInput> = {}): IsfInput {
  return {
    name,
    type,
    label: name,
    doc: '',
    default: [],
    min: null,
    max: null,
    identity: null,
    choices: [],
    unit: 'none',
    step: null,
    handle: null,
    sampleCount: null,
    optional: false,
    repeat: false,
    line: 1,
    column: 1,
    ...more,
  };
}

/** The text after `// Author:` to the end of the line. */
function commentValue(source: string, key: string): string {
  const found = new RegExp(`^[\\s/*]*${key}\\s*:\\s*(.+?)\\s*(?:\\*/)?\\s*$`, 'im').exec(source);
  return found?.[1]?.trim() ?? '';
}
