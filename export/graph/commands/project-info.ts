import type { PageInfo, Project } from '../project.ts';
import { type Change, change } from './change.ts';

export function setTitle(project: Project, { title }: { readonly title: string }): Change {
  return change(project, (draft) => {
    draft.title = title;
  });
}

/** What the exported page says about itself; fields left out stay. */
export function setPage(project: Project, { page }: { readonly page: Partial<PageInfo> }): Change {
  return change(project, (draft) => {
    Object.assign(draft.page, page);
  });
}
