import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { program } from '../../../tests/compile/compiled.ts';
import { videoStudio } from '../../../tests/compile/graphs.ts';
import { compileText } from '../../../tests/support/compile-project.ts';

const controlled = () =>
  videoStudio()
    .add('sepia-a', 'filter/sepia')
    .add('sepia-b', 'filter/sepia')
    .add('slider-a', 'input/slider', { value: 0.75, min: 2, max: -1, label: ' Warmth ' })
    .add('choice-a', 'input/choice', { options: 'Day,, Night ,' })
    .wire(
      'video-a.layer -> sepia-a.inputImage',
      'sepia-a.layer -> sepia-b.inputImage',
      'sepia-b.layer -> screen-a.layer',
      'slider-a.number -> sepia-a.amount',
      'choice-a.index -> sepia-b.amount',
    );

describe('controls', () => {
  test('are listed with what a page needs to draw and to set them', () => {
    const made = program(controlled());
    expect(made.controls).toEqual([
      { node: 'choice-a', param: 'value', label: 'Choose', value: 0, kind: 'choice', options: ['Day', 'Night'] },
      { node: 'slider-a', param: 'value', label: 'Warmth', value: 0.75, kind: 'slider', min: -1, max: 2, step: 0.5 },
    ]);
    for (const { node, param } of made.controls ?? []) expect(made.slots.params).toHaveProperty([`${node}.${param}`]);
  });

  test('stand in the order that the designer gave them', () => {
    const made = program(controlled().set('choice-a.place', 2).set('slider-a.place', 1));
    expect(made.controls?.map(({ node }) => node)).toEqual(['slider-a', 'choice-a']);
  });

  test('without a label bear the name of their kind', () => {
    expect(program(controlled().set('slider-a.label', ' ')).controls?.[1]?.label).toBe('Slider');
  });

  test('are left out where a wire sets them, or where they do nothing', () => {
    const wired = controlled().add('time-a', 'value/time').wire('time-a.seconds -> slider-a.value');
    expect(program(wired).controls?.map(({ node }) => node)).toEqual(['choice-a']);
    expect(program(videoStudio().add('slider-a', 'input/slider')).controls).toBeUndefined();
  });

  test('params that a node shows to visitors are listed by choice, angles around their value; a connected one is left out', () => {
    const text = readFileSync(join(import.meta.dirname, '../../../nodes/light/from-panorama/example/project.scrim.json'), 'utf8');
    const lit = (params: object) => {
      const project = JSON.parse(text);
      Object.assign(project.graphs.main.nodes['lamps-e6ts'].params, params);
      project.graphs.main.nodes['time-a'] = { type: 'value/time', version: 1 };
      project.graphs.main.wires.push('time-a.seconds -> lamps-e6ts.intensity');
      return compileText(JSON.stringify(project)).controls;
    };
    const options = ['Directional', 'Spot', 'Point'];
    expect(lit({ visitorControls: true, rotationRad: 0.5, kind: 1 })).toEqual([
      { node: 'lamps-e6ts', param: 'kind', label: 'Type of light', value: 1, kind: 'choice', options },
      { node: 'lamps-e6ts', param: 'distanceM', label: 'Distance', value: 2.5, kind: 'slider', min: 0.1, max: 100, step: 0.1 },
      { node: 'lamps-e6ts', param: 'ambient', label: 'Ambient light', value: 1, kind: 'slider', min: 0, max: 10, step: 0.01 },
      {
        node: 'lamps-e6ts',
        param: 'rotationRad',
        label: 'Rotation',
        value: 0.5,
        kind: 'slider',
        step: 0.01,
        unit: 'rad',
        min: 0.5 - Math.PI / 6,
        max: 0.5 + Math.PI / 6,
      },
    ]);
  });
});
