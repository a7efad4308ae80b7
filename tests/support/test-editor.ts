import { newProject } from '../../export/graph/new-project.ts';
import type { Project } from '../../export/graph/project.ts';
import { saveProject } from '../../export/graph/save.ts';
import { DEFINITIONS, SHADERS } from '../../nodes/generated/definitions.gen.ts';
import type { EditorClock } from '../../renderer/clock.ts';
import { createEditor, type Editor } from '../../renderer/state/editor/editor.ts';
import { DEFAULT_PREFERENCES } from '../../renderer/state/editor/preferences.ts';
import { DEFAULT_SIZES } from '../../renderer/state/editor/ui.ts';
import { openPath } from '../../renderer/state/files/files.ts';
import { createFakeHost, type FakeFolder, type FakeHost } from './fake-host.ts';

/** A clock that only `pass` advances. */
export interface TestClock extends EditorClock {
  pass(ms: number): void;
}

export function createTestClock(): TestClock {
  let nowMs = 0;
  let waiting: { readonly atMs: number; readonly run: () => void }[] = [];
  const after: EditorClock['after'] = (ms, run) => {
    const entry = { atMs: nowMs + ms, run };
    waiting.push(entry);
    return () => {
      waiting = waiting.filter((other) => other !== entry);
    };
  };
  return {
    after,
    nextFrame: (run) => after(16, run),
    pass: (ms) => {
      nowMs += ms;
      const due = waiting.filter(({ atMs }) => atMs <= nowMs);
      waiting = waiting.filter(({ atMs }) => atMs > nowMs);
      for (const { run } of due) run();
    },
  };
}

export interface TestEditor {
  readonly editor: Editor;
  readonly host: FakeHost;
  readonly clock: TestClock;
}

/** An editor without its user interface, with the library of Scrim, an in-memory host and repeatable random numbers. */
export async function openTestEditor(project: Project = newProject('Test'), folder: FakeFolder = {}): Promise<TestEditor> {
  const host = createFakeHost(saveProject(project), {}, folder);
  const clock = createTestClock();
  let seed = 1;
  const random = () => {
    seed = (seed * 48_271) % 2_147_483_647;
    return seed / 2_147_483_647;
  };
  let copied = '';
  const editor = createEditor({
    host,
    clock,
    random,
    library: { definitions: DEFINITIONS, shaders: SHADERS },
    mac: false,
    clipboard: {
      read: async () => copied,
      write: async (text) => {
        copied = text;
      },
    },
    keepFile: () => {},
    sizes: DEFAULT_SIZES,
    // Tests of places state those of nodes without thumbnails.
    preferences: { ...DEFAULT_PREFERENCES, thumbnails: false },
  });
  if (!(await openPath(editor, '/project'))) throw new Error('The project did not open.');
  return { editor, host, clock };
}
