import type { ProgramCredit } from '../program/program-credit.ts';
import { element } from './dom.ts';

export type Credit = Omit<ProgramCredit, 'nodes'>;

const ADDRESS = /(https?:\/\/[^\s,;)]+)/;

/** Creates a disclosure element with the credits; an empty array if there are none. */
export function createCredits(document: Document, credits: readonly Credit[]): HTMLElement[] {
  if (credits.length === 0) return [];
  const works = credits.map(({ title, credit, licence }) => {
    const texts = [credit, licence].filter((text) => text !== '').flatMap((text) => [' ', ...sentence(document, text)]);
    return element(document, 'li', {}, element(document, 'strong', {}, fileName(title)), ...texts);
  });
  const list = element(document, 'ul', {}, ...works);
  return [element(document, 'details', { className: 'credits' }, element(document, 'summary', {}, 'Credits'), list)];
}

/** Converts the addresses in a text to links and adds a full stop. */
function sentence(document: Document, text: string): (Node | string)[] {
  const parts = text.split(ADDRESS).map((part) => {
    if (!ADDRESS.test(part)) return part;
    return element(document, 'a', { attributes: { href: part, target: '_blank', rel: 'noopener noreferrer' } }, part);
  });
  return /[.!?]$/.test(text) ? parts : [...parts, '.'];
}

/** Removes folders from an asset path. */
function fileName(title: string): string {
  return title.slice(title.lastIndexOf('/') + 1);
}
