/**
 * Estimates where world space lies on the earth, from satellite positions, the compass, and the motion that the session measures.
 *
 * An extended Kalman filter over the device's position east and north of an origin and the azimuth of world space's -z axis. Between two
 * measurements the device moves as the session measures, rotated by the azimuth; so a walk corrects the azimuth. Noise allows for tracking
 * that drifts. The errors of satellites and compass change slowly: measurements shortly after each other tell little new and count less
 * (`CORRELATION_S`).
 */
export interface GeoAlignment {
  /** Whether the position is known. */
  readonly isPlaced: boolean;
  /** Whether the azimuth is known. */
  readonly isTurned: boolean;
  readonly eastM: number;
  readonly northM: number;
  /** Azimuth of world space's -z axis, clockwise from north. */
  readonly northRad: number;
  /** The uncertainty of the azimuth: it is within this angle in 95 % of cases. */
  readonly turnErrorRad: number;
  /** The horizontal uncertainty of a point at an offset from the device, meters: the point is within this distance in 95 % of cases. */
  errorM(eastM: number, northM: number): number;
  /**
   * Moves the estimate by the motion of the device.
   *
   * @param rightM, aheadM Motion since the last call as the session measures it, along x and -z of world space.
   */
  move(rightM: number, aheadM: number, deltaS: number): void;
  /**
   * Corrects the estimate by a satellite position.
   *
   * @param sigmaM Standard deviation along each axis.
   */
  place(eastM: number, northM: number, sigmaM: number, timeS: number): void;
  turn(northRad: number, sigmaRad: number, timeS: number): void;
  /** Replaces the azimuth after world space has been rotated and moved; the device's place on the earth stays. */
  jump(northRad: number): void;
  reset(): void;
}

export interface GeoMotionNoise {
  /** Drift of the device's position that the session does not notice, as variance per second, m²/s. */
  readonly moveM2PerS: number;
  /** Drift of world space's azimuth, as variance per second, rad²/s. */
  readonly turnRad2PerS: number;
}

/** How many standard deviations contain 95 % of a normal distribution of one number. */
const NORMAL_95 = 1.96;
/**
 * How many standard deviations contain 95 % of the errors of an azimuth that only walks tell. More than `NORMAL_95`, because slow errors of
 * positions look like a rotated walk. Found by simulating walks other than those of the test.
 */
const WALK_95 = 2.4;
/** Radius of the circle that contains 95 % of a two-dimensional normal distribution, in standard deviations. */
export const RADIUS_95 = 2.448;
/**
 * Time for which one measurement stands for all others, seconds: twice the time in which the correlation of the errors falls to 1/e
 * (satellite positions 20 s, compasses 60 s). This gives the variance of the mean of a first-order Gauss–Markov process.
 */
const CORRELATION_S = { place: 40, turn: 120 };
/** Factor on the error of an azimuth from a walk. It is above 1 because the positions of the walk also determine the place. */
const WALK_EXCESS = 3;
/** Standard deviation that a jump of world space adds to the azimuth. */
const JUMP_RAD = 0.05;

export function createGeoAlignment(noise: () => GeoMotionNoise): GeoAlignment {
  let [east, north, azimuth] = [0, 0, 0];
  /** Covariance of east, north and azimuth, row by row. */
  const p = new Float64Array(9);
  let placed = false;
  let turned = false;
  let hasCompass = false;
  let placedS = 0;
  let turnedS = 0;
  /** The walk since the first position: `rightM` and `aheadM` as the session measured them, the others as they were at its start. */
  const walk = { rightM: 0, aheadM: 0, east: 0, north: 0, sigmaM: 0 };

  const at = (row: number, column: number): number => p[3 * row + column] ?? 0;
  const set = (row: number, column: number, value: number): void => {
    p[3 * row + column] = value;
  };
  /** The variance of a measurement that comes `sinceS` after an earlier one and partly repeats its error; larger the sooner it comes. */
  const independent = (sigma: number, sinceS: number, correlationS: number): number =>
    sigma * sigma * Math.max(1, correlationS / Math.max(sinceS, 0.05));

  /** Corrects the state by a measurement of one of its three numbers: 0 east, 1 north, 2 azimuth. */
  function correct(which: 0 | 1 | 2, difference: number, variance: number): void {
    const total = at(which, which) + variance;
    const gain = [at(0, which) / total, at(1, which) / total, at(2, which) / total];
    const row = [at(which, 0), at(which, 1), at(which, 2)];
    east += (gain[0] ?? 0) * difference;
    north += (gain[1] ?? 0) * difference;
    azimuth = wrap(azimuth + (gain[2] ?? 0) * difference);
    for (let i = 0; i < 3; i++) for (let j = 0; j < 3; j++) set(i, j, at(i, j) - (gain[i] ?? 0) * (row[j] ?? 0));
  }
  function beginTurn(northRad: number, variance: number): void {
    azimuth = wrap(northRad);
    turned = true;
    for (let i = 0; i < 3; i++) {
      set(i, 2, 0);
      set(2, i, 0);
    }
    set(2, 2, variance);
  }
  /**
   * Estimates the azimuth without a compass, from the direction of the walk, once the walk is far longer than the errors of the positions.
   */
  function turnByWalk(eastM: number, northM: number, sigmaM: number): void {
    const error = Math.hypot(sigmaM, walk.sigmaM);
    const length = Math.hypot(walk.rightM, walk.aheadM);
    if (length < 6 * error) return;
    const onEarth = Math.atan2(eastM - walk.east, northM - walk.north);
    beginTurn(onEarth - Math.atan2(walk.rightM, walk.aheadM), (WALK_EXCESS * (error / length)) ** 2);
  }

  return {
    get isPlaced() {
      return placed;
    },
    get isTurned() {
      return turned;
    },
    get eastM() {
      return east;
    },
    get northM() {
      return north;
    },
    get northRad() {
      return azimuth;
    },
    get turnErrorRad() {
      return turned ? Math.min(Math.PI, (hasCompass ? NORMAL_95 : WALK_95) * Math.sqrt(at(2, 2))) : Math.PI;
    },
    errorM: (eastM, northM) => {
      if (!placed || !turned) return Number.POSITIVE_INFINITY;
      // An azimuth that is larger than estimated moves the point clockwise around the device.
      const [alongEast, alongNorth] = [northM, -eastM];
      const ee = at(0, 0) + 2 * alongEast * at(0, 2) + alongEast * alongEast * at(2, 2);
      const nn = at(1, 1) + 2 * alongNorth * at(1, 2) + alongNorth * alongNorth * at(2, 2);
      const en = at(0, 1) + alongEast * at(1, 2) + alongNorth * at(0, 2) + alongEast * alongNorth * at(2, 2);
      const largest = (ee + nn) / 2 + Math.hypot((ee - nn) / 2, en);
      return RADIUS_95 * Math.sqrt(Math.max(0, largest));
    },
    move: (rightM, aheadM, deltaS) => {
      if (!placed) return;
      walk.rightM += rightM;
      walk.aheadM += aheadM;
      const [sine, cosine] = [Math.sin(azimuth), Math.cos(azimuth)];
      const [byEast, byNorth] = turned ? [rightM * cosine + aheadM * sine, aheadM * cosine - rightM * sine] : [0, 0];
      east += byEast;
      north += byNorth;
      // P ← F P Fᵀ, where F turns the motion by the error of the azimuth.
      for (let i = 0; i < 3; i++) {
        set(0, i, at(0, i) + byNorth * at(2, i));
        set(1, i, at(1, i) - byEast * at(2, i));
      }
      for (let i = 0; i < 3; i++) {
        set(i, 0, at(i, 0) + byNorth * at(i, 2));
        set(i, 1, at(i, 1) - byEast * at(i, 2));
      }
      const { moveM2PerS, turnRad2PerS } = noise();
      // While the azimuth is unknown, so is where a motion leads.
      const unknown = turned ? 0 : rightM * rightM + aheadM * aheadM;
      set(0, 0, at(0, 0) + moveM2PerS * deltaS + unknown);
      set(1, 1, at(1, 1) + moveM2PerS * deltaS + unknown);
      set(2, 2, at(2, 2) + turnRad2PerS * deltaS);
    },
    place: (eastM, northM, sigmaM, timeS) => {
      if (!placed) {
        placed = true;
        [east, north] = [eastM, northM];
        Object.assign(walk, { rightM: 0, aheadM: 0, east: eastM, north: northM, sigmaM });
        const azimuthVariance = at(2, 2);
        p.fill(0);
        set(0, 0, sigmaM * sigmaM);
        set(1, 1, sigmaM * sigmaM);
        set(2, 2, azimuthVariance);
      } else {
        if (!turned) turnByWalk(eastM, northM, sigmaM);
        const variance = independent(sigmaM, timeS - placedS, CORRELATION_S.place);
        correct(0, eastM - east, variance);
        correct(1, northM - north, variance);
      }
      placedS = timeS;
    },
    turn: (northRad, sigmaRad, timeS) => {
      if (!turned) beginTurn(northRad, sigmaRad * sigmaRad);
      else correct(2, wrap(northRad - azimuth), independent(sigmaRad, timeS - turnedS, CORRELATION_S.turn));
      turnedS = timeS;
      hasCompass = true;
    },
    jump: (northRad) => {
      if (!turned) return;
      azimuth = wrap(northRad);
      set(2, 2, at(2, 2) + JUMP_RAD * JUMP_RAD);
    },
    reset: () => {
      placed = false;
      turned = false;
      hasCompass = false;
      p.fill(0);
    },
  };
}

/** Wraps an angle to (-π, π]. */
function wrap(rad: number): number {
  return Math.atan2(Math.sin(rad), Math.cos(rad));
}
