import { loadProject } from '../../export/graph/load.ts';
import { saveProject } from '../../export/graph/save.ts';
import { validateProject } from '../../export/graph/validate/validate.ts';
import { type Bench, timeMs } from './bench.ts';
import { chainProject, LIBRARY } from './sample-project.ts';

/** Duration of opening a project, without the compile. */
export async function benches(): Promise<readonly Bench[]> {
  return [10, 100, 1000, 10_000].map((nodeCount): Bench => {
    const texts = saveProject(chainProject(nodeCount));
    return {
      name: `load and validate, ${nodeCount} nodes`,
      unit: 'ms',
      sample: () =>
        timeMs(() => {
          const { output } = loadProject(texts);
          if (!output) throw new Error('The sample project cannot be read.');
          return validateProject(output, LIBRARY);
        }),
    };
  });
}
