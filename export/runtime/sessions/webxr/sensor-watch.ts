/** Tells when what a sensor measures fails to come, and when it comes again. */
export interface SensorWatch {
  /** Once a frame, with the time of the frame, seconds. */
  update(timeS: number, measured: boolean): void;
}

/** Devices leave out a few frames now and then, and nobody sees it. */
export const SILENT_AFTER_S = 2;
/** Phones measure no depth before they have been moved a little. */
export const FIRST_WITHIN_S = 6;

export function createSensorWatch(onChange: (working: boolean) => void): SensorWatch {
  /** When it measured last, or the first frame came. */
  let lastS: number | null = null;
  let patienceS = FIRST_WITHIN_S;
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
        patienceS = SILENT_AFTER_S;
        tell(true);
      } else if (timeS - lastS > patienceS) {
        tell(false);
      }
    },
  };
}
