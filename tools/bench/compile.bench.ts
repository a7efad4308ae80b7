import { createCompiler } from '../../export/compiler/compile.ts';
import { type GraphNode, MAIN_GRAPH, type Project } from '../../export/graph/project.ts';
import { type Bench, timeMs } from './bench.ts';
import { chainProject, LIBRARY } from './sample-project.ts';

const NODE_COUNTS = [10, 50, 100, 500, 1000, 5000, 10_000];
const EDITED_NODES = 500;

/**
 * Duration of a recompile with all shaders in the compiler’s cache, as in the editor and with fusion, as for an export; of a compile after
 * one node of 500 was edited, as a share of a compile without a cache. All nodes of the chain affect the output.
 */
export async function benches(): Promise<readonly Bench[]> {
  const chain = chainProject(EDITED_NODES);
  const edits = [
    // The shader of the node. What else is edited compiles all nodes, but links no shader again; a value of a uniform param compiles nothing.
    edit('an edit of one node', (count) => withOwnShader(chain, count)),
    edit('muting one node', (count) => withMutedNode(chain, count % 2 === 0)),
  ];
  return [...recompiles(false, 'compile'), ...recompiles(true, 'compile with fusion'), ...edits];
}

function recompiles(fuse: boolean, name: string): Bench[] {
  const { compile } = createCompiler();
  let compiles = 0;
  const projects = new Map(NODE_COUNTS.map((nodeCount) => [nodeCount, chainProject(nodeCount)]));
  const compileMs = (nodeCount: number) =>
    timeMs(() => {
      compiles++;
      // Of an unchanged project, the compiler would keep the schedule.
      const project = { ...(projects.get(nodeCount) ?? chainProject(nodeCount)), title: `Chain ${compiles}` };
      if (!compile({ project, library: LIBRARY, options: { fuse } }).output) throw new Error('The sample project does not compile.');
    });
  const samplesOf = (nodeCount: number) => (nodeCount < 5000 ? 15 : 7);
  const perSize = NODE_COUNTS.map(
    (nodeCount): Bench => ({
      name: `${name}, ${nodeCount} nodes`,
      unit: 'ms',
      samples: samplesOf(nodeCount),
      sample: () => compileMs(nodeCount),
    }),
  );
  // 10 if the time is proportional to the number of nodes; 100 if to its square.
  const growth = NODE_COUNTS.filter((nodeCount) => NODE_COUNTS.includes(nodeCount / 10)).map(
    (nodeCount): Bench => ({
      name: `${name}, ${nodeCount} nodes against ${nodeCount / 10}`,
      unit: 'ratio',
      samples: samplesOf(nodeCount),
      sample: async () => (await compileMs(nodeCount)) / (await compileMs(nodeCount / 10)),
    }),
  );
  return [...perSize, ...growth];
}

function edit(name: string, edited: (edits: number) => Project): Bench {
  const { compile } = createCompiler();
  const compileMs = (project: Project, { compile: by }: { readonly compile: typeof compile }) =>
    timeMs(() => {
      if (!by({ project, library: LIBRARY }).output) throw new Error('The sample project does not compile.');
    });
  let edits = 0;
  return {
    name: `compile after ${name} in ${EDITED_NODES}, against a full compile`,
    unit: 'ratio',
    sample: async () => {
      edits++;
      const project = edited(edits);
      return (await compileMs(project, { compile })) / (await compileMs(project, createCompiler()));
    },
  };
}

/** The chain in which one filter is a shader of the project, whose text differs from edit to edit. */
function withOwnShader(project: Project, edits: number): Project {
  const header = { ISFVSN: '2', INPUTS: [{ NAME: 'inputImage', TYPE: 'image' }] };
  const text = `/*${JSON.stringify(header)}*/\nvoid main() { gl_FragColor = IMG_THIS_PIXEL(inputImage) * ${edits}.0; }\n`;
  return { ...withNode(project, 'filter-x250', { type: 'filter/own', version: 1, params: {} }), sources: { 'own.fs': text } };
}

function withMutedNode(project: Project, muted: boolean): Project {
  return withNode(project, 'filter-x250', { type: 'filter/sepia', version: 1, params: {}, muted });
}

function withNode(project: Project, id: string, node: GraphNode): Project {
  const main = project.graphs[MAIN_GRAPH];
  if (main === undefined) throw new Error('A project has a main graph.');
  return { ...project, graphs: { [MAIN_GRAPH]: { ...main, nodes: { ...main.nodes, [id]: node } } } };
}
