import { canConnect } from '../../../export/graph/can-connect.ts';
import { type Change, sequence, unchanged } from '../../../export/graph/commands/change.ts';
import { addNode } from '../../../export/graph/commands/node-commands.ts';
import { connect } from '../../../export/graph/commands/wire-commands.ts';
import { makeNodeId } from '../../../export/graph/document-names.ts';
import type { PortAddress, Project } from '../../../export/graph/project.ts';
import { getOwn } from '../../../export/graph/record.ts';
import type { NodeLibrary } from '../../../nodes/kit/definition.ts';
import type { WireType } from '../../../nodes/kit/wire-types.ts';

/** Wire types with one obvious source in most graphs. For layers and objects only the user can choose. */
const SHARED: readonly WireType[] = ['depth', 'lights'];
const LEFT_PX = 240;
const BELOW_PX = 72;

interface AutoConnectContext {
  readonly library: NodeLibrary;
  readonly graph: string;
  readonly random: () => number;
}

/**
 * Connects required inputs of a new node if the source is unambiguous: the only one in the graph. Without one, adds the only node
 * type of the library that outputs this wire type.
 */
export function autoConnect(node: string, { library, graph, random }: AutoConnectContext): (project: Project) => Change {
  return (project) => {
    const type = getOwn(project.graphs[graph]?.nodes ?? {}, node)?.type ?? '';
    const wanting = Object.entries(library.definition(type)?.inputs ?? {}).filter(
      ([, port]) => port.required && SHARED.includes(port.type),
    );
    const steps = wanting.map(([port, { type: wanted }]) => (before: Project): Change => {
      const to = { node, port };
      const graphNow = before.graphs[graph];
      if (!graphNow || graphNow.wires.some((wire) => wire.to.node === node && wire.to.port === port)) return unchanged(before);
      const known = sourcesOf(before, library, graph, wanted).filter((from) => canConnect(before, library, graph, from, to).ok);
      const [only] = known;
      if (only && known.length === 1) return connect(before, { library, graph, from: only, to });
      return known.length === 0 ? addSource(before, to, wanted, { library, graph, random }) : unchanged(before);
    });
    return sequence(project, ...steps);
  };
}

function addSource(project: Project, to: PortAddress, wanted: WireType, { library, graph, random }: AutoConnectContext): Change {
  const types = [...library.types()].flatMap((type) => {
    const definition = library.definition(type);
    const output = Object.entries(definition?.outputs ?? {}).find(([, port]) => port.type === wanted)?.[0];
    const standsAlone = Object.values(definition?.inputs ?? {}).every(({ required }) => !required);
    return output !== undefined && standsAlone ? [{ type, output }] : [];
  });
  const [only] = types;
  if (!only || types.length !== 1) return unchanged(project);
  const id = makeNodeId(project, only.type, random);
  const { x, y } = getOwn(project.layout[graph]?.nodes ?? {}, to.node) ?? { x: 0, y: 0 };
  return sequence(
    project,
    (before) => addNode(before, { library, graph, id, type: only.type, x: x - LEFT_PX, y: y + BELOW_PX }),
    (before) => connect(before, { library, graph, from: { node: id, port: only.output }, to }),
  );
}

function sourcesOf(project: Project, library: NodeLibrary, graph: string, wanted: WireType): PortAddress[] {
  return Object.entries(project.graphs[graph]?.nodes ?? {}).flatMap(([id, { type }]) =>
    Object.entries(library.definition(type)?.outputs ?? {}).flatMap(([port, output]) =>
      output.type === wanted ? [{ node: id, port }] : [],
    ),
  );
}
