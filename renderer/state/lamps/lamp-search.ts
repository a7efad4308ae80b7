import type { FoundLamps } from '../../../nodes/kit/panorama/found-lamps.ts';
import type { Editor } from '../editor/editor.ts';
import type { LampSource } from './lamp-source.ts';
import type { LampAnswer, LampRequest, LampStage } from './messages.ts';

/** The part of `Worker` that is used. */
export interface LampWorker {
  postMessage(message: LampRequest, transfer: Transferable[]): void;
  onmessage: ((event: MessageEvent<LampAnswer>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  terminate(): void;
}

export type LampView =
  | { readonly state: 'searching'; readonly part: number }
  | { readonly state: 'found'; readonly found: FoundLamps; readonly stages: readonly LampStage[] }
  | { readonly state: 'failed'; readonly reason: string };

/**
 * Reads a panorama of the project, or its shots, and searches it in a worker.
 *
 * @returns Cancels the search, and releases the images of a result.
 */
export function searchLamps(
  editor: Pick<Editor, 'host' | 'document'>,
  { paths, stopsApart, options }: LampSource,
  start: () => LampWorker,
  show: (view: LampView) => void,
): () => void {
  let worker: LampWorker | null = null;
  let isOver = false;
  let images: readonly LampStage[] = [];
  const end = () => {
    worker?.terminate();
    worker = null;
  };
  const fail = (reason: string) => {
    end();
    if (!isOver) show({ state: 'failed', reason: `${paths.join(', ')} cannot be searched: ${reason.replace(/\.$/, '')}.` });
  };
  const begin = async () => {
    const { open } = editor.document.getState();
    if (open === null) return;
    const files: ArrayBuffer[] = [];
    for (const path of paths) {
      const { base64 } = await editor.host.call('asset.read', { handle: open.handle, path });
      if (isOver) return;
      files.push(Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)).buffer);
    }
    worker = start();
    worker.onerror = (event) => fail(event.message || 'its worker ended');
    worker.onmessage = ({ data }) => {
      if (data.kind === 'part') return show({ state: 'searching', part: data.part });
      if (data.kind === 'failed') return fail(data.reason);
      end();
      images = data.stages;
      show({ state: 'found', found: data.found, stages: data.stages });
    };
    worker.postMessage({ files, stopsApart, options }, files);
  };
  show({ state: 'searching', part: 0 });
  begin().catch((error: unknown) => fail(error instanceof Error ? error.message : String(error)));
  return () => {
    isOver = true;
    end();
    for (const { image } of images) image.close();
  };
}

export function startLampWorker(): LampWorker {
  return new Worker(new URL('./lamps.worker.ts', import.meta.url), { type: 'module', name: 'lamps' });
}
