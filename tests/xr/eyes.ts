import type { XrPage } from './xr-page.ts';

/** A view of the session. */
export interface Eye {
  /** In the space `local-floor`, meters. */
  readonly position: readonly [number, number, number];
  readonly clipFromView: readonly number[];
  /** Left border and width of its part of the layer, px. */
  readonly left: number;
  readonly width: number;
}

/** Eyes as WebXR reports them to the page, asked of the running session by the test. The layer is `layerPx` wide. */
export async function eyesOf(xr: XrPage, layerPx: number): Promise<Eye[]> {
  const eyes = await xr.page.evaluate(async () => {
    const session = (scrimEmulator?.current?.device as unknown as { activeSession?: XRSession })?.activeSession;
    if (!session) throw new Error('There is no session.');
    const space = await session.requestReferenceSpace('local-floor');
    const told = new Promise<{ position: number[]; projection: number[] }[]>((resolve) => {
      session.requestAnimationFrame((_time, frame) => {
        const views = frame.getViewerPose(space)?.views ?? [];
        resolve(
          views.map(({ transform: { position }, projectionMatrix }) => ({
            position: [position.x, position.y, position.z],
            projection: [...projectionMatrix],
          })),
        );
      });
    });
    await scrimEmulator?.current?.stepFrame();
    return told;
  });
  const width = layerPx / eyes.length;
  return eyes.map(({ position, projection }, i) => ({
    position: position as unknown as Eye['position'],
    clipFromView: projection,
    left: i * width,
    width,
  }));
}
