import type { Photograph } from '../../../export/captures/acquire/take-photograph.ts';
import type { AcquiredCamera } from '../../../export/captures/acquire/write-transforms.ts';
import type { PhotographsRequest } from '../../preview-protocol.ts';
import type { FrameRenderLink } from '../editor/editor.ts';

/** Shows what one camera of an acquisition sees. Of several requests, only the newest is answered. */
export interface PreviewedCamera {
  show(camera: AcquiredCamera, worldFromCamera: readonly number[]): void;
  /** Closes the page, which then shows nothing more. */
  close(): void;
}

interface Listener {
  readonly onPhotograph: (photograph: Photograph, worldFromCamera: readonly number[]) => void;
  readonly onError: (message: string) => void;
}

export function previewCameras(link: FrameRenderLink, request: PhotographsRequest, { onPhotograph, onError }: Listener): PreviewedCamera {
  let wanted: { readonly camera: AcquiredCamera; readonly worldFromCamera: readonly number[] } | null = null;
  let busy = true;
  let closed = false;
  const run = async (): Promise<void> => {
    busy = true;
    while (wanted !== null) {
      const shown = wanted;
      wanted = null;
      const answer = await link.ask({ kind: 'photograph', ...shown });
      if (closed) return;
      if (answer.kind === 'render-failed') onError(answer.diagnostic.message);
      else if (answer.kind === 'photographed' && answer.photograph) onPhotograph(answer.photograph, shown.worldFromCamera);
    }
    busy = false;
  };
  void link.ask({ kind: 'photographs-begin', request }).then((answer) => {
    if (closed) return undefined;
    // A page that failed stays silent: it would fail again for each camera.
    if (answer.kind !== 'render-failed') return run();
    onError(answer.diagnostic.message);
    return undefined;
  });
  return {
    show: (camera, worldFromCamera) => {
      wanted = { camera, worldFromCamera };
      if (!busy && !closed) void run();
    },
    close: () => {
      closed = true;
      link.close();
    },
  };
}
