/// <reference types="webxr" />
import { installEmulator } from '../../export/emulator/install-emulator.ts';
import { enterWith, first, forward, lookAt, nameOfError, nameOfThrow, onStage, point, round, TABLE_ROOM, up } from './emulator-kit.ts';

/** Where spaces lie, for a head that has turned, bowed and moved. */
export async function spaces() {
  const emulator = installEmulator({ clock: 'manual', room: TABLE_ROOM });
  emulator.setPose(lookAt([1, 1.5, 2], [0, 0.5, 2]));
  const stage = await enterWith(emulator, { optionalFeatures: ['unbounded'] });
  const { session, space, frame } = stage;
  const local = await session.requestReferenceSpace('local');
  const viewer = await session.requestReferenceSpace('viewer');
  const shifted = space.getOffsetReferenceSpace(
    new XRRigidTransform({ x: 1, y: 0, z: 2 }, { x: 0, y: Math.SQRT1_2, z: 0, w: Math.SQRT1_2 }),
  );
  const ask = () =>
    frame((f, pose) => ({
      floor: point(pose.transform.position),
      local: point(f.getViewerPose(local)?.transform.position),
      localUp: up(f.getPose(local, space)?.transform.matrix),
      localForward: forward(f.getPose(local, space)?.transform.matrix),
      viewer: point(f.getViewerPose(viewer)?.transform.position),
      shifted: point(f.getViewerPose(shifted)?.transform.position),
    }));
  const before = await ask();
  emulator.setPose(lookAt([2, 1.6, 0], [2, 1.6, -1]));
  const after = await ask();
  emulator.recenter();
  const recentered = await ask();
  await stage.leave();
  await emulator.uninstall();
  return { before, after, recentered };
}

export function hits() {
  return onStage({ device: 'headset' }, { requiredFeatures: ['hit-test', 'anchors'] }, async ({ session, emulator, space, frame }) => {
    const viewer = await session.requestReferenceSpace('viewer');
    const planes = await session.requestHitTestSource?.({ space: viewer });
    const solids = await session.requestHitTestSource?.({ space: viewer, entityTypes: ['mesh'] });
    const down = new XRRay({ x: 0, y: 3, z: 1 }, { x: 0, y: -1, z: 0 });
    const straightDown = await session.requestHitTestSource?.({ space, offsetRay: down });
    if (!planes || !solids || !straightDown) throw new Error('No hit test.');
    emulator.setPose(lookAt([0, 1.6, 0], [0, 0.8, -1.8]));
    const found = await frame(async (f) => {
      const poses = (source: XRHitTestSource) => f.getHitTestResults(source).map((hit) => hit.getPose(space)?.transform);
      const anchor = f.getHitTestResults(planes)[0]?.createAnchor?.();
      return {
        planes: poses(planes).map((t) => point(t?.position)),
        normals: poses(planes).map((t) => up(t?.matrix)),
        solids: poses(solids).map((t) => point(t?.position)),
        straightDown: poses(straightDown).map((t) => point(t?.position)),
        ray: [...down.matrix],
        anchor,
      };
    });
    await frame(() => {});
    const anchor = await (await found).anchor;
    const anchored = await frame((f) => anchor && point(f.getPose(anchor.anchorSpace, space)?.transform.position));
    planes.cancel();
    const { anchor: _, ...rest } = await found;
    return { ...rest, anchored, cancelledTwice: await nameOfError(() => planes.cancel()) };
  });
}

/** What a page hears of a finger on the screen, and where its ray meets the floor. */
export function touches() {
  return onStage({ device: 'phone' }, { requiredFeatures: ['hit-test'] }, async ({ session, emulator, space, frame }) => {
    const heard: string[] = [];
    for (const type of ['selectstart', 'select', 'selectend'] as const)
      session.addEventListener(type, ({ inputSource }) => heard.push(`${type} ${inputSource.targetRayMode}`));
    session.addEventListener('inputsourceschange', ({ added, removed }) => heard.push(`+${added.length} -${removed.length}`));
    const duringEvent: unknown[] = [];
    session.addEventListener('selectstart', ({ frame: f, inputSource }) => {
      duringEvent.push(
        nameOfThrow(() => f.getViewerPose(space)),
        f.getPose(inputSource.targetRaySpace, space) !== null,
      );
    });
    const source = await session.requestHitTestSourceForTransientInput?.({ profile: 'generic-touchscreen' });
    if (!source) throw new Error('No hit test.');
    emulator.setPose(lookAt([0, 2, 0], [0, 0, 0.0001]));
    emulator.press(0.75, 0.5);
    const hit = await frame((f, pose) => {
      const [result] = f.getHitTestResultsForTransientInput(source);
      return {
        at: point(result?.results[0]?.getPose(space)?.transform.position),
        halfWidth: 1 / (first(pose.views).projectionMatrix[0] ?? 1),
      };
    });
    emulator.release();
    await frame(() => {});
    await frame(() => {});
    return { heard, hit, duringEvent };
  });
}

export function controllers() {
  return onStage({ device: 'headset' }, {}, async ({ session, emulator, frame }) => {
    const heard: string[] = [];
    for (const type of ['selectstart', 'select', 'selectend'] as const)
      session.addEventListener(type, ({ inputSource }) => heard.push(`${type} ${inputSource.handedness}`));
    await frame(() => {});
    emulator.device.controllers.right?.updateButtonValue('trigger', 1);
    await frame(() => {});
    const held = [...heard];
    emulator.device.controllers.right?.updateButtonValue('trigger', 0);
    await frame(() => {});
    return { held, heard, sources: session.inputSources.length };
  });
}

export async function overlay() {
  const root = document.createElement('div');
  const button = document.createElement('button');
  root.style.background = 'red';
  button.style.width = '100%';
  button.style.height = '100%';
  root.append(button);
  document.body.append(root);
  const result = await onStage(
    { device: 'phone' },
    { requiredFeatures: ['dom-overlay'], domOverlay: { root } },
    async ({ session, emulator, frame }) => {
      const heard: string[] = [];
      session.addEventListener('selectstart', () => heard.push('selectstart'));
      const tap = async () => {
        emulator.press(0.5, 0.5);
        await frame(() => {});
        emulator.release();
        await frame(() => {});
      };
      await frame(() => {});
      const during = { background: root.style.background, position: root.style.position, state: session.domOverlayState?.type };
      await tap();
      button.addEventListener('beforexrselect', (event) => event.preventDefault());
      await tap();
      return { during, heard };
    },
  );
  const after = { background: root.style.background, position: root.style.position };
  root.remove();
  return { ...result, after };
}

/** Planes and meshes in two frames: the same objects, changed once. */
export function surfaces() {
  return onStage(
    { device: 'headset', room: 'studio' },
    { requiredFeatures: ['plane-detection', 'mesh-detection'] },
    async ({ frame, space }) => {
      const look = () =>
        frame((f) => {
          const planes = [...(f.detectedPlanes ?? [])];
          const meshes = [
            ...((f as XRFrame & { detectedMeshes?: Set<{ vertices: Float32Array; indices: Uint32Array }> }).detectedMeshes ?? []),
          ];
          return {
            planes: planes.map((plane) => ({
              plane,
              label: (plane as XRPlane & { semanticLabel: string }).semanticLabel,
              orientation: plane.orientation,
              changed: plane.lastChangedTime,
              heights: plane.polygon.map(({ x, z }) => heightOf(f.getPose(plane.planeSpace, space)?.transform.matrix, x, z)),
            })),
            meshes: meshes.map(({ vertices, indices }) => [vertices.length / 3, indices.length / 3, Math.max(...indices.slice(-300))]),
          };
        });
      const [a, b] = [await look(), await look()];
      return {
        same: a.planes.every(({ plane, changed }, i) => plane === b.planes[i]?.plane && changed === b.planes[i]?.changed),
        planes: a.planes.map(({ label, orientation, heights }) => ({ label, orientation, heights })),
        meshes: a.meshes,
      };
    },
  );
}

/** A device that does not know the room: its planes before and after the page asks for a scan, and the error of a second one. */
export function roomCapture() {
  return onStage(
    { device: 'headset', room: 'studio', roomScanned: false },
    { requiredFeatures: ['plane-detection'] },
    async ({ frame, session }) => {
      const count = () => frame((f) => f.detectedPlanes?.size);
      const before = await count();
      await session.initiateRoomCapture?.();
      const after = await count();
      return { before, after, twice: await nameOfError(() => session.initiateRoomCapture?.()) };
    },
  );
}

function heightOf(m: ArrayLike<number> | undefined, x: number, z: number): number {
  return round((m?.[1] ?? 0) * x + (m?.[9] ?? 0) * z + (m?.[13] ?? 0));
}
