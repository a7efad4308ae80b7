import { mkdir, writeFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { afterAll, afterEach, beforeAll, describe, expect, test } from '@jest/globals';
import { Quaternion, Vector3 } from 'three';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { layOutPanel, PX_PER_M } from '../../export/page/room-panel/panel-layout.ts';
import { TABLE_ROOM } from '../browser/emulator-kit.ts';
import { useBrowser } from '../support/browser.ts';
import { encodeImage, type RgbaImage } from '../support/image.ts';
import { type ServedExport, serveProject } from '../support/project-page.ts';
import { OUTPUT_FOLDER } from '../support/this-test.ts';
import { openXrPage, type XrPage } from '../xr/xr-page.ts';

const chromium = useBrowser();
let served: ServedExport;
beforeAll(async () => {
  served = await serveProject(resolve(import.meta.dirname, '../../nodes/world/surface-filter/example'));
});
afterAll(() => served.close());

const opened: XrPage[] = [];
afterEach(async () => {
  for (const xr of opened.splice(0)) await xr.close();
});

/** Two frames in a second, so that the page waits for five seconds in ten frames. */
const UNKNOWN_ROOM: EmulatorOptions = { room: TABLE_ROOM, roomScanned: false, extra: ['plane-detection'], framesPerSecond: 2 };
const EYE = [0, 1.6, 0] as const;

/** Keeps how often the page asked for a scan, and refuses it where `globalThis.refuseScan` is set. */
const SPY = `
  globalThis.scans = 0;
  const request = navigator.xr.requestSession.bind(navigator.xr);
  navigator.xr.requestSession = async (mode, init) => {
    const session = await request(mode, init);
    const capture = session.initiateRoomCapture.bind(session);
    session.initiateRoomCapture = async () => {
      globalThis.scans++;
      if (globalThis.refuseScan) throw new DOMException('The visitor refused.', 'NotAllowedError');
      await capture();
    };
    return session;
  };
`;

async function enter(options: EmulatorOptions): Promise<XrPage> {
  const xr = await openXrPage(chromium.browser, served.url, { ...UNKNOWN_ROOM, ...options }, { width: 480, height: 360 }, SPY);
  opened.push(xr);
  // Level, as the table and its ball are before it.
  await xr.setPose({ position: EYE, quaternion: [0, 0, 0, 1] });
  await xr.enter();
  return xr;
}

const scansOf = (xr: XrPage) => xr.page.evaluate(() => (globalThis as unknown as { scans: number }).scans);

/** Pixels of the blue ball that the page puts on the table. */
function countBall({ data }: RgbaImage): number {
  let count = 0;
  for (let i = 0; i < data.length; i += 4) {
    const [r = 0, , b = 0] = data.subarray(i, i + 3);
    if (b > 60 && b > 2 * r) count++;
  }
  return count;
}

describe('a page that reads planes, on a phone that knows no surface of the room', () => {
  test('offers a scan after five seconds, starts it by a button only, and shows what the surfaces hold', async () => {
    const xr = await enter({ device: 'phone' });
    const scan = xr.page.getByRole('button', { name: 'Scan the room' });
    await xr.step(4);
    expect(await scan.count()).toBe(0);
    await xr.step(8);
    await scan.waitFor();
    expect(await scansOf(xr)).toBe(0);
    expect(countBall(await xr.readLayer())).toBe(0);
    await mkdir(join(OUTPUT_FOLDER, 'room-scan'), { recursive: true });
    await writeFile(join(OUTPUT_FOLDER, 'room-scan', 'phone.png'), await xr.page.screenshot());
    await scan.click();
    await xr.step(3);
    expect(await scan.count()).toBe(0);
    expect(await scansOf(xr)).toBe(1);
    expect(countBall(await xr.readLayer())).toBeGreaterThan(20);
    expect(xr.errors).toEqual([]);
  });

  test('says that nothing was scanned where the visitor refuses, and does not ask again', async () => {
    const xr = await enter({ device: 'phone' });
    await xr.page.evaluate(() => Object.assign(globalThis, { refuseScan: true }));
    await xr.step(12);
    await xr.page.getByRole('button', { name: 'Scan the room' }).click();
    await xr.page.getByText('The room was not scanned').waitFor();
    await xr.step(4);
    expect(await xr.page.getByRole('button', { name: 'Scan the room' }).count()).toBe(0);
    expect(await scansOf(xr)).toBe(1);
    expect(xr.errors).toEqual([]);
  });
});

describe('a page that reads planes, in a headset that knows no surface of the room and shows no page', () => {
  const labels = ['Scan the room', 'Not now'];
  const controls = labels.map((label) => ({ kind: 'button', node: '', param: '', label, value: 0 }) as const);
  const layout = layOutPanel('The device knows no surface of this room.', controls, () => 90);

  /** Points the right controller at a button of the panel, 0.9 m ahead and 0.5 m below the eyes, and pulls its trigger. */
  async function press(xr: XrPage, label: string): Promise<void> {
    const part = layout.parts[labels.indexOf(label)];
    if (!part) throw new Error(`There is no button “${label}”.`);
    const aheadM = Math.sqrt(0.9 ** 2 - 0.5 ** 2);
    const upM = (layout.heightPx / 2 - part.y - part.height / 2) / PX_PER_M;
    const rightM = (part.x + part.width / 2 - layout.widthPx / 2) / PX_PER_M;
    const at = new Vector3(EYE[0] + rightM, EYE[1] - 0.5 + (upM * aheadM) / 0.9, EYE[2] - aheadM - (upM * 0.5) / 0.9);
    const hand = new Vector3(EYE[0] + 0.25, EYE[1] - 0.3, EYE[2] - 0.1);
    const turn = new Quaternion().setFromUnitVectors(new Vector3(0, 0, -1), at.sub(hand).normalize());
    await xr.page.evaluate(
      ([p, q]) => {
        const controller = scrimEmulator?.current?.device.controllers.right;
        controller?.position.set(p[0], p[1], p[2]);
        controller?.quaternion.set(q[0], q[1], q[2], q[3]);
      },
      [hand.toArray(), turn.toArray()] as const,
    );
    for (const value of [0, 1, 0]) {
      await xr.page.evaluate((pulled) => scrimEmulator?.current?.device.controllers.right?.updateButtonValue('trigger', pulled), value);
      await xr.step(2);
    }
  }

  const countDrawn = ({ data }: RgbaImage) => data.filter((alpha, i) => i % 4 === 3 && alpha > 0).length;

  test('offers the scan on a panel in the room, which goes when it is pressed', async () => {
    const xr = await enter({ device: 'headset' });
    await xr.step(4);
    expect(countDrawn(await xr.readLayer())).toBe(0);
    await xr.step(10);
    const offered = await xr.readLayer();
    expect(countDrawn(offered)).toBeGreaterThan(1000);
    await mkdir(join(OUTPUT_FOLDER, 'room-scan'), { recursive: true });
    await writeFile(join(OUTPUT_FOLDER, 'room-scan', 'headset.png'), encodeImage(offered));
    await press(xr, 'Scan the room');
    expect(await scansOf(xr)).toBe(1);
    const after = await xr.readLayer();
    expect(countBall(after)).toBeGreaterThan(20);
    expect(xr.errors).toEqual([]);
  });

  test('takes the panel away without a scan at “Not now”', async () => {
    const xr = await enter({ device: 'headset' });
    await xr.step(14);
    await press(xr, 'Not now');
    await xr.step(4);
    expect(countDrawn(await xr.readLayer())).toBe(0);
    expect(await scansOf(xr)).toBe(0);
    expect(xr.errors).toEqual([]);
  });
});
