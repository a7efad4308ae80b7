import { homedir } from 'node:os';
import { isAbsolute, join } from 'node:path';
import type { ImageQuality } from '../../export/captures/evaluate/image-quality.ts';
import type { HostEvent, HostInput, PlatformMenu } from '../contract/contract.ts';
import type { Answer } from '../contract/host-error.ts';
import { POSTER_SIZE } from '../contract/poster-size.ts';
import { createAcquisitionJobs } from './acquisition-jobs.ts';
import { resolveInside } from './confine.ts';
import { type Content, createContent } from './content.ts';
import type { Origins } from './content-policy.ts';
import { copyExample, isExample } from './copy-example.ts';
import { dispatch, type Handlers } from './dispatch.ts';
import { createExportJobs } from './export-jobs.ts';
import { refusal } from './file-errors.ts';
import { type FileLayer, NODE_FILES } from './file-layer.ts';
import { findExamples, withThumbnail } from './find-examples.ts';
import { createFrameJobs } from './frame-jobs.ts';
import { importAsset } from './import-asset.ts';
import { reportOfAsset } from './import-report/read-capture-report.ts';
import type { Installation } from './installation.ts';
import { listFolders } from './list-folders.ts';
import { createOpenProjects } from './open-projects.ts';
import { createSimplifyJobs } from './outside/simplify-jobs.ts';
import { createToolJobs, type ToolEvents } from './outside/tool-jobs.ts';
import { createPageServers } from './page-servers.ts';
import { createPhotographImports } from './photograph-imports.ts';
import { findProject, listAssets } from './project-files.ts';
import { readAsset } from './read-asset.ts';
import { listRecipes, removeRecipe, saveRecipe } from './recipe-folders.ts';
import { createRephotographJobs, reportFolder } from './rephotograph/rephotograph-jobs.ts';
import { ROOMS } from './rooms.ts';
import { saveSession } from './save-session.ts';
import { findSessions, SESSIONS_FOLDER } from './session-list.ts';
import { sweepStagingFolders } from './staging-folder.ts';
import { createProject, findTemplates } from './templates.ts';

/** What a shell (Electron or the loopback server) provides to the host. */
export interface Shell {
  readonly kind: 'electron' | 'server';
  readonly origins: Origins;
  /** Asks for a folder with the native dialog; null if the shell has none. */
  readonly pickFolder: ((purpose: HostInput<'folder.pick'>['purpose']) => Promise<string | null>) | null;
  readonly closeWindow: () => void;
  /** Shows a file in the file manager; null if the shell cannot. */
  readonly revealFile: ((path: string) => void) | null;
  /** Opens an address of this machine in the default browser; null if the editor itself runs in a browser. */
  readonly openInBrowser: ((url: string) => Promise<void>) | null;
  /** Sets the native menus; null if the shell has none. */
  readonly showMenus: ((menus: readonly PlatformMenu[]) => void) | null;
}

export interface HostOptions {
  readonly shell: Shell;
  readonly installation: Installation;
  /** Project to open at start. */
  readonly startPath: string | null;
  readonly files?: FileLayer;
  /** Logs internal errors, which the editor sees as SCR074. */
  readonly log: (message: string) => void;
}

export interface HostService {
  readonly content: Content;
  /** Validates a call against the contract and runs it. Never rejects. `client` is the window or tab that calls. */
  dispatch(method: string, input: unknown, client?: string): Promise<Answer<unknown>>;
  /** Registers a window or tab. Returns a function that unregisters it. */
  attend(client: string): () => void;
  subscribe(listener: (event: HostEvent) => void): () => void;
  emit(event: HostEvent): void;
  /** Cancels jobs and closes the projects at once. Resolves when the calls in progress no longer write. */
  dispose(): Promise<void>;
}

const ROOMS_MOUNT = 'rooms/captures';

/** Creates the host: implements the contract on the files of this machine. */
export function createHost({ shell, installation, startPath, files = NODE_FILES, log }: HostOptions): HostService {
  const content = createContent({ origins: shell.origins, pages: installation.pages });
  content.show(ROOMS_MOUNT, installation.roomsDir);
  const listeners = new Set<(event: HostEvent) => void>();
  const emit = (event: HostEvent) => {
    for (const listener of listeners) listener(event);
  };
  const clients = createClients();
  const exports = createExportJobs();
  const frames = createFrameJobs(files);
  const acquisitions = createAcquisitionJobs(files, installation.root);
  const tools = createToolJobs();
  const photographs = createPhotographImports(files, tools, installation.root);
  const simplifications = createSimplifyJobs(files, tools);
  const rephotographs = createRephotographJobs(files);
  const pages = createPageServers();
  void sweepStagingFolders();
  const show = async (folder: string, open: boolean) => {
    const url = await pages.serve(folder);
    if (open) await shell.openInBrowser?.(url);
    return { url, opened: open && shell.openInBrowser !== null };
  };
  const projects = createOpenProjects({ content, previewOrigin: shell.origins.preview, files, emit, isThere: clients.isThere });

  const toolEvents = (handle: string): ToolEvents => ({
    onProgress: (progress) => emit({ kind: 'tool-progress', handle, ...progress }),
    onLines: (lines) => emit({ kind: 'tool-log', handle, lines }),
  });

  const handlers: Handlers = {
    'app.info': async () => ({
      shell: shell.kind,
      version: installation.version,
      previewUrl: `${shell.origins.preview}/index.html`,
      startPath,
      examples: await findExamples(installation.examplesDir),
      templates: await Promise.all(
        (await findTemplates(installation.templatesDir)).map((template) =>
          withThumbnail(template, installation.examplesDir, `template-${template.name}`),
        ),
      ),
      canPickFolders: shell.pickFolder !== null,
      canReveal: shell.revealFile !== null,
      projectsDir: installation.projectsDir,
    }),
    'app.close': async () => {
      shell.closeWindow();
      return {};
    },
    'menu.show': async ({ menus }) => {
      shell.showMenus?.(menus);
      return {};
    },
    'folder.pick': async ({ purpose }) => ({ path: shell.pickFolder ? await shell.pickFolder(purpose) : null }),
    'folder.list': ({ path }) => listFolders(path.trim() === '' ? installation.projectsDir : fullPath(path, 'SCR004')),
    'project.open': async ({ path }, client) => {
      const typed = fullPath(path, 'SCR004');
      const root = await findProject(typed);
      if (!(await isExample(root, installation.examplesDir))) return projects.open(typed, client);
      return projects.open(await copyExample({ example: root, projectsDir: installation.projectsDir, files }), client);
    },
    'project.create': async ({ path, template, title }, client) => {
      const { templatesDir } = installation;
      const root = await createProject({ templatesDir, template, title, path: fullPath(path, 'SCR060'), files });
      return projects.open(root, client);
    },
    'project.save': (input) => projects.save(input.handle, input.files, input.revision, input.overwrite),
    'project.break-lock': async ({ handle }) => {
      await projects.breakLock(handle);
      return {};
    },
    'project.save-as': (input, client) => projects.saveAs(input.handle, fullPath(input.path, 'SCR060'), input.files, client),
    'project.autosave': async (input) => {
      await projects.autosave(input.handle, input.files);
      return {};
    },
    'project.close': async ({ handle }) => {
      exports.cancel(handle);
      await frames.cancel(handle);
      await acquisitions.cancel(handle);
      tools.cancel(handle);
      await rephotographs.cancel(handle);
      projects.close(handle);
      return {};
    },
    'asset.import': async ({ handle, name, bytes }) => ({ path: await importAsset(projects.rootOf(handle), name, bytes, files) }),
    'asset.read': async ({ handle, path }) => ({ base64: Buffer.from(await readAsset(projects.rootOf(handle), path)).toString('base64') }),
    'asset.list': async ({ handle }) => ({ assetFiles: await listAssets(projects.rootOf(handle)) }),
    'asset.reveal': async ({ handle, path }) => {
      shell.revealFile?.(await resolveInside(projects.rootOf(handle), path));
      return {};
    },
    'session.save': async ({ handle, session, files: images, content: bytes }) => ({
      id: `project/${await saveSession(projects.rootOf(handle), { session, images, bytes }, files)}`,
    }),
    'session.list': async ({ handle }) => {
      const own = await findSessions(join(projects.rootOf(handle), SESSIONS_FOLDER));
      const shipped = await findSessions(installation.sessionsDir);
      for (const { name, folder } of shipped) content.show(`sessions/${name}`, folder);
      return [
        ...own.map(({ name, title }) => ({
          id: `project/${name}`,
          title,
          kind: 'recorded' as const,
          url: `${projects.baseUrlOf(handle)}sessions/${encodeURIComponent(name)}/`,
        })),
        ...shipped.map(({ name, title }) => ({
          id: `example/${name}`,
          title,
          kind: 'recorded' as const,
          url: `${shell.origins.preview}/sessions/${encodeURIComponent(name)}/`,
        })),
        ...ROOMS.map(({ name, title, capture }) => ({
          id: `room/${name}`,
          title,
          kind: 'room' as const,
          url: capture === null ? null : `${shell.origins.preview}/${ROOMS_MOUNT}/${capture}`,
        })),
      ];
    },
    'export.run': ({ handle, files: projectFiles, out, poster = null, singleFile = false, offline = true, address = null }) =>
      exports.run(handle, {
        root: projects.rootOf(handle),
        projectFiles,
        out: fullPath(out, 'SCR060'),
        installation,
        files,
        singleFile,
        offline,
        address: address && withSlash(address),
        say: (text) => emit({ kind: 'export-progress', handle, text }),
        drawPoster: async () => poster && { type: 'jpg', bytes: poster, drawn: true, ...POSTER_SIZE },
      }),
    'export.show': async ({ handle, open }) => {
      projects.rootOf(handle);
      const folder = exports.lastOf(handle);
      if (folder === null) throw refusal('SCR004', 'This project has no exported page yet.');
      return show(folder, open);
    },
    'frames.begin': async ({ handle, out, widthPx, heightPx }, client) => {
      projects.rootOf(handle);
      await frames.begin(handle, client, { out: fullPath(out, 'SCR060'), widthPx, heightPx });
      return {};
    },
    'frames.add': async ({ handle, number, rgba }) => {
      await frames.add(handle, number, rgba);
      return {};
    },
    'frames.finish': ({ handle, title, frameRateHz }) => frames.finish(handle, { title, frameRateHz }),
    'frames.cancel': async ({ handle }) => {
      await frames.cancel(handle);
      return {};
    },
    'capture.begin': async ({ handle, name, camera, poses }, client) => {
      await acquisitions.begin(handle, client, { root: projects.rootOf(handle), name, camera, poses });
      return {};
    },
    'capture.add': async ({ handle, index, colorSize, rgba, depthSize, meters }) => {
      const color = { ...colorSize, pixels: Uint8Array.from(rgba) };
      const depth = { ...depthSize, meters: new Float32Array(Uint8Array.from(meters).buffer) };
      await acquisitions.add(handle, index, { color, depth });
      return {};
    },
    'capture.finish': async ({ handle }) => {
      const packed = await acquisitions.finish(handle, (text) => emit({ kind: 'export-progress', handle, text }));
      return { path: packed?.path ?? null, diagnostics: [...(packed?.diagnostics ?? [])] };
    },
    'capture.cancel': async ({ handle }) => {
      await acquisitions.cancel(handle);
      return {};
    },
    'capture.report': ({ handle, path }) => reportOfAsset(projects.rootOf(handle), path),
    'photographs.look': async ({ handle, folder, colmap }) => {
      projects.rootOf(handle);
      return photographs.look({ colmap }, fullPath(folder, 'SCR004'));
    },
    'photographs.survey': async ({ handle, folder }) => {
      projects.rootOf(handle);
      return photographs.survey(fullPath(folder, 'SCR004'));
    },
    'photographs.import': ({ handle, folder, ...options }, client) =>
      photographs.run(handle, client, {
        ...options,
        root: projects.rootOf(handle),
        folder: fullPath(folder, 'SCR004'),
        ...toolEvents(handle),
      }),
    'photographs.stage': async ({ handle, ...file }) => ({ folder: await photographs.stage(projects.rootOf(handle), file) }),
    'simplify.look': ({ handle, ...asked }) => simplifications.look(projects.rootOf(handle), asked),
    'simplify.run': ({ handle, ...options }, client) =>
      simplifications.run(handle, client, { ...options, root: projects.rootOf(handle), ...toolEvents(handle) }),
    'tool.cancel': async ({ handle }) => {
      tools.cancel(handle);
      return {};
    },
    'rephotograph.begin': ({ handle, ...options }, client) =>
      rephotographs.begin(handle, client, { root: projects.rootOf(handle), ...options }),
    'rephotograph.add': async ({ handle, index, method, size, picture, error, ...quality }) => {
      await rephotographs.add(handle, index, { method, ...size, picture, error, ...mapFigures(quality, (figure) => figure ?? Number.NaN) });
      return {};
    },
    'rephotograph.finish': async ({ handle }) => {
      const means = await rephotographs.finish(handle);
      return {
        means: means.map(({ method, ...quality }) => ({
          method,
          ...mapFigures(quality, (figure) => (Number.isFinite(figure) ? figure : null)),
        })),
      };
    },
    'rephotograph.cancel': async ({ handle }) => {
      await rephotographs.cancel(handle);
      return {};
    },
    'rephotograph.show': async ({ handle, path }) => show(await reportFolder(projects.rootOf(handle), path), true),
    'recipe.list': () => listRecipes(installation.projectsDir),
    'recipe.save': async (input) => ({ path: await saveRecipe(installation.projectsDir, input, files) }),
    'recipe.remove': async ({ name }) => ({ kept: await removeRecipe(installation.projectsDir, name, files) }),
    'export.cancel': async ({ handle }) => {
      exports.cancel(handle);
      return {};
    },
  };

  const calls = new Set<Promise<unknown>>();

  return {
    content,
    dispatch: (method, input, client = '') => {
      const call = dispatch(handlers, method, input, client, log).finally(() => calls.delete(call));
      calls.add(call);
      return call;
    },
    attend: (client) => {
      const leave = clients.attend(client);
      return () => {
        leave();
        if (clients.isThere(client)) return;
        frames.left(client);
        acquisitions.left(client);
        tools.left(client);
        rephotographs.left(client);
        projects.left(client);
      };
    },
    subscribe: (listener) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
    emit,
    dispose: async () => {
      listeners.clear();
      exports.dispose();
      frames.dispose();
      acquisitions.dispose();
      tools.dispose();
      rephotographs.dispose();
      projects.dispose();
      await Promise.all([...calls, pages.dispose()]);
    },
  };
}

/** Messages have null for figures that are no numbers. */
function mapFigures<From, To>(quality: Record<keyof ImageQuality, From>, map: (figure: From) => To): Record<keyof ImageQuality, To> {
  const { psnrDb, ssim, chromaError, covered } = quality;
  return { psnrDb: map(psnrDb), ssim: map(ssim), chromaError: map(chromaError), covered: map(covered) };
}

/** The address of a folder ends in a slash. */
function withSlash(address: string): string {
  return address.endsWith('/') ? address : `${address}/`;
}

/** Tracks clients by their open event streams. A page that reconnects has two for a moment. */
function createClients() {
  const streams = new Map<string, number>();
  return {
    isThere: (client: string) => (streams.get(client) ?? 0) > 0,
    attend: (client: string) => {
      streams.set(client, (streams.get(client) ?? 0) + 1);
      return () => {
        const left = (streams.get(client) ?? 1) - 1;
        if (left > 0) streams.set(client, left);
        else streams.delete(client);
      };
    },
  };
}

/**
 * Resolves a typed path; `~/` is the home folder. Rejects relative paths, because a window has no working folder.
 *
 * @throws HostError with this `code` if the path is relative
 */
function fullPath(path: string, code: 'SCR004' | 'SCR060'): string {
  const typed = path.trim();
  const whole = typed === '~' || /^~[/\\]/.test(typed) ? join(homedir(), typed.slice(1)) : typed;
  if (isAbsolute(whole)) return whole;
  throw refusal(code, `${path} is not a full path.`, `Enter a full path, such as ${join(homedir(), path)}.`);
}
