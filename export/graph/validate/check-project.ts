import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { assetPathProblem } from '../asset-path.ts';
import { usesOfGraphs } from '../liveness.ts';
import { MAIN_GRAPH, type ProjectLogic } from '../project.ts';
import { findCycles } from '../topology.ts';

/** Asset paths must be inside the project folder. */
export function checkAssetPaths(project: ProjectLogic): Diagnostic[] {
  return Object.entries(project.assets).flatMap(([id, { path }]): Diagnostic[] => {
    const problem = assetPathProblem(path);
    if (problem === null) return [];
    const shown = JSON.stringify(path.slice(0, 120));
    const message = `The path ${shown} of the asset ${id} is invalid: ${problem}.`;
    return [{ code: 'SCR031', severity: 'error', message, fix: 'Import the file again.' }];
  });
}

/**
 * No subgraph may contain itself, directly or through others. The main graph must not expose ports.
 *
 * @example
 * // `glow` contains a node of the type `graph/glow`.
 * checkGraphs(project)[0]?.message; // 'A subgraph contains itself: glow → glow.'
 */
export function checkGraphs(project: ProjectLogic): Diagnostic[] {
  const uses = usesOfGraphs(project);
  const cycles = findCycles(uses.keys(), (name) => uses.get(name) ?? []);
  const diagnostics = cycles.map((cycle): Diagnostic => {
    const loop = [...cycle, cycle[0]].join(' → ');
    return {
      code: 'SCR020',
      severity: 'error',
      message: `A subgraph contains itself: ${loop}.`,
      fix: 'Delete the node that closes the loop.',
    };
  });
  const { inputs = [], outputs = [] } = project.graphs[MAIN_GRAPH]?.exposed ?? {};
  if (inputs.length + outputs.length > 0) {
    diagnostics.push({ code: 'SCR020', severity: 'warning', message: 'The main graph exposes ports, which only subgraphs can do.' });
  }
  return diagnostics;
}
