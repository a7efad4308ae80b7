import { readShader, TEST_LIBRARY } from '../support/test-library.ts';
import { TestStudio } from '../support/test-studio.ts';

/** Graphs to compile, as designers would wire them, from the small node library of the tests. */

export function emptyStudio(): TestStudio {
  return new TestStudio({ library: TEST_LIBRARY, readShader });
}

/** Of a thing before and behind the room, its shadow on a floor, over the camera video. */
export const AR_WIRES: readonly string[] = [
  'fox-a.objects -> place-a.objects',
  'place-a.objects -> scene-a.objects',
  'sun-a.lights -> scene-a.lights',
  'scene-a.layer -> hide-a.layer',
  'room-a.depth -> hide-a.depth',
  'box-a.objects -> floor-a.objects',
  'place-a.objects -> shadow-a.casters',
  'floor-a.objects -> shadow-a.receivers',
  'sun-a.lights -> shadow-a.lights',
  'shadow-a.layer -> over-a.top',
  'video-a.layer -> over-a.bottom',
  'hide-a.layer -> over-b.top',
  'over-a.layer -> over-b.bottom',
  'over-b.layer -> screen-a.layer',
];

/** A model behind the room, its shadow on a phantom floor, over the camera video. */
export function arScene(): TestStudio {
  return emptyStudio()
    .asset('fox-file', { path: 'assets/fox.glb', kind: 'model' })
    .add('video-a', 'source/camera-video')
    .add('fox-a', 'source/model', { model: 'fox-file', speed: 0.5 })
    .add('place-a', 'objects/transform', { position: [0, 0, -2] })
    .add('box-a', 'objects/primitive')
    .add('floor-a', 'objects/phantom')
    .add('sun-a', 'light/directional')
    .add('room-a', 'world/depth')
    .add('scene-a', 'layer/scene')
    .add('hide-a', 'layer/depth-occlusion')
    .add('shadow-a', 'layer/shadow')
    .add('over-a', 'operator/over')
    .add('over-b', 'operator/over')
    .add('screen-a', 'output/screen')
    .wire(...AR_WIRES);
}

/** A scene over the video, which the two scenes of the paper treat in different orders. */
function paperScene(): TestStudio {
  return emptyStudio()
    .add('video-a', 'source/camera-video')
    .add('box-a', 'objects/primitive')
    .add('scene-a', 'layer/scene')
    .add('blur-a', 'filter/gaussian-blur')
    .add('over-a', 'operator/over')
    .add('sobel-a', 'filter/sobel-edges')
    .add('screen-a', 'output/screen')
    .wire('box-a.objects -> scene-a.objects', 'scene-a.layer -> over-a.top', 'sobel-a.layer -> screen-a.layer');
}

/** Scene A: the video is blurred, the model laid over it, edges found of both. */
export function blurBeforeMerging(): TestStudio {
  return paperScene().wire('video-a.layer -> blur-a.inputImage', 'blur-a.layer -> over-a.bottom', 'over-a.layer -> sobel-a.inputImage');
}

/** Scene B: video and model are merged, both blurred, edges found of that. */
export function blurAfterMerging(): TestStudio {
  return paperScene().wire('video-a.layer -> over-a.bottom', 'over-a.layer -> blur-a.inputImage', 'blur-a.layer -> sobel-a.inputImage');
}

/** Nothing but pictures: the page needs no three.js. A picture file filtered in its own size, masked by noise of the view's. */
export function imageOnly(): TestStudio {
  return emptyStudio()
    .asset('sky-file', { path: 'assets/sky.png', kind: 'image' })
    .add('sky-a', 'source/image-file', { image: 'sky-file' })
    .add('sepia-a', 'filter/sepia')
    .add('small-a', 'filter/thumbnail')
    .add('noise-a', 'generator/noise')
    .add('trails-a', 'filter/trails')
    .add('mask-a', 'operator/mask', { fit: 'contain' })
    .add('time-a', 'value/time')
    .add('math-a', 'value/math')
    .add('screen-a', 'output/screen')
    .wire(
      'sky-a.layer -> sepia-a.inputImage',
      'sepia-a.layer -> small-a.inputImage',
      'noise-a.layer -> trails-a.inputImage',
      'small-a.layer -> mask-a.inputImage',
      'trails-a.layer -> mask-a.mask',
      'time-a.seconds -> math-a.a',
      'math-a.result -> noise-a.scale',
      'mask-a.layer -> screen-a.layer',
    );
}

/** Adds the subgraph `twice`: the subgraph `look` applied twice, the first with a strength of its own. */
export function lookTwice(studio: TestStudio, strength: number): TestStudio {
  return studio
    .in('twice')
    .add('first-a', 'graph/look', { strength })
    .add('second-a', 'graph/look')
    .wire('first-a.layer -> second-a.picture')
    .expose('inputs', 'picture', 'first-a.picture')
    .expose('inputs', 'strength', 'second-a.strength')
    .expose('outputs', 'layer', 'second-a.layer');
}

/** The same look used twice, within another subgraph, with a param set and a param wired from outside. */
export function subgraphs(): TestStudio {
  const studio = emptyStudio()
    .in('look')
    .add('sepia-a', 'filter/sepia', { amount: 0.25 })
    .add('sobel-a', 'filter/sobel-edges')
    .wire('sepia-a.layer -> sobel-a.inputImage')
    .expose('inputs', 'picture', 'sepia-a.inputImage')
    .expose('inputs', 'strength', 'sepia-a.amount')
    .expose('outputs', 'layer', 'sobel-a.layer');
  return lookTwice(studio, 0.5)
    .in('main')
    .add('video-a', 'source/camera-video')
    .add('toggle-a', 'value/toggle')
    .add('twice-a', 'graph/twice')
    .add('screen-a', 'output/screen')
    .wire('video-a.layer -> twice-a.picture', 'toggle-a.value -> twice-a.strength', 'twice-a.layer -> screen-a.layer');
}

/** A filter whose strength and color move by themselves, within a subgraph and from outside of it. */
export function movedParams(): TestStudio {
  const keys = [
    { timeS: 0, value: 0, easing: 'ease-in' as const },
    { timeS: 2, value: 3, easing: 'linear' as const },
  ];
  return subgraphs()
    .unwire('toggle-a.value -> twice-a.strength')
    .remove('toggle-a')
    .bind('twice-a.strength', { expression: 'abs(sin(time))' })
    .add('noise-a', 'generator/noise')
    .add('over-a', 'operator/over')
    .bind('noise-a.scale', { track: { keys, repeat: 'mirror' } })
    .bind('over-a.opacity', { expression: 'frame % 2' })
    .wire('noise-a.layer -> over-a.top', 'twice-a.layer -> over-a.bottom', 'over-a.layer -> screen-a.layer');
}

/** Fog reads the depth of what `over` has merged. */
export function fog(): TestStudio {
  return arScene()
    .add('sepia-a', 'filter/sepia')
    .add('fog-a', 'filter/fog')
    .wire('over-b.layer -> sepia-a.inputImage', 'sepia-a.layer -> fog-a.inputImage', 'fog-a.layer -> screen-a.layer');
}

/** video → screen. */
export function videoStudio(): TestStudio {
  return emptyStudio().add('video-a', 'source/camera-video').add('screen-a', 'output/screen').wire('video-a.layer -> screen-a.layer');
}

/** A scene over something still to be wired. */
export function sceneStudio(): TestStudio {
  return emptyStudio()
    .add('video-a', 'source/camera-video')
    .add('box-a', 'objects/primitive')
    .add('scene-a', 'layer/scene')
    .add('over-a', 'operator/over')
    .add('screen-a', 'output/screen')
    .wire('box-a.objects -> scene-a.objects', 'scene-a.layer -> over-a.top', 'over-a.layer -> screen-a.layer');
}
