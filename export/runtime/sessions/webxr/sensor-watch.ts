/** Reports when a sensor stops measuring and when it starts again. */
export interface SensorWatch {
  /** To be called once per frame with its time in seconds. */
  update(timeS: number, measured: boolean): void;
}

/** Delay of the report, because devices skip single frames. */
export const REPORT_AFTER_S = 2;
/** Delay before the first measurement, because phones must be moved before they measure depth. */
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
