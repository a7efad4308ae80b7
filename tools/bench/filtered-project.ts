/** The parts of `project.scrim.json` that are changed. */
interface ProjectText {
  readonly graphs: {
    readonly main: {
      readonly nodes: Record<string, { readonly type: string; readonly version: number; readonly params?: object }>;
      readonly wires: readonly string[];
    };
  };
}

/**
 * Returns a project with a filter over all that its screen shows. Without one, the layers of the screen are blended where they are shown;
 * with one, they have to be textures, as in most projects that filter a whole image.
 *
 * @param text `project.scrim.json`.
 *
 * @example
 * filteredProject(await readFile('examples/sketchy-shadow/project.scrim.json', 'utf8'));
 */
export function filteredProject(text: string): string {
  const project = JSON.parse(text) as ProjectText;
  const { nodes, wires } = project.graphs.main;
  const [screen] = Object.entries(nodes).find(([, { type }]) => type === 'output/screen') ?? [];
  const shown = wires.find((wire) => wire.endsWith(` -> ${screen}.layer`));
  if (shown === undefined) throw new Error('The screen of the project shows nothing.');
  const main = {
    ...project.graphs.main,
    nodes: { ...nodes, 'filter-all1': { type: 'filter/sepia', version: 1 } },
    wires: [
      ...wires.filter((wire) => wire !== shown),
      shown.replace(`${screen}.layer`, 'filter-all1.inputImage'),
      `filter-all1.layer -> ${screen}.layer`,
    ],
  };
  return JSON.stringify({ ...project, graphs: { ...project.graphs, main } });
}

/**
 * Returns a project with two filters over one layer, and without antialiasing: as a project that colors its virtual objects alone.
 *
 * @param text `project.scrim.json`.
 * @param layer The layer, as `node.port`.
 *
 * @example
 * filteredObjects(await readFile('examples/shadows-of-real-and-virtual-things/project.scrim.json', 'utf8'), 'scene-f6.layer');
 */
export function filteredObjects(text: string, layer: string): string {
  const project = JSON.parse(text) as ProjectText;
  const { nodes, wires } = project.graphs.main;
  const [screen, output] = Object.entries(nodes).find(([, { type }]) => type === 'output/screen') ?? [];
  if (screen === undefined || output === undefined || !wires.some((wire) => wire.startsWith(`${layer} ->`)))
    throw new Error(`The project does not show ${layer}.`);
  const main = {
    ...project.graphs.main,
    nodes: {
      ...nodes,
      'filter-one1': { type: 'filter/sepia', version: 1 },
      'filter-two1': { type: 'filter/grey', version: 1, params: { amount: 0.5 } },
      [screen]: { ...output, params: { ...output.params, antialias: false } },
    },
    wires: [
      ...wires.map((wire) => wire.replace(`${layer} ->`, 'filter-two1.layer ->')),
      `${layer} -> filter-one1.inputImage`,
      'filter-one1.layer -> filter-two1.inputImage',
    ],
  };
  return JSON.stringify({ ...project, graphs: { ...project.graphs, main } });
}
