/** A point on the page in CSS pixels, y down. */
export interface PagePoint {
  readonly x: number;
  readonly y: number;
}

/** Where an image is on the page, in CSS pixels from the top left, and how many of its pixels are one CSS pixel. */
export interface ImageBox {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
  readonly scale: number;
}

/** Where a point of an image is on the page. Points of images are UV from the bottom left. */
export function onPage({ x, y }: PagePoint, { left, top, width, height }: ImageBox): PagePoint {
  return { x: left + x * width, y: top + (1 - y) * height };
}
