import { clockwiseTurn } from '../../kit/device-orientation.ts';
import { writePose } from '../../kit/pose.ts';
import { setFromAngles } from '../../kit/rigid.ts';
import type { NodeContext, NodeRuntime } from '../../kit/runtime.ts';
import { askForSensors } from '../../kit/sensor-permission.ts';
import type { SessionFrame } from '../../kit/session.ts';
import { writeViewerPosition } from '../../kit/viewer.ts';
import { type EastNorthUp, type GeoPlace, setEastNorthUp, setGeoPlace } from '../../kit/wgs84.ts';
import { type Compass, listenToCompass } from './compass.ts';
import type { definition } from './definition.ts';
import { createGeoAlignment, type GeoMotionNoise, RADIUS_95 } from './geo-alignment.ts';
import { type GeoFix, locate } from './locate.ts';
import { inaccurate, NO_NORTH, NORTH_DENIED, REFUSALS } from './notices.ts';

const RAD_PER_DEG = Math.PI / 180;
/** Noise of sessions with tracking: AR tracking drifts by 2 cm and 1° within a minute. */
const TRACKED: GeoMotionNoise = { moveM2PerS: 0.02 ** 2 / 60, turnRad2PerS: RAD_PER_DEG ** 2 / 60 };
/** Noise of other sessions, which do not notice that the visitor walks: at 1.4 m/s, in any direction. */
const UNTRACKED: GeoMotionNoise = { moveM2PerS: 1.4 ** 2, turnRad2PerS: RAD_PER_DEG ** 2 / 60 };
/** Least time between two readings of the compass that are used; its errors change more slowly than this. */
const COMPASS_PERIOD_S = 1;
/** While the device rotates faster, the compass is not read, because its reading is that of an earlier direction. */
const FASTEST_RAD_PER_S = 0.5;
const NO_COMPASS_S = 5;
const INACCURATE_S = 15;
const IDENTITY = Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);

type State = 'asking' | 'searching' | 'found' | 'inaccurate' | 'denied' | 'unavailable';

export function create(ctx: NodeContext<typeof definition>): NodeRuntime {
  const { outputs, params } = ctx;
  const onEllipsoid = ctx.config.height === 'ellipsoid';
  let noise = TRACKED;
  const alignment = createGeoAlignment(() => noise);
  const origin: GeoPlace = { latitudeDeg: 0, longitudeDeg: 0, altitudeM: 0 };
  const here: GeoPlace = { latitudeDeg: 0, longitudeDeg: 0, altitudeM: 0 };
  const target: GeoPlace = { latitudeDeg: 0, longitudeDeg: 0, altitudeM: 0 };
  const offset: EastNorthUp = { eastM: 0, northM: 0, upM: 0 };
  const viewerM = new Float64Array(3);
  const lastViewerM = new Float64Array(3);
  const lastView = new Float32Array(IDENTITY);
  const position = new Float64Array(3);
  const angles = new Float64Array(3);
  const worldFromPlace = new Float32Array(16);
  /** The newest position of the device that has not been used yet. */
  let fix: GeoFix | null = null;
  let lastFix: GeoFix | null = null;
  let isAsked = false;
  let lastSession = ctx.session.sessions;
  let refused: State | null = null;
  let compass: Compass | null = null;
  let fixedS: number | null = null;
  let listensS: number | null = null;
  let comparedS = Number.NEGATIVE_INFINITY;
  /** Altitude of the floor above the ellipsoid, and its variance. */
  let floorM = 0;
  let floorVariance = Number.POSITIVE_INFINITY;
  let frameJumps = 0;
  let hasView = false;
  let isShown = false;
  const told = new Set<string>();

  function tell(words: { readonly message: string; readonly fix: string }, topic: string): void {
    if (told.has(topic)) return;
    told.add(topic);
    ctx.report({ code: 'SCR055', severity: 'warning', ...words });
  }
  const endings = ctx.clock.held
    ? // A render has no place on Earth, and must be reproducible.
      []
    : [
        locate(
          () => {
            isAsked = true;
          },
          (found) => {
            fix = found;
            lastFix = found;
            refused = null;
          },
          (reason) => {
            tell(REFUSALS[reason], reason);
            if (reason === 'denied') refused = 'denied';
            else if (reason !== 'timeout') refused = 'unavailable';
          },
        ),
        askForSensors((answer) => {
          if (answer === 'granted') compass = listenToCompass();
          else tell(answer === 'denied' ? NORTH_DENIED : NO_NORTH, 'north');
        }),
      ];

  /** Passes the motion of the viewer since the last frame to the alignment. Returns how far the view has turned clockwise, radians. */
  function follow(frame: SessionFrame, worldFromView: Float32Array): number {
    const turned = hasView ? clockwiseTurn(worldFromView, lastView) : 0;
    if (hasView && frame.jumps !== frameJumps) {
      // The device is where it was, and looks where it did.
      alignment.jump(alignment.northRad - turned);
      isShown = false;
    } else if (hasView) {
      const [right, back] = [(viewerM[0] ?? 0) - (lastViewerM[0] ?? 0), (viewerM[2] ?? 0) - (lastViewerM[2] ?? 0)];
      alignment.move(noise === TRACKED ? right : 0, noise === TRACKED ? -back : 0, ctx.clock.deltaS);
    }
    frameJumps = frame.jumps;
    hasView = true;
    lastView.set(worldFromView);
    lastViewerM.set(viewerM);
    return turned;
  }
  function takeFix({ latitudeDeg, longitudeDeg, altitudeM, accuracyM, altitudeAccuracyM }: GeoFix): void {
    Object.assign(here, { latitudeDeg, longitudeDeg, altitudeM });
    if (!alignment.isPlaced) {
      // On the ellipsoid, so that altitudes are the same all around.
      Object.assign(origin, { latitudeDeg, longitudeDeg, altitudeM: 0 });
    }
    here.altitudeM = 0;
    setEastNorthUp(offset, origin, here);
    alignment.place(offset.eastM, offset.northM, Math.max(accuracyM, 0.01) / RADIUS_95, ctx.clock.timeS);
    fixedS ??= ctx.clock.timeS;
    if (altitudeAccuracyM === null) return;
    const variance = Math.max((altitudeAccuracyM / 1.96) ** 2, 1e-4) * (floorVariance === Number.POSITIVE_INFINITY ? 1 : 20);
    const gain = floorVariance === Number.POSITIVE_INFINITY ? 1 : floorVariance / (floorVariance + variance);
    floorM += gain * (altitudeM - (viewerM[1] ?? 0) - floorM);
    floorVariance = floorVariance === Number.POSITIVE_INFINITY ? variance : (1 - gain) * floorVariance;
  }
  function compare(reading: Compass, worldFromView: Float32Array, turnedRad: number): void {
    const { timeS, deltaS } = ctx.clock;
    if (!reading.isFresh || timeS - comparedS < COMPASS_PERIOD_S || Math.abs(turnedRad) > FASTEST_RAD_PER_S * deltaS) return;
    comparedS = timeS;
    alignment.turn(reading.take(worldFromView) + params.declinationRad.value, reading.sigmaRad, timeS);
  }
  /** Computes the pose of the place in world space. Returns its horizontal distance from the viewer, meters. */
  function aim(): number {
    target.latitudeDeg = params.latitudeDeg.value;
    target.longitudeDeg = params.longitudeDeg.value;
    target.altitudeM = onEllipsoid ? params.heightM.value : 0;
    setEastNorthUp(offset, origin, target);
    offset.eastM -= alignment.eastM;
    offset.northM -= alignment.northM;
    const [sine, cosine] = [Math.sin(alignment.northRad), Math.cos(alignment.northRad)];
    const rightM = offset.eastM * cosine - offset.northM * sine;
    const aheadM = offset.eastM * sine + offset.northM * cosine;
    const x = (viewerM[0] ?? 0) + rightM;
    const y = onEllipsoid ? offset.upM - floorM : params.heightM.value;
    const z = (viewerM[2] ?? 0) - aheadM;
    // The z axis of world space points to the azimuth + π; clockwise from above is negative about y.
    const yawRad = alignment.northRad + Math.PI - params.directionRad.value;
    const smoothing = params.smoothingS.value;
    const share = isShown && smoothing > 0 ? 1 - Math.exp(-ctx.clock.deltaS / smoothing) : 1;
    position[0] = (position[0] ?? 0) + (x - (position[0] ?? 0)) * share;
    position[1] = (position[1] ?? 0) + (y - (position[1] ?? 0)) * share;
    position[2] = (position[2] ?? 0) + (z - (position[2] ?? 0)) * share;
    const turn = yawRad - (angles[1] ?? 0);
    angles[1] = (angles[1] ?? 0) + Math.atan2(Math.sin(turn), Math.cos(turn)) * share;
    isShown = true;
    setFromAngles(worldFromPlace, position, angles);
    return Math.hypot(offset.eastM, offset.northM);
  }
  function stateOf(isKnown: boolean, isGood: boolean): State {
    if (refused) return refused;
    if (!isKnown) return isAsked || ctx.clock.held ? 'searching' : 'asking';
    return isGood ? 'found' : 'inaccurate';
  }
  function warn(isGood: boolean, errorM: number): void {
    const { timeS } = ctx.clock;
    if (compass) listensS ??= timeS;
    if (listensS !== null && !alignment.isTurned && timeS - listensS > NO_COMPASS_S) tell(NO_NORTH, 'north');
    if (fixedS !== null && alignment.isTurned && !isGood && timeS - fixedS > INACCURATE_S) {
      tell(inaccurate(errorM, params.largestErrorM.value), 'inaccurate');
    }
  }
  function writeViewer(worldFromView: Float32Array): void {
    offset.eastM = alignment.eastM;
    offset.northM = alignment.northM;
    offset.upM = 0;
    if (alignment.isPlaced) setGeoPlace(here, origin, offset);
    outputs.latitudeDeg.value = alignment.isPlaced ? here.latitudeDeg : 0;
    outputs.longitudeDeg.value = alignment.isPlaced ? here.longitudeDeg : 0;
    const heading = alignment.isTurned ? alignment.northRad + clockwiseTurn(worldFromView, IDENTITY) : 0;
    outputs.headingRad.value = heading - 2 * Math.PI * Math.floor(heading / (2 * Math.PI));
    outputs.headingErrorRad.value = alignment.turnErrorRad;
  }

  function forget(): void {
    alignment.reset();
    // A device at rest may give no other.
    fix = lastFix;
    floorVariance = Number.POSITIVE_INFINITY;
    hasView = false;
    isShown = false;
    fixedS = null;
    comparedS = Number.NEGATIVE_INFINITY;
  }

  return {
    update: (frame) => {
      // Another session has another world space.
      if (ctx.session.sessions !== lastSession) forget();
      lastSession = ctx.session.sessions;
      const view = frame.viewCount > 0 ? frame.views[0] : undefined;
      noise = frame.xr ? TRACKED : UNTRACKED;
      let errorM = Number.POSITIVE_INFINITY;
      if (view && writeViewerPosition(viewerM, frame)) {
        const turnedRad = follow(frame, view.worldFromView);
        if (fix) takeFix(fix);
        fix = null;
        if (compass) compare(compass, view.worldFromView, turnedRad);
        const isKnown = alignment.isPlaced && alignment.isTurned;
        outputs.distanceM.value = isKnown ? aim() : 0;
        errorM = alignment.errorM(offset.eastM, offset.northM);
      }
      const isKnown = alignment.isPlaced && alignment.isTurned;
      const hasHeight = !onEllipsoid || Number.isFinite(floorVariance);
      const isGood = isKnown && hasHeight && errorM <= params.largestErrorM.value && refused !== 'denied';
      outputs.errorM.value = Number.isFinite(errorM) ? errorM : -1;
      writePose(outputs.pose, isGood ? worldFromPlace : null, frame.jumps);
      outputs.state.value = stateOf(isKnown, isGood);
      writeViewer(view?.worldFromView ?? lastView);
      if (!ctx.clock.held) warn(isGood, errorM);
    },
    reset: forget,
    dispose: () => {
      for (const end of endings) end();
      compass?.dispose();
    },
  };
}
