import { HOST_CONTRACT, type Host, type HostEvent, type HostInput, type HostMethod, type HostOutput } from '../../app/contract/contract.ts';
import { HostError } from '../../app/contract/host-error.ts';

type Handlers = { [M in HostMethod]?: (input: HostInput<M>) => HostOutput<M> | Promise<HostOutput<M>> };

export interface FakeHost extends Host {
  /** All calls in order. */
  readonly calls: { readonly method: HostMethod; readonly input: unknown }[];
  /** Rejects the next call of a method. */
  refuse(method: HostMethod, code: string, message: string): void;
  /** Simulates a save of another process: changes the revision without an event. */
  writeOutside(files: HostOutput<'project.open'>['files']): void;
  /** Replaces the handler of a method. */
  answer<M extends HostMethod>(method: M, handler: NonNullable<Handlers[M]>): void;
  emit(event: HostEvent): void;
}

export interface FakeFolder {
  readonly openElsewhere?: boolean;
}

/** An in-memory host with one project. Validates all inputs and outputs against the contract. */
export function createFakeHost(
  files: HostOutput<'project.open'>['files'],
  handlers: Handlers = {},
  { openElsewhere = false }: FakeFolder = {},
): FakeHost {
  const calls: FakeHost['calls'] = [];
  const listeners = new Set<(event: HostEvent) => void>();
  const refusals = new Map<HostMethod, HostError>();
  let saved = files;
  let revision = 1;
  let opened = 0;
  let recipes: HostOutput<'recipe.list'> = [];
  const open = (path: string) => ({
    // Each opening returns another handle and URL, like the real host.
    handle: `abcdef0123456789${++opened}`,
    displayPath: path,
    files: saved,
    revision: `r${revision}`,
    assetBaseUrl: `http://127.0.0.1:1/projects/${opened}/`,
    assetFiles: [],
    recovery: null,
    openElsewhere,
  });
  const all: Required<Handlers> = {
    'app.info': () => ({
      shell: 'server',
      version: '0',
      previewUrl: 'http://127.0.0.1:1/',
      startPath: '/project',
      examples: [],
      templates: [{ name: 'empty', title: 'Empty', description: 'Nothing yet.' }],
      canPickFolders: false,
      canReveal: false,
      projectsDir: '/home/me/Scrim',
    }),
    'app.close': () => ({}),
    'menu.show': () => ({}),
    'folder.pick': () => ({ path: null }),
    'folder.list': ({ path }) => ({ path, parent: null, folders: [] }),
    'project.open': ({ path }) => open(path),
    'project.create': ({ path }) => open(path),
    'project.save': (input) => {
      saved = input.files;
      revision++;
      return { revision: `r${revision}`, kept: null };
    },
    'project.break-lock': () => ({}),
    'project.save-as': ({ path, files: next }) => {
      saved = next;
      return open(path);
    },
    'project.autosave': () => ({}),
    'project.close': () => ({}),
    'asset.read': ({ path }) => ({ base64: btoa(`bytes of ${path}`) }),
    'asset.import': ({ name }) => ({ path: `assets/${name}` }),
    'asset.list': () => ({ assetFiles: [] }),
    'asset.reveal': () => ({}),
    'session.save': () => ({ id: 'project/recording' }),
    'session.list': () => [],
    'export.run': ({ out }) => ({
      ok: true,
      out,
      diagnostics: [],
      report: {
        files: 1,
        bytes: { raw: 2000, gzip: 1000 },
        assets: [],
        gpuBytes: { assets: 0, onPhones: 0, places: null },
        parts: [{ kind: 'page', raw: 2000, gzip: 1000 }],
        note: null,
        devices: [],
      },
    }),
    'export.show': () => ({ url: 'http://127.0.0.1:2/', opened: false }),
    'export.cancel': () => ({}),
    'frames.begin': () => ({}),
    'frames.add': () => ({}),
    'frames.finish': () => ({ out: '/frames', pictures: 1 }),
    'frames.cancel': () => ({}),
    'capture.begin': () => ({}),
    'capture.add': () => ({}),
    'capture.finish': () => ({ path: 'assets/scene.capture/capture.json', diagnostics: [] }),
    'capture.cancel': () => ({}),
    'capture.report': () => ({ record: null, views: [], vertexCount: 0, triangleCount: 0, sizeM: [0, 0, 0], surface: [] }),
    'photographs.look': () => ({ photographs: 12, hasCameras: false, colmap: '3.8 (/usr/bin/colmap)', diagnostic: null }),
    'photographs.survey': () => ({ form: null, up: null, mesh: null, warnings: [], photographs: [], depth: null }),
    'photographs.import': () => ({
      path: 'assets/kitchen.capture/capture.json',
      photographs: 12,
      found: 12,
      isRough: true,
      isScaleGuessed: true,
      start: { positionM: [1, 2, 3], yawRad: 0.5 },
      diagnostics: [],
    }),
    'photographs.stage': ({ folder }) => ({ folder: `/project/.scrim/photographs/${folder}` }),
    'simplify.look': () => ({ triangles: 5000, tool: '3.4.1 (/usr/bin/blender)', diagnostic: null }),
    'simplify.run': ({ triangles }) => ({ path: 'assets/statue-simple.glb', before: 5000, after: triangles }),
    'tool.cancel': () => ({}),
    'rephotograph.begin': ({ method }) => ({ methods: [method ?? 'lumigraph'], views: 2 }),
    'rephotograph.add': () => ({}),
    'rephotograph.finish': () => ({ means: [{ method: 'lumigraph', psnrDb: 30.5, ssim: 0.9, chromaError: 2, covered: 1 }] }),
    'rephotograph.cancel': () => ({}),
    'rephotograph.show': () => ({ url: 'http://127.0.0.1:2/', opened: false }),
    'recipe.list': () => recipes,
    'recipe.save': ({ name, files: texts }) => {
      const path = `/home/me/Scrim/recipes/${name}`;
      recipes.push({ name, path, files: { ...texts, sources: {} }, problem: null });
      return { path };
    },
    'recipe.remove': ({ name }) => {
      recipes = recipes.filter((recipe) => recipe.name !== name);
      return { kept: `/home/me/Scrim/recipes/.removed/${name}` };
    },
    ...handlers,
  };
  return {
    calls,
    refuse: (method, code, message) => refusals.set(method, new HostError({ code, severity: 'error', message })),
    writeOutside: (theirs) => {
      saved = theirs;
      revision++;
    },
    answer: (method, handler) => Object.assign(all, { [method]: handler }),
    emit: (event) => {
      for (const listener of listeners) listener(event);
    },
    call: async <M extends HostMethod>(method: M, input: HostInput<M>) => {
      calls.push({ method, input });
      HOST_CONTRACT[method].input.parse(input);
      const refusal = refusals.get(method);
      refusals.delete(method);
      if (refusal) throw refusal;
      const output = await (all[method] as unknown as (given: HostInput<M>) => HostOutput<M> | Promise<HostOutput<M>>)(input);
      HOST_CONTRACT[method].output.parse(output);
      return output;
    },
    subscribe: (listener) => {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
