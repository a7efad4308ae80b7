import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { type BundleInput, bundlePage } from '../../export/bundle/bundle-page.ts';
import type { ExportReport } from '../../export/bundle/report.ts';
import type { Program } from '../../export/program/program.ts';
import { serveStatic } from '../support/serve.ts';

const ROOT = resolve(import.meta.dirname, '../..');

export interface ServedPage {
  /** Ends in `/`. */
  readonly url: string;
  readonly folder: string;
  readonly report: ExportReport;
  close(): Promise<void>;
}

/** Bundles a program and serves the page from a sub-path, as a plain static host would. */
export async function servePage(
  program: Program,
  readAsset: (path: string) => Promise<Uint8Array> = () => Promise.reject(new Error('there is no such file')),
  more: Partial<Pick<BundleInput, 'singleFile' | 'address'>> = {},
): Promise<ServedPage> {
  const folder = await mkdtemp(join(tmpdir(), 'scrim-page-'));
  const { output, diagnostics } = await bundlePage({
    program,
    page: { description: 'A warm light for the room, drawn by a shader.', language: 'en' },
    generator: 'Scrim test',
    root: ROOT,
    readAsset,
    ...more,
    sink: {
      write: async (path, bytes) => {
        await mkdir(dirname(join(folder, path)), { recursive: true });
        await writeFile(join(folder, path), bytes);
      },
    },
  });
  if (output === null) throw new Error(JSON.stringify(diagnostics));
  const server = await serveStatic({ '/some/sub path/': `${folder}/` });
  return {
    url: `${server.origin}/some/sub%20path/`,
    folder,
    report: output,
    close: async () => {
      await server.close();
      await rm(folder, { recursive: true, force: true });
    },
  };
}

const VERTEX = `#version 300 es
out vec2 uv;
void main() {
  uv = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}`;

/** A warm disc in the middle of the view, transparent around it: no objects, so no three.js. */
export const DISC: Program = {
  format: 'scrim-program',
  version: 1,
  title: 'Warm light',
  slots: { numbers: [], texts: [], slots: [], params: {} },
  resources: [],
  operations: [
    {
      id: 'disc-a1',
      node: 'disc-a1',
      kind: 'pass',
      view: 'each',
      reads: [],
      writes: [],
      shader: 0,
      target: 'screen',
      blend: 'over',
      samplers: [],
      uniforms: [{ name: 'size', type: 'vec2', source: { builtin: 'RENDERSIZE' } }],
      passIndex: 0,
    },
  ],
  shaders: [
    {
      id: 'disc',
      vertex: VERTEX,
      fragment: `#version 300 es
precision highp float;
uniform vec2 size;
in vec2 uv;
out vec4 color;
void main() {
  vec2 p = (uv - 0.5) * size / min(size.x, size.y);
  float a = 1.0 - smoothstep(0.28, 0.3, length(p));
  color = vec4(1.0, 0.8 - p.y, 0.35 - p.y, 1.0) * a;
}`,
    },
  ],
  assets: [],
  presentation: { mode: 'composed', antialias: false, background: 'world', blend: 'alpha' },
  needs: [
    {
      capability: 'depth',
      required: false,
      nodes: ['a-1'],
      why: 'to hide the light behind furniture',
      without: 'it shines through everything',
    },
    { capability: 'camera-image', required: false, nodes: ['b-1'], why: 'to tint the room', without: 'the room keeps its colors' },
  ],
  tiers: [
    { id: 'ar-camera', without: [] },
    { id: 'ar', without: [{ capability: 'camera-image', effect: 'the room keeps its colors' }] },
    { id: 'camera', without: [{ capability: 'depth', effect: 'it shines through everything' }] },
    {
      id: 'orbit',
      without: [
        { capability: 'depth', effect: 'it shines through everything' },
        { capability: 'camera-image', effect: 'the room keeps its colors' },
      ],
    },
  ],
  taps: {},
};
