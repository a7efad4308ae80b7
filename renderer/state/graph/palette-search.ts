import { categoryLabel } from '../../../nodes/kit/categories.ts';
import { type NodeDefinition, paramWireType } from '../../../nodes/kit/definition.ts';
import { conversion, type WireType } from '../../../nodes/kit/wire-types.ts';
import { searchable } from '../../spellings.ts';
import type { OpenEnd } from '../editor/canvas-state.ts';

export interface PaletteEntry {
  readonly definition: NodeDefinition;
  /** The port that the dragged wire would connect to; null without a dragged wire. */
  readonly port: string | null;
}

/** Scores of a match. The best match of each word counts, and every word must match. */
const SCORES = {
  titleStart: 100,
  titleWord: 80,
  name: 70,
  keyword: 65,
  keywordStart: 60,
  category: 50,
  keywordPart: 45,
  titlePart: 40,
  doc: 10,
  letters: 4,
  none: 0,
};

/**
 * Searches node types for the palette, best match first. An empty query lists all by category and title. With a dragged wire, only
 * types with a fitting port.
 */
export function searchPalette(definitions: readonly NodeDefinition[], query: string, end: OpenEnd | null): PaletteEntry[] {
  const words = searchable(query).split(/\s+/).filter(Boolean);
  const found: { entry: PaletteEntry; score: number }[] = [];
  for (const definition of definitions) {
    const port = end === null ? null : fittingPort(definition, end);
    if (end !== null && port === null) continue;
    const score = scoreOf(definition, words);
    if (score > 0) found.push({ entry: { definition, port }, score });
  }
  const byCategory = words.length === 0;
  return found
    .sort((a, b) => {
      const category = byCategory ? compare(categoryOf(a.entry.definition), categoryOf(b.entry.definition)) : 0;
      return b.score - a.score || category || compare(a.entry.definition.title, b.entry.definition.title);
    })
    .map(({ entry }) => entry);
}

/** An entry of the list, and the heading of its section. */
export interface ListedEntry extends PaletteEntry {
  readonly section: string;
}

/**
 * The list of the palette: with a query the best matches, else the favorites, the types that were added last, and all by category.
 *
 * @param first Label of a category that is listed before all others, favorites included.
 */
export function listPalette(
  entries: readonly PaletteEntry[],
  query: string,
  favorites: readonly string[],
  recent: readonly string[],
  first: string | null = null,
): readonly ListedEntry[] {
  const all = entries.map((entry) => ({ ...entry, section: categoryOf(entry.definition) }));
  if (query.trim() !== '') return all;
  const pick = (types: readonly string[], section: string) =>
    types.flatMap((type): ListedEntry[] => {
      const entry = entries.find(({ definition }) => definition.type === type);
      return entry ? [{ ...entry, section }] : [];
    });
  const fresh = recent.filter((type) => !favorites.includes(type));
  const leading = all.filter(({ section }) => section === first);
  const others = all.filter(({ section }) => section !== first);
  return [...leading, ...pick(favorites, 'Favorites'), ...pick(fresh, 'Recent'), ...others];
}

/** The first port of the same wire type, else the first that converts without loss. */
export function fittingPort(definition: NodeDefinition, end: OpenEnd): string | null {
  const candidates = end.side === 'output' ? inputsOf(definition) : outputsOf(definition);
  const kinds = candidates.map(
    ([name, type]) => [name, end.side === 'output' ? conversion(end.type, type) : conversion(type, end.type)] as const,
  );
  return (kinds.find(([, kind]) => kind === 'same') ?? kinds.find(([, kind]) => kind === 'lossless'))?.[0] ?? null;
}

/** Label of the category of a node type. */
export function categoryOf(definition: NodeDefinition): string {
  return categoryLabel(definition.type);
}

function inputsOf(definition: NodeDefinition): [string, WireType][] {
  const wireable = Object.entries(definition.params).flatMap(([name, param]): [string, WireType][] => {
    const type = paramWireType(param);
    return type === undefined ? [] : [[name, type]];
  });
  return [...Object.entries(definition.inputs).map(([name, port]): [string, WireType] => [name, port.type]), ...wireable];
}

function outputsOf(definition: NodeDefinition): [string, WireType][] {
  return Object.entries(definition.outputs).map(([name, port]) => [name, port.type]);
}

function scoreOf(definition: NodeDefinition, words: readonly string[]): number {
  if (words.length === 0) return 1;
  let total = 0;
  for (const word of words) {
    const score = scoreOfWord(definition, word);
    if (score === 0) return 0;
    total += score;
  }
  return total / words.length;
}

function scoreOfWord(definition: NodeDefinition, word: string): number {
  const title = searchable(definition.title);
  const keywords = (definition.keywords ?? []).map(searchable);
  const match = matchOf(definition, title, keywords, word);
  if (match === 'none') return 0;
  // Among titles that begin with the word, shorter ones come first; else node types with fewer params.
  const size = match === 'titleStart' ? title.length : Object.keys(definition.params).length + title.length / 1000;
  return SCORES[match] + 1 / (1 + size);
}

function matchOf(definition: NodeDefinition, title: string, keywords: readonly string[], word: string): keyof typeof SCORES {
  if (title.startsWith(word)) return 'titleStart';
  if (hasWord(title, word)) return 'titleWord';
  if (definition.type.split('/')[1]?.startsWith(word)) return 'name';
  if (keywords.includes(word)) return 'keyword';
  if (keywords.some((keyword) => hasWord(keyword, word))) return 'keywordStart';
  if (categoryOf(definition).startsWith(word) || definition.type.startsWith(word)) return 'category';
  if (keywords.some((keyword) => keyword.includes(word))) return 'keywordPart';
  if (title.includes(word)) return 'titlePart';
  if (word.length > 3 && hasWord(searchable(definition.doc), word)) return 'doc';
  return word.length > 2 && hasLettersInOrder(title, word) ? 'letters' : 'none';
}

function hasWord(text: string, start: string): boolean {
  return text.split(/[^\p{L}\p{N}]+/u).some((word) => word.startsWith(start));
}

/** Whether the text contains the letters in order: `gsb` finds “Gaussian blur”. The first letter must match. */
function hasLettersInOrder(text: string, letters: string): boolean {
  let at = 0;
  for (const letter of letters) {
    at = text.indexOf(letter, at) + 1;
    if (at === 0) return false;
  }
  return text[0] === letters[0];
}

function compare(a: string, b: string): number {
  return a < b ? -1 : a > b ? 1 : 0;
}
