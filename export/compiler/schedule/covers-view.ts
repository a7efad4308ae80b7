import type { IsfShader } from '../../glsl/isf/isf-shader.ts';
import type { ResourceId } from '../../program/program.ts';
import type { Presentation } from '../../program/program-presentation.ts';
import { type FlatNode, portKey, sourcesAt } from '../flat-graph.ts';
import { constantParam } from '../fold/constants.ts';
import { FILE_SOURCES, hardEdgedLayers } from './fuse/hard-edged-layers.ts';
import { layerOutput } from './layers.ts';
import { type Lowering, resourceAt } from './lower/lowering.ts';
import { fitOf } from './lower/pass-parts.ts';
import { isPass, type ScheduledOperation, type ScheduledPass } from './scheduled.ts';

/** What is known of nodes and files apart from the code of passes. */
export interface CoverFacts {
  readonly lowering: Lowering;
  /** Ids of image and video assets without transparency. */
  readonly opaqueImages: ReadonlySet<string>;
  node(id: string): FlatNode | undefined;
  /** The shader of a node if it is one of Scrim's own, else null. */
  ownShader(node: FlatNode): IsfShader | null;
}

/**
 * Whether the screen shows an image without transparency in each of its pixels, when all files are loaded; `if-files-do`: if no file has
 * transparency. Null if it is unclear.
 *
 * An image has no transparency if the code of its pass says so (`export/glsl/access/kept-alpha.ts`), or if the header of a shader of Scrim
 * names the images and colors that decide it (`SCRIM_OPAQUE`).
 *
 * @param operations In the order in which they run, before fusion.
 */
export function coversView(operations: readonly ScheduledOperation[], facts: CoverFacts): NonNullable<Presentation['covers']> | null {
  const files = operations.filter((operation) => operation.kind === 'source' && FILE_SOURCES.has(operation.type));
  const covers = (opaque: Set<ResourceId>): boolean =>
    operations.some((operation) => {
      if (!isPass(operation) || !isOpaque(operation, opaque, facts)) return false;
      for (const id of operation.writes) opaque.add(id);
      return operation.target === 'screen';
    });
  if (covers(new Set(hardEdgedLayers(files, facts.opaqueImages)))) return true;
  return covers(new Set(files.flatMap(({ writes }) => writes))) ? 'if-files-do' : null;
}

function isOpaque(pass: ScheduledPass, opaque: ReadonlySet<ResourceId>, facts: CoverFacts): boolean {
  const { parts, samplers, copies } = pass;
  if (typeof parts === 'string') return false;
  if (parts.isOpaque) return true;
  const kept = copies ? samplers[0] : samplers.find(({ name }) => name === parts.keptAlpha);
  if (kept?.source.kind === 'color' && kept.fit !== 'contain' && opaque.has(kept.source.resource)) return true;
  const node = copies ? undefined : facts.node(pass.node);
  return node !== undefined && drawsOutput(pass, node, facts) && isOpaqueNode(node, opaque, facts);
}

function drawsOutput({ target }: ScheduledPass, node: FlatNode, { lowering }: CoverFacts): boolean {
  const output = layerOutput(node);
  return target === 'screen' || (output !== null && target === lowering.resourceOf.get(portKey(output)));
}

function isOpaqueNode(node: FlatNode, opaque: ReadonlySet<ResourceId>, { lowering, ownShader }: CoverFacts): boolean {
  const images = ownShader(node)?.opaqueImages ?? [];
  if (images.length === 0 || node.definition.visitorParams || fitOf(node) === 'contain') return false;
  const areColorsOpaque = Object.entries(node.definition.params).every(([name, param]) => {
    if (param.type !== 'color') return true;
    const value = constantParam(node, name, param);
    return Array.isArray(value) && (value[3] ?? 1) === 1;
  });
  return (
    areColorsOpaque &&
    images.every((name) => {
      const [source] = sourcesAt(node, name);
      return source !== undefined && opaque.has(resourceAt(lowering, source));
    })
  );
}
