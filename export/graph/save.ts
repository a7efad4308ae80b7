import { LAYOUT_FORMAT, newestVersion, PROJECT_FORMAT } from './document/migrate-document.ts';
import { inline, type PrintableJson, printJson } from './json/print-json.ts';
import type { ProjectTexts } from './load.ts';
import { DEFAULT_PAGE } from './new-project.ts';
import { type Asset, type Binding, type Graph, type GraphLayout, type GraphNode, MAIN_GRAPH, type Project } from './project.ts';
import { sortedEntries } from './record.ts';
import { printWire, sortWires } from './wires.ts';

/**
 * Writes a project as the texts of its files. Equal projects give equal bytes: `main` comes first, then graphs by name, nodes by id, wires
 * by target and params by name. Defaults are left out. `loadProject` reads an equal project back.
 *
 * @returns The texts of `project.scrim.json`, `project.layout.json` and the files in `shaders/`.
 * @throws Error if a number is not finite, which commands and loading prevent.
 *
 * @example
 * const { project: json, layout } = saveProject(project);
 */
export function saveProject(project: Project): ProjectTexts & { readonly layout: string } {
  return { project: saveLogic(project), layout: saveLayout(project), sources: { ...project.sources } };
}

function saveLogic({ title, page, graphs, assets, recipe }: Project): string {
  const pageFields = (['description', 'language', 'poster'] as const).filter((key) => page[key] !== DEFAULT_PAGE[key]);
  return printJson({
    format: PROJECT_FORMAT.format,
    version: newestVersion(PROJECT_FORMAT),
    title,
    ...((pageFields.length > 0 || page.framing) && {
      page: {
        ...Object.fromEntries(pageFields.map((key) => [key, page[key] ?? ''])),
        ...(page.framing && { framing: { ...page.framing } }),
      },
    }),
    graphs: mapMainFirst(graphs, saveGraph),
    ...(Object.keys(assets).length > 0 && { assets: mapSorted(assets, saveAsset) }),
    ...(recipe && { recipe: recipe.keywords.length > 0 ? { keywords: inline(recipe.keywords) } : {} }),
  });
}

function saveGraph({ nodes, wires, exposed }: Graph): PrintableJson {
  const ports = (['inputs', 'outputs'] as const).filter((side) => exposed[side].length > 0);
  return {
    nodes: mapSorted(nodes, saveNode),
    wires: sortWires(wires).map(printWire),
    ...(ports.length > 0 && {
      exposed: Object.fromEntries(ports.map((side) => [side, exposed[side].map(({ name, node, port }) => inline({ name, node, port }))])),
    }),
  };
}

function saveNode({ type, version, muted, unfused, params }: GraphNode): PrintableJson {
  return {
    type,
    version,
    ...(muted === true && { muted }),
    ...(unfused === true && { unfused }),
    ...(Object.keys(params).length > 0 && { params: mapSorted(params, saveBinding) }),
  };
}

export function saveBinding(binding: Binding): PrintableJson {
  if ('value' in binding) return binding.value;
  if ('expression' in binding) return { expression: binding.expression };
  if ('port' in binding) return inline({ port: binding.port });
  const { keys, repeat } = binding.track;
  const saved = keys.map(({ timeS, value, easing }) => inline({ timeS, value, ...(easing !== 'linear' && { easing }) }));
  return { track: { keys: saved, ...(repeat !== 'once' && { repeat }) } };
}

function saveAsset({ path, kind, credit, licence }: Asset): PrintableJson {
  return { path, kind, ...(credit !== undefined && { credit }), ...(licence !== undefined && { licence }) };
}

function saveLayout({ layout }: Project): string {
  return printJson({
    format: LAYOUT_FORMAT.format,
    version: newestVersion(LAYOUT_FORMAT),
    graphs: mapMainFirst(layout, saveGraphLayout),
  });
}

function saveGraphLayout({ nodes, frames, notes, reroutes, routes, borders = {} }: GraphLayout): PrintableJson {
  const some = (record: object) => Object.keys(record).length > 0;
  return {
    ...(some(nodes) && {
      nodes: mapSorted(nodes, ({ x, y, collapsed }) => inline({ x, y, ...(collapsed === true && { collapsed }) })),
    }),
    ...(some(frames) && {
      frames: mapSorted(frames, ({ x, y, width, height, title, color }) =>
        inline({ x, y, width, height, title, ...(color !== undefined && { color }) }),
      ),
    }),
    ...(some(notes) && { notes: mapSorted(notes, ({ x, y, width, height, text }) => inline({ x, y, width, height, text })) }),
    ...(some(reroutes) && { reroutes: mapSorted(reroutes, ({ x, y }) => inline({ x, y })) }),
    ...(some(routes) && { routes: mapSorted(routes, inline) }),
    ...(some(borders) && { borders: mapSorted(borders, ({ x, y }) => inline({ x, y })) }),
  };
}

function mapSorted<T>(record: Readonly<Record<string, T>>, map: (value: T) => PrintableJson): PrintableJson {
  return Object.fromEntries(sortedEntries(record).map(([key, value]) => [key, map(value)]));
}

function mapMainFirst<T>(record: Readonly<Record<string, T>>, map: (value: T) => PrintableJson): PrintableJson {
  const entries = sortedEntries(record);
  const main = entries.filter(([key]) => key === MAIN_GRAPH);
  const others = entries.filter(([key]) => key !== MAIN_GRAPH);
  return Object.fromEntries([...main, ...others].map(([key, value]) => [key, map(value)]));
}
