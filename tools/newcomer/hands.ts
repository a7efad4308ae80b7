import { readFile } from 'node:fs/promises';
import { basename } from 'node:path';
import type { Locator, Page } from 'playwright-core';
import { centerOf, type Point } from '../lib/center-of.ts';
import { frameOf } from '../lib/frame-of.ts';

/** An interaction as a user counts it: a click, a drag, or a field with its Enter. */
export interface Interaction {
  readonly kind: 'click' | 'drag' | 'type';
  /** What the user does, as a caption for readers of the documentation. */
  readonly what: string;
  /** Position of the pointer in client pixels. */
  readonly at: Point;
}

const KEY_MS = 8;
const TOUCH_MS = 150;
const TWIST_STEPS = 6;

/** Pointer and keyboard that count their interactions. */
export class Hands {
  readonly done: Interaction[] = [];
  private readonly page: Page;
  private readonly onDone: (done: Interaction) => Promise<void>;

  constructor(page: Page, onDone: (done: Interaction) => Promise<void>) {
    this.page = page;
    this.onDone = onDone;
  }

  async click(what: string, target: Locator): Promise<void> {
    const at = await centerOf(target);
    await target.click();
    await this.count({ kind: 'click', what, at });
  }

  async clickAt(what: string, at: Point): Promise<void> {
    await this.page.mouse.click(at.x, at.y);
    await this.count({ kind: 'click', what, at });
  }

  async drag(what: string, from: Point, to: Point): Promise<void> {
    const { mouse } = this.page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    await mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 4 });
    await mouse.move(to.x, to.y, { steps: 6 });
    await mouse.up();
    await this.count({ kind: 'drag', what, at: to });
  }

  /** Puts two fingers on opposite sides of a point of the preview and turns them about it, clockwise as seen. */
  async twist(what: string, { x, y }: Point, radiusPx: number, turnRad: number): Promise<void> {
    // Touches reach a frame in a process of its own only by its session, at points of the page.
    const client = await this.page.context().newCDPSession(await frameOf(this.page));
    const put = async (type: 'touchStart' | 'touchMove', rad: number) => {
      const touchPoints = [rad, rad + Math.PI].map((at, id) => ({ x: x + radiusPx * Math.cos(at), y: y + radiusPx * Math.sin(at), id }));
      await client.send('Input.dispatchTouchEvent', { type, touchPoints });
      // The preview reads pointers once per frame.
      await this.page.waitForTimeout(TOUCH_MS);
    };
    await put('touchStart', 0);
    for (let i = 1; i <= TWIST_STEPS; i++) await put('touchMove', (turnRad * i) / TWIST_STEPS);
    await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    await client.detach();
    await this.count({ kind: 'drag', what, at: { x, y } });
  }

  async type(what: string, text: string, field: Locator): Promise<void> {
    const at = await centerOf(field);
    await field.fill('');
    await this.page.keyboard.type(text, { delay: KEY_MS });
    await this.page.keyboard.press('Enter');
    await this.count({ kind: 'type', what, at });
  }

  /** Types where the focus is. */
  async write(what: string, text: string): Promise<void> {
    await this.page.keyboard.type(text, { delay: KEY_MS });
    await this.count({ kind: 'type', what, at: { x: 0, y: 0 } });
  }

  /** Chooses an option of a list. */
  async choose(what: string, list: Locator, option: string): Promise<void> {
    const at = await centerOf(list);
    await list.click();
    await this.page.getByRole('option', { name: option, exact: true }).click();
    await this.count({ kind: 'click', what, at });
  }

  /** Presses a single key. Counts like a field. */
  async press(what: string, key: string): Promise<void> {
    await this.page.keyboard.press(key);
    await this.count({ kind: 'type', what, at: { x: 0, y: 0 } });
  }

  /** Drops a file from outside, by synthetic events, because pointer input of a page cannot do that. */
  async dropFile(what: string, path: string, at: Point): Promise<void> {
    const base64 = (await readFile(path)).toString('base64');
    await this.page.evaluate(
      ({ bytes, name, x, y }) => {
        const data = new DataTransfer();
        data.items.add(new File([Uint8Array.from(atob(bytes), (c) => c.charCodeAt(0))], name));
        const target = document.elementFromPoint(x, y);
        for (const kind of ['dragover', 'drop']) {
          target?.dispatchEvent(new DragEvent(kind, { dataTransfer: data, clientX: x, clientY: y, bubbles: true, cancelable: true }));
        }
      },
      { bytes: base64, name: basename(path), ...at },
    );
    await this.count({ kind: 'drag', what, at });
  }

  private async count(done: Interaction): Promise<void> {
    this.done.push(done);
    await this.onDone(done);
  }
}
