import type { CpuOperation, DrawOperation, Operation, PassOperation, Program } from '../program/program.ts';
import { bindingInWords, needInWords, tierInWords } from './plan-words.ts';
import { REFERENCE_SIZE, type ReferenceSize, type Target, targetBytes, targetSize, targetsOf } from './target-bytes.ts';

/**
 * A program in words, for `scrim plan`: how it reaches the screen, what is drawn in which order, what is kept in pictures and how
 * large they are, what is asked of the visitor and why, and what is lost where it is refused.
 */
export function describeProgram(program: Program, reference: ReferenceSize = REFERENCE_SIZE): string {
  const { operations, needs, tiers, assets, taps } = program;
  const section = (heading: string, lines: readonly string[]) => ['', heading, ...list(lines)];
  const run = (when: 'once' | 'each') =>
    operations.filter(({ view }) => view === when).map((operation) => describeOperation(operation, program));
  const lines = [
    program.title === '' ? 'Untitled' : program.title,
    presentation(program),
    ...section('Once a frame', run('once')),
    ...section('Per view', run('each')),
    '',
    ...pictures(program, reference),
    ...section('Asks the visitor for', needs.map(needInWords)),
    ...section(
      'Plays in, best first',
      tiers.map((tier) => tierInWords(tier).join('\n     ')),
    ),
    ...(assets.length === 0
      ? []
      : section(
          'Files',
          assets.map(({ path, kind }) => `${path} (${kind})`),
        )),
    ...(Object.keys(taps).length === 0 ? [] : section('Looked at', Object.keys(taps))),
  ];
  return `${lines.join('\n')}\n`;
}

function presentation({ presentation: { mode, antialias, background } }: Program): string {
  const how = mode === 'forward' ? 'straight into the session’s framebuffer, without pictures in between' : 'by way of pictures';
  const behind = background === 'world' ? 'the world' : `the colour ${background.join(' ')}`;
  return `Drawn ${how}; behind it ${behind}; ${antialias ? 'with' : 'without'} multisampling on the screen.`;
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
    case 'draw':
      return describeDraw(operation as DrawOperation);
    case 'cpu':
      return describeCpu(operation as CpuOperation);
    case 'value':
      return bindingInWords(operation) ?? `${operation.id}: computes ${Object.keys(operation.outputs).join(', ')} (${operation.type})`;
    case 'source':
      return `${operation.id}: brings ${operation.writes.join(', ')} (${operation.type})`;
    case 'behaviour':
    case 'geometry':
      return `${operation.id}: makes ${operation.writes.join(', ')} (${operation.type})`;
  }
}

function describePass({ id, reads, target, blend, access, shader }: PassOperation, program: Program): string {
  const from = reads.length === 0 ? '' : ` from ${reads.join(', ')}`;
  const onto = target === 'screen' ? (blend === 'over' ? ' over what is on the screen' : ' onto the screen') : ` into ${target}`;
  const file = program.shaders[shader]?.sourceMap?.sources[0];
  return `${id}: ${access ?? 'full-screen'} pass${from}${onto}${file === undefined ? '' : ` (${file})`}`;
}

function describeDraw({ id, type, target, shadowMaps, occlusion }: DrawOperation): string {
  const parts = [
    `${id}: draws objects ${target === 'screen' ? 'onto the screen' : `into ${target}`}`,
    ...(shadowMaps === null ? [] : [`with ${shadowMaps}`]),
    ...(occlusion === null ? [] : [`hidden where ${occlusion.roomDepth} is nearer, by ${occlusion.node}`]),
  ];
  return `${parts.join(', ')} (${type})`;
}

function describeCpu({ id, type, picture, target }: CpuOperation): string {
  return `${id}: sends ${picture} to a worker, and draws what came back of an earlier one into ${target} (${type})`;
}

function pictures(program: Program, reference: ReferenceSize): string[] {
  const targets = targetsOf(program);
  const total = targets.reduce((sum, target) => sum + (targetBytes(target, program, reference) ?? 0), 0);
  const heading = `Pictures kept, at ${reference.widthPx}×${reference.heightPx} per view`;
  const lines = targets.map((target) => describeTarget(target, program, reference));
  return [total === 0 ? heading : `${heading}: ${inMebibytes(total)}`, ...list(lines)];
}

function describeTarget(target: Target, program: Program, reference: ReferenceSize): string {
  if (target.shares !== undefined) return `${target.id}: in the place of ${target.shares}, which is done with by then`;
  const size = targetSize(target, program, reference);
  const bytes = targetBytes(target, program, reference);
  const parts = [
    size === null ? `as large as ${target.size.base}` : `${size.widthPx}×${size.heightPx}`,
    target.format,
    ...(target.depth === 'window' ? ['with depth'] : []),
    ...(target.samples > 1 ? [`${target.samples} samples`] : []),
    ...(target.lifetime === 'persistent' ? ['kept from frame to frame'] : []),
    ...(target.domain === 'image' ? ['once for all views'] : []),
    ...(bytes === null ? [] : [inMebibytes(bytes)]),
  ];
  return `${target.id}: ${parts.join(', ')}`;
}

function inMebibytes(bytes: number): string {
  return `${(bytes / 2 ** 20).toFixed(1)} MiB`;
}
