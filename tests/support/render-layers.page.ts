import { type OpenedJob, open as openRender, playAndRead, type RenderJob } from '../../app/cli/render/render.page.ts';
import { type LayerPixels, readColor } from '../../export/runtime/readback.ts';

const shots = new Map<string, LayerPixels>();

export function open(job: RenderJob): Promise<OpenedJob> {
  return openRender(job);
}

/** Plays a frame and keeps some of its layers. */
export async function take(frame: number, layers: readonly string[]): Promise<void> {
  shots.clear();
  const isPlayed = await playAndRead(frame, ({ player }) => {
    for (const layer of layers) {
      const shot = readColor(player.inspect(layer), 0);
      if (shot) shots.set(layer, shot);
    }
  });
  if (!isPlayed) throw new Error(`There is no frame ${frame}.`);
}

/** A layer of the last frame. */
export function shotOf(layer: string): LayerPixels {
  const shot = shots.get(layer);
  if (!shot) throw new Error(`There is no layer ${layer}.`);
  return shot;
}
