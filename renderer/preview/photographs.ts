import { pictureSize, takePhotograph } from '../../export/captures/acquire/take-photograph.ts';
import type { AcquiredCamera } from '../../export/captures/acquire/write-transforms.ts';
import { createPhotographer, type Photographer } from '../../export/runtime/photographer.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import type { FromPreview, PhotographsRequest, ToPreview } from '../preview-protocol.ts';
import { openHeldPlayer } from './held-player.ts';
import { createLayerGate } from './layer-gate.ts';

/** Takes photographs of a scene, for an acquisition. A page takes those of one program and is then discarded. */
export interface Photographs {
  /** Handles a message of the editor. Returns false if it is not for the photographs. */
  receive(message: ToPreview): boolean;
}

/** Until the first photograph. */
const FIRST_SIDE_PX = 16;

export function createPhotographs(send: (message: FromPreview, transfer?: Transferable[]) => void): Photographs {
  let set: { readonly gl: WebGL2RenderingContext; readonly canvas: HTMLCanvasElement; readonly photographer: Photographer } | null = null;
  let problems: readonly Diagnostic[] = [];
  const fail = (error: unknown) => {
    const reason = error instanceof Error ? error.message : String(error);
    send({
      kind: 'render-failed',
      diagnostic: { code: 'SCR069', severity: 'error', message: `The scene cannot be photographed: ${reason}` },
    });
  };
  /** Sends the first error, if there is one. */
  const sendProblem = (): boolean => {
    const broken = problems.find(({ severity }) => severity === 'error');
    if (broken) send({ kind: 'render-failed', diagnostic: broken });
    return broken !== undefined;
  };
  const begin = async (request: PhotographsRequest) => {
    const gate = createLayerGate();
    gate.show({ left: request.layer, right: null, probed: null }, []);
    const { canvas, gl, player } = await openHeldPlayer({
      request,
      gate,
      widthPx: FIRST_SIDE_PX,
      heightPx: FIRST_SIDE_PX,
      onDiagnostics: (diagnostics) => {
        problems = diagnostics;
      },
    });
    set = { gl, canvas, photographer: createPhotographer(gl, player, request.layer) };
    if (!sendProblem()) send({ kind: 'photographed', photograph: null });
  };
  const take = async (camera: AcquiredCamera, worldFromCamera: readonly number[]) => {
    if (!set) throw new Error('nothing is loaded.');
    const { gl, canvas, photographer } = set;
    const [widthPx, heightPx] = pictureSize(camera);
    if (canvas.width !== widthPx || canvas.height !== heightPx) Object.assign(canvas, { width: widthPx, height: heightPx });
    if (gl.drawingBufferWidth !== widthPx || gl.drawingBufferHeight !== heightPx) {
      throw new Error(`this computer cannot draw photographs of ${camera.widthPx} × ${camera.heightPx}.`);
    }
    const photograph = await takePhotograph(camera, worldFromCamera, photographer.take);
    if (gl.isContextLost()) throw new Error('the graphics device was lost.');
    if (sendProblem()) return;
    send({ kind: 'photographed', photograph }, [photograph.color.pixels.buffer, photograph.depth.meters.buffer]);
  };
  return {
    receive: (message) => {
      switch (message.kind) {
        case 'photographs-begin':
          begin(message.request).catch(fail);
          return true;
        case 'photograph':
          take(message.camera, message.worldFromCamera).catch(fail);
          return true;
        default:
          return false;
      }
    },
  };
}
