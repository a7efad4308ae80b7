import type { CDPSession, Page } from 'playwright-core';
import type { Point } from '../../tools/lib/center-of.ts';

const STEPS = 8;

/** Touch input, as the browser reports it. */
export class Hand {
  private readonly session: CDPSession;

  private constructor(session: CDPSession) {
    this.session = session;
  }

  static async on(page: Page): Promise<Hand> {
    return new Hand(await page.context().newCDPSession(page));
  }

  async put(...points: readonly Point[]): Promise<void> {
    await this.send('touchStart', points);
  }

  async slide(...points: readonly Point[]): Promise<void> {
    await this.send('touchMove', points);
  }

  async lift(): Promise<void> {
    await this.send('touchEnd', []);
  }

  /** Cancels the touch, as the browser does for a call or a system gesture. */
  async lose(): Promise<void> {
    await this.send('touchCancel', []);
  }

  async drag(from: Point, to: Point): Promise<void> {
    await this.put(from);
    for (let step = 1; step <= STEPS; step++) await this.slide(between(from, to, step / STEPS));
    await this.lift();
  }

  private async send(type: 'touchStart' | 'touchMove' | 'touchEnd' | 'touchCancel', points: readonly Point[]): Promise<void> {
    const touchPoints = points.map(({ x, y }, id) => ({ x, y, id }));
    await this.session.send('Input.dispatchTouchEvent', { type, touchPoints });
  }
}

function between(from: Point, to: Point, part: number): Point {
  return { x: from.x + (to.x - from.x) * part, y: from.y + (to.y - from.y) * part };
}
