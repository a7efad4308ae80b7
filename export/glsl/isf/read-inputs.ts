import type { Node } from 'jsonc-parser';
import { type Curve, curveMisfit, DIAGONAL } from '../../../nodes/kit/curve.ts';
import type { Unit } from '../../../nodes/kit/definition.ts';
import { BLACK_TO_WHITE, type Gradient, gradientMisfit } from '../../../nodes/kit/gradient.ts';
import { IMAGE_HANDLES_OF, type ImageHandle } from '../../../nodes/kit/handles.ts';
import { flagOf, type Header, items, numberOf, property, textOf } from './isf-header.ts';
import type { IsfInput, IsfInputType } from './isf-shader.ts';

/** How many numbers a value of each type has; 0 for types that only wires provide, and for curves and gradients, which may have any number of points. */
const SIZES: Readonly<Record<IsfInputType, number>> = {
  event: 0,
  bool: 1,
  long: 1,
  float: 1,
  point2D: 2,
  color: 4,
  image: 0,
  audio: 0,
  audioFFT: 0,
  depth: 0,
  curve: 0,
  gradient: 0,
  vector3: 3,
  vector4: 4,
};

/** Input types that only the shaders of gl-transitions have, not ISF headers. */
const NOT_IN_HEADERS: ReadonlySet<string> = new Set(['vector3', 'vector4'] satisfies IsfInputType[]);

const UNITS: ReadonlySet<string> = new Set(['m', 's', 'rad', 'px', 'K', 'Hz', 'cd', 'ratio', 'none'] satisfies Unit[]);

/** Maximum number of choices of a `long` without VALUES. */
const MAX_CHOICES = 64;

const IDENTIFIER = /^[A-Za-z_][A-Za-z0-9_]*$/;

export function isIdentifier(name: string): boolean {
  return IDENTIFIER.test(name);
}

/** Reads `INPUTS`. An invalid input is reported and left out. */
export function readInputs(header: Header): IsfInput[] {
  const list = property(header.root, 'INPUTS');
  if (list !== undefined && list.type !== 'array' && list.type !== 'null')
    header.error(list, 'INPUTS must be a list: [ { "NAME": …, "TYPE": … } ].');
  const inputs: IsfInput[] = [];
  for (const node of items(list)) {
    const input = readInput(header, node);
    if (input === null) continue;
    if (inputs.some((other) => other.name === input.name)) {
      header.error(property(node, 'NAME') ?? node, `Two inputs have the name “${input.name}”.`, 'Give one of them another name.');
    } else {
      inputs.push(input);
    }
  }
  return inputs;
}

function readInput(header: Header, node: Node): IsfInput | null {
  if (node.type !== 'object') {
    header.error(node, 'An input must be an object: { "NAME": …, "TYPE": … }.');
    return null;
  }
  const nameNode = property(node, 'NAME');
  const name = textOf(nameNode)?.trim() ?? '';
  if (nameNode === undefined || !isIdentifier(name)) {
    header.error(nameNode ?? node, 'The NAME of an input is invalid. Use letters, digits and “_”, and start with no digit.');
    return null;
  }
  const typeNode = property(node, 'TYPE');
  const written = textOf(typeNode)?.trim() ?? '';
  const type = typeMeant(written);
  if (type === null) {
    header.error(
      typeNode ?? node,
      `The input "${name}" has the TYPE "${written}", which does not exist.`,
      `Use one of ${Object.keys(SIZES)
        .filter((known) => !NOT_IN_HEADERS.has(known))
        .join(', ')}.`,
    );
    return null;
  }
  if (type !== written && typeNode)
    header.warn(
      typeNode,
      `The TYPE "${written}" must be written "${type}". Scrim reads it anyway; other programs may leave the input out.`,
    );
  const { line, column } = header.place(nameNode.offset);
  const choices = type === 'long' ? readChoices(header, node, name) : [];
  const min = readValue(header, node, 'MIN', type, name);
  const max = readValue(header, node, 'MAX', type, name);
  const ordered = min === null || max === null || min.every((value, i) => value <= (max[i] ?? value));
  if (!ordered) header.warn(property(node, 'MIN') ?? node, `MIN of the input “${name}” is greater than MAX. Neither is used.`);
  const range = ordered && type !== 'audio' && type !== 'audioFFT' ? { min, max } : { min: null, max: null };
  return {
    name,
    type,
    label: textOf(property(node, 'LABEL'))?.trim() || name,
    doc: textOf(property(node, 'DOC'))?.trim() ?? '',
    ...range,
    default:
      type === 'curve' || type === 'gradient'
        ? readPoints(header, node, name, POINTS[type])
        : readDefault(header, node, type, name, range.min, range.max, choices),
    identity: readValue(header, node, 'IDENTITY', type, name),
    choices,
    unit: readUnit(header, node, name),
    step: numberOf(property(node, 'STEP')),
    handle: readHandle(header, node, type, name),
    sampleCount: readSampleCount(node, type),
    optional: flagOf(property(node, 'OPTIONAL')),
    repeat: textOf(property(node, 'WRAP')) === 'repeat',
    line,
    column,
  };
}

/**
 * Reads the default of an input, clamped to its range. Without a valid DEFAULT, it is the first choice, or the value in the range that is
 * nearest to zero (for a color, to opaque black).
 */
function readDefault(
  header: Header,
  node: Node,
  type: IsfInputType,
  name: string,
  min: readonly number[] | null,
  max: readonly number[] | null,
  choices: IsfInput['choices'],
): readonly number[] {
  const zero = type === 'color' ? [0, 0, 0, 1] : new Array<number>(SIZES[type]).fill(0);
  const written = readValue(header, node, 'DEFAULT', type, name);
  if (choices.length > 0) {
    const value = written?.[0];
    if (value !== undefined && choices.some((choice) => choice.value === value)) return [value];
    if (value !== undefined)
      header.warn(property(node, 'DEFAULT') ?? node, `The DEFAULT of "${name}" is not one of its VALUES. The first is used.`);
    return [choices[0]?.value ?? 0];
  }
  const clamped = (written ?? zero).map((value, i) => Math.min(Math.max(value, min?.[i] ?? value), max?.[i] ?? Number.POSITIVE_INFINITY));
  if (written !== null && clamped.some((value, i) => value !== written[i])) {
    header.warn(property(node, 'DEFAULT') ?? node, `The DEFAULT of "${name}" is outside MIN and MAX. The nearest value is used.`);
  }
  return clamped;
}

/** How the lists of points of the types are checked, and what is used where there is no valid one. */
const POINTS = {
  curve: { misfit: curveMisfit, otherwise: DIAGONAL, words: 'The diagonal' },
  gradient: { misfit: gradientMisfit, otherwise: BLACK_TO_WHITE, words: 'The gradient from black to white' },
} as const;

/** Reads a curve, `[[0, 0], [0.5, 0.7], [1, 1]]`, or a gradient, `[[0, 0, 0, 0, 1, 0], …]`, or the same numbers in one list. */
function readPoints(
  header: Header,
  node: Node,
  name: string,
  { misfit: misfitOf, otherwise, words }: (typeof POINTS)[keyof typeof POINTS],
): Curve | Gradient {
  const written = property(node, 'DEFAULT');
  if (written === undefined) return otherwise;
  const numbers = items(written)
    .flatMap((item) => (item.type === 'array' ? items(item) : [item]))
    .map(numberOf);
  const misfit = misfitOf(numbers);
  if (misfit === null) return numbers as Curve | Gradient;
  header.warn(written, `The DEFAULT of "${name}" must be ${misfit}. ${words} is used.`);
  return otherwise;
}

function readValue(header: Header, node: Node, key: string, type: IsfInputType, name: string): readonly number[] | null {
  const size = SIZES[type];
  const value = property(node, key);
  if (size === 0 || value === undefined || value.type === 'null') return null;
  const numbers = (value.type === 'array' ? items(value) : [value]).map(numberOf);
  if (numbers.every((n) => n !== null)) {
    const expanded = expand(type, numbers);
    if (expanded !== null) return expanded;
  }
  const wanted =
    size === 1 ? 'a number' : type === 'color' ? 'a list of four numbers, red, green, blue and alpha' : `a list of ${size} numbers`;
  header.warn(value, `${key} of the input "${name}" is not ${wanted}, so it is not used.`);
  return null;
}

/**
 * Completes the numbers of a value: a single number applies to all components of a point, and a color may omit its alpha. Null if their
 * count is invalid.
 */
function expand(type: IsfInputType, numbers: readonly number[]): readonly number[] | null {
  const size = SIZES[type];
  const [first] = numbers;
  if (first === undefined) return null;
  if (type === 'bool') return [first === 0 ? 0 : 1];
  if (type === 'long') return [Math.trunc(first)];
  if (type === 'color' && numbers.length === 3) return [...numbers, 1].map(unitInterval);
  if (type === 'color') return numbers.length === 4 ? numbers.map(unitInterval) : null;
  if (numbers.length === 1) return new Array<number>(size).fill(first);
  return numbers.length === size ? numbers : null;
}

function unitInterval(value: number): number {
  return Math.min(Math.max(value, 0), 1);
}

function readChoices(header: Header, node: Node, name: string): IsfInput['choices'] {
  const valuesNode = property(node, 'VALUES');
  const labels = items(property(node, 'LABELS')).map((label) => textOf(label) ?? String(label.value));
  if (valuesNode === undefined) return rangeChoices(node, labels);
  const choices: { value: number; label: string }[] = [];
  items(valuesNode).forEach((item, i) => {
    const value = numberOf(item);
    if (value === null) header.warn(item, `One of the VALUES of "${name}" is not a number. It is left out.`);
    else choices.push({ value: Math.trunc(value), label: labels[i] ?? String(value) });
  });
  if (choices.length === 0) header.warn(valuesNode, `VALUES of the input "${name}" lists no numbers.`);
  return choices;
}

/**
 * The choices of a `long` without VALUES: the integers from MIN (default: 0) to MAX (default: as many as there are LABELS). Empty if there
 * would be more than `MAX_CHOICES`.
 */
function rangeChoices(node: Node, labels: readonly string[]): IsfInput['choices'] {
  const min = numberOf(property(node, 'MIN')) ?? 0;
  const max = numberOf(property(node, 'MAX')) ?? (labels.length > 0 ? min + labels.length - 1 : Number.NaN);
  if (!(max >= min && max - min < MAX_CHOICES)) return [];
  return Array.from({ length: Math.trunc(max - min) + 1 }, (_, i) => ({ value: min + i, label: labels[i] ?? String(min + i) }));
}

/** `UNIT` of the input, or its entry in `SCRIM_UNITS`. */
function readUnit(header: Header, node: Node, name: string): Unit {
  const unitNode = property(node, 'UNIT') ?? property(property(header.root, 'SCRIM_UNITS'), name);
  const unit = textOf(unitNode);
  if (unit !== null && UNITS.has(unit)) return unit as Unit;
  if (unitNode !== undefined) header.warn(unitNode, `The unit of “${name}” is unknown.`, `Use one of ${[...UNITS].join(', ')}.`);
  return 'none';
}

/** `HANDLE`: a part of the gizmo that fits the type; null if there is none. */
function readHandle(header: Header, node: Node, type: IsfInputType, name: string): ImageHandle | null {
  const written = property(node, 'HANDLE');
  const fitting: readonly ImageHandle[] = type === 'float' ? IMAGE_HANDLES_OF.number : type === 'point2D' ? IMAGE_HANDLES_OF.vector2 : [];
  const handle = fitting.find((known) => known === textOf(written)) ?? null;
  if (written !== undefined && handle === null)
    header.warn(
      written,
      `The input “${name}” cannot have this HANDLE.`,
      `A float can have ${IMAGE_HANDLES_OF.number.join(' or ')}, a point2D ${IMAGE_HANDLES_OF.vector2.join(', ')}.`,
    );
  return handle;
}

/** `MAX` of sound is the number of samples or bins; null if it is invalid. */
function readSampleCount(node: Node, type: IsfInputType): number | null {
  if (type !== 'audio' && type !== 'audioFFT') return null;
  const count = Math.trunc(numberOf(property(node, 'MAX')) ?? 0);
  return count >= 1 ? count : null;
}

/** The input type that a header names, ignoring case; null if there is no such type. */
function typeMeant(written: string): IsfInputType | null {
  const types = Object.keys(SIZES) as IsfInputType[];
  return types.find((type) => type.toLowerCase() === written.toLowerCase() && !NOT_IN_HEADERS.has(type)) ?? null;
}
