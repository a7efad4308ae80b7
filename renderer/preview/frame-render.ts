import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { FrameRenderRequest, FromPreview, ToPreview } from '../preview-protocol.ts';
import { createFrameEncoder, type FrameEncoder } from './frame-encoder.ts';
import { openHeldPlayer } from './held-player.ts';
import { createLayerGate } from './layer-gate.ts';
import { type OpenRenderSource, openRenderSource } from './render-source.ts';

/**
 * Renders frames of a recording or an emulated room one by one, with the same pixels as `scrim render`. A page makes one frame render
 * and is then discarded.
 */
export interface FrameRender {
  /** Handles a message of the editor. Returns false if it is not for the frame render. */
  receive(message: ToPreview): boolean;
}

/** State of a frame render. */
interface RenderSetup {
  readonly gl: WebGL2RenderingContext;
  readonly source: OpenRenderSource;
  readonly encoder: FrameEncoder | null;
  /** The canvas that the encoder reads. */
  readonly screen: HTMLCanvasElement;
}

export function createFrameRender(send: (message: FromPreview, transfer?: Transferable[]) => void): FrameRender {
  let set: RenderSetup | null = null;
  let problems: readonly Diagnostic[] = [];
  const fail = (error: unknown) => {
    const reason = error instanceof Error ? error.message : String(error);
    send({ kind: 'render-failed', diagnostic: { code: 'SCR053', severity: 'error', message: `The frames cannot be rendered: ${reason}` } });
  };
  const begin = async (request: FrameRenderRequest) => {
    const { program, video, widthPx, heightPx } = request;
    const gate = createLayerGate();
    const { canvas, gl, player } = await openHeldPlayer({
      request,
      widthPx,
      heightPx,
      gate,
      onDiagnostics: (diagnostics) => {
        problems = diagnostics;
      },
    });
    const { output: source, diagnostics } = await openRenderSource(request.source, gl, program, player);
    const [broken] = [...diagnostics, ...problems].filter(({ severity }) => severity === 'error');
    if (broken) return send({ kind: 'render-failed', diagnostic: broken });
    if (source === null) throw new Error('the preview source cannot be read.');
    const screen = source.onCanvas ? canvas : copyOf(canvas);
    const encoder = video === null ? null : await createFrameEncoder({ canvas: screen, widthPx, heightPx, frameRateHz: video.frameRateHz });
    set = { gl, source, encoder, screen };
    send({ kind: 'frame-rendered', frame: null });
  };
  const draw = async ({ gl, source, encoder, screen }: RenderSetup, timeS: number, keep: boolean) => {
    if (!(await source.draw(timeS))) throw new Error('a frame of the recording is damaged.');
    if (gl.isContextLost()) throw new Error('the graphics device was lost.');
    if (keep && encoder) {
      if (!source.onCanvas) show(screen, source.read());
      await encoder.add();
    }
    if (!keep || encoder) return send({ kind: 'frame-rendered', frame: null });
    const pixels = source.read();
    send({ kind: 'frame-rendered', frame: pixels }, [pixels.buffer]);
  };
  const end = async ({ encoder }: RenderSetup) => send({ kind: 'render-finished', file: (await encoder?.finish()) ?? null });
  return {
    receive: (message) => {
      switch (message.kind) {
        case 'render-begin':
          begin(message.request).catch(fail);
          return true;
        case 'render-frame':
          if (set) draw(set, message.timeS, message.keep).catch(fail);
          return true;
        case 'render-end':
          if (set) end(set).catch(fail);
          return true;
        default:
          return false;
      }
    },
  };
}

/** A canvas of the same size for pixels that were read back. */
function copyOf({ width, height, ownerDocument }: HTMLCanvasElement): HTMLCanvasElement {
  const copy = ownerDocument.createElement('canvas');
  copy.width = width;
  copy.height = height;
  return copy;
}

function show(screen: HTMLCanvasElement, pixels: Uint8Array<ArrayBuffer>): void {
  const image = new ImageData(new Uint8ClampedArray(pixels.buffer), screen.width, screen.height);
  screen.getContext('2d')?.putImageData(image, 0, 0);
}
