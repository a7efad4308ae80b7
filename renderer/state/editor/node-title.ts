import type { GraphNode, Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import { CAPTURE_FILE } from '../../../nodes/kit/capture.ts';
import type { NodeDefinition, NodeLibrary } from '../../../nodes/kit/definition.ts';

/**
 * The name of a node wherever the editor writes one: the name of its file for a source with one file, else the title of its type, or the
 * type itself if that is unknown.
 *
 * @example
 * nodeTitle({ type: 'filter/sepia', version: 1, params: {} }, library, {}); // 'Sepia'
 */
export function nodeTitle(node: GraphNode, library: Pick<NodeLibrary, 'definition'>, assets: Project['assets']): string {
  const definition = library.definition(node.type);
  return definition === undefined ? node.type : (fileOf(node, definition, assets) ?? definition.title);
}

/** The name of the file of an asset, without its folder. All captures have a document of the same name, so a capture has that of its folder. */
export function fileTitle(path: string): string {
  const [folder = path, file = folder] = path.split('/').slice(-2);
  return file === CAPTURE_FILE ? folder.replace(/\.capture$/, '') : file;
}

/** Name of the file of a source with one file; null for other nodes. */
function fileOf({ type, params }: GraphNode, definition: NodeDefinition, assets: Project['assets']): string | null {
  if (!type.startsWith('source/')) return null;
  const [name, ...others] = Object.keys(definition.params).filter((param) => definition.params[param]?.type === 'asset');
  const binding = name === undefined || others.length > 0 ? undefined : getOwn(params, name);
  const path = binding && 'value' in binding ? getOwn(assets, String(binding.value))?.path : undefined;
  return path === undefined ? null : fileTitle(path);
}
