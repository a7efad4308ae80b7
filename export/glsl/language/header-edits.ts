import type { Node } from 'jsonc-parser';
import { entries, items, property, readHeader, textOf } from '../isf/isf-header.ts';

/** A path in a header: `['INPUTS', 0, 'LABEL']`. */
export type HeaderPath = readonly (string | number)[];

/** A value in a header. */
export type HeaderValue = string | number | boolean | readonly HeaderValue[] | { readonly [key: string]: HeaderValue };

/**
 * Sets a value in a shader's header, or removes its key if the value is undefined. Everything else stays as written, including comments and
 * unknown keys. Returns null if the header cannot be read or the path does not exist.
 */
export function setInHeader(source: string, path: HeaderPath, value: HeaderValue | undefined): string | null {
  const root = rootOf(source);
  const key = path.at(-1);
  if (root === null || key === undefined) return null;
  const parent = nodeAt(root, path.slice(0, -1));
  if (parent === undefined) {
    // Creates the list or object that contains it first.
    if (value === undefined) return source;
    return setInHeader(source, path.slice(0, -1), typeof key === 'number' ? [value] : { [key]: value });
  }
  const edited = typeof key === 'number' ? setItem(source, parent, key, value) : setProperty(source, parent, key, value);
  return edited !== null && rootOf(edited) !== null ? edited : null;
}

/** Moves an item within a list. */
export function moveInHeader(source: string, path: HeaderPath, from: number, to: number): string | null {
  const list = items(nodeAt(rootOf(source) ?? undefined, path));
  const [a, b] = [list[Math.min(from, to)], list[Math.max(from, to)]];
  if (!a || !b || a === b || Math.abs(from - to) !== 1) return null;
  const text = ({ offset, length }: Node) => source.slice(offset, offset + length);
  return source.slice(0, a.offset) + text(b) + source.slice(a.offset + a.length, b.offset) + text(a) + source.slice(b.offset + b.length);
}

/** Updates paths of imported images. A header that cannot be read stays unchanged. */
export function moveImported(source: string, moved: ReadonlyMap<string, string>): string {
  const imported = property(rootOf(source) ?? undefined, 'IMPORTED');
  const values = imported?.type === 'object' ? [...entries(imported)].map(([, value]) => value) : items(imported);
  const paths = values.flatMap((value) => {
    const path = property(value, 'PATH');
    return path?.type === 'array' ? items(path) : path === undefined ? [] : [path];
  });
  return paths.reduceRight((text, path) => {
    const to = moved.get(textOf(path) ?? '');
    return to === undefined ? text : text.slice(0, path.offset) + printValue(to) + text.slice(path.offset + path.length);
  }, source);
}

function rootOf(source: string): Node | null {
  return readHeader(source, '').header?.root ?? null;
}

function nodeAt(root: Node | undefined, path: HeaderPath): Node | undefined {
  let node = root;
  for (const key of path) node = typeof key === 'number' ? items(node)[key] : property(node, key);
  return node;
}

function setProperty(source: string, object: Node, key: string, value: HeaderValue | undefined): string | null {
  if (object.type !== 'object') return null;
  const known = property(object, key);
  if (value === undefined) {
    const written = object.children?.find((child) => child.children?.[1] === known);
    return known === undefined || !written ? source : remove(source, object, written);
  }
  if (known !== undefined) return source.slice(0, known.offset) + printValue(value) + source.slice(known.offset + known.length);
  return insert(source, object, `${JSON.stringify(key)}: ${printValue(value)}`);
}

function setItem(source: string, list: Node, index: number, value: HeaderValue | undefined): string | null {
  if (list.type !== 'array') return null;
  const known = items(list)[index];
  if (value === undefined) return known === undefined ? source : remove(source, list, known);
  if (known !== undefined) return source.slice(0, known.offset) + printValue(value) + source.slice(known.offset + known.length);
  return insert(source, list, printValue(value));
}

/** Inserts after the last child, on a separate line if the children have separate lines. */
function insert(source: string, parent: Node, text: string): string {
  const last = parent.children?.at(-1);
  if (last === undefined) {
    const [open, close] = parent.type === 'array' ? ['[', ']'] : ['{', '}'];
    return `${source.slice(0, parent.offset)}${open} ${text} ${close}${source.slice(parent.offset + parent.length)}`;
  }
  const first = parent.children?.[0] ?? last;
  const lead = /(\r\n|\r|\n)([ \t]*)$/.exec(source.slice(parent.offset, first.offset));
  const end = last.offset + last.length;
  return `${source.slice(0, end)},${lead === null ? ' ' : `${lead[1]}${lead[2]}`}${text}${source.slice(end)}`;
}

/** Removes a child with the comma next to it. */
function remove(source: string, parent: Node, child: Node): string {
  const children = parent.children ?? [];
  const index = children.indexOf(child);
  const before = children[index - 1];
  const after = children[index + 1];
  const end = child.offset + child.length;
  if (after === undefined) {
    if (before === undefined) return source.slice(0, child.offset) + source.slice(end);
    const start = before.offset + before.length;
    const comma = commaIn(source, start, child.offset) ?? start - 1;
    const between = source.slice(start, comma) + source.slice(comma + 1, child.offset);
    // A comment in between belongs to the preceding child, and stays.
    return source.slice(0, start) + (between.trim() === '' ? '' : between) + source.slice(end);
  }
  const comma = commaIn(source, end, after.offset) ?? end - 1;
  const rest = source.slice(comma + 1, after.offset);
  return source.slice(0, child.offset) + (rest.trim() === '' ? '' : rest.trimStart()) + source.slice(after.offset);
}

function commaIn(source: string, from: number, to: number): number | null {
  for (const { index, 0: text } of source.slice(from, to).matchAll(/\/\/[^\r\n]*|\/\*[\s\S]*?\*\/|,/g))
    if (text === ',') return from + index;
  return null;
}

/** Prints JSON on one line with spaces. Text that would end the surrounding comment is escaped. */
export function printValue(value: HeaderValue): string {
  if (typeof value === 'string') return JSON.stringify(value).replaceAll('*/', '*\\/');
  if (typeof value !== 'object') return JSON.stringify(value);
  if (isList(value)) return value.length === 0 ? '[]' : `[${value.map(printValue).join(', ')}]`;
  const pairs = Object.entries(value).map(([key, one]) => `${JSON.stringify(key)}: ${printValue(one)}`);
  return pairs.length === 0 ? '{ }' : `{ ${pairs.join(', ')} }`;
}

function isList(value: HeaderValue): value is readonly HeaderValue[] {
  return Array.isArray(value);
}

/** The values of a header as written, for a form. */
export interface HeaderForm {
  readonly description: string;
  readonly credit: string;
  readonly categories: readonly string[];
  readonly inputs: readonly HeaderFields[];
  readonly passes: readonly HeaderFields[];
}

/** Values of an object in the header, by key: texts, numbers, booleans, and lists of texts or numbers. Other values are left out. */
export type HeaderFields = Readonly<Record<string, string | number | boolean | readonly (string | number)[]>>;

/** Reads the values of a header; null if the header cannot be read. */
export function readHeaderForm(source: string): HeaderForm | null {
  const root = rootOf(source);
  if (root === null) return null;
  return {
    description: textOf(property(root, 'DESCRIPTION')) ?? '',
    credit: textOf(property(root, 'CREDIT')) ?? '',
    categories: items(property(root, 'CATEGORIES'))
      .map(textOf)
      .filter((one) => one !== null),
    inputs: items(property(root, 'INPUTS')).map(fieldsOf),
    passes: items(property(root, 'PASSES')).map(fieldsOf),
  };
}

function fieldsOf(object: Node): HeaderFields {
  const fields: Record<string, HeaderFields[string]> = {};
  if (object.type !== 'object') return fields;
  for (const [{ value: key }, node] of entries(object)) {
    if (node.type === 'array') fields[String(key)] = items(node).map(({ value }) => (typeof value === 'number' ? value : String(value)));
    else if (node.type !== 'object' && node.type !== 'null') fields[String(key)] = node.value as string | number | boolean;
  }
  return fields;
}
