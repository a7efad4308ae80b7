import { ARITHMETIC } from '../../../nodes/kit/arithmetic.ts';
import { WEBXR_FEATURES } from '../../program/webxr-features.ts';
import { needs } from '../optional/part.ts';
import type { PageUse } from '../page-entry.ts';

/** What is cut out of a source file of Scrim. */
export interface Trim {
  readonly file: string;
  readonly cases?: {
    /** Texts of the cases that a page may lack. */
    readonly labels: readonly string[];
    /** Those that the page needs, perhaps with others. */
    readonly needed: (use: PageUse) => ReadonlySet<string>;
  };
  /** Names of members that a page does not read, each with the condition under which it does. */
  readonly members?: Readonly<Record<string, (use: PageUse) => boolean>>;
}

const never = (): boolean => false;
const isSpatial = ({ spatial }: PageUse): boolean => spatial;

const RESOURCES = ['target', 'external', 'room-depth', 'objects', 'lights', 'environment', 'sound'];
const MORE_RESOURCES = ['table', 'pulses', 'pose', 'pixels', 'bodies', 'capture', 'technique', 'shadow-maps'];
const resources = { labels: [...RESOURCES, ...MORE_RESOURCES], needed: ({ resourceKinds }: PageUse) => resourceKinds };

const samplers = { labels: ['import', 'sound', 'table', 'room-depth', 'depth'], needed: ({ samplerKinds }: PageUse) => samplerKinds };

const BUILTINS = ['TIME', 'TIMEDELTA', 'DATE', 'RENDERSIZE', 'FRAMEINDEX', 'PASSINDEX', 'SCRIM_CLIP_FROM_VIEW', 'SCRIM_WORLD_FROM_VIEW'];

const ASSETS = ['image', 'video', 'audio', 'capture', 'splats', 'model', 'environment'];

/** Members that are needed if a set of the page's use contains their name. */
function membersOf(names: readonly string[], needed: (use: PageUse) => ReadonlySet<string>): NonNullable<Trim['members']> {
  return Object.fromEntries(names.map((name) => [name, (use: PageUse) => needed(use).has(name)]));
}

const ofCapabilities = membersOf(Object.keys(WEBXR_FEATURES), ({ capabilities }) => capabilities);

/**
 * Cases and members that depend on what a program contains. `optional/` leaves out files, this leaves out parts of them.
 */
export const TRIMS: readonly Trim[] = [
  { file: 'export/runtime/resources/resources.ts', cases: resources },
  { file: 'export/runtime/operations/node-ports.ts', cases: resources },
  {
    file: 'export/runtime/targets/target-buffer.ts',
    cases: { labels: ['rgba8', 'scene16f', 'rgba16f', 'rgba32f', 'r32f'], needed: ({ targetFormats }) => targetFormats },
  },
  { file: 'export/runtime/passes/samplers.ts', cases: samplers },
  { file: 'export/runtime/passes/uniform-setters.ts', cases: { labels: BUILTINS, needed: ({ builtins }) => builtins } },
  {
    file: 'export/runtime/passes/changes.ts',
    cases: samplers,
    members: membersOf(BUILTINS, ({ builtins }) => builtins),
  },
  {
    file: 'export/runtime/values/slots.ts',
    cases: {
      labels: ['number', 'toggle', 'text', 'vector2', 'vector3', 'vector4', 'color', 'curve', 'gradient'],
      needed: ({ slotTypes }) => slotTypes,
    },
  },
  {
    file: 'export/runtime/assets/asset-store.ts',
    cases: { labels: ASSETS, needed: ({ assetKinds }) => assetKinds },
    members: {
      ...membersOf(ASSETS, ({ assetKinds }) => assetKinds),
      createEnvironment: ({ scenes }) => scenes,
      // Remedies for designers; `notices.ts` has those for visitors.
      fix: never,
    },
  },
  {
    file: 'nodes/kit/arithmetic.ts',
    cases: {
      labels: Object.keys(ARITHMETIC),
      needed: ({ words }) => words,
    },
  },
  {
    file: 'nodes/kit/play-expression.ts',
    cases: {
      labels: ['sin', 'cos', 'tan', 'asin', 'acos', 'atan', 'exp', 'log', 'sign', 'fract', 'atan2', 'step', 'clamp', 'mix', 'smoothstep'],
      needed: ({ words }) => words,
    },
  },
  {
    file: 'export/runtime/clock.ts',
    members: { readDate: ({ builtins }) => builtins.has('DATE') },
  },
  {
    file: 'export/runtime/gl/pass-drawer.ts',
    members: { cube: ({ samplerKinds }) => samplerKinds.has('import') },
  },
  {
    // Tools inspect and settle a player, and replace its program. A page does not.
    file: 'export/runtime/player.ts',
    members: { drawSettled: never, settle: never, replaceProgram: never, inspect: never, counts: never },
  },
  { file: 'export/runtime/program-instance/program-instance.ts', members: { settle: never } },
  { file: 'export/runtime/sessions/webxr/request-session.ts', members: ofCapabilities },
  { file: 'export/program/webxr-features.ts', members: ofCapabilities },
  {
    file: 'export/page/entered-sessions.ts',
    members: {
      depth: needs('depth'),
      'light-estimation': needs('light-estimation'),
      camera: ({ tiers }) => tiers.has('camera'),
      vr: ({ tiers }) => tiers.has('authored-vr'),
    },
  },
  {
    file: 'export/runtime/engine.ts',
    members: {
      counts: never,
      openHitTest: isSpatial,
      castRay: isSpatial,
      answerRays: isSpatial,
      depthImage: isSpatial,
      anchors: isSpatial,
      keptFiles: isSpatial,
      multisampling: ({ operationKinds }) => operationKinds.has('draw'),
    },
  },
];
