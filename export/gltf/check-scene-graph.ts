import { damaged, type GltfDocument } from './document.ts';

/** Rejects nodes that refer to missing nodes or contain themselves, which three.js does not check (glTF 2.0, §3.5.2). */
export function checkSceneGraph({ scenes = [], nodes = [], meshes = [] }: GltfDocument): void {
  if (scenes.some((scene) => scene.nodes?.some((index) => nodes[index] === undefined))) {
    throw damaged('the scene refers to a missing node');
  }
  const parents = new Array<number>(nodes.length).fill(0);
  nodes.forEach(({ children = [], mesh }, i) => {
    if (mesh !== undefined && meshes[mesh] === undefined) throw damaged(`node ${i} refers to a missing mesh`);
    for (const child of children) {
      if (nodes[child] === undefined) throw damaged(`node ${i} refers to a missing node`);
      parents[child] = (parents[child] ?? 0) + 1;
    }
  });
  // Removes nodes from the roots down; nodes that remain are on or below a cycle.
  const free = nodes.flatMap((_, i) => (parents[i] === 0 ? [i] : []));
  for (let taken = 0; taken < free.length; taken++) {
    for (const child of nodes[free[taken] ?? -1]?.children ?? []) {
      const left = (parents[child] ?? 0) - 1;
      parents[child] = left;
      if (left === 0) free.push(child);
    }
  }
  if (free.length < nodes.length) throw damaged(`node ${parents.findIndex((count) => count > 0)} contains itself`);
}
