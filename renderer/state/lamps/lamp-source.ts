import type { GraphNode } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { ParamValue } from '../../../nodes/kit/definition.ts';
import { type LampOptions, lampOptionsOf } from '../../../nodes/kit/panorama/lamp-options.ts';
import { type DocumentState, graphOf, nodeOf } from '../editor/document.ts';
import { boundValue } from '../params/value-text.ts';

/** The node type whose inspector shows a panorama. */
export const LAMPS_TYPE = 'light/from-panorama';

/** A panorama of the project, and how a node searches it. */
export interface LampSource {
  /** Its file, or those of its shots. */
  readonly paths: readonly string[];
  /** Of shots: their difference in stops; 0 to measure it. */
  readonly stopsApart: number;
  readonly options: LampOptions;
}

/** The panorama that a node of the open graph searches; null if it is not a file of the project, and is thus known only to the page. */
export function lampSourceOf(state: DocumentState, node: string): LampSource | null {
  const definition = state.library.definition(LAMPS_TYPE);
  const params = nodeOf(state, node)?.params;
  const wire = graphOf(state).wires.find(({ to }) => to.node === node && to.port === 'environment');
  const source = wire && nodeOf(state, wire.from.node);
  const files = source && filesOf(state, source);
  if (!definition || !params || !files || files.paths.length === 0) return null;
  const readParam = (name: keyof LampOptions): ParamValue | undefined => {
    const param = definition.params[name];
    return param && boundValue(param, getOwn(params, name));
  };
  const options = lampOptionsOf({
    method: readParam('method'),
    lamps: readParam('lamps'),
    iterations: readParam('iterations'),
    intensities: readParam('intensities'),
    clippedShare: readParam('clippedShare'),
  });
  return { ...files, options };
}

/** The nodes whose param `file` is a panorama. Capture panorama shows it until one is taken. */
const FILE_SOURCES: ReadonlySet<string> = new Set(['source/panorama', 'source/panorama-capture']);

/** The panorama files of a source; null for other nodes. */
function filesOf(state: DocumentState, { type, params }: GraphNode): Pick<LampSource, 'paths' | 'stopsApart'> | null {
  const isMerged = type === 'source/panorama-exposures';
  if (!isMerged && !FILE_SOURCES.has(type)) return null;
  const definition = state.library.definition(type);
  const readOwn = (name: string): ParamValue | undefined => {
    const param = definition?.params[name];
    return param && boundValue(param, getOwn(params, name));
  };
  const names = ['file', ...(isMerged ? ['file2'] : []), ...(isMerged && readOwn('shots') === '3' ? ['file3'] : [])];
  const paths = names.flatMap((name) => getOwn(state.project.assets, String(readOwn(name)))?.path ?? []);
  return { paths, stopsApart: isMerged ? Number(readOwn('stopsApart')) : 0 };
}
