import { readDefinition } from '../../export/glsl/read-definition.ts';
import { createInterfaceLookup } from '../../export/graph/library/node-interface.ts';
import { projectLibrary } from '../../export/graph/library/project-library.ts';
import { loadProject } from '../../export/graph/load.ts';
import { type NodeAddress, replaceNodeAddresses } from '../../export/graph/node-addresses.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { ProjectFiles } from '../contract/contract.ts';
import { LIBRARY } from '../services/compile-project.ts';

/**
 * Adds titles to the ids of nodes in a diagnostic: `Sepia (sepia-1a2b)`. Ids stay alone where the files cannot be read as a project or
 * the type of the node is unknown.
 *
 * @returns The diagnostic for people; its `nodeId` is no id anymore.
 */
export function nameNodes(files: ProjectFiles, diagnostics: readonly Diagnostic[]): readonly Diagnostic[] {
  if (diagnostics.length === 0) return diagnostics;
  const { output: project } = loadProject(files);
  if (project === null) return diagnostics;
  const library = projectLibrary(LIBRARY, project.sources, (file, source) => readDefinition(source, file));
  const interfaceOf = createInterfaceLookup(project, library);
  const name = ({ node, path, port }: NodeAddress) => {
    const title = interfaceOf(node.type)?.title;
    const address = port === undefined ? path : `${path}.${port}`;
    return title === undefined ? address : `${title} (${address})`;
  };
  const named = (text: string) => replaceNodeAddresses(project, text, name);
  return diagnostics.map(({ nodeId, message, fix, ...rest }) => ({
    ...rest,
    message: named(message),
    ...(nodeId === undefined ? {} : { nodeId: named(nodeId) }),
    ...(fix === undefined ? {} : { fix: named(fix) }),
  }));
}
