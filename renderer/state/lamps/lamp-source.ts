import { getOwn } from '../../../export/graph/record.ts';
import type { ParamValue } from '../../../nodes/kit/definition.ts';
import { type LampOptions, lampOptionsOf } from '../../../nodes/kit/panorama/lamp-options.ts';
import { type DocumentState, graphOf, nodeOf } from '../editor/document.ts';
import { boundValue } from '../params/value-text.ts';

/** The node type whose inspector shows a panorama. */
export const LAMPS_TYPE = 'light/from-panorama';

/** A panorama of the project, and how a node searches it. */
export interface LampSource {
  readonly path: string;
  readonly options: LampOptions;
}

/** The panorama that a node of the open graph searches; null if it is not a file of the project, and is thus known only to the page. */
export function lampSourceOf(state: DocumentState, node: string): LampSource | null {
  const definition = state.library.definition(LAMPS_TYPE);
  const params = nodeOf(state, node)?.params;
  const wire = graphOf(state).wires.find(({ to }) => to.node === node && to.port === 'environment');
  const source = wire && nodeOf(state, wire.from.node);
  if (!definition || !params || source?.type !== 'source/panorama') return null;
  const file = getOwn(source.params, 'file');
  const id = file && 'value' in file ? String(file.value) : '';
  const path = getOwn(state.project.assets, id)?.path;
  if (path === undefined) return null;
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
  return { path, options };
}
