import { describe, expect, test } from '@jest/globals';
import { program } from '../../../tests/compile/compiled.ts';
import { emptyStudio, fog, videoStudio } from '../../../tests/compile/graphs.ts';
import type { TestStudio } from '../../../tests/support/test-studio.ts';
import type { Program } from '../../program/program.ts';

/** video → filters in a row → screen; the last one draws onto the screen. */
function chain(types: readonly string[]): TestStudio {
  const studio = types.reduce((made, type, i) => made.add(`f-${i}`, type), videoStudio());
  return types.reduce(
    (made, _, i) => made.wire(`${i === 0 ? 'video-a' : `f-${i - 1}`}.layer -> f-${i}.inputImage`),
    studio.wire(`f-${types.length - 1}.layer -> screen-a.layer`),
  );
}

/** Each target, and the one whose texture it has. */
function sharing({ resources }: Program): Record<string, string> {
  return Object.fromEntries(
    resources.flatMap((resource) => (resource.kind === 'target' ? [[resource.id, resource.shares ?? resource.id]] : [])),
  );
}

const textures = (made: Program) => new Set(Object.values(sharing(made))).size;

describe('textures', () => {
  test('a chain of a hundred filters takes turns with two', () => {
    const made = program(chain(Array.from({ length: 101 }, () => 'filter/sepia')));
    expect(Object.keys(sharing(made))).toHaveLength(100);
    expect(textures(made)).toBe(2);
  });

  test('what is read again later keeps its texture until then', () => {
    const made = program(
      chain(['filter/sepia', 'filter/sepia', 'filter/sepia', 'filter/sepia'])
        .add('over-a', 'operator/over', { opacity: 0.5 })
        .wire('f-0.layer -> over-a.top', 'f-3.layer -> over-a.bottom', 'over-a.layer -> screen-a.layer'),
    );
    const { 'f-0.layer': first, ...others } = sharing(made);
    expect(first).toBe('f-0.layer');
    expect(Object.values(others)).not.toContain(first);
    expect(textures(made)).toBe(3);
  });

  test('what is viewed at keeps its own, and so does what lasts', () => {
    const studio = chain(['filter/sepia', 'filter/sepia', 'filter/sepia', 'filter/trails', 'filter/sepia', 'filter/sepia']);
    const viewed = sharing(program(studio, { taps: ['f-2.layer'] }));
    expect(Object.entries(viewed).filter(([, texture]) => texture === 'f-2.layer')).toEqual([['f-2.layer', 'f-2.layer']]);
    expect(Object.entries(viewed).filter(([, texture]) => texture === 'f-3.trail')).toEqual([['f-3.trail', 'f-3.trail']]);
  });

  test('pictures of other sizes, precisions or depths share with none', () => {
    const made = program(fog());
    const kinds = new Map(
      made.resources.flatMap((r) => (r.kind === 'target' ? [[r.id, `${r.format} ${r.depth} ${r.samples}`] as const] : [])),
    );
    for (const [id, texture] of Object.entries(sharing(made))) expect(kinds.get(id)).toBe(kinds.get(texture));
    expect(textures(made)).toBeLessThan(kinds.size);
  });

  test('a picture of its own size that the views read is kept for all of them', () => {
    const made = program(
      emptyStudio()
        .asset('sky-file', { path: 'assets/sky.png', kind: 'image' })
        .add('sky-a', 'source/image-file', { image: 'sky-file' })
        .add('sepia-a', 'filter/sepia')
        .add('sepia-b', 'filter/sepia')
        .add('sepia-c', 'filter/sepia')
        .add('screen-a', 'output/screen')
        .wire(
          'sky-a.layer -> sepia-a.inputImage',
          'sepia-a.layer -> sepia-b.inputImage',
          'sepia-b.layer -> sepia-c.inputImage',
          'sepia-c.layer -> screen-a.layer',
        ),
    );
    const { 'sepia-c.layer': shown, ...before } = sharing(made);
    expect(Object.keys(before)).toHaveLength(2);
    expect(made.resources.find(({ id }) => id === 'sepia-c.layer')).toMatchObject({ domain: 'image' });
    // Nothing is drawn after it that could take its place: it may well stand in that of the first.
    expect(shown).toBe('sepia-a.layer');
  });

  test('the linker makes what a shader discards transparent, so that nobody else’s picture shows through', () => {
    const holes =
      '/*{"ISFVSN":"2","INPUTS":[{"NAME":"inputImage","TYPE":"image"}]}*/\nvoid main() { if (isf_FragNormCoord.x > 0.5) discard; gl_FragColor = IMG_THIS_PIXEL(inputImage); }';
    const made = program(
      videoStudio()
        .source('holes.fs', holes)
        .add('f-0', 'filter/holes')
        .wire('video-a.layer -> f-0.inputImage', 'f-0.layer -> screen-a.layer'),
    );
    expect(made.shaders[0]?.fragment).not.toMatch(/\bdiscard\b/);
  });
});
