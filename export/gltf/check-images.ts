import { damaged, type Gltf, isPacked } from './document.ts';
import { imageFault } from './image-faults.ts';

/** Refuses pictures inside the file that no browser can decode or show: the whole model would fail with them, and only on the page. */
export function checkImages({ document, binary }: Gltf): void {
  const { images = [], bufferViews = [] } = document;
  if (binary === null) return;
  images.forEach(({ bufferView }, i) => {
    if (bufferView === undefined) return;
    const view = bufferViews[bufferView];
    if (!view) throw damaged(`its picture ${i} names a part that is not there`);
    if (view.buffer !== 0 || isPacked(view)) return;
    const start = view.byteOffset ?? 0;
    const bytes = binary.subarray(start, start + view.byteLength);
    const fault = imageFault(bytes);
    if (fault !== null) throw damaged(`its picture ${i} ${fault.replace(/\.$/, '')}`);
  });
}
