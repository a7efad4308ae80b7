import type { FrameLocator, Locator, Page } from 'playwright-core';
import { centerOf, type Point } from '../../tools/lib/center-of.ts';
import { decodeImage, type RgbaImage } from './image.ts';
import { eventually, PATIENCE_MS } from './patience.ts';
import { countDifferent, expectSamePixels } from './pixels.ts';

/** Height of the strip at the top of the preview that messages may cover. */
export const FLAG_PX = 40;
/** A paused preview draws four times per second. */
const REST_MS = 300;
const RESTING_IMAGES = 2;
/** Between two looks at an image that is still to change: each look takes about as long from what it waits for. */
const LOOK_EVERY_MS = 100;
/** Delay of a fast typist. The text editor reads keys between two paints. */
const KEY_MS = 15;

/** Drives a running editor by pointer and keys, and reads what the page shows. */
export class EditorDriver {
  readonly page: Page;

  constructor(page: Page) {
    this.page = page;
  }

  get preview(): FrameLocator {
    return this.page.frameLocator('iframe[title="Preview"]');
  }

  get inspector(): Locator {
    return this.page.getByRole('complementary', { name: 'Inspector' });
  }

  node(idOrStem: string): Locator {
    return this.page.locator(`[data-node^="${idOrStem}"]`);
  }

  async nodeId(stem: string): Promise<string> {
    const id = await this.node(stem).first().getAttribute('data-node');
    if (id === null) throw new Error(`There is no node ${stem} on the canvas.`);
    return id;
  }

  port(node: string, port: string, side: 'source' | 'target'): Locator {
    return this.page.locator(`.react-flow__handle.${side}[data-nodeid="${node}"][data-handleid="${port}"]`);
  }

  /** A point on a drawn wire, at a part of its length. */
  async pointOnWire(wire: string, part: number): Promise<Point> {
    return this.page.locator(`.react-flow__edge[data-id="${wire}"] .react-flow__edge-path`).evaluate((element, at) => {
      const path = element as SVGPathElement;
      const { x, y } = path.getPointAtLength(path.getTotalLength() * at).matrixTransform(path.getScreenCTM() ?? undefined);
      return { x, y };
    }, part);
  }

  /** Drags a wire from one port to another. */
  async wire(from: readonly [node: string, port: string], to: readonly [node: string, port: string]): Promise<void> {
    await this.drag(await centerOf(this.port(from[0], from[1], 'source')), await centerOf(this.port(to[0], to[1], 'target')));
  }

  async drag(from: Point, to: Point): Promise<void> {
    const { mouse } = this.page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    await mouse.move((from.x + to.x) / 2, (from.y + to.y) / 2, { steps: 4 });
    await mouse.move(to.x, to.y, { steps: 4 });
    await mouse.up();
  }

  /** A free point on the canvas. */
  async emptyPlace(): Promise<Point> {
    return this.page.evaluate(() => {
      const box = document.querySelector('.canvas')?.getBoundingClientRect();
      if (!box) throw new Error('There is no canvas.');
      const isPane = (x: number, y: number) => document.elementFromPoint(x, y)?.classList.contains('react-flow__pane') ?? false;
      // A wire held within 40 px of an edge pans the canvas, so ports of a node placed here must be farther away.
      for (let y = box.top + 80; y < box.bottom - 130; y += 20) {
        for (let x = box.left + 100; x < box.right - 300; x += 20) {
          const around = [0, 70, 140, 210].flatMap((dx) => [-30, 0, 40, 80].map((dy) => isPane(x + dx, y + dy)));
          if (around.every(Boolean)) return { x, y };
        }
      }
      throw new Error('The canvas is full.');
    });
  }

  /** Opens the palette at a free point, types, and chooses the first entry. */
  async addNode(search: string): Promise<void> {
    const { x, y } = await this.emptyPlace();
    await this.page.mouse.dblclick(x, y);
    await this.page.getByRole('combobox', { name: 'Search nodes' }).fill(search);
    await this.page.keyboard.press('Enter');
  }

  /** Waits until the preview plays the newest program. */
  async settled(): Promise<void> {
    await this.page.waitForFunction(
      () =>
        document.querySelector('.stage')?.getAttribute('aria-busy') === 'false' &&
        !/Compiling/.test(document.querySelector('.status-bar')?.textContent ?? '') &&
        document.querySelector('.stage-notice') === null,
    );
  }

  /** Waits until the preview plays the newest program, in whatever window. */
  async previewAnswers(): Promise<void> {
    await this.page.waitForFunction(() => document.querySelector('.stage')?.getAttribute('aria-busy') === 'false');
  }

  /** Moves the preview to a window of its own, and returns that. It is small, so that all machines draw it in the same time. */
  async popOut(): Promise<Page> {
    const opening = this.page.waitForEvent('popup');
    await this.press('Pop out preview');
    const popup = await opening;
    await popup.setViewportSize({ width: 480, height: 360 });
    await popup.frameLocator('iframe[title="Preview"]').locator('#picture').waitFor();
    await this.page.locator('iframe[title="Preview"]').waitFor({ state: 'detached' });
    await this.previewAnswers();
    return popup;
  }

  async frame(): Promise<number> {
    return Number(await this.page.locator('.transport-time span').textContent());
  }

  async press(name: string): Promise<void> {
    await this.page.getByRole('button', { name, exact: true }).click();
  }

  /** Selects a node and opens its shader. */
  async openCode(stem: string): Promise<void> {
    await this.node(stem).locator('.node-title').click();
    await this.press('Edit shader');
    await this.page.locator('.monaco-editor .view-line').first().waitFor();
  }

  /** Puts the caret before the first occurrence of a text, with the search of Monaco. */
  async findInText(text: string): Promise<void> {
    const { page } = this;
    await page.locator('.code-text').click({ position: { x: 300, y: 60 } });
    await page.locator('.monaco-editor.focused').waitFor();
    await page.keyboard.press('Control+Home');
    await page.keyboard.press('Control+f');
    const search = page.locator('.monaco-editor .find-widget.visible');
    await search.locator('textarea').first().fill(text);
    await search.getByText(/^[1-9]\d* of \d+$/).waitFor();
    await page.keyboard.press('Escape');
    await search.waitFor({ state: 'detached' });
    // The editor counts as focused while its search field is, which would take the keys that follow.
    await page.waitForFunction(() => {
      const focused = document.activeElement;
      return focused?.closest('.monaco-editor') != null && focused.closest('.find-widget') === null;
    });
    // The found text is selected.
    await page.keyboard.press('ArrowLeft');
  }

  async type(text: string): Promise<void> {
    await this.page.keyboard.type(text, { delay: KEY_MS });
  }

  /** Waits for a paint, because the text editor, for example, draws once per frame. */
  async painted(): Promise<void> {
    await this.page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }

  /** Number of the line with the caret. */
  async lineNumber(): Promise<number> {
    await this.painted();
    return Number(await this.page.locator('.monaco-editor .line-numbers.active-line-number').first().textContent());
  }

  /** Visible text of the line with the caret. */
  async lineText(): Promise<string> {
    await this.painted();
    return this.page.evaluate(() => {
      const current = document.querySelector('.monaco-editor .view-overlays .current-line')?.parentElement as HTMLElement | null;
      const lines = [...document.querySelectorAll<HTMLElement>('.monaco-editor .view-line')];
      const line = lines.find(({ style }) => style.top === current?.style.top);
      return (line?.textContent ?? '').replaceAll('\u00a0', ' ').replaceAll('\u200b', '');
    });
  }

  /** Pauses the preview, and waits until the button shows it. */
  async hold(): Promise<void> {
    const either = this.page.getByRole('button', { name: /^(Play|Pause)$/ });
    await either.evaluate((button: HTMLElement) => {
      if (button.getAttribute('aria-label') === 'Pause') button.click();
    });
    await this.page.getByRole('button', { name: 'Play', exact: true }).waitFor();
    // The time at which it pauses is drawn in the next frame.
    await this.nextFrames();
  }

  /** Goes to the first frame, and returns its image once it no longer changes. Recordings decode their frames asynchronously. */
  async rewind(): Promise<RgbaImage> {
    await this.hold();
    await this.press('Go to first frame');
    await this.page.waitForFunction(() => document.querySelector('.transport-time span')?.textContent === '0');
    // The frame number is the requested one; its image follows. Other sources draw at their next frame.
    await this.nextFrames();
    await this.settled();
    return this.restingImage();
  }

  /** Waits until the preview has drawn what it was told before. */
  private async nextFrames(): Promise<void> {
    await this.preview.locator('body').evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  }

  /** The image of the preview once it no longer changes. */
  async restingImage(): Promise<RgbaImage> {
    let last = await this.picture();
    for (let same = 0; same < RESTING_IMAGES; ) {
      await this.page.waitForTimeout(REST_MS);
      const next = await this.picture();
      same = isAsLarge(next, last) && countDifferent(next, last).pixels === 0 ? same + 1 : 0;
      last = next;
    }
    return last;
  }

  /**
   * Moves the pointer to a point of the page over the preview, until the overlay there answers with `answer`. The frame of the preview
   * belongs to another process, so moves reach an overlay only once the compositor knows of it.
   */
  async moveOverPreview(x: number, y: number, answer: Locator): Promise<void> {
    await eventually(async () => {
      await this.page.mouse.move(x - 5, y);
      await this.page.mouse.move(x, y);
      if (!(await answer.isVisible())) throw new Error('The overlay over the preview does not answer the pointer.');
    });
  }

  /** The preview without gizmos, below the strip that messages may cover. */
  async picture(): Promise<RgbaImage> {
    await this.showGizmo(false);
    try {
      return await this.imageWithGizmo();
    } finally {
      await this.showGizmo(true);
    }
  }

  /** Shows or hides the gizmo. A hidden gizmo still works. */
  private async showGizmo(shown: boolean): Promise<void> {
    const show = (visibility: string) => {
      for (const element of document.querySelectorAll<HTMLElement>('#gizmo, #image-gizmo, .gizmo-bar'))
        element.style.visibility = visibility;
    };
    // A page that is loading has no gizmo.
    await Promise.all(this.page.frames().map((frame) => frame.evaluate(show, shown ? '' : 'hidden').catch(() => {})));
  }

  /** Waits until the screen shows what the editor and the preview have drawn. */
  private async shown(): Promise<void> {
    const wait = () =>
      new Promise((done) => {
        const { requestScreenFrame } = window as { requestScreenFrame?: Window['requestAnimationFrame'] };
        const request = requestScreenFrame ?? window.requestAnimationFrame;
        request(() => request(done));
        // A page out of view has no frames.
        setTimeout(done, 500);
      });
    // A page that is loading shows nothing.
    await Promise.all(this.page.frames().map((frame) => frame.evaluate(wait).catch(() => {})));
  }

  /** The image with the gizmo, for tests of the gizmo. */
  async imageWithGizmo(): Promise<RgbaImage> {
    await this.keepSize();
    const box = await this.page.locator('iframe[title="Preview"]').boundingBox();
    if (!box) throw new Error('There is no preview.');
    await this.shown();
    // Cropped here: a screenshot of a part of an iframe in a process of its own differs by a few steps in some pixels.
    const { width, height, data } = decodeImage(await this.page.screenshot({ clip: box }));
    return { width, height: height - FLAG_PX, data: data.slice(FLAG_PX * width * 4) };
  }

  /**
   * Restores the emulated window size, which Electron may lose on a busy machine. Sets another size first, because Playwright ignores
   * an unchanged one.
   */
  private async keepSize(): Promise<void> {
    const wanted = this.page.viewportSize();
    if (wanted === null || (await this.page.evaluate(() => window.innerWidth)) === wanted.width) return;
    process.stderr.write('The window lost the size that the test gave it, and was given it again.\n');
    await this.page.setViewportSize({ width: wanted.width, height: wanted.height - 1 });
    await this.page.setViewportSize(wanted);
  }

  /** The image once it no longer changes, after at least `pixels` pixels have changed. */
  async imageOtherThan(before: RgbaImage, pixels = 1000): Promise<RgbaImage> {
    const isOther = (picture: RgbaImage) => isAsLarge(picture, before) && countDifferent(picture, before, 4).pixels >= pixels;
    if (!isOther(await this.imageThat(isOther))) throw new Error('The picture did not change.');
    return this.restingImage();
  }

  /** Waits until the image equals `expected`. If it does not, both images and their difference are written as `name`. */
  async imageSameAs(expected: RgbaImage, name = 'editor'): Promise<void> {
    const last = await this.imageThat((picture) => isAsLarge(picture, expected) && countDifferent(picture, expected, 1).pixels === 0);
    await expectSamePixels(name, last, expected, { tolerance: 1 });
  }

  /** The first accepted image; after the timeout, the last one. */
  private async imageThat(accept: (picture: RgbaImage) => boolean): Promise<RgbaImage> {
    const endMs = Date.now() + PATIENCE_MS;
    for (;;) {
      const picture = await this.picture();
      if (accept(picture) || Date.now() > endMs) return picture;
      await this.page.waitForTimeout(LOOK_EVERY_MS);
    }
  }
}

function isAsLarge(a: RgbaImage, b: RgbaImage): boolean {
  return a.width === b.width && a.height === b.height;
}
