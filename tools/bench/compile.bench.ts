import { createCompiler } from '../../export/compiler/compile.ts';
import { type Bench, timeMs } from './bench.ts';
import { chainProject, LIBRARY } from './sample-project.ts';

const NODE_COUNTS = [10, 100, 1000, 10_000];

/** Duration of a recompile with all shaders in the compiler’s cache. All nodes of the chain affect the output. */
export async function benches(): Promise<readonly Bench[]> {
  const { compile } = createCompiler();
  const projects = new Map(NODE_COUNTS.map((nodeCount) => [nodeCount, chainProject(nodeCount)]));
  const compileMs = (nodeCount: number) =>
    timeMs(() => {
      const project = projects.get(nodeCount) ?? chainProject(nodeCount);
      if (!compile({ project, library: LIBRARY }).output) throw new Error('The sample project does not compile.');
    });
  const perSize = NODE_COUNTS.map(
    (nodeCount): Bench => ({
      name: `compile, ${nodeCount} nodes`,
      unit: 'ms',
      samples: nodeCount < 10_000 ? 15 : 5,
      sample: () => compileMs(nodeCount),
    }),
  );
  // 10 if the time is proportional to the number of nodes; 100 if to its square.
  const growth = NODE_COUNTS.slice(1).map(
    (nodeCount): Bench => ({
      name: `compile, ${nodeCount} nodes against ${nodeCount / 10}`,
      unit: 'ratio',
      samples: nodeCount < 10_000 ? 15 : 5,
      sample: async () => (await compileMs(nodeCount)) / (await compileMs(nodeCount / 10)),
    }),
  );
  return [...perSize, ...growth];
}
