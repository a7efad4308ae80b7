import { deviceTable } from '../program/devices/device-table.ts';
import { fixedImageNote } from '../program/fixed-image.ts';
import type { CpuOperation, DrawOperation, Operation, PassOperation, Program } from '../program/program.ts';
import { bindingInWords, deviceInWords, needInWords, tierInWords } from './describe-terms.ts';
import { FOLD_REASONS, type FoldedNode } from './fold/folded-node.ts';
import { SEPARATE_REASONS, type SeparateWire } from './schedule/fuse/separate-wire.ts';
import { behindGlassBytes, REFERENCE_SIZE, type ReferenceSize, type Target, targetBytes, targetSize, targetsOf } from './target-bytes.ts';

/**
 * Describes a program as text, for `scrim plan`: its presentation, the operations in order, the render targets with their sizes, the
 * requested features with their reasons, the tiers, and what is missing on which devices.
 *
 * @param reference Size of a view, for sizes in pixels and bytes.
 * @returns Lines of text without a trailing line break.
 * @example
 * console.log(describeProgram(program, { widthPx: 1280, heightPx: 720 }));
 */
export function describeProgram(program: Program, reference: ReferenceSize = REFERENCE_SIZE): string {
  const { operations, needs, tiers, assets, taps } = program;
  const note = fixedImageNote(program);
  const section = (heading: string, lines: readonly string[]) => ['', heading, ...list(lines)];
  const run = (when: 'once' | 'each') =>
    operations.filter(({ view }) => view === when).map((operation) => describeOperation(operation, program));
  const lines = [
    program.title === '' ? 'Untitled' : program.title,
    presentation(program),
    ...section('Once per frame', run('once')),
    ...section('Per view', run('each')),
    '',
    ...pictures(program, reference),
    ...section('Asks the visitor for', needs.map(needInWords)),
    ...section(
      'Plays in, best first',
      tiers.map((tier) => tierInWords(tier).join('\n     ')),
    ),
    ...(note === null ? [] : [`  ${note}`]),
    ...section(
      'On devices',
      deviceTable(program).map((row) => deviceInWords(row).join('\n     ')),
    ),
    ...(assets.length === 0
      ? []
      : section(
          'Files',
          assets.map(({ path, kind }) => `${path} (${kind})`),
        )),
    ...(Object.keys(taps).length === 0 ? [] : section('Viewed layers', Object.keys(taps))),
  ];
  return `${lines.join('\n')}\n`;
}

function presentation({ presentation: { mode, antialias, background, screenDepth } }: Program): string {
  const how = mode === 'forward' ? 'directly into the session’s framebuffer, without render targets' : 'through render targets';
  const behind = background === 'world' ? 'the world' : `the color ${background.join(' ')}`;
  const depth = screenDepth === 'none' ? 'without depth' : screenDepth === 'whole' ? 'with depth that headsets get' : 'with depth';
  return `Drawn ${how}; the background is ${behind}; ${antialias ? 'with' : 'without'} multisampling and ${depth} on the screen.`;
}

function list(lines: readonly string[]): string[] {
  return lines.length === 0 ? ['  nothing'] : lines.map((line, i) => `  ${i + 1}. ${line}`);
}

function describeOperation(operation: Operation, program: Program): string {
  switch (operation.kind) {
    case 'pass':
      return describePass(operation, program);
    case 'shadow-maps':
      return `${operation.id}: shadow maps of ${operation.casters.join(', ')} for ${operation.lights.join(', ')}`;
    case 'readback':
      return `${operation.id}: reads ${operation.picture} back for the next frame`;
    case 'draw':
      return describeDraw(operation as DrawOperation, program);
    case 'cpu':
      return describeCpu(operation as CpuOperation);
    case 'value':
      return bindingInWords(operation) ?? `${operation.id}: computes ${Object.keys(operation.outputs).join(', ')} (${operation.type})`;
    case 'source':
      return `${operation.id}: brings ${operation.writes.join(', ')} (${operation.type})`;
    case 'behavior':
    case 'geometry':
      return `${operation.id}: creates ${operation.writes.join(', ')} (${operation.type})`;
  }
}

/**
 * Describes, for `scrim plan --why`, the layers that passes read as textures, with the reason why each is not fused.
 *
 * @returns Lines of text.
 * @example
 * const { separate } = compile({ project, library, options: { fuse: true } });
 * console.log(describeSeparate(separate));
 */
export function describeSeparate(separate: readonly SeparateWire[]): string {
  const lines = separate.map(({ resource, reader, reason }) => `${resource} → ${reader}: ${SEPARATE_REASONS[reason]} (${reason})`);
  return `${['Layers that are not fused into their readers', ...list(lines)].join('\n')}\n`;
}

/** Describes, for `scrim plan`, the nodes that folding leaves out, each with the reason; empty if there are none. */
export function describeFolded(folded: readonly FoldedNode[]): string {
  if (folded.length === 0) return '';
  const lines = folded.map(({ node, reason, instead }) => `${node}: ${FOLD_REASONS[reason]} (${instead ?? reason})`);
  return `${['Nodes that are left out', ...list(lines)].join('\n')}\n`;
}

function describePass(operation: PassOperation, program: Program): string {
  const { id, reads, target, blend, access, shader, nodes } = operation;
  const from = reads.length === 0 ? '' : ` from ${reads.join(', ')}`;
  const onto = target === 'screen' ? (blend === 'over' ? ' over what is on the screen' : ' onto the screen') : ` into ${target}`;
  const files = program.shaders[shader]?.sourceMap?.sources ?? [];
  const fused = nodes === undefined ? '' : `, fused of ${nodes.join(', ')}`;
  return `${id}: ${access ?? 'full-screen'} pass${from}${onto}${fused}${files.length === 0 ? '' : ` (${files.join(', ')})`}`;
}

const GLASS_WORDS = { certain: 'glass', possible: 'glass of models, where they have it,' } as const;

/** Whether draws show glass: that of materials of the program is certain, that of models is known only once they are loaded. */
function glassOf(draws: readonly DrawOperation[], { assets }: Program): keyof typeof GLASS_WORDS | null {
  if (draws.some(({ glass }) => glass)) return 'certain';
  return draws.length > 0 && assets.some(({ kind }) => kind === 'model') ? 'possible' : null;
}

function describeDraw(operation: DrawOperation, program: Program): string {
  const { id, type, target, shadowMaps, occlusion, under, effects } = operation;
  const glass = glassOf([operation], program);
  const parts = [
    `${id}: draws objects ${target === 'screen' ? 'onto the screen' : `into ${target}`}`,
    ...(shadowMaps === null ? [] : [`with ${shadowMaps}`]),
    ...(occlusion === null ? [] : [`hidden where ${occlusion.roomDepth} is nearer (${occlusion.node})`]),
    ...(effects ? [`with the effects ${effects.nodes.join(', ')} in its materials`] : []),
    ...(under && glass ? [`${GLASS_WORDS[glass]} in front of ${under.resource}`] : []),
  ];
  return `${parts.join(', ')} (${type})`;
}

function describeCpu({ id, type, picture, target }: CpuOperation): string {
  return `${id}: sends ${picture} to a worker and draws the result of an earlier frame into ${target} (${type})`;
}

function pictures(program: Program, reference: ReferenceSize): string[] {
  const bytes = targetBytes(program, reference);
  const total = [...bytes.values()].reduce<number>((sum, known) => sum + (known ?? 0), 0);
  const heading = `Render targets, at ${reference.widthPx}×${reference.heightPx} per view`;
  const lines = targetsOf(program).map((target) => describeTarget(target, bytes.get(target.id) ?? null, program, reference));
  const multisampled = targetsOf(program).filter(({ samples, shares }) => samples > 1 && shares === undefined);
  const shared =
    multisampled.length > 1 ? ['  Multisampled targets of equal size draw into the same samples, which count for the first.'] : [];
  return [total === 0 ? heading : `${heading}: ${inMebibytes(total)}`, ...list(lines), ...shared, ...behindGlass(program, reference)];
}

/**
 * Describes the images of what is behind glass, one for each encoding of the targets that objects are drawn into. They are no resources of
 * the program, because only the runtime finds out whether a model has glass.
 */
function behindGlass(program: Program, reference: ReferenceSize): string[] {
  const { operations, resources } = program;
  const draws = operations.filter((operation): operation is DrawOperation => operation.kind === 'draw');
  const glass = glassOf(draws, program);
  if (glass === null) return [];
  // One image for each encoding.
  const inScene = new Set(
    draws.map(({ target }) => resources.some((r) => r.kind === 'target' && r.id === target && r.format === 'scene16f')),
  );
  const bytes = [...inScene].reduce((sum, scene) => sum + behindGlassBytes(scene, reference), 0);
  const when = glass === 'certain' ? 'While glass is in view' : 'If a model has glass, while it is in view';
  return [`  ${when}: its objects are drawn once more, into an image of what is behind it, ${inMebibytes(bytes)}.`];
}

function describeTarget(target: Target, bytes: number | null, program: Program, reference: ReferenceSize): string {
  if (target.shares !== undefined) return `${target.id}: reuses the texture of ${target.shares}`;
  const size = targetSize(target, program, reference);
  const parts = [
    size === null ? `size of ${target.size.base}` : `${size.widthPx}×${size.heightPx}`,
    target.format,
    ...(target.depth === 'window' ? ['with depth'] : []),
    ...(target.samples > 1 ? [`${target.samples} samples`] : []),
    ...(target.lifetime === 'persistent' ? ['kept between frames'] : []),
    ...(target.domain === 'image' ? ['one for all views'] : []),
    ...(bytes === null ? [] : [inMebibytes(bytes)]),
  ];
  return `${target.id}: ${parts.join(', ')}`;
}

function inMebibytes(bytes: number): string {
  return `${(bytes / 2 ** 20).toFixed(1)} MiB`;
}
