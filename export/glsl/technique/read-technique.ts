import { hasErrors, type Result } from '../../../nodes/kit/diagnostics.ts';
import type { TechniquePass } from '../../program/program.ts';
import { type Header, items, property, readHeader, textOf } from '../isf/isf-header.ts';
import { isIdentifier, readInputs } from '../isf/read-inputs.ts';
import { readRenamed } from '../isf/read-renamed.ts';
import type { TechniqueShader } from './technique-shader.ts';

/** Maximum number of passes; each draws every object again. */
const MAX_PASSES = 8;

const SIDES: readonly TechniquePass['side'][] = ['object', 'front', 'back', 'both', 'edges'];

/** Names of the interface (`interface.ts`). */
const TAKEN: ReadonlySet<string> = new Set([
  'Vertex',
  'Surface',
  'Light',
  'EYE',
  'AMBIENT',
  'LIGHT_COUNT',
  'LIGHT',
  'IRRADIANCE',
  'REFLECTION',
  'ENVIRONMENT',
  'PASSINDEX',
  'TIME',
  'RENDERSIZE',
  'VIEW_UV',
  'VIEW_DEPTH',
  'PIXEL_M',
  'vertex',
  'surface',
  'main',
]);

/**
 * Reads the header of a technique as leniently as those of ISF files.
 *
 * @returns The technique, or null if the header cannot be used; mistakes as SCR040 with line and column.
 */
export function readTechnique(source: string, file: string): Result<TechniqueShader> {
  const { header, diagnostics } = readHeader(source, file);
  if (header === null) return { output: null, diagnostics };
  const technique: TechniqueShader = {
    file,
    source,
    title: textOf(property(header.root, 'SCRIM_TITLE')),
    description: textOf(property(header.root, 'DESCRIPTION'))?.trim() ?? '',
    credit: textOf(property(header.root, 'CREDIT'))?.trim() ?? '',
    licence: textOf(property(header.root, 'LICENSE'))?.trim() ?? '',
    categories: items(property(header.root, 'CATEGORIES'))
      .map(textOf)
      .filter((category) => category !== null),
    inputs: readTaken(header),
    pictures: readImages(header),
    imported: readImported(header),
    passes: readPasses(header),
    unread: readUnread(header),
    renamed: readRenamed(header),
  };
  return { output: hasErrors(diagnostics) ? null : technique, diagnostics };
}

/** Input types of techniques. */
const TYPES: readonly string[] = ['bool', 'long', 'float', 'point2D', 'color', 'image'];

function readTaken(header: Header): TechniqueShader['inputs'] {
  const nodes = items(property(header.root, 'INPUTS'));
  return readInputs(header).filter((input) => {
    const node = nodes.find((one) => textOf(property(one, 'NAME'))?.trim() === input.name) ?? header.root;
    if (TAKEN.has(input.name))
      header.error(node, `"${input.name}" is what techniques call something else.`, 'Give the input another name.');
    else if (TYPES.includes(input.type)) return true;
    else
      header.error(
        node,
        `The input "${input.name}" is of TYPE "${input.type}", which techniques do not support.`,
        `Use one of ${TYPES.join(', ')}.`,
      );
    return false;
  });
}

/** Image inputs that are read by UV as textures, instead of by position in the view. */
function readImages(header: Header): readonly string[] {
  return items(property(header.root, 'INPUTS')).flatMap((node) => {
    const space = property(node, 'SPACE');
    if (space === undefined) return [];
    const word = textOf(space);
    if (word !== 'view' && word !== 'picture') header.error(space, 'SPACE must be "view" or "picture".');
    return word === 'picture' ? [textOf(property(node, 'NAME'))?.trim() ?? ''] : [];
  });
}

function readImported(header: Header): TechniqueShader['imported'] {
  const list = property(header.root, 'IMPORTED');
  return (list?.type === 'object' ? (list.children ?? []) : []).flatMap(({ children: [key, value] = [] }) => {
    const name = textOf(key);
    const path = textOf(property(value, 'PATH'));
    if (!key || name === null) return [];
    if (path === null || !isIdentifier(name) || TAKEN.has(name)) {
      header.error(key, 'IMPORTED lists images of the library: { "strokes": { "PATH": "pictures/strokes.png" } }.');
      return [];
    }
    return [{ name, path, ...header.place(key.offset) }];
  });
}

function readUnread(header: Header): TechniqueShader['unread'] {
  return items(property(header.root, 'SCRIM_UNREAD')).flatMap((node) => {
    const name = textOf(property(node, 'NAME'));
    const input = textOf(property(node, 'INPUT'));
    const values = items(property(node, 'VALUES')).map(({ value }) => value);
    if ((name === 'along' || name === 'radial') && input !== null && values.every((value) => typeof value === 'number'))
      return [{ name, input, values }];
    header.error(node, 'SCRIM_UNREAD lists values: { "NAME": "radial", "INPUT": "lines", "VALUES": [0] }.');
    return [];
  });
}

function readPasses(header: Header): readonly TechniquePass[] {
  const list = property(header.root, 'PASSES');
  if (list !== undefined && list.type !== 'array') header.error(list, 'PASSES must be a list: [ { "SIDE": "back" }, { } ].');
  const nodes = items(list);
  if (nodes.length > MAX_PASSES && list) header.error(list, `The technique has more than ${MAX_PASSES} passes.`);
  const passes = nodes.map((node): TechniquePass => {
    const written = property(node, 'SIDE');
    const side = SIDES.find((one) => one === textOf(written));
    if (written !== undefined && side === undefined) header.error(written, 'SIDE must be "front", "back", "both", "object" or "edges".');
    return { side: side ?? 'object', ...(property(node, 'OPEN')?.value === true ? { open: true } : {}) };
  });
  return passes.length === 0 ? [{ side: 'object' }] : passes;
}
