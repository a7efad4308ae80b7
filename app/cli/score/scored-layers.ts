import type { FlatGraph, FlatNode } from '../../../export/compiler/flat-graph.ts';
import { portKey, sourcesAt } from '../../../export/compiler/flat-graph.ts';
import { resolve } from '../../../export/compiler/resolve/resolve.ts';
import { createShaderStore } from '../../../export/compiler/shaders/shader-store.ts';
import { projectLibrary } from '../../../export/graph/library/project-library.ts';
import type { Project } from '../../../export/graph/project.ts';
import { LIBRARY } from '../../services/compile-project.ts';
import type { ScoredLayer } from './score.page.ts';

export interface ScoredLayers {
  readonly layers: readonly ScoredLayer[];
  /** The camera video; null if the output does not show it. */
  readonly camera: string | null;
}

/** The nodes that hide a layer behind the room, with the port of the layer. */
const OCCLUSIONS = { 'layer/depth-occlusion': 'layer', 'operator/sketched-occlusion': 'inputImage' } as const;

/**
 * What of a project can be compared with a recording, in subgraphs, too: each Depth occlusion and Sketched occlusion that the output depends
 * on, by its layer before and after, and the camera video. Each Scene that is not before any of these counts as a layer that nothing hides.
 */
export function scoredLayers(project: Project): ScoredLayers {
  const resolved = resolve(project, projectLibrary(LIBRARY, project.sources, createShaderStore().readDefinition)).output;
  if (resolved === null || resolved.graph.screen === null) return { layers: [], camera: null };
  const used = nodesBehind(resolved.graph, [resolved.graph.screen]);
  const ofType = (type: string): FlatNode[] => used.filter(({ definition }) => definition.type === type);
  const hidden = Object.entries(OCCLUSIONS).flatMap(([type, port]) =>
    ofType(type).flatMap((node) => {
      const [source] = sourcesAt(node, port);
      return source ? [{ whole: portKey(source), shown: `${node.id}.layer` }] : [];
    }),
  );
  const occluded = new Set(nodesBehind(resolved.graph, Object.keys(OCCLUSIONS).flatMap(ofType)));
  const scenes = ofType('layer/scene')
    .filter((node) => !occluded.has(node))
    .map(({ id }) => ({ whole: `${id}.layer`, shown: `${id}.layer` }));
  const [camera] = ofType('source/camera-video');
  return { layers: [...hidden, ...scenes], camera: camera ? `${camera.id}.layer` : null };
}

/** Nodes and all that they depend on. */
function nodesBehind({ nodes }: FlatGraph, ends: readonly FlatNode[]): FlatNode[] {
  const used = new Set(ends);
  // A set yields what is added while it is read.
  for (const { inputs } of used) {
    for (const source of [...inputs.values()].flat()) {
      const node = nodes.get(source.node);
      if (node) used.add(node);
    }
  }
  return [...used];
}
