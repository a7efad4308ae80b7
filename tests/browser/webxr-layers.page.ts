/// <reference types="webxr" />
import { createContext, first, lookAt, nameOfThrow, requestSession } from './emulator-kit.ts';
import { type Facts, withDevice } from './webxr-clauses-kit.ts';

type Color = readonly [number, number, number, number];
const RED: Color = [1, 0, 0, 1];
const GREEN: Color = [0, 1, 0, 1];
const HALF_BLUE: Color = [0, 0, 0.5, 0.5];

/** Fills what a sub-image is for. */
function fill(gl: WebGL2RenderingContext, framebuffer: WebGLFramebuffer, image: XRWebGLSubImage, color: Color): void {
  const { x, y, width, height } = image.viewport;
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  const index = image.imageIndex as number | null;
  if (index === null) gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, image.colorTexture, 0);
  else gl.framebufferTextureLayer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, image.colorTexture, 0, index);
  gl.enable(gl.SCISSOR_TEST);
  gl.scissor(x, y, width, height);
  gl.clearColor(...color);
  gl.clear(gl.COLOR_BUFFER_BIT);
  gl.disable(gl.SCISSOR_TEST);
}

/**
 * A red projection layer, half covered by what stands before it: a green quad of 1 m at 2 m, stereo, of which the right eye's half is
 * blue; or a cylinder. What is seen at places of the picture, per eye: middle, and outside of the quad.
 */
export function pictures(kind: 'quad' | 'cylinder', textureType: 'texture' | 'texture-array'): Promise<Facts> {
  return withDevice({ device: 'headset', sizePx: [128, 64], ipdM: 0 }, async (emulator) => {
    emulator.setPose(lookAt([0, 1.5, 0], [0, 1.5, -1]));
    const session = await requestSession({ requiredFeatures: ['layers'] }, 'immersive-vr');
    const gl = createContext();
    const binding = new XRWebGLBinding(session, gl);
    const space = await session.requestReferenceSpace('local-floor');
    const projection = binding.createProjectionLayer({ textureType });
    const transform = new XRRigidTransform({ y: 1.5, z: kind === 'quad' ? -2 : 0 });
    const init = { space, viewPixelWidth: 16, viewPixelHeight: 16, transform, layout: 'stereo', textureType } as const;
    const placed =
      kind === 'quad'
        ? binding.createQuadLayer({ ...init, width: 1, height: 1 })
        : binding.createCylinderLayer({ ...init, radius: 2, centralAngle: 0.5, aspectRatio: 1 });
    session.updateRenderState({ layers: [projection, placed] });
    const framebuffer = gl.createFramebuffer();
    const draw = (color: Color) =>
      new Promise<object>((resolve) => {
        session.requestAnimationFrame((_, f) => {
          const redraw = placed.needsRedraw;
          const views = f.getViewerPose(space)?.views ?? [];
          const images = views.map((view) => {
            const image = binding.getViewSubImage(projection, view);
            fill(gl, framebuffer, image, color);
            return [image.viewport.x, image.viewport.width, image.imageIndex, image.depthStencilTexture !== null];
          });
          fill(gl, framebuffer, binding.getSubImage(placed, f, 'left'), GREEN);
          fill(gl, framebuffer, binding.getSubImage(placed, f, 'right'), HALF_BLUE);
          resolve({ images, redraw, sizes: [projection.textureWidth, projection.textureHeight, projection.textureArrayLength] });
        });
      });
    const drawn = draw(RED);
    await emulator.stepFrame();
    const { rgba, widthPx } = emulator.readLayer();
    const at = (x: number, y: number) => [...rgba.subarray((y * widthPx + x) * 4, (y * widthPx + x) * 4 + 4)];
    const width = (x: number) => Array.from({ length: 64 }, (_, i) => at(x + i, 32)).filter(([red]) => red !== 255).length;
    return {
      ...(await drawn),
      left: [at(32, 32), at(4, 32)],
      right: [at(96, 32), at(68, 32)],
      // What the quad covers of 64 columns: 1 m at 2 m, of 2 · 2 m · tan(0.7).
      widths: [width(0), width(64)],
      redrawAfter: placed.needsRedraw,
    };
  });
}

/** Opacity, an opaque layer, a layer taken away, and one whose space moves with the head. */
export function ways(): Promise<Facts> {
  return withDevice({ device: 'headset', views: 1, sizePx: [64, 64] }, async (emulator) => {
    const session = await requestSession({ requiredFeatures: ['layers'] }, 'immersive-vr');
    const gl = createContext();
    const binding = new XRWebGLBinding(session, gl);
    const viewer = await session.requestReferenceSpace('viewer');
    // @types/webxr does not know of its opacity.
    const quad: XRQuadLayer & { opacity?: number } = binding.createQuadLayer({
      space: viewer,
      viewPixelWidth: 8,
      viewPixelHeight: 8,
      transform: new XRRigidTransform({ z: -1 }),
    });
    session.updateRenderState({ layers: [quad] });
    const framebuffer = gl.createFramebuffer();
    const show = async (change: () => void) => {
      change();
      const called = new Promise<void>((resolve) => {
        session.requestAnimationFrame((_, f) => {
          if (!quad.needsRedraw) return resolve();
          fill(gl, framebuffer, binding.getSubImage(quad, f), HALF_BLUE);
          resolve();
        });
      });
      await emulator.stepFrame();
      await called;
      const { rgba } = emulator.readLayer();
      return [...rgba.subarray((32 * 64 + 32) * 4, (32 * 64 + 32) * 4 + 4)];
    };
    return {
      plain: await show(() => {}),
      turned: await show(() => emulator.setPose(lookAt([1, 1, 1], [2, 1, 1]))),
      faint: await show(() => {
        quad.opacity = 0.5;
      }),
      opaque: await show(() => {
        quad.opacity = 7;
        quad.blendTextureSourceAlpha = false;
      }),
      opacity: quad.opacity,
      behind: await show(() => {
        quad.transform = new XRRigidTransform({ z: -1 }, { y: 1, w: 0 });
      }),
      destroyed: await show(() => {
        quad.transform = new XRRigidTransform({ z: -1 });
        quad.destroy();
      }),
    };
  });
}

export async function refusals(): Promise<Facts> {
  const without = await withDevice({ device: 'headset' }, async () => {
    const session = await requestSession({});
    const binding = new XRWebGLBinding(session, createContext());
    const space = await session.requestReferenceSpace('local');
    const layers = [binding.createProjectionLayer(), binding.createProjectionLayer()];
    return {
      quad: nameOfThrow(() => binding.createQuadLayer({ space, viewPixelWidth: 8, viewPixelHeight: 8 })),
      two: nameOfThrow(() => session.updateRenderState({ layers })),
      one: nameOfThrow(() => session.updateRenderState({ layers: [first(layers)] })),
    };
  });
  return withDevice({ device: 'headset' }, async () => {
    const session = await requestSession({ requiredFeatures: ['layers'] });
    const gl = createContext();
    const binding = new XRWebGLBinding(session, gl);
    const space = await session.requestReferenceSpace('local');
    const init = { space, viewPixelWidth: 8, viewPixelHeight: 8 };
    const layer = binding.createQuadLayer(init);
    const refused = {
      noSpace: nameOfThrow(() => binding.createQuadLayer({ ...init, space: null as never })),
      noWidth: nameOfThrow(() => binding.createQuadLayer({ ...init, width: 0 })),
      noPixels: nameOfThrow(() => binding.createQuadLayer({ ...init, viewPixelHeight: 0 })),
      default: nameOfThrow(() => binding.createQuadLayer({ ...init, layout: 'default' })),
      format: nameOfThrow(() => binding.createQuadLayer({ ...init, colorFormat: gl.RGBA32F })),
      cylinder: nameOfThrow(() => binding.createCylinderLayer({ ...init, transform: new XRRigidTransform(), centralAngle: 7 })),
      cube: nameOfThrow(() => binding.createCubeLayer()),
      twice: nameOfThrow(() => session.updateRenderState({ layers: [layer, layer] })),
      withBase: nameOfThrow(() => session.updateRenderState({ layers: [layer], baseLayer: new XRWebGLLayer(session, gl) })),
    };
    await session.end();
    return { without, ...refused, ended: nameOfThrow(() => binding.createQuadLayer(init)) };
  });
}
