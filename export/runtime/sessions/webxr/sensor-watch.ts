/** Reports when a sensor stops measuring and when it starts again. */
export interface SensorWatch {
  /** Called once per frame with the time of the frame, seconds, and whether the sensor measured in it. */
  update(timeS: number, measured: boolean): void;
}

/** How long a sensor may measure nothing before this is reported, seconds. Devices skip single frames. */
export const REPORT_AFTER_S = 2;
/**
 * How long a sensor may measure nothing before its first measurement, seconds: longer than later, because phones must be moved before they
 * measure depth.
 */
export const FIRST_REPORT_AFTER_S = 6;

export function createSensorWatch(onChange: (working: boolean) => void): SensorWatch {
  /** Time of the last measurement, or of the first frame. */
  let lastS: number | null = null;
  let patienceS = FIRST_REPORT_AFTER_S;
  let told = true;
  const tell = (working: boolean): void => {
    if (told === working) return;
    told = working;
    onChange(working);
  };
  return {
    update: (timeS, measured) => {
      lastS ??= timeS;
      if (measured) {
        lastS = timeS;
        patienceS = REPORT_AFTER_S;
        tell(true);
      } else if (timeS - lastS > patienceS) {
        tell(false);
      }
    },
  };
}
