import {
  CustomBlending,
  DataTexture,
  LinearFilter,
  Matrix4,
  Mesh,
  OneFactor,
  OneMinusSrcAlphaFactor,
  PlaneGeometry,
  RGBAFormat,
  Scene,
  ShaderMaterial,
  UnsignedByteType,
  Vector4,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { createEyeCamera, type Eye } from '../display/eye.ts';
import type { ViewportPx } from '../session/viewport-scale.ts';

/** The image of a WebXR layer: that of one eye, or the same for both eyes. */
export interface LayerImage {
  /** Premultiplied, rows from the bottom. */
  readonly rgba: Uint8Array;
  readonly widthPx: number;
  readonly heightPx: number;
  /** The visible part. */
  readonly part: ViewportPx;
  readonly opacity: number;
  readonly useAlpha: boolean;
  readonly shape: LayerShape;
}

/** Shape in meters and radians; `screen` covers the whole viewport of the eye. */
export type LayerShape =
  | { readonly kind: 'screen' }
  | { readonly kind: 'quad'; readonly worldFromLayer: Matrix4; readonly widthM: number; readonly heightM: number }
  | {
      readonly kind: 'cylinder';
      readonly worldFromLayer: Matrix4;
      readonly radiusM: number;
      readonly angleRad: number;
      readonly heightM: number;
    };

/** Composites the images of several layers on the device's own context, as the compositor of a headset does. */
export interface LayerCompositor {
  /** Draws the images of each eye from bottom to top. `out` receives premultiplied RGBA, rows from the bottom. */
  compose(widthPx: number, heightPx: number, eyes: readonly Eye[], images: (eye: Eye) => Iterable<LayerImage>, out: Uint8Array): void;
  dispose(): void;
}

/** Segments of a full circle along a cylinder; with 128 the error is 0.03 % of the radius. */
const SEGMENTS = 128;

const VERTEX_SHADER = `
  uniform mat4 clipFromLayer;
  uniform vec4 shape; // width, height, angle, radius
  uniform vec4 part;
  uniform bool onScreen;
  varying vec2 layerUv;
  void main() {
    layerUv = part.xy + uv * part.zw;
    vec2 at = uv - 0.5;
    float angle = at.x * shape.z;
    vec3 onQuad = vec3(at * shape.xy, 0.0);
    vec3 onCylinder = vec3(shape.w * sin(angle), at.y * shape.y, -shape.w * cos(angle));
    gl_Position = onScreen ? vec4(at * 2.0, 0.0, 1.0) : clipFromLayer * vec4(shape.w > 0.0 ? onCylinder : onQuad, 1.0);
  }`;

const FRAGMENT_SHADER = `
  uniform sampler2D image;
  uniform float opacity;
  uniform bool useAlpha;
  varying vec2 layerUv;
  void main() {
    vec4 color = texture(image, layerUv);
    gl_FragColor = (useAlpha ? color : vec4(color.rgb, 1.0)) * opacity;
  }`;

export function createLayerCompositor(renderer: WebGLRenderer): LayerCompositor {
  const uniforms = {
    image: { value: null as DataTexture | null },
    clipFromLayer: { value: new Matrix4() },
    shape: { value: new Vector4() },
    part: { value: new Vector4() },
    onScreen: { value: false },
    opacity: { value: 1 },
    useAlpha: { value: true },
  };
  const material = new ShaderMaterial({
    uniforms,
    vertexShader: VERTEX_SHADER,
    fragmentShader: FRAGMENT_SHADER,
    depthTest: false,
    depthWrite: false,
    blending: CustomBlending,
    blendSrc: OneFactor,
    blendDst: OneMinusSrcAlphaFactor,
  });
  const mesh = new Mesh(new PlaneGeometry(1, 1, SEGMENTS, 1), material);
  mesh.frustumCulled = false;
  const scene = new Scene();
  scene.add(mesh);
  const camera = createEyeCamera();
  let target: WebGLRenderTarget | null = null;

  const draw = (image: LayerImage, eye: Eye): void => {
    const { part, shape, widthPx, heightPx } = image;
    const texture = new DataTexture(image.rgba, widthPx, heightPx, RGBAFormat, UnsignedByteType);
    if (shape.kind !== 'screen') {
      texture.minFilter = LinearFilter;
      texture.magFilter = LinearFilter;
    }
    texture.needsUpdate = true;
    uniforms.image.value = texture;
    uniforms.part.value.set(part.x / widthPx, part.y / heightPx, part.widthPx / widthPx, part.heightPx / heightPx);
    uniforms.opacity.value = image.opacity;
    uniforms.useAlpha.value = image.useAlpha;
    uniforms.onScreen.value = shape.kind === 'screen';
    if (shape.kind === 'quad') uniforms.shape.value.set(shape.widthM, shape.heightM, 0, 0);
    if (shape.kind === 'cylinder') uniforms.shape.value.set(0, shape.heightM, shape.angleRad, shape.radiusM);
    if (shape.kind !== 'screen') {
      const viewFromWorld = scratchView.fromArray(eye.worldFromView).invert();
      uniforms.clipFromLayer.value.fromArray(eye.clipFromView).multiply(viewFromWorld).multiply(shape.worldFromLayer);
    }
    renderer.render(scene, camera);
    texture.dispose();
  };

  return {
    compose: (widthPx, heightPx, eyes, images, out) => {
      if (!target || target.width !== widthPx || target.height !== heightPx) {
        target?.dispose();
        target = new WebGLRenderTarget(widthPx, heightPx, { depthBuffer: false });
      }
      renderer.setRenderTarget(target);
      renderer.setScissorTest(false);
      renderer.setClearColor(0x000000, 0);
      renderer.clear();
      for (const eye of eyes) {
        const { x, y, widthPx: w, heightPx: h } = eye.viewport;
        target.viewport.set(x, y, w, h);
        target.scissor.set(x, y, w, h);
        target.scissorTest = true;
        renderer.setRenderTarget(target);
        for (const image of images(eye)) draw(image, eye);
      }
      target.scissorTest = false;
      target.viewport.set(0, 0, widthPx, heightPx);
      renderer.setRenderTarget(null);
      renderer.readRenderTargetPixels(target, 0, 0, widthPx, heightPx, out);
    },
    dispose: () => {
      target?.dispose();
      mesh.geometry.dispose();
      material.dispose();
    },
  };
}

// Valid during one `draw` only.
const scratchView = new Matrix4();
