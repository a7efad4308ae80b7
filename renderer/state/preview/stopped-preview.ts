import type { Editor } from '../editor/editor.ts';

/** What was kept of a project's preview: it runs, or it lost the graphics device. */
type Sign = 'running' | 'lost';

export interface StoppedPreviewOptions {
  readonly storage: Pick<Storage, 'getItem' | 'setItem' | 'removeItem'>;
  /** Whether the person asks, at this moment, for a project to open without its preview. */
  readonly asks: () => boolean;
  /** Whether another window shows the project: then its preview is the one that runs. */
  readonly isOpenElsewhere: (path: string) => Promise<boolean>;
}

const KEY = 'scrim-preview ';

/**
 * Keeps a sign while a project's preview runs. A project whose sign is still there when it is opened ended the graphics device, or
 * everything, the last time: its preview waits for the person, who can mend what did it first. `leave` ends what runs, as the page
 * does when it goes.
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
    // A copy that was saved goes on as it was.
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
    // Until it shows something, nothing is known that is newer.
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

/** Starts a preview that waits. */
export function startPreview({ preview }: Pick<Editor, 'preview'>): void {
  preview.setState({ stopped: null });
}
