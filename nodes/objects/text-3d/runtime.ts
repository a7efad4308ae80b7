import { BufferGeometry, Mesh, MeshStandardMaterial } from 'three';
import { readGlyphs } from '../../kit/glyphs.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import { setSurface } from '../../kit/three/material-color.ts';
import { createMeshItem, setShadows } from '../../kit/three/mesh-item.ts';
import type { definition } from './definition.ts';
import { layOut, MAX_CHARACTERS } from './lay-out.ts';
import { createLetters, mergeLetters } from './letters.ts';

/** Plays the node Text 3D. `config.characters` contains the outlines of glyphs, which the compiler adds. */
export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { text, sizeM, depthM } = ctx.params;
  const { objects } = ctx.outputs;
  const letterOf = createLetters(readGlyphs(ctx.config.characters));
  const material = new MeshStandardMaterial();
  const mesh = new Mesh(new BufferGeometry(), material);
  const item = createMeshItem('text', mesh, { castsShadow: true, receivesShadow: true });
  let shown: string | null = null;

  /**
   * Builds the geometry of a text. It is a new geometry each time, because readers cache what they derive from a geometry by its identity.
   */
  function write(words: string): void {
    shown = words;
    const { placed, missing, cut } = layOut(words, letterOf, ctx.config);
    mesh.geometry.dispose();
    mesh.geometry = mergeLetters(placed);
    objects.items.length = 0;
    if (placed.length > 0) objects.items.push(item);
    objects.version++;
    if (cut) reportCut();
    if (missing.length > 0) reportMissing(missing);
  }

  function reportCut(): void {
    ctx.report({
      code: 'SCR059',
      severity: 'warning',
      port: 'text',
      message: `The text has more than ${MAX_CHARACTERS} characters. The rest is not drawn.`,
      fix: 'Shorten it, or use a Label.',
    });
  }

  function reportMissing(missing: readonly string[]): void {
    ctx.report({
      code: 'SCR059',
      severity: 'warning',
      port: 'text',
      message: `There are no letters for: ${missing.join(' ')}`,
      fix: 'Add them to “Live characters” if the text is connected. Use a Label for scripts other than Latin, Greek and Cyrillic.',
    });
  }

  return {
    version: 0,
    update: () => {
      if (text.value !== shown) write(text.value);
      mesh.matrixWorld.makeScale(sizeM.value, sizeM.value, depthM.value);
      setSurface(material, ctx.params);
      setShadows(item, ctx.params);
    },
    dispose: () => {
      mesh.geometry.dispose();
      material.dispose();
    },
  };
}
