import { expect, test } from '@jest/globals';
import { fakeContext } from '../../../tests/support/node-context.ts';
import type { Anchor } from '../../kit/anchors.ts';
import type { EnvironmentAsset } from '../../kit/assets.ts';
import { uprightPose } from '../../kit/panorama/capture-targets.ts';
import { setPanoramaPose } from '../../kit/panorama/shot.ts';
import type { StitchAnswer } from '../../kit/panorama/stitch-protocol.ts';
import type { TakenPanorama } from '../../kit/taken-panorama.ts';
import { definition } from './definition.ts';
import { create } from './runtime.ts';
import { serve, type WorkerScope } from './worker.ts';

function taken(headingRad: number, isNew: boolean): TakenPanorama {
  const worldFromPanorama = new Float32Array(16);
  setPanoramaPose(worldFromPanorama, headingRad, [1, 1.6, -2]);
  const pixels = { widthPx: 2, heightPx: 1, channels: 4 as const, data: new Uint8ClampedArray(8) };
  return { pixels, worldFromPanorama, located: isNew, isNew };
}

/** A session whose anchors and panoramas the test sets. */
function stand() {
  const log: string[] = [];
  const ready = { now: true };
  const anchor = { state: 'pending', worldFromAnchor: new Float32Array(16) } as { state: Anchor['state']; worldFromAnchor: Float32Array };
  const give = (what: string) => {
    log.push(what);
    return Object.assign(anchor, { delete: () => log.push('delete anchor') });
  };
  const session = {
    sessions: 1,
    panorama: null as TakenPanorama | null,
    anchors: {
      create: (_: unknown, name: string) => give(`create ${name}`),
      restore: (name: string) => give(`restore ${name}`),
      forget: (name: string) => log.push(`forget ${name}`),
    },
  };
  const file = {} as EnvironmentAsset;
  const services = {
    session,
    assets: {
      environment: () => ({ kind: 'environment', value: file, settled: Promise.resolve(), release: () => log.push('release file') }),
      createEnvironment: () => {
        log.push('create environment');
        return {
          get ready() {
            return ready.now;
          },
          dispose: () => log.push('dispose environment'),
        };
      },
    },
  };
  const { ctx } = fakeContext(definition, { params: { file: 'sky', exposure: 1 }, services: services as never });
  const node = create(ctx);
  return { log, ready, anchor, session, file, ctx, node, update: () => node.update({} as never) };
}

test('shows the file until a panorama is there, then the panorama, turned as the room is', () => {
  const { ctx, session, file, update, node, log } = stand();
  update();
  expect(ctx.outputs.environment).toEqual({ asset: file, intensity: 2, rotationRad: 0 });
  expect(ctx.outputs.pose.valid).toBe(false);
  session.panorama = taken(0.75, true);
  update();
  expect(ctx.outputs.environment.asset).not.toBe(file);
  expect(ctx.outputs.environment.rotationRad).toBeCloseTo(0.75, 6);
  expect(ctx.outputs.pose.valid).toBe(true);
  expect([...ctx.outputs.pose.worldFromPose.slice(12, 15)].map((value) => Math.round(value * 10) / 10)).toEqual([1, 1.6, -2]);
  node.dispose();
  expect(log).toEqual(['create environment', 'create scrim-panorama', 'delete anchor', 'dispose environment', 'release file']);
});

test('asks the device for the anchor of an earlier visit, and turns the panorama when it is found', () => {
  const { ctx, session, anchor, update, log } = stand();
  session.panorama = taken(0, false);
  update();
  expect(log).toEqual(['create environment', 'restore scrim-panorama']);
  expect(ctx.outputs.pose.valid).toBe(false);
  anchor.state = 'tracked';
  setPanoramaPose(anchor.worldFromAnchor, -1.5, [0, 0, 0]);
  update();
  expect(ctx.outputs.environment.rotationRad).toBeCloseTo(-1.5, 6);
  expect(ctx.outputs.pose.valid).toBe(true);
});

test('the place of a panorama is forgotten with it, and not taken for that of a picture that is chosen instead', () => {
  const { session, update, log } = stand();
  session.panorama = taken(0, true);
  update();
  session.panorama = taken(1, false);
  update();
  expect(log.slice(2)).toEqual([
    'delete anchor',
    'forget scrim-panorama',
    'create environment',
    'restore scrim-panorama',
    'dispose environment',
  ]);
  session.panorama = null;
  update();
  expect(log.slice(7)).toEqual(['delete anchor', 'forget scrim-panorama', 'dispose environment']);
});

test('a later panorama replaces the one before', () => {
  const { session, update, log } = stand();
  session.panorama = taken(0, true);
  update();
  session.panorama = taken(1, true);
  update();
  expect(log.slice(2)).toEqual(['delete anchor', 'create environment', 'create scrim-panorama', 'dispose environment']);
});

test('the one before stays until the later one can be drawn', () => {
  const { ctx, session, update, log, ready, node } = stand();
  session.panorama = taken(0, true);
  update();
  const first = ctx.outputs.environment.asset;
  ready.now = false;
  session.panorama = taken(1, true);
  update();
  update();
  expect(ctx.outputs.environment.asset).toBe(first);
  expect(log).not.toContain('dispose environment');
  ready.now = true;
  update();
  expect(ctx.outputs.environment.asset).not.toBe(first);
  node.dispose();
  expect(log.filter((entry) => entry === 'dispose environment')).toHaveLength(2);
});

test('its worker answers with progress, then with the panorama', () => {
  const answers: StitchAnswer[] = [];
  const scope: WorkerScope = { onmessage: null, postMessage: (answer) => answers.push(answer) };
  serve(scope);
  const lens = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.1, 0]);
  const data = new Uint8Array(4 * 4 * 4).fill(200);
  const shots = [{ widthPx: 4, heightPx: 4, data, clipFromView: lens, worldFromView: uprightPose([0, 0, -1]) }];
  scope.onmessage?.({ data: { shots, widthPx: 64 } });
  const last = answers.at(-1);
  if (last?.kind !== 'done') throw new Error(JSON.stringify(last));
  expect(answers.length).toBeGreaterThan(2);
  expect(answers.slice(0, -1).every(({ kind }) => kind === 'progress')).toBe(true);
  const center = (16 * 64 + 32) * 4;
  expect([...last.panorama.data.slice(center, center + 4)]).toEqual([200, 200, 200, 255]);
  expect(last.panorama.holesPart).toBeCloseTo(5 / 6, 2);
});

test('its worker answers with the reason if photos are damaged', () => {
  const answers: StitchAnswer[] = [];
  const scope: WorkerScope = { onmessage: null, postMessage: (answer) => answers.push(answer) };
  serve(scope);
  scope.onmessage?.({ data: { shots: [null as never], widthPx: 64 } });
  expect(answers.at(-1)?.kind).toBe('failed');
});
