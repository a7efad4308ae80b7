import type { Picture } from './glsl.page.ts';

/** What the browser's own canvas makes of one picture on another; bottom row first, premultiplied, base64. */
export function compositeInCanvas(top: Picture, bottom: Picture, mode: GlobalCompositeOperation, opacity: number): string {
  const context = canvasOf(bottom);
  context.globalCompositeOperation = mode;
  context.globalAlpha = opacity;
  context.drawImage(canvasOf(top).canvas, 0, 0);
  const { data } = context.getImageData(0, 0, bottom.width, bottom.height);
  return encode(data.map((value, i) => (i % 4 === 3 ? value : Math.round((value * alphaAt(data, i)) / 255))));
}

/** A canvas keeps premultiplied colors but takes and gives straight ones: rounding there and back loses nothing. */
function canvasOf({ width, height, rgba }: Picture): CanvasRenderingContext2D {
  const context = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d', { willReadFrequently: true });
  if (!context) throw new Error('This browser has no 2D canvas.');
  const data = Uint8Array.from(atob(rgba), (c) => c.charCodeAt(0));
  const straight = Uint8ClampedArray.from(data, (value, i) => {
    const alpha = alphaAt(data, i);
    return i % 4 === 3 || alpha === 0 ? value : Math.round((value * 255) / alpha);
  });
  context.putImageData(new ImageData(straight, width, height), 0, 0);
  return context;
}

/** Alpha of the pixel that the byte belongs to. */
function alphaAt(rgba: ArrayLike<number>, i: number): number {
  return rgba[i - (i % 4) + 3] ?? 0;
}

function encode(bytes: Iterable<number>): string {
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text);
}
