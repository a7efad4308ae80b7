import { damaged, type Gltf, isPacked } from './document.ts';
import { pictureSize } from './picture-size.ts';

/** Refuses pictures inside the file that no browser can decode: the whole model would fail with them, and only on the page. */
export function checkPictures({ document, binary }: Gltf): void {
  const { images = [], bufferViews = [] } = document;
  if (binary === null) return;
  images.forEach(({ bufferView }, i) => {
    if (bufferView === undefined) return;
    const view = bufferViews[bufferView];
    if (!view) throw damaged(`its picture ${i} names a part that is not there`);
    if (view.buffer !== 0 || isPacked(view)) return;
    const start = view.byteOffset ?? 0;
    const bytes = binary.subarray(start, start + view.byteLength);
    if (pictureSize(bytes) === null && !isOther(bytes)) {
      throw damaged(`its picture ${i} is broken or of an unknown kind; PNG, JPEG and WebP are known`);
    }
  });
}

/** AVIF, GIF and BMP, whose sizes nobody asks for. */
function isOther(bytes: Uint8Array): boolean {
  const head = String.fromCharCode(...bytes.subarray(0, 8));
  return head.slice(4) === 'ftyp' || head.startsWith('GIF8') || head.startsWith('BM');
}
