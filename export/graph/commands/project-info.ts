import { castDraft } from 'immer';
import type { PosterFraming } from '../../../nodes/kit/poster-framing.ts';
import type { PageInfo, Project } from '../project.ts';
import { type Change, change } from './change.ts';

/**
 * Sets the title of the project.
 *
 * @returns The change; this command is never refused.
 *
 * @example
 * setTitle(project, { title: 'Fog in the kitchen' });
 */
export function setTitle(project: Project, { title }: { readonly title: string }): Change {
  return change(project, (draft) => {
    draft.title = title;
  });
}

/**
 * Sets description and language of the exported page. Missing fields stay.
 *
 * @returns The change; this command is never refused.
 *
 * @example
 * setPage(project, { page: { language: 'de' } });
 */
export function setPage(project: Project, { page }: { readonly page: Partial<Omit<PageInfo, 'poster' | 'framing'>> }): Change {
  return change(project, (draft) => {
    Object.assign(draft.page, page);
  });
}

/**
 * Sets the words by which the palette finds a recipe, besides its title and description.
 *
 * @returns The change; this command is never refused.
 *
 * @example
 * setKeywords(project, { keywords: ['film', 'grain'] });
 */
export function setKeywords(project: Project, { keywords }: { readonly keywords: readonly string[] }): Change {
  return change(project, (draft) => {
    draft.recipe = { keywords: [...keywords] };
  });
}

/**
 * Chooses the poster of the exported page; null: each export draws one.
 *
 * @returns The change; this command is never refused.
 *
 * @example
 * setPoster(project, { path: 'assets/poster.jpg' });
 */
export function setPoster(project: Project, { path }: { readonly path: string | null }): Change {
  return change(project, (draft) => {
    if (path === null) delete draft.page.poster;
    else draft.page.poster = path;
  });
}

/**
 * Chooses what the poster of the exported page shows, and lets each export draw it; null: it shows the objects.
 *
 * @returns The change; this command is never refused.
 *
 * @example
 * setFraming(project, { framing: { center: [0, 0], height: 0.8 } });
 */
export function setFraming(project: Project, { framing }: { readonly framing: PosterFraming | null }): Change {
  return change(project, (draft) => {
    delete draft.page.poster;
    if (framing === null) delete draft.page.framing;
    else draft.page.framing = castDraft(framing);
  });
}

/**
 * Replaces the whole project, such as by its saved version.
 *
 * @returns The change, with patches of the parts that differ; this command is never refused.
 *
 * @example
 * replaceProject(project, saved);
 */
export function replaceProject(project: Project, next: Project): Change {
  return change(project, (draft) => {
    Object.assign(draft, castDraft(next));
  });
}
