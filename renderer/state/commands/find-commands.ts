import { searchable } from '../../spellings.ts';
import type { Editor } from '../editor/editor.ts';
import { type PaletteEntry, searchPalette } from '../graph/palette-search.ts';
import type { AppCommand } from './app-command.ts';
import { type AppCommandId, appCommand, appCommandIds } from './app-commands.ts';

/** Rank that disabled commands get in addition, so that they come last. */
const DISABLED = 10;

/** The commands whose label or keywords contain all words of the query; the closest first, disabled ones last. */
export function findCommands(editor: Editor, query: string): readonly AppCommandId[] {
  const words = searchable(query).split(/\s+/).filter(Boolean);
  const matches = appCommandIds().filter((id) => id !== 'help.commands' && matchesAll(appCommand(id), words));
  const rank = (id: AppCommandId) => (appCommand(id).enabled(editor) ? 0 : DISABLED) + distance(appCommand(id).label, words);
  return [...matches].sort((a, b) => rank(a) - rank(b));
}

/** Node types that the list of commands shows at most. */
const MAX_NODES = 5;

/** The node types that fit the query best, few enough to stand below the commands. */
export function findNodes({ document }: Editor, query: string): readonly PaletteEntry[] {
  const { library } = document.getState();
  const definitions = [...library.types()].flatMap((type) => library.definition(type) ?? []);
  return query.trim() === '' ? [] : searchPalette(definitions, query, null).slice(0, MAX_NODES);
}

/** Rank of a match: 0 if the label begins with the first typed word, 1 if another of its words does, else 2. */
function distance(label: string, [first = '']: readonly string[]): number {
  const text = searchable(label);
  return text.startsWith(first) ? 0 : text.includes(` ${first}`) ? 1 : 2;
}

function matchesAll({ label, keywords = [] }: AppCommand, words: readonly string[]): boolean {
  const text = searchable([label, ...keywords].join('\n'));
  return words.every((word) => text.includes(word));
}
