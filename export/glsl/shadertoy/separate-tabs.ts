import { type Declared, declaredIn, renameWords, wordsOf } from './rename-words.ts';
import { type Shadertoy, type Tab, tabName } from './shadertoy.ts';

export interface Separated {
  /** Text before all tabs; empty if it was inserted into each. */
  readonly common: string;
  readonly codes: readonly string[];
  /** Macros that each tab defines and that must be undefined at its end. */
  readonly macros: readonly (readonly string[])[];
}

const CHANNEL = /^iChannel[0-3]$/;

/**
 * Makes tabs parts of one text: names that two of them declare are changed in all but the last. `Common` is shared if it does not depend on
 * the tab.
 */
export function separateTabs({ tabs, common }: Pick<Shadertoy, 'tabs' | 'common'>): Separated {
  if (tabs.length < 2) return { common, codes: tabs.map(({ code }) => code), macros: tabs.map(() => []) };
  const shared = declaredIn(common, '');
  const alone = tabs.map(({ code }) => declaredIn(code, common));
  const isShared = !readsChannels(common) && alone.every((tab) => !overlaps(tab, shared));
  const codes = tabs.map(({ code }) => (isShared || common === '' ? code : `${common}\n${code}`));
  const declared = isShared ? alone : codes.map((code) => declaredIn(code, ''));
  const taken = new Set([...codes, common].flatMap((code) => [...wordsOf(code)]));
  const renamed = codes.map((code, i) => {
    const others = declared.filter((_, other) => other !== i);
    const last = i === codes.length - 1;
    const own = declared[i];
    if (!own || last) return code;
    const clashing = [...own.names].filter((name) => name !== 'mainImage' && others.some(({ names }) => names.has(name)));
    const names = new Map(clashing.map((name) => [name, freshName(name, tabs[i] as Tab, taken)]));
    return renameWords(code, names, own.members);
  });
  return { common: isShared ? common : '', codes: renamed, macros: declared.map(({ macros }) => [...macros]) };
}

/**
 * Whether `Common` reads a channel outside of macros, so that it depends on the tab. A macro is no problem: it reads the channel of the tab
 * that uses the macro.
 */
function readsChannels(common: string): boolean {
  const code = common.replace(/^[ \t]*#(?:[^\n\\]|\\[\s\S])*/gm, '');
  return [...wordsOf(code)].some((word) => CHANNEL.test(word));
}

function overlaps(tab: Declared, shared: Declared): boolean {
  return [...tab.names, ...tab.macros].some((name) => shared.names.has(name) || shared.macros.has(name));
}

function freshName(name: string, tab: Tab, taken: Set<string>): string {
  return fresh(`${name}_${tabName(tab).replace(' ', '')}`, taken);
}

/** The requested name, or a similar one that the text does not use. Adds it to `taken`. */
export function fresh(wanted: string, taken: Set<string>): string {
  let name = wanted;
  // Two consecutive underscores are reserved in GLSL.
  for (let number = 2; taken.has(name); number++) name = `${wanted}${number}`;
  taken.add(name);
  return name;
}
