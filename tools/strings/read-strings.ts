import { children, isNode, parseFile, type SyntaxNode } from '../layers/syntax.ts';

/** Path of the committed table of strings. Its diff is reviewed like that of a rendered image. */
export const STRINGS_TABLE = 'docs/strings.tsv';

/**
 * What a string is for: `title` and `label` name something, `doc` explains it, `command` is a menu's item, `problem` a diagnostic and
 * `remedy` its fix, `ui` is any other text of the editor, and `text` any other text elsewhere.
 */
export type StringKind = 'title' | 'label' | 'doc' | 'command' | 'problem' | 'remedy' | 'ui' | 'text';

export interface UserString {
  readonly file: string;
  readonly kind: StringKind;
  /** The text. `{}` stands for each value of a template and for each element within a text. */
  readonly text: string;
}

/** Name of a project's file in its folder. */
const PROJECT_FILE = 'project.scrim.json';

const KIND_OF_KEY: Readonly<Record<string, StringKind>> = {
  title: 'title',
  label: 'label',
  doc: 'doc',
  message: 'problem',
  fix: 'remedy',
};

/** Attributes and keys whose values no user reads, although they may look like words. */
const SILENT_KEYS = new Set(['className', 'class', 'style', 'd', 'points', 'viewBox', 'path', 'type', 'name', 'id', 'key', 'keywords']);
const SPOKEN_ATTRIBUTES = new Set(['title', 'label', 'aria-label', 'placeholder', 'alt', 'hint', 'doc', 'text', 'tooltip']);

/** Calls whose texts are for programmers, or for no person. */
const SILENT_CALLS =
  /^(Error|TypeError|RangeError|SyntaxError|DOMException|querySelector|querySelectorAll|matchMedia|closest|matches|RegExp|fail)$/;

/** Reads a TypeScript module by its syntax tree, a shader by the header at its top, and a project by its title and description. */
export function readStrings(path: string, text: string): UserString[] {
  if (path.endsWith(PROJECT_FILE)) return readProject(path, text);
  return /\.(fs|glsl)$/.test(path) ? readHeader(path, text) : readModule(path, text);
}

/** Prints the table: one string per line with the columns kind, file and text, in the order of the strings. */
export function printTable(strings: readonly UserString[]): string {
  const lines = strings.map(({ kind, file, text }) => `${kind}\t${file}\t${text.replaceAll('\t', ' ')}`);
  return `kind\tfile\ttext\n${lines.join('\n')}\n`;
}

function readProject(path: string, text: string): UserString[] {
  const { title, page } = JSON.parse(text) as { title?: string; page?: { description?: string } };
  const found: UserString[] = [];
  if (title) found.push({ file: path, kind: 'title', text: title });
  if (page?.description) found.push({ file: path, kind: 'doc', text: page.description });
  return found;
}

function readModule(path: string, text: string): UserString[] {
  const found: UserString[] = [];
  const add = (kind: StringKind, value: string): void => {
    const flat = value.replace(/\s+/g, ' ').trim();
    if (/[A-Za-z]{2}/.test(flat)) found.push({ file: path, kind, text: flat });
  };
  visit(parseFile(path, text).program, null, path.endsWith('.tsx') ? 'ui' : 'text', add);
  return found;
}

type Add = (kind: StringKind, text: string) => void;

/** Syntax nodes that have the same kind as their children: conditions and concatenations, but not calls and objects. */
const TRANSPARENT = new Set([
  'ConditionalExpression',
  'LogicalExpression',
  'BinaryExpression',
  'JSXExpressionContainer',
  'ArrowFunctionExpression',
]);

/**
 * Collects the strings in a syntax node. `kind` is the kind by the nearest attribute, key or variable name; null if that gives none, then
 * only strings that read as sentences count.
 */
function visit(node: SyntaxNode, kind: StringKind | null, fallback: StringKind, add: Add): void {
  if (isSilent(node)) return;
  switch (node.type) {
    case 'JSXAttribute':
      visitAttribute(node, fallback, add);
      return;
    case 'ObjectExpression':
      visitObject(node, fallback, add);
      return;
    case 'VariableDeclarator':
      if (isNode(node.init)) visit(node.init, kindOf(String((node.id as SyntaxNode).name)), fallback, add);
      return;
    case 'JSXElement':
    case 'JSXFragment':
      add('ui', jsxWords(node));
      break;
    case 'Literal':
    case 'TemplateLiteral': {
      const words = textOf(node);
      if (kind !== null || isSentence(words)) add(kind ?? fallback, words);
      break;
    }
  }
  for (const [key, child] of children(node)) {
    if (key !== 'quasis') visit(child, TRANSPARENT.has(node.type) && key !== 'test' ? kind : null, fallback, add);
  }
}

function visitAttribute(node: SyntaxNode, fallback: StringKind, add: Add): void {
  const name = String((node.name as { name?: unknown }).name);
  if (!isNode(node.value)) return;
  if (SPOKEN_ATTRIBUTES.has(name)) visit(node.value, 'ui', fallback, add);
  else if (node.value.type !== 'Literal') visit(node.value, null, fallback, add);
}

function visitObject(node: SyntaxNode, fallback: StringKind, add: Add): void {
  const isCommand = hasKeys(node, ['label', 'run']);
  for (const property of node.properties as readonly SyntaxNode[]) {
    if (property.type !== 'Property') {
      visit(property, null, fallback, add);
      continue;
    }
    const key = property.key as SyntaxNode;
    const name = String(key.name ?? key.value);
    if (SILENT_KEYS.has(name) || !isNode(property.value)) continue;
    visit(property.value, isCommand && name === 'label' ? 'command' : kindOf(name), fallback, add);
  }
}

function kindOf(key: string): StringKind | null {
  return Object.hasOwn(KIND_OF_KEY, key) ? (KIND_OF_KEY[key] ?? null) : null;
}

function isSilent(node: SyntaxNode): boolean {
  if (/^(Import|Export(Named|All))/.test(node.type)) return node.source !== null && node.source !== undefined;
  if (node.type.startsWith('TS') && node.type !== 'TSAsExpression' && node.type !== 'TSSatisfiesExpression') return true;
  if (node.type === 'TaggedTemplateExpression') return true;
  if (node.type !== 'CallExpression' && node.type !== 'NewExpression') return false;
  const callee = node.callee as SyntaxNode;
  const name = String(callee.name ?? (callee.property as SyntaxNode | undefined)?.name ?? '');
  return SILENT_CALLS.test(name);
}

function textOf(node: SyntaxNode): string {
  if (node.type === 'Literal') return typeof node.value === 'string' ? node.value : '';
  return (node.quasis as readonly { readonly value: { readonly cooked: string } }[]).map(({ value }) => value.cooked).join('{}');
}

/** The text directly in an element, with `{}` for each child that is not text. */
function jsxWords(node: SyntaxNode): string {
  const parts = (node.children as readonly SyntaxNode[]).map((child) => (child.type === 'JSXText' ? (child.value as string) : '{}'));
  const words = parts.join('').replace(/\s+/g, ' ').trim();
  return /[A-Za-z]{2}/.test(words) ? words : '';
}

/** Whether a string reads as a sentence or label: two words or more, a capital letter or similar at the beginning, and no code. */
function isSentence(text: string): boolean {
  const flat = text.trim();
  if (!/^[“‘A-Z{]/.test(flat) || !/[a-z’”}] [\w“{(&×—–-]/.test(flat)) return false;
  return !/[;=<>[\]_]|=>|\/\/|::|\{\s|^\{\}[^\p{L}]*\{\}|\w\(|\s#|%s|^[A-Z]+ \{/u.test(flat);
}

function hasKeys(node: SyntaxNode, keys: readonly string[]): boolean {
  const names = (node.properties as readonly SyntaxNode[]).map((property) => (property.key as SyntaxNode | undefined)?.name);
  return keys.every((key) => names.includes(key));
}

const HEADER_KINDS: readonly (readonly [key: string, kind: StringKind])[] = [
  ['SCRIM_TITLE', 'title'],
  ['DESCRIPTION', 'doc'],
  ['LABEL', 'label'],
  ['DOC', 'doc'],
];

function readHeader(file: string, text: string): UserString[] {
  const header = /^\s*\/\*([\s\S]*?)\*\//.exec(text)?.[1];
  if (header === undefined) return [];
  const found: UserString[] = [];
  const entry = /"([A-Z_]+)"\s*:\s*("(?:[^"\\]|\\.)*")/g;
  for (const [, key, value] of header.matchAll(entry)) {
    const kind = HEADER_KINDS.find(([name]) => name === key)?.[1];
    if (kind) found.push({ file, kind, text: JSON.parse(value as string) as string });
  }
  return found;
}
