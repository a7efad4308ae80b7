import type { HostEvent, ProjectFiles } from '../contract/contract.ts';
import { revisionOf } from './project-files.ts';

/**
 * The event for an external change of a folder: the shaders with their texts if nothing else changed, so that the editor applies them
 * at once; else only that the project changed.
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
