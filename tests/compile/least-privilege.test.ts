import { describe, expect, test } from '@jest/globals';
import { programUse } from '../../export/bundle/program-use.ts';
import { describeProgram } from '../../export/compiler/describe.ts';
import type { Program } from '../../export/program/program.ts';
import { sessionInit } from '../../export/runtime/sessions/webxr/session-init.ts';
import type { NodeDefinition, NodeLibrary } from '../../nodes/kit/definition.ts';
import { formatDiagnostic } from '../../nodes/kit/diagnostics.ts';
import { definition as depthView } from '../../nodes/layer/depth-view/definition.ts';
import { LIBRARY } from '../support/library.ts';
import { readShader } from '../support/test-library.ts';
import { TestStudio } from '../support/test-studio.ts';

/** What an exported page asks of its visitors, by the nodes that ship: no more than the picture on screen needs. */

/** The library, with a node type of the test. */
function libraryWith(made: NodeDefinition): NodeLibrary {
  return { ...LIBRARY, definition: (type) => (type === made.type ? made : LIBRARY.definition(type)), types: () => LIBRARY.types() };
}

function program(studio: TestStudio): Program {
  const { output, diagnostics } = studio.compile();
  if (output === null) throw new Error(diagnostics.map(formatDiagnostic).join('\n'));
  return output;
}

/** Feature descriptors, as the browser is asked; the floor, which reveals nothing, is always among the optional ones. */
function asked(studio: TestStudio): string[] {
  const { needs } = program(studio);
  const { requiredFeatures = [], optionalFeatures = [], depthSensing } = sessionInit(needs, null);
  expect(depthSensing !== undefined).toBe(optionalFeatures.concat(requiredFeatures).includes('depth-sensing'));
  return [...requiredFeatures, ...optionalFeatures].filter((feature) => feature !== 'local-floor');
}

/** A box over the camera's picture. */
const scene = () =>
  new TestStudio({ library: LIBRARY, readShader })
    .add('video-a', 'source/camera-video')
    .add('box-a', 'objects/primitive')
    .add('scene-a', 'layer/scene')
    .add('over-a', 'operator/over')
    .add('screen-a', 'output/screen')
    .wire(
      'box-a.objects -> scene-a.objects',
      'scene-a.layer -> over-a.top',
      'video-a.layer -> over-a.bottom',
      'over-a.layer -> screen-a.layer',
    );

/** The same, hidden where the room is nearer. */
const hidden = () =>
  scene()
    .add('room-a', 'world/depth')
    .add('hide-a', 'layer/depth-occlusion')
    .wire('scene-a.layer -> hide-a.layer', 'room-a.depth -> hide-a.depth', 'hide-a.layer -> over-a.top');

/** The whole picture in sepia: the camera's has to be sampled. */
const styled = (studio: TestStudio) =>
  studio.add('sepia-a', 'filter/sepia').wire('over-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> screen-a.layer');

describe('the camera’s picture', () => {
  test('is not asked for where it is only behind everything: the device shows it by itself', () => {
    expect(asked(scene())).toEqual([]);
    expect(programUse(program(scene())).nodeTypes).not.toContain('source/camera-video');
    expect(describeProgram(program(scene()))).toContain('Asks the visitor for\n  nothing');
  });

  test('is asked for where a filter reads it', () => {
    expect(asked(styled(scene()))).toEqual(['camera-access']);
  });

  test('is not asked for where the filter is muted, or styles virtual things alone', () => {
    expect(asked(styled(scene()).mute('sepia-a'))).toEqual([]);
    const virtual = scene().add('sepia-a', 'filter/sepia').wire('scene-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> over-a.top');
    expect(asked(virtual)).toEqual([]);
  });

  test('is not asked for where the filter that reads it leads nowhere', () => {
    expect(asked(scene().add('sepia-a', 'filter/sepia').wire('video-a.layer -> sepia-a.inputImage'))).toEqual([]);
  });

  test('is not required where something else is shown: without it the page still starts', () => {
    expect(sessionInit(program(styled(hidden())).needs, null).requiredFeatures).toEqual([]);
  });

  /** The camera's picture alone, in sepia and in gray. */
  const alone = () =>
    new TestStudio({ library: LIBRARY, readShader })
      .add('video-a', 'source/camera-video')
      .add('sepia-a', 'filter/sepia')
      .add('grey-a', 'filter/grey')
      .add('screen-a', 'output/screen')
      .wire('video-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> grey-a.inputImage', 'grey-a.layer -> screen-a.layer');

  test('is required where nothing is left without it; the other ways in bring it along', () => {
    const made = program(alone());
    expect(sessionInit(made.needs, null).requiredFeatures).toEqual(['camera-access']);
    expect(made.tiers.map(({ id }) => id)).toEqual(['ar-camera', 'camera', 'authored-vr', 'orbit']);
  });

  test('is not required where a color takes its place', () => {
    expect(sessionInit(program(alone().set('video-a.withoutImage', 'color')).needs, null).requiredFeatures).toEqual([]);
  });
});

describe('the depth of the room', () => {
  test('is asked for where something on screen is hidden by it, and nothing else is', () => {
    expect(asked(hidden())).toEqual(['depth-sensing']);
    expect(asked(styled(hidden()))).toEqual(['camera-access', 'depth-sensing']);
  });

  test('is asked for smooth, and raw only where all that reads it measures', () => {
    const measuring = libraryWith({
      ...depthView,
      type: 'test/measures',
      inputs: { depth: { ...depthView.inputs.depth, depthType: 'raw' } },
    });
    const shown = (type: string) =>
      new TestStudio({ library: measuring, readShader })
        .add('room-a', 'world/depth')
        .add('shown-a', type)
        .add('screen-a', 'output/screen')
        .wire('room-a.depth -> shown-a.depth', 'shown-a.layer -> screen-a.layer');
    const typesOf = (studio: TestStudio) => sessionInit(program(studio).needs, null).depthSensing?.depthTypeRequest;
    expect(typesOf(shown('test/measures'))).toEqual(['raw', 'smooth']);
    expect(typesOf(shown('layer/depth-view'))).toEqual(['smooth', 'raw']);
    const both = shown('test/measures')
      .add('view-a', 'layer/depth-view')
      .add('over-a', 'operator/over')
      .wire(
        'room-a.depth -> view-a.depth',
        'view-a.layer -> over-a.top',
        'shown-a.layer -> over-a.bottom',
        'over-a.layer -> screen-a.layer',
      );
    expect(typesOf(both)).toEqual(['smooth', 'raw']);
  });

  test('is not asked for where the hiding is muted', () => {
    expect(asked(hidden().mute('hide-a'))).toEqual([]);
  });

  test('is not asked for by nodes that lead nowhere', () => {
    expect(asked(scene().add('room-a', 'world/depth'))).toEqual([]);
    expect(asked(hidden().wire('scene-a.layer -> over-a.top'))).toEqual([]);
  });

  test('is asked for by a subgraph only where it is used and not muted', () => {
    const withSubgraph = () =>
      scene()
        .in('hiding')
        .add('room-a', 'world/depth')
        .add('hide-a', 'layer/depth-occlusion')
        .wire('room-a.depth -> hide-a.depth')
        .expose('inputs', 'picture', 'hide-a.layer')
        .expose('outputs', 'layer', 'hide-a.layer')
        .in('main');
    expect(asked(withSubgraph())).toEqual([]);
    const used = () =>
      withSubgraph().add('hiding-a', 'graph/hiding').wire('scene-a.layer -> hiding-a.picture', 'hiding-a.layer -> over-a.top');
    expect(asked(used())).toEqual(['depth-sensing']);
    expect(asked(used().mute('hiding-a'))).toEqual([]);
  });
});

test('looking at a layer asks for what it needs, and an export looks at nothing', () => {
  const { output } = scene().compile({ taps: ['video-a.layer'] });
  expect(output?.needs.map(({ capability }) => capability)).toEqual(['camera-image']);
  expect(asked(scene())).toEqual([]);
});

describe('the plan says in words', () => {
  test('what is asked for, why, and what is lost without it', () => {
    const plan = describeProgram(program(styled(hidden())));
    const section = plan.slice(plan.indexOf('Asks the visitor for'), plan.indexOf('Plays in')).trim().split('\n').slice(1);
    expect(section).toHaveLength(2);
    expect(section[0]).toMatch(/1\. the camera image, to .* \(video-a\); without it /);
    expect(section[1]).toMatch(/2\. room depth, to .* \(room-a\); without it /);
  });

  test('where it plays, best first, and nothing where nothing is lost', () => {
    const plays = (studio: TestStudio) => {
      const plan = describeProgram(program(studio));
      return plan
        .slice(plan.indexOf('Plays in'), plan.indexOf('On devices'))
        .split('\n')
        .slice(1)
        .filter((line) => /^ {2}\d\./.test(line));
    };
    expect(plays(styled(scene()))).toHaveLength(5);
    expect(plays(scene()).map((line) => line.slice(5))).toEqual([
      'AR',
      'Camera without AR: its image, with the orientation of the phone',
      'VR headset: a virtual room',
      'Any other browser: orbit with mouse or finger',
    ]);
    expect(describeProgram(program(scene()))).not.toContain('camera image');
  });
});

describe('what is not used is not in the page', () => {
  test('no player of expressions or tracks where nothing moves by itself', () => {
    expect(programUse(program(styled(scene()))).nodeTypes.filter((type) => type.startsWith('binding/'))).toEqual([]);
  });

  test('each where it is used', () => {
    const types = (studio: TestStudio) => programUse(program(studio)).nodeTypes.filter((type) => type.startsWith('binding/'));
    expect(types(styled(scene()).bind('sepia-a.amount', { expression: 'time' }))).toEqual(['binding/expression']);
    const keys = [{ timeS: 0, value: 1, easing: 'linear' as const }];
    expect(types(styled(scene()).bind('sepia-a.amount', { track: { keys, repeat: 'once' } }))).toEqual(['binding/track']);
  });
});

describe('light and surfaces of the room', () => {
  const lit = () => scene().add('light-a', 'world/light-estimate').wire('light-a.lights -> scene-a.lights');

  test('are asked for where they are used, optionally, and nothing else is for their sake', () => {
    expect(asked(lit())).toEqual(['light-estimation']);
    const shadowed = (surfaces: string) =>
      lit()
        .add('real-a', surfaces)
        .add('shadow-a', 'layer/shadow')
        .add('under-a', 'operator/over')
        .wire(
          'box-a.objects -> shadow-a.casters',
          'real-a.objects -> shadow-a.receivers',
          'light-a.lights -> shadow-a.lights',
          'shadow-a.layer -> under-a.bottom',
          'scene-a.layer -> under-a.top',
          'under-a.layer -> over-a.top',
        );
    expect(asked(shadowed('world/planes')).sort()).toEqual(['light-estimation', 'plane-detection']);
    expect(asked(shadowed('world/meshes')).sort()).toEqual(['light-estimation', 'mesh-detection']);
    expect(sessionInit(program(shadowed('world/planes')).needs, null).requiredFeatures).toEqual([]);
    // Room depth is read by the shadow itself, and asked for by its node alone.
    const onDepth = lit()
      .add('room-a', 'world/depth')
      .add('shadow-a', 'layer/shadow')
      .wire('box-a.objects -> shadow-a.casters', 'room-a.depth -> shadow-a.depth', 'light-a.lights -> shadow-a.lights')
      .wire('shadow-a.layer -> over-a.bottom');
    expect(asked(onDepth).sort()).toEqual(['depth-sensing', 'light-estimation']);
  });

  test('are not asked for where they are placed and not used', () => {
    expect(asked(scene().add('light-a', 'world/light-estimate').add('planes-a', 'world/planes'))).toEqual([]);
  });
});
