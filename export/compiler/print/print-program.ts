import type { ProjectLogic } from '../../graph/project.ts';
import { type Operation, PROGRAM_VERSION, type Program, type ProgramAsset } from '../../program/program.ts';
import { importedAssets } from '../imported-assets.ts';
import type { LinkedOperations } from '../link/link.ts';
import type { Schedule } from '../schedule/schedule.ts';
import { collectControls } from './collect-controls.ts';
import { collectCredits } from './collect-credits.ts';
import { collectNeeds } from './collect-needs.ts';
import { findTiers } from './find-tiers.ts';

/** Last phase: assembles the program. Equal projects give equal text, because everything is sorted. */
export function print(project: ProjectLogic, scheduled: Schedule, { operations, resources, shaders }: LinkedOperations): Program {
  const needs = collectNeeds(scheduled.nodes, scheduled.working);
  const controls = collectControls(scheduled);
  const credits = collectCredits(scheduled.nodes, project.assets);
  const program: Program = {
    format: 'scrim-program',
    version: PROGRAM_VERSION,
    title: project.title,
    slots: scheduled.slots,
    resources,
    operations,
    shaders,
    assets: usedAssets(project, operations),
    presentation: scheduled.presentation,
    needs,
    tiers: [],
    taps: scheduled.taps,
    ...(controls.length > 0 ? { controls } : {}),
    ...(scheduled.nodes.some(({ definition }) => definition.readsInput) ? { readsInput: true as const } : {}),
    ...(credits.length > 0 ? { credits } : {}),
  };
  return { ...program, tiers: findTiers(program) };
}

function usedAssets({ assets }: ProjectLogic, operations: readonly Operation[]): ProgramAsset[] {
  const used = new Set<string>();
  const withDepthMeshes = new Set<string | null>();
  const imported = importedAssets(operations.filter((operation) => operation.kind === 'pass'));
  for (const operation of operations) {
    if (operation.kind === 'pass' || operation.kind === 'shadow-maps' || operation.kind === 'readback') continue;
    for (const id of Object.values(operation.assets)) if (id !== null) used.add(id);
    if (operation.depthMeshes) for (const id of Object.values(operation.assets)) withDepthMeshes.add(id);
  }
  const chosen = [...used].sort().flatMap((id): ProgramAsset[] => {
    const asset = Object.hasOwn(assets, id) ? assets[id] : undefined;
    if (!asset) return [];
    return [{ id, kind: asset.kind, path: asset.path, ...(withDepthMeshes.has(id) ? { depthMeshes: true as const } : {}) }];
  });
  return [...chosen, ...imported];
}
