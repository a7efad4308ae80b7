import { hasErrors, type Result } from '../../../nodes/kit/diagnostics.ts';
import { findTerms } from './find-terms.ts';
import { type Header, items, property, readHeader, textOf } from './isf-header.ts';
import { type IsfInput, type IsfShader, SHADER_ENCODINGS } from './isf-shader.ts';
import { readInputs } from './read-inputs.ts';
import { readImported, readPasses } from './read-passes.ts';
import { readRenamed } from './read-renamed.ts';

/**
 * Reads the header of an ISF file, version 1 or 2, as leniently as other hosts: it accepts trailing, doubled and missing commas, control
 * characters and comments.
 *
 * @param file Name in the library or project.
 * @param vertex Text of the vertex shader (`companionOf(file)`), or null.
 * @returns The shader, or null if the header cannot be used; mistakes as SCR040 with line and column.
 */
export function readIsf(source: string, file: string, vertex: string | null = null): Result<IsfShader> {
  const { header, diagnostics } = readHeader(source, file);
  if (header === null) return { output: null, diagnostics };
  const inputs = readInputs(header);
  const encoding = readWord(header, 'SCRIM_ENCODING', SHADER_ENCODINGS);
  const shader: IsfShader = {
    file,
    source,
    vertex: vertex === null ? null : { file: companionOf(file), source: vertex },
    dialect: 'isf',
    version: property(header.root, 'ISFVSN') === undefined ? 1 : 2,
    kind: kindOf(inputs),
    title: textOf(property(header.root, 'SCRIM_TITLE')),
    description: textOf(property(header.root, 'DESCRIPTION'))?.trim() ?? '',
    credit: textOf(property(header.root, 'CREDIT'))?.trim() ?? '',
    // ISF has no standard key; most files name their license in comments.
    licence: textOf(property(header.root, 'LICENSE'))?.trim() ?? findTerms(source).licence,
    categories: items(property(header.root, 'CATEGORIES'))
      .map(textOf)
      .filter((category) => category !== null),
    inputs,
    passes: readPasses(header, inputs),
    imported: readImported(header),
    premultiplied: readWord(header, 'SCRIM_ALPHA', ['straight', 'premultiplied']) === 'premultiplied',
    opaqueImages: items(property(header.root, 'SCRIM_OPAQUE')).flatMap((node) => textOf(node) ?? []),
    depth: readWord(header, 'SCRIM_DEPTH', ['auto', 'same', 'none', 'over', 'nearer']),
    encoding,
    readsScene: encoding === 'scene' || encoding === 'scene to display',
    writesScene: encoding === 'scene' || encoding === 'display to scene',
    fit: readWord(header, 'SCRIM_FIT', ['cover', 'contain', 'stretch']),
    renamed: readRenamed(header),
  };
  return { output: hasErrors(diagnostics) ? null : shader, diagnostics };
}

/** Name of the vertex shader of a file: `edge.vs` of `edge.fs`. */
export function companionOf(file: string): string {
  return file.replace(/\.[^./\\]*$/, '.vs');
}

/**
 * The kind of a shader by its number of images. This gives the same result as ISF's conventions: `inputImage` is a filter's only image, a
 * transition has two.
 */
function kindOf(inputs: readonly IsfInput[]): IsfShader['kind'] {
  const images = inputs.filter((input) => input.type === 'image').length;
  return images === 0 ? 'generator' : images === 1 ? 'filter' : 'operator';
}

/** The value of a Scrim key among `words`; the first if the key is missing or invalid. */
function readWord<const W extends string>(header: Header, key: string, words: readonly [W, ...W[]]): W {
  const node = property(header.root, key);
  const word = words.find((w) => w === textOf(node));
  if (node !== undefined && word === undefined) header.warn(node, `${key} must be one of ${words.map((w) => `"${w}"`).join(', ')}.`);
  return word ?? words[0];
}
