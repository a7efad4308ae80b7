import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { ProgramCredit } from '../program/program.ts';
import type { PreparedAsset } from './assets/prepare-assets.ts';

/** A work on the page, and its terms. */
export type PageCredit = Omit<ProgramCredit, 'nodes'>;

export const LICENCES_FILE = 'LICENSES.txt';

/** The program's works, and what its models say of themselves (glTF's `asset.copyright`) where the project says nothing of them. */
export function pageCredits(credits: readonly ProgramCredit[], assets: readonly PreparedAsset[]): ProgramCredit[] {
  const named = new Set(credits.filter(({ kind }) => kind === 'asset').map(({ title }) => title));
  const models = assets.flatMap(({ asset, copyright }): ProgramCredit[] =>
    copyright === '' || named.has(asset.path) ? [] : [{ title: asset.path, kind: 'asset', credit: copyright, licence: '', nodes: [] }],
  );
  return [...credits, ...models];
}

/** Whether works under it may not be used for money. */
export function isNonCommercial(licence: string): boolean {
  return /\bNC\b|non-?\s?commercial/i.test(licence);
}

/** A warning for each work that a page for money must not have. */
export function licenceWarnings(credits: readonly ProgramCredit[]): Diagnostic[] {
  return credits.flatMap(({ title, credit, licence, nodes: [nodeId] }): Diagnostic[] => {
    // glTF's copyright holds the terms, too.
    const terms = licence || credit;
    if (!isNonCommercial(terms)) return [];
    const message = `“${title}” must not be used commercially: its license is ${terms}.`;
    const fix = 'Ask its author for permission, use another work, or publish the page non-commercially.';
    return [{ code: 'SCR046', severity: 'warning', message, fix, ...(nodeId === undefined ? {} : { nodeId }) }];
  });
}

export function licencesText(title: string, credits: readonly PageCredit[]): string {
  const works = credits.map(({ title: work, credit, licence }) =>
    [work, ...(credit === '' ? [] : [`  Credit: ${credit}`]), ...(licence === '' ? [] : [`  License: ${licence}`])].join('\n'),
  );
  return `Works in “${title}”\n\n${works.join('\n\n')}\n\nThe licenses of program libraries are at the end of the page's script.\n`;
}
