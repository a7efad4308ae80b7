import type { Point } from '../../tools/lib/center-of.ts';
import { FLAG_PX } from './editor-driver.ts';
import type { RgbaImage } from './image.ts';
import { type OneEditor, saveGraphs } from './open-editor.ts';
import { eventually } from './patience.ts';

/** Of the gizmo's axes, as it draws them. */
const AXES = { x: [0xf2, 0x49, 0x5c], y: [0x7a, 0xc7, 0x4f], z: [0x4c, 0x8d, 0xff] } as const;
export type Axis = keyof typeof AXES;

/** Pixels of a color, in page points. */
export function pixelsOf({ width, height, data }: RgbaImage, frame: Point, color: readonly number[]): Point[] {
  const points: Point[] = [];
  for (let i = 0; i < width * height; i++) {
    if (color.every((part, c) => Math.abs((data[i * 4 + c] ?? 0) - part) <= 2)) {
      points.push({ x: frame.x + (i % width), y: frame.y + FLAG_PX + Math.floor(i / width) });
    }
  }
  return points;
}

/** Looks at gizmos in the preview of an editor, and at what they change. */
export function gizmoKit(open: OneEditor) {
  async function frameBox() {
    const frame = await open.page.locator('iframe[title="Preview"]').boundingBox();
    if (!frame) throw new Error('There is no preview.');
    return frame;
  }

  /** Where all of an axis is seen, once it is. */
  async function seeAxis(axis: Axis): Promise<Point[]> {
    const frame = await frameBox();
    return eventually(async () => {
      const points = pixelsOf(await open.editor.imageWithGizmo(), frame, AXES[axis]);
      if (points.length <= 8) throw new Error(`The axis ${axis} is not to be seen.`);
      return points;
    });
  }

  /** Whether an axis is seen now. */
  async function hasAxis(axis: Axis): Promise<boolean> {
    return pixelsOf(await open.editor.imageWithGizmo(), await frameBox(), AXES[axis]).length > 8;
  }

  /** The end of an axis: of all its pixels the last in a direction, a little inwards. */
  async function tip(axis: Axis, by: (point: Point) => number): Promise<Point> {
    const points = await seeAxis(axis);
    const last = points.reduce((best, point) => (by(point) > by(best) ? point : best));
    const near = points.filter(({ x, y }) => Math.hypot(x - last.x, y - last.y) < 6);
    const mean = (of: (point: Point) => number) => near.reduce((sum, point) => sum + of(point), 0) / near.length;
    return { x: mean(({ x }) => x), y: mean(({ y }) => y) };
  }

  /** The preview shows the gizmo of a tool, of a document as it was when the tool was chosen or later. */
  async function holds(mode: 'move' | 'rotate' | 'scale'): Promise<void> {
    await open.editor.preview.locator(`#gizmo[data-mode="${mode}"]`).waitFor();
  }

  async function select(stem: string): Promise<void> {
    await open.editor.node(stem).locator('.node-title').click();
  }

  async function numberIn(name: string): Promise<number> {
    return Number(await open.editor.inspector.getByRole('textbox', { name, exact: true }).inputValue());
  }

  async function expectValue(name: string, is: (value: number) => boolean): Promise<void> {
    await eventually(async () => {
      const value = await numberIn(name);
      if (!is(value)) throw new Error(`${name} stayed ${value}.`);
    });
  }

  function tool(name: RegExp) {
    return open.page.getByRole('toolbar', { name: 'Gizmo' }).getByRole('button', { name });
  }

  async function savedParams(node: string): Promise<Readonly<Record<string, unknown>>> {
    return (await saveGraphs(open)).main?.nodes[node]?.params ?? {};
  }

  async function undo(): Promise<void> {
    await open.page.locator('.canvas').focus();
    await open.page.keyboard.press('Control+z');
  }

  return { frameBox, seeAxis, hasAxis, tip, holds, select, numberIn, expectValue, tool, savedParams, undo };
}
