/// <reference types="webxr" />
import type { DepthUsage } from '../../export/emulator/options.ts';
import { enterWith, first, lookAt, nameOfThrow, round } from './emulator-kit.ts';
import { type Facts, isSame, withDevice, within } from './webxr-clauses-kit.ts';

function wishes(usages: DepthUsage[], formats: XRDepthDataFormat[], more: Partial<XRDepthStateInit> = {}): XRSessionInit {
  return { requiredFeatures: ['depth-sensing'], depthSensing: { usagePreference: usages, dataFormatPreference: formats, ...more } };
}

const CPU = wishes(['cpu-optimized'], ['luminance-alpha']);

/** What of it a device was granted, or the name of its refusal. */
async function granted(init: XRSessionInit): Promise<unknown> {
  try {
    const session = await navigator.xr?.requestSession('immersive-ar', init);
    if (!session) return 'no session';
    const found = session.enabledFeatures?.includes('depth-sensing') ? [session.depthUsage, session.depthDataFormat] : 'without depth';
    await session.end();
    return found;
  } catch (error) {
    return error instanceof DOMException ? error.name : String(error);
  }
}

export function depthConfiguration(): Promise<Facts> {
  const optional = (init: XRSessionInit): XRSessionInit => ({
    optionalFeatures: ['depth-sensing'],
    ...(init.depthSensing && { depthSensing: init.depthSensing }),
  });
  return withDevice({ device: 'headset' }, async (emulator) => {
    const impossible = wishes(['cpu-optimized'], ['no-such-format' as XRDepthDataFormat]);
    const facts = {
      requiredWithoutWishes: await granted({ requiredFeatures: ['depth-sensing'] }),
      optionalWithoutWishes: await granted({ optionalFeatures: ['depth-sensing'] }),
      requiredImpossible: await granted(impossible),
      optionalImpossible: await granted(optional(impossible)),
      single: await granted(wishes(['cpu-optimized'], ['float32'])),
      several: await granted(
        wishes(['cpu-optimized', 'gpu-optimized'], ['no-such-format' as XRDepthDataFormat, 'float32', 'unsigned-short']),
      ),
      none: await granted(wishes([], [])),
      always: await granted(wishes([], ['luminance-alpha'])),
      typeIgnored: await granted(wishes([], [], { depthTypeRequest: ['smooth'] })),
    };
    const stage = await enterWith(emulator, {});
    const { session } = stage;
    const absent = [
      nameOfThrow(() => session.depthUsage),
      nameOfThrow(() => session.depthDataFormat),
      nameOfThrow(() => session.depthType),
      nameOfThrow(() => session.depthActive),
      nameOfThrow(() => session.pauseDepthSensing?.()),
    ];
    await stage.leave();
    return { ...facts, absent };
  });
}

export function cpuDepth(): Promise<Facts> {
  return within({ depth: { sizePx: [30, 20] } }, CPU, async (stage) => {
    const { session, emulator, binding } = stage;
    emulator.setPose(lookAt([0, 1.5, 0], [0, 0, -0.8]));
    const depthOf = (frame: XRFrame, view: XRView) => frame.getDepthInformation?.(view) ?? null;
    const old = await stage.frame((frame, pose) => {
      const view = first(pose.views);
      return { frame, view, depth: depthOf(frame, view) };
    });
    const facts = await stage.frame((frame, pose) => {
      const view = first(pose.views);
      const depth = depthOf(frame, view);
      if (!depth) throw new Error('No depth.');
      const raw = new Uint16Array(depth.data);
      const at = (column: number, row: number) => (raw[row * depth.width + column] ?? 0) * depth.rawValueToMeters;
      return {
        size: [depth.width, depth.height, depth.data.byteLength],
        sameObjects: isSame(() => depth.data) && isSame(() => depth.normDepthBufferFromNormView),
        // Looking down, the table before the feet is farther than the floor at them.
        looksUpwards: depth.getDepthInMeters(0.5, 0.02) > depth.getDepthInMeters(0.5, 0.98),
        indexed: [depth.getDepthInMeters(0.26, 0.51) - at(7, 10), depth.getDepthInMeters(0.999, 0.001) - at(29, 0)],
        clamped: depth.getDepthInMeters(1, 1) - at(29, 19),
        outside: [
          nameOfThrow(() => depth.getDepthInMeters(1.001, 0)),
          nameOfThrow(() => depth.getDepthInMeters(0, -0.001)),
          nameOfThrow(() => depth.getDepthInMeters(Number.NaN, 0)),
        ],
        foreignView: nameOfThrow(() => depthOf(frame, old.view)),
        onGpu: nameOfThrow(() => binding.getDepthInformation(view)),
        // Where it was measured from: the view, for this is the default of matchDepthView.
        matched: String([...(depth.transform?.matrix ?? [])]) === String([...view.transform.matrix]),
        matchedLens: String([...(depth.projectionMatrix ?? [])]) === String([...view.projectionMatrix]),
      };
    });
    const late = {
      frame: nameOfThrow(() => depthOf(old.frame, old.view)),
      data: nameOfThrow(() => old.depth?.data),
      value: nameOfThrow(() => old.depth?.getDepthInMeters(0.5, 0.5)),
    };
    session.pauseDepthSensing?.();
    const paused = await stage.frame((frame, pose) => [session.depthActive, depthOf(frame, first(pose.views))]);
    session.resumeDepthSensing?.();
    const resumed = await stage.frame((frame, pose) => [session.depthActive, depthOf(frame, first(pose.views)) !== null]);
    emulator.setDepth('stopped');
    const stopped = await stage.frame((frame, pose) => depthOf(frame, first(pose.views)));
    return {
      ...facts,
      late: Object.values(late),
      paused,
      resumed,
      stopped,
      attributes: [session.depthUsage, session.depthDataFormat, session.depthType],
    };
  });
}

export async function gpuDepth(): Promise<Facts> {
  const one = await within({}, wishes(['gpu-optimized'], ['luminance-alpha']), (stage) =>
    stage.frame((_, pose) => {
      const depth = stage.binding.getDepthInformation(first(pose.views));
      return [depth?.textureType, depth?.imageIndex, stage.gl.isTexture(depth?.texture ?? null)];
    }),
  );
  return within({ device: 'headset' }, wishes(['gpu-optimized'], ['unsigned-short']), async (stage) => {
    const { binding, session } = stage;
    const old = await stage.frame((_, pose) => {
      const view = first(pose.views);
      return { view, depth: binding.getDepthInformation(view) };
    });
    const facts = await stage.frame((frame, pose) => {
      const depths = pose.views.map((view) => binding.getDepthInformation(view));
      return {
        two: depths.map((depth) => [depth?.textureType, depth?.imageIndex]),
        shared: depths[0]?.texture === depths[1]?.texture,
        onCpu: nameOfThrow(() => frame.getDepthInformation?.(first(pose.views))),
      };
    });
    return {
      one,
      ...facts,
      late: [nameOfThrow(() => binding.getDepthInformation(old.view)), nameOfThrow(() => old.depth?.texture)],
      usage: session.depthUsage,
    };
  });
}

/** A buffer with a camera of its own, two frames late; both as the page is told. */
export function ownDepthCamera(): Promise<Facts> {
  const depth = { sizePx: [40, 30], sensor: { positionM: [0.05, 0, 0], fovYRad: 1.4 }, lagFrames: 2 } as const;
  return within({ depth }, wishes(['cpu-optimized'], ['luminance-alpha'], { matchDepthView: false }), async (stage) => {
    const told: { from: number[]; lens: number; middle: number }[] = [];
    for (const z of [0, 0.5, 1, 1.5]) {
      stage.emulator.setPose(lookAt([0, 0.4, z], [0, 0.4, -9]));
      told.push(
        await stage.frame((frame, pose) => {
          const info = frame.getDepthInformation?.(first(pose.views));
          const { x = 0, y = 0, z: back = 0 } = info?.transform?.position ?? {};
          return {
            from: [round(x), round(y), round(back)],
            lens: info?.projectionMatrix?.[5] ?? 0,
            middle: round(info?.getDepthInMeters(0.5, 0.5) ?? 0),
          };
        }),
      );
    }
    return { told };
  });
}
