import { afterEach, expect, test } from '@jest/globals';
import { createXrRenderTarget, type XrRenderTargetOptions } from './xr-render-target.ts';

const page = globalThis as unknown as Record<string, unknown>;

afterEach(() => {
  delete page.XRWebGLLayer;
});

/** The options of the layer that a session gets. */
async function layerInit(options: Partial<XrRenderTargetOptions>): Promise<XRWebGLLayerInit> {
  let init: XRWebGLLayerInit = {};
  page.XRWebGLLayer = class {
    constructor(_session: object, _gl: object, given: XRWebGLLayerInit) {
      init = given;
    }
  };
  const gl = { makeXRCompatible: async () => {} } as unknown as WebGL2RenderingContext;
  const session = { updateRenderState: async () => {} } as unknown as XRSession;
  await createXrRenderTarget(gl, session, { antialias: true, screenDepth: undefined, wantsDepth: false, authoredRoom: false, ...options });
  return init;
}

test('a headset gets the depth buffer where it shows all that is drawn, and there is none where nothing needs it', async () => {
  expect(await layerInit({ screenDepth: 'whole' })).toMatchObject({ depth: true, ignoreDepthValues: false });
  expect(await layerInit({})).toMatchObject({ depth: true, ignoreDepthValues: true });
  expect(await layerInit({ screenDepth: 'none' })).toMatchObject({ depth: false, ignoreDepthValues: true });
});
