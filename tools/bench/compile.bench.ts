import { createCompiler } from '../../export/compiler/compile.ts';
import { MAIN_GRAPH, type Project } from '../../export/graph/project.ts';
import { type Bench, timeMs } from './bench.ts';
import { chainProject, LIBRARY } from './sample-project.ts';

const NODE_COUNTS = [10, 50, 100, 500, 1000, 5000, 10_000];
const EDITED_NODES = 500;

/**
 * Duration of a recompile with all shaders in the compiler’s cache, as in the editor and with fusion, as for an export; of a compile after
 * one node of 500 was edited, as a share of a compile without a cache. All nodes of the chain affect the output.
 */
export async function benches(): Promise<readonly Bench[]> {
  return [...recompiles(false, 'compile'), ...recompiles(true, 'compile with fusion'), edit()];
}

function recompiles(fuse: boolean, name: string): Bench[] {
  const { compile } = createCompiler();
  const projects = new Map(NODE_COUNTS.map((nodeCount) => [nodeCount, chainProject(nodeCount)]));
  const compileMs = (nodeCount: number) =>
    timeMs(() => {
      const project = projects.get(nodeCount) ?? chainProject(nodeCount);
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

function edit(): Bench {
  const { compile } = createCompiler();
  const compileMs = (project: Project, { compile: by }: { readonly compile: typeof compile }) =>
    timeMs(() => {
      if (!by({ project, library: LIBRARY }).output) throw new Error('The sample project does not compile.');
    });
  let edits = 0;
  return {
    name: `compile after an edit of one node in ${EDITED_NODES}, against a full compile`,
    unit: 'ratio',
    sample: async () => {
      edits++;
      const project = withOwnShader(chainProject(EDITED_NODES), edits);
      return (await compileMs(project, { compile })) / (await compileMs(project, createCompiler()));
    },
  };
}

/** The chain in which one filter is a shader of the project, whose text differs from edit to edit. */
function withOwnShader(project: Project, edits: number): Project {
  const header = { ISFVSN: '2', INPUTS: [{ NAME: 'inputImage', TYPE: 'image' }] };
  const text = `/*${JSON.stringify(header)}*/\nvoid main() { gl_FragColor = IMG_THIS_PIXEL(inputImage) * ${edits}.0; }\n`;
  const main = project.graphs[MAIN_GRAPH];
  if (main === undefined) throw new Error('A project has a main graph.');
  const nodes = { ...main.nodes, 'filter-x250': { type: 'filter/own', version: 1, params: {} } };
  return { ...project, sources: { 'own.fs': text }, graphs: { [MAIN_GRAPH]: { ...main, nodes } } };
}
