import { damaged, type Gltf, isPacked } from './document.ts';
import { imageFault } from './image-faults.ts';

/** Rejects embedded images that browsers cannot decode or show, because the whole model would then fail on the page. */
export function checkImages({ document, binary }: Gltf): void {
  const { images = [], bufferViews = [] } = document;
  if (binary === null) return;
  images.forEach(({ bufferView }, i) => {
    if (bufferView === undefined) return;
    const view = bufferViews[bufferView];
    if (!view) throw damaged(`image ${i} refers to a missing buffer view`);
    if (view.buffer !== 0 || isPacked(view)) return;
    const start = view.byteOffset ?? 0;
    const bytes = binary.subarray(start, start + view.byteLength);
    const fault = imageFault(bytes);
    if (fault !== null) throw damaged(`image ${i} ${fault.replace(/\.$/, '')}`);
  });
}
