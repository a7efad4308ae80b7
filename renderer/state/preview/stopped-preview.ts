import type { Editor } from '../editor/editor.ts';

/** Stored state of a project’s preview: it is running, or it lost the graphics device. */
type Sign = 'running' | 'lost';

export interface StoppedPreviewOptions {
  readonly storage: Pick<Storage, 'getItem' | 'setItem' | 'removeItem'>;
  /** Whether the user holds the key that opens a project without its preview. */
  readonly asks: () => boolean;
  /** Whether another window shows the project. Then the stored state is that of its preview. */
  readonly isOpenElsewhere: (path: string) => Promise<boolean>;
}

const KEY = 'scrim-preview ';

/**
 * Stores a mark while the preview of a project runs. If the mark still exists when the project is opened, Scrim ended during playback
 * or the graphics device was lost. The preview then waits until the user starts it, so that the cause can be fixed first. `leave`
 * removes the mark when the page closes.
 */
export function guardPreview(
  editor: Pick<Editor, 'document' | 'compile' | 'preview'>,
  { storage, asks, isOpenElsewhere }: StoppedPreviewOptions,
): { leave(): void; dispose(): void } {
  const { document, compile, preview } = editor;
  let path: string | null = null;
  const keep = (sign: Sign) => {
    if (path !== null && storage.getItem(KEY + path) !== sign) storage.setItem(KEY + path, sign);
  };
  const leave = () => {
    if (path !== null && storage.getItem(KEY + path) === 'running' && preview.getState().stopped === null) storage.removeItem(KEY + path);
  };
  const open = (next: string | null, sameWork: boolean) => {
    leave();
    path = next;
    // A project that was saved as a copy keeps its state.
    if (sameWork) run();
    if (next === null || sameWork) return;
    const sign = storage.getItem(KEY + next);
    const stopped = sign === 'lost' ? 'lost' : sign === 'running' ? 'broken-off' : asks() ? 'asked' : null;
    preview.setState({ stopped });
    if (stopped !== 'broken-off') return;
    void isOpenElsewhere(next).then((elsewhere) => {
      if (elsewhere && path === next && preview.getState().stopped === 'broken-off') preview.setState({ stopped: null });
    });
  };
  const run = () => {
    const { stopped, status } = preview.getState();
    if (stopped !== null || compile.getState().program === null) return;
    // Without a status from the preview the stored state is still the newest.
    if (path !== null && status === null && storage.getItem(KEY + path) === 'lost') return;
    keep(status?.state === 'lost' ? 'lost' : 'running');
  };
  const stops = [
    document.subscribe((state, before) => {
      if (state.open?.displayPath === before.open?.displayPath && state.open?.handle === before.open?.handle) return;
      open(state.open?.displayPath ?? null, before.open !== null && state.project === before.project);
    }),
    compile.subscribe((state, before) => {
      if (state.program !== before.program) run();
    }),
    preview.subscribe((state, before) => {
      if (state.stopped !== before.stopped || state.status?.state !== before.status?.state) run();
    }),
  ];
  return {
    leave,
    dispose: () => {
      for (const stop of stops) stop();
    },
  };
}

/** Starts a stopped preview. */
export function startPreview({ preview }: Pick<Editor, 'preview'>): void {
  preview.setState({ stopped: null });
}
