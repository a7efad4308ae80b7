import { damaged, type GltfDocument } from './document.ts';

/** Refuses nodes that name what is not there, or hang from themselves: three walks them without looking (glTF 2.0, §3.5.2). */
export function checkSceneGraph({ scenes = [], nodes = [], meshes = [] }: GltfDocument): void {
  if (scenes.some((scene) => scene.nodes?.some((index) => nodes[index] === undefined))) {
    throw damaged('its scene names a node that is not there');
  }
  const parents = new Array<number>(nodes.length).fill(0);
  nodes.forEach(({ children = [], mesh }, i) => {
    if (mesh !== undefined && meshes[mesh] === undefined) throw damaged(`its node ${i} names a mesh that is not there`);
    for (const child of children) {
      if (nodes[child] === undefined) throw damaged(`its node ${i} names a node that is not there`);
      parents[child] = (parents[child] ?? 0) + 1;
    }
  });
  // Taken away from the top: what is left has no top, so it hangs from itself.
  const free = nodes.flatMap((_, i) => (parents[i] === 0 ? [i] : []));
  for (let taken = 0; taken < free.length; taken++) {
    for (const child of nodes[free[taken] ?? -1]?.children ?? []) {
      const left = (parents[child] ?? 0) - 1;
      parents[child] = left;
      if (left === 0) free.push(child);
    }
  }
  if (free.length < nodes.length) throw damaged(`its node ${parents.findIndex((count) => count > 0)} hangs from itself`);
}
