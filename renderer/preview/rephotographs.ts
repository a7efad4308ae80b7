import { type DrawRephotograph, type RephotographMethod, rephotograph } from '../../export/captures/evaluate/rephotograph.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { createRephotographer, type Rephotographer } from '../../export/runtime/rephotographer.ts';
import { CaptureError } from '../../nodes/kit/capture.ts';
import type { FromPreview, RephotographRequest, ToPreview } from '../preview-protocol.ts';
import { pageFetch } from './network.ts';

/** Draws the photographs of a capture, each from all others. A page draws those of one capture and is then discarded. */
export interface Rephotographs {
  /** Handles a message of the editor. Returns false if it is not for these photographs. */
  receive(message: ToPreview): boolean;
}

export function createRephotographs(send: (message: FromPreview, transfer?: Transferable[]) => void): Rephotographs {
  let capture: Rephotographer | null = null;
  let left: { readonly index: number; readonly draw: DrawRephotograph } | null = null;
  const fail = (error: unknown) => {
    const reason = error instanceof Error ? error.message.replace(/\.$/, '') : String(error);
    const code = error instanceof CaptureError ? 'SCR032' : 'SCR053';
    send({ kind: 'render-failed', diagnostic: { code, severity: 'error', message: `The capture cannot be rephotographed: ${reason}.` } });
  };
  const begin = async ({ assetBaseUrl, folder, methods, blended }: RephotographRequest) => {
    const gl = document.createElement('canvas').getContext('webgl2', { alpha: true, antialias: false, depth: true });
    if (!gl) throw new Error('this browser has no WebGL 2.');
    const { load } = createFetchAssetSource(new URL(folder, assetBaseUrl).href, pageFetch);
    capture = await createRephotographer(gl, load, methods, blended);
    send({ kind: 'rephotographed', shot: null });
  };
  const take = async (index: number, method: RephotographMethod) => {
    const view = capture?.views[index];
    if (!capture || !view) throw new Error('nothing is loaded.');
    if (left?.index !== index) left = { index, draw: await rephotograph(capture, index) };
    const shot = await left.draw(method);
    const { widthPx, heightPx } = view;
    send({ kind: 'rephotographed', shot: { ...shot, widthPx, heightPx } }, [shot.shown.buffer, shot.error.buffer]);
  };
  return {
    receive: (message) => {
      switch (message.kind) {
        case 'rephotograph-begin':
          begin(message.request).catch(fail);
          return true;
        case 'rephotograph':
          take(message.index, message.method).catch(fail);
          return true;
        default:
          return false;
      }
    },
  };
}
