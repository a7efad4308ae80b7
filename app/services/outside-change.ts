import type { HostEvent, ProjectFiles } from '../contract/contract.ts';
import { revisionOf } from './project-files.ts';

/**
 * What to tell a window of a folder that somebody else has written: which shaders, with their texts, where nothing else has
 * changed, so that they are seen at once; else only that it changed.
 */
export function outsideChange(projectId: string, before: ProjectFiles, now: ProjectFiles): HostEvent {
  const revision = revisionOf(now);
  if (before.project !== now.project || before.layout !== now.layout)
    return { kind: 'project-changed-outside', handle: projectId, revision };
  const names = new Set([...Object.keys(before.sources), ...Object.keys(now.sources)]);
  const shaders = [...names]
    .filter((file) => before.sources[file] !== now.sources[file])
    .sort()
    .map((file) => ({ file, before: before.sources[file] ?? null, text: now.sources[file] ?? null }));
  return { kind: 'shaders-changed-outside', handle: projectId, from: revisionOf(before), revision, shaders };
}
