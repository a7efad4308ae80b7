import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { ProgramCredit } from '../program/program-credit.ts';
import type { PreparedAsset } from './assets/prepared-asset.ts';

/** A work on the page and its license. */
export type PageCredit = Omit<ProgramCredit, 'nodes'>;

export const LICENCES_FILE = 'LICENSES.txt';

/** Credits of the program, and of its models (glTF's `asset.copyright`) if the project has no credit for them. */
export function pageCredits(credits: readonly ProgramCredit[], assets: readonly PreparedAsset[]): ProgramCredit[] {
  const named = new Set(credits.filter(({ kind }) => kind === 'asset').map(({ title }) => title));
  const models = assets.flatMap(({ asset, copyright }): ProgramCredit[] =>
    copyright === '' || named.has(asset.path) ? [] : [{ title: asset.path, kind: 'asset', credit: copyright, licence: '', nodes: [] }],
  );
  return [...credits, ...models];
}

/** Whether the license forbids commercial use. */
export function isNonCommercial(licence: string): boolean {
  return /\bNC\b|non-?\s?commercial/i.test(licence);
}

/** A warning for each work with a non-commercial license. */
export function licenceWarnings(credits: readonly ProgramCredit[]): Diagnostic[] {
  return credits.flatMap(({ title, credit, licence, nodes: [nodeId] }): Diagnostic[] => {
    // glTF's copyright contains the license too.
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
