import { z } from 'zod';
import { diagnostic, documentText, handle, isWithinLimit, projectFiles, projectPath, side } from './call-parts.ts';
import { PHOTOGRAPH_CALLS } from './photograph-calls.ts';
import { RECIPE_CALLS } from './recipe-calls.ts';
import { REPHOTOGRAPH_CALLS } from './rephotograph-calls.ts';
import { SIMPLIFY_CALLS } from './simplify-calls.ts';

/*
 * The contract between editor and host: inputs and outputs of all calls, and the events. The preload script of Electron, the loopback
 * server, the editor’s client and the fake of the tests derive from this table. All calls are asynchronous; a rejected call throws a
 * `HostError` whose diagnostic says why.
 *
 * The host reads and writes files; it does not interpret documents. Texts are passed unchanged.
 */

/** Limit for an asset that is copied with its nodes. Clipboards take some hundred megabytes of text. */
export const MAX_COPIED_BYTES = 32 * 2 ** 20;

const MAX_POSTER_BYTES = 8 * 2 ** 20;

/** Files in `assets/` with their sizes. */
const assetFiles = z.array(z.object({ path: projectPath, bytes: z.number() }));

const openProject = z.object({
  handle,
  /** Path for the title bar. Never sent back. */
  displayPath: z.string(),
  files: projectFiles,
  /** Hash of the files. A save names the revision that it is based on. */
  revision: z.string(),
  /** URL on the origin of the preview, ending in `/`. Append a path inside the project folder to load that file. */
  assetBaseUrl: z.string(),
  assetFiles,
  /** Unsaved changes found after a crash; null if there are none. This window owns them from now on. */
  recovery: projectFiles.nullable(),
  /** Whether another window or tab shows the project. */
  openElsewhere: z.boolean(),
});

/**
 * A preview source. `url` is on the origin of the preview: for a recording the URL of its folder with `session.json`, ending in `/`;
 * for a room that of its capture, or null for the emulator’s built-in room. The id of a room is `room/NAME`.
 */
const sessionSource = z.object({ id: z.string(), title: z.string(), kind: z.enum(['recorded', 'room']), url: z.string().nullable() });

/** Path of an image in the folder of a session. */
const sessionFile = z.string().regex(/^(?:color\/\d{6}\.jpg|depth\/\d{6}\.png|room\.voxels)$/);

const thumbnailUrl = z.string().startsWith('data:image/jpeg;base64,').optional();

/** The poster as JPEG of `POSTER_SIZE`; null or absent if the preview shows nothing. */
const poster = z.instanceof(Uint8Array).refine(isPosterJpeg, 'not a JPEG, or too large');

/** Whether the bytes begin like every JPEG (ISO 10918-1, B.1.1.3), and are not too many. */
function isPosterJpeg(bytes: Uint8Array): boolean {
  return bytes.length <= MAX_POSTER_BYTES && bytes[0] === 0xff && bytes[1] === 0xd8 && bytes[2] === 0xff;
}

/** Address of a published page. */
const pageAddress = z
  .string()
  .max(2048)
  .refine((text) => URL.canParse(text) && /^https?:$/.test(new URL(text).protocol), 'not an address of the web');

const sizes = z.object({ raw: z.number(), gzip: z.number() });

/** What an export wrote: an extract of `report.json`. */
const exportReport = z.object({
  files: z.number(),
  bytes: sizes,
  /** Sizes of assets by project path, after compression. `gpuBytes` is an estimate. */
  assets: z.array(
    z.object({
      path: z.string(),
      bytes: z.number(),
      gpuBytes: z.number(),
      /** On phones and headsets; null for assets without a limit there. */
      phoneGpuBytes: z.number().nullable(),
      /** What phones and headsets show less of it. */
      reducedOnPhones: z.array(z.string()),
    }),
  ),
  /** What all assets take on the GPU; `places`: captures and splats, null if there are none. */
  gpuBytes: z.object({
    assets: z.number(),
    onPhones: z.number(),
    places: z.object({ onComputers: z.number(), onPhones: z.number(), phoneLimit: z.number() }).nullable(),
  }),
  /** Sizes by kind of file, largest first. */
  parts: z.array(z.object({ kind: z.string(), ...sizes.shape })),
  /** Why the page offers no session to enter, or would offer none with other files; null if neither. */
  note: z.string().nullable(),
  /** How the page plays on each kind of device. */
  devices: z.array(
    z.object({
      title: z.string(),
      tier: z.enum(['ar-camera', 'ar', 'camera', 'authored-vr', 'orbit']),
      display: z.string(),
      worthless: z.boolean(),
      lost: z.array(z.object({ node: z.string(), capability: z.string(), effect: z.string(), known: z.boolean() })),
      unseen: z.array(z.string()),
    }),
  ),
});

/** Id of an editor command in the native menus. */
const menuCommand = z.string().regex(/^[a-z]+\.[a-z-]+$/);

/** A menu of the editor, for the native menu bar. */
const platformMenu = z.object({
  label: z.string().max(64),
  entries: z
    .array(
      z.union([
        z.literal('line'),
        z.object({
          command: menuCommand,
          label: z.string().max(128),
          /** Keybinding of the command, as `renderer/keybinding.ts` writes it; null if there is none. */
          keybinding: z.string().max(64).nullable(),
          enabled: z.boolean(),
          /** Whether what the command switches is on; null if it switches nothing. */
          checked: z.boolean().nullable(),
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
      /** URL of the preview page, on its own origin. */
      previewUrl: z.string(),
      /** Project to open at start. */
      startPath: z.string().nullable(),
      /** `types`: the node types in the example. `picture`: its image as a `data:` URL, if it has one. */
      examples: z.array(z.object({ title: z.string(), path: z.string(), types: z.array(z.string()), picture: thumbnailUrl })),
      /** Templates for new projects; the default is first. */
      templates: z.array(z.object({ name: z.string(), title: z.string(), description: z.string(), picture: thumbnailUrl })),
      canPickFolders: z.boolean(),
      /** Whether `asset.reveal` shows files in the file manager. */
      canReveal: z.boolean(),
      /** Folder for the projects of the user. It may not exist yet. */
      projectsDir: z.string(),
    }),
  },
  /** Closes the window without asking again, in answer to `close-requested`. Does nothing if the host has no window. */
  'app.close': { input: z.object({}), output: z.object({}) },
  /** Sets the native menus. Does nothing if the host has none. */
  'menu.show': { input: z.object({ menus: z.array(platformMenu).max(16) }), output: z.object({}) },
  /** Asks for a folder with the native dialog; null if the user cancels or the host has no dialog. */
  'folder.pick': {
    input: z.object({ purpose: z.enum(['new', 'open', 'save-as', 'export', 'render', 'photographs']) }),
    output: z.object({ path: z.string().nullable() }),
  },
  /**
   * Lists the folders in the folder `path`, or in its nearest ancestor that exists, for hosts without a native dialog. `path` is absolute or
   * begins with `~/`; empty: the projects folder.
   */
  'folder.list': {
    input: z.object({ path: z.string().max(4096) }),
    output: z.object({
      path: z.string(),
      /** Null for the root of a drive. */
      parent: z.string().nullable(),
      folders: z.array(z.object({ name: z.string(), path: z.string(), isProject: z.boolean() })),
    }),
  },
  'project.open': { input: z.object({ path: z.string().min(1).max(4096) }), output: openProject },
  /** Creates a project from a template in a new or empty folder and opens it. `title`: by default made from the name of the folder. */
  'project.create': {
    input: z.object({ path: z.string().min(1).max(4096), template: z.string().min(1).max(64), title: z.string().max(1000).optional() }),
    output: openProject,
  },
  /**
   * Saves all files or none. Rejects with SCR063 if the files changed since `revision`, unless `overwrite` is set: then `kept` is the
   * project path of a folder with the replaced files, or null if nothing was replaced. Shaders that this window never loaded stay.
   * Rejects with SCR066 while another process holds the lock of the project, and with SCR067 if the folder is missing.
   */
  'project.save': {
    input: z.object({ handle, files: projectFiles, revision: z.string(), overwrite: z.boolean() }),
    output: z.object({ revision: z.string(), kept: projectPath.nullable() }),
  },
  /** Removes the lock of another process, at the user’s request. That process notices it before it writes. */
  'project.break-lock': { input: z.object({ handle }), output: z.object({}) },
  /** Saves a copy with all assets in a new or empty folder, and opens it. */
  'project.save-as': { input: z.object({ handle, path: z.string().min(1).max(4096), files: projectFiles }), output: openProject },
  /** Stores unsaved changes for recovery; null deletes them. */
  'project.autosave': { input: z.object({ handle, files: projectFiles.nullable() }), output: z.object({}) },
  'project.close': { input: z.object({ handle }), output: z.object({}) },
  /** Writes a file into `assets/`, under a free name derived from `name`. */
  'asset.import': {
    input: z.object({ handle, name: z.string().min(1).max(255), bytes: z.instanceof(Uint8Array).refine(isWithinLimit, 'too large') }),
    output: z.object({ path: projectPath }),
  },
  /** Reads an asset file, to copy it to another project. Rejects with SCR005 above `MAX_COPIED_BYTES`. */
  'asset.read': { input: z.object({ handle, path: projectPath }), output: z.object({ base64: z.string() }) },
  /** Lists the files in `assets/`, as they are now. */
  'asset.list': { input: z.object({ handle }), output: z.object({ assetFiles }) },
  /** Shows an asset file in the file manager. Does nothing if the host has none. */
  'asset.reveal': { input: z.object({ handle, path: projectPath }), output: z.object({}) },
  /**
   * Writes a recorded session into a new folder in `sessions/`, in one step. `content`: the bytes of all files, one after another. Gives
   * the id of `session.list`. SCR073 if the lengths do not add up.
   */
  'session.save': {
    input: z.object({
      handle,
      /** Text of `session.json`. */
      session: documentText,
      files: z.array(z.object({ path: sessionFile, bytes: z.number().int().min(1) })).max(20_000),
      content: z.instanceof(Uint8Array).refine(isWithinLimit, 'too large'),
    }),
    output: z.object({ id: z.string() }),
  },
  /** Lists recorded sessions and emulated rooms. */
  'session.list': { input: z.object({ handle }), output: z.array(sessionSource) },
  /**
   * Exports these files, saved or not. `out` is an absolute path. Progress is reported as events. If the export is canceled, nothing
   * is written, and `ok` is false without an error in the diagnostics.
   */
  'export.run': {
    input: z.object({
      handle,
      files: projectFiles,
      out: z.string().min(1).max(4096),
      poster: poster.nullable().optional(),
      /** Whether to write one file that opens without a server. Default: false. */
      singleFile: z.boolean().optional(),
      /** Whether the page opens offline after a visit. Default: true. */
      offline: z.boolean().optional(),
      /** Where the page will be published. */
      address: pageAddress.nullable().optional(),
    }),
    output: z.object({ ok: z.boolean(), out: z.string(), diagnostics: z.array(diagnostic), report: exportReport.nullable() }),
  },
  /**
   * Serves the page of the last export of this project on loopback, on an own port. `open`: opens it in the browser, if the host can;
   * `opened` says whether it did. Rejects with SCR004 if nothing was exported, or the page is gone.
   */
  'export.show': { input: z.object({ handle, open: z.boolean() }), output: z.object({ url: z.string(), opened: z.boolean() }) },
  /**
   * Begins a frame render into a temporary folder that replaces `out` at the end. `out` is absolute. SCR061 unless it is missing,
   * empty, or contains an earlier render. One at a time per project.
   */
  'frames.begin': {
    input: z.object({ handle, out: z.string().min(1).max(4096), widthPx: side, heightPx: side }),
    output: z.object({}),
  },
  /** Adds a frame: premultiplied RGBA, rows from the top. Written as `000012.png`. After an error all frames are deleted. */
  'frames.add': {
    input: z.object({
      handle,
      number: z.number().int().min(0).max(999_999),
      rgba: z.instanceof(Uint8Array).refine(isWithinLimit, 'too large'),
    }),
    output: z.object({}),
  },
  /** Moves the folder to `out`, with a `sequence.json` that lists its contents. */
  'frames.finish': {
    input: z.object({ handle, title: z.string().max(1000), frameRateHz: z.number().positive() }),
    output: z.object({ out: z.string(), pictures: z.number() }),
  },
  /** Cancels a frame render and deletes its frames. */
  'frames.cancel': { input: z.object({ handle }), output: z.object({}) },
  ...PHOTOGRAPH_CALLS,
  ...REPHOTOGRAPH_CALLS,
  ...SIMPLIFY_CALLS,
  ...RECIPE_CALLS,
  /** Ends the program of others that imports photographs or simplifies an asset of a project, if there is one. */
  'tool.cancel': { input: z.object({ handle }), output: z.object({}) },
  /** Cancels the export of a project, if there is one. */
  'export.cancel': { input: z.object({ handle }), output: z.object({}) },
} as const;

export type HostMethod = keyof typeof HOST_CONTRACT;
export type HostInput<M extends HostMethod> = z.infer<(typeof HOST_CONTRACT)[M]['input']>;
export type HostOutput<M extends HostMethod> = z.infer<(typeof HOST_CONTRACT)[M]['output']>;

/** Events that the host sends to the editor. */
export const hostEvent = z.discriminatedUnion('kind', [
  z.object({ kind: z.literal('project-changed-outside'), handle, revision: z.string() }),
  /** Progress of an export or an acquisition, as text for the user. */
  z.object({ kind: z.literal('export-progress'), handle, text: z.string() }),
  /** Progress of an import of photographs, or of a simplification. */
  z.object({
    kind: z.literal('tool-progress'),
    handle,
    step: z.enum(['features', 'matches', 'cameras', 'mesh', 'pack', 'read', 'simplify', 'write']),
    text: z.string(),
  }),
  /** What a program of others prints. */
  z.object({ kind: z.literal('tool-log'), handle, lines: z.array(z.string()) }),
  /** Only shaders changed on disk. `text` is null if a shader was deleted; `from` is the revision before the change. */
  z.object({
    kind: z.literal('shaders-changed-outside'),
    handle,
    from: z.string(),
    revision: z.string(),
    shaders: z.array(z.object({ file: z.string(), before: z.string().nullable(), text: z.string().nullable() })),
  }),
  z.object({ kind: z.literal('menu'), command: menuCommand }),
  /** The window is about to close. The editor answers with `app.close`, or asks about unsaved changes first. */
  z.object({ kind: z.literal('close-requested') }),
]);
export type HostEvent = z.infer<typeof hostEvent>;

export interface Host {
  call<M extends HostMethod>(method: M, input: HostInput<M>): Promise<HostOutput<M>>;
  /** Returns a function that unsubscribes. */
  subscribe(listener: (event: HostEvent) => void): () => void;
}

export type ProjectFiles = z.infer<typeof projectFiles>;
export type OpenProject = z.infer<typeof openProject>;
export type SessionSource = z.infer<typeof sessionSource>;
export type ExportedReport = z.infer<typeof exportReport>;
export type HostDiagnostic = z.infer<typeof diagnostic>;
export type PlatformMenu = z.infer<typeof platformMenu>;
export type PlatformMenuEntry = PlatformMenu['entries'][number];
