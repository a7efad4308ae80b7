import { z } from 'zod';

/**
 * Everything the editor may ask of its host, and all that crosses: name → input and output. The Electron preload, the loopback
 * server, the editor's client and the tests' fake are made from this table. All calls are asynchronous; a refusal rejects with
 * a `HostError` whose diagnostic says why.
 *
 * The host reads and writes files; it does not understand documents. Texts cross as they stand on disk.
 */

const diagnostic = z.object({
  code: z.string().regex(/^SCR\d{3}$/),
  severity: z.enum(['error', 'warning', 'info']),
  message: z.string(),
  nodeId: z.string().optional(),
  port: z.string().optional(),
  file: z.string().optional(),
  line: z.number().optional(),
  column: z.number().optional(),
  fix: z.string().optional(),
});

/** Id of an open project, valid while it is open. Never a path. */
const handle = z.string().regex(/^[a-z0-9]{16,64}$/);

/** Relative to the project folder, `/` between parts; the host refuses what leaves the folder. */
const projectPath = z.string().min(1).max(512);

/** Larger than any model a phone can hold, small enough to be held in memory. */
export const MAX_ASSET_BYTES = 512 * 2 ** 20;

/** Of an asset that is copied with its nodes: clipboards take some hundred megabytes of text. */
export const MAX_COPIED_BYTES = 32 * 2 ** 20;

const MAX_POSTER_BYTES = 8 * 2 ** 20;

function isBearable(bytes: Uint8Array): boolean {
  return bytes.length <= MAX_ASSET_BYTES;
}

const projectFiles = z.object({
  /** Text of `project.scrim.json`. */
  project: z.string().max(64 * 2 ** 20),
  /** Text of `project.layout.json`; null where there is none. */
  layout: z
    .string()
    .max(64 * 2 ** 20)
    .nullable(),
  /** Texts below `shaders/`, by file name. */
  sources: z.record(z.string(), z.string().max(4 * 2 ** 20)),
});

const openProject = z.object({
  handle,
  /** For the title bar; never sent back. */
  displayPath: z.string(),
  files: projectFiles,
  /** Hash over the files as read; a save names the one it started from. */
  revision: z.string(),
  /** Ends in `/`, on the preview's origin: a path of the project's after it reads that file. */
  assetBaseUrl: z.string(),
  /** Files below `assets/`, with their sizes. */
  assetFiles: z.array(z.object({ path: projectPath, bytes: z.number() })),
  /** Unsaved work found after a crash, other than the files. From now on it counts as this window's own. */
  recovery: projectFiles.nullable(),
  /** Whether another window or tab shows the project already. */
  openElsewhere: z.boolean(),
});

/**
 * `url` is on the preview's origin: for a recording its folder, ending in `/`, with `session.json` in it; for a room the JSON of
 * its capture, or null where the emulator makes the room itself. The id of a room is `room/NAME`.
 */
const sessionSource = z.object({ id: z.string(), title: z.string(), kind: z.enum(['recorded', 'room']), url: z.string().nullable() });

/** Of a rendered picture, pixels: WebGL 2 has at least 2,048. */
const side = z.number().int().min(1).max(8192);

const pictureUrl = z.string().startsWith('data:image/jpeg;base64,').optional();

/** A picture of what the page shows, as JPEG of `POSTER_SIZE`; null or left out where the editor has none. */
const poster = z.instanceof(Uint8Array).refine(isPosterJpeg, 'no JPEG of a bearable size');

/** ISO 10918-1 B.1.1.3: what every JPEG begins with. */
function isPosterJpeg(bytes: Uint8Array): boolean {
  return bytes.length <= MAX_POSTER_BYTES && bytes[0] === 0xff && bytes[1] === 0xd8 && bytes[2] === 0xff;
}

/** A command of the editor's, by which its menu asks for it. */
const menuCommand = z.string().regex(/^[a-z]+\.[a-z-]+$/);

/** What the editor's own menus offer, for the window's. */
const platformMenu = z.object({
  label: z.string().max(64),
  entries: z
    .array(
      z.union([
        z.literal('line'),
        z.object({
          command: menuCommand,
          label: z.string().max(128),
          /** As `renderer/keybinding.ts` writes them; null where there is none. */
          keybinding: z.string().max(64).nullable(),
          enabled: z.boolean(),
        }),
      ]),
    )
    .max(64),
});

export const HOST_CONTRACT = {
  'app.info': {
    input: z.object({}),
    output: z.object({
      shell: z.enum(['electron', 'server']),
      version: z.string(),
      /** Address of the preview page, on an origin of its own. */
      previewUrl: z.string(),
      /** What to open at start. */
      startPath: z.string().nullable(),
      /** `types`: the node types that they use. `picture`: what they show, as a `data:` address; left out where there is none. */
      examples: z.array(z.object({ title: z.string(), path: z.string(), types: z.array(z.string()), picture: pictureUrl })),
      /** What a new project can begin with, the default first. */
      templates: z.array(z.object({ name: z.string(), title: z.string(), description: z.string(), picture: pictureUrl })),
      canPickFolders: z.boolean(),
    }),
  },
  /** Closes the window without asking again: the answer to `close-requested`. Does nothing where the shell has no window. */
  'app.close': { input: z.object({}), output: z.object({}) },
  /** What the window's own menu has, from now on. Does nothing where the shell has no window. */
  'menu.show': { input: z.object({ menus: z.array(platformMenu).max(16) }), output: z.object({}) },
  /** Asks the person for a folder; null when they cancel or the shell has no dialog. */
  'folder.pick': {
    input: z.object({ purpose: z.enum(['new', 'open', 'save-as', 'export', 'render']) }),
    output: z.object({ path: z.string().nullable() }),
  },
  'project.open': { input: z.object({ path: z.string().min(1).max(4096) }), output: openProject },
  /** A project made from a template, in an empty or new folder whose name becomes its title; it is open then. */
  'project.create': { input: z.object({ path: z.string().min(1).max(4096), template: z.string().min(1).max(64) }), output: openProject },
  /**
   * Atomic: all files or none. Rejects with SCR063 when the files changed since `revision`, unless `overwrite`: then `kept` is the
   * project path of the folder with what was written over, null where nothing was. Shaders that were never loaded here stay.
   * Rejects with SCR066 while another process holds the project's lock, and with SCR067 when the folder is gone.
   */
  'project.save': {
    input: z.object({ handle, files: projectFiles, revision: z.string(), overwrite: z.boolean() }),
    output: z.object({ revision: z.string(), kept: projectPath.nullable() }),
  },
  /** Takes away the lock of another process, which finds out before it writes. For a person who knows that nobody saves. */
  'project.break-lock': { input: z.object({ handle }), output: z.object({}) },
  /** A copy, assets included, in an empty or new folder; it becomes an open project of its own. */
  'project.save-as': { input: z.object({ handle, path: z.string().min(1).max(4096), files: projectFiles }), output: openProject },
  /** Keeps unsaved work for recovery; null forgets it. */
  'project.autosave': { input: z.object({ handle, files: projectFiles.nullable() }), output: z.object({}) },
  'project.close': { input: z.object({ handle }), output: z.object({}) },
  /** Copies bytes into `assets/` under a free name made from `name`. */
  'asset.import': {
    input: z.object({ handle, name: z.string().min(1).max(255), bytes: z.instanceof(Uint8Array).refine(isBearable, 'too large') }),
    output: z.object({ path: projectPath }),
  },
  /** What an asset has in its file, for copying it to another project. Rejects with SCR005 above `MAX_COPIED_BYTES`. */
  'asset.read': { input: z.object({ handle, path: projectPath }), output: z.object({ base64: z.string() }) },
  /** Recorded sessions and emulated rooms that the preview can play. */
  'session.list': { input: z.object({ handle }), output: z.array(sessionSource) },
  /**
   * Exports the files as given, saved or not. `out` is absolute. Its progress comes as events; it is over when this answers, also
   * where it was cancelled: nothing was written then, and `ok` is false without an error among the diagnostics.
   */
  'export.run': {
    input: z.object({ handle, files: projectFiles, out: z.string().min(1).max(4096), poster: poster.nullable().optional() }),
    output: z.object({ ok: z.boolean(), out: z.string(), diagnostics: z.array(diagnostic), bytes: z.number() }),
  },
  /**
   * Begins to write pictures of frames into a new folder beside `out`, which takes its place at the end. `out` is absolute, and may
   * be missing, empty, or hold what was rendered earlier: anything else is SCR061. One at a time for each project.
   */
  'frames.begin': {
    input: z.object({ handle, out: z.string().min(1).max(4096), widthPx: side, heightPx: side }),
    output: z.object({}),
  },
  /** Premultiplied RGBA, rows from the top; written as `000012.png`. Where it cannot be, nothing stays of those before. */
  'frames.add': {
    input: z.object({
      handle,
      number: z.number().int().min(0).max(999_999),
      rgba: z.instanceof(Uint8Array).refine(isBearable, 'too large'),
    }),
    output: z.object({}),
  },
  /** Puts the folder in its place, with a `sequence.json` that says what it holds. */
  'frames.finish': {
    input: z.object({ handle, title: z.string().max(1000), frameRateHz: z.number().positive() }),
    output: z.object({ out: z.string(), pictures: z.number() }),
  },
  /** Nothing is left of them then. */
  'frames.cancel': { input: z.object({ handle }), output: z.object({}) },
  /** Ends the export of a project, if there is one. */
  'export.cancel': { input: z.object({ handle }), output: z.object({}) },
} as const;

export type HostMethod = keyof typeof HOST_CONTRACT;
export type HostInput<M extends HostMethod> = z.infer<(typeof HOST_CONTRACT)[M]['input']>;
export type HostOutput<M extends HostMethod> = z.infer<(typeof HOST_CONTRACT)[M]['output']>;

/** What the host tells the editor unasked. */
export const hostEvent = z.discriminatedUnion('kind', [
  z.object({ kind: z.literal('project-changed-outside'), handle, revision: z.string() }),
  /** What an export is at, for people. */
  z.object({ kind: z.literal('export-progress'), handle, text: z.string() }),
  /** The same where only shaders changed, with their texts; null for one that is not there. `from` is the revision before. */
  z.object({
    kind: z.literal('shaders-changed-outside'),
    handle,
    from: z.string(),
    revision: z.string(),
    shaders: z.array(z.object({ file: z.string(), before: z.string().nullable(), text: z.string().nullable() })),
  }),
  z.object({ kind: z.literal('menu'), command: menuCommand }),
  /** The window wants to close: answer with `app.close`, or ask about unsaved work first. */
  z.object({ kind: z.literal('close-requested') }),
]);
export type HostEvent = z.infer<typeof hostEvent>;

export interface Host {
  call<M extends HostMethod>(method: M, input: HostInput<M>): Promise<HostOutput<M>>;
  /** Returns the function that stops listening. */
  subscribe(listener: (event: HostEvent) => void): () => void;
}

export type ProjectFiles = z.infer<typeof projectFiles>;
export type OpenProject = z.infer<typeof openProject>;
export type SessionSource = z.infer<typeof sessionSource>;
export type HostDiagnostic = z.infer<typeof diagnostic>;
export type PlatformMenu = z.infer<typeof platformMenu>;
export type PlatformMenuEntry = PlatformMenu['entries'][number];
