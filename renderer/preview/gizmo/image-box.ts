import { Matrix3 } from 'three';
import type { PassOperation } from '../../../export/program/program.ts';
import type { Inspected } from '../../../export/runtime/inspected.ts';
import { fitted } from '../../../export/runtime/passes/fit.ts';
import type { ViewFrame } from '../../../nodes/kit/session.ts';
import type { ImageBox } from './page-point.ts';
import type { ViewBox } from './tool.ts';

const IDENTITY = new Float32Array(new Matrix3().elements);

/**
 * Where the layer of a node is on the page. A layer of the view fills the view; an image of its own size is where the first pass that fits
 * it to the view draws it. Null before that image has a size.
 *
 * @param box Where the view is on the page.
 */
export function imageBox(
  { program, resources }: Pick<Inspected, 'program' | 'resources'>,
  node: string,
  { viewport }: Pick<ViewFrame, 'viewport'>,
  box: ViewBox,
): ImageBox | null {
  const passes = program.operations.filter((operation): operation is PassOperation => operation.kind === 'pass');
  const images = program.resources.filter((resource) => resource.kind === 'target' && resource.domain === 'image');
  // The pass that copies an image to the screen belongs to its node, too.
  const resource = passes
    .filter((pass) => pass.node === node || pass.nodes?.includes(node))
    .flatMap(({ target }) => images.find(({ id }) => id === target) ?? [])
    .at(-1);
  if (!resource) return { ...box, scale: viewport.heightPx / box.height };
  const live = resources.get(resource.id);
  const image = live?.kind === 'target' ? live.target.peek(0) : null;
  if (!image) return null;
  const fit = fitOf(passes, resource.id);
  const [scaleX = 1, , , , scaleY = 1, , offsetX = 0, offsetY = 0] = fitted(
    IDENTITY,
    fit,
    image.widthPx,
    image.heightPx,
    viewport.widthPx,
    viewport.heightPx,
  );
  const [width, height] = [box.width / scaleX, box.height / scaleY];
  return {
    left: box.left - offsetX * width,
    // The offset is from the bottom.
    top: box.top + box.height + offsetY * height - height,
    width,
    height,
    scale: image.heightPx / height,
  };
}

/** How the first pass that reads an image, or what other passes make of it, fits it to the view. */
function fitOf(passes: readonly PassOperation[], image: string): 'none' | 'cover' | 'contain' | 'stretch' {
  const images = new Set([image]);
  for (const { samplers, target } of passes) {
    const read = samplers.find(({ source }) => source.kind === 'color' && images.has(source.resource));
    if (!read) continue;
    if (read.fit !== 'none') return read.fit;
    images.add(target);
  }
  return 'none';
}
