import type { ImageAsset } from '../../kit/assets.ts';
import type { RoomDepth, ViewFrame } from '../../kit/session.ts';
import type { DepthDrawing, DepthImage } from './drawing.ts';

/** Reads depth from an image in shades of gray. The image is the same for all views, and is scaled to cover each view. */
export interface ImageDepth {
  /** Returns the depth of a view. It is valid until the next call. */
  read(image: ImageAsset, view: ViewFrame, viewIndex: number, nearM: number, farM: number): RoomDepth;
  dispose(): void;
}

type Mutable<T> = { -readonly [K in keyof T]: T[K] };

/** Creates a reader of depth from images. `shades`: whether the gray values are linear in distance or in inverse distance. */
export function createImageDepth(
  gl: WebGL2RenderingContext,
  drawing: DepthDrawing,
  viewCount: number,
  shades: 'distance' | 'inverse',
): ImageDepth {
  const pass = drawing.link(shades === 'distance' ? DISTANCE : INVERSE, ['shades']);
  const rangeM = pass.uniform('rangeM');
  let meters: DepthImage | null = null;
  let drawn: WebGLTexture | null = null;
  let drawnNearM = 0;
  let drawnFarM = 0;
  const views: (Mutable<RoomDepth> | null)[] = Array.from({ length: viewCount }, () => null);

  const draw = (image: ImageAsset, nearM: number, farM: number): DepthImage => {
    if (meters && drawn === image.texture && drawnNearM === nearM && drawnFarM === farM) return meters;
    if (meters?.widthPx !== image.widthPx || meters.heightPx !== image.heightPx) {
      if (meters) drawing.free(meters);
      meters = drawing.createImage(image.widthPx, image.heightPx);
    }
    drawing.begin(meters, pass);
    drawing.texture(0, image.texture, 'nearest');
    gl.uniform2f(rangeM, nearM, farM);
    drawing.draw();
    drawn = image.texture;
    drawnNearM = nearM;
    drawnFarM = farM;
    return meters;
  };
  return {
    read: (image, { viewport, worldFromView }, viewIndex, nearM, farM) => {
      const { texture, widthPx, heightPx } = draw(image, nearM, farM);
      const depth = views[viewIndex] ?? createDepth(texture, widthPx, heightPx);
      views[viewIndex] = depth;
      depth.texture = texture;
      depth.widthPx = widthPx;
      depth.heightPx = heightPx;
      depth.worldFromDepth.set(worldFromView);
      setCover(depth.uvFromViewUv, widthPx / heightPx, viewport.widthPx / viewport.heightPx);
      return depth;
    },
    dispose: () => {
      if (meters) drawing.free(meters);
    },
  };
}

function createDepth(texture: WebGLTexture, widthPx: number, heightPx: number): Mutable<RoomDepth> {
  return { texture, widthPx, heightPx, uvFromViewUv: new Float32Array(9), worldFromDepth: new Float32Array(16) };
}

/** Writes the UV matrix that shows the center of the image, scaled to cover the view. */
function setCover(out: Float32Array, imageAspect: number, viewAspect: number): void {
  const width = Math.min(1, viewAspect / imageAspect);
  const height = Math.min(1, imageAspect / viewAspect);
  out.fill(0);
  out[0] = width;
  out[4] = height;
  out[6] = (1 - width) / 2;
  out[7] = (1 - height) / 2;
  out[8] = 1;
}

/** The start of the shaders that convert the image: white is nearest, an alpha below 0.5 is unknown, and the value is the Rec. 709 luma. */
const HEAD = /* glsl */ `
uniform sampler2D shades;
uniform vec2 rangeM;
float meters() {
  vec4 shade = texelFetch(shades, ivec2(gl_FragCoord.xy), 0);
  if (shade.a < 0.5) return 0.0;
  float white = clamp(dot(shade.rgb / shade.a, vec3(0.2126, 0.7152, 0.0722)), 0.0, 1.0);`;
const DISTANCE = /* glsl */ `${HEAD}
  return mix(rangeM.y, rangeM.x, white);
}`;
const INVERSE = /* glsl */ `${HEAD}
  return 1.0 / mix(1.0 / rangeM.y, 1.0 / rangeM.x, white);
}`;
